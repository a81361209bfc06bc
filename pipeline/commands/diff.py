"""`debist diff`, and the comparison of two runs that `debist verify --against` prints."""

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pipeline.commands.console import emit_json, emit_table, emit_text
from pipeline.commands.options import Force, Json
from pipeline.errors import CorruptArtifactError

if TYPE_CHECKING:
    from pipeline.tools.diff import Comparison, RunDifference

_ALARMING = ("differs", "missing")


def diff(
    one: Annotated[Path, typer.Argument(metavar="RUN_A", help="Run folder.")],
    other: Annotated[Path, typer.Argument(metavar="RUN_B", help="Run folder to set beside it.")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="PAGE.html", help="Also a page with curves and free runs.")
    ] = None,
    force: Force = False,
    as_json: Json = False,
) -> None:
    """Two runs side by side: settings, versions, raw logs, scores and artifacts that differ.

    NRMSE in percent, a fraction in JSON. Exit code 0 whether they differ or not. Example: debist diff runs/P1 runs/P1b
    """
    from pipeline.tools.diff import diff_runs, write_diff_page

    found = diff_runs(one, other)
    if output is not None:
        write_diff_page(found, one, other, output, force=force)
    if as_json:
        emit_json(asdict(found) | {"equal": found.equal, "page": output})
    else:
        _emit_difference(found)
        if output is not None:
            emit_text(f"open {output}")


def _emit_difference(found: "RunDifference") -> None:
    """Print what differs, table by table."""
    from pipeline.reporting.diff_page import artifact_rows, change_row, notes, score_rows

    tables = (
        ("settings", ("key", *found.names), [change_row(change) for change in found.settings], 3),
        ("versions", ("package", *found.names), [change_row(change) for change in found.versions], 3),
        ("raw logs (SHA-256)", ("log", *found.names), [change_row(change) for change in found.sources], 3),
        ("NRMSE of free runs", ("log", "model", "signal", *found.names, "ratio"), score_rows(found), 3),
        ("artifacts", ("artifact", "state", "deviation", "in"), artifact_rows(found), 2),
    )
    for title, header, rows, numeric in tables:
        if rows:
            emit_table(title, header, [row.cells for row in rows], numeric_from=numeric)
    for sentence in notes(found):
        emit_text(sentence)
    same = [title for title, _, rows, _ in tables if not rows]
    if same:
        emit_text(f"equal: {', '.join(same)}")


def emit_comparison(run: Path, other: Path, found: "Sequence[Comparison]", *, as_json: bool) -> None:
    """Print what is not equal, and how many artifacts are.

    Raises
    ------
    CorruptArtifactError
        An artifact differs by more than rounding, or is missing.
    """
    from pipeline.tools.diff import STATES

    if as_json:
        emit_json({"artifacts": [asdict(comparison) for comparison in found]})
    else:
        unequal = [c for c in found if c.state != "equal"]
        if unequal:
            rows = [
                (c.artifact, c.state, "" if c.deviation is None else f"{c.deviation:.1e}", c.column) for c in unequal
            ]
            emit_table(f"{run} and {other}", ("artifact", "state", "deviation", "in"), rows, numeric_from=2)
            for state in dict.fromkeys(c.state for c in unequal):
                emit_text(f"{state}: {STATES[state]}")
        emit_text(f"{len(found) - len(unequal)} of {len(found)} artifacts have the same content hash")
    apart = [comparison.artifact for comparison in found if comparison.state in _ALARMING]
    if apart:
        raise CorruptArtifactError(
            f"{run}: not the content of {other}: {', '.join(apart)}; compare settings and versions in both manifests"
        )
