"""The sentences of findings: what was measured, and what to do; no other module words them."""

from collections.abc import Callable

from pipeline.diagnostics.findings import Finding, Number
from pipeline.si_prefix import moment, percent, quantity, significant

ADVICE_BY_MODEL = {"rbf-paper": "fewer basis functions ([identify] basis_functions), or richer training logs"}
"""Where basis functions do act in number, fewer of them are a remedy."""
RICHER = "richer training logs: longer, with pulses of more heights and lengths"
KEYS = {
    "gain_v1": "gain = {{ v1 = {} }}", "gain_v2": "gain = {{ v2 = {} }}", "gain_q": "gain = {{ q = {} }}",
    "zero_q": 'zero = "{}"', "delay": 'delay = "{}"', "clock": "clock = {}",
}  # fmt: skip
"""What is written at a log in `[logs]`, by quantity of the instruments."""


def sentences(finding: Finding) -> tuple[str, str]:
    """What was measured, without a full stop, and what to do.

    Parameters
    ----------
    finding : Finding
        Its code must be one of `CODES`.
    """
    return CODES[finding.code](finding)


def _value(finding: Finding, name: str) -> float:
    return finding.numbers[name].value


def _shown(number: Number) -> str:
    """A number with its unit and its ±; shares in percent."""
    if number.unit == "1":
        error = None if number.error is None else 100.0 * number.error
        return quantity(100.0 * number.value, "%", error)
    return quantity(number.value, number.unit, number.error)


def _generalisation(finding: Finding) -> tuple[str, str]:
    text = f"the error of {finding.subject} on the {finding.log} is {significant(_value(finding, 'ratio'), 2)} times "
    return f"{text}that on the training logs", ADVICE_BY_MODEL.get(finding.subject, RICHER)


def _another_device(finding: Finding) -> tuple[str, str]:
    text = (
        f"no instrument explains what is left of the {finding.log}: "
        f"{significant(_value(finding, 'residual_ratio'), 2)} times what the training logs leave"
    )
    return text, "see whether this log is of this device, or whether the device was changed in between"


def _exchanged(finding: Finding) -> tuple[str, str]:
    what = {"inputs": "v1 and v2 exchanged", "sign": "q counted to the other side"}.get(finding.subject, "both")
    both = "v1 and v2 exchanged and q counted to the other side" if what == "both" else what
    return f"the {finding.log} fits with {both}", "see to the channels of this log, or of the training logs"


def _instrument(finding: Finding) -> tuple[str, str]:
    number = finding.numbers["estimate"]
    size = _shown(Number(abs(number.value), number.unit, number.error))
    name = finding.subject.removeprefix("gain_")
    if finding.subject == "zero_q":
        text = f"the zero of q of the {finding.log} is {size} too {'high' if number.value > 0.0 else 'low'}"
    elif finding.subject == "delay":
        text = f"the voltages of the {finding.log} are recorded {size} {'late' if number.value > 0.0 else 'early'}"
    elif finding.subject == "clock":
        text = f"the clock of the {finding.log} runs {size} {'fast' if number.value > 0.0 else 'slow'}"
    else:
        text = f"{name} of the {finding.log} reads {size} {'high' if number.value > 0.0 else 'low'}"
    correction = finding.numbers["correction"]
    line = KEYS[finding.subject].format(correction_text(finding.subject, correction.value, correction.unit))
    mend = {"zero_q": "set the laser", "delay": "mend the recorder", "clock": "mend the recorder"}
    advice = f"`{line}` at that log in [logs], or {mend.get(finding.subject, 'mend the probe')}"
    return text, f"{advice}, unless the training logs are the wrong ones"


def _disagreement(finding: Finding) -> tuple[str, str]:
    number = finding.numbers["estimate"]
    size = _shown(Number(number.value, number.unit, number.error))
    name = {"zero_q": "the zero of q", "delay": "the delay of the inputs", "clock": "the clock"}.get(
        finding.subject, f"the reading of {finding.subject.removeprefix('gain_')}"
    )
    text = f"{name} differs by {size} between the {finding.log}"
    return text, "find out which of both logs is right, and correct the other one in [logs]"


def _unlike_training(finding: Finding) -> tuple[str, str]:
    text = f"the {finding.log} and the {finding.subject} are not of one device with equal channels"
    return text, "see to channels and wiring of both logs, and whether the device was changed in between"


def correction_text(name: str, value: float, displacement: str) -> str:
    """A correction as [logs] takes it: a factor, or a number with its unit, which is that of q for its zero."""
    unit = {"zero_q": displacement, "delay": "s"}.get(name)
    return f"{value:.5g}" if unit is None else quantity(value, unit).replace("−", "-")


def _extrapolation(finding: Finding) -> tuple[str, str]:
    share = percent(_value(finding, "share"))
    text = f"{share} of the {finding.log} lie in states (q, q̇) that no training sample was near"
    return text, "train on motions as large and as fast"


def _one_passage(finding: Finding) -> tuple[str, str]:
    share, when = percent(_value(finding, "share")), moment(_value(finding, "time"))
    text = f"one passage over the barrier at t = {when} makes {share} of the squared error on the {finding.log}"
    return text, "there a small error decides the well: judge the rest of the log by itself, or train on such passages"


CODES: dict[str, Callable[[Finding], tuple[str, str]]] = {
    "generalisation": _generalisation,
    "another_device": _another_device,
    "exchanged": _exchanged,
    "instrument": _instrument,
    "disagreement": _disagreement,
    "unlike_training": _unlike_training,
    "outside": _extrapolation,
    "one_passage": _one_passage,
}
"""By code."""
