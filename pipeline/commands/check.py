"""`debist check`: are the logs what the settings say?"""

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from pipeline.commands.console import Progress, emit_json, emit_table, emit_text
from pipeline.commands.options import Json, PrototypeFile, Quiet

if TYPE_CHECKING:
    from pipeline.checks.rows import CheckRow


def check(
    place: PrototypeFile,
    details: Annotated[bool, typer.Option("--details", help="Also the numbers beside those of the table.")] = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Sides, signs, delays, time base, mass and device: are the logs what the settings say? Nothing is fitted.

    Delays in ms, rates in Hz, pushes in m/s². Exit code 3 if the model would be wrong. `debist run` does it first.
    Example: debist check P1.toml
    """
    from pipeline.stages.check import verdict
    from pipeline.tools.inspection import check as check_tool

    with Progress(quiet=quiet) as progress:
        prototype, rows = check_tool(place, progress)
    if as_json:
        emit_json({"prototype": prototype.name, "rows": [asdict(row) for row in rows]})
    else:
        emit_rows(prototype.name, rows, details=details)
    verdict(rows, prototype)


def emit_rows(name: str, rows: "Sequence[CheckRow]", *, details: bool) -> None:
    """Print the numbers side by side, the logs as columns, and below them in words what is remarkable."""
    from pipeline.checks.rows import beside

    header, table = beside(rows)
    emit_table(f"{name}: are the logs what the settings say?", header, table, numeric_from=len(header))
    for row in rows:
        if row.state == "note":
            emit_text(f"note: {row.sentence}: {row.advice}", indent="  ")
        elif details and row.more:
            emit_text(row.sentence, indent="  ")
    if all(row.state in ("ok", "not seen") for row in rows):
        emit_text("nothing speaks against it")
