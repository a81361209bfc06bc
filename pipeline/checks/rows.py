"""What a check says: one row for each thing looked at, with its number, its limit, and what to do."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from pipeline.settings import CheckGate
from pipeline.signals.quality_gates import Finding

State = Literal["ok", "note", "wrong", "not seen"]
"""ok: within the limit; note: look at it; wrong: the model would be wrong; not seen: the log does not show it."""


@dataclass(frozen=True)
class CheckRow:
    """One thing that was looked at.

    Attributes
    ----------
    log : str
        Of which log, as ``role/name``.
    what : str
        What was looked at.
    found, limit : str
        The number with its uncertainty, and what it may be; the limit may be empty.
    state : State
    gate : CheckGate or None
        The name under which the settings can accept it.
    advice : str
        What to do unless the state is ok.
    """

    log: str
    what: str
    found: str
    limit: str
    state: State = "ok"
    gate: CheckGate | None = None
    advice: str = ""


def findings(rows: Sequence[CheckRow]) -> list[Finding]:
    """What would make the model wrong: one finding for each gate, with the first row's number."""
    found = []
    for gate in dict.fromkeys(row.gate for row in rows if row.state == "wrong" and row.gate is not None):
        of_gate = [row for row in rows if row.gate == gate and row.state == "wrong"]
        first = of_gate[0]
        more = f", and {len(of_gate) - 1} more like it" if len(of_gate) > 1 else ""
        wanted = f" ({first.limit})" if first.limit else ""
        found.append(Finding(gate, f"{first.log}: {first.what} is {first.found}{wanted}{more}", first.advice))
    return found


def remarks(rows: Sequence[CheckRow]) -> list[str]:
    """What deserves a look and does not make the model wrong."""
    return [f"{row.log}: {row.what} is {row.found}: {row.advice}" for row in rows if row.state == "note"]
