"""Tables and page of a fleet, from the runs of its prototypes."""

import csv
import io
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from ..errors import DebistError
from ..reporting.fleet_report import fleet_report
from ..reporting.fleet_table import Summary, summary
from ..reporting.tables import disarmed
from ..store import layout, schemas, tables
from ..store.atomic import make_folder, write_text
from ..store.outputs import note_written
from ..store.run_folder import RunFolder
from ..store.schemas import FLEET
from ..store.schemas import FLEET_FACTS as FLEET_FACT_TABLE
from .batch import Outcome
from .members import FLEET_CSV, FLEET_FACTS, FLEET_FILES, FLEET_REPORT, FLEET_TABLE, Member
from .progress import failure
from .report_data import load_datasheet, load_scores


def collect_batch(members: Sequence[Member], output: Path) -> list[Outcome]:
    """Write the fleet tables from the runs that are there, running nothing."""
    outcomes = existing_outcomes(members, output)
    make_folder(output)
    write_fleet(output, outcomes)
    return sorted(outcomes, key=lambda outcome: outcome.name)


def write_fleet(output: Path, outcomes: Iterable[Outcome]) -> None:
    """Tables and page of a fleet, in the order of the names; nothing in them depends on times or processes."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.name)
    write_fleet_tables(output, ordered)
    summaries = [_member(output, outcome.name, outcome.reason) for outcome in ordered]
    _write_facts(output, summaries)
    write_text(output / FLEET_REPORT, fleet_report(summaries, output.resolve().name))
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


def existing_outcomes(members: Sequence[Member], output: Path) -> list[Outcome]:
    """What the runs in a folder hold already, without running anything.

    A prototype has failed if its failure is kept there, or if it has no scores.
    """
    return [_existing(member, output) for member in members]


def _existing(member: Member, output: Path) -> Outcome:
    if (failed := failure(output, member.name)) is not None:
        return Outcome(member.name, member.settings, failed.exit_code, failed.reason)
    try:
        load_scores(output / member.name)
    except DebistError as error:
        return Outcome(member.name, member.settings, error.exit_code, str(error))
    return Outcome(member.name, member.settings, 0, "")


def _write_facts(output: Path, members: Iterable[Summary]) -> None:
    """Every known fact of every prototype in one table."""
    rows = [(member.name, key, value, unit) for member in members for key, (value, unit) in member.facts.items()]
    columns = zip(*rows, strict=True) if rows else ((), (), (), ())
    keys = [column.key for column in FLEET_FACT_TABLE.columns]
    tables.write_table(output / FLEET_FACTS, FLEET_FACT_TABLE, dict(zip(keys, map(list, columns), strict=True)))


def _member(output: Path, name: str, reason: str) -> Summary:
    if reason:
        return Summary(name, reason)
    try:
        held = RunFolder.open(output / name).manifest.artifacts
        document = load_datasheet(output / name) if layout.DATASHEET in held else _scores_alone(output / name)
        paged = layout.REPORT in held
    except DebistError as error:
        return Summary(name, str(error))
    return summary(name, document, f"{name}/{layout.REPORT}" if paged else None)


def _scores_alone(run: Path) -> dict[str, Any]:
    """Entries of the page for a run without a datasheet: errors, without facts or an assessment."""
    scores = load_scores(run)
    judged = next((row["model"] for row in scores if row["headline"]), scores[0]["model"])
    return {"scores": scores, "judged_model": judged, "facts": [], "verdict": {"data": "", "model": ""}}
