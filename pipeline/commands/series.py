"""`debist series`: how one device changes from run to run."""

import csv
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Literal

import typer

from pipeline.commands.console import Json, Runs, emit_json, emit_table, emit_text


def series(
    runs: Runs,
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="TIME,…", help="Date (2026-03-01) or day of each run [default: in this order]."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write a page with a figure of each fact.")
    ] = None,
    form: Annotated[Literal["text", "csv"], typer.Option("--format", help="Form of the table.")] = "text",
    as_json: Json = False,
) -> None:
    """Drift and steps of the facts of one device over several runs, with 95 % intervals; units SI in JSON and CSV.

    Rests, barriers, switching voltages, stiffness, capacitance gains, charging time, creep and the laser's zero. A
    change is claimed where chance explains it in one of twenty series at most; four runs are the least.

    Example: debist series runs/day0 runs/day7 runs/day14 runs/day30 --at 0,7,14,30 -o series.html
    """
    from pipeline.reporting.series_page import COLUMNS, conclusion, series_page, series_rows
    from pipeline.runs.atomic import write_text
    from pipeline.tools.series import series_of

    made = series_of(runs, at)
    if output is not None:
        write_text(output, series_page(made))
    if as_json:
        emit_json(asdict(made) | {"page": output})
    elif form == "csv":
        writer = csv.writer(sys.stdout, lineterminator="\n")
        writer.writerow(("key", "unit", *asdict(made.facts[0].trend)) if made.facts else ("key", "unit"))
        writer.writerows((fact.key, fact.unit, *asdict(fact.trend).values()) for fact in made.facts)
    else:
        emit_table(f"{len(made.names)} runs of one device, ± 95 %", COLUMNS, series_rows(made))
        emit_text(conclusion(made))
