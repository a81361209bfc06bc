"""Unevenly sampled signals on a uniform grid: decimated without delay or aliasing, or interpolated.

At the ends of a segment the kernel is cut, and its first moment no longer vanishes. There, and wherever jittered
stamps leave a moment of more than 10⁻⁶ T, the weighted mean is taken about a local line. Its slope is that of least
squares under the positive window (1 − y)². So straight lines are reproduced exactly everywhere.

The anti-alias kernel is a low pass without delay that hardly rings. With x the distance of a sample from the grid
point in output intervals T and y = (x/2)²,

    K(x) = (1 − y)² Σ_k a_k y^k   for |x| ≤ 2, else 0,

evaluated at the samples' actual times and weighted by their trapezoidal share of the time axis. It is
symmetric, so phase and group delay are zero and a step stays where it is (the 50 % point to within the raw
sampling). The coefficients solve a linear program: least stop-band gain under bounds on the step response's
overshoot and on the droop at 0.1/T. Figures (T = 10 ms in brackets):

=============================  ==========================
overshoot of a step            1.5 %, before and after, gone 2 T away from the step
rise time, 10 to 90 %          0.87 T (8.7 ms)
droop at 0.1/T (10 Hz)         1.0 %
−3 dB                          0.41/T (41 Hz)
at 0.5/T, the Nyquist limit    −5.2 dB
at 0.9/T, aliased onto 0.1/T   −19 dB
at 1/T, aliased onto 0         −27 dB
beyond 1.08/T                  below −40 dB
white noise, RMS               0.92 sqrt(raw step / T) times the raw one
=============================  ==========================

A sharper filter would ring: a steep cut at 0.5/T overshoots a voltage step by about 9 % (Gibbs). Where a drive
steps, ringing is worse than the little noise that folds over.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray, runs_of
from .columns import CHUNK, ROUNDING, Stream, chunks, column

REACH = 2.0
"""Half width of the kernel in output intervals."""

_COEFFICIENTS = (1.1192, -12.2297, 52.0192, -112.3366, 126.2552, -60.1179)
LEAST_RATIO = 1.5
"""Fewest raw samples per output interval for decimation; fewer are interpolated."""
_BLOCK = 1 << 15  # samples that are decimated at once
_STEEPEST = 1.5  # times the steps beside it, the largest slope at a sample


def filtered_samples(values: FloatArray, ratio: int) -> FloatArray:
    """Every `ratio`-th value of a uniform signal, low-pass filtered as a log is when it is brought to its samples.

    Parameters
    ----------
    values : FloatArray, shape (…, ratio (N−1) + 1, C)
        C signals.
    ratio : int
        Values in a sample interval.

    Returns
    -------
    FloatArray, shape (…, N, C)
        The first and the last two samples, where the kernel would be cut, are the values themselves. Between values
        the signal is a cubic spline: the kernel at the values alone widens it twofold at a ratio of 2.
        Cost: 4 `ratio` multiply-adds for each.
    """
    samples: FloatArray = values[..., ::ratio, :].copy()
    if samples.shape[-2] > 2 * REACH:
        size = 2 * int(REACH) * ratio + 1
        windows = np.lib.stride_tricks.sliding_window_view(values, size, axis=-2)[..., ::ratio, :, :]
        samples[..., int(REACH) : -int(REACH), :] = windows @ _weights(ratio)
    return samples


@cache
def _weights(ratio: int) -> FloatArray:
    """Integral of the kernel times the cubic spline that is 1 at one of `ratio` values in a sample interval, each."""
    from scipy.interpolate import CubicSpline

    nodes = np.arange(-int(REACH) * ratio, int(REACH) * ratio + 1) / ratio
    fine = np.linspace(-REACH, REACH, 64 * (len(nodes) - 1) + 1)
    weights: FloatArray = kernel(fine) @ CubicSpline(nodes, np.eye(len(nodes)))(fine)
    weights /= weights.sum()
    return weights


def sharpened(samples: FloatArray, usable: BoolArray) -> FloatArray:
    """Smooth signal before `decimated`, restored from its samples, shape (N,).

    The kernel's response is 1 + m2/2 D² + m4/24 D⁴ + … in derivatives D per sample interval, m2 and m4 being its
    moments; the inverse is taken to fourth order, in differences of five samples. Where one of them is not `usable` a
    sample stays as it is. Cost: 10 flops each; noise at the Nyquist limit grows by a quarter.
    """
    sharp = samples.copy()
    if len(samples) < 5:
        return sharp
    second = np.diff(samples, 2)
    by_second, by_fourth = _sharpening()
    inside = np.lib.stride_tricks.sliding_window_view(usable, 5).all(axis=1)
    sharp[2:-2] += np.where(inside, by_second * second[1:-1] + by_fourth * np.diff(second, 2), 0.0)
    return sharp


def kernel(x: FloatArray, coefficients: Sequence[float] = _COEFFICIENTS) -> FloatArray:
    """The decimation kernel K(x), unnormalised, for |x| ≤ 2 in output intervals; any shape.

    With the one coefficient 1 it is the positive window (1 − y)² of the local slope.
    """
    y = np.square(x * (1.0 / REACH))
    value = np.full_like(y, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        value *= y
        value += coefficient
    np.subtract(1.0, y, out=y)
    value *= y
    value *= y
    return value


@cache
def _sharpening() -> tuple[float, float]:
    """Factors of second and fourth differences in `sharpened`: D² = δ² − δ⁴/12."""
    fine = np.linspace(-REACH, REACH, 4001)
    weights = kernel(fine)
    m2, m4 = (float(np.sum(weights * fine**power) / np.sum(weights)) for power in (2, 4))
    return -m2 / 2.0, m2 / 24.0 + (m2 / 2.0) ** 2 - m4 / 24.0


def uniform_grid(start: float, stop: float, interval: float) -> FloatArray:
    """Points ``start + j·interval`` [s] up to `stop` and a millionth of an interval beyond, shape (M,)."""
    size = int(np.floor((stop - start) / interval + ROUNDING)) + 1
    parts = (start + interval * np.arange(rows.start, rows.stop, dtype=np.float64) for rows in chunks(size))
    return column(size, parts, np.float64)


def decimated(
    time: FloatArray, columns: Sequence[FloatArray], t_out: FloatArray, interval: float
) -> Iterator[FloatArray]:
    """Low-pass and sample one gap-free segment on a uniform grid; shape (k, m), piece after piece.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Strictly increasing time stamps [s], not necessarily uniform, without gaps.
    columns : sequence of k FloatArray, shape (N,) each
        Finite samples, of any length.
    t_out : FloatArray, shape (M,)
        Uniform grid [s] of step `interval`, inside ``[time[0], time[-1]]``.
    interval : float
        Output interval T [s], at least `LEAST_RATIO` raw steps.

    Notes
    -----
    Cost: every sample meets its four kernels once, 4 N kernel values of 17 flops and 4 (k + 2) N multiply-adds. Blocks
    of 2¹⁵ samples stay in the second-level cache, and the working memory is a few MB however long the log. About 0.1 µs
    a sample for k = 3 on one core of 2024.
    """
    if time.size == 1:
        yield np.array([np.full(t_out.size, column[0]) for column in columns], dtype=np.float64)
        return
    slopes = _Slopes(time, columns, t_out, interval)
    apart = _BLOCK * t_out.size // time.size
    for first, moments, sums in _moments(time, columns, t_out, interval, _COEFFICIENTS, (2, 1)):
        values: FloatArray = sums[0] / moments[0]
        shift = moments[1] / moments[0]
        uneven = np.abs(shift) > ROUNDING
        for run in _joined(runs_of(uneven), apart):
            slope = slopes.at(first + run.start, first + run.stop, ends=run.stop < shift.size)
            values[:, run] -= np.where(uneven[run], shift[run], 0.0) * slope
        yield values


def _joined(runs: list[slice], apart: int) -> list[slice]:
    """Runs, where those no further `apart` are joined: each run costs a block of samples."""
    joined: list[slice] = []
    for run in runs:
        if joined and run.start - joined[-1].stop <= apart:
            joined[-1] = slice(joined[-1].start, run.stop)
        else:
            joined.append(run)
    return joined


class _Slopes:
    """Local slopes [per output interval] by weighted least squares, run after run of grid points in ascending order."""

    def __init__(self, time: FloatArray, columns: Sequence[FloatArray], t_out: FloatArray, interval: float) -> None:
        self._segment = (time, columns, interval)
        self._grid = t_out
        self._open: Stream | None = None
        self._next = -1

    def at(self, first: int, last: int, *, ends: bool) -> FloatArray:
        """The slopes at the points `first` … `last` − 1, shape (k, last − first).

        A run that goes on (`ends` is false) is taken up by the next call, so that it makes no difference where it
        was interrupted.
        """
        if self._open is None or first != self._next:
            # The sums at a point do not depend on how far the run goes on: bins beyond it do not reach it.
            self._open = Stream(self._pieces(self._grid[first : last if ends else None]))
        slopes = self._open.read(last - first)
        self._next = last
        if ends:
            self._open = None
        return slopes

    def _pieces(self, points: FloatArray) -> Iterator[FloatArray]:
        time, columns, interval = self._segment
        for _, moments, sums in _moments(time, columns, points, interval, (1.0,), (3, 2)):
            centre = moments[1] / moments[0]
            spread = moments[2] - centre * moments[1]
            flat = spread <= 1e-12 * moments[0]  # a segment of one sample or two stamps almost equal
            yield (sums[1] - centre * sums[0]) / np.where(flat, np.inf, spread)


def _moments(
    time: FloatArray,
    columns: Sequence[FloatArray],
    t_out: FloatArray,
    interval: float,
    coefficients: Sequence[float],
    powers: tuple[int, int],
) -> Iterator[tuple[int, FloatArray, FloatArray]]:
    """Sums of ``w x^p`` and ``w x^p y`` around each grid point, w the kernel times the share of the time axis.

    Yields
    ------
    first : int
        Number of the first grid point of this piece.
    moments : FloatArray, shape (powers[0], m)
    sums : FloatArray, shape (powers[1], k, m)
    """
    origin = float(t_out[0])
    moments = np.zeros((powers[0], 3))
    sums = np.zeros((powers[1], len(columns), 3))
    for bins in _blocks(time, origin, interval, t_out.size):
        # Grid point p counts as number p + 3, so that none is negative; bin b reaches the numbers b … b + 3.
        width = bins.last - bins.first
        moments = np.concatenate((moments, np.zeros((powers[0], width))), axis=1)
        sums = np.concatenate((sums, np.zeros((powers[1], len(columns), width))), axis=2)
        if bins.starts[-1] > 0:
            _add_block(bins, columns, origin, interval, coefficients, moments, sums)
        skip = max(0, 3 - bins.first)
        yield bins.first + skip - 3, moments[:, skip:width], sums[:, :, skip:width]
        moments, sums = moments[:, width:], sums[:, :, width:]


def _add_block(
    bins: "_Bins",
    columns: Sequence[FloatArray],
    origin: float,
    interval: float,
    coefficients: Sequence[float],
    moments: FloatArray,
    sums: FloatArray,
) -> None:
    """Add what the samples of a block of bins contribute to the grid points within reach."""
    sizes = np.diff(bins.starts)
    filled = np.flatnonzero(sizes)
    heads = bins.starts[:-1][filled]
    position = (bins.stamps - origin) / interval - np.repeat(np.arange(bins.first - 2, bins.last - 2), sizes)
    share = bins.shares / interval
    samples = [column[bins.low : bins.low + position.size] for column in columns]
    for shift in range(1 - int(REACH), 1 + int(REACH)):
        x = position - shift
        w = kernel(x, coefficients)
        w *= share
        target = filled + (shift + 1)
        for power in range(max(len(moments), len(sums))):
            if power:
                w *= x
            if power < len(moments):
                moments[power, target] += np.add.reduceat(w, heads)
            if power < len(sums):
                for j, column in enumerate(samples):
                    sums[power, j, target] += np.add.reduceat(w * column, heads)


@dataclass(frozen=True)
class _Bins:
    """Consecutive bins `first` … `last` − 1 of a grid; bin b holds the samples from grid point b − 2 up to b − 1.

    Attributes
    ----------
    low : int
        Row of the first sample.
    starts : IntArray, shape (last − first + 1,)
        Start of each bin, counted from there.
    stamps, shares : FloatArray
        Time stamps [s] of the samples, and their trapezoidal shares of the time axis.
    """

    first: int
    last: int
    low: int
    starts: IntArray
    stamps: FloatArray
    shares: FloatArray


def _blocks(time: FloatArray, origin: float, interval: float, points: int) -> Iterator[_Bins]:
    """All bins within reach of a grid of `points` points, in blocks of about `_BLOCK` samples.

    Where a block ends depends on the samples alone, not on how they are read.
    """
    first = 0
    end = points + 3
    most = _BLOCK
    low = int(np.searchsorted(time, _edges(origin, interval, 0, 1)[0]))
    while first < end:
        before = min(low, 1)
        around = time[low - before : low + most + 1]
        stamps = around[before:]
        whole = low + stamps.size == time.size
        reach = int((stamps[-1] - origin) / interval) + 5 if stamps.size else 0
        last = end if whole and stamps.size <= most else min(end, max(reach, first + 1))
        starts = np.searchsorted(stamps, _edges(origin, interval, first, last + 1))
        held = int(np.searchsorted(starts, most, side="right")) - 1
        if held < 1:  # one bin alone holds more, and is a block of its own
            most *= 2
            continue
        held = held if most == _BLOCK else 1
        starts = starts[: held + 1]
        count = int(starts[-1])
        shares = _shares(around[: before + count + 1], before, count, low + count == time.size)
        yield _Bins(first=first, last=first + held, low=low, starts=starts, stamps=stamps[:count], shares=shares)
        first, low, most = first + held, low + count, _BLOCK


def _edges(origin: float, interval: float, first: int, last: int) -> FloatArray:
    """Starts [s] of the bins `first` … `last` − 1."""
    return np.asarray(origin + interval * np.arange(first - 2, last - 2, dtype=np.float64))


def _shares(around: FloatArray, before: int, count: int, at_end: bool) -> FloatArray:
    """Trapezoidal shares of the time axis of `count` samples, given with the ones `before` and behind them."""
    middles = 0.5 * (around[1:] + around[:-1])
    bounds = np.concatenate((around[:1] if before == 0 else [], middles, around[-1:] if at_end else []))
    return np.diff(bounds)[:count]


def interpolated(time: FloatArray, samples: FloatArray, t_out: FloatArray, *, smooth: bool) -> Iterator[FloatArray]:
    """The same as `interpolate` of columns of any length, piece after piece.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s].
    samples : FloatArray, shape (N,)
        The signal.
    t_out : FloatArray, shape (m,)
        Times that are asked for [s].
    smooth : bool
        By a cubic spline instead of lines.
    """
    for first in range(0, t_out.size, CHUNK):
        points = t_out[first : first + CHUNK]
        low, high = np.searchsorted(time, points[[0, -1]])
        rows = slice(max(low - 3, 0), high + 3)
        yield interpolate(time[rows], samples[rows], points, smooth=smooth)


def interpolate(time: FloatArray, samples: FloatArray, t_out: FloatArray, *, smooth: bool) -> FloatArray:
    """Interpolate one gap-free segment; nothing is averaged, samples are passed through.

    Parameters
    ----------
    time, samples : FloatArray, shape (N,)
        Strictly increasing time stamps [s] and finite samples.
    t_out : FloatArray, shape (M,)
        Any times [s] within ``[time[0], time[-1]]``.
    smooth : bool
        True: cubic Hermite pieces with the slopes of three-point parabolas, error O(h³), for displacements;
        False: straight lines, which cannot overshoot, for voltages.

    Returns
    -------
    FloatArray, shape (M,)
    """
    if not smooth or time.size < 3:
        return np.interp(t_out, time, samples)
    from scipy.interpolate import CubicHermiteSpline

    return np.asarray(CubicHermiteSpline(time, samples, _slopes(time, samples))(t_out))


def _slopes(time: FloatArray, samples: FloatArray) -> FloatArray:
    """Slopes of three-point parabolas, none so steep that it leads far out of its neighbours over the longer step.

    Of two stamps that nearly coincide, the noise between them is a slope without a bound. A slope d overshoots over a
    step h by 4/27 of d h at most. So at 1.5 times the changes beside it, it overshoots by less than a quarter of these.
    On even steps the limit is never reached.
    """
    steps = np.diff(time)
    changes = np.abs(np.diff(samples))
    beside = (changes[1:] + changes[:-1]) / np.maximum(steps[1:], steps[:-1])
    limit = _STEEPEST * np.pad(beside, 1, mode="edge")
    return np.asarray(np.clip(np.gradient(samples, time, edge_order=2), -limit, limit))
