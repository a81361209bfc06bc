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
from ...signals.columns import Signal, missing, scaled
from ...signals.findings import (
    Finding,
    Remark,
    coarse_inputs,
    log_findings,
    missing_findings,
    rate_findings,
)
from ...signals.log import LONGEST_BRIDGE, UNKNOWN, Corrections, RawLog
from ...signals.noise import held_samples, resolution
from ...signals.outliers import Trusted, trusted, without_spikes
from ...signals.remarks import (
    bridged_remark,
    channel_remarks,
    discarded_remarks,
    gap_remarks,
    mains_remarks,
    masked_remarks,
    missing_remarks,
    rate_remarks,
    saturation_remarks,
    scale_remarks,
)
from ...signals.signal_quality import SignalQuality, examine_signal, span
from ...signals.survey import Survey, inputs_unknown, survey
from ...signals.timebase import TimeQuality, examine, nominal_step, seldom
from ...signals.uniform_record import Resampling, UniformRecord

_MOST_EMPTY = 1000.0  # times what a log holds, beyond which it is not brought to one grid
_FEWEST_ROWS = 10


def corrected_log(log: RawLog, by: Corrections) -> RawLog:
    """A raw log whose readings are corrected; a measured velocity is left as its own sensor read it."""
    made: dict[tuple[int, float], FloatArray] = {}

    def base(time: FloatArray, delay: float = 0.0) -> FloatArray:
        """A corrected time base, made once, so that signals that shared one do so still."""
        return made.setdefault((id(time), delay), scaled(time, by.clock, delay))

    inputs = [
        Signal(base(time, by.delay), scaled(samples, gain, 0.0))
        for (time, samples), gain in zip(log.inputs, by.gains, strict=True)
    ]
    q = Signal(base(log.q.time), scaled(log.q.samples, by.gain_q, by.zero))
    velocity = None if log.velocity is None else Signal(base(log.velocity.time), log.velocity.samples)
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
    interval = settings.sample_interval
    try:
        raw_step = nominal_step(signals.q.time)
        signals = _without_spikes(signals, settings)
        trusted = _trusted(signals, prototype, raw_step)
        remarks = [*signals.notes, *_remarks(signals, prototype, trusted)]
        usable = survey(
            Signal(signals.q.time, trusted.samples),
            signals.beside,
            gaps=settings.gaps,
            time_reversal=settings.time_reversal,
            cuts=trusted.dropouts.cuts[:, 0],
        )
    except DataRefusedError as error:
        raise DataRefusedError(f"{where}: {error}") from error
    quality = trusted.quality
    clock = examine(signals.q.time)
    _refuse_no_record(where, usable.span, interval, usable.rows.keep.size * raw_step)
    _refuse_other_clock(where, clock, quality, prototype)
    fine = interval / max(1, int(interval / max(settings.record_interval, raw_step * (1.0 - 1e-3)) + 1e-9))
    resamplings = (Resampling(usable, fine), Resampling(usable, interval))
    beside = missing(signals.q, signals.beside)
    unknown = inputs_unknown(usable, LONGEST_BRIDGE * interval)
    few, coarse = _few_samples(signals, interval)
    cut_off = _cut_off(usable, clock)
    report = resamplings[1].report
    cut = cut_off / report.interval  # rows
    findings = [
        *missing_findings(beside),
        *rate_findings(clock, quality, interval),
        *coarse,
        *log_findings(clock, quality, (report.masked_rows + cut) / (report.rows + cut), few),
    ]
    kept = [finding for finding in findings if finding.gate == "rails" and settings.rails == "keep"]
    accepted = judge(
        where, [finding for finding in findings if finding not in kept], prototype.quality, noted=signals.notes
    )
    remarks += [
        *discarded_remarks(usable.rows),
        *missing_remarks(beside, interval),
        *gap_remarks(clock, unknown),
        *rate_remarks(clock, quality, interval),
        *(Remark(f"q: {sentences(finding)[0]}; kept ([ingest] rails)", dealt_with=True) for finding in kept),
    ]
    # An interval around each place where rows are missing belongs to what is not known of the inputs.
    around = [(a - interval, b + interval) for a, b in trusted.dropouts.cuts.tolist()]
    return resamplings, {
        "warnings": [*(remark.text for remark in remarks), *accepted],
        "dealt_with": [remark.text for remark in remarks if remark.dealt_with],
        "accepted": accepted,
        "gaps_in_time": clock.gaps + clock.backward,
        "masked_at_rails": trusted.left_out.rails,
        "masked_without_target": trusted.left_out.lost,
        "masked_spikes": trusted.left_out.spikes,
        "cut_off_s": cut_off,
        UNKNOWN: sorted([*unknown, *around]),
        **_sensor(signals, quality),
    }


def _without_spikes(signals: RawLog, settings: Ingest) -> RawLog:
    """The log with its inputs' single-sample spikes bridged, and noted."""
    remarks = list[Remark]()
    inputs = []
    for k, signal in enumerate(signals.inputs if settings.spikes == "mask" else (), start=1):
        bridged, count, first = without_spikes(signal, nominal_step(signal.time))
        if count:
            remarks.append(bridged_remark(count, first).of(f"v{k}"))
        inputs.append(bridged)
    return replace(signals, inputs=tuple(inputs), notes=(*signals.notes, *remarks)) if remarks else signals


def _trusted(signals: RawLog, prototype: Prototype, raw_step: float) -> Trusted:
    """The displacement without what is masked by the settings."""
    masked = {name: getattr(prototype.ingest, name) == "mask" for name in ("rails", "lost", "spikes")}
    inert = device(prototype).displacement.symbol != "V"
    return trusted(signals.q, signals.inputs, examine_signal(*signals.q, raw_step), raw_step, inert=inert, **masked)


def _few_samples(signals: RawLog, interval: float) -> tuple[list[str], list[Finding]]:
    """Inputs with stamps of their own that may have been recorded on change only, and those with too long steps for a
    sample interval [s].
    """
    own = {f"v{k}": time for k, (time, _) in enumerate(signals.inputs, start=1) if time is not signals.q.time}
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
    step = resolution(signals.q.samples)
    return {
        "noise": quality.noise,
        "resolution": step,
        "hum": [line.frequency for line in quality.hum if line.stands_out],
        "held": held_samples(signals.q.samples, step),
        "sketch": sketch(*signals.q),
    }


def _cut_off(usable: Survey, clock: TimeQuality) -> float:
    """Time [s] at both ends of a log in which no sample of q is left; clock: that of q."""
    edges = usable.groups[0].edges
    return max(0.0, float(edges[0, 0]) - clock.start) + max(0.0, clock.stop - float(edges[-1, 1]))


def record_columns(piece: UniformRecord, names: Sequence[str]) -> dict[str, FloatArray]:
    """The columns of a record's table; `names` are those beside q."""
    beside = {name: np.ascontiguousarray(column) for name, column in zip(names, piece.v.T, strict=True)}
    if "velocity" in beside:
        beside["velocity"] = np.where(piece.segment < 0, np.nan, beside["velocity"])
    return {"t": piece.t, "q": piece.q, **beside, "segment": piece.segment}


def _remarks(signals: RawLog, prototype: Prototype, trusted: Trusted) -> Iterator[Remark]:
    """Remarks on suspicious signals, which are left as they are, and on masked samples of q."""
    plant = device(prototype)
    rate = prototype.ingest.sample_rate
    inputs = [
        (f"v{k}", time, samples, unit)
        for k, ((time, samples), unit) in enumerate(zip(signals.inputs, plant.inputs, strict=True), 1)
    ]
    yield from (remark.of("q") for remark in channel_remarks(trusted.quality))
    yield from mains_remarks(signals.inputs, rate) if rate else ()
    for name, time, samples, unit in inputs:
        yield from (remark.of(name) for remark in saturation_remarks(time, samples, unit.symbol))
    for name, _, samples, unit in (("q", None, trusted.samples, plant.displacement), *inputs):
        smallest, largest = span(samples)
        yield from scale_remarks(name, largest - smallest, unit.symbol, plant.plausible_span(unit.symbol))
    yield from masked_remarks(
        trusted.left_out,
        trusted.dropouts,
        1.0 / plant.displacement.factor,
        "mm" if plant.angle else prototype.channels.q.unit,
    )
