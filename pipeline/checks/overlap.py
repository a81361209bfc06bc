"""Whether two logs hold one recording: the motion of q or -q down to its noise, at any offset, rate or rounding."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from pipeline.checks.rows import CheckRow
from pipeline.checks.weak_form import LogSignals
from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, samples_of
from pipeline.numerics.metrics import robust_std
from pipeline.signals.noise import rounding

_WINDOW = 128
"""Least sample intervals of the excerpts that are looked for, longer than a ring-down after one pulse; they are twice
as long, and so on, where the device is too slow to move within them."""
_LEAST_MOVING = 8
_MOST_WINDOWS = 64
_MOVES = 0.2
"""Share of the range of q that an excerpt must run through: logs of one device are alike at rest."""
_ALIKE = 0.2
"""Energy of the difference over that of the excerpt, up to which a place is looked at more closely; half an interval
between two grids makes 0.05."""
_PLACES = 3
_SHARED_NOISE = 0.6
"""Noise of the difference of two logs over that of both: 1 for two recordings, 0.0 to 0.4 for one."""
_WITHIN = 1.5
"""Times the noise of both up to which logs agree, where digits or rates hide whether they share it."""
_FLOOR = 2e-3
"""Share of an excerpt's standard deviation that interpolation may cost. Two runs of a real device differ by more."""
_LEAST = 4
"""Excerpts that a span must last where only the motion shows it: two logs may begin with the same pulse."""
_CLOSE = 0.08
"""Share of an excerpt's standard deviation by which a sixteenth of the grid may be off at the best offset."""
_SAME_RATE = 0.01
_SAME_STEP = 1e-9
_WHITE, _OF_INPUT = 0.2, 0.05
"""Least noise by differences of the eighth order over that by the fourth, and largest share of a measured input."""
_TOGETHER = 0.8
"""Correlation of the noise of an input in two logs from which it is one recording; two of their own have 0.0."""
_STEPS, _RESTING = 4.0, 8
"""Standard deviations of steps beyond which an input moves, and samples whose means are compared."""
_LINE, _RIPPLE = 16.0, 0.2
"""Power of a spectral line of ripple over the median one, and the largest share of such lines in the noise."""
_FEWEST = 32
"""Samples that show whether noise is shared."""
_ORDER, _SMOOTHED = 4, 3
_GAIN = 6.32
"""Standard deviation that these differences make of white noise of 1."""


@dataclass(frozen=True)
class Overlap:
    """What two logs have in common.

    Attributes
    ----------
    here, there : (float, float)
        The span [s] in the clock of the first and of the second log.
    share : float
        Share of the second log that it is.
    mirrored : bool
        Whether q has the other sign in one of them.
    """

    here: tuple[float, float]
    there: tuple[float, float]
    share: float
    mirrored: bool = False

    @property
    def spans(self) -> str:
        """Both spans, that in the second log first."""
        here, there = (f"{start:.4g} to {stop:.4g} s" for start, stop in (self.here, self.there))
        mirrored = ", with q of the other sign" if self.mirrored else ""
        return (f"{there} is {here} of it" if here != there else here) + mirrored


def shared_recordings(logs: Sequence[LogSignals], sample_interval: float) -> list[tuple[int, int, Overlap]]:
    """Every pair of logs that hold one recording, by their places, with what they share."""
    overlaps = (
        (i, k, overlap(logs[i], logs[k], sample_interval) or _by_inputs(logs[i], logs[k], sample_interval))
        for i, k in combinations(range(len(logs)), 2)
    )
    return [(i, k, shared) for i, k, shared in overlaps if shared is not None]


def shared_rows(logs: Sequence[LogSignals], shared: Sequence[tuple[int, int, Overlap]]) -> list[CheckRow]:
    """What to look at where logs of one role share a recording."""
    advice = "what both hold counts twice in fits and scores: leave one of them out, or cut it"
    return [
        CheckRow(logs[k].name, f"shared with {logs[i].name}", each.spans, "none", "note", None, advice)
        for i, k, each in shared
    ]


def overlap(first: LogSignals, second: LogSignals, sample_interval: float) -> Overlap | None:
    """The span in which two logs hold one recording; None where there is none of 128 sample intervals and more.

    Excerpts of the shorter log that move are looked for in the longer one on the grid of the identification. The
    offset is then refined on the finer records, and the difference compared with the noise of both.

    Cost: up to 128 Fourier transforms of the longer log: 0.2 to 2.6 s for two
    logs of 37.5 s at 10 ms, most of it for places where the device moves alike.
    """
    if np.isfinite(second.q).sum() * second.interval > np.isfinite(first.q).sum() * first.interval:
        turned = overlap(second, first, sample_interval)
        share = 0.0 if turned is None else (turned.here[1] - turned.here[0]) / float(np.ptp(second.t))
        return None if turned is None else Overlap(turned.there, turned.here, min(share, 1.0), turned.mirrored)
    for mirrored in (False, True):
        other = replace(second, q=-second.q) if mirrored else second
        for place, offset in _candidates(first, other, sample_interval):
            if (span := _agreement(first, other, place, offset, sample_interval)) is not None:
                begin, end, exact = span
                share = (end - begin) / float(np.ptp(second.t))
                return Overlap((begin + exact, end + exact), (begin, end), min(share, 1.0), mirrored)
    return None


def _by_inputs(first: LogSignals, second: LogSignals, sample_interval: float) -> Overlap | None:
    """What two logs share by the noise of a measured input, where q was filtered since or noise was added to it.

    Logs coarser than the sample interval are not judged: between steps they have too few samples at rest.
    """
    from scipy.ndimage import uniform_filter1d
    from scipy.signal import correlate

    width = samples_of(_WINDOW * sample_interval, first.interval)
    coarse = first.interval > sample_interval * (1.0 + _SAME_STEP)
    if coarse or abs(first.interval / second.interval - 1.0) > _SAME_STEP:
        return None
    if width > min(first.t.size, second.t.size) - _ORDER:
        return None
    for columns in zip(first.v.T, second.v.T, strict=False):
        (here, rests_here), (there, rests_there) = map(_noise_at_rest, columns)
        if not (rests_here.any() and rests_there.any()):
            continue
        shift = int(np.argmax(correlate(here, there, "full", "fft"))) - (there.size - 1)
        begin, end = max(0, -shift), min(there.size, here.size - shift)
        if end - begin < width:
            continue
        ours, theirs = here[begin + shift : end + shift], there[begin:end]
        products = [uniform_filter1d(a * b, width) for a, b in ((ours, theirs), (ours, ours), (theirs, theirs))]
        resting = uniform_filter1d(1.0 * (rests_here[begin + shift : end + shift] & rests_there[begin:end]), width)
        runs = runs_of(
            (resting > 0.5) & (products[0] > _TOGETHER * np.sqrt(np.maximum(products[1] * products[2], 0.0)))
        )
        longest = max(runs, key=lambda rows: rows.stop - rows.start, default=slice(0, 0))
        if longest.stop - longest.start >= width:
            rows = np.array([begin + longest.start, begin + longest.stop - 1])
            times = second.t[rows]
            share = float(np.ptp(times) / np.ptp(second.t))
            starts = first.t[rows + shift]
            return Overlap((float(starts[0]), float(starts[1])), (float(times[0]), float(times[1])), share)
    return None


def _noise_at_rest(v: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Differences of an input in which its noise outweighs the rest, zero where the input moves, and where it rests.

    It rests nowhere where it shows no noise of a measurement: a command has none, some inputs are noises themselves,
    and ripple of an amplifier is alike in all logs of a rig.
    """
    from scipy.fft import rfft
    from scipy.ndimage import maximum_filter1d, uniform_filter1d

    noise, higher = (
        robust_std(np.diff(v, order)) / math.sqrt(math.comb(2 * order, order)) for order in (_ORDER, 2 * _ORDER)
    )
    differences = np.diff(v, _ORDER)
    steps = np.diff(uniform_filter1d(v, _RESTING), prepend=v[0])
    moves = maximum_filter1d(np.abs(steps) > _STEPS * robust_std(steps), 2 * _RESTING + 1)
    rests = ~moves[_ORDER // 2 : _ORDER // 2 + differences.size]
    alone = np.where(rests, differences, 0.0)
    lines = np.abs(rfft(alone)) ** 2
    fast = np.arange(lines.size // 4, lines.size)  # where noise outweighs what is left of the sequence
    lines = lines[fast] / np.sin(math.pi * fast / alone.size) ** (2 * _ORDER)
    ripple = float(np.sum(lines[lines > _LINE * np.median(lines)]))
    is_noise = higher > _WHITE * noise  # of a smooth command, higher differences are far smaller
    if not (is_noise and 0.0 < noise < _OF_INPUT * float(np.std(v)) and ripple < _RIPPLE * float(np.sum(lines))):
        rests = np.zeros_like(rests)
    return alone, rests


def _candidates(
    first: LogSignals, second: LogSignals, sample_interval: float
) -> Iterator[tuple[tuple[float, float], float]]:
    """Excerpts of the second log [s], each with an offset [s] at which the first one looks alike."""
    t, whole = _coarse(first, sample_interval)
    stamps, short = _coarse(second, sample_interval)
    begins, window = _moving(short)
    if not begins.size:
        return
    filled = np.interp(t, t[np.isfinite(whole)], whole[np.isfinite(whole)])
    filled = filled - filled.mean()
    size = 1 << int(filled.size + window).bit_length()
    spectrum = np.fft.rfft(filled, size)
    sums = [np.concatenate(([0.0], np.cumsum(filled**k))) for k in (1, 2)]
    total, squares = (each[window:] - each[:-window] for each in sums)
    energy = squares - total**2 / window
    for begin in begins.tolist():
        part = short[begin : begin + window] - short[begin : begin + window].mean()
        along = np.fft.irfft(spectrum * np.conj(np.fft.rfft(part, size)), size)[: energy.size]
        apart = (energy + part @ part - 2.0 * along) / (part @ part)
        for _ in range(_PLACES):
            best = int(np.argmin(apart))
            if apart[best] > _ALIKE:
                break
            yield (float(stamps[begin]), float(stamps[begin + window - 1])), float(t[best] - stamps[begin])
            apart[max(0, best - 2) : best + 3] = np.inf


def _coarse(log: LogSignals, sample_interval: float) -> tuple[FloatArray, FloatArray]:
    step = samples_of(sample_interval, log.interval)
    return log.t[::step], log.q[::step]


def _moving(q: FloatArray) -> tuple[IntArray, int]:
    """First rows of the excerpts that move and are measured throughout, at most `_MOST_WINDOWS` evenly spread, and how
    many rows they have.
    """
    least, window = _MOVES * (np.nanmax(q) - np.nanmin(q)), _WINDOW
    while True:
        starts = np.arange(0, q.size - window + 1, window // 2)
        spans = np.array([np.ptp(q[i : i + window]) for i in starts])  # NaN where masked
        usable: IntArray = starts[spans > least] if starts.size else starts
        if usable.size >= _LEAST_MOVING or 4 * window > q.size:
            spread = np.linspace(0, usable.size - 1, min(usable.size, _MOST_WINDOWS)).astype(np.int64)
            return usable[np.unique(spread)], window
        window *= 2


def _agreement(
    first: LogSignals, second: LogSignals, place: tuple[float, float], offset: float, sample_interval: float
) -> tuple[float, float, float] | None:
    """Begin and end [s] of the span around an excerpt in which the logs agree, and the exact offset [s]."""
    from scipy.optimize import minimize_scalar

    grid = _grid(first, second)
    t = grid[(grid >= place[0]) & (grid <= place[1])]

    def apart(shift: float) -> float:
        """Standard deviation of the difference at an offset."""
        return float(np.nanstd(_difference(first, second, t, shift)))

    shifts, few = offset + np.linspace(-1.0, 1.0, 17) * sample_interval, t[:: max(1, t.size // _WINDOW)]
    tried = np.nanstd(_difference(first, second, few, shifts[:, None]), axis=1)
    best, reach = float(shifts[int(np.nanargmin(tried))]), 0.125 * sample_interval
    if not np.min(tried) <= _CLOSE * float(np.nanstd(_interpolated(second, few))):
        return None
    exact = float(
        minimize_scalar(apart, bounds=(best - reach, best + reach), options={"xatol": 1e-6 * sample_interval}).x
    )
    exact = min((exact, *_whole_steps(exact, first, second)), key=apart)
    limit, surely = _limit(first, second, t, exact)
    if not apart(exact) <= limit:
        return None
    difference = _difference(first, second, grid, exact)
    inside = grid[~np.isnan(difference)]
    if not inside.size:
        return None
    near = _agreeing(difference, limit, max(1, round(0.25 * (place[1] - place[0]) / (grid[1] - grid[0]))))
    row = int(np.searchsorted(grid, 0.5 * (place[0] + place[1])))
    run = next((rows for rows in runs_of(near) if rows.start <= row < rows.stop), None)
    if run is None:
        return None
    begin, end = max(float(grid[run.start]), float(inside[0])), min(float(grid[run.stop - 1]), float(inside[-1]))
    return (begin, end, exact) if surely or end - begin > _LEAST * (place[1] - place[0]) else None


def _whole_steps(offset: float, first: LogSignals, second: LogSignals) -> tuple[float, ...]:
    """The offset at which both grids coincide that is next to this one [s]."""
    step, phase = first.interval, float(first.t[0] - second.t[0])
    return (phase + step * round((offset - phase) / step),)


def _grid(first: LogSignals, second: LogSignals) -> FloatArray:
    """The stamps of the second log at which both are compared: those of the coarser record."""
    return second.t[:: max(1, round(first.interval / second.interval))]


def _difference(first: LogSignals, second: LogSignals, t: FloatArray, offset: FloatArray | float) -> FloatArray:
    """First less second log at stamps of the second [s], in a row for each offset of a column; NaN where one is not
    measured.
    """
    step = round((t[1] - t[0]) / second.interval) if t.size > 1 else 1
    row = round((t[0] - second.t[0]) / second.interval)
    return _interpolated(first, t + offset) - second.q[row : row + step * t.size : step][: t.size]


def _interpolated(log: LogSignals, t: FloatArray) -> FloatArray:
    """Cubic interpolation through the four samples around each time [s]; NaN where one of them is none."""
    place = (t - log.t[0]) / log.interval
    row = np.floor(place + 1e-6).astype(np.int64)
    x, inside = place - row, (row >= 1) & (row < log.q.size - 2)
    row = np.where(inside, row, 1)
    a, b, c, d = (log.q[np.minimum(row + k, log.q.size - 1)] for k in (-1, 0, 1, 2))
    value = b + 0.5 * x * (c - a + x * (2.0 * a - 5.0 * b + 4.0 * c - d + x * (3.0 * (b - c) + d - a)))
    result: FloatArray = np.where(inside, np.where(np.abs(x) < 1e-5, b, value), np.nan)
    return result


def _limit(first: LogSignals, second: LogSignals, t: FloatArray, offset: float) -> tuple[float, bool]:
    """The standard deviation [m or rad] of the difference up to which both hold one recording, 0 where they share no
    noise though they would; and whether they do share it.
    """
    own = _interpolated(first, t + offset)
    other, size = own - _difference(first, second, t, offset), float(np.nanstd(own))
    steps = [rounding(log.resolution) for log in (first, second)]
    noises = [max(log.noise or 0.0, step) for log, step in zip((first, second), steps, strict=True)]
    within = float(math.hypot(math.hypot(*noises) * _WITHIN, _FLOOR * size))
    hidden, alike = max(steps) > 0.5 * min(noises), math.isclose(*steps, rel_tol=_SAME_RATE)
    if abs(first.raw_step / second.raw_step - 1.0) > _SAME_RATE or (hidden and not alike):
        return within, False
    details = np.array([_detail(q) for q in (own, other, own - other)])
    if hidden:  # at rest they are equal anyway, while what moves is rounded up or down by chance
        details = details[:, np.abs(np.diff(own))[: details.shape[1]] > (first.resolution or 0.0)]
    usable = details[:, np.isfinite(details).all(axis=0)]
    if usable.shape[1] < _FEWEST:
        return 0.0, False
    rough = [min(robust_std(detail), _GAIN * noise) for detail, noise in zip(usable, noises, strict=False)]
    shared = robust_std(usable[2]) <= _SHARED_NOISE * math.hypot(*rough)
    return (within if shared else 0.0), shared and not hidden


def _detail(q: FloatArray) -> FloatArray:
    """Fourth differences of running means, in which noise outweighs the motion."""
    differences = np.diff(q, _ORDER)
    for _ in range(_SMOOTHED):
        differences = differences[1:] + differences[:-1]
    detail: FloatArray = differences
    return detail


def _agreeing(difference: FloatArray, limit: float, width: int) -> BoolArray:
    """Rows around which the difference, but for a constant, stays within three times the limit or is not known."""
    from scipy.ndimage import uniform_filter1d

    measured = ~np.isnan(difference)
    square = np.where(measured, difference - np.median(difference[measured]), 0.0) ** 2
    weight = uniform_filter1d(measured.astype(np.float64), width)
    near: BoolArray = (uniform_filter1d(square, width) <= (3.0 * limit) ** 2 * weight) | (weight < 1e-9)
    return near
