"""`debist fleet`: what many joints of one drawing teach the next one."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pipeline.commands.boundary import group
from pipeline.commands.console import Json, emit_json, emit_table, emit_text, printable

if TYPE_CHECKING:
    from pipeline.tools.siblings import LearntFile

app = group("What many joints of one drawing teach the next one.")
_SHOWN = 15


@app.callback()
def fleet() -> None:
    """What many joints of one drawing teach the next one."""


@app.command()
def learn(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN...", help="Runs with the model hybrid, or folders of a batch.")
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE", help="File of the siblings (.h5), for plant.siblings.")
    ],
    as_json: Json = False,
) -> None:
    """Mean, spread and correlations of the deviations of identified siblings, as a prior of the next joint; odd ones.

    From five siblings on; all need the parameter set that the next joint has. Lengths in m, all other units SI, odd
    quantities in percent where they are positive. Example: debist fleet learn runs -o siblings.h5
    """
    from pipeline.tools.siblings import learn_siblings

    made = learn_siblings(runs, output)
    for name, reason in made.left_out.items():
        typer.echo(printable(f"warning: {name} teaches nothing: {reason}"), err=True)
    if as_json:
        _emit_json(made)
    else:
        _emit(made)


def _emit_json(made: "LearntFile") -> None:
    emit_json(
        {
            "file": made.path,
            "siblings": made.siblings,
            "left_out": made.left_out,
            "quantities": [vars(quantity) for quantity in made.learnt.quantities],
            "odd": [vars(odd) for odd in made.learnt.odd],
            "log_evidence_gain": made.learnt.gains,
        }
    )


def _emit(made: "LearntFile") -> None:
    quantities, gains = made.learnt.quantities, sorted(made.learnt.gains.values())
    rows = [
        (each.name, f"{each.mean:.3g}", f"{each.spread:.2g}", each.unit, f"{each.share:.2f}")
        for each in quantities[:_SHOWN]
    ]
    heading = ("quantity", "mean deviation", "spread", "unit", "spread over the prior's")
    emit_table(f"{len(made.siblings)} siblings, the best known quantities", heading, rows)
    halved = sum(each.share < 0.5 for each in quantities)
    emit_text(
        f"{halved} of {len(quantities)} quantities have less than half the prior's spread; logs of a sibling that the "
        f"others teach are exp({gains[len(gains) // 2]:.0f}) times as probable as under the prior (median)"
    )
    for odd in made.learnt.odd:
        emit_text(f"odd: {odd.name}: {odd.quantity} {odd.size:+.3g} ± {odd.error:.2g} {odd.unit}")
    if not made.learnt.odd:
        emit_text("no sibling is odd")
    emit_text(f"written: {made.path}; name it in [plant] siblings, or give it to debist batch --siblings")
