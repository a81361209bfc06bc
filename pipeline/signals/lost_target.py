"""The level that a sensor shows while it has lost its target, told from a place where the device itself stays."""

from collections.abc import Sequence

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.answers import answer_inputs
from pipeline.signals.columns import Signal, chunks
from pipeline.signals.signal_quality import SignalQuality

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
    return None if answer_inputs(times[np.isfinite(times)], inputs, stamps, step) else bound


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
