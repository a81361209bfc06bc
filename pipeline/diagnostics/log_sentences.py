"""The sentences of findings on logs: rows of the check's table, and refusals."""

from collections.abc import Callable
from dataclasses import astuple, dataclass

from ..signals.findings import Finding, Number
from ..signals.noise import below_resolution
from ..units.quantity import quantity, significant
from .log_facts import FIELD

_SIDES = ("right (+)", "left (−)")
_ON_CHANGE = "; an input ({}) that was recorded only when it changed takes `on_change = true` in [channels]"
_NAME_DRIVEN = "name the channel that drives the device, or leave it out for a device with one input"
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
    "hum": ("of the range of q is hum of {frequency:g} Hz", "shield the sensor"),
}
"""Defect of a log in excess, and the remedy, by gate."""


@dataclass(frozen=True)
class ShownRow:
    """A finding in the table of the check: subject, numbers, limit, advice, and further numbers."""

    what: str
    found: str
    limit: str = ""
    advice: str = ""
    more: str = ""


def row(finding: Finding) -> ShownRow:
    """The row of a finding of the check; advice is of no meaning where it is good or unseen."""
    shown = ROWS[finding.code]
    return ShownRow(*map(finding.filled, astuple(shown))) if isinstance(shown, ShownRow) else shown(finding)


def _times(ratio: float) -> str:
    """Ratio in words: ``3 times``, ``1/3``."""
    return f"{significant(ratio, 2)} times" if ratio >= 1.0 else f"1/{significant(1.0 / ratio, 2)}"


def _range(finding: Finding) -> ShownRow:
    limit = finding.filled("{least:short} … {most:short}") if "most" in finding.numbers else ""
    advice = ""
    if finding.code == "still":
        advice = "q does not move: name the channel of its sensor, and see whether that has its target"
    elif "times" in finding.numbers:
        advice = (
            f"check the unit of {finding.subject} in [channels]: its numbers look {_times(finding.value('times'))} as "
            "large as a joint's"
        )
    return ShownRow(f"range of {finding.subject}", finding.filled("{range}"), limit, advice)


def _resolution(finding: Finding) -> ShownRow:
    noise = finding.filled("noise {noise}") if "noise" in finding.numbers else ""
    if "resolution" not in finding.numbers:
        return ShownRow("resolution of q", "no steps", more=noise)
    if noise and below_resolution(finding.value("noise"), finding.value("resolution")):
        noise = "noise below that"
    return ShownRow(
        "resolution of q", finding.filled("{resolution}"), finding.filled("≤ {most:short}"),
        "velocities come in steps: use the sensor's finer range, or average before recording", noise,
    )  # fmt: skip


def _undriven_starts(finding: Finding) -> ShownRow:
    second = "name the second input as v2 (in [channels], or as an argument)"
    mend = second if finding.value("inputs") == 1 else "find out what does"
    return ShownRow(
        "leaves rest though no input changes",
        finding.filled("{starts:.0f}, the first at {first:.4g} s"),
        advice=f"what moves q there is not among the inputs: {mend}",
    )


def _rests(finding: Finding) -> ShownRow:
    places = finding.filled("{left}, {right}")
    if finding.severity == "good":
        return ShownRow("rests", places)
    middle = quantity(-0.5 * (finding.value("left") + finding.value("right")), finding.numbers["left"].unit)
    return ShownRow(
        "rests", places, "left < 0 < right",
        "both wells are on one side of zero, where a joint, its parameter set and its mirror plane have the middle: "
        f"zero the sensor, or give `offset` in [channels] q (about {middle})",
    )  # fmt: skip


def _direction(finding: Finding) -> ShownRow:
    what = f"direction of {finding.subject}"
    side = _SIDES[0] if finding.value("push") > 0.0 else _SIDES[1]
    if finding.code == "push":
        return ShownRow(what, side)
    return ShownRow(
        what, side, _SIDES[0] if finding.subject == "v1" else _SIDES[1],
        "v1 is the left membrane and pushes q to the right, v2 to the left: swap v1 and v2 in [channels], or give q "
        "scale = -1 there; only if this device is wired the other way round, accept it",
    )  # fmt: skip


def _late_answer(finding: Finding) -> ShownRow:
    later = finding.value("late") > 0.0
    advice = (
        "start both recorders by one trigger; if the sensor of q averages over a window, give that as `average` "
        "in [channels] q; if the inputs do act late (a filter, a slow drive, electrodes that charge slowly), hybrid "
        'estimates by how much, and rbf with drive = "lag" or "delay" in [identify.structure]'
        if later
        else "q moves before its inputs: if it is the angle of a joint, give it in deg or rad; else start both "
        "recorders by one trigger"
    )
    delay = f"about {Number(abs(finding.value('late')), 's'):short} {'late' if later else 'early'}"
    return ShownRow("answer of q", delay, finding.filled("± {most:short}"), advice)


def _coupling(finding: Finding) -> ShownRow:
    ratio = finding.value("ratio")
    most = finding.value("most")
    mass = finding.value("mass")
    what = f"coupling if of {1e3 * mass:g} g"
    off = max(ratio, 1.0 / ratio)
    small, short, large = ("small", "short", "large") if ratio > 1.0 else ("large", "long", "small")
    root = significant(off**0.5, 2)
    of_all = f"v1 and v2 ({root} times too {small} do that), of time ({root} times too {short}), of q"
    if finding.subject == "stated":
        what = f"coupling with {quantity(1e3 * mass, 'g') if mass < 1.0 else f'{significant(mass)} kg'}"
        of_all += " and of plant.mass"
    return ShownRow(
        what, f"{significant(ratio, 2)} × as drawn", f"{1.0 / most:.2g} … {most:g}",
        f"that is {_times(ratio)} the coupling of the joint as drawn: check the units of {of_all} "
        f"({significant(off, 2)} times too {large})",
    )  # fmt: skip


def _coupling_ratio(finding: Finding) -> ShownRow:
    ratio = finding.value("ratio")
    return ShownRow(
        "coupling of v1 over v2", significant(ratio, 2), finding.filled("1/{most:g} … {most:g}"),
        f"voltages wrong by {significant(max(ratio, 1.0 / ratio) ** 0.5, 2)} on one side do that: check the unit and "
        "`scale` of both channels, and the ratio of both probes",
    )  # fmt: skip


def _field(finding: Finding) -> ShownRow:
    advice = "a film of {film} may break down: lower the voltage, or give film_thickness and field_limit in [plant]"
    if finding.code == "field_units":
        advice = "check the units of plant.film_thickness ({film}) and plant.field_limit ({limit})"
    most = f"≤ {significant(1e-6 * finding.value('limit'))} (+{100.0 * (FIELD - 1.0):.0f} %) V/µm"
    return ShownRow("largest field", f"{significant(1e-6 * finding.value('field'))} V/µm", most, finding.filled(advice))


def _rest_level(finding: Finding) -> ShownRow:
    level = finding.numbers["level"]
    return ShownRow(
        f"rest level of {finding.subject}", f"{level}", finding.filled("≤ {most:short}"),
        f"{finding.subject} never returns to zero: if its drive was off at some time, that is the probe's error; add "
        f"{quantity(-level.value, level.unit)} to its `offset` in [channels]",
    )  # fmt: skip


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
    return ShownRow(
        f"shared with {finding.subject}", shared_spans(finding), "none",
        "what both hold counts twice in fits and scores: leave one of them out, or cut it",
    )  # fmt: skip


def shared_spans(finding: Finding) -> str:
    """The spans that two logs share, that in the log of the finding first."""
    own, other = (
        f"{finding.value(f'{log}start'):.4g} to {finding.value(f'{log}stop'):.4g} s" for log in ("", "other_")
    )
    return f"{own} is {other} of it" if own != other else own


ROWS: dict[str, ShownRow | Callable[[Finding], ShownRow]] = {
    "range": _range,
    "from_angle": ShownRow(
        "origin of q", "the logged angle",
        more="by the kinematics of the joint at rest (plant.parameters); hybrid reads the angle itself",
    ),
    "still": _range,
    "resolution": _resolution,
    "sampling_rate": ShownRow("sampling rate", "{rate}"),
    "held": ShownRow(
        "values of q held", "for {held:.0f} samples",
        advice="q has new values at {rate} only, late by half of that: record it as its sensor delivers it, or set "
        "[ingest] sample_interval no finer",
    ),
    "drift": ShownRow(
        "drift of the rests", "{drift}",
        advice="the places of rest move by {moved} over the log: let the sensor warm up, fix its mount, or take the "
        "drift off q",
    ),
    "undriven_starts": _undriven_starts,
    "wrapped": ShownRow(
        "jumps of the angle", "{jumps:.0f} by {turn:short}", "none",
        "unwrap it before it is logged or read (numpy.unwrap, MATLAB's unwrap): a turn is no motion of the device",
    ),
    "rests": _rests,
    "no_rests": ShownRow("rests", "{subject}"),
    "idle_input": ShownRow(
        "direction of {subject}", "nothing but noise",
        advice="where no training log drives {subject}, leave it out of [channels]: nothing is known of its gain",
    ),
    "never_on": ShownRow("direction of {subject}", "never on", advice=_NAME_DRIVEN),
    "hardly_changes": ShownRow("direction of {subject}", "hardly ever changes", advice=_NAME_DRIVEN),
    "unsure_push": ShownRow("direction of {subject}", "not sure"),
    "push": _direction,
    "side": _direction,
    "command": ShownRow(
        "noise of {subject}", "none: a command?",
        more="a measurement has noise; an amplifier need not follow a command",
    ),
    "input_noise": ShownRow("noise of {subject}", "{noise}"),
    "late_answer": _late_answer,
    "coupling": _coupling,
    "coupling_ratio": _coupling_ratio,
    "correlated": ShownRow(
        "v2 beside v1", "correlation {correlation:.4f}", "< {most:g}",
        "v1 and v2 go together all the time, so their effects cannot be separated: drive them apart, or leave v2 out",
    ),
    "field": _field,
    "field_units": _field,
    "rest_level": _rest_level,
    "law": _input_action,
    "signed_monitor": _input_action,
    "shared_recording": _shared_recording,
}  # fmt: skip
"""Rows of the check by code: templates for `Finding.filled`, or functions."""


def of_row(finding: Finding) -> tuple[str, str]:
    """Log, numbers and limit of a finding of the check in one line, and the advice."""
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
    return f"{log}: {what}: {'; '.join(filter(None, (found, more)))}" + (f" (limit: {limit})" if limit else "")


def _share(finding: Finding) -> tuple[str, str]:
    what, advice = SHARES[str(finding.gate)]
    few = [name for name in finding.numbers if name.startswith("v")]
    text = (
        f"{100.0 * finding.value('share'):.3g} % {finding.filled(what)} (at most {100.0 * finding.value('most'):g} %)"
    )
    return text, advice + (_ON_CHANGE.format(", ".join(few)) if few else "")


def _signal_missing(finding: Finding) -> tuple[str, str]:
    share, most = (100.0 * finding.value(name) for name in ("share", "most"))
    advice = "repair the recorder, or cut the log where the signal ends"
    return (
        f"{finding.subject} is missing for {share:.3g} % of the log (at most {most:g} %)",
        advice + (_ON_CHANGE.format(finding.subject) if finding.value("not_finite") else ""),
    )


def _other_rate(finding: Finding) -> tuple[str, str]:
    stated = [f"{name} states {number.value:.6g} Hz" for name, number in finding.numbers.items() if name != "settings"]
    return (
        f"in the log {' and '.join(stated)}, but [ingest] sample_rate is {finding.value('settings'):g} Hz",
        "correct sample_rate, or where the log means another rate keep it",
    )


CODES: dict[str, tuple[str, str] | Callable[[Finding], tuple[str, str]]] = {
    **dict.fromkeys(ROWS, of_row),
    **dict.fromkeys([f"{gate}_share" for gate in SHARES], _share),
    "signal_missing": _signal_missing,
    "coarse_input": (
        "{subject} has one sample every {step:.4g} s, but [ingest] sample_interval is {interval:g} s",
        "record it as finely as q, or set a sample_interval as long" + _ON_CHANGE.format("{subject}"),
    ),
    "fast_motion": (
        "half of the power of q lies above {half:.3g} Hz, which decimation to [ingest] sample_interval = "
        "{interval:g} s takes away",
        "set sample_interval = {advised:g}, or correct the unit of time",
    ),
    "coarse_log": (
        "one sample every {step:.4g} s for {lasts:.6g} s, by the settings, but [ingest] sample_interval is "
        "{interval:g} s (at most {most:g} intervals a sample)",
        "correct the unit of time in [channels] (ms is not s) or the sample_rate (in Hz), or set a sample_interval as "
        "long as the log's step",
    ),
    "other_rate": _other_rate,
    "idle": (
        "the displacement shows nothing but noise: no excitation",
        "drive the device through its whole stroke",
    ),
    "undriven": (
        "input {subject} never changes by more than its noise: nothing is known of its gain",
        "drive it, or leave it out of [channels] ({subject})",
    ),
    "visits": (
        "the basis centre at q = {place} has {visits:.0f} of at least {least:.0f} training samples",
        "excite that place, or set fewer than {centres:.0f} [identify] basis_functions",
    ),
    "rank": (
        "the regressor's columns cannot be separated: condition number {condition:.3g} (at most {most:g}), "
        "{silent:.0f} columns are zero",
        "vary the inputs independently",
    ),
    "one_well": (
        "only one well is visited: of the other half of every curve the data say nothing",
        "add pulses that snap the joint to the other side (`debist rig excite`)",
    ),
}
"""Sentences by code: templates for `Finding.filled`, or functions."""
