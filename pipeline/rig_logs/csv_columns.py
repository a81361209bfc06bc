"""Columns written otherwise than the rest: words around each number, or another decimal mark."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from pipeline.rig_logs.csv_cells import MISSING, is_before_decimals, is_stamp, is_value

_AROUND = re.compile(
    r"(?:(?P<label>[^\W\d_][^:=]{0,40}?) ?[:=] ?)?(?P<number>[-+\u2212]?(?:\d[\d.,]*|[.,]\d+)(?:[eE][-+]?\d+)?)"
    r"(?: ?(?P<unit>[^\W\d_°%][^\W_]{0,7}(?:[/*^·][\w²³]{1,4})?|°C?|%))?"
)
_FEWEST = 3


@dataclass(frozen=True)
class Writing:
    """How the cells of one column are written.

    Attributes
    ----------
    label, unit : str
        What stands before and behind each number, as in ``q: 10.2`` of a serial plotter and ``0.002 sec`` of MATLAB.
    mark : str
        Its decimal mark where that is not the file's; "" elsewhere.
    """

    label: str = ""
    unit: str = ""
    mark: str = ""


def writings(rows: Sequence[Sequence[str]], width: int, decimal: str) -> tuple[Writing, ...]:
    """How each column of a sample is written; empty where all are written as numbers with the decimal mark."""
    fitting = [row for row in rows if len(row) >= width]
    columns = [[cell for cell in column if cell.lower() not in MISSING] for column in zip(*fitting, strict=False)]
    marked = any(is_before_decimals(cell, decimal) for column in columns[:width] for cell in column)
    written = tuple(_writing(column[len(column) // 2 :], decimal, marked=marked) for column in columns[:width])
    return written if any(each != Writing() for each in written) else ()


def _writing(cells: Sequence[str], decimal: str, *, marked: bool) -> Writing:
    """How a column is written, by its later cells: the first ones may stand above the data."""
    if len(cells) < _FEWEST or is_value(cells[-1], decimal):
        return Writing()
    other = "," if decimal == "." else "."
    numbers = all(is_value(cell, other) and not is_stamp(cell) for cell in cells)
    if marked and numbers and any(is_before_decimals(cell, other) for cell in cells):
        return Writing(mark=other)
    matches = [_AROUND.fullmatch(cell) for cell in cells]
    around = {(match["label"] or "", match["unit"] or "") for match in matches if match}
    if all(matches) and len(around) == 1 and all(is_value(match["number"], decimal) for match in matches if match):
        return Writing(*around.pop())
    return Writing()


def bare_cells(cells: Sequence[str], columns: Sequence[Writing], decimal: str) -> list[str]:
    """The cells of a row as numbers with the file's decimal mark, without the words around them."""
    if len(cells) < len(columns) or not columns:
        return [*cells]
    return [_bare(*each, decimal) for each in zip(cells, columns, strict=False)] + [*cells[len(columns) :]]


def _bare(cell: str, written: Writing, decimal: str) -> str:
    if written.mark and is_value(cell, written.mark):
        return cell.replace(written.mark, decimal)
    if written.label or written.unit:
        match = _AROUND.fullmatch(cell)
        if match and (match["label"] or "", match["unit"] or "") == (written.label, written.unit):
            return match["number"]
    return cell
