"""The ends of a sensor's range in its samples: a signal that is cut off there, exactly or beneath noise.

What is cut off stays at one level, which nothing exceeds, and comes and leaves at a slope. A rest is approached ever
more slowly: at half the time of the approach an exponential has gone three quarters of it, a line the half. At a
turning point the stay is shorter than the approach (a parabola: 0.7 times), and so it is for a triangle. All this is
seen in units of what the level shows by itself: half a step of the converter, or what noise may reach.
"""

from dataclasses import dataclass

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import BLOCKS, chunks
from .noise import CHANCE, below_resolution, resolution

_APPROACH = 15.0
"""Widths of the level over which an approach is looked at."""
IN_A_ROW = 3
"""Samples that make a stay."""


@dataclass(frozen=True)
class Rail:
    """An end of a sensor's range.

    Attributes
    ----------
    low, high : float
        Samples between these, three or more in a row, are at the end of the range.
    share : float
        Share of the samples that are.
    """

    low: float
    high: float
    share: float

    @property
    def level(self) -> float:
        """The middle."""
        return 0.5 * (self.low + self.high)


def rail(values: FloatArray, usual: tuple[float, float], end: int, noise: float) -> Rail | None:
    """The end of the sensor's range, where a signal is cut off by it.

    Parameters
    ----------
    values : FloatArray, shape (N,)
        Finite samples.
    usual : (float, float)
        Smallest and largest value that three samples in a row reach.
    end : {0, 1}
        The lower or the upper end.
    noise : float
        Standard deviation of the noise in them.

    Notes
    -----
    Cost: two passes in chunks for each form that is tried, the exact level and the one beneath noise.
    """
    if not usual[1] > usual[0]:
        return None
    sign = 2.0 * end - 1.0
    level = usual[end]
    begin = values[: 1 << 17]
    others = begin[np.isfinite(begin) & (begin != level)]
    digit = resolution(others)
    exact = runs_between(values, level, level)
    if _is_exact(exact, values, others, level, digit, noise) and not _passed(values, usual, end, 0.0):
        return _rail(values, exact, level, 0.0)
    if noise > 0.0 and not below_resolution(noise, digit):
        from scipy.special import ndtri

        width = float(-ndtri(CHANCE / values.size)) * noise
        near = begin[np.abs(begin - level) <= 2.0 * width]
        level = float(np.median(near)) if near.size else level
        runs = runs_between(values, level - width, level + width)
        if _cut_off(values, runs, level, width, noisy=True) and not _passed(
            values, usual, end, width + sign * (level - usual[end])
        ):
            return _rail(values, runs, level, width)
    return None


def _rail(values: FloatArray, runs: IntArray, level: float, width: float) -> Rail:
    lengths = np.diff(runs, axis=1)
    return Rail(level - width, level + width, float(lengths[lengths >= IN_A_ROW].sum()) / values.size)


def runs_between(values: FloatArray, low: float, high: float) -> IntArray:
    """First and end index of each run of samples from `low` to `high`, shape (n, 2)."""
    edges = [np.empty(0, dtype=np.int64)]
    before = False
    for rows in chunks(values.size):
        inside = (values[rows] >= low) & (values[rows] <= high)
        edges.append(rows.start + np.flatnonzero(np.diff(inside, prepend=before)))
        before = bool(inside[-1])
    edges.append(np.full(int(before), values.size))
    return np.concatenate(edges).reshape(-1, 2)


def in_a_row(inside: BoolArray) -> BoolArray:
    """Which of the samples that are inside lie in a run of three or more of them."""
    edges = np.flatnonzero(np.diff(inside.astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
    long = edges[edges[:, 1] - edges[:, 0] >= IN_A_ROW]
    steps = np.zeros(inside.size + 1, dtype=np.int8)
    steps[long[:, 0]] += 1
    steps[long[:, 1]] -= 1
    marked: BoolArray = np.cumsum(steps[:-1]) > 0
    return marked


def _is_exact(
    runs: IntArray, values: FloatArray, others: FloatArray, level: float, digit: float | None, noise: float
) -> bool:
    """Whether the equal samples at a level are more than chance, and where steps hide the noise, cut off."""
    longest = int(np.diff(runs, axis=1).max(initial=0))
    if longest < IN_A_ROW:
        return False
    equal = float(np.mean(np.diff(others) == 0.0)) if others.size > 1 else 0.0
    if below_resolution(noise, digit) or equal > 0.5:
        return _cut_off(values, runs, level, 0.5 * (digit or 0.0), noisy=False)
    return int(np.diff(runs, axis=1).sum()) * equal ** (longest - 1) < CHANCE


def _cut_off(values: FloatArray, runs: IntArray, level: float, width: float, *, noisy: bool) -> bool:
    """Whether the signal comes to its longest stays at a level, of this width to both sides, and leaves them, as a
    line does.

    Beneath noise both sides of a single turning point may look straight, so more than those must be seen.
    """
    lengths = np.diff(runs, axis=1).ravel()
    longest = np.argsort(-lengths, kind="stable")[:BLOCKS]
    stays = runs[longest[lengths[longest] >= IN_A_ROW]].tolist()
    reach = int(_APPROACH)
    coming = [values[max(0, first - reach * (end - first)) : first + 1][::-1] for first, end in stays]
    leaving = [values[end - 1 : end + reach * (end - first)] for first, end in stays]
    seen = 0
    for sides in (coming, leaving):
        approaches = [
            approach
            for side, (first, end) in zip(sides, stays, strict=True)
            if (approach := _approach(np.abs(side - level), end - first, width, noisy=noisy)) is not None
        ]
        if approaches:
            left, stay = np.median(np.array(approaches), axis=0).tolist()
            if left**2 < 0.5**3 or stay < 2.0:  # between the half of a line and the quarter of an exponential
                return False
        seen += len(approaches)
    return seen >= (IN_A_ROW if noisy else 1)


def _approach(off: FloatArray, stay: int, width: float, *, noisy: bool) -> tuple[float, float] | None:
    """The share of an approach that is left at half time, and the stay over the time that it takes.

    Parameters
    ----------
    off : FloatArray, shape (N,)
        Distances from the level, from the last sample of the stay outwards.
    stay : int
        Samples of it.
    width : float
        Half the level's width.
    noisy : bool
        Whether noise makes the width. Then an approach within two samples is a line by its next steps only, as it may
        be the step of a command; in steps of a converter it is one.
    """
    far = int(np.argmax(off >= _APPROACH * width))
    if far == 0:
        return None
    if far < 3:
        steps = np.diff(off[1:4])
        even = steps.size > 1 and steps[0] >= off[1] and abs(steps[1] - steps[0]) < 0.5 * steps[0]
        return (0.5, np.inf) if even or not noisy else None
    left = max(1.0 - float(off[1] / max(off[2] - off[1], off[1])), 0.0)  # of the first sample, where the line begins
    middle = float(np.interp(0.5 * (left + far), np.arange(off.size), off))
    return middle / float(off[far]), stay / (far - left)


def _passed(values: FloatArray, usual: tuple[float, float], end: int, beyond: float) -> bool:
    """Whether three samples beside others like them lie more than `beyond` outside of the usual end: no spikes."""
    sign = 2.0 * end - 1.0
    count = 0
    for rows in chunks(values.size, overlap=1):
        over = sign * (values[rows] - usual[end]) > beyond
        count += int(np.count_nonzero(over[1:] & over[:-1]))
    return count >= IN_A_ROW
