"""Samples that are no measurement though they lie within the range: bursts at one level, values held, rows lost.

A device with inertia passes through the values between. It cannot jump from one sample to the next.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import BLOCK, Signal, chunks
from .noise import CHANCE, REACH, SELDOM
from .rails import IN_A_ROW
from .signal_quality import OF_BESIDE, SignalQuality, span
from .timebase import ONE_LOST

_OF_INPUT = 0.05
_ANSWER = 0.03
"""Share of the range of an input that its change exceeds, and time [s] that a device which jumps takes to answer."""
_TOGETHER = 0.75
_BY_CHANCE = 0.01
"""Share of the jumps that answer an input where the device makes them, and the probability below which that is no
chance: a single jump may show it."""


def answer_inputs(times: FloatArray, inputs: Sequence[Signal], stamps: FloatArray, step: float) -> bool:
    """Whether an input has changed just before most of these times [s], more of them than by chance.

    Parameters
    ----------
    times : FloatArray
        When the signal jumps [s].
    inputs : sequence of (FloatArray, FloatArray)
        Time stamps [s] and samples of what drives the device.
    stamps : FloatArray
        Those of the signal [s], by which chance is judged.
    step : float
        Nominal sampling step of the signal [s].
    """
    from scipy.special import bdtrc

    anywhere = stamps[:: max(1, stamps.size // BLOCK)]
    answers = np.zeros(times.size, dtype=np.bool_)
    chance = np.zeros(anywhere.size, dtype=np.bool_)
    for signal in inputs:
        answers |= _changed(signal, times, step)
        chance |= _changed(signal, anywhere, step)
    count = int(np.count_nonzero(answers))
    likely = count > 0 and count >= _TOGETHER * times.size
    return likely and bool(bdtrc(count - 1, times.size, float(np.mean(chance))) < _BY_CHANCE)


def _changed(signal: Signal, times: FloatArray, step: float) -> BoolArray:
    """Whether an input differs at these times [s] from what it was shortly before."""
    smallest, largest = span(signal[1])
    before = np.searchsorted(signal[0], times - max(5.0 * step, _ANSWER))
    now = np.searchsorted(signal[0], times + step)
    last = signal[1].size - 1
    change = np.abs(signal[1][np.minimum(now, last)] - signal[1][np.minimum(before, last)])
    changed: BoolArray = change > _OF_INPUT * (largest - smallest)
    return changed


_LEAST = 0.01
_LOST = 0.03
"""Share of the usual range that a jump exceeds, and where rows are missing: encoders and potentiometers slip by 2 %."""
_LONGEST = 0.25
"""Duration [s] of the longest burst; what is longer and far outside is a lost target, what is not may be a place."""


@dataclass(frozen=True)
class Dropouts:
    """What of a signal is no measurement.

    Attributes
    ----------
    bursts, held : IntArray, shape (n, 2)
        First row and end of each burst at a level, and of each stretch in which the last value was held.
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


_NO_ROWS = np.empty((0, 2), dtype=np.int64)
NONE = Dropouts(_NO_ROWS, _NO_ROWS, (), np.empty((0, 2)), (np.nan, np.nan))


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
    Cost: one pass in chunks, memory for the places of jumps; one more pass where bursts share a level.
    """
    stamps, samples = q
    if quality.constant or quality.stepped or quality.idle:
        return NONE
    usual = quality.usual[1] - quality.usual[0]
    jumps = _jumps(samples, max(2.0 * REACH * quality.roughness, _LEAST * usual))
    jumps = jumps[stamps[jumps + 1] - stamps[jumps] < ONE_LOST * step]
    if not 0 < jumps.size <= SELDOM * samples.size:
        return NONE
    times = stamps[jumps + 1]
    if answer_inputs(times[np.isfinite(times)], inputs, stamps, step):
        return NONE
    bursts, levels = _bursts(samples, jumps, round(_LONGEST / step) + 1, REACH * quality.roughness)
    left = jumps[~np.isin(jumps, bursts.ravel() - 1)]
    bursts = _with_code(samples, bursts, levels)
    left = left[~np.isin(left, bursts.ravel() - 1)]
    held = _held(samples, left, round(_LONGEST / step) + 1)
    left = left[~np.isin(left, held[:, 1] - 1)]
    left = left[np.abs(samples[left + 1] - samples[left]) > _LOST * usual]
    ends = np.stack((stamps[left], stamps[left + 1]), axis=1)
    cuts = ends[np.isfinite(ends).all(axis=1)]
    first = [float(stamps[spans[0, 0]]) if spans.size else np.nan for spans in (bursts, held)]
    return Dropouts(bursts, held, _ranked(levels), cuts, (first[0], first[1]))


def _jumps(samples: FloatArray, least: float) -> IntArray:
    """Rows before a step larger than `least` and several times those beside it."""
    rows_before = []
    for rows in chunks(samples.size):
        begin = max(rows.start - 1, 0)
        steps = np.abs(np.diff(samples[begin : rows.stop + 2]))
        if steps.size < 3:
            continue
        beside = OF_BESIDE * np.maximum(steps[:-2], steps[2:])
        rows_before.append(begin + 1 + np.flatnonzero((steps[1:-1] > least) & (steps[1:-1] >= beside)))
    return np.concatenate([np.empty(0, dtype=np.int64), *rows_before])


def _bursts(samples: FloatArray, jumps: IntArray, longest: int, flat: float) -> tuple[IntArray, FloatArray]:
    """Rows of what lies between a jump to a level and one back, and these levels."""
    bursts = []
    levels = []
    last = -1
    for before, end in zip(jumps[:-1].tolist(), jumps[1:].tolist(), strict=True):
        if before <= last or not 2 <= end - before <= longest:
            continue
        part = samples[before + 1 : end + 1]
        there = samples[before + 1] - samples[before]
        back = samples[end + 1] - samples[end]
        if there * back < 0.0 and np.ptp(part) <= flat:
            bursts.append((before + 1, end + 1))
            levels.append(float(np.median(part)))
            last = end
    return np.array(bursts, dtype=np.int64).reshape(-1, 2), np.array(levels)


def _with_code(samples: FloatArray, bursts: IntArray, levels: FloatArray) -> IntArray:
    """The bursts, and all other runs of three samples and more at a level that three bursts have to the last digit."""
    values, counts = np.unique(levels, return_counts=True)
    codes = values[counts >= IN_A_ROW]
    if not codes.size:
        return bursts
    spans = [bursts]
    previous = np.zeros(0, dtype=np.int64)
    for rows in chunks(samples.size):
        previous = np.concatenate((previous, rows.start + np.flatnonzero(np.isin(samples[rows], codes))))
    runs = np.split(previous, np.flatnonzero(np.diff(previous) > 1) + 1)
    spans.append(
        np.array([(run[0], run[-1] + 1) for run in runs if run.size >= IN_A_ROW], dtype=np.int64).reshape(-1, 2)
    )
    every = np.unique(np.concatenate(spans), axis=0)
    keep = np.concatenate(([True], every[1:, 0] >= np.maximum.accumulate(every[:-1, 1])))
    return every[keep]


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


def dropout_remarks(lost: Dropouts, factor: float = 1.0, unit: str = "") -> list[str]:
    """Remarks on them: what, how many, since when. Levels are printed in `unit`, which is `factor` × SI."""
    remarks = []
    if len(lost.bursts):
        levels = " and ".join(f"{factor * level:.5g}{unit and ' ' + unit}" for level in lost.levels[:2])
        more = f" and {len(lost.levels) - 2} more levels" if len(lost.levels) > 2 else ""
        what = f"{_several(lost.bursts, 'burst')} at {levels}{more}, which no motion reaches"
        remarks.append(f"{what}, the first at {lost.first[0]:.6g} s")
    if len(lost.held):
        what = f"{_several(lost.held, 'stretch', 'stretches')} in which the last value was held"
        remarks.append(f"{what}, the first at {lost.first[1]:.6g} s")
    if count := len(lost.cuts):
        remarks.append(
            f"{count} jump{'s' * (count > 1)} from one sample to the next, the first at {lost.cuts[0, 1]:.6g} s: rows "
            "are missing though time goes on (a buffer was lost?)"
        )
    return remarks


def _several(spans: IntArray, singular: str, plural: str = "") -> str:
    """How many spans and samples."""
    noun = singular if len(spans) == 1 else plural or f"{singular}s"
    return f"{len(spans)} {noun} of {int(np.diff(spans).sum())} samples"


def _ranked(levels: FloatArray) -> tuple[float, ...]:
    """The different levels, the most frequent first."""
    values, counts = np.unique(levels, return_counts=True)
    return tuple(values[np.argsort(-counts, kind="stable")].tolist())
