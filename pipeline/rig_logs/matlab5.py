"""MAT files of version 5 to 7 through SciPy, whose parser may die on damaged files: the guarded child contains that.

Cost: one pass over the file. Memory: all of its variables at once, in the types in which it stores them.
"""

import struct
import warnings
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.io import loadmat
from scipy.io.matlab import MatlabFunction, MatlabObject, MatlabOpaque, varmats_from_mat

from .mat_source import MatArray, MatObject, MatSource, MatStruct, MatValue
from .source import CsvOptions, Limits, UnreadableLogError

_HEADER = 128
_TAG = 8
_COMPRESSED = 15


@dataclass(frozen=True)
class _Struct(MatStruct):
    """A struct array as SciPy gives it."""

    elements: NDArray[Any]

    def get(self, index: int, name: str) -> MatValue:
        """Field `name` of element `index`, or None."""
        return _value(self.elements[index][name]) if index < self.count and name in self.fields else None


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> MatSource:
    """The log as `pipeline.rig_logs.child` opens it.

    Raises
    ------
    UnreadableLogError
        Truncated or damaged, or its variables declare more bytes than the limits allow.
    """
    declared = _declared_bytes(path)
    most = limits.largest(path.stat().st_size)
    if declared > most:
        raise UnreadableLogError(
            f"its variables declare {declared / 1e6:.0f} MB, beyond the limit of {most / 1e6:.0f} MB; refused unread"
        )
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of objects of the same name
            loaded = loadmat(path, appendmat=False)
        objects = _objects(path) if "None" in loaded else {}
    except MemoryError:
        raise
    except Exception as error:  # SciPy lets errors of many kinds through on damaged files
        raise UnreadableLogError(f"truncated or damaged (SciPy: {type(error).__name__}: {error})") from error
    for name, value in loaded.items():
        if isinstance(value, str) and value.startswith("Read error"):
            raise UnreadableLogError(f"the variable {name!r} is damaged ({value})")
    variables = {name: _value(value) for name, value in loaded.items() if not name.startswith("__") and name != "None"}
    return MatSource("v5", variables | objects, path)


def _declared_bytes(path: Path) -> int:
    """Bytes to which the variables of a file expand, by their tags."""
    declared = 0
    with path.open("rb") as file:
        order = "<" if file.read(_HEADER).endswith(b"IM") else ">"
        while len(tag := file.read(_TAG)) == _TAG:
            kind, size = struct.unpack(f"{order}II", tag)
            content = file.tell()
            if kind == _COMPRESSED:
                declared += _expanded_bytes(file.read(min(size, _HEADER)), order)
            file.seek(content + size)
    return declared


def _expanded_bytes(packed: bytes, order: str) -> int:
    """Bytes of a compressed variable, by the tag with which its stream begins; 0 where that is damaged."""
    try:
        tag = zlib.decompressobj().decompress(packed, _TAG)
    except zlib.error:
        return 0
    return int(struct.unpack(f"{order}II", tag)[1]) if len(tag) == _TAG else 0


def _objects(path: Path) -> dict[str, MatValue]:
    """The tables and other objects of classes by their names: SciPy calls each of them None, and keeps the last."""
    with path.open("rb") as file:
        variables: list[Any] = [variable for name, variable in varmats_from_mat(file) if name == "None"]
    single = [loadmat(variable)["None"][0] for variable in variables]
    return {each["s0"].decode("latin-1"): MatObject(each["s2"].decode("latin-1")) for each in single}


def _value(item: Any) -> MatValue:
    """A value as the layouts of MAT files take it."""
    if isinstance(item, MatlabObject):
        return MatObject(f"{item.classname}")
    if isinstance(item, MatlabFunction | MatlabOpaque):
        return MatObject("function handle" if isinstance(item, MatlabFunction) else "object")
    if not isinstance(item, np.ndarray):
        return MatObject("sparse array")
    if item.dtype.names:
        return _Struct(item.dtype.names, item.size, item.ravel(order="F"))
    if item.dtype.kind in "US":
        return " ".join(str(text) for text in item.ravel()).rstrip("\0 ")
    if item.dtype.kind not in "fiub":
        return MatObject("complex array" if item.dtype.kind == "c" else "cell")
    samples = item.ravel(order="F")
    return MatArray(item.shape, item.dtype.name, lambda first, last: samples[first:last])
