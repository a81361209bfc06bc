"""Samples that are no measurements. They are masked.

A device with inertia does not jump: it passes through the values between, and its velocity changes over many samples.
So a jump shows a fault of the sensor or of the recorder. It is a burst at one level, a held value, lost rows, or the
level of a sensor without a target. But a jump that answers a step of an input is one of the device.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import BLOCK, Signal, chunks, column, finite, select
from .noise import CHANCE, REACH, SELDOM, noise_level
from .signal_quality import (
    BESIDE_SPIKE,
    IN_A_ROW,
    OF_BESIDE,
    SignalQuality,
    bridged,
    examine_signal,
    in_a_row,
    runs_between,
    single_spikes,
    spikes_in,
)
from .timebase import GAP_FLOOR, GAP_STEPS, ONE_LOST

_ANSWER = 0.03
"""Time [s] that a device which jumps takes to answer."""
_LEAST = 0.01
_MUCH = 0.03
"""Shares of the usual range: a jump exceeds the first, and the second where rows are missing, as encoders and
potentiometers slip by 2 %. Between them lies the width of the level of a lost target: what is wider moves.
"""
_LONGEST = 0.25
"""Duration [s] of the longest burst; what is longer and far outside is a lost target, what is not may be a place."""
_NO_ROWS = np.empty((0, 2), dtype=np.int64)


def answer_inputs(times: FloatArray, inputs: Sequence[Signal], stamps: FloatArray, step: float) -> bool:
    """True if some input has changed just before these times more often than by chance.

    Parameters
    ----------
    times : FloatArray, shape (n,)
        Times of the signal's jumps [s].
    inputs : sequence of (FloatArray, FloatArray)
        Time stamps [s] and samples of the device's inputs.
    stamps : FloatArray, shape (N,)
        Those of the signal [s], by which chance is judged.
    step : float
        Nominal sampling step of the signal [s].
    """
    from scipy.special import bdtrc

    anywhere = stamps[:: max(1, stamps.size // BLOCK)]
    for time, samples in inputs:
        signal = Signal(time, samples)
        least = 2.0 * REACH * noise_level(select(samples, finite(samples)))
        count = int(np.count_nonzero(_changed(signal, times, step, least)))
        if count and bdtrc(count - 1, times.size, float(np.mean(_changed(signal, anywhere, step, least)))) < CHANCE:
            return True
    return False


def _changed(signal: Signal, times: FloatArray, step: float, least: float) -> BoolArray:
    """Mask of the times [s] at which an input differs by more than `least` from its value shortly before."""
    before = np.searchsorted(signal.time, times - max(GAP_STEPS * step, _ANSWER))
    now = np.searchsorted(signal.time, times + step)
    last = signal.samples.size - 1
    changes = signal.samples[np.minimum(now, last)] - signal.samples[np.minimum(before, last)]
    return np.asarray(np.abs(changes) > least)


@dataclass(frozen=True)
class Dropouts:
    """Samples of a signal within its range that are no measurement.

    Attributes
    ----------
    bursts, held : IntArray, shape (n, 2)
        First row and end of each burst at a level, and of each segment in which the last value was held.
    levels : tuple of float
        Levels of the bursts, the most frequent first, in the unit of the signal.
    cuts : FloatArray, shape (m, 2)
        Last stamp before, and first stamp behind [s], each jump that is left: rows are missing though time goes on.
    first : (float, float)
        Stamps [s] of the first burst and of the first held value; NaN without any.
    """

    bursts: IntArray
    held: IntArray
    levels: tuple[float, ...]
    cuts: FloatArray
    first: tuple[float, float]

    @property
    def spans(self) -> IntArray:
        """Rows of bursts and held values, in order."""
        both: IntArray = np.concatenate((self.bursts, self.held))
        return both[np.argsort(both[:, 0])]


NONE = Dropouts(bursts=_NO_ROWS, held=_NO_ROWS, levels=(), cuts=np.empty((0, 2)), first=(np.nan, np.nan))


def dropouts(q: Signal, inputs: Sequence[Signal], quality: SignalQuality, step: float) -> Dropouts:
    """Find what cannot be a motion; nothing where the jumps go with steps of the inputs, or the signal is a command.

    Parameters
    ----------
    q : (FloatArray, FloatArray)
        Time stamps [s] and samples.
    inputs : sequence of (FloatArray, FloatArray)
        The same of what drives the device.
    quality : SignalQuality
        Of these samples.
    step : float
        Nominal sampling step [s].

    Notes
    -----
    Cost: one pass in chunks, memory for the places of jumps.
    """
    stamps, samples = q
    if quality.constant or quality.stepped or quality.idle:
        return NONE
    usual = quality.usual[1] - quality.usual[0]
    jumps = _jumps(samples, max(2.0 * REACH * quality.noise, _LEAST * usual))
    jumps = jumps[stamps[jumps + 1] - stamps[jumps] < ONE_LOST * step]
    if not 0 < jumps.size <= SELDOM * samples.size:
        return NONE
    times = stamps[jumps + 1]
    if answer_inputs(times[np.isfinite(times)], inputs, stamps, step):
        return NONE
    longest = round(_LONGEST / step) + 1
    bursts = _bursts(samples, jumps, longest, 2.0 * REACH * quality.noise)
    left = jumps[~np.isin(jumps, bursts.ravel() - 1)]
    held = _held(samples, left, longest)
    left = left[~np.isin(left, held[:, 1] - 1)]
    left = left[np.abs(samples[left + 1] - samples[left]) > _MUCH * usual]
    ends = np.stack((stamps[left], stamps[left + 1]), axis=1)
    levels, counts = np.unique([np.median(samples[first:end]) for first, end in bursts], return_counts=True)
    return Dropouts(
        bursts=bursts,
        held=held,
        levels=tuple(levels[np.argsort(-counts, kind="stable")].tolist()),
        cuts=ends[np.isfinite(ends).all(axis=1)],
        first=(_stamp_of_first(stamps, bursts), _stamp_of_first(stamps, held)),
    )


def _stamp_of_first(stamps: FloatArray, spans: IntArray) -> float:
    return float(stamps[spans[0, 0]]) if spans.size else np.nan


def _jumps(samples: FloatArray, least: float) -> IntArray:
    """Rows before a step larger than `least` and several times those beside it."""
    rows_before = []
    for rows in chunks(samples.size):
        begin = max(rows.start - 1, 0)
        steps = np.abs(np.diff(samples[begin : rows.stop + 2]))
        jumps = (steps[1:-1] > least) & (steps[1:-1] >= OF_BESIDE * np.maximum(steps[:-2], steps[2:]))
        rows_before.append(begin + 1 + np.flatnonzero(jumps))
    return np.concatenate([np.empty(0, dtype=np.int64), *rows_before])


def _bursts(samples: FloatArray, jumps: IntArray, longest: int, flat: float) -> IntArray:
    """Rows between a jump to a level and one back; `flat` is the largest change by noise there."""
    bursts = []
    last = -1
    for before, end in zip(jumps[:-1].tolist(), jumps[1:].tolist(), strict=True):
        there_and_back = (samples[before + 1] - samples[before]) * (samples[end + 1] - samples[end]) < 0.0
        short = before > last and 2 <= end - before <= longest
        if short and there_and_back and np.ptp(samples[before + 1 : end + 1]) <= flat:
            bursts.append((before + 1, end + 1))
            last = end
    return np.array(bursts, dtype=np.int64).reshape(-1, 2)


def _held(samples: FloatArray, jumps: IntArray, longest: int) -> IntArray:
    """Rows of a value that was held up to a jump, without the first of them, which was measured."""
    spans = []
    for end in jumps.tolist():
        before = samples[max(0, end - longest) : end]
        other = np.flatnonzero(before != samples[end])
        count = before.size - (int(other[-1]) + 1 if other.size else 0)
        free = before[: before.size - count]
        equal = float(np.mean(np.diff(free) == 0.0)) if free.size > 1 else 0.0
        if count + 1 >= IN_A_ROW and samples.size * equal**count < CHANCE:
            spans.append((end - count + 1, end + 1))
    return np.array(spans, dtype=np.int64).reshape(-1, 2)


def without_spikes(signal: Signal, step: float) -> tuple[Signal, int, float]:
    """An input with its single samples far off neighbours that agree on the line between these; how many, and the
    stamp [s] of the first.

    Nothing is changed where a step [s] is longer than an amplifier needs to go there and back, or where such samples
    are frequent. Nor is a command without noise, whose pulses may be as short. A controller that differentiates kicks
    for one of its periods, and the device follows.
    """
    time, samples = signal
    usable = finite(samples)
    values = select(samples, usable)
    noise = noise_level(values) if step < ONE_LOST * GAP_FLOOR and values.size else 0.0
    count, first = single_spikes(values, noise)
    if not 0 < count <= SELDOM * values.size:
        return signal, 0, np.nan
    return Signal(time, bridged(samples, noise)), count, float(select(time, usable)[first[0]])


def lost_bounds(q: Signal, inputs: Sequence[Signal], quality: SignalQuality, step: float) -> tuple[float, float]:
    """Values beyond which q is a level that the sensor shows without a target; infinite where there is none.

    Such a level is constant except for little noise, lies farther outside than half the range of the rest, and is kept
    for less than half of the log. A device that moves passes through the values between; here hardly a sample has one.
    Nor does a sensor know the inputs: a level that is entered and left with their steps is one of the device.

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
    Cost: two passes over q, and two more where there is such a level, in chunks. The memory is that of a chunk and of
    the places where the level is entered and left.
    """
    stamps, samples = q
    smallest, largest = quality.usual
    span = largest - smallest
    width = min(max(2.0 * REACH * quality.noise, _LEAST * span), _MUCH * span)
    ends = []
    for sign, bottom, other in ((-1.0, -smallest - width, -largest), (1.0, largest - width, smallest)):
        bound = _gap(samples, (bottom, bottom + 2.0 * width), other, sign)
        if bound < np.inf:
            runs = runs_between(samples, bound, np.inf) if sign > 0.0 else runs_between(samples, -np.inf, -bound)
            edges = np.unique(runs)
            times = stamps[edges[(edges > 0) & (edges < samples.size)]]
            most = 2 * np.diff(runs).sum() >= samples.size
            bound = np.inf if most or answer_inputs(times[np.isfinite(times)], inputs, stamps, step) else bound
        ends.append(sign * bound)
    return ends[0], ends[1]


def _gap(samples: FloatArray, level: tuple[float, float], smallest: float, sign: float) -> float:
    """The middle of the gap below `level`, if that is entered by jumps, kept, and far from the rest of sign times q;
    infinite where it is not.
    """
    bottom, ceiling = level
    at_level = 0
    runs = 0
    before = False
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        there = part >= bottom
        runs += int(np.count_nonzero(np.diff(there.astype(np.int8), prepend=np.int8(before)) == 1))
        at_level += int(np.count_nonzero(there & (part <= ceiling)))
        before = bool(there[-1])
    if not IN_A_ROW * runs <= at_level < 0.5 * samples.size:
        return np.inf
    top = np.empty(0)
    jumps = 2 * runs  # one sample of each jump may lie between
    for rows in chunks(samples.size):
        part = sign * samples[rows]
        top = np.concatenate((top, part[part < bottom]))
        if top.size > jumps:
            top = np.partition(top, -jumps - 1)[-jumps - 1 :]
    apart = top.size > jumps and bottom - top[0] >= 0.5 * (top[0] - smallest)
    return float(0.5 * (bottom + top[0])) if apart else np.inf


class LeftOut(NamedTuple):
    """Numbers of samples at the rails, without a target, and of spikes."""

    rails: int
    lost: int
    spikes: int


@dataclass(frozen=True)
class Trusted:
    """A signal without what is not to be trusted.

    Attributes
    ----------
    samples : FloatArray, shape (N,)
        NaN where left out.
    left_out : LeftOut
        What they are.
    quality : SignalQuality
        Of the samples that the sensor and the recorder did not lose; its counts are those of all.
    dropouts : Dropouts
        Bursts and held values, which are left out with those without a target; and places where rows are missing.
    """

    samples: FloatArray
    left_out: LeftOut
    quality: SignalQuality
    dropouts: Dropouts


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
        Settings of the masks.
    inert : bool
        True if the device has inertia, as a circuit need not: then it cannot jump.
    """
    time, samples = q
    bounds = lost_bounds(q, inputs, quality, step) if lost and not quality.constant else (-np.inf, np.inf)
    measured = _within(samples, bounds)
    dropouts_of_q = dropouts(Signal(time, measured), inputs, quality, step) if lost and inert else NONE
    measured = _without(measured, dropouts_of_q.spans)
    if measured is not samples:  # their values do not describe the motion
        as_measured = {key: getattr(quality, key) for key in ("n", "not_finite", "lost", "not_finite_at")}
        quality = replace(examine_signal(time, measured, step), **as_measured)
    at = quality.rails if rails else ()
    noise = quality.noise if spikes and quality.spikes else 0.0
    counts = np.zeros(3, dtype=np.int64)

    def parts() -> Iterator[FloatArray]:
        """The samples with NaN, chunk by chunk; what is left out is counted beside."""
        for rows in chunks(samples.size):
            first = max(rows.start - BESIDE_SPIKE, 0)
            part = measured[first : rows.stop + BESIDE_SPIKE]
            own = slice(rows.start - first, rows.stop - first)
            at_rail = np.zeros(part.size, dtype=np.bool_)
            for low, high in at:
                at_rail |= in_a_row((part >= low) & (part <= high))
            spiked = np.pad(spikes_in(part, noise), 1) & ~at_rail if noise and part.size > 2 else np.zeros_like(at_rail)
            missed = np.isnan(part[own]) & ~np.isnan(samples[rows])
            counts[:] += [np.count_nonzero(each) for each in (at_rail[own], missed, spiked[own])]
            yield np.where((at_rail | spiked)[own], np.nan, part[own])

    masked = column(samples.size, parts(), np.float64) if at or noise or measured is not samples else samples
    return Trusted(
        samples=masked,
        left_out=LeftOut(*counts.tolist()),
        quality=quality,
        dropouts=dropouts_of_q,
    )


def _within(samples: FloatArray, bounds: tuple[float, float]) -> FloatArray:
    """The samples, NaN beyond the bounds."""
    parts = (
        np.where((samples[r] < bounds[0]) | (samples[r] > bounds[1]), np.nan, samples[r]) for r in chunks(samples.size)
    )
    return samples if bounds == (-np.inf, np.inf) else column(samples.size, parts, np.float64)


def _without(samples: FloatArray, spans: IntArray) -> FloatArray:
    """The samples, NaN in these rows."""
    if not spans.size:
        return samples

    def parts() -> Iterator[FloatArray]:
        """Chunk by chunk."""
        for rows in chunks(samples.size):
            part = np.array(samples[rows])
            for begin, end in spans[(spans[:, 0] < rows.stop) & (spans[:, 1] > rows.start)].tolist():
                part[max(begin - rows.start, 0) : end - rows.start] = np.nan
            yield part

    return column(samples.size, parts(), np.float64)
