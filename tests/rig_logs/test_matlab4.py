"""MAT v4 files: read lazily, whatever their byte order and numbers, and refused where they are damaged."""

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pipeline.errors import InputError
from pipeline.rig_logs import read_recording

T = np.arange(500) * 0.01
Q = np.sin(9.0 * T)


def saved(folder: Path, **variables: object) -> Path:
    savemat(folder / "log.mat", variables, format="4")
    return folder / "log.mat"


@pytest.mark.parametrize("kind", ["float64", "float32", "int32", "int16", "uint16", "uint8"])
def test_vectors_of_every_number(tmp_path: Path, kind: str) -> None:
    whole = (100.0 * np.abs(Q)).astype(kind)
    recording = read_recording(saved(tmp_path, t=T, q=whole, note="a text"))
    assert recording.format == "MAT v4"
    assert [channel.name for channel in recording.channels] == ["t", "q"]
    np.testing.assert_array_equal(recording.channel("q").samples, whole.astype(np.float64))
    np.testing.assert_array_equal(recording.channel("t").samples, T)


def test_rows_and_columns_of_a_matrix(tmp_path: Path) -> None:
    for table, name in ((np.vstack([T, Q]), "m(2,:)"), (np.column_stack([T, Q]), "m(:,2)")):
        recording = read_recording(saved(tmp_path, m=table))
        np.testing.assert_array_equal(recording.channel(name).samples, Q)


def test_the_other_byte_order(tmp_path: Path) -> None:
    head = np.array([1000, 1, Q.size, 0, 2], dtype=">i4").tobytes()
    (tmp_path / "log.mat").write_bytes(head + b"q\0" + Q.astype(">f8").tobytes())
    np.testing.assert_array_equal(read_recording(tmp_path / "log.mat").channel("q").samples, Q)


@pytest.mark.parametrize("cut", [5, 30, 3000])
def test_a_truncated_file_is_refused(tmp_path: Path, cut: int) -> None:
    path = saved(tmp_path, t=T, q=Q)
    path.write_bytes(path.read_bytes()[:-cut])
    with pytest.raises(InputError, match="truncated or damaged"):
        read_recording(path)
