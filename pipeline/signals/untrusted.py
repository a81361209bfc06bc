"""Samples that are no measurements: at the ends of the sensor's range, while it has lost its target, or single ones
far off. They are masked.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import Signal, chunks, column, finite, select
from .dropouts import NONE, Dropouts, answer_inputs, dropouts
from .noise import REACH, SELDOM, noise_level
from .rails import in_a_row, runs_between
from .signal_quality import (
    BESIDE_SPIKE,
    SignalQuality,
    bridged,
    examine_signal,
    single_spikes,
    spikes_in,
)

_LOST_FOR = 0.05
"""Least mean time [s] that a sensor stays at the level of a lost target."""
_FAR = 0.5
"""Gap between that level and the rest, as a share of the range of the rest."""
_THINNEST = 1e-3
_WIDEST = 0.03
"""Least and largest width of it, as a share of the usual range: what is wider moves, and is measured."""
_MOST = 0.5
"""Share of a log that may be without a target."""
_JUMP = 2
"""Samples that the jumps to it and back may show between the two."""

UNBOUNDED = (-np.inf, np.inf)
_SHORTEST_PULSE = 1e-3
"""Time [s] within which no amplifier goes there and back."""


def without_spikes(signal: Signal, step: float) -> tuple[Signal, int, float]:
    """An input with its single samples far off neighbours that agree on the line between these; how many, and the
    stamp [s] of the first.

    Nothing is changed where a step [s] is longer than 1 ms, where such samples are
    frequent, and in a command without noise: there pulses may be as short. A controller that differentiates kicks for
    one of its periods, and the device follows.
    """
    time, samples = signal
    usable = finite(samples)
    values = select(samples, usable)
    short = step <= 1.01 * _SHORTEST_PULSE
    noise = noise_level(values) if short and values.size else 0.0
    count, first = single_spikes(values, noise)
    if not 0 < count <= SELDOM * values.size:
        return signal, 0, np.nan
    at = float(select(time, usable)[first[0]])
    return (time, bridged(samples, noise)), count, at


def lost_bounds(q: Signal, inputs: Sequence[Signal], quality: SignalQuality, step: float) -> tuple[float, float]:
    """Values beyond which q is a level that the sensor shows without a target; infinite where there is none.

    Such a level is constant except for little noise, lies far outside the rest, and is entered by a jump and kept for
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
    width = min(max(2.0 * REACH * quality.noise, _THINNEST * (largest - smallest)), _WIDEST * (largest - smallest))
    low = _bound(q, inputs, (-smallest - width, -smallest + width), -largest, step, sign=-1.0)
    high = _bound(q, inputs, (largest - width, largest + width), smallest, step)
    return (-np.inf if low is None else -low, np.inf if high is None else high)


def _bound(
    q: Signal, inputs: Sequence[Signal], level: tuple[float, float], smallest: float, step: float, sign: float = 1.0
) -> float | None:
    """The middle of the gap below the level at the top of `sign` times q, if the sensor has lost its target there.

    level: its lower and upper end · smallest: of all · step: of time [s].
    """
    stamps, samples = q
    bound = _gap(samples, level, smallest, step, sign)
    if bound is None:
        return None
    runs = runs_between(samples, bound, np.inf) if sign > 0.0 else runs_between(samples, -np.inf, -bound)
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
    top = np.empty(0)
    jumps = _JUMP * runs
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        top = np.sort(np.concatenate((top, part[part < bottom])))[-jumps - 1 :]
    if top.size <= jumps or bottom - top[0] < _FAR * (top[0] - smallest):
        return None
    return float(0.5 * (bottom + top[0]))


_NEAR = BESIDE_SPIKE


@dataclass(frozen=True)
class Trusted:
    """A signal without what is not to be trusted.

    Attributes
    ----------
    samples : FloatArray, shape (N,)
        NaN where left out.
    left_out : (int, int, int)
        Samples left out at the rails, without a target, and as spikes.
    rails : tuple of (float, float)
        Between which values three samples in a row are a sensor at the end of its range.
    bounds : (float, float)
        Values beyond which the sensor has lost its target.
    quality : SignalQuality
        Of the samples that the sensor and the recorder did not lose; its counts are those of all.
    dropouts : Dropouts
        Bursts and held values, which are left out with those without a target; and places where rows are missing.
    """

    samples: FloatArray
    left_out: tuple[int, int, int]
    rails: tuple[tuple[float, float], ...]
    bounds: tuple[float, float]
    quality: SignalQuality
    dropouts: Dropouts = NONE


def _within(samples: FloatArray, bounds: tuple[float, float]) -> FloatArray:
    """The samples, NaN beyond the bounds."""
    if bounds == UNBOUNDED:
        return samples
    parts = (
        np.where((samples[r] < bounds[0]) | (samples[r] > bounds[1]), np.nan, samples[r]) for r in chunks(samples.size)
    )
    return column(samples.size, parts, np.float64)


def _without(samples: FloatArray, spans: IntArray) -> FloatArray:
    """The samples, NaN in these rows."""
    parts = (np.where(_in_spans(spans, r.start, r.stop - r.start), np.nan, samples[r]) for r in chunks(samples.size))
    return column(samples.size, parts, np.float64)


def _in_spans(spans: IntArray, first: int, count: int) -> BoolArray:
    """Which of `count` rows from `first` on lie in one of the spans."""
    inside = np.zeros(count, dtype=np.bool_)
    for begin, end in spans[(spans[:, 0] < first + count) & (spans[:, 1] > first)].tolist():
        inside[max(begin - first, 0) : end - first] = True
    return inside


def _at_rail(part: FloatArray, rails: Sequence[tuple[float, float]]) -> BoolArray:
    there = np.zeros(part.size, dtype=np.bool_)
    for low, high in rails:
        there |= in_a_row((part >= low) & (part <= high))
    return there


def _spikes(part: FloatArray, noise: float | None) -> BoolArray:
    there = np.zeros(part.size, dtype=np.bool_)
    if noise is not None and part.size > 2:
        there[1:-1] = spikes_in(part, noise)
    return there


def trusted(
    q: Signal,
    inputs: Sequence[Signal],
    quality: SignalQuality,
    step: float,
    *,
    rails: bool,
    lost: bool,
    spikes: bool,
    inert: bool = True,
) -> Trusted:
    """The signal without what is no measurement.

    Parameters
    ----------
    q : (FloatArray, FloatArray)
        Time stamps [s] and samples as measured.
    inputs : sequence of (FloatArray, FloatArray)
        The same of what drives the device; their steps separate a place of the device from a lost target.
    quality : SignalQuality
        Of these samples: the rails and the noise.
    step : float
        Nominal sampling step [s].
    rails, lost, spikes : bool
        What to leave out.
    inert : bool
        Whether the device has inertia, as a circuit need not: then it cannot jump.
    """
    samples = q[1]
    bounds = lost_bounds(q, inputs, quality, step) if lost and not quality.constant else UNBOUNDED
    fallen = dropouts((q[0], _within(samples, bounds)), inputs, quality, step) if lost and inert else NONE
    spans = fallen.spans
    if bounds != UNBOUNDED or spans.size:  # their values do not describe the motion
        left = _without(_within(samples, bounds), spans)
        as_measured = {key: getattr(quality, key) for key in ("n", "not_finite", "lost", "not_finite_at")}
        quality = replace(examine_signal(q[0], left, step), **as_measured)
    at = quality.rails if rails else ()
    noise = quality.roughness if spikes and quality.spikes else None
    if not at and noise is None and bounds == UNBOUNDED and not spans.size:
        return Trusted(samples, (0, 0, 0), at, bounds, quality, fallen)
    counts = np.zeros(3, dtype=np.int64)

    def parts() -> Iterator[FloatArray]:
        """The samples with NaN, chunk by chunk; what is left out is counted beside."""
        for rows in chunks(samples.size):
            first = max(rows.start - _NEAR, 0)
            part = samples[first : rows.stop + _NEAR]
            own = slice(rows.start - first, rows.stop - first)
            missed: BoolArray = (part < bounds[0]) | (part > bounds[1])
            missed |= _in_spans(spans, first, part.size)
            at_rail = _at_rail(part, at) & ~missed
            left_out = np.stack((at_rail, missed, _spikes(part, noise) & ~at_rail & ~missed))[:, own]
            counts[:] += np.count_nonzero(left_out, axis=1)
            yield np.where(left_out.any(axis=0), np.nan, part[own])

    masked = column(samples.size, parts(), np.float64)
    rail, lost_target, spike = counts.tolist()
    return Trusted(masked, (rail, lost_target, spike), at, bounds, quality, fallen)
