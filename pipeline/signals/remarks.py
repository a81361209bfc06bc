"""Remarks: the sentences that warn of a raw log; none of them refuses it.

Sentences of findings stand in `pipeline.diagnostics.sentences`.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal

import numpy as np

from ..numerics.arrays import FloatArray
from ..units.quantity import counted, stamped
from .columns import Missing, Signal, finite, select
from .findings import UNTOLD_STEP, Remark, scale_suspicion, unshown
from .noise import LEAST_PER_PERIOD, advised_interval, is_stepped, mains_at_another_rate, noise_level
from .outliers import Dropouts, LeftOut
from .signal_quality import BOTH_SIGNS, SignalQuality, few_levels, is_ramped, rail, span, usual_span
from .survey import TimeRows
from .timebase import TimeQuality

_FROZEN_SECONDS = 0.05
_FROZEN_SAMPLES = 20
_SHOWS = 1e-4
"""Share of the range of a signal that a hum is worth a remark from."""
_MUCH = 10.0
"""Times the range of an idle channel by which another one of its unit moves, if the idle one is not driven."""
_MUCH_DISCARDED = 0.03
"""Share of the rows that may be left out where time steps back, before another remedy is named."""

Clock = Literal["s", "samples", ""]
"""Units of places in a log: seconds, numbers of samples, or a time of which the log states no unit."""


def channel_remarks(
    quality: SignalQuality, clock: Clock = "s", *, driven: bool = False, alike: float = np.nan
) -> tuple[Remark, ...]:
    """Remarks on a channel for the user.

    Parameters
    ----------
    quality : SignalQuality
        Of the channel.
    clock : {"s", "samples", ""}
        Unit of its places.
    driven : bool
        True if it may be an input: one that is held, or stays at a limit, was commanded so.
    alike : float
        Largest range of another channel of its unit; NaN where there is none.
    """
    remarks = []
    if quality.not_finite:
        remarks.append(
            Remark(
                f"{counted(quality.not_finite, 'sample')} not finite{_first(quality.not_finite_at, clock)}",
                dealt_with=True,
            )
        )
    if quality.constant:
        return (*remarks, Remark("constant"))
    if quality.levels:
        values = [f"{value:.6g}" for value in quality.levels]
        return (*remarks, Remark(f"takes {len(values)} values only: {', '.join(values[:-1])} and {values[-1]}"))
    if quality.idle:
        undriven = not driven or alike > _MUCH * quality.span
        remarks.append(Remark("nothing but noise: no excitation" if undriven else "white noise, or nothing but noise"))
    if not (driven and (quality.stepped or quality.ramped)):
        remarks += _stays(quality, clock)
    if quality.spikes:
        remarks.append(
            Remark(
                f"{counted(quality.spikes, 'single-sample spike')}{_first(quality.spikes_at, clock)}", dealt_with=True
            )
        )
    remarks += [
        Remark(
            f"{line.frequency:g} Hz hum {line.above_floor_db:.0f} dB over the spectrum beside it, "
            f"amplitude {line.amplitude:.3g}"
        )
        for line in quality.hum
        if line.stands_out and line.amplitude > _SHOWS * quality.span and clock == "s"
    ]
    return tuple(remarks)


def _stays(quality: SignalQuality, clock: Clock) -> Iterator[Remark]:
    """Remarks on times in which a signal stands still."""
    for end, share, value in (
        ("upper", quality.high_rail, quality.usual[1]),
        ("lower", quality.low_rail, quality.usual[0]),
    ):
        if share > 0.0:
            yield Remark(  # their share has a grade of its own
                f"{100 * share:.2g} % of the samples stay at the {end} extreme {value:.6g}: saturated?", dealt_with=True
            )
    long = quality.longest_frozen > _FROZEN_SECONDS and quality.frozen_samples >= _FROZEN_SAMPLES
    if clock == "s" and long and not (quality.stepped or quality.rests):
        yield Remark(f"unchanged for {quality.longest_frozen:.3g} s from {stamped(quality.frozen_at)} s on")


def _first(places: tuple[float, ...], clock: Clock) -> str:
    """Place of the first event, as text; empty where the time itself is not known there."""
    if not places or not np.isfinite(places[0]):
        return ""
    shown = {"s": f"{stamped(places[0])} s", "samples": f"sample {places[0]:.6g}", "": f"{places[0]:.6g}"}
    return f", the first at {shown[clock]}"


def saturation_remarks(time: FloatArray, samples: FloatArray, unit: str) -> Iterator[Remark]:
    """Remarks on an input that is cut off at its largest or smallest value, exactly or beneath noise.

    A command holds its levels exactly, everywhere; a probe does so nowhere but at its rail. An input that rests about
    zero is not at a rail there: its steps may hide the noise, and an amplifier that is off makes none.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s].
    samples : FloatArray, shape (N,)
        The input.
    unit : str
        SI unit of the input.
    """
    values = select(samples, finite(samples))
    if not values.size or few_levels(values) or is_stepped(values):
        return
    noise = noise_level(values)
    usual = usual_span(values)
    ends = [rail(values, usual, end, noise) for end in (0, 1)]
    rails = [(end.low, end.high) for end in ends if end]
    largest = max(abs(bound) for bound in span(values))
    for low, high in rails if not is_ramped(rails) else ():
        level = 0.5 * (low + high)
        if abs(level) > BOTH_SIGNS * largest:
            there = (samples >= low) & (samples <= high)
            cut = "but for its noise, " if high > low else ""
            yield Remark(
                f"{100.0 * np.mean(there):.2g} % of the samples stay at {level:.6g} {unit}, {cut}the first at "
                f"{time[np.argmax(there)]:.6g} s, which they reach at a slope: a saturated probe? What was applied "
                "there is not known: widen the probe's range, unless this is a command that is limited there"
            )


def scale_remarks(name: str, reach: float, unit: str, plausible: tuple[float, float] | None) -> Iterator[Remark]:
    """Remark on a channel whose numbers span so much that their prefix seems to be wrong.

    Parameters
    ----------
    name, unit : str
        Of the channel; its SI unit.
    reach : float
        Largest minus smallest number, in that unit.
    plausible : (float, float) or None
        Least and largest such span.
    """
    factor = scale_suspicion(reach, plausible)
    if factor is not None:
        size = f"{factor:g}× too large" if factor > 1.0 else f"{1.0 / factor:g}× too small"
        yield Remark(f"{name} spans {reach:.3g} {unit} and looks {size}: check its unit in [channels]")


def mains_remarks(inputs: Sequence[Signal], rate: float) -> Iterator[Remark]:
    """Remarks on inputs whose mains hum contradicts the sample rate [Hz] of the settings."""
    for k, (_, samples) in enumerate(inputs, start=1):
        hum = mains_at_another_rate(select(samples, finite(samples)), 1.0 / rate)
        if hum is not None:
            line, factor = hum
            rectified = ", or that of a rectifier" if factor < 1.0 else ""
            yield Remark(
                f"v{k}: a line at {line.frequency:g} Hz and no hum at {factor * line.frequency:g} Hz, as mains hum at "
                f"{factor:g} times the sample rate{rectified}: is [ingest] sample_rate = {rate:g} right?"
            )


def code_remarks(counts: dict[float, int]) -> list[Remark]:
    """Remarks on the codes in a column."""
    return [
        Remark(
            f"{n} sample{'s' * (n > 1)} of {code:.6g} stand{'s' * (n == 1)} for no value: masked "
            "(`missing` in [channels])",
            dealt_with=True,
        )
        for code, n in counts.items()
    ]


def dropout_texts(lost: Dropouts, factor: float = 1.0, unit: str = "") -> Iterator[tuple[str, str]]:
    """Texts on them: what, how many, since when; and what ingest does with their rows.

    Levels are printed in `unit`, which is `factor` × SI.
    """
    if len(lost.bursts):
        levels = " and ".join(f"{factor * level:.5g}{unit and ' ' + unit}" for level in lost.levels[:2])
        more = f" and {len(lost.levels) - 2} more levels" if len(lost.levels) > 2 else ""
        bursts = f"{counted(len(lost.bursts), 'burst')} of {int(np.diff(lost.bursts).sum())} samples"
        yield f"{bursts} at {levels}{more}, which no motion reaches, the first at {lost.first[0]:.6g} s", "masked"
    if len(lost.held):
        yield (
            f"{counted(len(lost.held), 'segment')} of {int(np.diff(lost.held).sum())} samples in which the last value "
            f"was held, the first at {lost.first[1]:.6g} s",
            "masked",
        )
    if count := len(lost.cuts):
        yield (
            f"{counted(count, 'jump')} from one sample to the next, the first at {lost.cuts[0, 1]:.6g} s: rows "
            "are missing though time goes on (a buffer was lost?)",
            "split there",
        )


def bridged_remark(spikes: int, first: float) -> Remark:
    """Remark on the spikes of an input that were bridged, the first at `first` [s]."""
    return Remark(
        f"{counted(spikes, 'single-sample spike')}, the first at {stamped(first)} s: bridged ([ingest] spikes)",
        dealt_with=True,
    )


def masked_remarks(left_out: LeftOut, lost: Dropouts, factor: float, unit: str) -> Iterator[Remark]:
    """Remarks on samples of q that were masked as no measurements.

    Parameters
    ----------
    left_out : LeftOut
        Their numbers by cause.
    lost : Dropouts
        Where the sensor lost its target.
    factor, unit : float, str
        Levels are printed in `unit`, which is `factor` × SI.
    """
    at_level = left_out.lost - int(np.diff(lost.spans).sum())
    lost_target = "at a constant level far outside the rest masked: the sensor had lost its target ([ingest] lost)"
    masks = (
        (left_out.rails, "sample", "at the ends of its range masked ([ingest] rails)"),
        (at_level, "sample", lost_target),
        (left_out.spikes, "single-sample spike", "masked ([ingest] spikes)"),
    )
    texts = [
        *(f"{text}: {then} ([ingest] lost)" for text, then in dropout_texts(lost, factor, unit)),
        *(f"{counted(count, noun)} {then}" for count, noun, then in masks if count),
    ]
    return (Remark(f"q: {text}", dealt_with=True) for text in texts)


def missing_remarks(beside: Mapping[str, Missing], interval: float) -> Iterator[Remark]:
    """Remarks on samples that are missing beside q, and on more than an interval [s] at which only q is known."""
    for name, lacks in beside.items():
        if lacks.not_finite:
            place = f", the first at {stamped(lacks.first)} s" if np.isfinite(lacks.first) else ""
            yield Remark(f"{name}: {counted(lacks.not_finite, 'sample')} not finite{place}", dealt_with=True)
        for alone, how in ((lacks.before, "begins {} after q"), (lacks.after, "ends {} before q")):
            if alone > interval:
                yield Remark(f"{name} {how.format(f'{alone:.4g} s')}: what q shows there is left out")


def discarded_remarks(rows: TimeRows) -> Iterator[Remark]:
    """Remark on rows that are left out where time steps back."""
    if rows.turns.size:
        share = rows.backward / rows.time.size
        much = "; give the parts as logs of their own, or repair the clock" if share > _MUCH_DISCARDED else ""
        yield Remark(
            f"time steps back at {counted(int(rows.turns.size), 'place')}, first after "
            f"{stamped(float(rows.turns[0]))} s: {rows.backward} of {rows.time.size} rows ({100.0 * share:.2g} %) are "
            f"left out ([ingest] time_reversal){much}"
        )


def gap_remarks(clock: TimeQuality, unknown: Sequence[tuple[float, float]]) -> Iterator[Remark]:
    """Remarks on gaps in time, and on spans [s] in which the inputs are not known."""
    kinds = (
        ("in time", clock.gaps, clock.gaps_at, "split there ([ingest] gaps)"),
        (
            "in the inputs",
            len(unknown),
            unknown,
            "what they were is not known, so fits and free runs start anew behind",
        ),
    )
    for what, count, places, then in kinds:
        if count:
            before, after = map(stamped, places[0])
            several = "the first " if count > 1 else ""
            yield Remark(
                f"{counted(count, 'gap')} {what}, {several}from {before} to {after} s: {then}", dealt_with=True
            )


def rate_remarks(time: TimeQuality, q: SignalQuality, sample_interval: float) -> Iterator[Remark]:
    """Remark on the sample interval: shorter than that of the log, so that rows are interpolated, or too long for the
    motion in a log that could show it.
    """
    if time.step > UNTOLD_STEP * sample_interval:
        made_up = 100.0 * (1.0 - sample_interval / time.step)
        yield Remark(
            f"the log has a sample every {time.step:.4g} s, so {made_up:.0f} % of the rows at [ingest] "
            f"sample_interval = {sample_interval:g} are interpolated: the noise looks smaller and fits take longer; "
            f"set sample_interval = {time.step:.4g}"
        )
    elif unshown(time, q, sample_interval, q.band.most, LEAST_PER_PERIOD):
        yield Remark(
            f"q: moves up to {q.band.most:.3g} Hz (99 % of its power), of which [ingest] sample_interval = "
            f"{sample_interval:g} s leaves little: set sample_interval = {advised_interval(q.band.most, time.step):g}"
        )
