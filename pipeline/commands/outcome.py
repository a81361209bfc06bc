"""What a run came to: the headline table, the verdict, and where the rest is."""

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from pipeline.commands.console import emit_json, emit_table, printable

if TYPE_CHECKING:
    from pipeline.reporting.tables import Format


def emit_scores(run: Path, *, as_json: bool, form: "Format" = "text", details: bool = False) -> None:
    """Print the scores: the headline table, or with details both score tables; as records for JSON."""
    from pipeline.stages.scores import load_scores, score_text, shown_scores

    if as_json:
        emit_json({"scores": load_scores(run)})
        return
    if form != "text" or details:
        typer.echo(score_text(run, form), nl=False)
        if form == "text":
            from pipeline.reporting.tables import BEHAVIOUR_EXPLANATION, CHAOS, EXPLANATION

            chaotic = any(row.get("lyapunov_per_s") for row in load_scores(run))
            typer.echo(f"\n{EXPLANATION}\n{BEHAVIOUR_EXPLANATION}" + f"\n{CHAOS}" * chaotic)
        return
    from pipeline.reporting.error_tables import EXPLANATION as BRIEF
    from pipeline.reporting.error_tables import headline_table

    scores = shown_scores(run)
    table = headline_table(scores)
    emit_table(table.where, table.heading, table.rows)
    for row in scores:
        if row["headline"] and row.get("lyapunov_per_s"):
            typer.echo(printable(
                f"{row['log']}: chaotic, free runs part e-fold in {1.0 / row['lyapunov_per_s']:.3g} s; --details has "
                "the error after that time and the statistics, by which to judge"
            ))  # fmt: skip
    typer.echo(f"{BRIEF}\nIntervals, every log, horizons and times: --details")


def emit_verdict(run: Path) -> None:
    """Print the verdict of the report and where the report lies."""
    from pipeline.tools.show import load_datasheet

    verdict = load_datasheet(run)["verdict"]
    typer.echo(printable(f"verdict: data {verdict['data']}, model {verdict['model']}"))
    for check in verdict["checks"]:
        if check["grade"] != "good":
            typer.echo(printable(f"  {check['about']}, {check['grade']}: {check['statement']}"))
    typer.echo(printable(f"report: {run / 'report.html'}"))
