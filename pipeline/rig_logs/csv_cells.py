"""Type of a cell of a CSV file: a number, a time of day, a switch, or missing; and ambiguous marks."""

import csv
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from ..store.arrow_columns import doubles
from ..units.units import SECONDS as SECONDS_IN

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
    """A number with a decimal point; other cells as they are, but for such a point."""
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
        First time [ns] of the columns of one log, by the time [ns] after which they begin anew; the first to be read
        sets it, so that what lies between two clocks stays.

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
    pairs = [*zip(keys.get("X0", []), keys.get("Delta_X", []), strict=False)]
    clocks = [(float(start), float(step)) for start, step in pairs if NUMBER.match(start) and NUMBER.match(step)]
    alike = len(set(clocks)) < 2 or min(step for _, step in clocks) <= 0.0
    return () if alike else (clocks[0], *clocks, *clocks[-1:] * width)[:width]
