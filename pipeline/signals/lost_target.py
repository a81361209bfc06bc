"""The level that a sensor shows while it has lost its target, told from a place where the device itself stays."""

from collections.abc import Iterator, Sequence

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.columns import Signal, chunks
from pipeline.signals.signal_quality import SignalQuality, span

_LOST_FOR = 0.05
"""Time [s] that a sensor stays at the level which says that it lost its target, on average at least."""
_FAR = 0.5
"""Gap between that level and the rest, as a share of the range of the rest."""
_NOISES = 12.0
"""Width of that level in standard deviations of the noise."""
_THINNEST, _WIDEST = 1e-3, 0.03
"""Least and largest width of it, as a share of the usual range: what is wider moves, and is measured."""
_MOST = 0.5
"""Share of a log that may be without a target."""
_JUMP = 2
"""Samples that the jumps to it and back may show between the two."""
_STEP = 0.1
"""Change of an input from one sample to the next that is a step, as a share of its range."""
_ANSWER = 5, 0.03
"""Samples, and time [s], the longer of which a device that jumps takes to answer a step of an input."""
_TOGETHER = 0.75
"""Share of the jumps to a level and back that go with steps of an input where the device makes them."""
_BY_CHANCE = 0.01
"""Probability below which it is no chance that so many do."""

UNBOUNDED = (-np.inf, np.inf)


def lost_bounds(q: Signal, inputs: Sequence[Signal], quality: SignalQuality, step: float) -> tuple[float, float]:
    """Values beyond which q is a level that the sensor shows without a target; infinite where there is none.

    Such a level is constant but for little noise, lies far outside the rest, and is entered by a jump and kept for
    50 ms or more. A device that moves passes through the values between; here hardly a sample has one. Nor does a
    sensor know the inputs: a level that is entered and left together with their steps is one of the device.

    Parameters
    ----------
    q : (FloatArray, FloatArray)
        Time stamps [s] and displacement as measured.
    inputs : sequence of (FloatArray, FloatArray)
        Time stamps [s] and samples of the inputs.
    quality : SignalQuality
        Of these samples of q.
    step : float
        Nominal sampling step [s] of q.

    Notes
    -----
    Cost: two passes over q, and where there is such a level two more and two over the inputs, in chunks; the memory is
    that of a chunk and of the places where the level is entered and left.
    """
    smallest, largest = quality.usual
    width = min(max(_NOISES * quality.noise, _THINNEST * (largest - smallest)), _WIDEST * (largest - smallest))
    low = _bound(q, inputs, (-smallest - width, -smallest + width), -largest, step, sign=-1.0)
    high = _bound(q, inputs, (largest - width, largest + width), smallest, step)
    return (-np.inf if low is None else -low, np.inf if high is None else high)


def _bound(
    q: Signal,
    inputs: Sequence[Signal],
    level: tuple[float, float],
    smallest: float,
    step: float,
    sign: float = 1.0,
) -> float | None:
    """The middle of the gap below the level at the top of `sign` times q, if the sensor has lost its target there.

    level: its lower and upper end · smallest: of all · step: of time [s].
    """
    stamps, samples = q
    bound = _gap(samples, level, smallest, step, sign)
    if bound is None:
        return None
    runs = _runs_beyond(samples, bound, sign)
    if np.diff(runs).sum() >= _MOST * samples.size:
        return None
    ends = np.unique(runs)
    times = stamps[ends[(ends > 0) & (ends < samples.size)]]
    return None if _goes_with(times[np.isfinite(times)], inputs, step, step * samples.size) else bound


def _gap(samples: FloatArray, level: tuple[float, float], smallest: float, step: float, sign: float) -> float | None:
    """The middle of the gap below `level`, if that is entered by jumps, kept, and far from the rest of sign times q."""
    (bottom, ceiling), at_level, runs, before = level, 0, 0, False
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        there = part >= bottom
        runs += int(np.count_nonzero(np.diff(there.astype(np.int8), prepend=np.int8(before)) == 1))
        at_level += int(np.count_nonzero(there & (part <= ceiling)))
        before = bool(there[-1])
    if not 3 * runs <= at_level < _MOST * samples.size or at_level * step < _LOST_FOR * runs:
        return None
    top, jumps = np.empty(0), _JUMP * runs
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        top = np.sort(np.concatenate((top, part[part < bottom])))[-jumps - 1 :]
    if top.size <= jumps or bottom - top[0] < _FAR * (top[0] - smallest):
        return None
    return float(0.5 * (bottom + top[0]))


def _runs_beyond(samples: FloatArray, bound: float, sign: float) -> IntArray:
    """First and end index of each run of `sign` times the samples above the bound, shape (n, 2)."""
    edges, before = [np.empty(0, dtype=np.int64)], False
    for rows in chunks(samples.size):
        beyond = sign * samples[rows] > bound
        edges.append(rows.start + np.flatnonzero(np.diff(beyond, prepend=before)))
        before = bool(beyond[-1])
    edges.append(np.full(int(before), samples.size))
    return np.concatenate(edges).reshape(-1, 2)


def _goes_with(times: FloatArray, inputs: Sequence[Signal], step: float, duration: float) -> bool:
    """Whether jumps at these times [s] answer steps of the inputs, more of them than by chance.

    step: of time [s] · duration: of the log [s].
    """
    from scipy.special import bdtrc

    earliest, latest = -max(_ANSWER[0] * step, _ANSWER[1]), step
    answers, covered = np.zeros(times.size, dtype=np.bool_), 0.0
    for signal in inputs:
        last = -np.inf
        for steps in _steps(signal):
            answers |= np.searchsorted(steps, times + latest, side="right") > np.searchsorted(steps, times + earliest)
            covered += float(np.minimum(np.diff(steps, prepend=last), latest - earliest).sum())
            last = float(steps[-1])
    count, chance = int(np.count_nonzero(answers)), min(covered / duration, 1.0)
    if not count or count < _TOGETHER * times.size:
        return False
    return bool(bdtrc(count - 1, times.size, chance) < _BY_CHANCE)


def _steps(signal: Signal) -> Iterator[FloatArray]:
    """The times [s] at which an input steps, chunk by chunk, without the chunks in which it does not."""
    time, samples = signal
    smallest, largest = span(samples)
    for rows in chunks(samples.size if largest > smallest else 0, overlap=1):
        with np.errstate(invalid="ignore"):
            found = np.abs(np.diff(samples[rows])) >= _STEP * (largest - smallest)
        steps = time[rows][1:][found]
        steps = np.sort(steps[np.isfinite(steps)])
        if steps.size:
            yield steps
