"""The finding: what was measured of a log or a model, as a code with numbers; `sentences` puts it into words."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Literal

Severity = Literal["good", "fair", "poor"]
SEVERITIES: tuple[Severity, ...] = ("good", "fair", "poor")


@dataclass(frozen=True)
class Number:
    """A number with its SI unit (``1`` for shares and ratios) and its standard error, where it has one."""

    value: float
    unit: str = "1"
    error: float | None = None


@dataclass(frozen=True)
class Finding:
    """What was measured, how bad it is, and of which log.

    Attributes
    ----------
    code : str
        Which finding it is, in snake case, as tests and users of the datasheet compare it.
    severity : Severity
    log : str
        The log as tables show it (`names.log_title`); empty where it is of the whole run.
    subject : str
        The channel, model or fact that it is about, for instance ``v1``; may be empty.
    numbers : mapping of str to Number
        What was measured, by name.
    """

    code: str
    severity: Severity
    log: str = ""
    subject: str = ""
    numbers: Mapping[str, Number] = field(default_factory=dict)


def worst(findings: Iterable[Finding]) -> Severity:
    """The worst severity; good where there is no finding."""
    return max((finding.severity for finding in findings), key=SEVERITIES.index, default="good")
