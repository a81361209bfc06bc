"""Arrow columns from and to NumPy through their buffers.

pyarrow's own `to_numpy` and `array` import pandas to ask whether it is there, which costs every command 0.3 s.
"""

from typing import Any

import numpy as np
import pyarrow as pa

from ..numerics.arrays import FloatArray

_FIXED: dict[Any, Any] = {pa.float64(): np.dtype("<f8"), pa.int64(): np.dtype("<i8"), pa.int32(): np.dtype("<i4")}


def doubles(column: Any) -> FloatArray:
    """A chunked column of type float64, NaN where it is null, shape (N,).

    Raises
    ------
    TypeError
        The column is of another type.
    """
    if column.type != pa.float64():
        raise TypeError(f"a column of {column.type}, not float64")
    return to_numpy(column)


def to_numpy(column: Any) -> np.ndarray[Any, Any]:
    """A chunked column as an array, shape (N,): numbers in their type, anything else as objects with None for null.

    Nulls of a float64 column become NaN.
    """
    dtype = _FIXED.get(column.type)
    if dtype is None or (column.null_count and dtype.kind != "f"):
        objects = np.empty(len(column), dtype=object)
        objects[:] = column.to_pylist()
        return objects
    parts = [_chunk(chunk, dtype) for chunk in column.chunks if len(chunk)]
    return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0, dtype), *parts])


def _chunk(chunk: Any, dtype: Any) -> np.ndarray[Any, Any]:
    bits, values = chunk.buffers()
    part = slice(chunk.offset, chunk.offset + len(chunk))
    samples = np.frombuffer(values, dtype=dtype)[part]
    if chunk.null_count == 0:
        return samples
    valid = np.unpackbits(np.frombuffer(bits, dtype=np.uint8), bitorder="little")[part]
    return np.where(valid == 1, samples, np.nan)


def from_numpy(values: Any, kind: Any) -> Any:
    """An Arrow array of type `kind` that shares the memory of `values`; lists may hold None for null."""
    if isinstance(values, np.ndarray) and kind in _FIXED:
        samples = np.ascontiguousarray(values, dtype=_FIXED[kind])
        return pa.Array.from_buffers(kind, len(samples), [None, pa.py_buffer(samples)])
    entries = list(values)
    present = np.array([entry is not None for entry in entries], dtype=bool)
    buffers = [None if present.all() else pa.py_buffer(np.packbits(present, bitorder="little"))]
    if kind in _FIXED:
        buffers += [pa.py_buffer(np.array([0 if entry is None else entry for entry in entries], dtype=_FIXED[kind]))]
    elif kind == pa.bool_():
        buffers += [
            pa.py_buffer(np.packbits(np.array([bool(entry) for entry in entries], dtype=bool), bitorder="little"))
        ]
    elif kind == pa.string():
        texts = [b"" if entry is None else str(entry).encode() for entry in entries]
        offsets = np.cumsum([0, *map(len, texts)], dtype="<i4")
        buffers += [pa.py_buffer(offsets), pa.py_buffer(b"".join(texts))]
    else:
        raise TypeError(f"no column of type {kind} is made here")
    return pa.Array.from_buffers(kind, len(entries), buffers)
