"""Parquet tables with a unit and a meaning for every column."""

import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from ..errors import CorruptArtifactError, memory_failure
from ..system.plain_files import open_plain
from .arrow_columns import from_numpy, to_numpy
from .atomic import atomic_path, reading
from .columns import SCHEMA_VERSION, Dtype
from .hashing import ColumnDigest, digests_hash
from .schemas import Schema
from .trees import LARGEST_RATIO, SMALL_FILE

Table = dict[str, np.ndarray[Any, Any]]

_ARROW: dict[Dtype, Any] = {
    "float64": pa.float64(),
    "int32": pa.int32(),
    "int64": pa.int64(),
    "string": pa.string(),
    "bool": pa.bool_(),
}
_ROW_GROUP = 1 << 20
_WIDEST = 8


def write_pieces(
    target: Path,
    schema: Schema,
    pieces: Iterable[Mapping[str, Any]],
    *,
    within: Path | None = None,
) -> str:
    """Write a table that comes in pieces, one row group at a time, and return its content hash.

    Neither file nor hash depends on the pieces' sizes.

    Parameters
    ----------
    target : Path
        Path of the file.
    schema : Schema
        Resolved for the device; decides order, types and metadata.
    pieces : iterable of mapping of str to array-like
        Consecutive rows of all columns; of text and nullable columns lists with None for null.
    within : Path, optional
        As for `atomic_path`.
    """
    fields = [
        pa.field(column.key, _ARROW[column.dtype], metadata={"unit": column.unit, "meaning": column.help})
        for column in schema.columns
    ]
    columns = pa.schema(fields, metadata={"debist.schema": f"{schema.kind}/{SCHEMA_VERSION}"})
    digests = {column.key: ColumnDigest() for column in schema.columns}
    with (
        atomic_path(target, within=within) as temporary,
        pq.ParquetWriter(
            temporary, columns, compression="zstd", use_dictionary=False, write_page_checksum=True
        ) as writer,
    ):
        for table in _row_groups(columns, pieces):
            writer.write_table(table, row_group_size=_ROW_GROUP)
            for name, digest in digests.items():
                digest.update(to_numpy(table[name]))
        if not digests[schema.columns[0].key].length:
            writer.write_table(_table(columns, {column.key: [] for column in schema.columns}))
    return digests_hash(
        (c.key, c.dtype, c.unit, (digests[c.key].length,), digests[c.key].hexdigest()) for c in schema.columns
    )


def _table(columns: Any, piece: Mapping[str, Any]) -> Any:
    return pa.Table.from_arrays([from_numpy(piece[field.name], field.type) for field in columns], schema=columns)


def _row_groups(columns: Any, pieces: Iterable[Mapping[str, Any]]) -> Iterator[Any]:
    """The pieces as tables of exactly one row group each, but the last."""
    waiting: list[Any] = []
    held = 0
    for piece in pieces:
        waiting.append(_table(columns, piece))
        held += len(waiting[-1])
        while held >= _ROW_GROUP:
            whole = pa.concat_tables(waiting)
            yield whole.slice(0, _ROW_GROUP)
            waiting, held = [whole.slice(_ROW_GROUP)], held - _ROW_GROUP
    if held:
        yield pa.concat_tables(waiting)


def read_table(path: Path) -> Table:
    """Read a table, every page checked.

    Raises
    ------
    InputError
        The system does not let it.
    CorruptArtifactError
        The file is damaged or no Parquet file.
    """
    with reading(path):
        content = read_buffer(path)
    return parse_table(content, path)


def read_buffer(path: Path) -> Any:
    """The bytes of a regular file in memory of Arrow's own; OSError where the system does not let it.

    Arrow's threads must hold nothing of Python's: one that lets go of it while the interpreter is taken down aborts
    the process. And Arrow's own files say of what failed that it failed, and not why.
    """
    with open_plain(path) as stream:
        size = os.fstat(stream.fileno()).st_size
        content = pa.allocate_buffer(size)
        view = memoryview(content).cast("B")
        filled = 0
        while filled < size and (count := stream.readinto(view[filled:])):
            filled += count
    return content.slice(0, filled)


def parse_table(content: Any, path: Path) -> Table:
    """The table in a buffer that was read from `path`.

    Raises
    ------
    CorruptArtifactError
        It is damaged or no Parquet file.
    """
    try:
        # pq.read_table would load pyarrow.dataset and with it pandas: half a second.
        with pq.ParquetFile(pa.BufferReader(content), page_checksum_verification=True) as file:
            _check_size(file.metadata, len(content))
            table = file.read()
        return {name: to_numpy(table[name]) for name in table.column_names}
    except (OSError, pa.ArrowException, ValueError) as error:
        if memory_failure(error):
            raise
        reason = str(error).splitlines()[0]
        raise CorruptArtifactError(f"{path}: damaged ({reason}); `debist run` sets it aside and rebuilds it") from error


def _check_size(metadata: Any, size: int) -> None:
    """Raise a ValueError if a file of `size` bytes declares more than it can hold.

    Rows of nulls take next to no bytes, nor do rows that all name one text of a dictionary.
    """
    declared = metadata.num_rows * metadata.num_columns * _WIDEST
    for i, j in np.ndindex(metadata.num_row_groups, metadata.num_columns):
        column = metadata.row_group(i).column(j)
        repeated = column.has_dictionary_page and "BYTE_ARRAY" in column.physical_type
        declared += column.total_uncompressed_size * (column.num_values if repeated else 1)
    if declared > max(SMALL_FILE, LARGEST_RATIO * size):
        raise ValueError(f"declares {declared / 1e6:.3g} MB in a file of {size / 1e6:.3g} MB")
