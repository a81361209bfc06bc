"""CSV logs: Arrow's reader under the dialect that was found or configured."""

import io
import mmap
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.csv_dialect import MISSING, SAMPLE_BYTES, find_dialect, split_row
from pipeline.rig_logs.csv_end import is_whole, last_rows
from pipeline.rig_logs.source import CsvOptions, Entry, UnreadableLogError, read_start, unique_names

_BLOCK_BYTES = 1 << 22


class CsvSource:
    """A CSV log; columns are parsed on the first request, all wanted ones in one pass."""

    format = "CSV"

    def __init__(self, path: Path, options: CsvOptions) -> None:
        self._path = path
        start = read_start(path, SAMPLE_BYTES)
        self._dialect = dialect = find_dialect(start, whole=len(start) < SAMPLE_BYTES, options=options)
        self._columns = unique_names(list(dialect.header))
        self.notes = [dialect.describe()]
        # The number of rows is not declared anywhere; one byte a cell and one a delimiter is the least.
        self._count = path.stat().st_size // (2 * len(self._columns))

    def entries(self) -> list[Entry]:
        """The columns whose first rows are numbers; `count` is the most that the file's size allows."""
        headings = self._dialect.headings or self._dialect.header
        return [
            Entry(name, unit, "text", self._count, aliases=(heading,) if heading != name else ())
            for name, unit, heading, numeric in zip(
                self._columns, self._dialect.units, headings, self._dialect.numeric, strict=True
            )
            if numeric
        ]

    def load(self, name: str) -> NDArray[Any]:
        """One column."""
        return self.load_all([name])[name]

    def load_all(self, names: list[str]) -> dict[str, NDArray[Any]]:
        """Several columns in one pass, memory bounded by the columns themselves."""
        if self._dialect.delimiter == " ":
            return self._load_blanks(names)
        import pyarrow as pa
        from pyarrow import csv

        from pipeline.arrow_columns import doubles

        try:
            table = csv.read_csv(
                pa.BufferReader(pa.py_buffer(self._complete_rows())),
                read_options=csv.ReadOptions(
                    use_threads=False,
                    block_size=_BLOCK_BYTES,
                    skip_rows=self._dialect.first_data_row,
                    column_names=self._columns,
                    encoding=self._dialect.encoding,
                ),
                parse_options=csv.ParseOptions(delimiter=self._dialect.delimiter),
                convert_options=csv.ConvertOptions(
                    column_types={name: pa.float64() for name in names},
                    include_columns=names,
                    decimal_point=self._dialect.decimal,
                    null_values=_NULLS,
                    strings_can_be_null=True,
                ),
            )
        except (pa.ArrowInvalid, UnicodeDecodeError) as error:
            raise UnreadableLogError(f"a row does not fit the table: {error}") from error
        return {name: doubles(table.column(name)) for name in names}

    def _complete_rows(self) -> memoryview:
        """The mapped file, without a last row that has no line end unless it is seen to be whole.

        Raises
        ------
        UnreadableLogError
            That row lacks cells, or a character is cut in two: the file is truncated.
        """
        with self._path.open("rb") as file:
            whole = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        try:
            rows, length = last_rows(whole, self._dialect.encoding)
        except UnicodeDecodeError as error:
            raise UnreadableLogError(f"truncated within a character: {error.reason}") from None
        if not length:
            return memoryview(whole)
        *before, last = [split_row(row, self._dialect.delimiter) for row in rows]
        if len(last) != len(self._columns):
            raise UnreadableLogError(
                f"truncated: it ends within a row ({len(last)} of {len(self._columns)} cells); "
                "delete that row if the log shall be used up to there"
            )
        if is_whole(last[-1], [row[-1] for row in before if len(row) == len(last)]):
            self.notes.append("the last row has no line end; it is kept, its last number has as many digits as others")
            return memoryview(whole)
        self.notes.append("the last row has no line end and may be cut off within a number: left out")
        return memoryview(whole)[: len(whole) - length]

    def _load_blanks(self, names: list[str]) -> dict[str, NDArray[Any]]:
        """Columns separated by runs of blanks, which Arrow does not know."""
        indices = [self._columns.index(name) for name in names]
        try:
            file = io.TextIOWrapper(io.BytesIO(self._complete_rows()), encoding=self._dialect.encoding)
            table = np.loadtxt(file, skiprows=self._dialect.first_data_row, usecols=indices, ndmin=2, comments=None)
        except (ValueError, UnicodeDecodeError) as error:
            raise UnreadableLogError(f"a row does not fit the table: {error}") from error
        return {name: table[:, j] for j, name in enumerate(names)}


def _spellings(text: str) -> set[str]:
    """The ways in which a missing value is written; infinities are numbers, not missing ones."""
    return set() if "inf" in text else {text, text.upper(), text.capitalize(), {"nan": "NaN"}.get(text, text)}


_NULLS = sorted({form for text in MISSING for form in _spellings(text)})
