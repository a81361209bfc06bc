"""Logs of any length: every format gives its samples in parts, and they lie in a mapped temporary file."""

import gc
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from scipy.io import savemat

from pipeline.errors import InputError
from pipeline.rig_logs import Limits, read_recording
from pipeline.rig_logs.source import PART
from tests.rig_logs.small_logs import load, open_here, write_matlab73

ROWS = 300_001
T = np.arange(ROWS) / 1e4
FORMATS = ("parquet", "mdf", "hdf5", "csv")
Q = np.sin(T)


def _write(kind: str, path: Path) -> None:
    if kind in ("mat", "packed.mat"):
        savemat(path, {"t": T, "q": Q}, do_compression=kind == "packed.mat")
    elif kind == "mat73":
        axis = {"Name": "t", "Data": T, "Unit": "s", "Raster": ""}
        write_matlab73(path, [axis], [{**axis, "Name": "q", "Data": Q, "XIndex": 1.0}])
    elif kind == "csv":
        path.write_text("t,q\n" + "\n".join(f"{a!r},{b!r}" for a, b in zip(T.tolist(), Q.tolist(), strict=True)) + "\n")
    elif kind == "blanks":
        path.write_text(
            "t q\n" + "\n".join(f"{a!r}  {b!r}" for a, b in zip(T.tolist(), Q.tolist(), strict=True)) + "\n"
        )
    elif kind == "parquet":  # a single row group
        pq.write_table(pa.table({"t": T, "q": Q}), path, row_group_size=ROWS)
    elif kind == "h5":
        with h5py.File(path, "w") as file:
            file.create_dataset("t", data=T, chunks=(50_000,), compression="gzip")
            file["q"] = Q
    else:
        from asammdf import MDF, Signal

        with MDF(version="4.10") as mdf:
            mdf.append([Signal(Q, T, name="q")])
            mdf.save(path, overwrite=True, compression=1)


@pytest.fixture(scope="module", params=["mat", "packed.mat", "mat73", "csv", "blanks", "parquet", "h5", "mf4"])
def log(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("streaming") / f"log.{request.param}"
    _write(request.param, path)
    return path


def test_no_part_is_much_longer_than_agreed(log: Path) -> None:
    parts = [samples for _, samples in open_here(log).parts(["q"])]
    assert len(parts) > 1 and max(samples.size for samples in parts) < 2 * PART
    np.testing.assert_array_equal(np.concatenate(parts), Q)


@pytest.mark.skipif(not Path("/proc/self/fd").exists(), reason="open files are listed on Linux only")
def test_a_log_is_closed_with_the_last_reference_to_its_reader(log: Path) -> None:
    source = open_here(log)
    load(source, "q")
    gc.disable()
    try:
        del source
        left = [opened.resolve() for opened in Path("/proc/self/fd").iterdir()]
    finally:
        gc.enable()
    assert log not in left


def test_samples_are_those_of_the_log(log: Path) -> None:
    shares: list[float] = []
    channel = read_recording(log, channels=["q"], progress=shares.append).channel("q")
    np.testing.assert_array_equal(channel.samples, Q)
    if channel.time is not None:
        np.testing.assert_allclose(channel.time, T, atol=1e-12)
    with pytest.raises(ValueError, match="read-only"):
        channel.samples[0] = 0.0
    assert shares == sorted(shares) and 0.0 < shares[0] < 1.0 and shares[-1] > 0.9


def test_samples_beyond_the_limit_are_refused_while_they_come(tmp_path: Path) -> None:
    """A text declares no number of rows; short rows below a long head are more than was estimated."""
    path = tmp_path / "log.csv"
    path.write_text("t,q\n" + "0.00000000000000000000000000001,2.000000000000000000000000\n" * 5000 + "1,2\n" * 200_000)
    with pytest.raises(InputError, match=r"holds more of samples in a file of .* beyond the limit of 2 MB"):
        read_recording(path, limits=Limits(small_bytes=2_000_000, expansion=0.0))


@pytest.mark.long
def test_memory_does_not_grow_with_the_log(tmp_path: Path) -> None:
    """But for MAT v5, which SciPy reads as a whole."""
    script = Path(__file__).resolve().parents[2] / "benchmarks/bench_long_log.py"

    def largest(rows: int) -> int:
        done = subprocess.run(
            [sys.executable, str(script), "--rows", str(rows), "--folder", str(tmp_path), "--formats", *FORMATS],
            capture_output=True,
            text=True,
            check=True,
        )
        _, *formats = done.stdout.splitlines()  # format, rows, log, seconds, memory, …
        return max(int(line.split()[4]) for line in formats)

    few, many = largest(1_000_000), largest(8_000_000)
    assert many < 300 and many < few + 60  # as arrays, seven million rows more take 224 MB
