"""Grades: the judged numbers, the thresholds of fair and poor, and their reasons."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

from ..signals.findings import Finding, Number, Severity
from .sentences import sentences

OF_WELLS = ("switches", "switch_accuracy", "ambiguous", "wells")
"""Thresholds that say nothing of a device without two wells."""


@dataclass(frozen=True)
class Threshold:
    """Up to `good` a number is good, up to `fair` fair, beyond it poor; the other way round if `more_is_better`."""

    good: float
    fair: float
    reason: str
    more_is_better: bool = False

    def grade(self, value: float) -> Severity:
        """The grade of a value."""
        sign = -1.0 if self.more_is_better else 1.0
        return "good" if sign * value <= sign * self.good else "fair" if sign * value <= sign * self.fair else "poor"


THRESHOLDS = {
    "masked": Threshold(0.01, 0.1, "every gap costs two filter lengths of rows, and a free run must pass it unchecked"),
    "noise": Threshold(1e-3, 1e-2, "noise of 0.1 % of the range is a twentieth of the paper's model error (2.1 %)"),
    "rails": Threshold(1e-3, 1e-2, "samples at a sensor's rail are no measurement, and bend the curves there"),
    "switches": Threshold(10, 4, "only snaps, of 0.1 s each, show the force between the wells", True),
    "coverage": Threshold(
        20, 5, "samples per basis centre: below five, its weights follow noise and ridge, not data", True
    ),
    "extrapolation": Threshold(0.01, 0.05, "outside the range of the training data curves are continued, not measured"),
    "nrmse": Threshold(0.021, 0.057, "2.1 % is what the paper's RBF model reaches for q, 5.7 % its analytical one"),
    "rival": Threshold(1.0, 4.0, "times the error of the best baseline: where one is surely nearer, take that one"),
    "switch_accuracy": Threshold(0.99, 0.9, "one wrong well costs a whole stroke until the next pulse", True),
    "ambiguous": Threshold(0.1, 0.3, "ambiguous outcomes come true about half of the time on simulated prototypes"),
    "outside": Threshold(0.01, 0.05, "in states (q, q̇) that no training sample was near the model is a guess"),
    "generalisation": Threshold(
        3.0, 10.0, "validation over training error: a model that has learnt the noise shows a large ratio"
    ),
    "measured_facts": Threshold(
        2.5, 5.0, "standard deviations between model and measurement: beyond 2.5 chance explains one fact in eighty"
    ),
    "wells": Threshold(
        0.03, 0.1, "a rest between pulses still creeps and rings by 1 to 3 % of the distance of the wells"
    ),
}


@dataclass(frozen=True)
class Check:
    """One judged number: its code, its grade, the sentence with the number, and the advice unless it is good.

    Of what a `Finding` is behind, `log`, `subject` and `numbers` are those of the finding.
    """

    about: Literal["data", "model"]
    name: str
    grade: Severity
    statement: str
    advice: str
    log: str = ""
    subject: str = ""
    numbers: Mapping[str, Number] = field(default_factory=dict)


def of_finding(about: Literal["data", "model"], finding: Finding) -> Check:
    """A finding as a row of the assessment."""
    statement, advice = sentences(finding)
    return Check(
        about=about,
        name=finding.code,
        grade=finding.severity,
        statement=statement,
        advice=advice,
        log=finding.log,
        subject=finding.subject,
        numbers=finding.numbers,
    )


def graded(
    about: Literal["data", "model"],
    code: str,
    value: float,
    *,
    log: str = "",
    subject: str = "",
    numbers: Mapping[str, Number] = MappingProxyType({}),
) -> Check:
    """A row whose grade a number decides, by the threshold of its code; that number is its ``value``.

    Parameters
    ----------
    about : {"data", "model"}
        Subject of the grade.
    code : str
        Of the threshold and of the finding.
    value : float
        A share, a ratio or a count.
    log, subject : str
        As in `Finding`.
    numbers : mapping of str to Number
        Others that its sentences name.
    """
    numbers = {"value": Number(value), **numbers}
    return of_finding(about, Finding(code, THRESHOLDS[code].grade(value), log, subject, numbers))
