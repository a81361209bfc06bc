"""Parquet logs through pyarrow, page by page; units from the metadata of the fields or of the table."""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from ..store.arrow_columns import doubles
from .attributes import (
    description_among,
    is_unit,
    plain,
    rates_among,
    scales_among,
    texts_among,
    unit_among,
)
from .source import (
    EXACT,
    PART,
    Counted,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    unique_names,
)

_BUFFER = 1 << 20
_MOST_DIGITS = 75  # of decimals whose differences Arrow holds


class ParquetSource(Source):
    """A Parquet table; it declares no time base, the settings name the time column."""

    format = "Parquet"

    def __init__(self, path: Path, *_: object) -> None:
        super().__init__()
        try:
            self._file = pq.ParquetFile(
                path, page_checksum_verification=True, memory_map=False, pre_buffer=False, buffer_size=_BUFFER
            )
        except (pa.ArrowInvalid, OSError) as error:
            raise UnreadableLogError(f"Parquet cannot open it: {error}") from error
        self._columns = dict(zip(unique_names(self._file.schema_arrow.names), self._file.schema_arrow, strict=True))
        leaves = [leaf for name, field in self._columns.items() for leaf in _leaves(name, field, ())]
        unique = unique_names([".".join((name, *path)) for name, path, _ in leaves])
        self._places = {label: (name, path) for label, (name, path, _) in zip(unique, leaves, strict=True)}
        self._fields = {label: field for label, (_, _, field) in zip(unique, leaves, strict=True)}
        self.texts = {
            name: f"{field.type}"
            for name, field in self._fields.items()
            if not (_is_number(field.type) or _is_time(field.type))
        }
        self.notes = left_out(self.texts)
        of_table = _texts(self._file.schema_arrow.metadata)
        of_table |= _mapping(of_table.get("PANDAS_ATTRS"))
        self._units = {k: f"{v}" for key in filter(is_unit, of_table) for k, v in _mapping(of_table[key]).items()}
        for name, field in self._fields.items():
            own = _texts(field.metadata)
            self._units.setdefault(name, unit_among(own))
            self.note_rates(rates_among(own, name))
            self.notes += scales_among(own, name)
            self.descriptions |= {name: text} if (text := description_among(own)) else {}
        self.notes += scales_among(of_table)
        self.heading = texts_among({key: of_table[key] for key in of_table if key not in ("ARROW:schema", "pandas")})
        self.note_rates(rates_among(of_table, ""))

    def entries(self) -> list[Entry]:
        """Every column of numbers, of time stamps or of durations."""
        return [
            Entry(
                name, "s" if _is_time(field.type) else self._units[name], str(field.type), self._file.metadata.num_rows
            )
            for name, field in self._fields.items()
            if name not in self.texts
        ]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """Columns as numbers, NaN where they are null; time stamps as seconds since the first one."""
        for name in names:
            try:
                for column in self._chunks(name):
                    yield name, _numbers(name, column, self.counted)
            except (pa.ArrowInvalid, OSError) as error:
                raise UnreadableLogError(f"column {name!r}: {error}") from error

    def _chunks(self, label: str) -> Iterator[Any]:
        """A column in chunked arrays; a row group may be as large as the log, so it is not read at once."""
        name, path = self._places[label]
        field = self._columns[name]
        equal = [other for other, each in self._columns.items() if each.name == field.name]
        for batch in self._file.iter_batches(PART, columns=[field.name], use_threads=False):
            column = batch.column(equal.index(name))
            for key in path:
                column = pc.struct_field(column, [key])
            yield pa.chunked_array([column])


def _numbers(name: str, column: Any, counted: Counted) -> NDArray[Any]:
    """The samples of a part of a column."""
    kind = column.type
    if pa.types.is_decimal(kind):
        column = _since_first(name, column, counted)
    if not _is_time(kind) and not pa.types.is_integer(kind):
        return doubles(column.cast(pa.float64()))
    if pa.types.is_time(kind):
        ticks = pa.int32() if pa.types.is_time32(kind) else pa.int64()
        column = column.cast(ticks).cast(pa.int64()).cast(pa.duration(kind.unit))
    samples = np.full(len(column), np.nan)
    samples[column.is_valid().to_numpy()] = counted(name, column.drop_null().to_numpy())
    return samples


def _since_first(name: str, column: Any, counted: Counted) -> Any:
    """Decimals from the first one on where that is too large to be held exactly."""
    first = next((value.as_py() for value in column if value.is_valid), None)
    if first is not None:
        counted.origin(name, first if abs(first).scaleb(column.type.scale) > EXACT else 0)
    if not (origin := counted.get(name, 0)):
        return column
    wide = column.cast(pa.decimal256(_MOST_DIGITS, column.type.scale))
    return pc.subtract(wide, pa.scalar(origin, wide.type))


def _leaves(name: str, field: Any, path: tuple[str, ...]) -> Iterator[tuple[str, tuple[str, ...], Any]]:
    """The columns below a field: itself, or those of a struct, each with its path, unless two have one name."""
    kind = field.type
    names = [kind.field(i).name for i in range(kind.num_fields)] if pa.types.is_struct(kind) else []
    if not names or len(set(names)) < len(names):
        yield name, path, field
        return
    for i, key in enumerate(names):
        yield from _leaves(name, kind.field(i), (*path, key))


def _is_time(kind: Any) -> bool:
    """True if a column holds time stamps, durations, or times of day, which are read in s."""
    return any(holds(kind) for holds in (pa.types.is_timestamp, pa.types.is_duration, pa.types.is_time))


def _is_number(kind: Any) -> bool:
    """True if numbers are read from a column; a switch that is on or off is 1 or 0."""
    return any(
        holds(kind) for holds in (pa.types.is_integer, pa.types.is_floating, pa.types.is_decimal, pa.types.is_boolean)
    )


def _mapping(value: Any) -> dict[str, Any]:
    """A mapping that is written as JSON; empty for anything else."""
    try:
        read = json.loads(value) if isinstance(value, str) else value
    except (ValueError, RecursionError):
        return {}
    return read if isinstance(read, dict) else {}


def _texts(metadata: Mapping[bytes, bytes] | None) -> dict[str, Any]:
    return {key.decode("utf-8", "replace"): f"{plain(value)}" for key, value in (metadata or {}).items()}


open_log = ParquetSource
