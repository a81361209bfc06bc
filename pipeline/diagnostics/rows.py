"""The table of the check: one row for each thing looked at, with its number, its limit, and what to do."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from ..settings.prototype import Gate
from ..signals.findings import Finding, Severity
from ..units.units import column_suffix
from . import log_sentences

State = Literal["not seen", "ok", "note", "wrong"]
"""ok: within the limit; note: look at it; wrong: the model would be wrong; not seen: the log does not show it."""

STATES: dict[Severity, State] = {"unseen": "not seen", "good": "ok", "fair": "note", "poor": "wrong"}
_MOST_BESIDE = 2


@dataclass(frozen=True)
class CheckRow:
    """A finding of the check in words, as tables, `check.json` and the page show it.

    Attributes
    ----------
    log : str
        Of which log, as people call it.
    what : str
        What was looked at.
    found, limit : str
        The number, and what it may be; the limit may be empty.
    state : State
    gate : Gate or None
        The name under which the settings can accept it.
    advice : str
        What to do unless the state is ok.
    more : str
        Other numbers that speak for or against it.
    values : mapping of str to float
        The numbers of the finding in SI, the unit at the end of the key, as in ``delay_s``.
    code : str
        That of the finding; empty in runs of earlier releases.
    """

    log: str
    what: str
    found: str
    limit: str
    state: State = "ok"
    gate: Gate | None = None
    advice: str = ""
    more: str = ""
    values: Mapping[str, float] = field(default_factory=dict)
    code: str = ""

    @property
    def remark(self) -> str:
        """Log, numbers, limit and advice in one line."""
        return f"{log_sentences.line(self.log, self.what, self.found, self.more, self.limit)}: {self.advice}"


def check_rows(findings: Sequence[Finding]) -> list[CheckRow]:
    """The findings of a check as rows."""
    rows = []
    for finding in findings:
        shown = log_sentences.row(finding)
        advice = shown.advice if finding.severity in ("fair", "poor") else ""
        state = STATES[finding.severity]
        values = _in_si(finding)
        rows.append(
            CheckRow(
                finding.log, shown.what, shown.found, shown.limit, state, finding.gate, advice, shown.more, values,
                finding.code,
            )
        )  # fmt: skip
    return rows


def remarks(findings: Sequence[Finding]) -> list[str]:
    """What deserves a look and does not make the model wrong."""
    return [": ".join(log_sentences.of_row(finding)) for finding in findings if finding.severity == "fair"]


def beside(rows: Sequence[CheckRow]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """The rows as a table: the logs as columns where there are two at most, else the most remarkable of all logs.

    Returns
    -------
    header : tuple of str
    table : list of tuple of str
        What was looked at, what was found, the limit; a (!) marks what is remarkable.
    """
    logs = list(dict.fromkeys(row.log for row in rows))
    order = list(STATES.values())
    table = []
    for what in dict.fromkeys(row.what for row in rows):
        kind = [row for row in rows if row.what == what]
        shown: list[CheckRow | None]
        if len(logs) > _MOST_BESIDE:
            shown = [max(kind, key=lambda row: order.index(row.state))]
        else:
            shown = [next((row for row in kind if row.log == log), None) for log in logs]
        table.append((what, *map(_cell, shown), kind[0].limit))
    columns = logs if len(logs) <= _MOST_BESIDE else [f"most remarkable of {len(logs)} logs"]
    return ("checked", *columns, "limit"), table


def _cell(row: CheckRow | None) -> str:
    if row is None:
        return ""
    return f"{row.found} (!)" if row.state in ("wrong", "note") else row.found


def _in_si(finding: Finding) -> dict[str, float]:
    """Numbers under keys with their SI units, and their standard errors."""
    values = {}
    for name, number in finding.numbers.items():
        end = "" if number.unit == "1" else f"_{column_suffix(number.unit)}"
        for key, value in ((f"{name}{end}", number.value), (f"{name}_error{end}", number.error)):
            if value is not None and np.isfinite(value):
                values[key] = float(value)
    return values
