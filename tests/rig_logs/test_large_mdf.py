"""MDF groups of 200 MiB and more, for which asammdf has a path of its own that fails for slices."""

from pathlib import Path

import numpy as np
import pytest

from pipeline.rig_logs import read_recording
from pipeline.rig_logs.mdf import MdfSource

RECORD_BYTES = 32


def _write(path: Path, megabytes: float) -> tuple[int, np.ndarray]:
    from asammdf import MDF, Signal

    rows = int(megabytes * 1e6) // RECORD_BYTES
    t, q = np.arange(rows) / 30e3, np.random.default_rng(1).normal(size=rows)
    with MDF(version="4.10") as file:
        file.append([Signal(k * q, timestamps=t, name=f"c{k}", unit="V") for k in (1, 2, 3)])
        file.save(path, overwrite=True)
    return rows, q


def test_slices_do_not_take_the_path_for_large_groups(tmp_path, monkeypatch):
    _, q = _write(tmp_path / "log.mf4", 5.0)
    monkeypatch.setattr("asammdf.blocks.mdf_v4.validate_blocks", lambda *_: True)
    found = np.concatenate([samples for _, samples in MdfSource(tmp_path / "log.mf4").parts(["c2"])])
    assert np.array_equal(found, 2 * q)


@pytest.mark.long
def test_a_group_of_300_megabytes(tmp_path):
    rows, q = _write(tmp_path / "log.mf4", 300.0)
    assert (tmp_path / "log.mf4").stat().st_size > 200 << 20
    recording = read_recording(tmp_path / "log.mf4", channels=["c1", "c3"])
    first, last = recording.channel("c1"), recording.channel("c3")
    assert first.time is not None and first.time.size == first.samples.size == last.samples.size == rows
    assert np.array_equal(first.samples, q)
    assert np.array_equal(last.samples, 3 * q)
    assert first.time[-1] == pytest.approx((rows - 1) / 30e3)
