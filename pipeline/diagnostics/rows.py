"""What a check says: one row for each thing looked at, with its number, its limit, and what to do."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from ..settings.prototype import CheckGate
from ..signals.quality_gates import Finding
from ..units.quantity import scale, short, significant
from ..units.units import column_suffix

State = Literal["ok", "note", "wrong", "not seen"]
"""ok: within the limit; note: look at it; wrong: the model would be wrong; not seen: the log does not show it."""

_MOST_BESIDE = 2
_ORDER: tuple[State, ...] = ("not seen", "ok", "note", "wrong")


@dataclass(frozen=True)
class CheckRow:
    """One thing that was looked at.

    Attributes
    ----------
    log : str
        Of which log, as people call it.
    what : str
        What was looked at.
    found, limit : str
        The number with its uncertainty, and what it may be; the limit may be empty.
    state : State
    gate : CheckGate or None
        The name under which the settings can accept it.
    advice : str
        What to do unless the state is ok.
    more : str
        Other numbers that speak for or against it.
    values : mapping of str to float
        The numbers of `found` in SI, the unit at the end of the key, as in ``delay_s``.
    """

    log: str
    what: str
    found: str
    limit: str
    state: State = "ok"
    gate: CheckGate | None = None
    advice: str = ""
    more: str = ""
    values: Mapping[str, float] = field(default_factory=dict)

    @property
    def sentence(self) -> str:
        """Log, number, other numbers and limit in one line."""
        numbers = "; ".join(filter(None, (self.found, self.more)))
        return f"{self.log}: {self.what}: {numbers}" + (f" (limit: {self.limit})" if self.limit else "")


def beside(rows: Sequence[CheckRow]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """The rows as a table: the logs as columns where there are two at most, else the most remarkable of all logs.

    Returns
    -------
    header : tuple of str
    table : list of tuple of str
        What was looked at, what was found, the limit; a (!) marks what is remarkable.
    """
    logs = list(dict.fromkeys(row.log for row in rows))
    table = []
    for what in dict.fromkeys(row.what for row in rows):
        kind = [row for row in rows if row.what == what]
        shown: list[CheckRow | None]
        if len(logs) > _MOST_BESIDE:
            shown = [max(kind, key=lambda row: _ORDER.index(row.state))]
        else:
            shown = [next((row for row in kind if row.log == log), None) for log in logs]
        table.append((what, *map(_cell, shown), kind[0].limit))
    columns = logs if len(logs) <= _MOST_BESIDE else [f"most remarkable of {len(logs)} logs"]
    return ("checked", *columns, "limit"), table


def _cell(row: CheckRow | None) -> str:
    if row is None:
        return ""
    return f"{row.found} (!)" if row.state in ("wrong", "note") else row.found


def findings(rows: Sequence[CheckRow]) -> list[Finding]:
    """What would make the model wrong: one finding for each gate, with the first row's number."""
    collected = []
    for gate in dict.fromkeys(row.gate for row in rows if row.state == "wrong" and row.gate is not None):
        of_gate = [row for row in rows if row.gate == gate and row.state == "wrong"]
        first = of_gate[0]
        more = f", and {len(of_gate) - 1} more like it" if len(of_gate) > 1 else ""
        collected.append(Finding(gate, f"{first.sentence}{more}", first.advice))
    return collected


def remarks(rows: Sequence[CheckRow]) -> list[str]:
    """What deserves a look and does not make the model wrong."""
    return [f"{row.sentence}: {row.advice}" for row in rows if row.state == "note"]


def in_si(name: str, unit: str, value: float | None, error: float | None = None) -> dict[str, float]:
    """A number for `CheckRow.values` under a key with its SI unit, and its standard error; nothing where it is none."""
    end = "" if unit == "1" else f"_{column_suffix(unit)}"
    numbers = {f"{name}{end}": value, f"{name}_error{end}": error}
    return {key: float(number) for key, number in numbers.items() if number is not None and np.isfinite(number)}


def short_quantity(value: float, unit: str) -> str:
    """A round number with its unit."""
    shown, factor = scale(unit, value)
    return f"{short(value * factor)} {shown}"


def times_text(ratio: float | None) -> str:
    """How many times as large, in words; empty for None."""
    if ratio is None:
        return ""
    return f"{significant(ratio, 2)} times" if ratio >= 1.0 else f"1/{significant(1.0 / ratio, 2)}"
