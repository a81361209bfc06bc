"""MAT v4 files, which are not read: one line says how to save them anew."""

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording


@pytest.mark.parametrize("order", ["<", ">"])
def test_it_is_named_with_what_to_do(tmp_path: Path, order: str) -> None:
    path = tmp_path / "log.mat"
    savemat(path, {"q": np.arange(50.0)}, format="4")
    if order == ">":
        path.write_bytes(np.array([1000, 1, 50, 0, 2], dtype=">i4").tobytes() + b"q\0" + bytes(400))
    with pytest.raises(
        InputError, match=r"MAT file of version 4; load it in MATLAB and save it by `save NAME.mat -v7`"
    ):
        read_recording(path)
