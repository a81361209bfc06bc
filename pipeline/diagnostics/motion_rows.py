"""Rows on the motion of one log: units, sampling, rests, and what moves q without an input."""

from collections.abc import Sequence

import numpy as np

from ..scoring.wells import Wells
from ..settings.prototype import CheckGate
from ..signals.noise import below_resolution
from ..signals.quality_gates import plausible_span, scale_suspicion
from ..units.quantity import quantity
from . import limits
from .declared import Declared
from .log_facts import LogFacts
from .rows import CheckRow, State, in_si, short_quantity, times_text

ROUNDING = 1e-9
"""Range of q over its largest value up to which it is constant but for the rounding of its unit."""


def motion_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """The rows on the motion of a log."""
    rows = [*_unit_rows(fact, declared), _resolution_row(fact, declared), _rate_row(fact)]
    rows += [*_held_rows(fact), *_wrapped_rows(fact, declared), _rest_row(fact, declared)]
    if fact.drift is not None:
        rows.append(_drift_row(fact, fact.drift, declared))
    return rows


def start_rows(facts: Sequence[LogFacts]) -> list[CheckRow]:
    """The rows on logs that leave a rest though no input changes; none where that is seen once in all.

    No log of 16 prototypes has one; P1 to P3 have 2 to 5 in each log where one of their voltages is left out.
    """
    if sum(len(fact.starts) for fact in facts) < 2:
        return []
    return [_start_row(fact) for fact in facts if fact.starts]


def _unit_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    rows = []
    names = ("q", *(f"v{i + 1}" for i in range(fact.peaks.size)))
    spans = (fact.span, *fact.peaks.tolist())
    units = (declared.displacement, *declared.inputs)
    for name, span, unit in zip(names, spans, units, strict=True):
        circuit = declared.displacement == "V"  # which is built for whatever voltages it was built for
        allowed = None if circuit else plausible_span(unit, joint=declared.joint)
        limit = " … ".join(short_quantity(end, unit) for end in allowed) if allowed else ""
        wrong = None if circuit else scale_suspicion(span, unit, joint=declared.joint)
        still = name == "q" and span <= ROUNDING * float(np.nanmax(np.abs(fact.signals.q)))
        advice = ""
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
    log = fact.signals
    unit = declared.displacement
    noise = "" if log.noise is None else f"noise {quantity(log.noise, unit)}"
    if log.noise is not None and below_resolution(log.noise, log.resolution):
        noise = "noise below that"
    if log.resolution is None:
        return CheckRow(log.name, "resolution of q", "no steps", "", more=noise)
    fine = log.resolution <= limits.RESOLUTION * fact.span
    limit = f"≤ {short_quantity(limits.RESOLUTION * fact.span, unit)}"
    state: State = "ok" if fine else "note"
    advice = "" if fine else "velocities come in steps: use the sensor's finer range, or average before recording"
    values = in_si("resolution", unit, log.resolution) | in_si("noise", unit, log.noise)
    measured = quantity(log.resolution, unit)
    return CheckRow(log.name, "resolution of q", measured, limit, state, None, advice, noise, values)


def _rate_row(fact: LogFacts) -> CheckRow:
    rate = 1.0 / fact.signals.raw_step
    return CheckRow(fact.signals.name, "sampling rate", quantity(rate, "Hz"), "", values=in_si("rate", "Hz", rate))


def _held_rows(fact: LogFacts) -> list[CheckRow]:
    """A sensor or a bus that is slower than the recorder makes a staircase of the motion."""
    held = fact.signals.held
    if held < 2:
        return []
    rate = quantity(1.0 / (held * fact.signals.raw_step), "Hz")
    advice = (
        f"q has new values at {rate} only, late by half of that: record it as its sensor delivers it, or set [ingest] "
        "sample_interval no finer"
    )
    values = in_si("held", "1", held)
    return [
        CheckRow(fact.signals.name, "values of q held", f"for {held} samples", "", "note", None, advice, values=values)
    ]


def _drift_row(fact: LogFacts, drift: float, declared: Declared) -> CheckRow:
    unit = declared.displacement
    moved = quantity(abs(drift) * float(np.ptp(fact.signals.t)), unit)
    advice = (
        f"the places of rest move by {moved} over the log: let the sensor warm up, fix its mount, "
        "or take the drift off q"
    )
    values = in_si("drift", f"{unit}/s", drift)
    return CheckRow(
        fact.signals.name, "drift of the rests", quantity(drift, f"{unit}/s"), "", "note", None, advice, values=values
    )


def _start_row(fact: LogFacts) -> CheckRow:
    first = ", ".join(f"{start:.4g}" for start in fact.starts[:3])
    measured = f"{len(fact.starts)}, at {first}{' …' if len(fact.starts) > 3 else ''} s"
    missing = "find out what does"
    if len(fact.pushes) == 1:
        missing = "name the second input as v2 (in [channels], or as an argument)"
    advice = f"what moves q there is not among the inputs: {missing}"
    what = "leaves rest though no input changes"
    return CheckRow(
        fact.signals.name, what, measured, "", "note", None, advice, values=in_si("starts", "1", len(fact.starts))
    )


def _wrapped_rows(fact: LogFacts, declared: Declared) -> list[CheckRow]:
    """An angle that jumps by a turn where it leaves the interval that it is kept in."""
    if declared.displacement != "rad" or round(fact.span / (2.0 * np.pi)) != 1:
        return []
    q = fact.signals.q
    jumps = int(np.count_nonzero(np.diff((np.abs(q[3:] - q[:-3]) > limits.WRAPPED * fact.span).astype(np.int8)) > 0))
    if not jumps:
        return []
    advice = "unwrap it before it is logged or read (numpy.unwrap, MATLAB's unwrap): a turn is no motion of the device"
    measured = f"{jumps} by {short_quantity(fact.span, 'rad')}"
    return [CheckRow(fact.signals.name, "jumps of the angle", measured, "none", "wrong", "wrapped", advice)]


def _rest_row(fact: LogFacts, declared: Declared) -> CheckRow:
    name = fact.signals.name
    unit = declared.displacement
    if not isinstance(fact.wells, Wells):
        reason = fact.wells.reason.partition(":")[0]
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
