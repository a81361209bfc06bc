"""The progress and the summary of a batch."""

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import typer

from pipeline.commands.console import emit_json, emit_table, printable
from pipeline.stages.batch import Outcome
from pipeline.stages.scores import load_scores, percent


def tell(outcome: Outcome, done: int, total: int) -> None:
    """One line on stderr for a finished prototype."""
    state = outcome.reason or "done"
    typer.echo(printable(f"[{done}/{total}] {outcome.name}: {state} ({outcome.seconds:.1f} s)"), err=True)


def emit_outcomes(outcomes: Sequence[Outcome], output: Path, *, as_json: bool) -> None:
    """Print how every prototype went, with its NRMSE of q on the validation logs."""
    if as_json:
        emit_json({"output": output, "prototypes": [asdict(outcome) for outcome in outcomes]})
        return
    rows = [
        (outcome.name, "failed" if outcome.exit_code else "ok", outcome.reason or _summary(output / outcome.name))
        for outcome in outcomes
    ]
    emit_table(f"{output}", ("prototype", "state", "validation NRMSE of q in %, or the reason"), rows, numeric_from=3)


def _summary(run: Path) -> str:
    scores = [s for s in load_scores(run) if s["role"] == "validation" and s["signal"] == "q"]
    return ", ".join(f"{s['model']} {percent(s['nrmse']) if s['status'] == 'ok' else 'diverged'}" for s in scores)
