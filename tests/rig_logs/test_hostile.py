"""Damaged, truncated and hostile logs: one line that names the file, nothing opened outside it, no bomb expanded."""

import os
import subprocess
import sys
import zlib
from pathlib import Path

import h5py
import numpy as np
import pytest
from scipy.io import savemat

from pipeline.errors import InputError
from pipeline.rig_logs import Limits, read_recording
from pipeline.rig_logs.source import UnreadableLogError
from tests.rig_logs import broken_readers
from tests.rig_logs.small_logs import open_here


def _refused(path: Path, match: str, **options) -> None:
    with pytest.raises(InputError, match=match) as error:
        read_recording(path, **options)
    text = str(error.value)
    assert text.startswith(str(path)) and "\n" not in text and len(text) < 500


def test_no_log_at_all(tmp_path):
    _refused(tmp_path, "is a directory, not a log")
    _refused(tmp_path / "missing.mat", "cannot be read \\(No such file")
    (tmp_path / "empty.mat").touch()
    _refused(tmp_path / "empty.mat", "the file is empty")
    os.mkfifo(tmp_path / "pipe")
    _refused(tmp_path / "pipe", "no regular file")


def test_garbage(tmp_path):
    path = tmp_path / "log.mat"
    path.write_bytes(np.random.default_rng(0).bytes(20_000))
    _refused(path, "no text and no format that is known")


@pytest.mark.parametrize(
    ("kind", "match"),
    [
        ("mat", "truncated or damaged"),
        ("mat73", "truncated file"),
        ("h5", "truncated file"),
        ("parquet", "magic bytes not found in footer"),
        ("csv", "truncated: it ends within a row"),
        ("mf4", "truncated or damaged"),
    ],
)
def test_truncated(logs, tmp_path, kind, match):
    whole = logs[kind].read_bytes()
    path = tmp_path / f"cut.{kind}"
    end = len(whole) // 2
    if kind == "csv":  # within a row, not between two
        end = whole.index(b";", end)
    path.write_bytes(whole[:end])
    _refused(path, match)


def test_death_of_the_reader_is_an_error(logs, monkeypatch):
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.dies)
    _refused(logs["mat"], "died of SIGSEGV; the file is damaged")
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.raises)
    _refused(logs["mat"], "failed \\(RuntimeError: boom\\)")
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.babbles)
    _refused(logs["mat"], "failed")


def test_a_hung_reader_ends_at_its_limit(logs, monkeypatch):
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.sleeps)
    monkeypatch.setattr("pipeline.rig_logs.guarded._PATIENCE", 0.01)
    _refused(logs["mat"], "reading it does not end; damaged, or on a stalled file system")


@pytest.mark.parametrize("most", [12, 14, 24])
def test_too_few_descriptors_are_no_damage(logs, tmp_path, most):
    """With twelve the server printed a traceback below the line, with fourteen the command."""
    resource = pytest.importorskip("resource")
    (tmp_path / "log.csv").write_bytes(logs["csv"].read_bytes())
    ended = subprocess.run(
        [sys.executable, "-P", "-c", "from cli import app; app()", "inspect", str(tmp_path / "log.csv")],
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most)), capture_output=True, text=True,
    )  # fmt: skip
    assert "damaged" not in ended.stderr and "Traceback" not in ended.stderr
    assert ended.returncode == 0 or "Too many open files; raise the limit" in ended.stderr


def test_limits_hold(logs, monkeypatch):
    _refused(logs["csv"], "needs more than 40 MB|cannot|failed|died", limits=Limits(memory_bytes=40 << 20))
    _refused(logs["mat"], "declares 0.*beyond the limit", limits=Limits(data_bytes=1000, small_bytes=0))
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.never_ends)
    _refused(logs["mat"], "was ended after")


def test_answers_of_a_corrupted_child_are_not_believed(logs, monkeypatch):
    monkeypatch.setattr("pipeline.rig_logs.guarded._READER", broken_readers.promises_samples_that_are_not_there)
    _refused(logs["mat"], "samples that are not there")


def test_a_compressed_bomb_is_refused_by_its_declared_size(tmp_path):
    path = tmp_path / "bomb.mat"
    savemat(path, {"x": np.zeros(5_000_000)}, do_compression=True)
    assert path.stat().st_size < 50_000
    _refused(path, r"declare 40 MB, beyond the limit of 10 MB; refused unread", limits=Limits(small_bytes=10_000_000))


def test_a_variable_that_expands_further_than_declared_is_cut(tmp_path):
    path = tmp_path / "liar.mat"
    header = b"MATLAB 5.0 MAT-file".ljust(124) + b"\0\x01IM"
    tag = np.array([14, 64], dtype="<u4").tobytes()
    packed = zlib.compress(tag + b"\0" * 50_000_000)
    path.write_bytes(header + np.array([15, len(packed)], dtype="<u4").tobytes() + packed)
    _refused(path, "truncated or damaged|died of|no numeric channel", channels=["x"])


def test_hdf5_claims_are_not_believed(tmp_path):
    path = tmp_path / "bomb.h5"
    with h5py.File(path, "w") as file:
        file.create_dataset("x", (2_000_000_000,), "f8", chunks=True)
    _refused(path, "claims 16000 MB and stores 0 MB; refused unread")


def _external_link(file):
    file["p"] = h5py.ExternalLink("/etc/passwd", "/x")


def _external_storage(file):
    file.create_dataset("p", (100,), "u1", external=[("/etc/passwd", 0, 100)])


def _virtual(file):
    layout = h5py.VirtualLayout((10,), "f8")
    layout[:] = h5py.VirtualSource("other.h5", "x", (10,))
    file.create_virtual_dataset("p", layout)


@pytest.mark.parametrize("suffix", [".h5", ".mat"])
@pytest.mark.parametrize(
    ("plant", "match"),
    [
        (_external_link, "leads elsewhere"),
        (_external_storage, "external storage"),
        (_virtual, "virtual dataset"),
    ],
)
def test_nothing_outside_the_file_is_opened(tmp_path, plant, match, suffix):
    path = tmp_path / f"log{suffix}"
    with h5py.File(path, "w", userblock_size=512) as file:
        plant(file)
    if suffix == ".mat":
        with path.open("r+b") as raw:
            raw.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\0\x02IM")
    with pytest.raises(UnreadableLogError, match=match):
        open_here(path)
