"""MAT files as ControlDesk exports them: one struct with ``X`` (time axes) and ``Y`` (channels), v5 and v7.3."""

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.numerics.arrays import FloatArray

_VARIABLE = "rec"
_RASTER = "HostService"
_USERBLOCK = 512  # bytes before the HDF5 superblock of a v7.3 file


def write_mat5(path: Path, t: FloatArray, channels: dict[str, tuple[FloatArray, str]]) -> None:
    """Write `channels` (name → samples, unit) over the times `t` [s] as MAT v5, samples in single precision."""
    from scipy.io import savemat

    x, y = _axes(t, channels)
    record = {
        "Info": {"RevisionMajor": 2},
        "X": _struct_array([x]),
        "Y": _struct_array(y),
        "Description": {"General": {"User": "virtual rig"}},
    }
    savemat(path, {_VARIABLE: record}, format="5", do_compression=False)


def write_mat73(path: Path, t: FloatArray, channels: dict[str, tuple[FloatArray, str]]) -> None:
    """Write the same as MAT v7.3: HDF5 behind a MATLAB user block, struct arrays as object references."""
    import h5py

    x, y = _axes(t, channels)
    with h5py.File(path, "w", userblock_size=_USERBLOCK, libver=("earliest", "v110")) as file:
        references = file.create_group("#refs#")
        record = _matlab(file.create_group(_VARIABLE), "struct")
        info = _matlab(record.create_group("Info"), "struct")
        _put(info, "RevisionMajor", 2)
        for axis, entries in (("X", [x]), ("Y", y)):
            group = _matlab(record.create_group(axis), "struct")
            for field in entries[0]:
                if len(entries) == 1:
                    _put(group, field, entries[0][field])
                    continue
                cells = group.create_dataset(field, (len(entries), 1), dtype=h5py.ref_dtype)
                for i, entry in enumerate(entries):
                    cells[i, 0] = _put(references, f"{axis}{i}{field}", entry[field]).ref
        general = _matlab(_matlab(record.create_group("Description"), "struct").create_group("General"), "struct")
        _put(general, "User", "virtual rig")
    text = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, virtual rig, HDF5 schema 1.00 .".ljust(116)
    header = text + bytes(8) + struct.pack("<H", 0x0200) + b"IM"
    with path.open("r+b") as raw:
        raw.write(header.ljust(_USERBLOCK, b"\0"))


def _axes(t: FloatArray, channels: dict[str, tuple[FloatArray, str]]) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Fields of the time axis, and of each channel."""
    x = {"Name": "", "Type": 5, "Data": t[None, :], "Unit": "s", "Raster": _RASTER}
    y = [
        {
            "Name": name,
            "Type": 1,
            "Data": samples.astype(np.float32)[None, :],
            "Unit": unit,
            "Raster": _RASTER,
            "Path": f"Model Root/Rig/{name}",
            "XIndex": 1,
        }
        for name, (samples, unit) in channels.items()
    ]
    return x, y


def _struct_array(records: list[dict[str, Any]]) -> NDArray[np.void]:
    """A 1×n MATLAB struct array from `records` with equal keys."""
    array = np.empty((1, len(records)), dtype=[(field, object) for field in records[0]])
    for i, record in enumerate(records):
        array[0, i] = tuple(record.values())
    return array


def _matlab(node: Any, kind: str) -> Any:
    """`node` of an HDF5 file marked with its MATLAB class."""
    node.attrs["MATLAB_class"] = np.bytes_(kind)
    return node


def _put(group: Any, name: str, value: Any) -> Any:
    """Store a text, a number or a row vector as MATLAB does: column-major, texts as UTF-16 code units."""
    if isinstance(value, str):
        codes = np.array([[ord(letter)] for letter in value], dtype=np.uint16)
        if not value:
            node = group.create_dataset(name, data=np.array([0, 0], dtype=np.uint64))
            node.attrs["MATLAB_empty"] = np.uint8(1)
        else:
            node = group.create_dataset(name, data=codes)
        node.attrs["MATLAB_int_decode"] = np.int32(2)
        return _matlab(node, "char")
    array = np.atleast_2d(np.asarray(value, dtype=np.float64 if np.isscalar(value) else None))
    return _matlab(group.create_dataset(name, data=array.T), "single" if array.dtype == np.float32 else "double")
