"""Fleet report: one page over the runs of a batch, written beside them."""

from collections.abc import Iterable
from pathlib import Path

from pipeline.errors import DebistError
from pipeline.reporting.fleet_members import Member
from pipeline.reporting.fleet_report import fleet_report
from pipeline.runs import layout
from pipeline.runs.atomic import write_text
from pipeline.runs.run_folder import RunFolder
from pipeline.tools.show import load_datasheet

FLEET_REPORT = "fleet.html"


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


def _member(output: Path, name: str, reason: str) -> Member:
    if reason:
        return Member(name, reason, None, None)
    try:
        document = load_datasheet(output / name)
        paged = layout.REPORT in RunFolder.open(output / name).manifest.artifacts
    except DebistError as error:
        return Member(name, str(error), None, None)
    return Member(name, "", document, f"{name}/{layout.REPORT}" if paged else None)
