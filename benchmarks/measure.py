"""How the benchmarks measure: processor time, as the machine may be shared."""

import ctypes
import os
import resource
import statistics
import subprocess
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pipeline.settings.prototype import load_prototype
from pipeline.workflow.batch import Outcome

HOME = Path(__file__).resolve().parents[1]


class UnheardBatch:
    """An observer of a batch that reports nothing."""

    def started(self, name: str) -> None: ...
    def finished(self, outcome: Outcome) -> None: ...


@dataclass(frozen=True)
class Cost:
    """Processor and wall time [s] of a command and all that it starts, and what it says."""

    processor: float
    wall: float
    stdout: bytes


def seconds(work: Callable[[], Any], repeats: int = 5) -> float:
    """Median processor time [s] of some calls after a first one."""
    work()
    times = []
    for _ in range(repeats):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return statistics.median(times)


def adopt_orphans() -> None:
    """Processes that lose their parent become children of this one, so that `cost` counts them (Linux)."""
    ctypes.CDLL(None).prctl(36, 1, 0, 0, 0)


def cost(command: list[str], **surroundings: str) -> Cost:
    """What a command and all that it starts take, processes that outlive it and end with it too."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    environment = os.environ | {"PYTHONPATH": str(HOME)} | surroundings
    done = subprocess.run(command, check=True, env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    wall = time.monotonic() - began
    with suppress(ChildProcessError):
        while True:  # what the command left behind is ours to wait for, see `adopt_orphans`
            os.wait()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Cost(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall, done.stdout)


def has_logs(settings: Path) -> bool:
    """Whether the training logs that a settings file names are there."""
    logs = load_prototype(settings).logs.train
    return all((settings.parent / (log if isinstance(log, str) else log.file)).is_file() for log in logs)


def fits(document: object) -> list[float]:
    """Every ``fit_s`` of a manifest."""
    if isinstance(document, dict):
        own = [float(document["fit_s"])] if "fit_s" in document else []
        return own + [x for value in document.values() for x in fits(value)]
    return [x for value in document for x in fits(value)] if isinstance(document, list) else []
