"""CSV logs: Arrow's reader under the dialect that was found or configured."""

import mmap
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import pyarrow as pa
from numpy.typing import NDArray
from pyarrow import csv

from ..store.arrow_columns import doubles, to_numpy
from .attributes import note_on_rate
from .csv_dialect import SAMPLE_BYTES, find_dialect
from .csv_heading import stated_frequencies, stated_rates, stated_scales
from .csv_text import (
    MISSING,
    NUMBER,
    STAMP,
    SWITCH,
    Clock,
    as_utf8,
    bytes_written,
    is_behind,
    is_stamp,
    is_value,
    is_word,
    labview_starts,
    last_rows,
    marks_between_thousands,
    plain_number,
    plain_row,
    split_row,
    text_of,
    unclear_mark,
    written,
)
from .source import (
    MEGABYTE,
    CsvOptions,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    read_start,
    unique_names,
)

_LARGEST_HEAD = 1 << 24
_FEWEST_LINES = 20
_MOST_NAMED = 3
_MARKED = re.compile(r"\d([.,])\d")
_YEARS = ("1678", "2261")
"""First and last year whose times a count of nanoseconds since 1970 holds."""


class CsvSource(Source):
    """A CSV log, parsed in blocks of rows, all wanted columns in one pass."""

    format = "CSV"
    one_pass = True

    def __init__(self, path: Path, options: CsvOptions, *_: object) -> None:
        super().__init__()
        self._path = path
        size = SAMPLE_BYTES
        start = read_start(path, size)
        while len(start) == size < _LARGEST_HEAD and start.count(b"\n") + start.count(b"\r") < _FEWEST_LINES:
            size *= 4
            start = read_start(path, size)
        self._dialect = find_dialect(start, whole=len(start) < size, options=options)
        self._block = max(MEGABYTE, 2 * size)
        self._columns = unique_names(list(self._dialect.header))
        preamble = self._dialect.preamble
        delimiter = self._dialect.delimiter
        rates = stated_rates(preamble, delimiter)
        self.rates = {name: rate for name, _, rate in rates}
        self.frequencies = stated_frequencies(preamble, delimiter)
        self._rewritten = self._dialect.rewritten
        self._words = dict[str, list[int]]()
        self._remarks = list[str]()
        self._firsts = dict(zip(self._columns, self._dialect.firsts, strict=True))
        self._stamped = {name for name, cell in self._firsts.items() if is_stamp(cell)}
        self._clocks = _clocks(
            self._firsts, (name for name in self._stamped if not STAMP.fullmatch(self._firsts[name]))
        )
        texts = self._left_out()
        self.texts = {name: text if ";" in text else f"{text}; export it as numbers" for name, text in texts.items()}
        headed = dict(zip(self._columns, self._dialect.headings, strict=True))
        self.notes += [self._dialect.describe(), *(note_on_rate(*each) for each in rates)]
        self.notes += stated_scales(preamble, delimiter)
        self.notes += left_out({name: text for name, text in texts.items() if self._firsts[name] or headed[name]})
        # The first column is a time, or empty.
        starts = labview_starts([split_row(line, delimiter) for line in preamble], len(self._columns))
        self.starts = dict([*zip(self._columns, starts, strict=False)][1:])
        self.heading = " ".join(" ".join(preamble).split())
        # The number of rows is not declared anywhere.
        self._count = path.stat().st_size * max(1, start.count(b"\n")) // len(start)

    def _left_out(self) -> dict[str, str]:
        """Content of the columns that are no numbers, by name."""
        return {
            name: text
            or (repr(cell[:40]) if cell else "empty cells only in the first rows; no sensor, or another channel?")
            for name, text, cell in zip(self._columns, self._dialect.texts, self._firsts.values(), strict=True)
            if text or not cell or not is_value(cell, self._dialect.decimal)
        }

    def entries(self) -> list[Entry]:
        """The columns whose first rows are numbers; `count` is an estimate from the first rows."""
        return [
            Entry(
                name,
                "s" if name in self._stamped else unit,
                "text",
                self._count,
                aliases=(heading,) if heading not in ("", name) else (),
            )
            for name, unit, heading in zip(self._columns, self._dialect.units, self._dialect.headings, strict=True)
            if name not in self.texts and not (self.starts and name == self._columns[0])  # that of one channel only
        ]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Several columns, block of rows by block of rows."""
        first: dict[float, str] = {}
        for name in filter(self._clocks.__contains__, names):
            clock = self._clocks[name]
            note = f"time of {name!r} {first.setdefault(clock.turn, clock.note)}"
            self.notes += [] if note in self.notes else [note]
        rows = Counter[str]()
        while True:
            rewritten = self._rewritten
            read = Counter[str]()
            try:
                for name, samples in self._delimited(list(names)):
                    new = samples[max(0, rows[name] - read[name]) :]
                    read[name] += samples.size
                    rows[name] += new.size
                    yield name, new
                break
            except ValueError as error:  # as pyarrow's ArrowInvalid is one
                if rewritten:
                    raise UnreadableLogError(
                        f"not encoded as {self._dialect.encoding} throughout; set [ingest.csv] encoding, as cp1252, or "
                        "save it as UTF-8"
                        if isinstance(error, UnicodeDecodeError)
                        else f"a row does not fit the table: {error}; repair or delete it"
                    ) from error
                self._rewritten = True
        if not rows.total():
            raise UnreadableLogError("truncated: it holds no complete row of numbers")
        self._note_what_is_left_out()

    def _note_what_is_left_out(self) -> None:
        """Note words in place of numbers, and lines that are no rows of numbers."""
        words = [f"{what} ({number} times, the first in line {at})" for what, (number, at) in self._words.items()]
        lines = f"{len(self._remarks)} line{'s' * (len(self._remarks) > 1)} left out"
        for places, what in ((words, "words in place of numbers, missing values"), (self._remarks, lines)):
            more = f" and {len(places) - _MOST_NAMED} more" if len(places) > _MOST_NAMED else ""
            if places:
                self.warnings.append(f"{what}: {', '.join(places[:_MOST_NAMED])}{more}")

    def _plain_rows(self, names: Sequence[str]) -> Iterator[str]:
        """The rows of data as Arrow reads them: cells between tabs, numbers with a decimal point, nothing for words.

        Raises
        ------
        UnreadableLogError
            A row that does not fit the table, with its line counted from 1.
        """
        width = len(self._columns)
        wanted = [j for j, name in enumerate(self._columns) if name in names]
        self._words = {}
        self._remarks = []
        dialect = self._dialect
        named = dialect.delimiter != " " and any(len(row) == width + 1 for row in dialect.above)  # a column of comments
        plain = plain_row(dialect.delimiter, width) if dialect.decimal == "." and dialect.has_marks else None
        for number, line in self._lines():
            if plain and plain.fullmatch(line):  # as most lines do, and at a third of the cost
                yield "\t".join(line.replace(dialect.delimiter, " ").split()) + "\n"
                continue
            cells = split_row(line, dialect.delimiter)
            dialect.check_same_segment(cells, number)
            if dialect.is_remark(line, cells):
                self._remarks.append(f"line {number}: {line.strip()[:40]!r}")
                continue
            if len(cells) == width + 1 and (named or is_behind(cells[-1], dialect.decimal)):
                del cells[-1]
            if len(cells) != width:
                raise UnreadableLogError(
                    f"a row does not fit the table: row {number} has {len(cells)} cells, not {width}: repair or delete "
                    "that row"
                )
            if dialect.begins_another(cells):
                raise UnreadableLogError(
                    f"row {number} begins another table, of {', '.join(cells)}: save each table in a file of its own"
                )
            for j in wanted:
                cells[j] = self._plain_cell(cells[j], self._columns[j], number)
            yield "\t".join(cell.replace("\t", " ") for cell in cells) + "\n"

    def _plain_cell(self, cell: str, column: str, line: int) -> str:
        """A cell as Arrow reads it."""
        mark = None if self._dialect.has_marks else _MARKED.search(cell)
        if mark and not is_stamp(cell):
            raise UnreadableLogError(unclear_mark(cell, line, column, mark[1]))
        if NUMBER.match(number := plain_number(cell, self._dialect.decimal)):
            return number
        is_time = is_stamp(cell)
        is_switch = {cell.lower(), self._firsts[column].lower()} <= SWITCH
        if is_time and column in self._stamped and cell[:4].isdecimal() and not _YEARS[0] <= cell[:4] <= _YEARS[1]:
            raise UnreadableLogError(
                f"row {line}: {cell!r} in column {column!r} is the time of a clock that was not set: delete that row"
            )
        if cell.lower() in MISSING or (is_time and column in self._stamped) or is_switch:
            return cell
        if is_time or not is_word(cell):
            what = f"a row does not fit the table: row {line}: {cell!r} in column {column!r}"
            if marks := marks_between_thousands(cell):
                raise UnreadableLogError(f"{what} has {marks}")
            raise UnreadableLogError(
                f"{what} is no number with the decimal mark {self._dialect.decimal!r}: repair or delete that row, or "
                "leave the cell empty for a missing value"
            )
        self._words.setdefault(f"{cell[:20]!r} in {column!r}", [0, line])[0] += 1
        return ""

    def _lines(self) -> Iterator[tuple[int, str]]:
        """The lines of data that are not empty, with their numbers, counted from 1."""
        with text_of(self._path, self._length, self._dialect.encoding) as lines:
            for number, line in enumerate(lines, 1):
                if number > self._dialect.first_data_row and line.strip():
                    yield number, line.rstrip("\n")

    def _delimited(self, names: list[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Several columns by Arrow's reader, of the file itself or of its rows written anew."""
        clocks = _clocks(self._firsts, self._clocks)
        dialect = self._dialect
        plain = self._rewritten
        # Words in the first column show that a row is none of numbers.
        every = names if plain or not dialect.numeric[0] else list(dict.fromkeys([*names, self._columns[0]]))
        batches = csv.open_csv(
            written(self._plain_rows(every), self)
            if plain
            else as_utf8(self._path, self._length, dialect.encoding, self),
            read_options=csv.ReadOptions(
                use_threads=False,
                block_size=self._block,
                skip_rows=0 if plain else dialect.first_data_row,
                column_names=self._columns,
            ),
            parse_options=csv.ParseOptions(
                delimiter="\t" if plain else dialect.delimiter, quote_char=False if plain else '"'
            ),
            convert_options=csv.ConvertOptions(
                column_types={name: self._kind(name) for name in every},
                include_columns=every,
                decimal_point="." if plain else dialect.decimal,
                null_values=_NULLS,
                strings_can_be_null=True,
            ),
        )
        for batch in batches:
            for name, column in zip(names, batch.columns, strict=False):
                samples = pa.chunked_array([column])
                if name in clocks:
                    yield name, clocks[name].seconds(samples)
                elif pa.types.is_timestamp(samples.type):
                    ticks = to_numpy(samples.cast(pa.int64()).fill_null(-(1 << 63)))  # which NumPy takes for no time
                    yield name, self.counted(name, ticks.view("M8[ns]"))
                else:
                    yield name, doubles(samples.cast(pa.float64()))

    def _kind(self, name: str) -> Any:
        """Arrow's type of a column: numbers, switches, or time stamps, with a zone where they state one."""
        cell = self._firsts[name]
        if name in self._clocks:
            return pa.string()
        if name in self._stamped:
            match = STAMP.match(cell)
            return pa.timestamp("ns", "UTC" if match and match["zone"] else None)
        if cell.lower() in SWITCH:
            return pa.bool_()
        return pa.float64() if self._dialect.has_marks or self._rewritten else pa.int64()

    @cached_property
    def _length(self) -> int:
        """Bytes of the file that are whole rows.

        Zeros at its end are left out, and a last row without a line end, which may be cut off within a number.

        Raises
        ------
        UnreadableLogError
            That row lacks cells, or a character is cut in two: the file is truncated.
        """
        with self._path.open("rb") as file:
            content = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        dialect = self._dialect
        size = len(content)
        if not dialect.encoding.startswith("utf-16") and (size := bytes_written(content)) < len(content):
            self.warnings.append(
                f"{len(content) - size} zero bytes at the end are left out; did the recorder lose its power?"
            )
        try:
            rows, length = last_rows(content, size, dialect.encoding)
        except UnicodeDecodeError as error:
            raise UnreadableLogError(f"truncated within a character: {error.reason}") from None
        last = split_row(rows[-1], dialect.delimiter) if length else []
        if not length or dialect.is_remark(rows[-1], last):
            return size
        if len(last) < len(self._columns):
            raise UnreadableLogError(
                f"truncated: it ends within a row ({len(last)} of {len(self._columns)} cells); "
                "delete that row if the log shall be used up to there"
            )
        self.warnings.append("the last row has no line end and may be cut off within a number: left out")
        return size - length


def _clocks(firsts: Mapping[str, str], names: Iterable[str]) -> dict[str, Clock]:
    """The columns of times of day of one log, which count from one origin."""
    origins: dict[float, float] = {}
    return {name: Clock(firsts[name], origins) for name in names}


_NULLS = sorted(
    {"NaN"} | {form for text in MISSING if "inf" not in text for form in (text, text.upper(), text.capitalize())}
)
"""The ways in which a missing value is written; infinities are numbers, not missing ones."""


open_log = CsvSource
