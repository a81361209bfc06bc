"""Arrow columns as NumPy arrays without `to_numpy`, which imports pandas (0.3 s) to ask whether it is there."""

from typing import Any

import numpy as np
import pyarrow as pa

from pipeline.numerics.arrays import FloatArray


def doubles(column: Any) -> FloatArray:
    """A chunked column of type float64, NaN where it is null, shape (N,)."""
    parts = [_doubles(chunk) for chunk in column.chunks]
    return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])


def _doubles(chunk: Any) -> FloatArray:
    if chunk.type != pa.float64():
        raise TypeError(f"a column of {chunk.type}, not float64")
    bits, values = chunk.buffers()
    part = slice(chunk.offset, chunk.offset + len(chunk))
    samples = np.frombuffer(values, dtype=np.float64)[part] if len(chunk) else np.empty(0)
    if chunk.null_count == 0:
        return samples
    valid = np.unpackbits(np.frombuffer(bits, dtype=np.uint8), bitorder="little")[part]
    return np.where(valid == 1, samples, np.nan)
