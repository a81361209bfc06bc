"""Finding out how a CSV file is written: encoding, delimiter, decimal mark, preamble, header and units rows."""

import codecs
import re
from dataclasses import dataclass

from pipeline.rig_logs.source import CsvOptions, UnreadableLogError

SAMPLE_BYTES = 1 << 16
_CANDIDATES = ((";", ","), (";", "."), ("\t", ","), ("\t", "."), (",", "."), ("|", "."), ("|", ","), (" ", "."))
_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$")
MISSING = frozenset({"", "nan", "na", "n/a", "#n/a", "null", "-", "inf", "+inf", "-inf", "infinity", "-infinity"})
_UNIT_IN_NAME = re.compile(r"^(?P<name>.*\S)\s*[\[(](?P<unit>[^\[\]()]*)[\])]$")


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
    delimiter, decimal, first = _find_table(lines, options)
    cells = _split(lines[first], delimiter)
    header_row = options.header_row
    if header_row is None:
        header_row = first
        while header_row > 0 and len(_split(lines[header_row - 1], delimiter)) == len(cells):
            header_row -= 1
    if header_row > first or len(_split(lines[header_row], delimiter)) != len(cells):
        raise UnreadableLogError(f"row {header_row} has not the {len(cells)} cells of the data rows below it")
    headings = tuple(_split(lines[header_row], delimiter)) if header_row < first else ()
    units_row = tuple(_split(lines[header_row + 1], delimiter)) if header_row + 1 < first else ()
    header, units = _names_and_units(headings, units_row, len(cells))
    rows = [_split(line, delimiter) for line in lines[first : first + 200] if line.strip()]
    numeric = tuple(
        all(_is_number(row[j], decimal) for row in rows if len(row) == len(cells)) for j in range(len(cells))
    )
    return Dialect(encoding, delimiter, decimal, header, units, headings, first, numeric)


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
    lines = text.splitlines()
    return lines if whole else lines[:-1]


def _find_table(lines: list[str], options: CsvOptions) -> tuple[str, str, int]:
    """Delimiter, decimal mark and first row of the widest table of numbers in the sample."""
    best: tuple[int, str, str, int] | None = None
    for delimiter, decimal in _candidates(options):
        first, columns = _first_data_row(lines, delimiter, decimal, options.header_row)
        if first is not None and (best is None or columns > best[0]):
            best = columns, delimiter, decimal, first
    if best is None:
        raise UnreadableLogError(
            "no table of numbers found; if it is one, set [ingest.csv] encoding, delimiter, decimal and header_row"
        )
    return best[1:]


def _candidates(options: CsvOptions) -> list[tuple[str, str]]:
    pairs = [
        pair for pair in _CANDIDATES if options.delimiter in (None, pair[0]) and options.decimal in (None, pair[1])
    ]
    if options.delimiter is not None and not pairs:
        pairs = [(options.delimiter, options.decimal or ".")]
    return pairs


def _first_data_row(lines: list[str], delimiter: str, decimal: str, header_row: int | None) -> tuple[int | None, int]:
    """First row from which the sample's rows have one width and mostly numbers, and that width."""
    rows = [_split(line, delimiter) for line in lines]
    scores = [sum(_is_number(cell, decimal) and bool(cell) for cell in row) for row in rows]
    body = [i for i, line in enumerate(lines) if line.strip()]
    if not body:
        return None, 0
    width = len(rows[body[-1]])
    if width < 2 or scores[body[-1]] < 2:
        return None, 0
    first = body[-1]
    for i in reversed(body):
        if len(rows[i]) != width or scores[i] < 2 or (header_row is not None and i <= header_row):
            break
        first = i
    return first, scores[body[-1]]


def _split(line: str, delimiter: str) -> list[str]:
    parts = line.split() if delimiter == " " else line.rstrip("\r\n").split(delimiter)
    return [part.strip().strip('"').strip() for part in parts]


def _is_number(cell: str, decimal: str) -> bool:
    if cell.lower() in MISSING:
        return True
    return bool(_NUMBER.match(cell if decimal == "." else cell.replace(".", "x").replace(",", ".")))


def _names_and_units(
    headings: tuple[str, ...], units_row: tuple[str, ...], width: int
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    if not headings:
        return tuple(f"column {j + 1}" for j in range(width)), ("",) * width
    names, units = [], []
    for j, heading in enumerate(headings):
        match = _UNIT_IN_NAME.match(heading)
        unit = units_row[j].strip("[]() ") if units_row else ""
        names.append(match["name"] if match and not unit else heading or f"column {j + 1}")
        units.append(unit or (match["unit"].strip() if match else ""))
    return tuple(names), tuple(units)
