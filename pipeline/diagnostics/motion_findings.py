"""Findings on the motion of one log: units, sampling, rests, and what moves q without an input."""

from collections.abc import Sequence

import numpy as np

from ..device.device import Device
from ..scoring.wells import Wells
from ..signals.findings import Finding, Number, Severity
from ..signals.quality_gates import scale_suspicion
from . import limits
from .log_facts import LogFacts

ROUNDING = 1e-9
"""Range of q over its largest value up to which it is constant but for the rounding of its unit."""


def motion_findings(fact: LogFacts, plant: Device) -> list[Finding]:
    """The findings on the motion of a log."""
    findings = [*_ranges(fact, plant), _resolution(fact, plant), _rate(fact)]
    findings += [*_held(fact), *_wrapped(fact, plant), _rests(fact, plant)]
    if fact.drift is not None:
        unit = plant.displacement.symbol
        moved = abs(fact.drift) * float(np.ptp(fact.signals.t))
        numbers = {"drift": Number(fact.drift, f"{unit}/s"), "moved": Number(moved, unit)}
        findings.append(Finding("drift", "fair", fact.signals.name, "q", numbers))
    return findings


def starts(facts: Sequence[LogFacts]) -> list[Finding]:
    """The findings on logs that leave a rest though no input changes; none where that is seen once in all.

    No log of 16 prototypes has one; P1 to P3 have 2 to 5 in each log where one of their voltages is left out.
    """
    if sum(len(fact.starts) for fact in facts) < 2:
        return []
    return [
        Finding(
            "undriven_starts", "fair", fact.signals.name, "q",
            {
                "starts": Number(len(fact.starts)), "first": Number(fact.starts[0], "s"),
                "inputs": Number(len(fact.pushes)),
            },
        )
        for fact in facts
        if fact.starts
    ]  # fmt: skip


def _ranges(fact: LogFacts, plant: Device) -> list[Finding]:
    """Ranges of q and of the inputs against those that a device can have."""
    findings = [Finding("from_angle", "good", fact.signals.name, "q")] if plant.angle else []
    names = ("q", *(f"v{i + 1}" for i in range(fact.peaks.size)))
    spans = (fact.span, *fact.peaks.tolist())
    units = (plant.displacement.symbol, *plant.input_symbols)
    for name, span, unit in zip(names, spans, units, strict=True):
        allowed = plant.plausible_span(unit)
        times = scale_suspicion(span, allowed)
        still = name == "q" and span <= ROUNDING * float(np.nanmax(np.abs(fact.signals.q)))
        # A voltage too small may be one that is not used; if it pushes all the same, the coupling tells.
        judged = plant.joint and (still or (times is not None and (name == "q" or times > 1.0)))
        severity: Severity = "poor" if judged else "fair" if still or times is not None else "good"
        numbers = {"range": Number(span, unit)}
        if allowed is not None:
            numbers |= {"least": Number(allowed[0], unit), "most": Number(allowed[1], unit)}
        if times is not None:
            numbers["times"] = Number(times)
        code = "still" if still else "range"
        findings.append(Finding(code, severity, fact.signals.name, name, numbers, "scale" if judged else None))
    return findings


def _resolution(fact: LogFacts, plant: Device) -> Finding:
    log = fact.signals
    unit = plant.displacement.symbol
    numbers = {} if log.noise is None else {"noise": Number(log.noise, unit)}
    if log.resolution is None:
        return Finding("resolution", "good", log.name, "q", numbers)
    most = limits.RESOLUTION * fact.span
    numbers |= {"resolution": Number(log.resolution, unit), "most": Number(most, unit)}
    return Finding("resolution", "good" if log.resolution <= most else "fair", log.name, "q", numbers)


def _rate(fact: LogFacts) -> Finding:
    return Finding("sampling_rate", "good", fact.signals.name, "", {"rate": Number(1.0 / fact.signals.raw_step, "Hz")})


def _held(fact: LogFacts) -> list[Finding]:
    """A sensor or a bus that is slower than the recorder makes a staircase of the motion."""
    held = fact.signals.held
    if held < 2:
        return []
    numbers = {"held": Number(held), "rate": Number(1.0 / (held * fact.signals.raw_step), "Hz")}
    return [Finding("held", "fair", fact.signals.name, "q", numbers)]


def _wrapped(fact: LogFacts, plant: Device) -> list[Finding]:
    """An angle that jumps by a turn where it leaves the interval that it is kept in."""
    if plant.displacement.symbol != "rad" or round(fact.span / (2.0 * np.pi)) != 1:
        return []
    q = fact.signals.q
    jumps = int(np.count_nonzero(np.diff((np.abs(q[3:] - q[:-3]) > limits.WRAPPED * fact.span).astype(np.int8)) > 0))
    if not jumps:
        return []
    numbers = {"jumps": Number(jumps), "turn": Number(fact.span, "rad")}
    return [Finding("wrapped", "poor", fact.signals.name, "q", numbers, "wrapped")]


def _rests(fact: LogFacts, plant: Device) -> Finding:
    name = fact.signals.name
    unit = plant.displacement.symbol
    if not isinstance(fact.wells, Wells):
        return Finding("no_rests", "unseen", name, fact.wells.reason.partition(":")[0])
    numbers = {"left": Number(fact.wells.left, unit), "right": Number(fact.wells.right, unit)}
    about_zero = not plant.joint or fact.wells.left < 0.0 < fact.wells.right
    return Finding("rests", "good" if about_zero else "fair", name, "q", numbers)
