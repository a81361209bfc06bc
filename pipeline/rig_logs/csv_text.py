"""The text of a CSV file: its bytes, its rows, and the type of a cell (number, time of day, switch, missing)."""

import codecs
import csv
import io
import mmap
import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from ..store.arrow_columns import doubles
from ..units.units import SECONDS as SECONDS_IN
from .source import PART, UnreadableLogError, temporary_path

_TAIL_BYTES = 1 << 16
_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_NO_TEXT = "this is no text and no format that is known here; export the log as CSV, MAT, MDF4, HDF5 or Parquet"
_GROUPED = re.compile(
    r"[-+]?\d{1,3}(?P<mark>[.,'’ \u00a0\u202f])\d{3}(?:(?P=mark)\d{3})*(?P<fraction>(?!(?P=mark))[.,]\d+)?"
)
_BEGINS_AS_NUMBER = re.compile(r"[-+(]?\s*(?!1[.]#)[.,]?\d")
COMMENT = re.compile(r"\s*(?:#|%|//)+\s*")
_ROW_END = re.compile(r"\r\n|\r|\n")
_DIGITS = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
NUMBER = re.compile(rf"[+-]?{_DIGITS}$")
SECONDS = re.compile(rf"(NaN|[+-]?{_DIGITS}) sec(?=[,;\t|])")
"""A time at the beginning of a row, as MATLAB's `writetimetable` writes it."""
MISSING = frozenset(
    {"", "nan", "-nan", "nan(ind)", "-nan(ind)", "na", "n/a", "null", "none", "-", "--", "---", "."}
    | {"#n/a", "#nv", "#value!", "#wert!", "#div/0!", "#ref!", "#num!", "#name?", "#null!"}
    | {"1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind"}
    | {"inf", "+inf", "-inf", "infinity", "-infinity"}
)
SWITCH = frozenset({"true", "false"})
STAMP = re.compile(r"\d{4}-\d\d-\d\d[ T]\d\d:\d\d:\d\d(\.\d{1,9})?(?P<zone>Z|[+-]\d\d:?\d\d)?")
"""Date and time of day by ISO 8601."""
_DATE = r"(?:19|20)\d\d(?:0[1-9]|1[0-2])(?:0[1-9]|[12]\d|3[01])"
CLOCKS = (
    r"^\[?(?:(?:[^:]*?(?:[T ,]|\d[_-]))|\d{3}:)??"
    r"(?:(?P<h>\d{1,2}):(?P<m>\d{1,2}):(?P<s>\d{1,2}(?:[.,:]\d{1,9}| \d{3})?)"
    r"|(?P<mm>\d{1,3}):(?P<ss>\d{1,2}[.,]\d{1,9}))"
    r"(?:[ \x{a0}\x{202f}]?(?P<half>[AaPp][.]? ?[Mm][.]?))?"
    r"(?: ?[+-]\d\d:?\d\d| [A-Z]{1,5}|Z| \d{4}| \d{1,4}[./-]\d\d?[./-]\d{2,4})*\]?$",
    rf"^{_DATE}[T _-]?(?P<h>[01]\d|2[0-3])(?P<m>[0-5]\d)(?P<s>[0-5]\d(?:[.,]?\d{{1,9}})?)(?:Z|[+-]\d\d:?\d\d)?$",
)
"""Time of day with colons, whatever date stands before it, or minutes and seconds with a fraction, zones and years
behind it; date and time in one number. As Arrow's expressions."""
_DIGITS_OF_STAMP = 14
"""Fewest digits of date and time in one number."""
_SAMPLED = 1 << 14
"""Cells whose kind is remembered: each of the sample is looked at for every delimiter and decimal mark."""


def text_encoding(start: bytes) -> str:
    """The encoding by the first bytes of a file: UTF-8 or UTF-16, else a Western one, in which numbers are the same.

    The five bytes that stand for nothing in that of Windows are letters in that of DOS, as ü.

    Raises
    ------
    UnreadableLogError
        They are no text.
    """
    for bom, encoding in _BOMS:
        if start.startswith(bom):
            return encoding
    for parity, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):  # of numbers, every other byte is zero
        if b"\0" not in start[1 - parity :: 2] and 2 * start[parity::2].count(0) > len(start[parity::2]):
            return encoding
    start = start.strip(b"\0")
    control = sum(byte < 32 and byte not in b"\t\n\r\f" for byte in start)
    before, zero, _ = start.partition(b"\0")
    if zero:
        line = len(rows_of(before.decode("latin-1") + "."))
        damaged = f"a zero byte in line {line}, which is no text: repair or delete that line"
        raise UnreadableLogError(_NO_TEXT if control > len(start) // 1000 else damaged)
    try:
        codecs.getincrementaldecoder("utf-8")().decode(start)
        return "utf-8"
    except UnicodeDecodeError:
        if control > len(start) // 1000:
            raise UnreadableLogError(_NO_TEXT) from None
        if re.search(rb"[\x81\x8d\x8f\x90\x9d]", start):
            return "cp850"
        return "cp1252" if re.search(rb"[\x80-\x9f]", start) else "latin-1"


def as_utf8(path: Path, length: int, encoding: str, owner: object) -> Any:
    """The first `length` bytes as UTF-8.

    Arrow's threads read ahead. Were they to hold memory of Python's, as they would of a Python file or of a codec,
    one of them could abort the interpreter while it is taken down. A file is read block by block, whereas pages of
    a mapped one stay in memory.

    Parameters
    ----------
    path : Path
        The log.
    length : int
        Bytes that are whole rows.
    encoding : str
        Its text encoding.
    owner : object
        Reader of it; see `written`.
    """
    if not _is_ascii_and_more(encoding):
        with text_of(path, length, encoding, newline="") as lines:
            return written(lines, owner)
    return _whole_rows_of(path, length)  # what is beyond ASCII stands in no number


def written(lines: Iterable[str], owner: object) -> Any:
    """Lines in a file of Arrow's own, which vanishes with it, on Windows with the `owner`."""
    path = temporary_path(owner)
    rest = iter(lines)
    with path.open("wb") as file:
        while some := list(islice(rest, PART)):
            file.write("".join(some).encode())
    opened = pa.OSFile(str(path))
    with suppress(PermissionError):  # as on Windows, where an open file stays
        path.unlink()
    return opened


def text_of(path: Path, length: int, encoding: str, newline: str | None = None) -> io.TextIOWrapper:
    """The first `length` bytes as text, to be read in order.

    Parameters
    ----------
    path : Path
        The file.
    length : int
        Bytes that are read.
    encoding : str
        Encoding of the text.
    newline : str, optional
        As of `io.TextIOWrapper`.
    """
    whole = length == path.stat().st_size  # by Python, which opens a name in any encoding
    return io.TextIOWrapper(path.open("rb") if whole else _whole_rows_of(path, length), encoding, newline=newline)


def _whole_rows_of(path: Path, length: int) -> Any:
    """The first `length` bytes in a file of Arrow's own; where that is less than all, in a mapped buffer."""
    if length == path.stat().st_size:
        return pa.OSFile(str(path))
    with pa.memory_map(str(path)) as mapped:
        return pa.BufferReader(mapped.read_buffer(length))


def _is_ascii_and_more(encoding: str) -> bool:
    """True if every ASCII character is its own single byte, which means nothing else anywhere."""
    every = bytes(range(256))
    decoded = every.decode(encoding, "replace")
    return len(decoded) == len(every) and decoded[:128].encode() == every[:128]


def last_rows(content: bytes | mmap.mmap, end: int, encoding: str) -> tuple[list[str], int]:
    """The rows in the last 64 kB of a file, and how many bytes at its end belong to a row without line end.

    Parameters
    ----------
    content : bytes-like
        The whole file.
    end : int
        Its bytes that are text.
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
    start = max(0, end - _TAIL_BYTES)
    start -= start % width
    if width == 1:  # line ends are single bytes in all of these, whatever stands between them
        codec = "latin-1"
    text = content[start:end].decode(codec)
    return rows_of(text), len(text[max(text.rfind("\n"), text.rfind("\r")) + 1 :].encode(codec))


def bytes_written(content: bytes | mmap.mmap) -> int:
    """Bytes of a file before the zeros at its end, which stay where a logger that took space lost its power."""
    end = len(content)
    while end and content[end - 1] == 0:
        begin = max(0, end - _TAIL_BYTES)
        end = begin + len(content[begin:end].rstrip(b"\0"))
    return end


_CLOCKS = [re.compile(re.sub(r"\\x{(\w+)}", lambda code: chr(int(code[1], 16)), form)) for form in CLOCKS]


def clock_of(cell: str) -> tuple[str, re.Match[str]] | None:
    """Format of a time of day, of `CLOCKS`, and its parts; None for any other cell."""
    matches = ((form, own.match(cell)) for form, own in zip(CLOCKS, _CLOCKS, strict=True))
    return next(((form, match) for form, match in matches if match), None)


@lru_cache(_SAMPLED)
def is_stamp(cell: str) -> bool:
    """True if a cell is a time of day, with or without a date."""
    if len(cell) < _DIGITS_OF_STAMP and NUMBER.match(cell):
        return False
    return bool(STAMP.fullmatch(cell)) or clock_of(cell) is not None


def plain_number(cell: str, decimal: str) -> str:
    """A cell with its decimal mark as a point; where that is another mark, points become x, as no number has them."""
    return cell if decimal == "." else cell.replace(".", "x").replace(decimal, ".")


@lru_cache(_SAMPLED)
def is_value(cell: str, decimal: str) -> bool:
    """True if a cell is a number, a switch, missing, or a time stamp."""
    if cell.lower() in MISSING or cell.lower() in SWITCH or NUMBER.match(plain_number(cell, decimal)):
        return True
    return is_stamp(cell)


def is_word(cell: str) -> bool:
    """True if a cell is a word in place of a number, as ``OVER``, ``----`` and C's ``1.#INF``."""
    return not _BEGINS_AS_NUMBER.match(cell)


def plain_row(delimiter: str, width: int) -> re.Pattern[str]:
    """Pattern of a line of `width` numbers and nothing else, each as Arrow reads it, without a plus sign."""
    edge, between = ("[ \t]*", "[ \t]+") if delimiter == " " else (" *", f" *{re.escape(delimiter)} *")
    return re.compile(rf"{edge}-?{_DIGITS}(?:{between}-?{_DIGITS}){{{width - 1}}}{edge}")


def is_behind(cell: str, decimal: str) -> bool:
    """True if a cell beyond the last column may be left out: it is empty, or a comment."""
    return not cell or not is_value(cell, decimal)


def rows_of(text: str) -> list[str]:
    """Rows of a text; those of `str.splitlines` end at characters, too, which may stand within a cell."""
    rows = _ROW_END.split(text)
    return rows if rows[-1] else rows[:-1]


def split_row(line: str, delimiter: str) -> list[str]:
    """Cells of a line; quotes around a cell protect delimiters in it."""
    line = SECONDS.sub(r"\1", line, count=1) if SECONDS.match(line) else line
    if delimiter == " ":
        return _unquoted(" ".join(line.split()), " ") if '"' in line else line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.split(delimiter)]
    return [cell.strip() for cell in _unquoted(line, delimiter)]


def _unquoted(line: str, delimiter: str) -> list[str]:
    """Cells of a line with quotes; a heading of over 128 kB is one cell under a delimiter that is not in it."""
    try:
        return next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    except csv.Error:
        return line.split(delimiter)


def unclear_mark(cell: str, line: int, column: str, mark: str) -> str:
    """Message on an ambiguous mark, which separates either decimals or thousands.

    Parameters
    ----------
    cell : str
        The first cell with it.
    line : int
        Its line, counted from 1.
    column : str
        The name of its column.
    mark : str
        The point or the comma.
    """
    return (
        f"{cell!r} in line {line}, column {column!r}: does {mark!r} separate thousands? Nothing in the first rows "
        f"shows it. Export the log without such separators; if it is the decimal mark, set [ingest.csv] decimal = "
        f"{mark!r}"
    )


def marks_between_thousands(cell: str) -> str:
    """Message on a cell in which marks stand between thousands; empty for any other one."""
    return "marks between thousands: export it without them" if _GROUPED.fullmatch(cell) else ""


class Clock:
    """A column of times of day, or of minutes and seconds, read part by part.

    Parameters
    ----------
    first : str
        The first cell that is not empty.
    origins : dict of float to float
        First time [ns] of the columns of one log, by the time [ns] after which they begin anew. The first column to be
        read sets it, so that the time between two clocks is kept.

    Attributes
    ----------
    turn : float
        That time of this column.
    note : str
        What it counts from if it is the first to be read.
    """

    def __init__(self, first: str, origins: dict[float, float]) -> None:
        self._origins = origins
        self._last = 0.0
        self._form, match = clock_of(first) or ("", None)
        self.turn = 1e9 * SECONDS_IN["day" if match and match["h"] else "h"]
        begins = min((match.start(part) for part, text in match.groupdict().items() if text), default=0) if match else 0
        self.note = f"counts from {first}" + ("; its date is not used" if begins > 1 else "")

    def seconds(self, cells: Any) -> NDArray[Any]:
        """The seconds of a part of the column since the first cell of the log's clocks, NaN where a cell is empty.

        Raises
        ------
        ValueError
            A cell is no time.
        """
        matched = pc.extract_regex(cells, self._form)
        if matched.null_count > cells.null_count:
            raise ValueError("a time cannot be read")
        parts = {each.name for each in matched.type}

        def part(name: str) -> Any:
            """The numbers of one part, 0 where it is not written."""
            if name not in parts:
                return 0.0
            text = pc.replace_substring_regex(pc.struct_field(matched, name), "[,: ]", ".")
            text = pc.replace_substring_regex(text, r"^(\d\d)(\d)", r"\1.\2")  # as in 20261127101500123
            return doubles(pc.if_else(pc.equal(text, ""), "0", text).cast(pa.float64()))

        hours = part("h")
        if "half" in parts:
            half = pc.struct_field(matched, "half")
            of_twelve, after_noon = (
                doubles(pc.match_substring_regex(half, form).cast(pa.float64())) for form in (".", "[Pp]")
            )
            hours = np.where(of_twelve > 0.0, hours % 12.0 + 12.0 * after_noon, hours)
        seconds = SECONDS_IN["h"] * hours + SECONDS_IN["min"] * (part("m") + part("mm")) + part("s") + part("ss")
        return self._onwards(np.rint(1e9 * seconds))

    def _onwards(self, times: NDArray[Any]) -> NDArray[Any]:
        """Times [ns] within a day (or an hour) from the first one on, in s: back by more than half is the next one."""
        filled = np.flatnonzero(np.isfinite(times))
        if not filled.size:
            return times
        since = times - self._origins.setdefault(self.turn, float(times[filled[0]]))
        steps = np.diff(since[filled], prepend=self._last % self.turn)
        turns = np.floor(self._last / self.turn) + np.cumsum(steps < -self.turn / 2.0)
        if self._last == 0.0 and steps[0] > self.turn / 2.0:  # it begins before the origin, and that after midnight
            turns -= 1.0
        since[filled] += self.turn * turns
        self._last = float(since[filled[-1]])
        return since / 1e9


def labview_starts(above: Sequence[Sequence[str]], width: int) -> tuple[tuple[float, float], ...]:
    """X0 and Delta_X [s] of each column, in the rows above the data; () where all have one clock, or columns of time.

    Parameters
    ----------
    above : sequence of rows
        Their cells, the key first.
    width : int
        Number of columns.
    """
    keys = {row[0]: [cell.replace(",", ".") for cell in row[1:]] for row in above if row}
    if keys.get("X_Columns", ["Multi"])[0] == "Multi" or "Time" not in keys.get("X_Dimension", []):
        return ()
    clocks = [
        (float(start), float(step))
        for start, step in zip(keys.get("X0", []), keys.get("Delta_X", []), strict=False)
        if NUMBER.match(start) and NUMBER.match(step)
    ]
    alike = len(set(clocks)) < 2 or min(step for _, step in clocks) <= 0.0
    return () if alike else (clocks[0], *clocks, *clocks[-1:] * width)[:width]
