"""Where the processor time of a run goes, by stage: children such as the readers of raw logs count.

    python benchmarks/bench_stages.py [SETTINGS.toml]

One process, all baselines and the page; P1 if no settings are given. Imports are what is spent outside of the tasks.
"""

import os
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from pipeline.system.machine import settle_machine

settle_machine()

from pipeline.workflow.engine import Task, Unheard  # noqa: E402
from pipeline.workflow.run import run_prototype  # noqa: E402


class Clock(Unheard):
    """An observer that adds up processor time [s] by stage, and by model for fits of baselines."""

    def __init__(self) -> None:
        self.spent, self._began = defaultdict[str, float](float), 0.0

    def started(self, task: Task, reasons: list[str]) -> None:
        """A task begins."""
        self._began = _now()

    def finished(self, task: Task, seconds: float) -> None:
        """A task ends."""
        name = task.title if task.title.startswith("fit of") else f"{task.stage}: all tasks"
        self.spent[name.replace("compare: all tasks", "free runs of baselines")] += _now() - self._began


def _now() -> float:
    spent = os.times()
    return spent.user + spent.system + spent.children_user + spent.children_system


def main() -> None:
    prototype = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent / "prototypes" / "P1.toml")
    clock = Clock()
    with tempfile.TemporaryDirectory() as folder:
        run_prototype(prototype, Path(folder) / "run", clock)
    whole = _now()
    for name, seconds in clock.spent.items():
        print(f"{name:32} {seconds:6.2f} s")
    print(f"{'imports and the rest':32} {whole - sum(clock.spent.values()):6.2f} s")
    print(f"{'whole':32} {whole:6.2f} s")


if __name__ == "__main__":
    main()
