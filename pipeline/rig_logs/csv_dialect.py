"""Finding out how a CSV file is written: encoding, delimiter, decimal mark, preamble, header and units rows."""

import codecs
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from .csv_heading import (
    bare_line,
    cells_above,
    check_long_table,
    heading_rows,
    names_and_units,
    rows_by_key,
)
from .csv_text import (
    COMMENT,
    MISSING,
    NUMBER,
    SECONDS,
    is_behind,
    is_stamp,
    is_value,
    is_word,
    marks_between_thousands,
    rows_of,
    split_row,
    text_encoding,
    unclear_mark,
)
from .source import CsvOptions, UnreadableLogError

_MOST_ROWS = 400
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}[.,]\d{3}")
_NOTES = re.compile(r"(?i)((comment|remark|note|event|marker|message)s?|kommentar|bemerkung|anmerkung|notiz|ereignis)?")
"""Names of a column whose cells are notes on single rows, or no name."""
_CANDIDATES = (
    (";", ","), (";", "."), ("\t", ","), ("\t", "."), (",", "."), ("|", "."), ("|", ","), (" ", "."), (" ", ","),
    (",", ","),
)  # fmt: skip
"""Delimiters and decimal marks; of two that fit alike the first is taken. A comma may be both between quotes only."""
SAMPLE_BYTES = 1 << 16
_KEY = re.compile(r"[^\W\d]{2}\D*")
"""A word before a value that an instrument states for each channel, and no damaged number."""
_STATISTIC = re.compile(r"(?i)(min|max|mean|avg|average|median|std|stdev|stddev|rms|sum|total|count)(imum|\.|:)*:?")
"""Word before the statistics that a program writes below each column."""
_STATEMENT = re.compile(r"[:=]")  # in a remark, as of ``key: value``
_SENTENCE = re.compile(r"[^\W\d_]{2,}\s+[^\W\d_]{2,}")
_LABVIEW = "LabVIEW Measurement"  # the first line of such a file
_END_OF_HEADER = "***End_of_Header***"
_LEADING_ZERO = re.compile(r"0\d+")  # the decimals of a number that a comma cut


@dataclass(frozen=True)
class SampleTable:
    """The sample under one reading: its cells, its first row of data, and which columns are numbers."""

    delimiter: str
    decimal: str
    rows: list[list[str]]
    first: int
    numeric: tuple[bool, ...]
    """Flags of the columns that have numbers in the sample."""
    ragged: bool

    def _marked(self, columns: Sequence[bool]) -> Iterator[str]:
        """The numbers with a decimal mark in some columns."""
        body = (row for row in self.rows[self.first :] if len(row) == len(columns))
        cells = (cell for row in body for cell, wanted in zip(row, columns, strict=True) if wanted)
        return (cell for cell in cells if self.decimal in cell and not is_stamp(cell) and is_value(cell, self.decimal))

    @property
    def has_marks(self) -> bool:
        """True if a number has the decimal mark."""
        return any(self._marked([True] * len(self.numeric)))

    @property
    def shows_mark(self) -> bool:
        """True if a number shows that the mark stands before decimals. A file has one mark, so that decides for all.

        As in 0.04, there are not three digits behind it.
        """
        return any(
            cell.lower() not in MISSING and not _THOUSANDS.fullmatch(cell) for cell in self._marked(self.numeric)
        )


def sample_lines(start: bytes, encoding: str, *, whole: bool) -> list[str]:
    """The lines of a file's first bytes; the last one only if these bytes are the `whole` file.

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
        raise UnreadableLogError(
            f"not encoded as {encoding}: {error.reason} at byte {error.start}; set another [ingest.csv] encoding, or "
            "save it as UTF-8"
        ) from None
    lines = rows_of(text.strip("\0\ufeff"))
    return lines if whole else lines[:-1]


def find_table(lines: list[str], options: CsvOptions, most: int = _MOST_ROWS) -> SampleTable:
    """The reading of the sample, of its first rows where they hold a table, that gives the most columns of numbers.

    Of two with one delimiter it is that whose mark surely stands before decimals.
    """
    tables = (_table(lines[:most], *marks, options.header_row) for marks in _candidates(lines, options))
    readable = [table for table in tables if table is not None]
    if not readable and len(lines) > most:
        return find_table(lines, options, len(lines))
    if not readable:
        way_out = "if it is one, set [ingest.csv] encoding, delimiter, decimal and header_row"
        cells = [line.strip(' \t"') for line in lines[:_MOST_ROWS] if line.strip()]
        if 2 * sum(is_value(cell, ".") for cell in cells) > len(cells):  # most lines are one number each
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


def _candidates(lines: list[str], options: CsvOptions) -> list[tuple[str, str]]:
    usual = _CANDIDATES if any('"' in line for line in lines) else _CANDIDATES[:-1]
    pairs = [pair for pair in usual if options.delimiter in (None, pair[0]) and options.decimal in (None, pair[1])]
    if options.delimiter is not None and not pairs:
        pairs = [(options.delimiter, options.decimal or ".")]
    return pairs


def _table(lines: list[str], delimiter: str, decimal: str, header_row: int | None) -> SampleTable | None:
    """The sample as a table, None if it is none.

    The width is the most frequent one. A column holds numbers if most of its cells do, of those that are not empty in
    the second half. Of a column that is empty in the second half, every cell of the data must be a number. A later row
    that does not fit is no preamble but an error, which the parser reports.
    """
    rows = [split_row(line, delimiter) for line in lines]
    width = Counter(len(row) for row in rows if any(row)).most_common(1)[0][0] if any(map(any, rows)) else 0
    begin = 0 if header_row is None else header_row + 1
    named = header_row is not None and header_row < len(rows) and len(rows[header_row]) == width + 1
    fits = [_fits(row, width, decimal) or (named and len(row) == width + 1) for row in rows]
    fitting = [i for i in range(begin, len(rows)) if fits[i]]
    if width < 2 or not fitting:
        return None
    later = [rows[i] for i in fitting[len(fitting) // 2 :]]
    likely = [_mostly_values([row[j] for row in later], decimal) for j in range(width)]
    first = _first_row(rows, fits, fitting, later, likely, decimal)
    if first is None:
        return None
    body = [rows[i][:width] for i in fitting if i >= first]
    columns = [[cell for cell in column if cell] for column in zip(*body, strict=True)]
    numeric = tuple(
        wanted or (any(column) and all(is_value(cell, decimal) for cell in column))
        for wanted, column in zip(likely, columns, strict=True)
    )
    return SampleTable(
        delimiter=delimiter,
        decimal=decimal,
        rows=rows,
        first=first,
        numeric=numeric,
        ragged=any(len(rows[i]) > width for i in fitting if i >= first),
    )


def _first_row(
    rows: list[list[str]],
    fits: Sequence[bool],
    fitting: Sequence[int],
    later: Sequence[Sequence[str]],
    likely: Sequence[bool],
    decimal: str,
) -> int | None:
    """First row of data: two numbers or more, and nothing else in the columns that are `likely` numbers; or None.

    Numbers above a row of texts are part of the preamble, and so are blank rows. Rows just above the data belong to
    them even with a single number, as of a channel that begins later, beside the time.
    """
    clocks = [not wanted or any(is_stamp(row[j]) for row in later) for j, wanted in enumerate(likely)]
    keys = likely[1] and not any(row[0] for row in later)  # of an instrument, in the first column of its preamble
    begins = next((i for i in fitting if _filled(rows[i], likely, decimal) >= 2), 0)
    notes = (row[0] for row in rows[:begins][-2:] if len(row) == len(likely) and any(row))
    keys = keys and not any(map(_NOTES.fullmatch, notes))
    filled = [
        _filled(row, likely, decimal) if fit and not (keys and row[0]) and _in_place(row, clocks) else 0
        for row, fit in zip(rows, fits, strict=True)
    ]
    preamble = {
        i for i, j in pairwise(fitting) if not filled[j] and any(rows[j]) and not any(map(NUMBER.match, rows[j]))
    }
    preamble |= {i for i, row in enumerate(rows[1:]) if len(row) == 1 and row[0].endswith(":")}  # above a key
    blank = {i for i in fitting if all(cell.lower() in MISSING for cell in rows[i])}  # or a line below the heading
    first = next((i for i in fitting if filled[i] >= 2 and i not in preamble | blank), None)
    if first is None:
        return None
    while (
        first > fitting[0]
        and filled[first - 1]
        and first - 1 not in blank
        and _same_kinds(rows[first - 1], rows[first])
    ):
        first -= 1
    return first


def _same_kinds(row: Sequence[str], below: Sequence[str]) -> bool:
    """True if two rows have time stamps in the same columns, as far as both are filled."""
    return all(is_stamp(cell) == is_stamp(lower) for cell, lower in zip(row, below, strict=False) if cell and lower)


def _in_place(row: Sequence[str], clocks: Sequence[bool]) -> bool:
    """True if time stamps of a row stand in columns of time stamps only."""
    return all(clock or not is_stamp(cell) for cell, clock in zip(row, clocks, strict=False))


def _fits(row: Sequence[str], width: int, decimal: str) -> bool:
    """True if a row has `width` cells, or one more that is empty or a comment."""
    return len(row) == width or (len(row) == width + 1 and is_behind(row[-1], decimal))


def _filled(row: Sequence[str], likely: Sequence[bool], decimal: str) -> int:
    """Number of numeric columns that hold a number in this row; 0 if one of them holds anything else."""
    cells = [cell for cell, wanted in zip(row, likely, strict=False) if wanted and cell]
    return len(cells) if all(is_value(cell, decimal) for cell in cells) else 0


def _mostly_values(cells: Sequence[str], decimal: str) -> bool:
    """True if most of the cells that are not empty are numbers, and at least one is."""
    values = [is_value(cell, decimal) for cell in cells if cell]
    return 2 * sum(values) > len(values)


@dataclass(frozen=True)
class Dialect:
    """Format of a CSV file; rows count from 0."""

    encoding: str
    delimiter: str
    decimal: str
    header: tuple[str, ...]
    units: tuple[str, ...]
    headings: tuple[str, ...]
    first_data_row: int
    numeric: tuple[bool, ...]
    firsts: tuple[str, ...]
    """The first cell of each column that is not empty; "" where all in the sample are: what it holds is open."""
    has_marks: bool
    """True if the decimal mark is known: seen, set, or the point beside commas that separate."""
    preamble: tuple[str, ...]
    """The lines above the data."""
    texts: tuple[str, ...]
    """Content of the columns that are no numbers; "" for the others."""
    rewritten: bool
    """True if rows need more than to be split at the delimiter, as where some have a comment behind them."""
    above: frozenset[tuple[str, ...]]
    """The rows of names and units, which a logger may write once more where it begins anew."""

    def is_remark(self, line: str, cells: Sequence[str]) -> bool:
        """True if a line among rows of numbers is none of them: a comment, an event, a statistic, a row from above."""
        if COMMENT.match(line) and cells[0].lower() not in MISSING:
            return True
        if tuple(cells) in self.above or (self.numeric[0] and _STATISTIC.fullmatch(cells[0])):
            return True
        words = all(is_word(cell) and not (is_stamp(cell) and any(map(is_stamp, self.firsts))) for cell in cells)
        if len(cells) == len(self.headings):
            return words and any(map(_STATEMENT.search, cells))
        return words or (len(cells) == 1 and bool(_SENTENCE.search(line)))

    def check_same_segment(self, cells: Sequence[str], line: int) -> None:
        """Refuse a further segment of a LabVIEW measurement, which has a header and a start of its own."""
        if cells[0] in ("Channels", _LABVIEW) and any(above.startswith(_END_OF_HEADER) for above in self.preamble):
            raise UnreadableLogError(
                f"line {line} is the header of another segment (LabVIEW's Multi_Headings), whose time begins anew: cut "
                "the file there, and put the header of the file above each segment"
            )

    def begins_another(self, cells: Sequence[str]) -> bool:
        """True if a row of words in place of numbers is the heading of another table."""
        if not all(is_word(cell) and not is_stamp(cell) for cell in cells):
            return False
        names = len(set(cells)) == len(cells) > 2 and all(cell[:1].isalpha() for cell in cells)
        return names or not {*filter(None, self.headings)}.isdisjoint(cells)

    def describe(self) -> str:
        """The dialect in one line."""
        mark = {"\t": "tab", " ": "blank"}.get(self.delimiter, repr(self.delimiter))
        return (
            f"CSV found: encoding {self.encoding}, delimiter {mark}, decimal mark {self.decimal!r}, "
            f"data from row {self.first_data_row} (counted from 0)"
        )


def find_dialect(start: bytes, *, whole: bool, options: CsvOptions) -> Dialect:
    """Find the dialect from a file's first bytes; entries of `options` are taken as given.

    Parameters
    ----------
    start : bytes
        The first `SAMPLE_BYTES` bytes of the file.
    whole : bool
        True if these bytes are the whole file.
    options : CsvOptions
        Settings of the user.

    Raises
    ------
    UnreadableLogError
        Binary, undecodable, or no rows of numbers in a table.
    """
    encoding = options.encoding or text_encoding(start)
    lines = sample_lines(start, encoding, whole=whole)
    options = _as_labview(lines, options)
    table = find_table(lines, options)
    width = len(table.numeric)
    above, comments = _above(table, lines)
    header_row, units_row = _header_rows(table, above, comments, options.header_row)
    _check_rows_below_header(table, above, header_row)
    _check_commas(table, above)
    header, units, headings = _headings(table, above, header_row, units_row)
    if options.decimal is None and not table.shows_mark:
        _check_marks(table, header)
    in_seconds = bool(SECONDS.match(lines[table.first]))
    units = ("s", *units[1:]) if in_seconds else units
    check_long_table(header, table.numeric, table.rows[table.first :])
    firsts = tuple(_firsts(table))
    numeric = tuple(
        is_numeric or (not cell and bool(heading))
        for is_numeric, cell, heading in zip(table.numeric, firsts, headings, strict=True)
    )
    return Dialect(
        encoding=encoding,
        delimiter=table.delimiter,
        decimal=table.decimal,
        header=header,
        units=units,
        headings=headings,
        first_data_row=table.first,
        numeric=numeric,
        firsts=firsts,
        has_marks=options.decimal is not None or table.delimiter == "," or table.has_marks,
        preamble=tuple(lines[: table.first]),
        texts=tuple("" if is_numeric else _first_text(table, j) for j, is_numeric in enumerate(numeric)),
        rewritten=bool(table.delimiter == " " or table.ragged or in_seconds)
        or (header_row is not None and len(above[header_row]) == width + 1),
        above=frozenset([headings, *(tuple(table.rows[i]) for i in (header_row, units_row) if i is not None)])
        - {("",) * width},
    )


def _header_rows(
    table: SampleTable, above: list[Sequence[str]], comments: Sequence[bool], row: int | None
) -> tuple[int | None, int | None]:
    """The rows of names and of units; the settings may give the row of names."""
    width = len(table.numeric)
    names, units = rows_by_key(above)
    if row is None and names is not None and not _firsts(table)[0]:
        return names, units
    if row is None:
        row, below = heading_rows(above, comments, table.numeric)
    elif row >= table.first or not -1 <= width - len(above[row]) <= table.numeric[::-1].index(True):
        raise UnreadableLogError(f"row {row} is no header: it must have the {width} cells of the rows below it")
    else:
        below = row + 1 if row + 1 < table.first else None
    return row, units if below is None else below


def _as_labview(lines: Sequence[str], options: CsvOptions) -> CsvOptions:
    """The options with the row of the names of a LabVIEW measurement file: the one below its second header."""
    ends = [i for i, line in enumerate(lines) if line.startswith(_END_OF_HEADER)]
    if options.header_row is not None or not ends or not lines[0].startswith(_LABVIEW):
        return options
    return replace(options, header_row=ends[:2][-1] + 1)


def _headings(
    table: SampleTable, above: Sequence[Sequence[str]], header_row: int | None, units_row: int | None
) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Names and units of the columns, and the cells above them as they are written."""
    width = len(table.numeric)
    if header_row is None:
        return (*names_and_units((), (), width), ("",) * width)
    padded = [*above[header_row], *[""] * width][:width]
    names, units = names_and_units(padded, () if units_row is None else above[units_row], width)
    as_written = table.rows[header_row][:width]
    return names, units, tuple(as_written if len(as_written) == len(above[header_row][:width]) == width else padded)


def _firsts(table: SampleTable) -> list[str]:
    """The first cell of each column that is not empty, "" where there is none."""
    width = len(table.numeric)
    body = [row[:width] for row in table.rows[table.first :] if len(row) >= width]
    return [next(filter(None, column), "") for column in zip(*body, strict=True)]


def _first_text(table: SampleTable, column: int) -> str:
    """The first cell below the header that is no number, with its line counted from 1 where that is not the first."""
    cells = ((line, row[column]) for line, row in enumerate(table.rows) if line >= table.first and len(row) > column)
    texts = (each for each in cells if not is_value(each[1], table.decimal))
    line, cell = next(texts, (table.first, table.rows[table.first][column]))
    place = "" if line == table.first else f" in line {line + 1}"
    return "; ".join(filter(None, [f"{cell[:40]!r}{place}", marks_between_thousands(cell)]))


def _above(table: SampleTable, lines: list[str]) -> tuple[list[Sequence[str]], list[bool]]:
    """The rows above the data without marks of comments, and for each whether it had one."""
    width, lines = len(table.numeric), lines[: table.first]
    rows: list[Sequence[str]] = []
    for line in lines:
        cells = split_row(bare_line(line), table.delimiter)
        if len(cells) == width and _STATISTIC.fullmatch(cells[0]) and all(map(NUMBER.match, cells[1:])):
            cells = []
        while len(cells) > width and (not cells[-1] or "=" in cells[-1]):  # as of an oscilloscope, behind the names
            del cells[-1]
        rows.append(cells_above(line, cells, width) if table.delimiter == " " or COMMENT.match(line) else cells)
    return rows, [bool(COMMENT.match(line)) for line in lines]


def _check_marks(table: SampleTable, header: Sequence[str]) -> None:
    """Refuse marks that may separate thousands, because no number shows that decimals follow them.

    They may where other numbers of a column have none, where they are commas, and where the semicolon separates.
    """
    body = [(i, row) for i, row in enumerate(table.rows) if i >= table.first and len(row) == len(table.numeric)]
    for column, numeric in enumerate(table.numeric):
        cells = [(i, row[column]) for i, row in body if numeric]
        line, marked = next(((i, cell) for i, cell in cells if table.decimal in cell and not is_stamp(cell)), (0, ""))
        whole = any(NUMBER.match(cell) and table.decimal not in cell for _, cell in cells)
        if marked and (whole or table.decimal == "," or table.delimiter == ";"):
            raise UnreadableLogError(unclear_mark(marked, line + 1, header[column], table.decimal))


def _check_commas(table: SampleTable, above: Sequence[Sequence[str]]) -> None:
    """Refuse commas both between cells and before decimals: more cells than names, some with leading zeros as 007."""
    width = len(table.numeric)
    names = next(([cell for cell in row if cell] for row in reversed(above) if any(row)), [])
    if table.delimiter != "," or not 1 < len(names) < width <= 2 * len(names) or any(map(NUMBER.match, names)):
        return
    cells = [cell for row in table.rows[table.first :] for cell in row]
    decimal = next(filter(_LEADING_ZERO.fullmatch, cells), None)
    if decimal is not None and not any("." in cell for cell in cells):
        raise UnreadableLogError(
            f"its rows have {width} cells below {', '.join(map(repr, names))}, some of them as {decimal!r}: the comma "
            "separates cells and stands before decimals; export it with semicolons, or with decimal points"
        )


def _check_rows_below_header(table: SampleTable, above: Sequence[Sequence[str]], header_row: int | None) -> None:
    """Units may stand between the names and the data, numbers may not: they are a damaged row of data."""
    for i in range(max(table.first - 1, 0) if header_row is None else header_row + 1, table.first):
        cells = [cell for cell, numeric in zip(above[i], table.numeric, strict=False) if numeric]
        numbers = [cell for cell in cells if NUMBER.match(cell.replace(",", ".")) and cell != "1"]  # "1": no unit
        others = [cell for cell in cells if not is_value(cell, table.decimal)]
        keys = sum(bool(_KEY.fullmatch(cell)) for cell in others) >= len(numbers) or not _firsts(table)[0]
        if numbers and len(above[i]) >= len(table.numeric) and not (keys and _KEY.match(above[i][0])):
            marks = marks_between_thousands(others[0]) if others else ""
            where = f", where {others[0]!r} is no number," if others else ""
            raise UnreadableLogError(
                f"line {i + 1}: {others[0]!r} has {marks}"
                if marks
                else f"row {i} (counted from 0){where} stands above the data with the number {numbers[0]!r} in it: "
                "repair or delete that row"
            )
