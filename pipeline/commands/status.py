"""The state of many runs."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pipeline.commands.console import brief, emit_json, emit_table

if TYPE_CHECKING:
    from pipeline.runs.engine import TaskStatus


def emit_fleet_status(found: "Sequence[tuple[Path, list[TaskStatus], str]]", *, as_json: bool) -> None:
    """Print for each run its stale stages with the first reason, or why it cannot be read."""
    if as_json:
        runs = [
            {"run": root, "stale": list(dict.fromkeys(r.stage for r in results if not r.up_to_date)), "error": error}
            for root, results, error in found
        ]
        emit_json({"runs": runs})
        return
    rows = []
    for root, results, error in found:
        stale = [result for result in results if not result.up_to_date]
        state = "unreadable" if error else "stale" if stale else "up to date"
        rows.append((str(root), state, error or brief([f"{r.stage} {r.title}: {r.reasons[0]}" for r in stale])))
    emit_table("runs", ("run", "state", "why"), rows, numeric_from=3)


def emit_status(title: str, found: "Sequence[TaskStatus]", *, as_json: bool) -> None:
    """Print for each task whether it is up to date, and why not."""
    if as_json:
        emit_json({"tasks": [{**vars(result), "up_to_date": result.up_to_date} for result in found]})
        return
    rows = [(r.stage, r.title, "up to date" if r.up_to_date else "to do", brief(r.reasons)) for r in found]
    emit_table(title, ("stage", "task", "state", "why"), rows, numeric_from=4)
