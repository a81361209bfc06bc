"""Workbooks of Excel and LibreOffice through calamine: the visible sheet of the most rows, read as the CSV that it is.

calamine rounds dates, times and durations to 1 ms. XLSX stores them as days with 15 digits, and calamine gives these
where it finds no styles. Such a file is therefore opened a second time with the name of its styles changed.
"""

import csv
import io
import math
import re
import zipfile
from collections.abc import Mapping
from dataclasses import replace
from datetime import date, datetime, time, timedelta
from pathlib import Path
from typing import Any

from python_calamine import CalamineError, CalamineWorkbook

from ..units.units import SECONDS
from .csv import CsvSource
from .source import CsvOptions, UnreadableLogError, View, temporary_path

_STYLES = b"xl/styles.xml"
_NO_STYLES = b"xl/unread.xml"
_LOCAL_HEADER = 30
"""Bytes before the name of a member in a ZIP file."""
_DAY_0 = datetime(1899, 12, 30)
_DAY_1 = datetime(1899, 12, 31)
"""Day from which Excel counts; calamine takes the first ones of 1900 for what Excel shows."""
_OPEN_FORMULA = re.compile(rb"(?:</f>|<f[^>]*/>)\s*(?:<v\s*/>|<v></v>)?\s*</c>")
_START = 100
"""Rows among which a heading stands."""
_DAY_NS = int(SECONDS["day"]) * 10**9
Rows = list[list[Any]]


class WorkbookSource(View):
    """A table as text in a temporary file, which lasts as long as this exists."""

    def __init__(self, path: Path, options: CsvOptions, *_: object) -> None:
        content = path.read_bytes()
        try:
            book = CalamineWorkbook.from_filelike(io.BytesIO(content))  # by its content, whatever its name ends in
            plain = _without_styles(content)
            numbers = CalamineWorkbook.from_filelike(io.BytesIO(plain)) if plain else None
            visible = [each.name for each in book.sheets_metadata if f"{each.visible}".endswith(".Visible")]
            sheets = {name: book.get_sheet_by_name(name) for name in visible or book.sheet_names}
            name = _one_table(sheets)
            rows = sheets[name].to_python(skip_empty_area=False)
            raw = rows if numbers is None else numbers.get_sheet_by_name(name).to_python(skip_empty_area=False)
        except (CalamineError, ValueError, OSError) as error:
            raise UnreadableLogError(f"the workbook cannot be opened: {error}") from error
        if plain and any(cell == "" for row in rows for cell in row):
            _check_formulas(content)
        written = temporary_path(self)
        mark = options.decimal or "."
        kinds = _clocks(rows)
        with written.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            for row, numbers_of_row in zip(rows, raw, strict=True):
                cells = zip(row, numbers_of_row, kinds, strict=False)
                writer.writerow([_text(cell, number, mark, clock) for cell, number, clock in cells])
        super().__init__(CsvSource(written, replace(options, encoding="utf-8", delimiter=",", decimal=mark)))
        self.format = "workbook"
        if others := ", ".join(repr(other) for other in book.sheet_names if other != name):
            self.warnings.append(f"of the sheets {name!r} is read, {others} not")
        if numbers is None and any(kinds):
            self.warnings.append("times of such a workbook are rounded to 1 ms; XLSX holds more digits")


def _without_styles(content: bytes) -> bytes:
    """The bytes of an XLSX file in which no styles are found, so that dates are numbers; b"" for other workbooks."""
    if not content.startswith(b"PK"):
        return b""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        if _STYLES.decode() not in archive.namelist():
            return b""
        local = archive.getinfo(_STYLES.decode()).header_offset + _LOCAL_HEADER
    changed = bytearray(content)
    for place in (local, content.rindex(_STYLES)):
        changed[place : place + len(_STYLES)] = _NO_STYLES
    return bytes(changed)


def _check_formulas(content: bytes) -> None:
    """Refuse an XLSX file with formulas that no program has worked out: their cells would be empty."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        sheets = (archive.read(name) for name in archive.namelist() if name.startswith("xl/worksheets/"))
        if any(_OPEN_FORMULA.search(sheet) for sheet in sheets):
            raise UnreadableLogError(
                "it has formulas without stored results: open it in a spreadsheet program and save it"
            )


def _is_time(cell: Any) -> bool:
    """True if a cell is a date (so is one at midnight), a time of day or a duration."""
    return isinstance(cell, date | time | timedelta)


def _first_of_numbers(rows: Rows) -> int:
    """The first row with two numbers or times; all rows are above it where there is none."""
    wanted = (sum(isinstance(cell, float | int) or _is_time(cell) for cell in row) > 1 for row in rows)
    return next((i for i, is_data in enumerate(wanted) if is_data), len(rows))


def _one_table(sheets: Mapping[str, Any]) -> str:
    """The sheet of the most rows.

    Raises
    ------
    UnreadableLogError
        Another one has as many columns, and the same heading or none: the table may go on there.
    """
    main = max(sheets, key=lambda name: sheets[name].total_height)
    heads = {name: _heading(each.to_python(False, _START)) for name, each in sheets.items()}
    alike = [name for name in sheets if heads[name] == heads[main] or [] in (heads[name], heads[main])]
    alike = [name for name in alike if heads[name] is not None and sheets[name].width == sheets[main].width]
    if len(alike) > 1:
        raise UnreadableLogError(
            f"the sheets {', '.join(map(repr, alike))} hold tables of one heading: save each as a file of its own, or "
            "where the table goes on, all as one CSV"
        )
    return main


def _heading(rows: Rows) -> Rows | None:
    """The cells above the first row of numbers, of rows that are as full as that; None where there are no numbers."""
    first = _first_of_numbers(rows)
    if first == len(rows):
        return None
    columns = [j for j, cell in enumerate(rows[first]) if cell != ""]
    above = [[row[j] for j in columns] for row in rows[:first]]
    return [cells for cells in above if all(cell != "" for cell in cells)]


def _clocks(rows: Rows) -> list[str]:
    """Format of the times of each column: "day" for times of day alone, else "stamp"; "" where there are none."""
    body = rows[min(_first_of_numbers(rows), len(rows) - 1) :] if rows else []
    types = [{type(cell) for cell in column if _is_time(cell)} for column in zip(*body, strict=True)]
    return ["" if each in (set(), {date}) else "day" if each == {time} else "stamp" for each in types]


def _text(cell: Any, number: Any, mark: str, clock: str) -> str:
    """A cell as CSV has it: numbers with all digits and this decimal mark, times by ISO 8601.

    Parameters
    ----------
    cell : float, str, datetime, …
        As calamine gives it.
    number : float or the same
        The days that a time is stored as, where they are known.
    mark : str
        Decimal mark.
    clock : {"", "day", "stamp"}
        Format of times: times of day, which may pass midnight, or with a date.
    """
    if clock and _is_time(cell):
        day, of_day = _stamp(number if isinstance(number, float | int) else cell)
        return of_day if clock == "day" else f"{day} {of_day}"
    return repr(cell).replace(".", mark) if isinstance(cell, float) else f"{cell}"


def _stamp(cell: date | time | timedelta | float) -> tuple[date, str]:
    """The date and the time of day of a time, or of a number of days, which is exact to a nanosecond."""
    if isinstance(cell, float | int):
        days = math.floor(cell)
        seconds, nanoseconds = divmod(round((cell - days) * _DAY_NS), 10**9)
        stamp = _DAY_0 + timedelta(days=days, seconds=seconds)
        return stamp.date(), f"{stamp:%H:%M:%S}.{nanoseconds:09d}"
    if isinstance(cell, timedelta):
        cell = _DAY_0 + cell
    if isinstance(cell, time):
        cell = datetime.combine(_DAY_1, cell)
    stamp = cell if isinstance(cell, datetime) else datetime.combine(cell, time())
    return stamp.date(), stamp.time().isoformat()


open_log = WorkbookSource
