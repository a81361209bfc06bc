"""`debist fleet` and `debist series`: a prior from joints of one drawing, and how one device changes."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .boundary import group
from .console import Json, Runs, emit_json, emit_table, emit_text, printable

if TYPE_CHECKING:
    from ..workflow.studies.fleet import LearntFile


app = group("A prior for the next joint, from many joints of one drawing.")
_SHOWN = 15


@app.callback()
def fleet() -> None:
    """A prior for the next joint, from many joints of one drawing."""


@app.command()
def learn(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN...", help="Runs with the model hybrid, or folders of a batch.")
    ],
    output: Annotated[
        Path,
        typer.Option("-o", metavar="FILE", help="File of the siblings (.h5), for plant.siblings."),
    ],
    as_json: Json = False,
) -> None:
    """Mean, spread and correlations of the deviations of identified siblings, as a prior of the next joint; odd ones.

    From five siblings on; all need the parameter set that the next joint has. Lengths in m, all other units SI, odd
    quantities in percent where they are positive. Example: debist fleet learn runs -o siblings.h5
    """
    from ..workflow.studies.fleet import learn_siblings

    siblings = learn_siblings(runs, output)
    for name, reason in siblings.left_out.items():
        typer.echo(printable(f"warning: {name} is left out: {reason}"), err=True)
    if as_json:
        _emit_json(siblings)
    else:
        _emit(siblings)


def _emit_json(siblings: "LearntFile") -> None:
    emit_json(
        {
            "file": siblings.path,
            "siblings": siblings.siblings,
            "left_out": siblings.left_out,
            "quantities": [vars(quantity) for quantity in siblings.learnt.quantities],
            "odd": [vars(odd) for odd in siblings.learnt.odd],
            "log_evidence_gain": siblings.learnt.gains,
        }
    )


def _emit(siblings: "LearntFile") -> None:
    quantities = siblings.learnt.quantities
    gains = sorted(siblings.learnt.gains.values())
    rows = [
        (quantity.name, f"{quantity.mean:.3g}", f"{quantity.spread:.2g}", quantity.unit, f"{quantity.share:.2f}")
        for quantity in quantities[:_SHOWN]
    ]
    heading = ("quantity", "mean deviation", "spread", "unit", "spread over the prior's")
    emit_table(f"{len(siblings.siblings)} siblings, the best known quantities", heading, rows)
    halved = sum(quantity.share < 0.5 for quantity in quantities)
    emit_text(
        f"{halved} of {len(quantities)} quantities have less than half the prior's spread; with the other siblings as "
        f"prior, the logs of a sibling are exp({gains[len(gains) // 2]:.0f}) times as probable (median)"
    )
    for odd in siblings.learnt.odd:
        emit_text(f"odd: {odd.name}: {odd.quantity} {odd.size:+.3g} ± {odd.error:.2g} {odd.unit}")
    if not siblings.learnt.odd:
        emit_text("no sibling is odd")
    emit_text(f"written: {siblings.path}; name it in [plant] siblings, or give it to debist batch --siblings")


def series(
    runs: Runs,
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="TIME,…", help="Date (2026-03-01) or day of each run [default: in this order]."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--page", metavar="FILE", help="Write a page with a figure of each fact."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Drift and steps of the facts of one device over several runs, with 95 % intervals; SI units in JSON.

    Rests, barriers, switching voltages, stiffness, capacitance gains, charging time, creep and the laser's zero. A
    change is claimed where chance explains it in one of twenty series at most; four runs are the least.

    Example: debist series runs/day0 runs/day7 runs/day14 runs/day30 --at 0,7,14,30 --page series.html
    """
    from ..reporting.several_runs import COLUMNS, conclusion, series_page, series_rows
    from ..store.atomic import write_text
    from ..workflow.studies.fleet import series_of

    facts = series_of(runs, at)
    if output is not None:
        write_text(output, series_page(facts))
    if as_json:
        emit_json(asdict(facts) | {"page": output})
    else:
        emit_table(f"{len(facts.names)} runs of one device, ± 95 %", COLUMNS, series_rows(facts))
        emit_text(conclusion(facts))
