"""Parquet logs through pyarrow, row group by row group; units from the fields' metadata."""

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from pipeline.arrow_columns import doubles
from pipeline.rig_logs.source import Entry, UnreadableLogError


class ParquetSource:
    """A Parquet table; it declares no time base, the settings name the time column."""

    format = "Parquet"

    def __init__(self, path: Path) -> None:
        try:
            self._file = pq.ParquetFile(path, page_checksum_verification=True, memory_map=True)
        except (pa.ArrowInvalid, OSError) as error:
            raise UnreadableLogError(f"Parquet cannot open it: {error}") from error
        self.notes: list[str] = []

    def entries(self) -> list[Entry]:
        """Every column of numbers or of time stamps."""
        rows = self._file.metadata.num_rows
        return [
            Entry(field.name, _unit(field), str(field.type), rows)
            for field in self._file.schema_arrow
            if _is_number(field.type) or pa.types.is_timestamp(field.type)
        ]

    def load(self, name: str) -> NDArray[Any]:
        """One column as numbers, NaN where it is null; time stamps as seconds since the first one."""
        try:
            parts = [
                self._file.read_row_group(i, columns=[name], use_threads=False).column(name)
                for i in range(self._file.num_row_groups)
            ]
        except (pa.ArrowInvalid, OSError) as error:
            raise UnreadableLogError(f"column {name!r}: {error}") from error
        kind = self._file.schema_arrow.field(name).type
        if pa.types.is_timestamp(kind):
            return self._seconds(name, parts, kind.unit)
        arrays = [doubles(part.cast(pa.float64())) for part in parts]
        return np.concatenate(arrays) if arrays else np.empty(0)

    def _seconds(self, name: str, parts: list[Any], unit: str) -> NDArray[Any]:
        """Time stamps since the first one; as differences, since a float64 resolves an epoch to 0.2 µs only."""
        stamps = [part for part in parts if len(part)]
        if not stamps:
            return np.empty(0)
        origin = stamps[0][0].value
        if origin is None:
            raise UnreadableLogError(f"column {name!r}: the first time stamp is missing")
        self.notes.append(f"time of {name!r} counts from {stamps[0][0]}")
        scale = {"s": 1.0, "ms": 1e3, "us": 1e6, "ns": 1e9}[unit]
        ticks = [pc.subtract(part.cast(pa.int64()), origin).cast(pa.float64()) for part in stamps]
        return np.concatenate([doubles(part) for part in ticks]) / scale


def _is_number(kind: Any) -> bool:
    return bool(pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_decimal(kind))


def _unit(field: Any) -> str:
    if pa.types.is_timestamp(field.type):
        return "s"
    metadata = field.metadata or {}
    for key in (b"unit", b"units", b"Unit"):
        if key in metadata:
            return str(metadata[key].decode("utf-8", "replace"))
    return ""
