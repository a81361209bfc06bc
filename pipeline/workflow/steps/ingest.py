"""Ingest: a raw log corrected, examined, masked and brought to uniform records."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ...device.device import device
from ...diagnostics.copies import sketch
from ...diagnostics.sentences import judge, sentences
from ...errors import DataRefusedError
from ...numerics.arrays import FloatArray
from ...settings.prototype import Ingest, Prototype
from ...signals.columns import finite, missing, scaled, select
from ...signals.findings import (
    Finding,
    coarse_inputs,
    counted,
    log_findings,
    missing_findings,
    rate_findings,
    rate_remarks,
    remarks_on,
    saturation,
    scale_suspicion,
)
from ...signals.log import LONGEST_BRIDGE, UNKNOWN, Corrections, RawLog
from ...signals.noise import held_samples, mains_at_another_rate, resolution
from ...signals.outliers import Trusted, dropout_remarks, trusted, without_spikes
from ...signals.signal_quality import SignalQuality, examine_signal, span
from ...signals.timebase import TimeQuality, examine, nominal_step, seldom
from ...signals.uniform_record import Resampling, Survey, TimeRows, UniformRecord, inputs_unknown, survey
from ...units.quantity import stamped

_MOST_EMPTY = 1000.0  # times what a log holds, beyond which it is not brought to one grid
_FEWEST_ROWS = 10
_MUCH_DISCARDED = 0.03
"""Share of the rows that may be left out where time steps back, before another remedy is named."""


def corrected_log(log: RawLog, by: Corrections) -> RawLog:
    """A raw log whose readings are corrected; a measured velocity is left as its own sensor read it."""
    made: dict[tuple[int, float], FloatArray] = {}

    def base(time: FloatArray, delay: float = 0.0) -> FloatArray:
        """A corrected time base, made once, so that signals that shared one do so still."""
        return made.setdefault((id(time), delay), scaled(time, by.clock, delay))

    inputs = [
        (base(time, by.delay), scaled(samples, gain, 0.0))
        for (time, samples), gain in zip(log.inputs, by.gains, strict=True)
    ]
    q = base(log.q[0]), scaled(log.q[1], by.gain_q, by.zero)
    velocity = None if log.velocity is None else (base(log.velocity[0]), log.velocity[1])
    return RawLog(q, tuple(inputs), velocity, log.notes)


def examined(signals: RawLog, prototype: Prototype, where: str) -> tuple[tuple[Resampling, Resampling], dict[str, Any]]:
    """Examine a raw log in SI units and mask what cannot be trusted.

    Returns
    -------
    (Resampling, Resampling)
        The log brought to two uniform grids: that of the fine record, and that of the signals. The interval of the fine
        record is a whole fraction of the sample interval, and never finer than the log.
    dict
        What was noticed.

    Raises
    ------
    DataRefusedError
        The log is of no use, or the quality gates refuse it; the text begins with `where` it is.
    """
    settings = prototype.ingest
    try:
        raw_step = nominal_step(signals.q[0])
        signals = _without_spikes(signals, settings)
        trusted = _trusted(signals, prototype, raw_step)
        warnings = [*signals.notes, *_warnings(signals, prototype, trusted)]
        usable = survey(
            (signals.q[0], trusted.samples),
            signals.beside,
            gaps=settings.gaps,
            time_reversal=settings.time_reversal,
            cuts=trusted.dropouts.cuts[:, 0],
        )
    except DataRefusedError as error:
        raise DataRefusedError(f"{where}: {error}") from error
    quality = trusted.quality
    left_out = _left_out(trusted, warnings, prototype)
    _refuse_no_record(where, usable.span, settings.sample_interval, usable.rows.keep.size * raw_step)
    _refuse_other_clock(where, clock := examine(signals.q[0]), quality, prototype)
    finest = max(settings.record_interval, raw_step * (1.0 - 1e-3))
    fine = settings.sample_interval / max(1, int(settings.sample_interval / finest + 1e-9))
    resamplings = (Resampling(usable, fine), Resampling(usable, settings.sample_interval))
    masked = resamplings[1].report
    lacking, findings = _lacking(signals, settings.sample_interval)
    unknown = inputs_unknown(usable, LONGEST_BRIDGE * settings.sample_interval)
    warnings += [
        *_discarded(usable.rows),
        *lacking,
        *_gaps(clock, unknown),
        *rate_remarks(clock, quality, settings.sample_interval),
    ]
    few, coarse = _few_samples(signals, settings.sample_interval)
    findings += [*rate_findings(clock, quality, settings.sample_interval), *coarse]
    ends = _cut_off(usable, clock)
    cut = ends / masked.interval
    findings += log_findings(clock, quality, (masked.masked_rows + cut) / (masked.rows + cut), few)
    if settings.rails == "keep":
        rails = [sentences(finding)[0] for finding in findings if finding.gate == "rails"]
        warnings += [f"q: {text}; kept ([ingest] rails)" for text in rails]
        findings = [finding for finding in findings if finding.gate != "rails"]
    accepted = judge(where, findings, prototype.quality)
    notes = {"warnings": [*warnings, *accepted], "accepted": accepted, "gaps_in_time": clock.gaps + clock.backward}
    # An interval around each place where rows are missing belongs to what is not known of the inputs.
    around = [(a - settings.sample_interval, b + settings.sample_interval) for a, b in trusted.dropouts.cuts.tolist()]
    notes |= left_out | {"cut_off_s": ends, UNKNOWN: sorted([*unknown, *around])}
    return resamplings, notes | _sensor(signals, quality)


def _without_spikes(signals: RawLog, settings: Ingest) -> RawLog:
    """The log with its inputs' single-sample spikes bridged, and noted."""
    texts = list[str]()
    inputs = []
    for k, signal in enumerate(signals.inputs if settings.spikes == "mask" else (), start=1):
        bridged, count, first = without_spikes(signal, nominal_step(signal[0]))
        what = f"v{k}: {counted(count, 'single-sample spike')}, the first at {stamped(first)} s: bridged"
        texts += [f"{what} ([ingest] spikes)"] if count else []
        inputs.append(bridged)
    return replace(signals, inputs=tuple(inputs), notes=(*signals.notes, *texts)) if texts else signals


def _trusted(signals: RawLog, prototype: Prototype, raw_step: float) -> Trusted:
    """The displacement without what is masked by the settings."""
    masked = {name: getattr(prototype.ingest, name) == "mask" for name in ("rails", "lost", "spikes")}
    inert = device(prototype).displacement.symbol != "V"
    return trusted(signals.q, signals.inputs, examine_signal(*signals.q, raw_step), raw_step, inert=inert, **masked)


def _few_samples(signals: RawLog, interval: float) -> tuple[list[str], list[Finding]]:
    """Inputs with stamps of their own that may have been recorded on change only, and those with too long steps for a
    sample interval [s].
    """
    own = {f"v{k}": time for k, (time, _) in enumerate(signals.inputs, start=1) if time is not signals.q[0]}
    steps = {name: nominal_step(time) for name, time in own.items()}
    few = [name for name, time in own.items() if seldom(time.size, steps[name], float(time[-1] - time[0]))]
    return few, coarse_inputs(steps, interval)


def _refuse_no_record(where: str, span: tuple[float, float], interval: float, covered: float) -> None:
    """Refuse what cannot become a record with rows an interval [s] apart, from samples for `covered` seconds."""
    rows = int((span[1] - span[0]) / interval + 1e-6) + 1
    if rows < _FEWEST_ROWS:
        raise DataRefusedError(
            f"{where}: lasts {rows} steps of [ingest] sample_interval = {interval:g} s only; "
            "record longer, shorten that interval, or correct the unit of the time"
        )
    if rows * interval > _MOST_EMPTY * covered:
        raise DataRefusedError(
            f"{where}: holds {covered:.4g} s of samples within {rows * interval:.4g} s; give what lies on both sides "
            "of its gaps as logs of their own, or correct the time stamps"
        )


def _refuse_other_clock(where: str, clock: TimeQuality, quality: SignalQuality, prototype: Prototype) -> None:
    """Refuse stamps that are no seconds, before a record is made of them."""
    if clock.written_as_minutes:
        raise DataRefusedError(
            f"{where}: time jumps by 40 s at each of its minutes, as stamps written hhmmss do: write them as hh:mm:ss, "
            "or give what lies on both sides of such a gap as logs of their own"
        )
    if clock.step > _MOST_EMPTY * prototype.ingest.sample_interval:  # a record would hardly be one
        judge(where, rate_findings(clock, quality, prototype.ingest.sample_interval), prototype.quality)


def _sensor(signals: RawLog, quality: SignalQuality) -> dict[str, Any]:
    """Facts of the sensor of q: noise and steps [m or rad], mains lines [Hz], and samples for which a value is held.

    A sketch of the samples serves to recognise a copy.
    """
    step = resolution(signals.q[1])
    return {
        "noise": quality.noise,
        "resolution": step,
        "hum": [line.frequency for line in quality.hum if line.stands_out],
        "held": held_samples(signals.q[1], step),
        "sketch": sketch(*signals.q),
    }


def _cut_off(usable: Survey, clock: TimeQuality) -> float:
    """Time [s] at both ends of a log in which no sample of q is left; clock: that of q."""
    edges = usable.groups[0].edges
    return max(0.0, float(edges[0, 0]) - clock.start) + max(0.0, clock.stop - float(edges[-1, 1]))


def _lacking(signals: RawLog, interval: float) -> tuple[list[str], list[Finding]]:
    """Messages on missing samples beside q, and on more than an interval [s] at which only q is known; and the
    findings against the log.
    """
    beside = missing(signals.q, signals.beside)
    texts = []
    for name, lacks in beside.items():
        if lacks.not_finite:
            place = f", the first at {stamped(lacks.first)} s" if np.isfinite(lacks.first) else ""
            texts.append(f"{name}: {counted(lacks.not_finite, 'sample')} not finite{place}")
        for alone, how in ((lacks.before, "begins {} after q"), (lacks.after, "ends {} before q")):
            if alone > interval:
                texts.append(f"{name} {how.format(f'{alone:.4g} s')}: what q shows there is left out")
    return texts, missing_findings(beside)


def _discarded(rows: TimeRows) -> list[str]:
    """Messages on rows that are left out where time steps back."""
    if not rows.turns.size:
        return []
    share = rows.backward / rows.time.size
    places = counted(int(rows.turns.size), "place")
    much = "; give the parts as logs of their own, or repair the clock" if share > _MUCH_DISCARDED else ""
    return [
        f"time steps back at {places}, first after {stamped(float(rows.turns[0]))} s: {rows.backward} of "
        f"{rows.time.size} rows ({100.0 * share:.2g} %) are left out ([ingest] time_reversal){much}"
    ]


def _gaps(clock: TimeQuality, unknown: Sequence[tuple[float, float]]) -> Iterator[str]:
    """Messages on gaps in time, and on spans [s] in which the inputs are not known."""
    kinds = [
        ("in time", clock.gaps, clock.gaps_at, "split there ([ingest] gaps)"),
        (
            "in the inputs",
            len(unknown),
            unknown,
            "what they were is not known, so fits and free runs start anew behind",
        ),
    ]
    for what, count, places, then in kinds:
        if count:
            before, after = map(stamped, places[0])
            several = "the first " if count > 1 else ""
            yield f"{counted(count, 'gap')} {what}, {several}from {before} to {after} s: {then}"


def _left_out(trusted: Trusted, warnings: list[str], prototype: Prototype) -> dict[str, int]:
    """Counts of samples of q that were masked as no measurements; adds a warning for each cause."""
    rails, lost, spikes = trusted.left_out
    plant = device(prototype)
    unit = "mm" if plant.angle else prototype.channels.q.unit
    remarks = dropout_remarks(trusted.dropouts, 1.0 / plant.displacement.factor, unit)
    warnings += [f"q: {text}: {'split there' if 'jump' in text else 'masked'} ([ingest] lost)" for text in remarks]
    lost -= int(np.diff(trusted.dropouts.spans).sum())
    if rails:
        warnings.append(f"q: {counted(rails, 'sample')} at the ends of its range masked ([ingest] rails)")
    if lost:
        warnings.append(
            f"q: {counted(lost, 'sample')} at a constant level far outside the rest masked: the sensor had lost its "
            "target ([ingest] lost)"
        )
    if spikes:
        warnings.append(f"q: {counted(spikes, 'single-sample spike')} masked ([ingest] spikes)")
    return {"masked_at_rails": rails, "masked_without_target": trusted.left_out[1], "masked_spikes": spikes}


def record_columns(piece: UniformRecord, names: Sequence[str]) -> dict[str, FloatArray]:
    """The columns of a record's table; `names` are those beside q."""
    beside = {name: np.ascontiguousarray(column) for name, column in zip(names, piece.v.T, strict=True)}
    if "velocity" in beside:
        beside["velocity"] = np.where(piece.segment < 0, np.nan, beside["velocity"])
    return {"t": piece.t, "q": piece.q, **beside, "segment": piece.segment}


def _hum_against_rate(signals: RawLog, rate: float | None) -> Iterator[str]:
    """Warnings where mains hum on the inputs contradicts the sample rate [Hz] of the settings."""
    for k, (_, samples) in enumerate(signals.inputs if rate else (), start=1):
        hum = mains_at_another_rate(select(samples, finite(samples)), 1.0 / (rate or 1.0))
        if hum is not None:
            line, factor = hum
            rectified = ", or that of a rectifier" if factor < 1.0 else ""
            yield (
                f"v{k}: a line at {line.frequency:g} Hz and no hum at {factor * line.frequency:g} Hz, as mains hum at "
                f"{factor:g} times the sample rate{rectified}: is [ingest] sample_rate = {rate:g} right?"
            )


def _warnings(signals: RawLog, prototype: Prototype, trusted: Trusted) -> list[str]:
    """Warnings on suspicious signals; nothing is corrected."""
    warnings = [f"q: {remark}" for remark in remarks_on(trusted.quality)]
    plant = device(prototype)
    warnings += _hum_against_rate(signals, prototype.ingest.sample_rate)
    for k, ((time, column), unit) in enumerate(zip(signals.inputs, plant.inputs, strict=True), 1):
        warnings += [f"v{k}: {remark}" for remark in saturation(time, column, unit.symbol)]
    ends = [("q", span(trusted.samples), plant.displacement)] + [
        (f"v{k}", span(column), unit)
        for k, ((_, column), unit) in enumerate(zip(signals.inputs, plant.inputs, strict=True), 1)
    ]
    for name, (smallest, largest), unit in ends:
        factor = scale_suspicion(largest - smallest, plant.plausible_span(unit.symbol))
        if factor is not None:
            size = f"{factor:g}× too large" if factor > 1.0 else f"{1.0 / factor:g}× too small"
            warnings.append(
                f"{name} spans {largest - smallest:.3g} {unit.symbol} and looks {size}: check its unit in [channels]"
            )
    return warnings
