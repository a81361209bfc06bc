"""The uniform clock behind stamps that were rounded: to milliseconds, to six digits, or to single precision.

The stamps of a uniform clock that were rounded to a lattice of step R lie a whole number of R apart, and their steps
take two neighbouring multiples of R. So R follows from the stamps, block by block, since the lattice of floating
numbers widens with them. The clock is uniform if one line a + b k passes every stamp within R/2. The line that
keeps farthest from these limits is taken: a linear programme over the stamps that bind.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray, IntArray
from ..units.quantity import quantity
from .columns import ROUNDING, chunks, column, finite, select
from .noise import CHANCE
from .timebase import ONE_LOST, default_gap_limit, nominal_step, segments

_BLOCK = 256
"""Stamps over which the lattice is taken as constant."""


@dataclass(frozen=True)
class UniformClock:
    """A uniform clock whose stamps were rounded.

    Attributes
    ----------
    time : FloatArray, shape (N,)
        Its stamps [s]; what was not finite still is not.
    step : float
        Time [s] from one sample to the next, in the longest part without a gap.
    resolution : float
        Largest step [s] of the lattice to which the stamps were rounded.
    """

    time: FloatArray
    step: float
    resolution: float

    @property
    def described(self) -> str:
        """Rate of the clock, and rounding of its stamps."""
        return (
            f"those of a clock of {1.0 / self.step:.6g} Hz, rounded to {quantity(self.resolution, 's')}: taken as "
            "uniform"
        )


def uniform_clock(time: FloatArray) -> UniformClock | None:
    """The uniform clock behind rounded stamps; None where they are exact, or not those of one.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s] in the order of the log. Gaps and steps back divide it; each part has a line of its own.

    Notes
    -----
    Cost: two passes over exact stamps; for rounded ones about ten more, and as many small linear programmes. All in
    chunks.
    """
    usable = finite(time)
    stamps = select(time, usable)
    try:
        limit = default_gap_limit(nominal_step(stamps))
    except DataRefusedError:  # it never advances
        return None
    for lossy, (half, fuzz) in _resolutions(stamps, limit).items():
        count = _counts(stamps, limit) if lossy else _rows(usable)
        lines = _lines(stamps, count, half, fuzz, segments(stamps, limit))
        if lines:
            longest = max(lines, key=lambda line: line.rows.stop - line.rows.start)
            return UniformClock(_on_lines(time, usable, count, lines), longest.slope, 2.0 * float(half.max()))
    return None


def _blocks(stamps: FloatArray) -> Iterator[FloatArray]:
    """Steps of the stamps, shape (n, `_BLOCK`), chunk by chunk; the last block is filled up with NaN."""
    for rows in chunks(stamps.size, overlap=1):
        steps = np.diff(stamps[rows])
        yield np.concatenate((steps, np.full(-steps.size % _BLOCK, np.nan))).reshape(-1, _BLOCK)


def _resolutions(stamps: FloatArray, limit: float) -> dict[bool, tuple[FloatArray, float]]:
    """Half the lattice's step in each block, and what the steps miss it by at most, [s].

    By whether single rows are missing: without such, each step counts; with such, those of one sampling step only.
    There is no entry where the steps show no lattice.
    """
    rounding = 4.0 * float(np.spacing(np.abs(stamps).max()))
    seen: dict[bool, list[tuple[FloatArray, FloatArray, FloatArray]]] = {False: [], True: []}
    for steps in _blocks(stamps):
        near = np.where((steps >= 0.0) & (steps <= limit), steps, np.nan)
        single = np.where(near > 0.0, near, np.nan)
        middle = np.nanmedian(np.where(np.isnan(single).all(axis=1, keepdims=True), 0.0, single), axis=1, keepdims=True)
        own = np.where(single <= ONE_LOST * middle + rounding, single, np.nan)
        every = _lattice(near, rounding)
        seen[False].append(every)
        seen[True].append(every if np.array_equal(own, near, equal_nan=True) else _lattice(own, rounding))
    resolutions = {}
    for lossy, parts in seen.items():
        step, missed, odd = (np.concatenate(each) for each in zip(*parts, strict=True))
        with_step = np.flatnonzero(step)
        count = int(odd.sum())
        # So likely are that many random places all as evenly spread as those of odd steps: count!/count**count.
        if with_step.size and math.lgamma(count + 1) - count * math.log(max(count, 1)) < math.log(CHANCE):
            finest = np.minimum.accumulate(step[with_step][::-1])[::-1]
            of_blocks = finest[np.minimum(np.searchsorted(with_step, np.arange(step.size)), with_step.size - 1)]
            behind = np.append(of_blocks[1:], of_blocks[-1])  # the lattice may widen within a block
            resolutions[lossy] = 0.5 * np.maximum(of_blocks, behind), float(missed.max()) + rounding
    return resolutions


def _lattice(steps: FloatArray, rounding: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Step of the lattice in each block [s], 0 where its steps are not two neighbouring multiples of one; by how much
    [s] they miss these; and how many steps are those of the rarer multiple.
    """
    ordered = np.sort(np.where(np.isnan(steps), np.fmin.reduce(steps, axis=1)[:, None], steps), axis=1)
    at = np.argmax(np.nan_to_num(np.diff(ordered, axis=1)), axis=1)
    block = np.arange(len(ordered))
    low = ordered[block, at]
    high = ordered[block, at + 1]
    missed = (low - ordered[:, 0]) + (ordered[:, -1] - high)
    step = 0.5 * (high + ordered[:, -1] - low - ordered[:, 0])
    with np.errstate(invalid="ignore", divide="ignore"):
        multiple = 0.5 * (ordered[:, 0] + low) / step
        error = (0.5 * missed + rounding) / step
        shown = (step > 3.0 * (missed + rounding)) & (np.abs(multiple - np.rint(multiple)) <= error * (1.0 + multiple))
    rare = np.minimum(at + 1, _BLOCK - 1 - at)
    return np.where(shown, step, 0.0), np.where(shown, missed, 0.0), np.where(shown, rare, 0)


def _rows(usable: BoolArray) -> IntArray:
    """Number of each stamp, the row in which it stands."""
    parts = (rows.start + np.flatnonzero(usable[rows]) for rows in chunks(usable.size))
    return column(int(np.count_nonzero(usable)), parts, np.int64)


def _counts(stamps: FloatArray, limit: float) -> IntArray:
    """Number of each stamp where single rows are missing or written twice: each step by the usual ones in it."""
    total = 0.0
    count = 0
    usual = nominal_step(stamps)
    for steps in _blocks(stamps):
        single = steps[(steps > 0.0) & (steps <= ONE_LOST * usual)]
        total += float(single.sum())
        count += single.size
    step = total / max(count, 1)

    def parts() -> Iterator[IntArray]:
        """Chunk by chunk."""
        last = 0
        yield np.zeros(1, dtype=np.int64)
        for rows in chunks(stamps.size, overlap=1):
            steps = np.diff(stamps[rows])
            near = (steps >= 0.0) & (steps <= limit)
            passed = last + np.cumsum(np.where(near, np.rint(steps / step), 1.0).astype(np.int64))
            last = int(passed[-1]) if passed.size else last
            yield passed

    return column(stamps.size, parts(), np.int64)


@dataclass(frozen=True)
class _Line:
    """The clock of consecutive rows: stamp k is ``start + slope · (k − first)`` [s]."""

    rows: slice
    first: int
    start: float
    slope: float


def _lines(stamps: FloatArray, count: IntArray, half: FloatArray, fuzz: float, parts: IntArray) -> list[_Line]:
    """A line for each part; none at all where one of them has none within the resolution."""
    lines = []
    for first, end in parts.tolist():
        line = _line(stamps, count, half, fuzz, slice(first, end))
        if line is None:
            return []
        lines.append(line)
    return lines


def _line(stamps: FloatArray, count: IntArray, half: FloatArray, fuzz: float, part: slice) -> _Line | None:
    """The line through the middle of what the stamps of a part allow, None where they allow none."""
    from scipy.optimize import linprog

    start = float(stamps[part.start])
    first = int(count[part.start])
    length = int(count[part.stop - 1]) - first
    if length == 0:
        return _Line(part, first, start, 0.0)
    slope = (float(stamps[part.stop - 1]) - start) / length
    unit = float(half.max())

    def scaled(rows: IntArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Place from 0 to 1, distance from the first line and its limit in units of the resolution."""
        places = count[rows] - first
        limits = (half[np.maximum(rows - 1, 0) // _BLOCK] + fuzz) / unit
        return places / length, (stamps[rows] - start - slope * places) / unit, limits

    binding = np.array([part.start, part.stop - 1])
    while True:
        place, off, limit = scaled(binding)
        above = np.column_stack((np.ones(binding.size), place, np.ones(binding.size)))
        below = np.column_stack((-np.ones(binding.size), -place, np.ones(binding.size)))
        bounds = np.concatenate((off + limit, limit - off))
        solved = linprog([0.0, 0.0, -1.0], np.concatenate((above, below)), bounds, bounds=[(None, None)] * 3)
        level, tilt, margin = (np.nan, np.nan, -np.inf) if solved.x is None else solved.x
        if margin < -ROUNDING:
            return None
        worst = []
        for rows in chunks(part.stop - part.start):
            numbers = np.arange(part.start + rows.start, part.start + rows.stop)
            place, off, limit = scaled(numbers)
            beyond = np.abs(off - level - tilt * place) - limit + margin
            if beyond.max() > ROUNDING:
                worst.append(int(numbers[np.argmax(beyond)]))
        if not set(worst) - set(binding.tolist()):
            return _Line(part, first, start + unit * float(level), slope + unit * float(tilt) / length)
        binding = np.union1d(binding, np.array(worst))


def _on_lines(time: FloatArray, usable: BoolArray, count: IntArray, lines: list[_Line]) -> FloatArray:
    """The stamps on their lines, and those that are not finite."""
    on_lines: Iterator[FloatArray] = (
        np.asarray(line.start + line.slope * (count[line.rows][rows] - line.first), dtype=np.float64)
        for line in lines
        for rows in chunks(line.rows.stop - line.rows.start)
    )
    uniform: FloatArray = column(count.size, on_lines, np.float64)
    if count.size == time.size:
        return uniform

    def all_rows() -> Iterator[FloatArray]:
        """All stamps, chunk by chunk."""
        passed = 0
        for rows in chunks(time.size):
            places = passed + np.cumsum(usable[rows])
            yield np.where(usable[rows], uniform[places - 1], time[rows])
            passed = int(places[-1])

    return column(time.size, all_rows(), np.float64)
