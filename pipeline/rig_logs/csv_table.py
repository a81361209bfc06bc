"""The first rows of a CSV file as a table, under the delimiter and the decimal mark that give the most numbers."""

import codecs
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from .csv_cells import (
    MISSING,
    NUMBER,
    is_before_decimals,
    is_behind,
    is_stamp,
    is_value,
    rows_of,
    split_row,
)
from .source import CsvOptions, UnreadableLogError

_MOST_ROWS = 400
_NOTES = re.compile(r"(?i)((comment|remark|note|event|marker|message)s?|kommentar|bemerkung|anmerkung|notiz|ereignis)?")
"""Names of a column whose cells are notes on single rows, or no name."""
_CANDIDATES = (
    (";", ","), (";", "."), ("\t", ","), ("\t", "."), (",", "."), ("|", "."), ("|", ","), (" ", "."), (" ", ","),
    (",", ","),
)  # fmt: skip
"""Delimiters and decimal marks; of two that fit alike the first is taken. A comma may be both between quotes only."""


@dataclass(frozen=True)
class SampleTable:
    """The sample under one reading: its cells, its first row of data, and which columns are numbers."""

    delimiter: str
    decimal: str
    rows: list[list[str]]
    first: int
    numeric: tuple[bool, ...]
    """Which columns have numbers in the sample."""
    ragged: bool

    @property
    def has_marks(self) -> bool:
        """Whether a number has the decimal mark."""
        body = (row for row in self.rows[self.first :] if len(row) == len(self.numeric))
        return any(
            self.decimal in cell and not is_stamp(cell) and is_value(cell, self.decimal) for row in body for cell in row
        )

    @property
    def shows_mark(self) -> bool:
        """Whether a number shows that the mark stands before decimals. A file has one mark, so that decides for all."""
        body = (row for row in self.rows[self.first :] if len(row) == len(self.numeric))
        numbers = (cell for row in body for cell, numeric in zip(row, self.numeric, strict=True) if numeric)
        return any(is_before_decimals(cell, self.decimal) for cell in numbers if cell.lower() not in MISSING)


def sample_lines(start: bytes, encoding: str, *, whole: bool) -> list[str]:
    """The lines of a file's first bytes; the last only if that is the `whole` file.

    Raises
    ------
    UnreadableLogError
        The bytes are not in this encoding, or there is none of this name.
    """
    try:
        text = codecs.getincrementaldecoder(encoding)().decode(start)
    except LookupError:
        raise UnreadableLogError(f"unknown text encoding {encoding!r}") from None
    except UnicodeDecodeError as error:
        raise UnreadableLogError(f"not encoded as {encoding}: {error.reason} at byte {error.start}") from None
    lines = rows_of(text.strip("\0\ufeff"))
    return lines if whole else lines[:-1]


def find_table(lines: list[str], options: CsvOptions, most: int = _MOST_ROWS) -> SampleTable:
    """The reading of the sample, of its first rows where they hold a table, that gives the most columns of numbers.

    Of two with one delimiter it is that whose mark surely stands before decimals.
    """
    tables = [_table(lines[:most], *marks, options.header_row) for marks in _candidates(lines, options)]
    readable = [table for table in tables if table is not None]
    if not readable and len(lines) > most:
        return find_table(lines, options, len(lines))
    if not readable:
        way_out = "if it is one, set [ingest.csv] encoding, delimiter, decimal and header_row"
        if _is_single_column(lines):
            way_out = (
                "it holds a single one; if input and displacement stand in files of their own, join them as columns of "
                "one file"
            )
        raise UnreadableLogError(
            f"no table of numbers with two columns or more found in the first {len(lines)} rows; {way_out}"
        )
    best = max(readable, key=lambda table: sum(table.numeric))
    alike = [
        table for table in readable if (table.delimiter, sum(table.numeric)) == (best.delimiter, sum(best.numeric))
    ]
    return next((table for table in alike if len(alike) > 1 and table.shows_mark), best)


def _is_single_column(lines: list[str]) -> bool:
    """Whether most lines are one number each."""
    cells = [line.strip(' \t"') for line in lines[:_MOST_ROWS] if line.strip()]
    return 2 * sum(is_value(cell, ".") for cell in cells) > len(cells)


def _candidates(lines: list[str], options: CsvOptions) -> list[tuple[str, str]]:
    usual = _CANDIDATES if any('"' in line for line in lines) else _CANDIDATES[:-1]
    pairs = [pair for pair in usual if options.delimiter in (None, pair[0]) and options.decimal in (None, pair[1])]
    if options.delimiter is not None and not pairs:
        pairs = [(options.delimiter, options.decimal or ".")]
    return pairs


def _table(lines: list[str], delimiter: str, decimal: str, header_row: int | None) -> SampleTable | None:
    """The sample as a table, None if it is none.

    The width is the most frequent one. A column holds numbers if most of its cells do, of those that are not empty in
    the second half. Data begin with the first row of two numbers or more in which those columns hold nothing else; of a
    column that is empty in the second half, every cell from there on must be a number. Numbers above a row of texts are
    part of the preamble. A later row that does not fit
    is no preamble but an error, which the parser reports.
    """
    rows = [split_row(line, delimiter) for line in lines]
    width = Counter(len(row) for row in rows if any(row)).most_common(1)[0][0] if any(map(any, rows)) else 0
    begin = 0 if header_row is None else header_row + 1
    named = header_row is not None and header_row < len(rows) and len(rows[header_row]) == width + 1
    fits = [_fits(row, width, decimal) or (named and len(row) == width + 1) for row in rows]
    fitting = [i for i in range(begin, len(rows)) if fits[i]]
    if width < 2 or not fitting:
        return None
    later = fitting[len(fitting) // 2 :]
    likely = [_mostly_values([rows[i][j] for i in later], decimal) for j in range(width)]
    clocks = [not wanted or any(is_stamp(rows[i][j]) for i in later) for j, wanted in enumerate(likely)]
    keys = likely[1] and not any(rows[i][0] for i in later)  # of an instrument, in the first column of its preamble
    begins = next((i for i in fitting if _filled(rows[i], likely, decimal) >= 2), 0)
    keys = keys and not any(len(row) == width and any(row) and _NOTES.fullmatch(row[0]) for row in rows[:begins][-2:])
    data = [fit and not (keys and row[0]) and _in_place(row, clocks) for row, fit in zip(rows, fits, strict=True)]
    filled = [_filled(row, likely, decimal) if is_data else 0 for row, is_data in zip(rows, data, strict=True)]
    behind = {i: rows[j] for i, j in pairwise(fitting) if not filled[j]}
    only_text = {i for i, row in behind.items() if any(row) and not any(map(NUMBER.match, row))}
    only_text |= {i for i, row in enumerate(rows[1:]) if len(row) == 1 and row[0].endswith(":")}  # a key
    blank = {i for i in fitting if all(cell.lower() in MISSING for cell in rows[i])}  # or a line below the heading
    first = next((i for i in fitting if filled[i] >= 2 and i not in only_text | blank), None)
    if first is None:
        return None
    while first > begin and filled[first - 1] and first - 1 not in blank and _same_kinds(rows[first - 1], rows[first]):
        first -= 1  # as of a channel that begins later, beside the time
    body = [rows[i][:width] for i in fitting if i >= first]
    columns = [[cell for cell in column if cell] for column in zip(*body, strict=True)]
    numeric = tuple(
        wanted or (any(column) and all(is_value(cell, decimal) for cell in column))
        for wanted, column in zip(likely, columns, strict=True)
    )
    ragged = any(len(rows[i]) > width for i in fitting if i >= first)
    return SampleTable(delimiter, decimal, rows, first, numeric, ragged)


def _same_kinds(row: Sequence[str], below: Sequence[str]) -> bool:
    """Whether two rows have time stamps in the same columns, as far as both are filled."""
    return all(is_stamp(cell) == is_stamp(lower) for cell, lower in zip(row, below, strict=False) if cell and lower)


def _in_place(row: Sequence[str], clocks: Sequence[bool]) -> bool:
    """Whether time stamps of a row stand in columns of such only."""
    return all(clock or not is_stamp(cell) for cell, clock in zip(row, clocks, strict=False))


def _fits(row: Sequence[str], width: int, decimal: str) -> bool:
    """Whether a row has so many cells, or one more that is empty or a comment."""
    return len(row) == width or (len(row) == width + 1 and is_behind(row[-1], decimal))


def _filled(row: Sequence[str], likely: Sequence[bool], decimal: str) -> int:
    """How many columns of numbers hold one in this row, 0 where one of them holds something else."""
    cells = [cell for cell, wanted in zip(row, likely, strict=False) if wanted and cell]
    return len(cells) if all(is_value(cell, decimal) for cell in cells) else 0


def _mostly_values(cells: Sequence[str], decimal: str) -> bool:
    """Whether most cells are numbers, and there are such; empty cells leave it open."""
    values = [is_value(cell, decimal) for cell in cells if cell]
    return 2 * sum(values) > len(values)
