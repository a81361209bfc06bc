"""What a run came to: the headline table, the verdict, and where the rest is."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from pipeline.commands.console import brief, emit_json, emit_table, emit_text

if TYPE_CHECKING:
    from typing import Literal

    from pipeline.reporting.tables import Format
    from pipeline.runs.engine import TaskStatus


def emit_scores(run: Path, *, as_json: bool, form: "Format | Literal['text']" = "text", details: bool = False) -> None:
    """Print the scores: the headline table, or with details both score tables; as records for JSON."""
    from pipeline.stages.scores import load_scores, score_text, shown_scores

    if as_json:
        emit_json({"scores": load_scores(run)})
        return
    if form != "text":
        typer.echo(score_text(run, form), nl=False)
        return
    if details:
        _emit_details(run)
        return
    from pipeline.reporting.error_tables import EXPLANATION as BRIEF
    from pipeline.reporting.error_tables import headline_table

    scores = shown_scores(run)
    table = headline_table(scores)
    emit_table(table.where, table.heading, table.rows)
    for row in scores:
        if row["headline"] and row.get("lyapunov_per_s"):
            emit_text(
                f"{row['log']}: chaotic, free runs part e-fold in {1.0 / row['lyapunov_per_s']:.3g} s; --details has "
                "the error after that time and the statistics, by which to judge"
            )
    typer.echo(f"{BRIEF}\nIntervals, every log, horizons and times: --details")


def _emit_details(run: Path) -> None:
    """Print every number of every log, a table for each log, and what they mean."""
    from pipeline.reporting.tables import BEHAVIOUR_EXPLANATION, CHAOS, EXPLANATION, lines
    from pipeline.stages.scores import score_tables

    tables = score_tables(run)
    for table in tables:
        heading, *rows = lines(table)
        for log in dict.fromkeys(row[0] for row in rows):
            emit_table(log, heading[1:], [row[1:] for row in rows if row[0] == log])
    emit_text(f"{EXPLANATION}\n{BEHAVIOUR_EXPLANATION}" + f"\n{CHAOS}" * (len(tables) > 2))


def emit_verdict(run: Path) -> None:
    """Print the verdict of the report and where the report lies."""
    from pipeline.loading.report_data import load_datasheet

    verdict = load_datasheet(run)["verdict"]
    emit_text(f"verdict: data {verdict['data']}, model {verdict['model']}")
    for check in verdict["checks"]:
        if check["grade"] != "good":
            emit_text(f"  {check['about']}, {check['grade']}: {check['statement']}", indent="    ")
    emit_text(f"report: {run / 'report.html'}")


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
