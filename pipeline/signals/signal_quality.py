"""The quality of one measured signal: rails, hum, spikes, frozen segments, noise, and the size of its numbers.

What is cut off at an end of the sensor's range stays at one level, which nothing exceeds, and comes and leaves at a
slope. A rest is approached ever more slowly: at half the time of the approach an exponential has gone three quarters of
it, a line the half. At a turning point the stay is shorter than the approach (a parabola: 0.7 times), and so it is for
a triangle. All this is seen in units of what the level shows by itself: half a step of the converter, or what noise may
reach.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from ..numerics.metrics import NORMAL_MEDIAN
from .columns import BLOCKS, CHUNK, chunks, column, finite, select
from .noise import (
    CHANCE,
    REACH,
    Bandwidth,
    Hum,
    bandwidth,
    below_resolution,
    hum,
    is_idle,
    is_stepped,
    noise_level,
    resolution,
)
from .timebase import LOCATED

_APPROACH = 15.0
"""Widths of the level over which an approach is looked at."""
IN_A_ROW = 3
"""Samples that make a stay."""
OF_BESIDE = 4.0
"""Times what is beside it that a jump or a spike is at least; a motion of eight samples a period has up to 2."""
BESIDE_SPIKE = 32
"""Samples on either side whose noise a spike is compared with: an amplifier may be noisier while it is on."""
MOST_LEVELS = 8
"""Different values up to which they are listed one by one."""
BOTH_SIGNS = 0.1
"""Share of an input's largest magnitude beyond which it takes a sign."""


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


def rail(values: FloatArray, usual: tuple[float, float], end: int, noise: float) -> Rail | None:
    """The end of the sensor's range, where a signal is cut off by it; None where it is not.

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
    begin = values[:CHUNK]
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
    """Mask of the samples inside that lie in a run of three or more of them."""
    from scipy.ndimage import binary_opening

    return np.asarray(binary_opening(inside, np.ones(IN_A_ROW, dtype=np.bool_)))


def _is_exact(
    runs: IntArray, values: FloatArray, others: FloatArray, level: float, digit: float | None, noise: float
) -> bool:
    """True if the equal samples at a level are more than chance, and where steps hide the noise, cut off."""
    longest = int(np.diff(runs, axis=1).max(initial=0))
    if longest < IN_A_ROW:
        return False
    equal = float(np.mean(np.diff(others) == 0.0)) if others.size > 1 else 0.0
    by_steps = below_resolution(noise, digit) or equal > 0.5
    by_chance = int(np.diff(runs, axis=1).sum()) * equal ** (longest - 1)
    return _cut_off(values, runs, level, 0.5 * (digit or 0.0), noisy=False) if by_steps else by_chance < CHANCE


def _cut_off(values: FloatArray, runs: IntArray, level: float, width: float, *, noisy: bool) -> bool:
    """True if the signal enters and leaves its longest stays at a level, of this width to both sides, along a line.

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
        True if noise makes the width. Then an approach within two samples is a line by its next steps only, as it may
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
    """True if three samples beside others like them lie more than `beyond` outside of the usual end: no spikes."""
    sign = 2.0 * end - 1.0
    count = 0
    for rows in chunks(values.size, overlap=1):
        over = sign * (values[rows] - usual[end]) > beyond
        count += int(np.count_nonzero(over[1:] & over[:-1]))
    return count >= IN_A_ROW


@dataclass(frozen=True)
class SignalQuality:
    """Quality of one signal, in its own unit; times in s.

    Attributes
    ----------
    n, not_finite, lost : int
        Samples, how many of them are NaN or infinite, and of how many either this is so or the time is not known.
    not_finite_at : tuple of float
        Places of the first `LOCATED` of them.
    smallest, largest, mean : float
        Of the finite samples.
    usual : (float, float)
        Smallest and largest that three samples in a row reach.
    noise : float
        Standard deviation of the white noise in it, from the medians of its differences.
    idle : bool
        True if there is only noise: the span is that of 10⁶ normal samples or less, and it is no command.
    low_rail, high_rail : float
        Share of the samples that stay at the lower, at the upper end of the sensor's range.
    rails : tuple of (float, float)
        Ranges of values, three samples in a row within which are at such an end.
    stepped : bool
        True if it stands still between its steps, as a command does.
    levels : tuple of float
        The values that it takes, if they are `MOST_LEVELS` at most; else empty.
    longest_frozen : float
        Duration of the longest run of one and the same value [s].
    frozen_samples : int
        Number of its samples.
    frozen_at : float
        Start of that run [s].
    rests : bool
        True if that run may be a rest in the steps of a sensor, as it is entered and left by few of them.
    spikes : int
        Single samples that leave the line between their neighbours by more than noise reaches.
    spikes_at : tuple of float
        Places of the first `LOCATED` of them.
    hum : tuple of Hum
        Mains lines, as far as the sampling rate and the duration allow.
    band : Bandwidth
        Its bandwidth [Hz].
    """

    n: int
    not_finite: int
    lost: int
    not_finite_at: tuple[float, ...]
    smallest: float
    largest: float
    mean: float
    usual: tuple[float, float]
    noise: float
    idle: bool
    low_rail: float
    high_rail: float
    rails: tuple[tuple[float, float], ...]
    stepped: bool
    levels: tuple[float, ...]
    longest_frozen: float
    frozen_samples: int
    frozen_at: float
    rests: bool
    spikes: int
    spikes_at: tuple[float, ...]
    hum: tuple[Hum, ...]
    band: Bandwidth

    @property
    def constant(self) -> bool:
        """True if all finite samples are equal."""
        return self.smallest == self.largest

    @property
    def span(self) -> float:
        """Largest less smallest sample."""
        return self.largest - self.smallest

    @property
    def ramped(self) -> bool:
        """True if it comes to both ends of its range at a slope, beneath its noise, as a command with ramps does."""
        return is_ramped(self.rails)


def examine_signal(time: FloatArray, samples: FloatArray, step: float) -> SignalQuality:
    """Describe one signal.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s], only used to locate events.
    samples : FloatArray, shape (N,)
        The signal; NaN and infinities allowed.
    step : float
        Nominal sampling step [s].

    Returns
    -------
    SignalQuality
        With NaN extremes where no sample is finite.

    Notes
    -----
    Cost: some five passes over the samples in chunks; the hum's spectrum is taken of at most
    64 windows.
    """
    usable = finite(samples)
    values = select(samples, usable)
    stamps = select(time, usable)
    missing = samples.size - values.size
    located = tuple(select(time, ~usable)[:LOCATED].tolist())
    lost = missing + sum(int(np.count_nonzero(~np.isfinite(stamps[rows]))) for rows in chunks(stamps.size))
    if not values.size:
        return _nothing_finite(samples.size, located)
    smallest, largest = span(values)
    noise = noise_level(values)
    frozen, start = _longest_run(values)
    began, ended = stamps[[start, start + frozen - 1]].tolist()
    spikes, first_spikes = single_spikes(values, noise)
    usual = usual_span(values)
    low, high = (rail(values, usual, end, noise) for end in (0, 1))
    return SignalQuality(
        n=samples.size,
        not_finite=missing,
        lost=lost,
        not_finite_at=located,
        smallest=smallest,
        largest=largest,
        mean=float(values.mean()),
        usual=usual,
        noise=noise,
        idle=is_idle(values),
        low_rail=low.share if low else 0.0,
        high_rail=high.share if high else 0.0,
        rails=tuple((end.low, end.high) for end in (low, high) if end),
        stepped=is_stepped(values),
        levels=few_levels(values),
        longest_frozen=ended - began,
        frozen_samples=frozen,
        frozen_at=began,
        rests=_rests(values, start, start + frozen),
        spikes=spikes,
        spikes_at=tuple(stamps[first_spikes].tolist()),
        hum=hum(values, step),
        band=bandwidth(bridged(values, noise) if spikes else values, step, noise),
    )


def _nothing_finite(count: int, located: tuple[float, ...]) -> SignalQuality:
    """Quality of a signal of so many samples, none of which is finite."""
    return SignalQuality(
        n=count,
        not_finite=count,
        lost=count,
        not_finite_at=located,
        smallest=np.nan,
        largest=np.nan,
        mean=np.nan,
        usual=(np.nan, np.nan),
        noise=np.nan,
        idle=False,
        low_rail=0.0,
        high_rail=0.0,
        rails=(),
        stepped=False,
        levels=(),
        longest_frozen=0.0,
        frozen_samples=0,
        frozen_at=np.nan,
        rests=False,
        spikes=0,
        spikes_at=(),
        hum=(),
        band=Bandwidth(np.nan, np.nan),
    )


def is_ramped(rails: Sequence[tuple[float, float]]) -> bool:
    """True if a signal comes to both ends of its range, `rails` as in `SignalQuality`, at a slope beneath its noise."""
    return len(rails) == 2 and all(high > low for low, high in rails)


def few_levels(values: FloatArray) -> tuple[float, ...]:
    """The different values, none where there are more than `MOST_LEVELS`."""
    levels: set[float] = set()
    for rows in chunks(values.size):
        levels.update(np.unique(values[rows])[: MOST_LEVELS + 1].tolist())
        if len(levels) > MOST_LEVELS:
            return ()
    return tuple(sorted(levels))


def span(samples: FloatArray) -> tuple[float, float]:
    """Smallest and largest sample, NaN left out; NaN where there is none."""
    return float(np.fmin.reduce(samples, initial=np.nan)), float(np.fmax.reduce(samples, initial=np.nan))


def takes_both_signs(smallest: float, largest: float) -> bool:
    """True if an input between these values takes both signs, each to a tenth of its largest magnitude at least."""
    return min(-smallest, largest) > BOTH_SIGNS * max(-smallest, largest)


def usual_span(samples: FloatArray) -> tuple[float, float]:
    """Smallest and largest value that three samples in a row reach: no spike of one or two does."""
    lowest = np.nan
    highest = np.nan
    for rows in chunks(samples.size, overlap=2):
        stays = sliding_window_view(samples[rows], min(IN_A_ROW, rows.stop - rows.start)).T
        lowest = np.fmin(lowest, np.fmin.reduce(stays.max(axis=0)))
        highest = np.fmax(highest, np.fmax.reduce(stays.min(axis=0)))
    # A signal that nowhere stays for three samples reaches its highest value less often than its lowest.
    return float(np.fmin(lowest, highest)), float(np.fmax(lowest, highest))


def single_spikes(values: FloatArray, noise: float) -> tuple[int, IntArray]:
    """Single samples far off the line between neighbours that agree with each other: how many, and the first ones."""
    count = 0
    first = np.empty(0, dtype=np.int64)
    for rows in chunks(values.size):
        begin = max(rows.start - BESIDE_SPIKE, 0)
        spikes = begin + 1 + np.flatnonzero(spikes_in(values[begin : rows.stop + BESIDE_SPIKE], noise))
        spikes = spikes[(spikes >= rows.start) & (spikes < rows.stop)]
        count += spikes.size
        if first.size < LOCATED:
            first = np.concatenate((first, spikes))[:LOCATED]
    return count, first


def bridged(values: FloatArray, noise: float) -> FloatArray:
    """The values with each spike on the line between its neighbours, since none is motion."""

    def parts() -> Iterator[FloatArray]:
        """Chunk by chunk."""
        for rows in chunks(values.size):
            begin = max(rows.start - BESIDE_SPIKE, 0)
            part = values[begin : rows.stop + BESIDE_SPIKE].copy()
            at = 1 + np.flatnonzero(spikes_in(part, noise))
            part[at] = 0.5 * (part[at - 1] + part[at + 1])
            yield part[rows.start - begin : rows.stop - begin]

    return column(values.size, parts(), np.float64)


def spikes_in(part: FloatArray, noise: float) -> BoolArray:
    """Single samples far off the line between neighbours that agree with each other, shape (N − 2,).

    Two samples further on either side lie on that line too; beside a turning point, where a slow log has few samples,
    they bend away from it. And it is far beyond the noise of the samples around it.
    """
    with np.errstate(invalid="ignore"):  # infinite samples
        off = np.abs(part[1:-1] - 0.5 * (part[:-2] + part[2:]))
        apart = np.abs(part[2:] - part[:-2])
        bend = np.zeros_like(off)
        bend[1:-1] = 0.5 * np.abs(part[:-4] + part[4:] - part[1:-3] - part[3:-1])
    spikes: BoolArray = (off > 2.0 * REACH * noise) & (off > OF_BESIDE * np.maximum(apart, bend)) & (noise > 0.0)
    at = np.flatnonzero(spikes)
    spikes[at] = off[at] > 2.0 * REACH * _noise_around(part, at + 1)
    return spikes


def _noise_around(part: FloatArray, at: IntArray) -> FloatArray:
    """Noise of the samples before or behind each place, whichever is larger, from the median of second differences."""
    beside = np.arange(1, BESIDE_SPIKE + 1)
    sides = [part[np.clip(at[:, None] + side * beside, 0, part.size - 1)] for side in (-1, 1)]
    with np.errstate(invalid="ignore"):  # infinite samples
        second = np.nan_to_num(np.diff(sides, 2, axis=2), posinf=0.0, neginf=0.0)
    return np.asarray(NORMAL_MEDIAN / np.sqrt(6.0) * np.median(np.abs(second), axis=2).max(axis=0))


def _rests(values: FloatArray, begin: int, end: int) -> bool:
    """True if a run of equal samples may be a rest, as a sensor's steps hide its noise."""
    beside = values[[i for i in (begin - 1, end) if 0 <= i < values.size]]
    step = resolution(values)
    return step is not None and bool(np.all(np.abs(beside - values[begin]) <= 2.0 * step))


def _longest_run(values: FloatArray) -> tuple[int, int]:
    """Length and first index of the longest run of equal values, the first of several."""
    longest = 0
    at = 0
    began = 0
    for rows in chunks(values.size, overlap=1):
        changes = rows.start + 1 + np.flatnonzero(np.diff(values[rows]) != 0.0)
        edges = np.concatenate(([began], changes, [values.size] if rows.stop == values.size else [])).astype(np.int64)
        lengths = np.diff(edges)
        if lengths.size and lengths.max() > longest:
            longest = int(lengths.max())
            at = int(edges[np.argmax(lengths)])
        began = int(edges[-1])
    return longest, at
