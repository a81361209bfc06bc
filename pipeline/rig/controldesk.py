"""MAT files as ControlDesk exports them: one struct with ``X`` (time axes) and ``Y`` (channels)."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.io import savemat

from pipeline.numerics.arrays import FloatArray

_RASTER = "HostService"


def write_mat5(
    path: Path, t: FloatArray, channels: dict[str, tuple[FloatArray, str]], *, variable: str = "rec"
) -> None:
    """Write `channels` (name → samples, unit) over the times `t` [s] as MAT v5, samples in single precision."""
    x_fields = {"Name": "", "Type": 5, "Data": t[None, :], "Unit": "s", "Raster": _RASTER}
    y_fields = [
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
    record = {
        "Info": {"RevisionMajor": 2},
        "X": _struct_array([x_fields]),
        "Y": _struct_array(y_fields),
        "Description": {"General": {"User": "virtual rig"}},
    }
    savemat(path, {variable: record}, format="5", do_compression=False)


def _struct_array(records: list[dict[str, Any]]) -> NDArray[np.void]:
    """A 1×n MATLAB struct array from `records` with equal keys."""
    array = np.empty((1, len(records)), dtype=[(field, object) for field in records[0]])
    for i, record in enumerate(records):
        array[0, i] = tuple(record.values())
    return array
