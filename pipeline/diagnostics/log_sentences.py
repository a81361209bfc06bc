"""The sentences of findings on logs: a row of the table for each, and what refuses a log."""

from collections.abc import Callable
from dataclasses import dataclass

from ..signals.findings import Finding
from ..signals.noise import below_resolution
from ..units.quantity import quantity, scale, short, significant
from .log_facts import FIELD

_SIDES = ("right (+)", "left (−)")
_ON_CHANGE = "; an input ({}) that was recorded only when it changed takes `on_change = true` in [channels]"
SHARES = {
    "masked": (
        "of the rows are masked (gaps, rails, spikes, lost target)",
        "record without gaps and within the sensor's range",
    ),
    "missing": ("of the samples are not finite", "repair the recorder"),
    "repeated": (
        "of the time stamps repeat the one before",
        "repair the clock; only if its stamps are too coarse and no row is missing, leave `time` out and set [ingest] "
        "sample_rate",
    ),
    "dropped": ("of the samples are missing one by one", "record slower"),
    "jitter": ("of the time step is its jitter (RMS)", "record by a hardware clock"),
    "rails": (
        "of the samples of q stay at its extremes",
        "what lay beyond was not measured: widen the sensor's range, or name another channel as q; if the device rests "
        'there, set [ingest] rails = "keep"',
    ),
    "hum": ("of the range of q is hum of {:g} Hz", "shield the sensor"),
}
"""Defect of a log in excess, and the remedy, by gate."""


@dataclass(frozen=True)
class ShownRow:
    """A finding in the table of the check: what was looked at, what was found, what it may be, what to do, and numbers
    beside it.
    """

    what: str
    found: str
    limit: str = ""
    advice: str = ""
    more: str = ""


def row(finding: Finding) -> ShownRow:
    """The row of a finding of the check; advice is of no meaning where it is good or unseen."""
    return ROWS[finding.code](finding)


def _shown(finding: Finding, name: str) -> str:
    return quantity(finding.value(name), finding.numbers[name].unit)


def _short(finding: Finding, name: str) -> str:
    """A round number with its unit."""
    number = finding.numbers[name]
    shown, factor = scale(number.unit, number.value)
    return f"{short(number.value * factor)} {shown}"


def _times(ratio: float) -> str:
    """Ratio in words: ``3 times``, ``1/3``."""
    return f"{significant(ratio, 2)} times" if ratio >= 1.0 else f"1/{significant(1.0 / ratio, 2)}"


def _range(finding: Finding) -> ShownRow:
    limit = f"{_short(finding, 'least')} … {_short(finding, 'most')}" if "most" in finding.numbers else ""
    advice = ""
    if finding.code == "still":
        advice = "q does not move: name the channel of its sensor, and see whether that has its target"
    elif "times" in finding.numbers:
        times = _times(finding.value("times"))
        advice = f"check the unit of {finding.subject} in [channels]: its numbers look {times} as large as a joint's"
    return ShownRow(f"range of {finding.subject}", _shown(finding, "range"), limit, advice)


def _from_angle(_: Finding) -> ShownRow:
    more = "by the kinematics of the joint at rest (plant.parameters); hybrid reads the angle itself"
    return ShownRow("origin of q", "the logged angle", more=more)


def _resolution(finding: Finding) -> ShownRow:
    noise = f"noise {_shown(finding, 'noise')}" if "noise" in finding.numbers else ""
    if "resolution" not in finding.numbers:
        return ShownRow("resolution of q", "no steps", more=noise)
    if noise and below_resolution(finding.value("noise"), finding.value("resolution")):
        noise = "noise below that"
    advice = "velocities come in steps: use the sensor's finer range, or average before recording"
    return ShownRow("resolution of q", _shown(finding, "resolution"), f"≤ {_short(finding, 'most')}", advice, noise)


def _held(finding: Finding) -> ShownRow:
    advice = (
        f"q has new values at {_shown(finding, 'rate')} only, late by half of that: record it as its sensor delivers "
        "it, or set [ingest] sample_interval no finer"
    )
    return ShownRow("values of q held", f"for {finding.value('held'):.0f} samples", advice=advice)


def _drift(finding: Finding) -> ShownRow:
    advice = (
        f"the places of rest move by {_shown(finding, 'moved')} over the log: let the sensor warm up, fix its mount, "
        "or take the drift off q"
    )
    return ShownRow("drift of the rests", _shown(finding, "drift"), advice=advice)


def _undriven_starts(finding: Finding) -> ShownRow:
    starts = f"{finding.value('starts'):.0f}, the first at {finding.value('first'):.4g} s"
    missing = "find out what does"
    if finding.value("inputs") == 1:
        missing = "name the second input as v2 (in [channels], or as an argument)"
    advice = f"what moves q there is not among the inputs: {missing}"
    return ShownRow("leaves rest though no input changes", starts, advice=advice)


def _wrapped(finding: Finding) -> ShownRow:
    advice = "unwrap it before it is logged or read (numpy.unwrap, MATLAB's unwrap): a turn is no motion of the device"
    jumps = f"{finding.value('jumps'):.0f} by {_short(finding, 'turn')}"
    return ShownRow("jumps of the angle", jumps, "none", advice)


def _rests(finding: Finding) -> ShownRow:
    places = f"{_shown(finding, 'left')}, {_shown(finding, 'right')}"
    if finding.severity == "good":
        return ShownRow("rests", places)
    unit = finding.numbers["left"].unit
    middle = quantity(-0.5 * (finding.value("left") + finding.value("right")), unit)
    advice = (
        "both wells are on one side of zero, where a joint, its parameter set and its mirror plane have the middle: "
        f"zero the sensor, or give `offset` in [channels] q (about {middle})"
    )
    return ShownRow("rests", places, "left < 0 < right", advice)


def _unseen_direction(finding: Finding) -> ShownRow:
    """Row of an input whose force a log does not show."""
    name = finding.subject
    reasons = {"idle_input": "nothing but noise", "never_on": "never on", "hardly_changes": "hardly ever changes"}
    advice = "name the channel that drives the device, or leave it out for a device with one input"
    if finding.code == "idle_input":
        advice = f"where no training log drives {name}, leave it out of [channels]: nothing is known of its gain"
    return ShownRow(f"direction of {name}", reasons[finding.code], advice=advice)


def _direction(finding: Finding) -> ShownRow:
    what = f"direction of {finding.subject}"
    if finding.code == "unsure_push":
        return ShownRow(what, "not sure")
    side = _SIDES[0] if finding.value("push") > 0.0 else _SIDES[1]
    if finding.code == "push":
        return ShownRow(what, side)
    advice = (
        "v1 is the left membrane and pushes q to the right, v2 to the left: swap v1 and v2 in [channels], or give q "
        "scale = -1 there; only if this device is wired the other way round, accept it"
    )
    return ShownRow(what, side, _SIDES[0] if finding.subject == "v1" else _SIDES[1], advice)


def _input_noise(finding: Finding) -> ShownRow:
    what = f"noise of {finding.subject}"
    if finding.code == "command":
        return ShownRow(
            what, "none: a command?", more="a measurement has noise; an amplifier need not follow a command"
        )
    return ShownRow(what, _shown(finding, "noise"))


def _late_answer(finding: Finding) -> ShownRow:
    number = finding.numbers["late"]
    shown, factor = scale("s", number.value)
    later = number.value > 0.0
    advice = (
        "q moves before its inputs: if it is the angle of a joint, give it in deg or rad; "
        "else start both recorders by one trigger"
    )
    if later:
        advice = (
            "start both recorders by one trigger; if the sensor of q averages over a window, give that as `average` in "
            "[channels] q; if the inputs do act late (a filter, a slow drive, electrodes that charge slowly), hybrid "
            'estimates by how much, and rbf with drive = "lag" or "delay" in [identify.structure]'
        )
    delay = f"about {short(abs(number.value) * factor)} {shown} {'late' if later else 'early'}"
    return ShownRow("answer of q", delay, f"± {_short(finding, 'most')}", advice)


def _coupling(finding: Finding) -> ShownRow:
    ratio = finding.value("ratio")
    most = finding.value("most")
    mass = finding.value("mass")
    what = f"coupling if of {1e3 * mass:g} g"
    off = max(ratio, 1.0 / ratio)
    small, short, large = ("small", "short", "large") if ratio > 1.0 else ("large", "long", "small")
    root, most_off = significant(off**0.5, 2), significant(off, 2)
    of_all = f"v1 and v2 ({root} times too {small} do that), of time ({root} times too {short}), of q"
    advice = f"check the units of {of_all} ({most_off} times too {large})"
    if finding.subject == "stated":
        what = f"coupling with {quantity(1e3 * mass, 'g') if mass < 1.0 else f'{significant(mass)} kg'}"
        advice = f"check the units of {of_all} and of plant.mass ({most_off} times too {large})"
    coupling = f"{significant(ratio, 2)} × as drawn"
    advice = f"that is {_times(ratio)} the coupling of the joint as drawn: {advice}"
    return ShownRow(what, coupling, f"{1.0 / most:.2g} … {most:g}", advice)


def _coupling_ratio(finding: Finding) -> ShownRow:
    ratio = finding.value("ratio")
    off = max(ratio, 1.0 / ratio)
    advice = (
        f"voltages wrong by {significant(off**0.5, 2)} on one side do that: check the unit and `scale` of both "
        "channels, and the ratio of both probes"
    )
    most = f"{finding.value('most'):g}"
    return ShownRow("coupling of v1 over v2", significant(ratio, 2), f"1/{most} … {most}", advice)


def _correlated(finding: Finding) -> ShownRow:
    advice = (
        "v1 and v2 go together all the time, so their effects cannot be separated: drive them apart, or leave v2 out"
    )
    correlation = f"correlation {finding.value('correlation'):.4f}"
    return ShownRow("v2 beside v1", correlation, f"< {finding.value('most'):g}", advice)


def _field(finding: Finding) -> ShownRow:
    film = _shown(finding, "film")
    limit = finding.value("limit")
    advice = f"a film of {film} may break down: lower the voltage, or give film_thickness and field_limit in [plant]"
    if finding.code == "field_units":
        advice = f"check the units of plant.film_thickness ({film}) and plant.field_limit ({quantity(limit, 'V/m')})"
    most = f"≤ {significant(1e-6 * limit)} (+{100.0 * (FIELD - 1.0):.0f} %) V/µm"
    return ShownRow("largest field", f"{significant(1e-6 * finding.value('field'))} V/µm", most, advice)


def _rest_level(finding: Finding) -> ShownRow:
    name = finding.subject
    level = finding.numbers["level"]
    advice = (
        f"{name} never returns to zero: if its drive was off at some time, that is the probe's error; add "
        f"{quantity(-level.value, level.unit)} to its `offset` in [channels]"
    )
    return ShownRow(f"rest level of {name}", _shown(finding, "level"), f"≤ {_short(finding, 'most')}", advice)


def _input_action(finding: Finding) -> ShownRow:
    other = finding.subject
    own = "linear" if other == "squared" else "squared"
    share = {name: significant(100.0 * number.value, 2) for name, number in finding.numbers.items()}
    residuals = f"{share[f'left_by_{own}']} % ({other} {share[f'left_by_{other}']} %)"
    advice = f'they explain more so: set inputs = "{other}" (in [plant], or as an argument)'
    if finding.code == "signed_monitor":
        residuals += f", two membranes {share['left_by_membranes']} %"
        advice = (
            'it looks like the signed monitor of two membranes: give it to v1 with part = "positive" and to v2 with '
            'part = "negative", and set inputs = "squared" in [plant]'
        )
    return ShownRow("residual of the fit", residuals, advice=advice)


def _shared_recording(finding: Finding) -> ShownRow:
    advice = "what both hold counts twice in fits and scores: leave one of them out, or cut it"
    return ShownRow(f"shared with {finding.subject}", shared_spans(finding), "none", advice)


def shared_spans(finding: Finding) -> str:
    """The spans that two logs share, that in the log of the finding first."""
    own, other = (
        f"{finding.value(f'{log}start'):.4g} to {finding.value(f'{log}stop'):.4g} s" for log in ("", "other_")
    )
    return f"{own} is {other} of it" if own != other else own


ROWS: dict[str, Callable[[Finding], ShownRow]] = {
    "range": _range,
    "from_angle": _from_angle,
    "still": _range,
    "resolution": _resolution,
    "sampling_rate": lambda finding: ShownRow("sampling rate", _shown(finding, "rate")),
    "held": _held,
    "drift": _drift,
    "undriven_starts": _undriven_starts,
    "wrapped": _wrapped,
    "rests": _rests,
    "no_rests": lambda finding: ShownRow("rests", finding.subject),
    "idle_input": _unseen_direction,
    "never_on": _unseen_direction,
    "hardly_changes": _unseen_direction,
    "unsure_push": _direction,
    "push": _direction,
    "side": _direction,
    "command": _input_noise,
    "input_noise": _input_noise,
    "late_answer": _late_answer,
    "coupling": _coupling,
    "coupling_ratio": _coupling_ratio,
    "correlated": _correlated,
    "field": _field,
    "field_units": _field,
    "rest_level": _rest_level,
    "law": _input_action,
    "signed_monitor": _input_action,
    "shared_recording": _shared_recording,
}
"""Rows of the check by code."""


def of_row(finding: Finding) -> tuple[str, str]:
    """Log, numbers and limit of a finding of the check in one line, and what to do."""
    made = row(finding)
    return line(finding.log, made.what, made.found, made.more, made.limit), made.advice


def line(log: str, what: str, found: str, more: str, limit: str) -> str:
    """Log, numbers and limit in one line.

    Parameters
    ----------
    log : str
        Name of the log.
    what : str
        Subject of the check.
    found : str
        Its numbers.
    more : str
        Further numbers; may be empty.
    limit : str
        The limit.
    """
    numbers = "; ".join(filter(None, (found, more)))
    return f"{log}: {what}: {numbers}" + (f" (limit: {limit})" if limit else "")


def _share(finding: Finding) -> tuple[str, str]:
    what, advice = SHARES[str(finding.gate)]
    if finding.gate == "hum":
        what = what.format(finding.value("frequency"))
    share = 100.0 * finding.value("share")
    few = [name for name in finding.numbers if name.startswith("v")]
    text = f"{share:.3g} % {what} (at most {100.0 * finding.value('most'):g} %)"
    return text, advice + (_ON_CHANGE.format(", ".join(few)) if few else "")


def _signal_missing(finding: Finding) -> tuple[str, str]:
    share = 100.0 * finding.value("share")
    text = f"{finding.subject} is missing for {share:.3g} % of the log (at most {100.0 * finding.value('most'):g} %)"
    advice = "repair the recorder, or cut the log where the signal ends"
    return text, advice + (_ON_CHANGE.format(finding.subject) if finding.value("not_finite") else "")


def _coarse_input(finding: Finding) -> tuple[str, str]:
    interval = finding.value("interval")
    text = f"{finding.subject} has one sample every {finding.value('step'):.4g} s, but [ingest] sample_interval is "
    advice = "record it as finely as q, or set a sample_interval as long" + _ON_CHANGE.format(finding.subject)
    return f"{text}{interval:g} s", advice


def _fast_motion(finding: Finding) -> tuple[str, str]:
    half = finding.value("half")
    interval = finding.value("interval")
    text = f"half of the power of q lies above {half:.3g} Hz, which decimation to [ingest] sample_interval = "
    return (
        f"{text}{interval:g} s takes away",
        f"set sample_interval = {finding.value('advised'):g}, or correct the unit of time",
    )


def _coarse_log(finding: Finding) -> tuple[str, str]:
    step = finding.value("step")
    lasts = finding.value("lasts")
    text = f"one sample every {step:.4g} s for {lasts:.6g} s, by the settings, but [ingest] sample_interval is "
    text += f"{finding.value('interval'):g} s (at most {finding.value('most'):g} intervals a sample)"
    advice = "correct the unit of time in [channels] (ms is not s) or the sample_rate (in Hz), or set a sample_interval"
    return text, f"{advice} as long as the log's step"


def _other_rate(finding: Finding) -> tuple[str, str]:
    stated = [f"{name} states {number.value:.6g} Hz" for name, number in finding.numbers.items() if name != "settings"]
    return (
        f"in the log {' and '.join(stated)}, but [ingest] sample_rate is {finding.value('settings'):g} Hz",
        "correct sample_rate, or where the log means another rate keep it",
    )


def _idle(finding: Finding) -> tuple[str, str]:
    return "the displacement shows nothing but noise: no excitation", "drive the device through its whole stroke"


def _undriven(finding: Finding) -> tuple[str, str]:
    return (
        f"input {finding.subject} never changes by more than its noise: nothing is known of its gain",
        f"drive it, or leave it out of [channels] ({finding.subject})",
    )


def _visits(finding: Finding) -> tuple[str, str]:
    visits = f"{finding.value('visits'):.0f} of at least {finding.value('least'):.0f} training samples"
    return (
        f"the basis centre at q = {_shown(finding, 'place')} has {visits}",
        f"excite that place, or set fewer than {finding.value('centres'):.0f} [identify] basis_functions",
    )


def _rank(finding: Finding) -> tuple[str, str]:
    condition = f"condition number {finding.value('condition'):.3g} (at most {finding.value('most'):g})"
    return (
        f"the regressor's columns cannot be separated: {condition}, {finding.value('silent'):.0f} zero",
        "vary the inputs independently",
    )


def _one_well(finding: Finding) -> tuple[str, str]:
    return (
        "only one well is visited: of the other half of every curve the data say nothing",
        "add pulses that snap the joint to the other side (`debist rig excite`)",
    )


CODES: dict[str, Callable[[Finding], tuple[str, str]]] = {
    **dict.fromkeys(ROWS, of_row),
    **dict.fromkeys([f"{gate}_share" for gate in SHARES], _share),
    "signal_missing": _signal_missing,
    "coarse_input": _coarse_input,
    "fast_motion": _fast_motion,
    "coarse_log": _coarse_log,
    "other_rate": _other_rate,
    "idle": _idle,
    "undriven": _undriven,
    "visits": _visits,
    "rank": _rank,
    "one_well": _one_well,
}
"""Sentences by code."""
