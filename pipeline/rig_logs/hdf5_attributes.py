"""What the attributes, the type and the filters of an HDF5 dataset say of its numbers, by the conventions of netCDF."""

import re
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.source import UnreadableLogError
from pipeline.units import time_unit

_UNIT_ATTRIBUTES = ("unit", "units", "Unit", "Units", "UNIT")
_PACKING = ("scale_factor", "add_offset", "_FillValue", "missing_value", "valid_min", "valid_max", "valid_range")
_PERHAPS = re.compile(
    r"scale|scaling|gain|slope|factor|offset|intercept|multiplier|sensitivity|calib\w*", re.IGNORECASE
)
"""Attributes of no convention by which a number might have to be converted."""
_FILTERS = {
    307: "bzip2",
    32001: "blosc",
    32004: "lz4",
    32008: "bitshuffle",
    32013: "zfp",
    32015: "zstd",
    32026: "blosc2",
}
_KINDS = {"c": "complex: save its real part", "O": "text or lists", "S": "text", "U": "text", "V": "no numbers"}


def unit_of(dataset: Any) -> tuple[str, str]:
    """The unit of a dataset, and the origin of a time such as ``seconds since 2024-01-31``; "" where there is none."""
    for attribute in _UNIT_ATTRIBUTES:
        value = dataset.attrs.get(attribute)
        text = value.decode("utf-8", "replace") if isinstance(value, bytes) else value
        if isinstance(text, str):
            _, since, origin = text.partition(" since ")
            return (time_unit(text), origin) if since and time_unit(text) else (text, "")
    return "", ""


def why_unread(dataset: Any) -> str:
    """Why no numbers are read from a dataset; "" where they are."""
    filters = dataset.id.get_create_plist()
    codes = [filters.get_filter(i)[0] for i in range(filters.get_nfilters())]
    if foreign := [code for code in codes if not h5py.h5z.filter_avail(code)]:
        name = _FILTERS.get(foreign[0], "unknown")
        return f"compressed by a filter that is not read here, {name} ({foreign[0]}): write it with gzip or none"
    return "" if dataset.dtype.names else _KINDS.get(dataset.dtype.kind, "")


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
    unsigned : bool
        Whether whole numbers are stored without a sign.
    """

    factor: float
    offset: float
    stored: tuple[NDArray[Any], float, float]
    unpacked: tuple[NDArray[Any], float, float]
    unsigned: bool

    def unpack(self, raw: NDArray[Any]) -> NDArray[np.float64]:
        """The values of stored numbers."""
        numbers = raw.view(f"u{raw.dtype.itemsize}") if self.unsigned and raw.dtype.kind == "i" else raw
        values = numbers.astype(np.float64) * self.factor + self.offset
        values[_not_valid(numbers, *self.stored) | _not_valid(values, *self.unpacked)] = np.nan
        return values


def _not_valid(numbers: NDArray[Any], missing: NDArray[Any], low: float, high: float) -> NDArray[np.bool_]:
    return np.isin(numbers, missing) | (numbers < low) | (numbers > high)


def packing_of(dataset: Any, column: int | None = None) -> Packing | None:
    """How the numbers of a dataset, or of a column of it, are packed; None where they are stored as they are.

    Raises
    ------
    UnreadableLogError
        An attribute of packing is no number.
    """
    given = {name: _numbers(dataset, name) for name in _PACKING if name in dataset.attrs}
    unsigned = str(_text(dataset.attrs.get("_Unsigned", ""))).casefold() == "true"
    if not given and not unsigned:
        return None
    factor, offset = (
        _scalar(given.get(name, [empty]), name, column) for name, empty in zip(_PACKING[:2], (1.0, 0.0), strict=True)
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
    return Packing(factor, offset, limits[0], limits[1], unsigned)


def described(dataset: Any) -> str:
    """The attributes by which a dataset is unpacked."""
    return ", ".join(
        f"{name} = {_text(dataset.attrs[name])}" for name in (*_PACKING, "_Unsigned") if name in dataset.attrs
    )


def perhaps_packed(dataset: Any) -> str:
    """Attributes that may have to be applied by the settings, since no convention says so; "" where there are none."""
    return ", ".join(f"{name} = {_text(dataset.attrs[name])}" for name in dataset.attrs if _PERHAPS.fullmatch(name))


def _numbers(dataset: Any, name: str) -> NDArray[Any]:
    value = np.ravel(dataset.attrs[name])
    try:
        numbers = value if value.dtype.kind in "iuf" else value.astype(np.float64)
    except (ValueError, TypeError):
        raise UnreadableLogError(f"{name} = {_text(dataset.attrs[name])} is no number") from None
    if not numbers.size:
        raise UnreadableLogError(f"{name} is empty")
    return numbers


def _scalar(numbers: Any, name: str, column: int | None) -> float:
    if len(numbers) > 1 and column is None:
        raise UnreadableLogError(f"{name} has {len(numbers)} numbers")
    number = float(numbers[0] if len(numbers) == 1 else numbers[column])
    if not np.isfinite(number) or (name == "scale_factor" and number == 0.0):
        raise UnreadableLogError(f"{name} = {number:g} cannot be applied")
    return number


def _text(value: Any) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
