"""Parts of a log between which its inputs were not recorded: nobody knows what the device did there.

A short hole is bridged by a straight line. Behind a longer one fits and free runs start anew, as at the beginning of a
log.
"""

from collections.abc import Sequence

import numpy as np

from pipeline.numerics.arrays import BoolArray, runs_of
from pipeline.runs.tables import Table

LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Of a record's notes: spans [s] in which the inputs were not recorded for longer."""
_PART = "recorded"


def with_parts(table: Table, unknown: Sequence[Sequence[float]]) -> Table:
    """The table with its rows marked that lie strictly inside the `unknown` spans [s], if there are any."""
    if not unknown:
        return table
    t = table["t"]
    inside = np.zeros(len(t), dtype=np.bool_)
    for start, stop in unknown:
        inside[np.searchsorted(t, start, side="right") : np.searchsorted(t, stop)] = True
    return {**table, _PART: ~inside}


def recorded(table: Table) -> BoolArray:
    """Rows whose inputs are known, shape (N,)."""
    marked: BoolArray = table.get(_PART, np.ones(len(table["t"]), dtype=np.bool_))
    return marked


def part_rows(table: Table) -> list[slice]:
    """The rows of each part of a table, from its first valid sample on; a part without one is left out."""
    found = []
    for rows in runs_of(recorded(table)):
        valid = table["segment"][rows] >= 0
        if valid.any():
            found.append(slice(rows.start + int(np.argmax(valid)), rows.stop))
    return found


def parts(table: Table) -> list[Table]:
    """The parts of a table, each beginning with a valid sample."""
    return [{name: values[rows] for name, values in table.items() if name != _PART} for rows in part_rows(table)]


def longest_part(table: Table) -> Table:
    """The part with the most rows."""
    return max(parts(table), key=lambda part: len(part["t"]))
