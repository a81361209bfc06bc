"""Rows on the motion of one log: units, sampling, ring-down, rests, and what moves q without an input."""

from collections.abc import Sequence

import numpy as np

from pipeline.checks import limits
from pipeline.checks.declared import Declared
from pipeline.checks.log_facts import LogFacts
from pipeline.checks.rest_drift import RestDrift
from pipeline.checks.rows import CheckRow, State, in_si, short_quantity, times_text
from pipeline.scoring.wells import Wells
from pipeline.settings import CheckGate
from pipeline.si_prefix import quantity, significant
from pipeline.signals.noise import below_resolution
from pipeline.signals.quality_gates import plausible_span, scale_suspicion
from pipeline.signals.spectrum import advised_interval

ROUNDING = 1e-9
"""Range of q over its largest value up to which it is constant but for the rounding of its unit."""


def motion_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on the motion of a log."""
    rows = [*_unit_rows(fact, declared), _resolution_row(fact, declared), *_rate_rows(fact, declared)]
    rows += [*_wrapped_rows(fact, declared), _natural_row(fact, declared), _ring_row(fact), _rest_row(fact, declared)]
    if declared.joint and isinstance(fact.wells, Wells):
        rows.append(_length_row(fact))
    if fact.drift is not None:
        rows.append(_drift_row(fact, fact.drift, declared))
    if fact.undriven >= limits.UNDRIVEN_SNAPS:
        rows.append(_undriven_row(fact))
    return rows


def start_rows(facts: Sequence[LogFacts]) -> list[CheckRow]:
    """The rows on logs that leave a rest though no input changes; none where that is seen once in all."""
    if sum(len(fact.starts) for fact in facts) < limits.UNDRIVEN_STARTS:
        return []
    return [_start_row(fact) for fact in facts if fact.starts]


def _unit_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    rows = []
    names = ("q", *(f"v{i + 1}" for i in range(fact.peaks.size)))
    spans, units = (fact.span, *fact.peaks.tolist()), (declared.displacement, *declared.inputs)
    for name, span, unit in zip(names, spans, units, strict=True):
        circuit = declared.displacement == "V"  # which is built for whatever voltages it was built for
        allowed = None if circuit else plausible_span(unit, joint=declared.joint)
        limit = " … ".join(short_quantity(end, unit) for end in allowed) if allowed else ""
        wrong = None if circuit else scale_suspicion(span, unit, joint=declared.joint)
        still, advice = name == "q" and span <= ROUNDING * float(np.nanmax(np.abs(fact.signals.q))), ""
        if still:
            advice = "q does not move: name the channel of its sensor, and see whether that has its target"
        elif wrong:
            advice = (
                f"check the unit of {name} in [channels]: its numbers look {times_text(wrong)} as large as a joint's"
            )
        # A voltage too small may be one that is not used; if it pushes all the same, the coupling tells.
        judged = declared.joint and (still or (wrong is not None and (name == "q" or wrong > 1.0)))
        state: State = "wrong" if judged else "note" if still or wrong is not None else "ok"
        gate: CheckGate | None = "scale" if state == "wrong" else None
        values = in_si("range", unit, span)
        measured = quantity(span, unit)
        rows.append(
            CheckRow(fact.signals.name, f"range of {name}", measured, limit, state, gate, advice, values=values)
        )
    return rows


def _resolution_row(fact: LogFacts, declared: Declared) -> CheckRow:
    log, unit = fact.signals, declared.displacement
    noise = "" if log.noise is None else f"noise {quantity(log.noise, unit)}"
    if log.noise is not None and below_resolution(log.noise, log.resolution):
        noise = "noise below that"
    if log.resolution is None:
        return CheckRow(log.name, "resolution of q", "no steps", "", more=noise)
    fine = log.resolution <= limits.MOST_RESOLUTION * fact.span
    limit = f"≤ {short_quantity(limits.MOST_RESOLUTION * fact.span, unit)}"
    state: State = "ok" if fine else "note"
    advice = "" if fine else "velocities come in steps: use the sensor's finer range, or average before recording"
    values = in_si("resolution", unit, log.resolution) | in_si("noise", unit, log.noise)
    measured = quantity(log.resolution, unit)
    return CheckRow(log.name, "resolution of q", measured, limit, state, None, advice, noise, values)


def _rate_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    log, interval = fact.signals, declared.sample_interval
    rate = 1.0 / log.raw_step
    rates = [CheckRow(log.name, "sampling rate", quantity(rate, "Hz"), "", values=in_si("rate", "Hz", rate))]
    if fact.ring is None:
        return rates
    per_period = 1.0 / (fact.ring * interval)
    enough = per_period >= limits.LEAST_PER_PERIOD
    measured, limit = f"{per_period:.{0 if per_period >= 2.0 else 1}f} samples", f"≥ {limits.LEAST_PER_PERIOD:g}"
    finer = advised_interval(fact.ring, log.raw_step)
    advice = "" if enough or finer >= interval else f"set [ingest] sample_interval = {finer:g}"
    values = in_si("samples_per_period", "1", per_period)
    state: State = "ok" if enough else "note"
    return [*rates, CheckRow(log.name, "uniform, a period", measured, limit, state, None, advice, values=values)]


def _ring_row(fact: LogFacts) -> CheckRow:
    name = fact.signals.name
    if fact.ring is None or fact.damping is None:
        return CheckRow(name, "ring-down", "no clear ring-down after a switch-off", "", "not seen")
    measured = f"{quantity(fact.ring, 'Hz')}, ζ = {significant(fact.damping, 2)}"
    values = in_si("frequency", "Hz", fact.ring) | in_si("damping_ratio", "1", fact.damping)
    return CheckRow(name, "ring-down", measured, "", values=values)


def _drift_row(fact: LogFacts, drift: RestDrift, declared: Declared) -> CheckRow:
    unit, lasts = declared.displacement, float(np.ptp(fact.signals.t))
    advice = (
        f"the places of rest move by {quantity(drift.rate * lasts, unit)} over the log: let the sensor warm up, fix "
        "its mount, or take the drift off q"
    )
    measured = f"{quantity(drift.rate, f'{unit}/s', drift.error)} over {drift.rests} rests"
    values = in_si("drift", f"{unit}/s", drift.rate, drift.error)
    return CheckRow(fact.signals.name, "drift of the rests", measured, "", "note", None, advice, values=values)


def _undriven_row(fact: LogFacts) -> CheckRow:
    named = "the input is" if len(fact.inputs) == 1 else "all inputs are"
    measured = str(fact.undriven)
    return CheckRow(fact.signals.name, f"snaps while {named} off", measured, "", "note", None, _not_named(fact))


def _start_row(fact: LogFacts) -> CheckRow:
    places = ", ".join(f"{start:.4g}" for start in fact.starts[: limits.MOST_PLACES])
    measured = f"{len(fact.starts)}, at {places}{' …' if len(fact.starts) > limits.MOST_PLACES else ''} s"
    return CheckRow(
        fact.signals.name, "leaves rest though no input changes", measured, "", "note", None, _not_named(fact)
    )  # fmt: skip


def _not_named(fact: LogFacts) -> str:
    missing = (
        "name the second input as v2 (in [channels], or as an argument)" if len(fact.inputs) == 1
        else "find out what does"
    )  # fmt: skip
    return f"what moves q there is not among the inputs: {missing}"


def _natural_row(fact: LogFacts, declared: Declared) -> CheckRow:
    name, what = fact.signals.name, "natural frequency"
    if fact.natural is None:
        return CheckRow(name, what, "no stable rest in the motion", "", "not seen")
    measured, values = quantity(fact.natural, "Hz"), in_si("frequency", "Hz", fact.natural)
    if not declared.joint:
        return CheckRow(name, what, measured, "", values=values)
    low, high = limits.DRAWN_RING_DOWN / limits.MOST_RATIO, limits.DRAWN_RING_DOWN * limits.MOST_RATIO
    limit = f"{significant(low, 1)} … {significant(high, 2)} Hz"
    if low <= fact.natural <= high:
        return CheckRow(name, what, measured, limit, values=values)
    advice = "check the unit of time in [channels] and the recorder's clock"
    return CheckRow(name, what, measured, limit, "wrong", "time-base", advice, values=values)


def _wrapped_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """An angle that jumps by a turn where it leaves the interval that it is kept in."""
    turns = fact.span / (2.0 * np.pi)
    if declared.displacement != "rad" or not limits.WRAPPED[0] < turns < limits.WRAPPED[1]:
        return []
    q = fact.signals.q
    jumps = int(np.count_nonzero(np.diff((np.abs(q[3:] - q[:-3]) > limits.TURN * fact.span).astype(np.int8)) > 0))
    if not jumps:
        return []
    advice = "unwrap it before it is logged or read (numpy.unwrap, MATLAB's unwrap): a turn is no motion of the device"
    measured = f"{jumps} by {short_quantity(fact.span, 'rad')}"
    return [CheckRow(fact.signals.name, "jumps of the angle", measured, "none", "wrong", "wrapped", advice)]


def _length_row(fact: LogFacts) -> CheckRow:
    """How long the log is, and the error that as much training leaves on simulated joints."""
    length, (lengths, errors) = float(np.ptp(fact.signals.t)), np.transpose(limits.LENGTH_ERRORS)
    expected = float(np.exp(np.interp(np.log(length), np.log(lengths), np.log(errors))))
    measured, limit = (
        f"{significant(s, 3)} s, {significant(e, 2)} %" for s, e in ((length, expected), limits.LENGTH_ERRORS[-1])
    )
    values = in_si("length", "s", length)
    return CheckRow(fact.signals.name, "length, usual error", measured, limit, values=values)


def _rest_row(fact: LogFacts, declared: Declared) -> CheckRow:
    name, unit = fact.signals.name, declared.displacement
    if not isinstance(fact.wells, Wells):
        reason = fact.wells.reason if declared.joint else fact.wells.reason.partition(":")[0]
        return CheckRow(name, "rests", reason, "", "not seen")
    measured = f"{quantity(fact.wells.left, unit)}, {quantity(fact.wells.right, unit)}"
    values = in_si("left", unit, fact.wells.left) | in_si("right", unit, fact.wells.right)
    if not declared.joint or fact.wells.left < 0.0 < fact.wells.right:
        return CheckRow(name, "rests", measured, "", values=values)
    middle = quantity(-0.5 * (fact.wells.left + fact.wells.right), unit)
    advice = (
        "both wells are on one side of zero, where a joint, its parameter set and its mirror plane have the middle: "
        f"zero the sensor, or give `offset` in [channels] q (about {middle})"
    )
    return CheckRow(name, "rests", measured, "left < 0 < right", "note", None, advice, values=values)
