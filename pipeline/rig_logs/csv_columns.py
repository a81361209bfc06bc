"""Columns written otherwise than the rest: words or SI prefixes around each number, or another decimal mark."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from pipeline.rig_logs.csv_cells import MISSING, is_before_decimals, is_stamp, is_value

_AROUND = re.compile(
    r"(?:(?P<label>[^\W\d_][^:=]{0,40}?) ?[:=] ?)?(?P<number>[-+]?(?:\d[\d.,]*|[.,]\d+)(?:[eE][-+]?\d+)?)"
    r"(?: ?(?P<unit>[^\W\d_°%][^\W_]{0,7}(?:[/*^·][\w²³]{1,4})?|°C?|%)(?: [AD]C)?)?"
)
_FEWEST = 3
_POWERS = {"": 0, "k": 3, "K": 3, "M": 6, "Meg": 6, "MEG": 6, "G": 9, "m": -3, "u": -6, "µ": -6, "μ": -6, "n": -9}
"""Powers of ten by SI prefixes, and by those of circuit simulators."""


@dataclass(frozen=True)
class Writing:
    """How the cells of one column are written.

    Attributes
    ----------
    label, unit : str
        What stands before and behind each number, as in ``q: 10.2`` of a serial plotter and ``0.002 sec`` of MATLAB.
        A cell of another SI prefix is brought to this unit: ``950 V`` among ``2.95 kV``, ``2.95k`` among ``950``.
    mark : str
        Its decimal mark where that is not the file's; "" elsewhere.
    prefixed : bool
        Whether SI prefixes alone stand behind its numbers.
    """

    label: str = ""
    unit: str = ""
    mark: str = ""
    prefixed: bool = False


def writings(rows: Sequence[Sequence[str]], width: int, decimal: str) -> tuple[Writing, ...]:
    """How each column of a sample is written; empty where all are written as numbers with the decimal mark."""
    fitting = [row for row in rows if len(row) >= width]
    columns = [[cell for cell in column if cell.lower() not in MISSING] for column in zip(*fitting, strict=False)]
    marked = any(is_before_decimals(cell, decimal) for column in columns[:width] for cell in column)
    written = tuple(_writing(column, decimal, marked=marked) for column in columns[:width])
    return written if any(each != Writing() for each in written) else ()


def _writing(cells: Sequence[str], decimal: str, *, marked: bool) -> Writing:
    """How a column is written, by the cells behind the last one of its first half that is no number: a heading."""
    matches = [match if (match := _AROUND.fullmatch(c)) and is_value(match["number"], decimal) else None for c in cells]
    other = "," if decimal == "." else "."
    fits = [bool(match) or is_value(c, other) for match, c in zip(matches, cells, strict=True)]
    begin = max((i + 1 for i in range(len(cells) // 2) if not fits[i]), default=0)
    cells, matches = cells[begin:], matches[begin:]
    if sum(not is_value(cell, decimal) for cell in cells) < _FEWEST:
        return Writing()
    numbers = all(is_value(cell, other) and not is_stamp(cell) for cell in cells)
    if marked and numbers and any(is_before_decimals(cell, other) for cell in cells):
        return Writing(mark=other)
    around = [match.groupdict("") for match in matches if match]
    if len(around) < len(cells):
        return Writing()
    labels = {each["label"] for each in around}
    units = {each["unit"] for each in around if each["number"].strip("+-0.,")} or {each["unit"] for each in around}
    unit = _common_unit(units)
    if len(labels) > 1 or unit is None:
        return Writing()
    return Writing(labels.pop(), unit, prefixed=not unit and units != {""})


def _common_unit(units: set[str]) -> str | None:
    """The unit to which numbers are brought, "" for bare prefixes; None where they are of several kinds."""
    if units == {"K"}:  # kelvins, or thousands
        return None
    bare = units != {"m"} and any(unit in _POWERS for unit in units)
    firsts = [*([""] if bare else []), min(units, key=len)]
    return next((first for first in firsts if all(_power(unit, first) is not None for unit in units)), None)


@cache
def _power(unit: str, other: str) -> int | None:
    """The power of ten between two units that differ by an SI prefix, as 3 from kV to V; None for any others."""
    pairs = ((own, its) for own in _POWERS for its in _POWERS if unit.startswith(own) and other.startswith(its))
    return next((_POWERS[a] - _POWERS[b] for a, b in pairs if unit[len(a) :] == other[len(b) :]), None)


def bare_cells(cells: Sequence[str], columns: Sequence[Writing], decimal: str) -> list[str]:
    """The cells of a row as numbers with the file's decimal mark, without the words around them."""
    if len(cells) < len(columns) or not columns:
        return [*cells]
    return [_bare(*each, decimal) for each in zip(cells, columns, strict=False)] + [*cells[len(columns) :]]


def _bare(cell: str, written: Writing, decimal: str) -> str:
    if written.mark and is_value(cell, written.mark):
        return cell.replace(written.mark, decimal)
    match = None if written == Writing() else _AROUND.fullmatch(cell)
    if match is None or (match["label"] or "") != written.label:
        return cell
    power = _power(match["unit"] or "", written.unit) if match["number"].strip("+-0.,") else 0
    mantissa, _, exponent = match["number"].lower().partition("e")
    return cell if power is None else f"{mantissa}e{int(exponent or 0) + power}" if power else match["number"]
