"""How far a run is: task k of n, the time so far, and an estimate of what is left."""

import time
from collections.abc import Sequence

COST = {"ingest": 1.0, "check": 0.5, "differentiate": 1.0, "identify": 10.0, "validate": 0.5, "compare": 2.0}
"""Processor time [s] of a task of each stage on a log of 37.5 s at 30 kHz, roughly; 1 s for the others. Only what is
left is estimated from it: the time so far says how fast this machine is."""
_ELSE = 1.0
_TELLING = 0.15  # share of the cost that must be done before a rest is told


class Stopwatch:
    """Counts tasks.

    Parameters
    ----------
    stages : sequence of str
        The stage of every task that is to come; empty where that is not known.
    """

    def __init__(self, stages: Sequence[str]) -> None:
        self._total = len(stages)
        self._coming = sum(COST.get(stage, _ELSE) for stage in stages)
        self._began = time.perf_counter()
        self._at = 0
        self._made = 0.0

    def next(self) -> None:
        """The next task begins, or is skipped."""
        self._at += 1

    def done(self, stage: str, *, made: bool = True) -> None:
        """A task is over; one that was up to date says nothing of the speed."""
        cost = COST.get(stage, _ELSE)
        self._coming = max(0.0, self._coming - cost)
        self._made += cost if made else 0.0

    @property
    def place(self) -> str:
        """`` (k of n)``, or nothing where n is not known; n grows if more comes than was planned."""
        return f" ({self._at} of {max(self._total, self._at)})" if self._total else ""

    @property
    def left(self) -> str:
        """The time so far and about how much is left, in words; nothing where that cannot be told."""
        if not self._total or not self._coming:
            return ""
        elapsed = time.perf_counter() - self._began
        if self._made < _TELLING * (self._made + self._coming):
            return f", {clock(elapsed)} so far"
        return f", {clock(elapsed)} so far, about {clock(elapsed / self._made * self._coming)} left"


def clock(seconds: float) -> str:
    """A duration as people read it."""
    if seconds < 60.0:
        return f"{seconds:.0f} s"
    minutes = round(seconds / 60.0)
    return f"{minutes} min" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"
