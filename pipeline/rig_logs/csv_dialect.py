"""Finding out how a CSV file is written: encoding, delimiter, decimal mark, preamble, header and units rows, and
whether its last row is there in full.
"""

import codecs
import csv
import mmap
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from pipeline.rig_logs.csv_heading import bare_line, cells_of_comment, heading_rows, is_comment, names_and_units
from pipeline.rig_logs.source import CsvOptions, UnreadableLogError

_TAIL_BYTES = 1 << 16
_FEWEST = 10
_ROW_END = re.compile(r"\r\n|\r|\n")
_DIGITS = re.compile(r"[+-]?\d*(?:[.,](?P<fraction>\d+))?(?:[eE][+-]?(?P<exponent>\d+))?$")
_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}[.,]\d{3}")
_GROUPED = re.compile(r"[-+]?\d{1,3}(?:[.,'’ ]\d{3})+(?:[.,]\d+)?")
_PLAIN_WHOLE = re.compile(r"[-+]?\d{1,3}")
_FEW_CELLS = 3


def last_rows(content: bytes | mmap.mmap, encoding: str) -> tuple[list[str], int]:
    """The rows in the last 64 kB of a file, and how many bytes at its end belong to a row without line end.

    Parameters
    ----------
    content : bytes-like
        The whole file.
    encoding : str
        Its text encoding.

    Raises
    ------
    UnicodeDecodeError
        The file ends within a character of two bytes or more.
    """
    codec = encoding
    if encoding == "utf-16":
        codec = "utf-16-be" if content[:2] == codecs.BOM_UTF16_BE else "utf-16-le"
    width = len("0".encode(codec)) if codec != "utf-8-sig" else 1
    start = max(0, len(content) - _TAIL_BYTES)
    start -= start % width
    tail = content[start:]
    if width == 1:  # line ends are single bytes in all of these, whatever stands between them
        codec = "latin-1"
    text = tail.decode(codec)
    end = max(text.rfind("\n"), text.rfind("\r")) + 1
    return _rows(text), len(text[end:].encode(codec))


def is_whole(cell: str, before: Sequence[str]) -> bool:
    """Whether a number cannot have been cut off: it has as many decimals (and digits of the exponent) as all before.

    Parameters
    ----------
    cell : str
        The last cell of the file.
    before : sequence of str
        The cells above it; ten of them at least, all of one form, are needed to tell.
    """
    forms = [form for text in before if (form := _form(text)) is not None]  # what is no number is a heading
    return len(forms) >= _FEWEST and set(forms) == {_form(cell)} and forms[0] != (0, 0)


def _form(cell: str) -> tuple[int, int] | None:
    match = _DIGITS.match(cell)
    return match and (len(match["fraction"] or ""), len(match["exponent"] or ""))


SAMPLE_BYTES = 1 << 16
_MOST_ROWS = 400
_CANDIDATES = ((";", ","), (";", "."), ("\t", ","), ("\t", "."), (",", "."), ("|", "."), ("|", ","), (" ", "."))
_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$")
MISSING = frozenset(
    {"", "nan", "-nan", "nan(ind)", "-nan(ind)", "na", "n/a", "null", "none", "-", "--", "---", "."}
    | {"#n/a", "#nv", "#value!", "#wert!", "#div/0!"}
    | {"inf", "+inf", "-inf", "infinity", "-infinity"}
)
STAMP = re.compile(r"\d{4}-\d\d-\d\d[ T]\d\d:\d\d:\d\d(\.\d{1,9})?(?P<zone>Z|[+-]\d\d:?\d\d)?")
"""Date and time of day by ISO 8601."""
CLOCK = re.compile(r"\d\d:\d\d:\d\d([.,]\d{1,9})?")
"""Time of day alone, as where the date stands in a column of its own."""


@dataclass(frozen=True)
class Text:
    """The first cell of a column that is no number, how to show it, and what to do if that is not plain."""

    cell: str
    shown: str
    way_out: str


@dataclass(frozen=True)
class Dialect:
    """How a CSV file is written; rows count from 0."""

    encoding: str
    delimiter: str
    decimal: str
    header: tuple[str, ...]
    units: tuple[str, ...]
    headings: tuple[str, ...]
    first_data_row: int
    numeric: tuple[bool, ...]
    first_row: tuple[str, ...]
    open_marks: tuple[bool, ...]
    """Of which columns it is open yet whether `decimal` stands before decimals or between thousands."""
    texts: tuple["Text | None", ...]
    """What stands in the columns that are no numbers; None for the others."""

    def describe(self) -> str:
        """The dialect in one line."""
        mark = {"\t": "tab", " ": "blank"}.get(self.delimiter, repr(self.delimiter))
        return (
            f"CSV found: encoding {self.encoding}, delimiter {mark}, decimal mark {self.decimal!r}, "
            f"data from row {self.first_data_row} (counted from 0)"
        )


def find_dialect(start: bytes, *, whole: bool, options: CsvOptions) -> Dialect:
    """Find the dialect from a file's first bytes; what `options` says is taken as said.

    Parameters
    ----------
    start : bytes
        The first `SAMPLE_BYTES` bytes of the file.
    whole : bool
        Whether that is the whole file.
    options : CsvOptions
        What the user configured.

    Raises
    ------
    UnreadableLogError
        Binary, undecodable, or no rows of numbers in a table.
    """
    encoding = options.encoding or _find_encoding(start)
    lines = _lines(start, encoding, whole=whole)
    table = _find_table(lines, options)
    width, header_row = len(table.numeric), options.header_row
    _check_decimal_commas(table)
    open_marks = (False,) * width if options.decimal is not None else _open_marks(table)
    above, comments = _above(table, lines)
    if header_row is None:
        header_row, units_row = heading_rows(above, comments, width)
    elif header_row >= table.first or len(above[header_row]) != width:
        raise UnreadableLogError(f"row {header_row} is no header: it must have the {width} cells of the rows below it")
    else:
        units_row = header_row + 1 if header_row + 1 < table.first else None
    _check_rows_below_header(table, table.first if header_row is None else header_row)
    named = () if header_row is None else above[header_row][:width]
    header, units = names_and_units(named, () if units_row is None else above[units_row], width)
    as_written = () if header_row is None else table.rows[header_row][:width]
    headings = tuple(as_written if len(as_written) == len(named) else named)
    first_row = tuple(table.rows[table.first])
    unnamed = [not heading and empty for heading, empty in zip(headings, _empty(table), strict=False)]
    numeric = tuple(is_numeric and not any(unnamed[j : j + 1]) for j, is_numeric in enumerate(table.numeric))
    return Dialect(
        encoding,
        table.delimiter,
        table.decimal,
        header,
        units,
        headings,
        table.first,
        numeric,
        first_row,
        open_marks,
        tuple(None if is_numeric else _first_text(table, j) for j, is_numeric in enumerate(numeric)),
    )


def _first_text(table: "_Table", column: int) -> Text:
    """The first cell below the header that is no number, with its line counted from 1 where that is not the first."""
    cells = ((line, row[column]) for line, row in enumerate(table.rows) if line >= table.first and len(row) > column)
    texts = (each for each in cells if not _is_value(each[1], table.decimal, table.delimiter))
    line, cell = next(texts, (table.first, table.rows[table.first][column]))
    shown = f"{cell[:40]!r}" if line == table.first else f"{cell[:40]!r} in line {line + 1}"
    return Text(cell, shown, marks_between_thousands(cell))


def _above(table: "_Table", lines: list[str]) -> tuple[list[Sequence[str]], list[bool]]:
    """The rows above the data without marks of comments, and which had one."""
    width, comments = len(table.numeric), [is_comment(line) for line in lines[: table.first]]
    rows: list[Sequence[str]] = []
    for line, commented in zip(lines, comments, strict=False):
        cells = split_row(bare_line(line), table.delimiter)
        rows.append(cells_of_comment(line, cells, width) if commented else cells)
    return rows, comments


def _empty(table: "_Table") -> list[bool]:
    """Which columns hold nothing, as behind a delimiter at the end of each row."""
    body = [row for row in table.rows[table.first :] if len(row) == len(table.numeric)]
    return [not any(column) for column in zip(*body, strict=True)]


def _check_decimal_commas(table: "_Table") -> None:
    """Commas that separate and are decimal marks too: more cells than names, at most twice as many."""
    above = table.rows[table.first - 1] if table.first else []
    names = len(above)
    if table.delimiter == "," and 2 <= names < len(table.numeric) <= 2 * names and not any(map(_NUMBER.match, above)):
        raise UnreadableLogError(
            f"{names} names stand above rows of {len(table.numeric)} cells; is the comma separator and decimal mark at "
            "once? Export it with another separator, such as the semicolon"
        )


def _open_marks(table: "_Table") -> tuple[bool, ...]:
    """In which columns the rows that were seen do not tell whether the mark is for decimals; see `mark_is_open`."""
    body = [row for row in table.rows[table.first :] if len(row) == len(table.numeric)]
    return tuple(
        numeric and mark_is_open((row[column] for row in body), table.decimal)
        for column, numeric in enumerate(table.numeric)
    )


def mark_is_open(cells: Iterable[str], decimal: str) -> bool:
    """Whether the cells of a column leave open if its mark stands before decimals or between thousands.

    It may be between thousands where every one has three digits behind it, none a zero alone before it, and whole
    numbers below a thousand stand beside them. The first other cell settles it.

    Raises
    ------
    UnreadableLogError
        There are several of both, so that it most likely is.
    """
    marked, plain = [], []
    for cell in cells:
        if cell.lower() in MISSING:
            continue
        if _PLAIN_WHOLE.fullmatch(cell):
            plain.append(cell)
        elif decimal in cell and _THOUSANDS.fullmatch(cell):
            marked.append(cell)
        else:
            return False
        del marked[_FEW_CELLS:], plain[_FEW_CELLS:]
    if min(len(marked), len(plain)) >= _FEW_CELLS:
        raise UnreadableLogError(
            f"{marked[0]!r} stands beside {plain[0]!r}: does {decimal!r} separate thousands? Export without "
            f"such separators; if it is the decimal mark, set [ingest.csv] decimal = {decimal!r}"
        )
    return True


def marks_between_thousands(cell: str) -> str:
    """What to say of a cell in which marks stand between thousands; nothing of any other one."""
    return "marks between thousands: export it without them" if _GROUPED.fullmatch(cell) else ""


def no_number(cell: str, column: str, decimal: str) -> str:
    """What to say of a cell that is no number."""
    if marks := marks_between_thousands(cell):
        return f"{cell!r} in column {column!r} has {marks}"
    return (
        f"{cell!r} in column {column!r} is no number with the decimal mark {decimal!r}: repair or delete that row, or "
        "leave the cell empty for a missing value"
    )


def _check_rows_below_header(table: "_Table", header_row: int) -> None:
    """Units may stand between the names and the data, numbers may not: they are a damaged row of data."""
    for i in range(header_row + 1, table.first):
        cells = [cell for cell, numeric in zip(table.rows[i], table.numeric, strict=False) if numeric]
        numbers = [cell for cell in cells if _NUMBER.match(cell.replace(",", ".")) and cell != "1"]  # "1": no unit
        others = [cell for cell in cells if not _is_value(cell, table.decimal)]
        if numbers:
            where = f", where {others[0]!r} is no number," if others else ""
            raise UnreadableLogError(
                f"row {i} (counted from 0){where} stands above the data with the number {numbers[0]!r} in it: repair "
                "or delete that row"
            )


@dataclass(frozen=True)
class _Table:
    """The sample under one reading: its cells, its first row of data, and which columns are numbers."""

    delimiter: str
    decimal: str
    rows: list[list[str]]
    first: int
    numeric: tuple[bool, ...]


def _find_encoding(start: bytes) -> str:
    for bom, encoding in _BOMS:
        if start.startswith(bom):
            return encoding
    if b"\0" in start:
        raise UnreadableLogError("this is no text and no format that is known here")
    try:
        codecs.getincrementaldecoder("utf-8")().decode(start)
        return "utf-8"
    except UnicodeDecodeError:
        control = sum(byte < 32 and byte not in b"\t\n\r\f" for byte in start)
        if control > len(start) // 1000:
            raise UnreadableLogError("this is no text and no format that is known here") from None
        return "latin-1" if any(0x80 <= byte < 0xA0 for byte in start) is False else "cp1252"


def _lines(start: bytes, encoding: str, *, whole: bool) -> list[str]:
    try:
        text = codecs.getincrementaldecoder(encoding)().decode(start)
    except LookupError:
        raise UnreadableLogError(f"unknown text encoding {encoding!r}") from None
    except UnicodeDecodeError as error:
        raise UnreadableLogError(f"not encoded as {encoding}: {error.reason} at byte {error.start}") from None
    lines = _rows(text)
    return lines if whole else lines[:-1]


def _rows(text: str) -> list[str]:
    """Its rows; those of `str.splitlines` end at characters, too, which may stand within a cell."""
    rows = _ROW_END.split(text)
    return rows if rows[-1] else rows[:-1]


def _find_table(lines: list[str], options: CsvOptions) -> _Table:
    """The reading of the sample that gives the most columns of numbers."""
    tables = [_table(lines, delimiter, decimal, options.header_row) for delimiter, decimal in _candidates(options)]
    found = [table for table in tables if table is not None]
    if not found:
        way_out = "if it is one, set [ingest.csv] encoding, delimiter, decimal and header_row"
        if _is_single_column(lines):
            way_out = (
                "it holds a single one; if input and displacement stand in files of their own, join them as columns of "
                "one file"
            )
        raise UnreadableLogError(f"no table of numbers with two columns or more found; {way_out}")
    return max(found, key=lambda table: sum(table.numeric))


def _is_single_column(lines: list[str]) -> bool:
    """Whether most lines are one number each."""
    cells = [line.strip(' \t"') for line in lines[:_MOST_ROWS] if line.strip()]
    return 2 * sum(_is_value(cell, ".") for cell in cells) > len(cells)


def _candidates(options: CsvOptions) -> list[tuple[str, str]]:
    pairs = [
        pair for pair in _CANDIDATES if options.delimiter in (None, pair[0]) and options.decimal in (None, pair[1])
    ]
    if options.delimiter is not None and not pairs:
        pairs = [(options.delimiter, options.decimal or ".")]
    return pairs


def _table(lines: list[str], delimiter: str, decimal: str, header_row: int | None) -> _Table | None:
    """The sample as a table, None if it is none: the width is the most frequent one, a column holds numbers if
    most of its cells do, and data begin with the first row whose cells there are numbers. A later row that does
    not fit is no preamble but an error, which the parser reports.
    """
    rows = [split_row(line, delimiter) for line in lines[:_MOST_ROWS]]
    width = Counter(len(row) for row in rows if any(row)).most_common(1)[0][0] if any(map(any, rows)) else 0
    body = [row for row in rows[0 if header_row is None else header_row + 1 :] if len(row) == width]
    if width < 2 or not body:
        return None
    numbers = [[_is_value(cell, decimal, delimiter) for cell in row] for row in body[len(body) // 2 :]]
    numeric = tuple(2 * sum(column) > len(numbers) for column in zip(*numbers, strict=True))
    if sum(numeric) < 2:
        return None
    for i, row in enumerate(rows):
        after_header = header_row is None or i > header_row
        if (
            after_header
            and len(row) == width
            and all(
                _is_value(cell, decimal, delimiter) for cell, is_numeric in zip(row, numeric, strict=True) if is_numeric
            )
        ):
            return _Table(delimiter, decimal, rows, i, numeric)
    return None


def split_row(line: str, delimiter: str) -> list[str]:
    """Cells of a line; quotes around a cell protect delimiters in it."""
    if delimiter == " ":
        return line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.split(delimiter)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter), [])]


def _is_value(cell: str, decimal: str, delimiter: str = "") -> bool:
    """Whether a cell is a number, missing, or a time stamp, which columns between blanks cannot be."""
    if cell.lower() in MISSING or (delimiter != " " and (STAMP.fullmatch(cell) or CLOCK.fullmatch(cell))):
        return True
    return bool(_NUMBER.match(cell if decimal == "." else cell.replace(".", "x").replace(",", ".")))
