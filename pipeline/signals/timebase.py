"""The quality of a time base: gaps, repeated and backward stamps, jitter and dropped samples, counted and located."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import FloatArray, IntArray
from .columns import chunks, column, differences, finite, select

GAP_STEPS = 5.0
"""A hole of more nominal steps than this is a gap …"""
GAP_FLOOR = 1e-3
"""… unless it is shorter than this [s]: 10 mm at 9 Hz bend by less than 5 µm from the chord in 1 ms."""
ONE_LOST = 1.5
"""Nominal steps from which on a step shows a lost sample."""
LOCATED = 20
"""Most gaps, repetitions or reversals that are located; all are counted."""
NO_CUTS: FloatArray = np.empty(0)
_UNIFORM = 1e-3
"""Share of a step by which the steps of a uniform time base may differ, and rounding."""


def is_uniform(t: FloatArray) -> bool:
    """True if time stamps, shape (N,), rise in equal steps."""
    steps = np.diff(t)
    return bool(steps.min() > 0.0 and np.ptp(steps) <= _UNIFORM * steps.mean() + 4 * np.spacing(np.abs(t).max()))


@dataclass(frozen=True)
class TimeQuality:
    """Quality of a time base; times and durations in its unit (SI: s).

    Attributes
    ----------
    n : int
        Number of stamps.
    start, stop : float
        First and last finite stamp.
    step : float
        Nominal step, the median of the positive steps.
    shortest, longest : float
        Extreme positive steps.
    jitter : float
        Root mean square deviation from the nominal step of the steps shorter than 1.5 nominal ones.
    uniform : bool
        No step deviates from the nominal one by more than a thousandth of it.
    not_finite, repeated, backward, gaps, dropped : int
        Counts: NaN or infinite stamps; stamps equal to the one before; steps back; steps longer than
        `gap_limit`; samples missing elsewhere if the nominal step is the truth.
    gap_limit : float
        Steps longer than this are gaps.
    repeated_at, backward_at : tuple of float
        Stamps before the first `LOCATED` events.
    gaps_at : tuple of (float, float)
        Last stamp before and first stamp after a gap, the first `LOCATED` ones.
    """

    n: int
    start: float
    stop: float
    step: float
    shortest: float
    longest: float
    jitter: float
    uniform: bool
    not_finite: int
    repeated: int
    backward: int
    gaps: int
    dropped: int
    gap_limit: float
    repeated_at: tuple[float, ...]
    backward_at: tuple[float, ...]
    gaps_at: tuple[tuple[float, float], ...]

    @property
    def written_as_minutes(self) -> bool:
        """True if time goes on from 59 to 100 at each gap, as numbers written ``hhmmss`` do."""
        jumps = ((begin % 100.0, (end - begin) % 100.0) for begin, end in self.gaps_at)
        return bool(self.gaps_at) and all(begin >= 59.0 and abs(jump - 40.0) < 1.0 for begin, jump in jumps)


def nominal_step(time: FloatArray) -> float:
    """The median positive step of a time base.

    That of many stamps is taken over blocks of them, so that its cost does not grow.

    Raises
    ------
    DataRefusedError
        Fewer than two different finite stamps.
    """
    steps = differences(time)
    positive = steps[(steps > 0.0) & np.isfinite(steps)]
    if positive.size == 0:
        backwards = (
            "it runs backwards: reverse the rows of the log" if np.any(steps < 0.0) else "is it another channel?"
        )
        raise DataRefusedError(f"the time base never advances: no stamp is later than the one before; {backwards}")
    return float(np.median(positive))


def default_gap_limit(step: float) -> float:
    """The longest hole [s] over which samples are still taken as neighbours, by the nominal step [s]."""
    return max(GAP_STEPS * step, GAP_FLOOR)


def seldom(count: int, step: float, lasts: float) -> bool:
    """True if `count` samples of a usual step cover less than half of a record, as if made on change only."""
    return 2.0 * count * step < lasts


def examine(time: FloatArray) -> TimeQuality:
    """Count and locate everything that is wrong with a time base.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s] in the order of the log.

    Raises
    ------
    DataRefusedError
        Fewer than two different finite stamps.

    Notes
    -----
    Cost: O(N), two passes in chunks; where some are not finite, a copy of the others on disk.
    """
    stamps = select(time, finite(time))
    step = nominal_step(stamps)
    limit = default_gap_limit(step)
    repeated_at = list[float]()
    backward_at = list[float]()
    gaps_at = list[tuple[float, float]]()
    repeated = backward = gaps = dropped = regular = 0
    shortest = np.inf
    longest = 0.0
    square = 0.0
    for rows in chunks(stamps.size, overlap=1):
        part = stamps[rows]
        steps = np.diff(part)
        same = np.flatnonzero(steps == 0.0)
        back = np.flatnonzero(steps < 0.0)
        gap = np.flatnonzero(steps > limit)
        repeated += same.size
        backward += back.size
        gaps += gap.size
        repeated_at += part[same[:LOCATED]].tolist()
        backward_at += part[back[:LOCATED]].tolist()
        gaps_at += [(float(part[j]), float(part[j + 1])) for j in gap[:LOCATED]]
        long = steps[(steps > ONE_LOST * step) & (steps <= limit)]
        dropped += int((np.rint(long / step) - 1.0).sum())
        positive = steps[steps > 0.0]
        shortest = min(shortest, float(positive.min(initial=np.inf)))
        longest = max(longest, float(positive.max(initial=0.0)))
        near = positive[positive <= ONE_LOST * step]
        regular += near.size
        square += float(((near - step) ** 2).sum())
    return TimeQuality(
        n=time.size,
        start=float(stamps[0]),
        stop=float(stamps[-1]),
        step=step,
        shortest=float(shortest),
        longest=longest,
        jitter=float(np.sqrt(square / max(regular, 1))),
        uniform=bool(max(longest - step, step - shortest) <= _UNIFORM * step) and not repeated and not backward,
        not_finite=int(time.size - stamps.size),
        repeated=repeated,
        backward=backward,
        gaps=gaps,
        dropped=dropped,
        gap_limit=limit,
        repeated_at=tuple(repeated_at[:LOCATED]),
        backward_at=tuple(backward_at[:LOCATED]),
        gaps_at=tuple(gaps_at[:LOCATED]),
    )


def unwrapped(time: FloatArray) -> FloatArray:
    """Stamps of a counter that began anew: where time [s] steps back it goes on by the nominal step, shape (N,)."""
    usual = nominal_step(time)

    def parts() -> Iterator[FloatArray]:
        """Chunk by chunk."""
        last = np.nan
        added = 0.0
        for rows in chunks(time.size):
            part = time[rows].copy()
            usable = np.isfinite(part)
            steps = np.diff(part[usable], prepend=last)
            lift = added + np.cumsum(np.where(steps < 0.0, usual - steps, 0.0))
            last, added = (part[usable][-1], lift[-1]) if lift.size else (last, added)
            part[usable] += lift
            yield part

    return column(time.size, parts(), np.float64)


def segments(time: FloatArray, gap_limit: float, ends: FloatArray = NO_CUTS) -> IntArray:
    """Parts of a time base between gaps and steps back.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Finite stamps [s], N ≥ 1; strictly increasing where there are `ends`.
    gap_limit : float
        Longest step [s] within a segment.
    ends : FloatArray
        Stamps [s] behind which a segment ends too, even if the hole is small.

    Returns
    -------
    IntArray, shape (S, 2)
        First index and end index (exclusive) of each segment, in order.
    """
    cuts = [np.searchsorted(time, ends, side="right")]
    for rows in chunks(time.size, overlap=1):
        steps = np.diff(time[rows])
        cuts.append(rows.start + 1 + np.flatnonzero((steps < 0.0) | (steps > gap_limit)))
    edges = np.unique(np.concatenate(([0], *cuts, [time.size])).astype(np.int64))
    return np.stack((edges[:-1], edges[1:]), axis=1)
