"""Findings on the inputs of one log: side, law, scale and level of each, whether they act apart, and late answers."""

import numpy as np

from ..device.device import Device
from ..device.parameters import NOMINAL
from ..numerics.arrays import FloatArray
from ..scoring.wells import Wells
from ..signals.findings import Finding, Number, Severity
from ..signals.noise import is_idle, noise_level
from ..signals.signal_quality import takes_both_signs, usual_span
from . import limits
from .log_facts import InputForce, LogFacts


def input_findings(fact: LogFacts, plant: Device) -> list[Finding]:
    """The findings on the inputs of a log."""
    findings = [
        _unseen_force(fact, i) if force is None else _force(fact, i, force, plant)
        for i, force in enumerate(fact.pushes)
    ]
    findings += [_noise(fact, i, plant) for i in range(len(fact.pushes))]
    findings += [*_correlated(fact, plant), *_laws(fact, plant)]
    if plant.joint:
        findings += [*_late(fact, plant), _field(fact, plant), *_rest_levels(fact, plant)]
        findings += [*_scale(fact, plant), *_sides(fact)]
    return findings


def _unseen_force(fact: LogFacts, i: int) -> Finding:
    """Of an input whose force the log does not show: as it is never on, or hardly ever changes."""
    v = fact.signals.v[:, i]
    subject = f"v{i + 1}"
    if np.ptp(v) > 0.0 and is_idle(v):
        return Finding("idle_input", "fair", fact.signals.name, subject)
    if fact.peaks[i] == 0.0:
        return Finding("never_on", "fair", fact.signals.name, subject)
    return Finding("hardly_changes", "unseen", fact.signals.name, subject)


def _force(fact: LogFacts, i: int, force: InputForce, plant: Device) -> Finding:
    """To which side an input pushes; how strongly depends on the motion, so a table has the side alone."""
    name = fact.signals.name
    numbers = {"push": Number(force.value, f"{plant.displacement.symbol}/s²")}
    if not force.sure:
        return Finding("unsure_push", "unseen", name, f"v{i + 1}", numbers)
    if not plant.joint:
        return Finding("push", "good", name, f"v{i + 1}", numbers)
    right = (force.value > 0.0) == (i == 0)  # v1 is of the left membrane, which pushes to the right
    return Finding("side", "good" if right else "poor", name, f"v{i + 1}", numbers, None if right else "sides")


def _noise(fact: LogFacts, i: int, plant: Device) -> Finding:
    """Noise of an input that is measured; a command has none, and an amplifier need not follow it."""
    v = fact.signals.v[:, i]
    noise = noise_level(v)
    if noise <= np.finfo(np.float32).eps * fact.peaks[i]:
        return Finding("command", "good", fact.signals.name, f"v{i + 1}")
    numbers = {"noise": Number(noise, plant.input_symbols[i])}
    return Finding("input_noise", "good", fact.signals.name, f"v{i + 1}", numbers)


def _late(fact: LogFacts, plant: Device) -> list[Finding]:
    """A joint that answers its inputs surely late, or before they change; another device may do so by its nature.

    The angle of a joint does too: voltages turn its tip before it moves.
    """
    most = limits.LATE * fact.sample_interval
    if plant.angle or abs(fact.late) < most:
        return []
    numbers = {"late": Number(fact.late, "s"), "most": Number(most, "s")}
    return [Finding("late_answer", "fair", fact.signals.name, "q", numbers)]


def _scale(fact: LogFacts, plant: Device) -> list[Finding]:
    """Mass and units: what they make of the coupling of a membrane, half the slope of its capacitance over q."""
    couplings = _couplings(fact)
    if not couplings:
        return []
    mass = NOMINAL.m if plant.known_mass is None else plant.known_mass
    allowed = limits.UNSTATED_RATIO if plant.known_mass is None else limits.RATIO
    ratio = max((mass * each / limits.DRAWN_COUPLING for each in couplings), key=lambda r: max(r, 1.0 / r))
    wrong = max(ratio, 1.0 / ratio) > allowed
    numbers = {
        "coupling": Number(ratio * limits.DRAWN_COUPLING, "N/V²"),
        "ratio": Number(ratio),
        "most": Number(allowed),
        "mass": Number(mass, "kg"),
    }
    subject = "drawn" if plant.known_mass is None else "stated"
    severity: Severity = "poor" if wrong else "good"
    return [Finding("coupling", severity, fact.signals.name, subject, numbers, "scale" if wrong else None)]


def _couplings(fact: LogFacts) -> list[float]:
    """Push over the squared peak of every input that surely pushes [m/s²/V²]."""
    return [
        abs(push.value) / peak**2
        for push, peak in zip(fact.pushes, fact.peaks.tolist(), strict=True)
        if push is not None and push.sure
    ]


def _sides(fact: LogFacts) -> list[Finding]:
    """Membranes of one joint couple about as strongly."""
    couplings = _couplings(fact)
    if len(couplings) < 2 or not isinstance(fact.wells, Wells):
        return []
    ratio = couplings[0] / couplings[1]
    alike = max(ratio, 1.0 / ratio) <= limits.SIDES
    numbers = {"ratio": Number(ratio), "most": Number(limits.SIDES)}
    return [Finding("coupling_ratio", "good" if alike else "fair", fact.signals.name, "", numbers)]


def _correlated(fact: LogFacts, plant: Device) -> list[Finding]:
    """Two inputs of which one says all that the other does."""
    if None in fact.pushes or len(fact.pushes) < 2:
        return []
    acting = plant.acting(fact.signals.v)
    correlation = float(np.asarray(np.corrcoef(acting[np.isfinite(acting).all(axis=1)].T))[0, 1])
    if abs(correlation) < limits.CORRELATED:
        return []
    numbers = {"correlation": Number(correlation), "most": Number(limits.CORRELATED)}
    return [Finding("correlated", "fair", fact.signals.name, "", numbers)]


def _field(fact: LogFacts, plant: Device) -> Finding:
    """The largest field in the undeformed film, at the larger voltage that three samples reach: noise alone is none."""
    largest = max(abs(end) for column in fact.signals.v.T for end in usual_span(column))
    field = largest / plant.film_thickness
    limit = plant.field_limit
    numbers = {
        "field": Number(field, "V/m"),
        "limit": Number(limit, "V/m"),
        "film": Number(plant.film_thickness, "m"),
    }
    of_units = not limit / limits.RATIO < field < limit * limits.RATIO and largest > 0.0
    code = "field_units" if of_units else "field"
    return Finding(code, "fair" if of_units or field > limits.FIELD * limit else "good", fact.signals.name, "", numbers)


def _rest_levels(fact: LogFacts, plant: Device) -> list[Finding]:
    """A joint's voltage of one sign whose lowest level is not zero; one of two signs may switch between them.

    What drives another device, as a fan, need never have been off, and an offset would bend the law of its square.
    """
    findings = []
    for i, (peak, unit) in enumerate(zip(fact.peaks.tolist(), plant.input_symbols, strict=True)):
        level = rest_level(fact.signals.v[:, i])
        most = limits.REST_LEVEL * peak
        if level is not None and abs(level) > most:
            numbers = {"level": Number(level, unit), "most": Number(most, unit)}
            findings.append(Finding("rest_level", "fair", fact.signals.name, f"v{i + 1}", numbers))
    return findings


def rest_level(v: FloatArray) -> float | None:
    """The lowest level at which an input of one sign rests for a tenth of the log; None where there is none.

    Parameters
    ----------
    v : FloatArray, shape (N,)
        The input, finite. Of a negative one its magnitude counts.
    """
    if takes_both_signs(float(np.min(v)), float(np.max(v))):
        return None
    sign = -1.0 if -np.min(v) > np.max(v) else 1.0
    low, level, high = np.quantile(sign * v, (0.01, 0.05, 0.1)).tolist()
    rests = high - low <= limits.REST_LEVEL * float(np.max(np.abs(v)))
    return sign * level if rests else None


def _laws(fact: LogFacts, plant: Device) -> list[Finding]:
    """Whether the inputs act as the settings say, by what each law leaves of the accelerations."""
    own = fact.unexplained
    other = fact.under_other_law
    if own is None or other is None:
        return []
    laws = ("squared", "linear") if plant.squared else ("linear", "squared")
    numbers = {f"left_by_{laws[0]}": Number(own), f"left_by_{laws[1]}": Number(other)}
    if fact.as_signed_monitor is not None and fact.as_signed_monitor < limits.OTHER_LAW * min(own, other):
        numbers["left_by_membranes"] = Number(fact.as_signed_monitor)
        return [Finding("signed_monitor", "fair", fact.signals.name, laws[1], numbers)]
    right = other >= limits.OTHER_LAW * own
    return [Finding("law", "good" if right else "fair", fact.signals.name, laws[1], numbers)]
