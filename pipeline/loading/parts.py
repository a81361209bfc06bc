"""Parts of a log between which its inputs were not recorded: nobody knows what the device did there.

A short hole is bridged by a straight line. Behind a longer one fits and free runs start anew, as at the beginning of a
log.
"""

from collections.abc import Sequence

import numpy as np

from pipeline.numerics.arrays import BoolArray, runs_of
from pipeline.runs.tables import Table
from pipeline.signals.trajectory import SHORTEST, unknown_rows

_PART = "recorded"


def with_parts(table: Table, unknown: Sequence[Sequence[float]]) -> Table:
    """The table with its rows marked that lie in the `unknown` spans [s], if there are any."""
    return {**table, _PART: ~unknown_rows(table["t"], unknown)} if unknown else table


def recorded(table: Table) -> BoolArray:
    """Rows whose inputs are known, shape (N,)."""
    marked: BoolArray = table.get(_PART, np.ones(len(table["t"]), dtype=np.bool_))
    return marked


def part_rows(table: Table) -> list[slice]:
    """The rows of each part of a table, from its first valid sample on; parts of less than `SHORTEST` are left out.

    Where all are so short, the rows are those of the table from its first valid sample on.
    """
    valid = table["segment"] >= 0
    with_samples = [rows for rows in runs_of(recorded(table)) if valid[rows].any()]
    from_valid = [slice(rows.start + int(np.argmax(valid[rows])), rows.stop) for rows in with_samples]
    long_enough = [rows for rows in from_valid if rows.stop - rows.start >= SHORTEST]
    return long_enough or [slice(int(np.argmax(valid)), len(valid))]


def parts(table: Table) -> list[Table]:
    """The parts of a table, each beginning with a valid sample."""
    return [part(table, rows) for rows in part_rows(table)]


def part(table: Table, rows: slice) -> Table:
    """The rows of one part."""
    return {name: values[rows] for name, values in table.items() if name != _PART}


def longest_rows(table: Table) -> slice:
    """The rows of the longest part."""
    return max(part_rows(table), key=lambda rows: rows.stop - rows.start)
