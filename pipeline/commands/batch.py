"""The progress and the summary of a batch."""

import sys
import time
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from types import TracebackType
from typing import Any

import typer

from pipeline.batch.worker import Outcome
from pipeline.commands.console import clock, emit_json, emit_table, printable
from pipeline.stages.scores import load_scores, percent

_MOST_NAMED = 4


class BatchProgress:
    """One line on stderr per finished prototype; on a terminal also a bar with the remaining time below them."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = 0
        self._made = 0
        self._began: float | None = None
        self._running: list[str] = []
        self._bar: Any = None

    def __enter__(self) -> "BatchProgress":
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

            self._bar = Progress(
                BarColumn(),
                MofNCompleteColumn(),
                TimeElapsedColumn(),
                TextColumn("{task.description}", markup=False),
                console=Console(stderr=True),
                transient=True,
            )
            self._bar.add_task("", total=self._total)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
        if isinstance(error, KeyboardInterrupt):
            error.args = (
                f"{self._done} of {self._total} prototypes are done; the same command goes on with the rest, and "
                "--collect makes tables of what is there",
            )

    def _left(self) -> str:
        """About how long the rest takes, by those that were run; one that was up to date says nothing of the speed."""
        if self._began is None or not self._made or self._done == self._total:
            return ""
        elapsed = time.perf_counter() - self._began
        return f", about {clock(elapsed / self._made * (self._total - self._done))} left"

    def started(self, name: str) -> None:
        """Show it among those that run."""
        self._began = self._began or time.perf_counter()
        self._running.append(name)
        self._show()

    def finished(self, outcome: Outcome) -> None:
        """Say how it went."""
        self._done += 1
        self._made += not _up_to_date(outcome)
        self._running.remove(outcome.name)
        state = outcome.reason or ("up to date" if _up_to_date(outcome) else "done")
        line = f"[{self._done}/{self._total}] {outcome.name}: {state} ({outcome.seconds:.1f} s){self._left()}"
        line = printable(line)
        if self._bar is None:
            typer.echo(line, err=True)
        else:
            self._bar.console.print(line, markup=False, highlight=False, soft_wrap=True)
        self._show()

    def _show(self) -> None:
        if self._bar is not None:
            more = f" and {len(self._running) - _MOST_NAMED} more" if len(self._running) > _MOST_NAMED else ""
            names = printable(", ".join(self._running[:_MOST_NAMED]) + more)
            self._bar.update(self._bar.task_ids[0], completed=self._done, description=names + self._left())


def _up_to_date(outcome: Outcome) -> bool:
    """Whether no process had to be started for it."""
    return outcome.exit_code == 0 and not outcome.processor_seconds


def emit_outcomes(outcomes: Sequence[Outcome], output: Path, *, as_json: bool) -> None:
    """Print how every prototype went, with its NRMSE of q on the validation logs."""
    if as_json:
        emit_json({"output": output, "prototypes": [asdict(outcome) for outcome in outcomes]})
        return
    rows = [(outcome.name, _state(outcome), outcome.reason or _summary(output / outcome.name)) for outcome in outcomes]
    emit_table(f"{output}", ("prototype", "state", "validation NRMSE of q in %, or the reason"), rows, numeric_from=3)
    cost = sum(outcome.processor_seconds for outcome in outcomes)
    if cost:
        memory = max(outcome.memory_bytes for outcome in outcomes)
        typer.echo(f"{cost:.1f} s of processor time; at most {memory / 1e6:.0f} MB of memory in a process")


def _state(outcome: Outcome) -> str:
    if outcome.exit_code is None:
        return "not started"
    return "failed" if outcome.failed else "ok"


def _summary(run: Path) -> str:
    scores = [s for s in load_scores(run) if s["role"] == "validation" and s["signal"] == "q"]
    if not scores:
        return "no validation log"
    return ", ".join(f"{s['model']} {percent(s['nrmse']) if s['status'] == 'ok' else 'diverged'}" for s in scores)
