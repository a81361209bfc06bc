"""The finding: what was measured of a log or a model, as a code with numbers; `diagnostics.sentences` words it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from ..settings.prototype import Gate

Severity = Literal["unseen", "good", "fair", "poor"]
SEVERITIES: tuple[Severity, ...] = ("unseen", "good", "fair", "poor")


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
        Unseen: the data do not show it.
    log : str
        The log as tables show it (`names.log_title`); empty where it is of the whole run.
    subject : str
        The channel, model or fact that it is about, for instance ``v1``; may be empty.
    numbers : mapping of str to Number
        What was measured, by name.
    gate : Gate or None
        The name under which the settings accept it, where it refuses the data.
    """

    code: str
    severity: Severity
    log: str = ""
    subject: str = ""
    numbers: Mapping[str, Number] = field(default_factory=dict)
    gate: Gate | None = None


def refusal(gate: Gate, code: str, numbers: Mapping[str, Number] | None = None, subject: str = "") -> Finding:
    """A finding that refuses the data.

    Parameters
    ----------
    gate : Gate
        The name under which the settings accept it.
    code, numbers, subject : str, mapping of str to Number, str
        As in `Finding`.
    """
    return Finding(code, "poor", subject=subject, numbers=numbers or {}, gate=gate)
