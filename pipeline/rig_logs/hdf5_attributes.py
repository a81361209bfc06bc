"""What the attributes, the type and the filters of an HDF5 dataset say of its numbers, by the conventions of netCDF."""

import math
from collections.abc import Mapping
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from ..units.units import time_unit
from .attributes import plain, unit_among
from .source import UnreadableLogError

PACKING = ("scale_factor", "add_offset", "_Unsigned", "valid_min", "valid_max", "valid_range")
"""Attributes of netCDF by which stored numbers are not the values."""
_MISSING = ("_FillValue", "missing_value")
_FILLED = ("int16", "uint16", "int32", "uint32", "float32", "float64")
"""Types of which netCDF takes the value that stands where nothing was written for none."""
_FILTERS = {
    307: "bzip2",
    32001: "blosc",
    32004: "lz4",
    32008: "bitshuffle",
    32013: "zfp",
    32015: "zstd",
    32026: "blosc2",
}
NUMBERS = "fiubmM"
"""Kinds of types that are read; time stamps and durations as seconds."""
_KINDS = {"c": "complex: save its real part", "O": "text or lists", "S": "text", "U": "text", "V": "no numbers"}


def unit_of(attributes: Mapping[str, Any], column: int, columns: int) -> tuple[str, str]:
    """The unit of a column, and the origin of a time such as ``seconds since 2024-01-31``; "" where there is none."""
    text = unit_among(attributes, column, columns)
    _, since, origin = text.partition(" since ")
    return (time_unit(text), origin) if since and time_unit(text) else (text, "")


def why_unread(dataset: Any) -> str:
    """Why no numbers are read from a dataset; "" where they are."""
    filters = dataset.id.get_create_plist()
    codes = [filters.get_filter(i)[0] for i in range(filters.get_nfilters())]
    if foreign := [code for code in codes if not h5py.h5z.filter_avail(code)]:
        name = _FILTERS.get(foreign[0], "unknown")
        return f"compressed by a filter that is not read here, {name} ({foreign[0]}): write it with gzip or none"
    if dataset.dtype.names or dataset.dtype.kind in NUMBERS:
        return ""
    return _KINDS.get(dataset.dtype.kind, f"{dataset.dtype}")


def missing_values(dataset: Any, *, filled: bool = False) -> NDArray[Any] | None:
    """Numbers that stand for no value in a dataset; None where there are none.

    In a file of netCDF a value that was never written is the fill value of the dataset (`filled`).

    Raises
    ------
    UnreadableLogError
        Its numbers are packed: they would have to be converted.
    """
    if packed := [name for name in PACKING if name in dataset.attrs]:
        stated = ", ".join(f"{name} = {plain(dataset.attrs[name])}" for name in packed)
        raise UnreadableLogError(f"packed ({stated}): save its unpacked values")
    values = [np.ravel(dataset.attrs[name]) for name in _MISSING if name in dataset.attrs]
    if filled and dataset.dtype.name in _FILLED and "_FillValue" not in dataset.attrs:
        values.append(np.ravel(dataset.fillvalue))
    if any(each.dtype.kind not in "iuf" for each in values):
        raise UnreadableLogError("its fill value is no number")
    return np.concatenate(values).astype(dataset.dtype.base) if values else None


def written_chunks(dataset: Any, axis: int) -> NDArray[np.bool_] | None:
    """Which chunks along an axis hold numbers that were written; None where all do, or there are no chunks."""
    if dataset.chunks is None:
        return None
    counts = [-(-size // chunk) for size, chunk in zip(dataset.shape, dataset.chunks, strict=True)]
    if dataset.id.get_num_chunks() == math.prod(counts):
        return None
    written = np.zeros(counts[axis], dtype=np.bool_)

    def mark(chunk: Any) -> None:
        written[chunk.chunk_offset[axis] // dataset.chunks[axis]] = True

    dataset.id.chunk_iter(mark)
    return written


_NO_VARIABLE = b"This is a netCDF dimension but not a netCDF variable"


def scales_of_axis(dataset: Any, axis: int) -> list[str]:
    """Names of the dimension scales of an axis that hold numbers; a bare dimension of netCDF does not."""
    try:
        scales = list(dataset.dims[axis].values())
    except (RuntimeError, ValueError, KeyError, TypeError, OSError):  # references to what is not there
        return []
    named = [
        scale for scale in scales if scale.name and not bytes(scale.attrs.get("NAME", b"")).startswith(_NO_VARIABLE)
    ]
    return [scale.name.lstrip("/") for scale in named]
