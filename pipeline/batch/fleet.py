"""The tables and the page of a fleet: what a batch writes beside its runs."""

import csv
import io
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from pipeline.batch.journal import failures
from pipeline.batch.worker import Outcome
from pipeline.errors import DebistError
from pipeline.loading.report_data import load_datasheet, load_scores
from pipeline.reporting.fleet_report import fleet_report
from pipeline.reporting.fleet_table import Summary, failed, summary
from pipeline.reporting.tables import disarmed
from pipeline.runs import layout, schemas, tables
from pipeline.runs.atomic import write_text
from pipeline.runs.outputs import note_written
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schemas import FLEET

FLEET_TABLE = "fleet.parquet"
FLEET_CSV = "fleet.csv"
FLEET_REPORT = "fleet.html"
FLEET_FILES = (FLEET_TABLE, FLEET_CSV, FLEET_REPORT)


def write_fleet(output: Path, outcomes: Iterable[Outcome]) -> None:
    """Tables and page of a fleet, in the order of the names; nothing in them depends on times or processes."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.name)
    write_fleet_tables(output, ordered)
    write_fleet_report(output, [(outcome.name, outcome.reason) for outcome in ordered])
    note_written(output, FLEET_FILES, "batch")


def write_fleet_tables(output: Path, outcomes: Iterable[Outcome]) -> None:
    """The scores of all prototypes in one table, Parquet and CSV; one that failed has a row with the reason."""
    rows: list[dict[str, Any]] = []
    for outcome in outcomes:
        head = {"prototype": outcome.name, "exit_code": outcome.exit_code, "reason": outcome.reason}
        try:
            scores = load_scores(output / outcome.name) if outcome.exit_code == 0 else [{}]
        except DebistError as error:  # changed or damaged since it ended well
            scores, head = [{}], head | {"exit_code": error.exit_code, "reason": str(error)}
        rows += [{column.key: None for column in schemas.SCORES.columns} | score | head for score in scores]
    columns = {column.key: [row[column.key] for row in rows] for column in FLEET.columns}
    tables.write_table(output / FLEET_TABLE, FLEET, columns)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([disarmed(value) for value in row] for row in zip(*columns.values(), strict=True))
    write_text(output / FLEET_CSV, text.getvalue())


def existing_outcomes(named: Sequence[tuple[str, Path]], output: Path) -> list[Outcome]:
    """What the runs in a folder hold already, without running anything.

    A prototype has failed if the journals there end with its failure, or if it has no scores.
    """
    failed_last, outcomes = failures(output) if output.is_dir() else {}, []
    for name, prototype in named:
        try:
            event = failed_last.get(name)
            if event is None:
                load_scores(output / name)
            outcomes.append(Outcome(name, prototype, event.exit_code if event else 0, event.reason if event else ""))
        except DebistError as error:
            outcomes.append(Outcome(name, prototype, error.exit_code, str(error)))
    return outcomes


def write_fleet_report(output: Path, outcomes: Iterable[tuple[str, str]]) -> Path:
    """Write ``fleet.html`` into the folder of a batch.

    Parameters
    ----------
    output : Path
        Folder that holds one run folder per prototype.
    outcomes : iterable of (name, reason)
        Prototypes in order; the reason is empty for one that did not fail.
    """
    members = (_member(output, name, reason) for name, reason in outcomes)  # a datasheet has 20 kB: one at a time
    page = fleet_report(members, output.resolve().name)
    target = output / FLEET_REPORT
    write_text(target, page)
    return target


def _member(output: Path, name: str, reason: str) -> Summary:
    if reason:
        return failed(name, reason)
    try:
        held = RunFolder.open(output / name).manifest.artifacts
        document = load_datasheet(output / name) if layout.DATASHEET in held else _scores_alone(output / name)
        paged = layout.REPORT in held
    except DebistError as error:
        return failed(name, str(error))
    return summary(name, document, f"{name}/{layout.REPORT}" if paged else None)


def _scores_alone(run: Path) -> dict[str, Any]:
    """Entries of the page for a run without a datasheet: errors, without facts or a verdict."""
    scores = load_scores(run)
    judged = next((row["model"] for row in scores if row["headline"]), scores[0]["model"])
    return {"scores": scores, "judged_model": judged, "facts": [], "verdict": {"data": "", "model": ""}}
