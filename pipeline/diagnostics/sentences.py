"""The sentences of findings, with advice, and the refusal of data."""

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import Any

from ..errors import DataRefusedError
from ..settings.prototype import Gate, Quality
from ..signals.findings import Finding, Number, Remark
from ..units.quantity import counted, moment, percent, quantity, significant
from . import log_sentences

ADVICE_BY_MODEL = {"rbf-paper": "fewer basis functions ([identify] basis_functions), or richer training logs"}
"""Remedy for models in which the number of basis functions matters."""
RAILS = 'widen the sensor\'s range, or where the device does rest there set [ingest] rails = "keep"'
RICHER = "richer training logs: longer, with pulses of more heights and lengths"
MASKS = {
    "masked_without_target": (
        "sample without a target", "samples without a target",
        'keep the target within the sensor\'s sight, or where the device does rest there set [ingest] lost = "keep"',
    ),
    "masked_at_rails": ("sample at the ends of q's range", "samples at the ends of q's range", RAILS),
    "masked_spikes": ("spike", "spikes", ""),  # single samples: no row is lost to them alone
    "gaps_in_time": (
        "gap in the recording", "gaps in the recording", "repair the recorder, or record again what the gaps cut",
    ),
}  # fmt: skip
"""Causes of rows without a measurement, as ingest counts them: one, several, and what to do."""
KEYS = {
    "gain_v1": "gain = {{ v1 = {} }}", "gain_v2": "gain = {{ v2 = {} }}", "gain_q": "gain = {{ q = {} }}",
    "zero_q": 'zero = "{}"', "delay": 'delay = "{}"', "clock": "clock = {}",
}  # fmt: skip
"""Setting of a log in `[logs]` by quantity of the instruments."""
READINGS = {
    "gain_v1": "gain of v1",
    "gain_v2": "gain of v2",
    "zero_q": "zero of q",
    "gain_q": "gain of q",
}
"""Printed names of readings, where they differ from those in files."""


def sentences(finding: Finding) -> tuple[str, str]:
    """Measurement, without a full stop, and advice.

    Parameters
    ----------
    finding : Finding
        Its code must be one of `CODES`.
    """
    texts = CODES[finding.code]
    if not isinstance(texts, tuple):
        return texts(finding)
    statement, advice = map(finding.filled, texts)
    return statement, advice


def shown(number: Number) -> str:
    """A number with its unit and its ±; shares in percent."""
    if number.unit == "1":
        return quantity(100.0 * number.value, "%", None if number.error is None else 100.0 * number.error)
    return quantity(number.value, number.unit, number.error)


def _generalisation(finding: Finding) -> tuple[str, str]:
    text = "the error of {subject} on the {log} is {ratio:digits} times that on the training logs"
    return finding.filled(text), ADVICE_BY_MODEL.get(finding.subject, RICHER)


def _exchanged(finding: Finding) -> tuple[str, str]:
    what = {"inputs": "v1 and v2 exchanged", "sign": "q counted to the other side"}.get(
        finding.subject, "v1 and v2 exchanged and q counted to the other side"
    )
    return f"the {finding.log} fits with {what}", "see to the channels of this log, or of the training logs"


def _instrument(finding: Finding) -> tuple[str, str]:
    number = finding.numbers["estimate"]
    size = shown(Number(abs(number.value), number.unit, number.error))
    name = finding.subject.removeprefix("gain_")
    of_log, more, less, mend = {
        "zero_q": (f"the zero of q of the {finding.log} is {size} too", "high", "low", "set the laser"),
        "delay": (f"the voltages of the {finding.log} are recorded {size}", "late", "early", "mend the recorder"),
        "clock": (f"the clock of the {finding.log} runs {size}", "fast", "slow", "mend the recorder"),
    }.get(finding.subject, (f"{name} of the {finding.log} reads {size}", "high", "low", "mend the probe"))
    correction = finding.numbers["correction"]
    line = KEYS[finding.subject].format(correction_text(correction.value, correction.unit))
    return (
        f"{of_log} {more if number.value > 0.0 else less}",
        f"`{line}` at that log in [logs], or {mend}, unless the training logs are the wrong ones",
    )


def _disagreement(finding: Finding) -> tuple[str, str]:
    name = {"zero_q": "the zero of q", "delay": "the delay of the inputs", "clock": "the clock"}.get(
        finding.subject, f"the reading of {finding.subject.removeprefix('gain_')}"
    )
    return (
        f"{name} differs by {shown(finding.numbers['estimate'])} between the {finding.log}",
        "find out which of both logs is right, and correct the other one in [logs]",
    )


def unit_of(reading: str, displacement: str) -> str:
    """SI unit of an error of a reading, and of its correction; `displacement` is that of q."""
    return {"zero_q": displacement, "delay": "s"}.get(reading, "1")


def correction_text(value: float, unit: str) -> str:
    """A correction as [logs] takes it: a factor, or a number with its unit."""
    return f"{value:.5g}" if unit == "1" else quantity(value, unit).replace("−", "-")


def _switch_accuracy(finding: Finding) -> tuple[str, str]:
    share = finding.filled("{value:percent}") if finding.value("value") < 1.0 else "all"
    return (
        f"{share} of the pulses end in the well that was measured",
        "near the switching voltage the outcome is sensitive: train on pulses of that size",
    )


def _rival(finding: Finding) -> tuple[str, str]:
    best, _, own = finding.subject.partition(", ")
    text = f"{best} predicts the {{log}} with {{error:percent}}, where {own} diverged"
    if "own" in finding.numbers:
        text = f"{best} predicts the {{log}} surely better than {own}: {{error:percent}} for {{own:percent}}"
    return (
        finding.filled(text),
        f"take {best} for predictions (`--model {best}`), or help {own}: more and longer logs, or decide what is known "
        "of the device in [identify.structure] (force, damping, drag, gain, friction, drive)",
    )


def _divergence(finding: Finding) -> tuple[str, str]:
    places = ", ".join(f"{log} at t = {moment(number.value)}" for log, number in finding.numbers.items())
    return (
        f"the free run of {finding.subject} diverged: {places}",
        "see its last second under “Measured against models”; train on data that reach as far",
    )


def _ambiguous(finding: Finding) -> tuple[str, str]:
    count = f"{finding.value('open'):.0f}" if finding.value("open") else "none"
    return (
        f"{count} of {finding.value('outcomes'):.0f} outcomes after pulses are too close for the model to call",
        "do not trust the well after these pulses; train on pulses of that size and length",
    )


def _rails(finding: Finding) -> tuple[str, str]:
    text = finding.filled("{value:share} of the samples of q stay at its largest or smallest value")
    if finding.subject == "kept":
        return f'{text}, where it rests ([ingest] rails = "keep")', ""
    return text, RAILS


def _switches(finding: Finding) -> tuple[str, str]:
    advice = "record more pulses that snap it both ways"
    return (
        finding.filled("the training logs switch wells {value:.0f} times"),
        f"{advice}; `debist rig excite` designs a sequence" if finding.subject == "joint" else advice,
    )


def _coverage(finding: Finding) -> tuple[str, str]:
    samples = counted(int(finding.value("value")), "training sample")
    fills = ", `debist rig excite` fills them" if finding.subject == "joint" else ""
    return (
        finding.filled(f"the least visited of {{centres:.0f}} basis centres inside the range has {samples} around it"),
        f"excite the thin places (`debist inspect` names them{fills}); or fewer centres",
    )


def _noise(finding: Finding) -> tuple[str, str]:
    share = significant(100.0 * finding.value("share" if finding.subject == "steps" else "value"), 2)
    if finding.subject == "steps":
        text = f"q comes in steps of {{steps}}, {share} % of its range; its noise is below that"
        return finding.filled(text), "use the sensor's finer range"
    text = f"noise of q is {{noise}} RMS, {share} % of its range"
    return finding.filled(text), "average or shield the sensor, or raise alpha"


def _masked(finding: Finding) -> tuple[str, str]:
    causes = [(MASKS[cause], int(number.value)) for cause, number in finding.numbers.items() if cause in MASKS]
    named = " and ".join(f"{count} {several if count > 1 else single}" for (single, several, _), count in causes)
    advice = "; ".join(what for (_, _, what), _ in causes if what) or "repair the recorder"
    share = finding.value("value")
    if share:
        return f"{percent(share)} of the rows are masked, by {named or 'samples that are not finite'}", advice
    return f"{named} left out, and no row masked" if named else "no gaps", advice


def _measured_facts(finding: Finding) -> tuple[str, str]:
    if finding.severity == "good":
        which = "the one modelled fact that was measured too lies"
        if finding.value("count") != 1.0:
            which = "the {count:.0f} modelled facts that were measured too lie"
        return finding.filled(f"{which} within {{value:.1f}} standard deviations"), ""
    source, where = (
        ("free_run", "in the model's free runs") if "free_run" in finding.numbers else ("model", "by the model")
    )
    own, seen = (
        quantity(number.value, number.unit, number.error, abs(finding.value("measured")))
        for number in (finding.numbers[source], finding.numbers["measured"])
    )
    return (
        f"{finding.subject} is {own} {where}, but was measured as {seen} ({finding.value('events'):.0f} times)",
        "train on longer rests without voltage, and trust the measured value until then",
    )


CODES: dict[str, tuple[str, str] | Callable[[Finding], tuple[str, str]]] = {
    **log_sentences.CODES,
    "generalisation": _generalisation,
    "another_device": (
        "no instrument explains what is left of the {log}: {residual_ratio:digits} times what the training logs leave",
        "see whether this log is of this device, or whether the device was changed in between",
    ),
    "exchanged": _exchanged,
    "instrument": _instrument,
    "disagreement": _disagreement,
    "unlike_training": (
        "the {log} and the {subject} are not of one device with equal channels",
        "see to channels and wiring of both logs, and whether the device was changed in between",
    ),
    "outside": (
        "{value:share} of the samples of the {log} lie in states (q, q̇) that no training sample was near",
        "train on motions as large and as fast",
    ),
    "one_passage": (
        "one passage over the barrier at t = {time:moment} makes {share:percent} of the squared error on the {log}",
        "there a small error decides the well: judge the rest of the log by itself, or train on such passages",
    ),
    "nrmse": (
        "free-run NRMSE of q of {subject} is {value:percent} on the {log}",
        "look where residuals grow: at one switch (friction, delay) or throughout (alpha, centres)",
    ),
    "switch_accuracy": _switch_accuracy,
    "wells": (
        "modelled and measured rests differ by up to {value:percent} of the distance of the wells",
        "longer rests at zero voltage in both wells, for training",
    ),
    "validation": (
        "no validation log: errors are those of training",
        "add a log under [logs] validation: an error on the training data does not hold for new {subject}",
    ),
    "constant": (
        "a constant, its mean, predicts the {log} better than {subject}: {constant:percent} for {own:percent}",
        "do not use this model; see whether the inputs act linearly or by their squares ([plant] inputs), and whether "
        "a controller held the device where it is unstable: free runs of such a log part from it whatever the model",
    ),
    "rival": _rival,
    "divergence": _divergence,
    "converged": (
        "the fit of {subject} had not converged when it ended, so its error may be chance",
        "raise [identify] time_limit, or simplify the model (force, damping, gain, friction)",
    ),
    "ambiguous": _ambiguous,
    "rails": _rails,
    "no_wells": (
        "no two wells in the data: {subject}",
        "if the device is bistable, pulse both sides with rests of 1 s between",
    ),
    "switches": _switches,
    "extrapolation": (
        "{value:share} of the validation samples lie outside the range of the training data",
        "train on a log with the larger strokes and inputs",
    ),
    "coverage": _coverage,
    "noise": _noise,
    "masked": _masked,
    "measured_facts": _measured_facts,
}
"""Sentences by code: templates for `Finding.filled`, or functions."""


def judge(
    where: str,
    findings: Sequence[Finding],
    settings: Quality,
    prior: Collection[str] = (),
    decides: str = "the joint's equations",
    noted: Iterable[Remark] = (),
) -> list[str]:
    """The findings that do not refuse the data, as texts for the manifest, the terminal and the report.

    Parameters
    ----------
    where : str
        Name of the data, for the error.
    findings : sequence of Finding
        Findings against them.
    settings : Quality
        Settings with the accepted gates.
    prior : collection of str
        Gates of what the data need not show, because a model knows it beforehand.
    decides : str
        Part of the model that decides.
    noted : iterable of Remark
        Remarks from the reading of the data; those that nothing deals with may be the cause.

    Raises
    ------
    DataRefusedError
        A finding is not accepted; the text names all of them, what was noted, and the settings that would let them
        pass.
    """
    refused = [finding for finding in findings if finding.gate not in (*settings.accept, *prior)]
    if refused:
        reasons = "; ".join(
            [
                *(": ".join(sentences(finding)) for finding in refused),
                *(remark.text for remark in noted if not remark.dealt_with),
            ]
        )
        gates = (*settings.accept, *(finding.gate for finding in refused))
        names = ", ".join(f'"{gate}"' for gate in dict.fromkeys(gates))
        raise DataRefusedError(f"{where}: {reasons}. To use it knowingly, set [quality] accept = [{names}]")
    return [
        sentences(finding)[0]
        + (f" (accepted: {finding.gate})" if finding.gate in settings.accept else f"; there {decides} decide")
        for finding in findings
    ]


def accepted_settings(settings: Quality, gates: Iterable[Gate]) -> dict[str, Any]:
    """Settings of the gate in a recipe: empty where nothing is accepted there."""
    accepted = sorted(set(settings.accept) & set(gates))
    return {"quality": {"accept": accepted}} if accepted else {}
