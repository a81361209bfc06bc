"""CSV logs: Arrow's reader under the dialect that was found or configured."""

import codecs
import io
import mmap
import re
import tempfile
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.csv_dialect import (
    CLOCK,
    MISSING,
    SAMPLE_BYTES,
    STAMP,
    find_dialect,
    is_whole,
    last_rows,
    mark_is_open,
    no_number,
    split_row,
)
from pipeline.rig_logs.source import (
    PART,
    CsvOptions,
    Entry,
    Limits,
    Source,
    UnreadableLogError,
    read_start,
    unique_names,
)

_BLOCK_BYTES = 1 << 20
_DAY, _ANY_DAY = 86_400.0, "1970-01-01T"
_CONVERSION = re.compile(
    r"In CSV column #(?P<column>\d+): (?:Row #(?P<row>\d+): )?CSV conversion error.*invalid value '(?P<cell>.*)'"
)


class CsvSource:
    """A CSV log, parsed in blocks of rows, all wanted columns in one pass."""

    format = "CSV"

    def __init__(self, path: Path, options: CsvOptions) -> None:
        self._path = path
        start = read_start(path, SAMPLE_BYTES)
        self._dialect = dialect = find_dialect(start, whole=len(start) < SAMPLE_BYTES, options=options)
        self._columns = unique_names(list(dialect.header))
        self._origins: dict[str, int] = {}
        self.notes = [dialect.describe()]
        shown = {name: text for name, text in zip(self._columns, dialect.texts, strict=True) if text is not None}
        self.texts = {name: f"{text.shown}; {text.way_out or 'export it as numbers'}" for name, text in shown.items()}
        first = dict(zip(self._columns, dialect.first_row, strict=False))
        self._clocks = {name for name, cell in first.items() if CLOCK.fullmatch(cell)}
        self._stamped = {name for name, cell in first.items() if STAMP.match(cell)} | self._clocks
        self._last: dict[str, float] = {}
        self._open = {name for name, is_open in zip(self._columns, dialect.open_marks, strict=True) if is_open}
        left_out = [
            f"{name!r} ({'; '.join(filter(None, [text.shown, text.way_out]))})"
            for name, text in shown.items()
            if text.cell
        ]
        if left_out:
            self.notes.append(f"no numbers, and left out: {', '.join(left_out)}")
        # The number of rows is not declared anywhere.
        self._count = path.stat().st_size * max(1, start.count(b"\n")) // len(start)

    def entries(self) -> list[Entry]:
        """The columns whose first rows are numbers; `count` is an estimate from the first rows."""
        headings = self._dialect.headings or self._dialect.header
        return [
            Entry(
                name,
                "s" if name in self._stamped else unit,
                "text",
                self._count,
                aliases=(heading,) if heading != name else (),
            )
            for name, unit, heading, numeric in zip(
                self._columns, self._dialect.units, headings, self._dialect.numeric, strict=True
            )
            if numeric
        ]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Several columns, block of rows by block of rows."""
        found = False
        try:
            for name, samples in (
                self._blanks(names) if self._dialect.delimiter == " " else self._delimited(list(names))
            ):
                found = found or samples.size > 0
                if name in self._open and np.any(np.trunc(samples[finite := np.isfinite(samples)]) != samples[finite]):
                    self._settle(name)
                yield name, samples
        except (ValueError, UnicodeDecodeError) as error:  # pyarrow's ArrowInvalid is a ValueError
            raise UnreadableLogError(f"a row does not fit the table: {self._told(str(error))}") from error
        if not found:
            raise UnreadableLogError("truncated: it holds no complete row of numbers")

    def _told(self, error: str) -> str:
        """An error of Arrow in our words."""
        match = _CONVERSION.search(error)
        if match is None:
            return f"{error.removeprefix('CSV parse error: ').replace(_ANY_DAY, '').strip()}; repair or delete that row"
        cell = no_number(match["cell"], self._columns[int(match["column"])], self._dialect.decimal)
        return f"row {match['row']}: {cell}" if match["row"] else cell

    def _settle(self, name: str) -> None:
        """Look at every cell of a column in which the first marks stand after the rows that were seen at first.

        Raises
        ------
        UnreadableLogError
            They stand between thousands, most likely.
        """
        self._open.remove(name)
        column, delimiter = self._columns.index(name), self._dialect.delimiter
        with self._path.open(encoding=self._dialect.encoding, newline=None) as lines:
            rows = (split_row(line, delimiter) for line in islice(lines, self._dialect.first_data_row, None))
            mark_is_open((row[column] for row in rows if len(row) > column), self._dialect.decimal)

    def _delimited(self, names: list[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        import pyarrow as pa
        from pyarrow import csv

        from pipeline.arrow_columns import doubles

        reader = csv.open_csv(
            self._utf8(self._complete_rows()),
            read_options=csv.ReadOptions(
                use_threads=False,
                block_size=_BLOCK_BYTES,
                skip_rows=self._dialect.first_data_row,
                column_names=self._columns,
            ),
            parse_options=csv.ParseOptions(delimiter=self._dialect.delimiter),
            convert_options=csv.ConvertOptions(
                column_types={name: self._kind(name) for name in names},
                include_columns=names,
                decimal_point=self._dialect.decimal,
                null_values=_NULLS,
                strings_can_be_null=True,
            ),
        )
        for batch in reader:
            for name, column in zip(names, batch.columns, strict=True):
                samples = pa.chunked_array([column])
                yield name, self._seconds(name, samples) if name in self._stamped else doubles(samples)

    def _kind(self, name: str) -> Any:
        """Arrow's type of a column: numbers, or time stamps, with a zone where they state one."""
        import pyarrow as pa

        if name not in self._stamped:
            return pa.float64()
        if name in self._clocks:
            return pa.string()
        match = STAMP.match(self._dialect.first_row[self._columns.index(name)])
        return pa.timestamp("ns", "UTC" if match and match["zone"] else None)

    def _seconds(self, name: str, stamps: Any) -> NDArray[Any]:
        """Time stamps since the first one of the column."""
        import pyarrow as pa
        import pyarrow.compute as pc

        from pipeline.arrow_columns import doubles

        if name in self._clocks:
            dated = pc.binary_join_element_wise(_ANY_DAY, pc.replace_substring(stamps, ",", "."), "")
            stamps = dated.cast(pa.timestamp("ns"))
        ticks = stamps.cast(pa.int64())
        if name not in self._origins and len(ticks):
            self._origins[name] = ticks[0].as_py() or 0
            self.notes.append(f"time of {name!r} counts from {self._dialect.first_row[self._columns.index(name)]}")
        seconds = doubles(pc.subtract(ticks, self._origins.get(name, 0)).cast(pa.float64())) / 1e9
        return self._past_midnight(name, seconds) if name in self._clocks else seconds

    def _past_midnight(self, name: str, seconds: NDArray[Any]) -> NDArray[Any]:
        """Times of day, on the day of the first one: back by more than half a day is the next day."""
        known = np.flatnonzero(np.isfinite(seconds))
        if not known.size:
            return seconds
        steps = np.diff(seconds[known], prepend=self._last.get(name, 0.0) % _DAY)
        days = np.floor(self._last.get(name, 0.0) / _DAY) + np.cumsum(steps < -_DAY / 2.0)
        seconds = seconds.copy()
        seconds[known] += _DAY * days
        self._last[name] = float(seconds[known[-1]])
        return seconds

    def _utf8(self, length: int) -> Any:
        """The first `length` bytes as UTF-8 in a file of Arrow's own; where that is less than all, in a mapped buffer.

        Arrow's threads read ahead. Were they to hold memory of Python's, as they would of a Python file or of a codec,
        one of them could abort the interpreter while it is taken down. A file is read block by block, whereas pages of
        a mapped one stay in memory.
        """
        import pyarrow as pa

        if _is_ascii_and_more(self._dialect.encoding):  # what is beyond ASCII stands in no number
            if length == self._path.stat().st_size:
                return pa.OSFile(str(self._path))
            with pa.memory_map(str(self._path)) as mapped:
                return pa.BufferReader(mapped.read_buffer(length))
        head = io.TextIOWrapper(io.BufferedReader(_Head(self._path, length)), self._dialect.encoding, newline="")
        with head, tempfile.NamedTemporaryFile(prefix="debist-") as recoded:
            while text := head.read(PART):
                recoded.write(text.encode())
            recoded.flush()
            return pa.OSFile(recoded.name)

    def _complete_rows(self) -> int:
        """Bytes of the file without a last row that has no line end, unless that is seen to be whole.

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
            return len(whole)
        *before, last = [split_row(row, self._dialect.delimiter) for row in rows]
        if len(last) != len(self._columns):
            raise UnreadableLogError(
                f"truncated: it ends within a row ({len(last)} of {len(self._columns)} cells); "
                "delete that row if the log shall be used up to there"
            )
        if is_whole(last[-1], [row[-1] for row in before if len(row) == len(last)]):
            self.notes.append("the last row has no line end; it is kept, its last number has as many digits as others")
            return len(whole)
        self.notes.append("the last row has no line end and may be cut off within a number: left out")
        return len(whole) - length

    def _blanks(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Columns separated by runs of blanks, which Arrow does not know."""
        indices = [self._columns.index(name) for name in names]
        lines = islice(
            io.TextIOWrapper(
                io.BufferedReader(_Head(self._path, self._complete_rows())), encoding=self._dialect.encoding
            ),
            self._dialect.first_data_row,
            None,
        )
        while some := list(islice(lines, PART)):
            if any(map(str.strip, some)):
                table = np.loadtxt(some, usecols=indices, ndmin=2, comments=None)
                yield from ((name, table[:, j]) for j, name in enumerate(names))


class _Head(io.RawIOBase):
    """The first bytes of a file, to be read in order."""

    def __init__(self, path: Path, size: int) -> None:
        self._file = path.open("rb")
        self._left = size

    def readable(self) -> bool:
        """It is."""
        return True

    def readinto(self, buffer: Any, /) -> int:
        """Read what fits."""
        count = self._file.readinto(memoryview(buffer)[: self._left])
        self._left -= count
        return count

    def close(self) -> None:
        """Close the file."""
        self._file.close()
        super().close()


def _is_ascii_and_more(encoding: str) -> bool:
    """Whether every ASCII character is its own single byte, which means nothing else anywhere."""
    name = codecs.lookup(encoding).name
    if name in ("utf-8", "utf-8-sig", "ascii"):
        return True
    every = bytes(range(256))
    decoded = every.decode(encoding, "replace")
    return len(decoded) == len(every) and decoded[:128].encode() == every[:128]


def _spellings(text: str) -> set[str]:
    """The ways in which a missing value is written; infinities are numbers, not missing ones."""
    return set() if "inf" in text else {text, text.upper(), text.capitalize(), {"nan": "NaN"}.get(text, text)}


_NULLS = sorted({form for text in MISSING for form in _spellings(text)})


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    return CsvSource(path, csv)
