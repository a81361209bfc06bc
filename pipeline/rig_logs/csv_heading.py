"""Names and units above a table of numbers: the rows of names and of units among what stands there, units in names."""

import re
from collections.abc import Sequence

_COMMENT = re.compile(r"\s*(?:#|%|//)+\s*")
_UNIT_IN_NAME = re.compile(r"^(?P<name>.*\S)\s*[\[(](?P<unit>[^\[\]()]*)[\])]$")
_BEFORE_BRACKET = re.compile(r"\s+(?=[\[(])")
_BRACKETED = re.compile(r"[\[(][^\[\]()]*[\])]$")
_SEPARATORS = re.compile(r"[,;|\t]|\s+")
_KNOWN = (
    "s sec second seconds ms us µs μs ns min h m mm cm um µm μm nm deg degree degrees ° rad mrad v volt volts kv mv a "
    "ampere ma n kn nm n·m mn·m % pct hz khz g kg pa kpa bar mbar k °c rpm 1 - m/s mm/s deg/s rad/s m/s² m/s^2"
)
_UNITS = frozenset(_KNOWN.split())
"""Spellings by which a row of units is known."""

Row = Sequence[str]


def bare_line(line: str) -> str:
    """A line without the mark of a comment before it, as gnuplot, numpy and MATLAB set before headings."""
    match = _COMMENT.match(line)
    return line[match.end() :] if match else line


def is_comment(line: str) -> bool:
    """Whether a line is marked as a comment."""
    return bool(_COMMENT.match(line))


def cells_of_comment(line: str, cells: Row, width: int) -> Row:
    """Cells of a comment above rows of `width` cells, which often is separated otherwise than those."""
    if len(cells) == width:
        return cells
    bare = _BEFORE_BRACKET.sub("", bare_line(line)).strip()
    others = [cell for cell in _SEPARATORS.split(bare) if cell]
    return others if len(others) == width else cells


def heading_rows(above: Sequence[Row], comments: Sequence[bool], width: int) -> tuple[int | None, int | None]:
    """Which of the rows above the data holds the names, and which the units; None where there is none.

    Empty rows may stand between them and the data. A row of one cell more than the data, as for comments, names the
    first of them.

    Parameters
    ----------
    above : sequence of rows
        All rows before the first row of data.
    comments : sequence of bool
        Whether each is marked as a comment: many comments may be there, and the last one is the heading.
    width : int
        Cells of a row of data.
    """
    block: list[int] = []
    for i in range(len(above) - 1, -1, -1):
        if not any(above[i]):
            if block:
                break
            continue
        longer = not block and len(above[i]) == width + 1 and all(above[i][:width])
        if len(above[i]) != width and not longer:
            break
        block.insert(0, i)
    if not block:
        return None, None
    units = next((i for i in reversed(block[1:]) if _holds_units(above[i])), None)
    if comments[block[-1]]:
        return (block[-1] if units is None else block[block.index(units) - 1]), units
    return block[0], units if units is not None or len(block) < 2 else block[1]


def _holds_units(row: Row) -> bool:
    cells = [cell for cell in row if cell]
    known = [bool(_BRACKETED.match(cell)) or cell.strip("[]() ").lower() in _UNITS for cell in cells]
    return 2 * sum(known) > len(cells)


def names_and_units(headings: Row, units_row: Row, width: int) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Name and unit of each column; a unit in brackets behind a name is its unit where no row of units says it."""
    if not headings:
        return tuple(f"column {j + 1}" for j in range(width)), ("",) * width
    names, units = [], []
    for j, heading in enumerate(headings[:width]):
        match = _UNIT_IN_NAME.match(heading)
        unit = units_row[j].strip("[]() ") if j < len(units_row) else ""
        names.append(match["name"] if match and not unit else heading or f"column {j + 1}")
        units.append(unit or (match["unit"].strip() if match else ""))
    return tuple(names), tuple(units)
