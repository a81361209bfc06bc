"""Workbooks of Excel and LibreOffice through calamine: the sheet of the most rows, read as the CSV that it would be."""

import csv
from dataclasses import replace
from datetime import datetime, time, timedelta
from pathlib import Path
from typing import Any

from pipeline.rig_logs.csv import CsvSource
from pipeline.rig_logs.source import CsvOptions, UnreadableLogError, View, temporary_path


class WorkbookSource(View):
    """A sheet as a table of text in a temporary file, which lasts as long as this exists."""

    def __init__(self, path: Path, options: CsvOptions, *_: object) -> None:
        import python_calamine

        try:
            with path.open("rb") as file:  # by its content, whatever its name ends in
                book = python_calamine.CalamineWorkbook.from_filelike(file)
            visible = [each.name for each in book.sheets_metadata if f"{each.visible}".endswith(".Visible")]
            sheets = [book.get_sheet_by_name(name) for name in visible or book.sheet_names]
            sheet = max(sheets, key=lambda each: each.total_height)
            rows = sheet.to_python(skip_empty_area=False)
        except (python_calamine.CalamineError, ValueError, OSError) as error:
            raise UnreadableLogError(f"the workbook cannot be opened: {error}") from error
        written, mark = temporary_path(self), options.decimal or "."
        with written.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows([_text(cell, mark) for cell in row] for row in rows)
        super().__init__(CsvSource(written, replace(options, encoding="utf-8", delimiter=",", decimal=mark)))
        self.format = "workbook"
        if len(book.sheet_names) > 1:
            which = f"{len(book.sheet_names)} sheets; of those that are visible the one of the most rows is read"
            self.notes.insert(0, f"{which}, {sheet.name!r}")


def _text(cell: Any, mark: str) -> str:
    """A cell as CSV has it: numbers with all digits and this decimal mark, times by ISO 8601, durations in s."""
    if isinstance(cell, float | timedelta):
        return repr(cell if isinstance(cell, float) else cell.total_seconds()).replace(".", mark)
    if isinstance(cell, datetime):
        return cell.isoformat(sep=" ")
    return cell.isoformat() if isinstance(cell, time) else f"{cell}"


open_log = WorkbookSource
