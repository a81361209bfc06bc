"""Parquet logs through pyarrow, page by page; units from the fields' metadata."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from pipeline.arrow_columns import doubles
from pipeline.rig_logs.source import PART, CsvOptions, Entry, Limits, Source, UnreadableLogError

_BUFFER = 1 << 20


class ParquetSource:
    """A Parquet table; it declares no time base, the settings name the time column."""

    format = "Parquet"

    def __init__(self, path: Path) -> None:
        try:
            self._file = pq.ParquetFile(
                path, page_checksum_verification=True, memory_map=False, pre_buffer=False, buffer_size=_BUFFER
            )
        except (pa.ArrowInvalid, OSError) as error:
            raise UnreadableLogError(f"Parquet cannot open it: {error}") from error
        left_out = [f"{field.name!r} ({field.type})" for field in self._file.schema_arrow if not _is_read(field.type)]
        self.notes = [f"no numbers, and left out: {', '.join(left_out)}"] if left_out else []
        self.texts: dict[str, str] = {}

    def entries(self) -> list[Entry]:
        """Every column of numbers, of time stamps or of durations."""
        rows = self._file.metadata.num_rows
        return [
            Entry(field.name, _unit(field), str(field.type), rows)
            for field in self._file.schema_arrow
            if _is_read(field.type)
        ]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Columns as numbers, NaN where they are null; time stamps as seconds since the first one."""
        for name in names:
            kind = self._file.schema_arrow.field(name).type
            try:
                if pa.types.is_timestamp(kind):
                    yield from self._seconds(name, kind.unit)
                elif pa.types.is_duration(kind):
                    for column in self._columns(name):
                        yield name, doubles(column.cast(pa.int64()).cast(pa.float64())) / _PER_SECOND[kind.unit]
                else:
                    for column in self._columns(name):
                        yield name, doubles(column.cast(pa.float64()))
            except (pa.ArrowInvalid, OSError) as error:
                raise UnreadableLogError(f"column {name!r}: {error}") from error

    def _columns(self, name: str) -> Iterator[Any]:
        """A column in chunked arrays; a row group may be as large as the log, so it is not read at once."""
        for batch in self._file.iter_batches(PART, columns=[name], use_threads=False):
            yield pa.chunked_array([batch.column(0)])

    def _seconds(self, name: str, unit: str) -> Iterator[tuple[str, NDArray[Any]]]:
        """Time stamps since the first one; as differences, since a float64 resolves an epoch to 0.2 µs only."""
        origin = None
        for stamps in self._columns(name):
            if origin is None and len(stamps):
                origin = stamps[0].value
                if origin is None:
                    raise UnreadableLogError(f"column {name!r}: the first time stamp is missing")
                self.notes.append(f"time of {name!r} counts from {stamps[0]}")
            ticks = pc.subtract(stamps.cast(pa.int64()), origin).cast(pa.float64())
            yield name, doubles(ticks) / _PER_SECOND[unit]


_PER_SECOND = {"s": 1.0, "ms": 1e3, "us": 1e6, "ns": 1e9}


def _is_read(kind: Any) -> bool:
    return _is_number(kind) or bool(pa.types.is_timestamp(kind) or pa.types.is_duration(kind))


def _is_number(kind: Any) -> bool:
    """Whether numbers are read from a column; a switch that is on or off is 1 or 0."""
    kinds = (pa.types.is_integer, pa.types.is_floating, pa.types.is_decimal, pa.types.is_boolean)
    return any(one(kind) for one in kinds)


def _unit(field: Any) -> str:
    if pa.types.is_timestamp(field.type) or pa.types.is_duration(field.type):
        return "s"
    metadata = field.metadata or {}
    for key in (b"unit", b"units", b"Unit"):
        if key in metadata:
            return str(metadata[key].decode("utf-8", "replace"))
    return ""


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.child` opens it."""
    return ParquetSource(path)
