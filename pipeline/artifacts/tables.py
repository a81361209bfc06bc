"""Parquet tables with a unit and a meaning for every column."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.artifacts.atomic import atomic_path
from pipeline.artifacts.hashing import table_hash
from pipeline.artifacts.schemas import SCHEMA_VERSION, Schema
from pipeline.errors import CorruptArtifactError

Table = dict[str, np.ndarray[Any, Any]]

_ROW_GROUP = 1 << 20


def write_table(target: Path, schema: Schema, columns: Mapping[str, Any], note: Mapping[str, str] | None = None) -> str:
    """Write a table and return its content hash.

    Parameters
    ----------
    target : Path
        Where the file goes.
    schema : Schema
        Resolved for the device; decides order, types and metadata.
    columns : mapping of str to array-like, each of length N
        For text and nullable columns, lists with None for null.
    note : mapping of str to str, optional
        Further metadata of the file.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    from pipeline.arrow_columns import from_numpy, to_numpy

    kinds = {
        "float64": pa.float64(),
        "int32": pa.int32(),
        "int64": pa.int64(),
        "string": pa.string(),
        "bool": pa.bool_(),
    }
    fields, arrays = [], []
    for column in schema.columns:
        fields.append(
            pa.field(column.name, kinds[column.dtype], metadata={"unit": column.unit, "meaning": column.meaning})
        )
        arrays.append(from_numpy(columns[column.name], kinds[column.dtype]))
    metadata = {"debist.schema": f"{schema.kind}/{SCHEMA_VERSION}", **(note or {})}
    table = pa.Table.from_arrays(arrays, schema=pa.schema(fields, metadata=metadata))
    with atomic_path(target) as temporary:
        pq.write_table(
            table,
            temporary,
            compression="zstd",
            use_dictionary=False,
            write_page_checksum=True,
            row_group_size=_ROW_GROUP,
        )
    return content_hash(schema, {name: to_numpy(table[name]) for name in table.column_names})


def read_table(path: Path, columns: list[str] | None = None) -> Table:
    """Read a table, every page checked.

    Raises
    ------
    CorruptArtifactError
        The file is damaged or no Parquet file.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    from pipeline.arrow_columns import to_numpy

    try:
        # pq.read_table would load pyarrow.dataset and with it pandas: half a second.
        with pq.ParquetFile(path, page_checksum_verification=True) as file:
            table = file.read(columns=columns)
        return {name: to_numpy(table[name]) for name in table.column_names}
    except (OSError, pa.ArrowException) as error:
        reason = str(error).splitlines()[0]
        raise CorruptArtifactError(f"{path}: damaged ({reason}); `debist run` sets it aside and rebuilds it") from error


def content_hash(schema: Schema, columns: Mapping[str, np.ndarray[Any, Any]]) -> str:
    """Logical hash of a table's columns."""
    return table_hash((c.name, c.dtype, c.unit, columns[c.name]) for c in schema.columns)
