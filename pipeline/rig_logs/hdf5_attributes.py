"""What the attributes, the type and the filters of an HDF5 dataset say of its numbers, by the conventions of netCDF."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from ..units.units import time_unit
from .attributes import plain, unit_among
from .source import UnreadableLogError

PACKING = ("scale_factor", "add_offset", "_FillValue", "missing_value", "valid_min", "valid_max", "valid_range")
_MOST_NUMBERS = {"valid_range": 2, "valid_min": 1, "valid_max": 1}
_KIND_BY_UNSIGNED = {"true": "u", "1": "u", "false": "i"}
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


@dataclass(frozen=True)
class Packing:
    """How stored numbers become values: ``factor * number + offset``, NaN for those that are missing or not valid.

    Attributes
    ----------
    factor, offset : float
        By `scale_factor` and `add_offset`.
    stored, unpacked : (FloatArray, float, float)
        Missing values, and the smallest and largest valid one, of the stored numbers and of the values: limits are of
        the kind that their type is of.
    kind : str
        That of whole numbers, "u" without a sign and "i" with it, where their type is of the other one; else "".
    """

    factor: float
    offset: float
    stored: tuple[NDArray[Any], float, float]
    unpacked: tuple[NDArray[Any], float, float]
    kind: str

    def unpack(self, raw: NDArray[Any]) -> NDArray[np.float64]:
        """The values of stored numbers."""
        numbers = raw.view(f"{self.kind}{raw.dtype.itemsize}") if self.kind and raw.dtype.kind in "iu" else raw
        values = numbers.astype(np.float64) * self.factor + self.offset
        values[_not_valid(numbers, *self.stored) | _not_valid(values, *self.unpacked)] = np.nan
        return values


def _not_valid(numbers: NDArray[Any], missing: NDArray[Any], low: float, high: float) -> NDArray[np.bool_]:
    return np.isin(numbers, missing) | (numbers < low) | (numbers > high)


def packing_of(dataset: Any, column: int | None = None, *, filled: bool = False) -> Packing | None:
    """How the numbers of a dataset, or of a column of it, are packed; None where they are stored as they are.

    In a file of netCDF they are `filled`: a value that was never written is the fill value of the dataset.

    Raises
    ------
    UnreadableLogError
        An attribute of packing is no number.
    """
    given = {name: _numbers(dataset, name) for name in PACKING if name in dataset.attrs}
    kind = _KIND_BY_UNSIGNED.get(str(plain(dataset.attrs.get("_Unsigned", ""))).casefold(), "")
    if filled and dataset.dtype.name in _FILLED and "_FillValue" not in given:
        given["_FillValue"] = np.ravel(dataset.fillvalue)
    if not given and not kind:
        return None
    factor, offset = (
        _scalar(given.get(name, [empty]), name, column) for name, empty in zip(PACKING[:2], (1.0, 0.0), strict=True)
    )
    limits: list[tuple[NDArray[Any], float, float]] = []
    for of_values in (False, True):
        own = {n: v for n, v in given.items() if (dataset.dtype.kind in "iu" and v.dtype.kind == "f") == of_values}
        missing = np.concatenate([np.empty(0), *(own[n] for n in ("_FillValue", "missing_value") if n in own)])
        span = own.get("valid_range", np.array([-np.inf, np.inf]))
        low, high = (
            own[n][0] if n in own else end for n, end in zip(("valid_min", "valid_max"), span[:2], strict=True)
        )
        if dataset.dtype.kind == "f":
            missing = missing.astype(dataset.dtype)
        limits.append((missing, float(low), float(high)))
    return Packing(factor, offset, limits[0], limits[1], kind)


def described(dataset: Any) -> str:
    """The attributes by which a dataset is unpacked."""
    return ", ".join(
        f"{name} = {plain(dataset.attrs[name])}" for name in (*PACKING, "_Unsigned") if name in dataset.attrs
    )


def _numbers(dataset: Any, name: str) -> NDArray[Any]:
    value = np.ravel(dataset.attrs[name])
    try:
        numbers = value if value.dtype.kind in "iuf" else value.astype(np.float64)
    except (ValueError, TypeError):
        raise UnreadableLogError(f"{name} = {plain(dataset.attrs[name])} is no number") from None
    most = _MOST_NUMBERS.get(name, numbers.size)
    if not numbers.size or numbers.size > most or (name == "valid_range" and numbers.size != most):
        raise UnreadableLogError(f"{name} has {numbers.size} numbers")
    return numbers


def _scalar(numbers: Any, name: str, column: int | None) -> float:
    if len(numbers) > 1 and column is None:
        raise UnreadableLogError(f"{name} has {len(numbers)} numbers")
    number = float(numbers[0] if len(numbers) == 1 else numbers[column])
    if not np.isfinite(number) or (name == "scale_factor" and number == 0.0):
        raise UnreadableLogError(f"{name} = {number:g} cannot be applied")
    return number


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
