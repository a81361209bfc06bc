"""MAT files of version 7.3: HDF5 with MATLAB's conventions, read with h5py under the checks of `hdf5`.

A scalar struct is a group, its fields are members. A struct array is a group whose members are datasets of object
references, one per element. A text is a dataset of UTF-16 code units with the attribute MATLAB_class "char". An empty
array has MATLAB_empty and holds its dimensions instead of samples. Dimensions are reversed.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .hdf5 import checked, child_of, flat, open_hdf5, rows_at_a_time, why_unread
from .mat_source import MatArray, MatObject, MatSource, MatStruct, MatValue
from .source import UnreadableLogError


@dataclass(frozen=True)
class _Struct(MatStruct):
    """A struct array; members are looked up when asked for."""

    group: Any

    def get(self, index: int, name: str) -> MatValue:
        """Field `name` of element `index`, or None."""
        if name not in self.fields or index >= self.count:
            return None
        member = child_of(self.group, name)
        if not _is_references(member) or _class_of(member) == "cell":
            return _value(member)
        references = np.asarray(member[()]).reshape(-1)
        return _value(checked(self.group.file[references[index]])) if index < references.size else None


def open_log(path: Path, *_: object) -> MatSource:
    """The log as `pipeline.rig_logs.child` opens it.

    Raises
    ------
    UnreadableLogError
        Truncated, damaged, or with links and storage that lead out of the file.
    """
    file = open_hdf5(path)
    return MatSource("v7.3", {name: _value(child_of(file, name)) for name in file if not name.startswith("#")}, path)


def _value(item: Any) -> MatValue:
    if "MATLAB_object_decode" in item.attrs:
        return MatObject(_class_of(item))
    if isinstance(item, h5py.Group):
        return MatObject("sparse array") if "MATLAB_sparse" in item.attrs else _struct(item)
    if not isinstance(item, h5py.Dataset) or item.attrs.get("MATLAB_empty", 0):
        return "" if _class_of(item) == "char" else None
    if _class_of(item) == "char":
        return np.asarray(item[()], dtype="<u2").tobytes(order="F").decode("utf-16-le", "replace") if item.size else ""
    if _class_of(item) == "cell" or _is_references(item):
        return MatObject("cell")
    if item.dtype.names == ("real", "imag"):
        return MatObject("complex array")
    if item.dtype.kind not in "fiub" or (item.size and why_unread(item)):
        return MatObject(f"{_class_of(item)} {why_unread(item)}".strip())
    return MatArray(
        tuple(reversed(item.shape)),
        item.dtype.name,
        lambda start, stop: flat(item, start, stop, item.shape),
        rows_at_a_time(item, int(np.argmax(item.shape))) if item.shape else 1,  # a matrix is read by columns
    )


def _struct(group: Any) -> MatValue:
    fields = tuple(group)
    # Of a struct array every field is a dataset of references, one for each element.
    members = [child_of(group, field) for field in fields]
    arrays = [member for member in members if _is_references(member) and _class_of(member) == ""]
    if not arrays:
        return _Struct(fields, 1, group)
    sizes = {member.size for member in arrays}
    if len(sizes) != 1:
        raise UnreadableLogError(f"{group.name} is no proper struct array")
    return _Struct(fields, sizes.pop(), group)


def _is_references(item: Any) -> bool:
    return isinstance(item, h5py.Dataset) and h5py.check_ref_dtype(item.dtype) is h5py.Reference


def _class_of(item: Any) -> str:
    name = item.attrs.get("MATLAB_class", b"")
    return name.decode("ascii", "replace") if isinstance(name, bytes) else str(name)
