"""One writer per run: the second is told who and since when; the dead hold nothing; no locks is said so."""

import errno
import os
import signal
import stat
import subprocess
import sys
import time

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError, RunLockedError
from pipeline.runs.lock import run_lock
from pipeline.runs.manifest import Recipe
from pipeline.runs.run_folder import RunFolder
from pipeline.tools.verify import verify_everything
from tests.faults.system_calls import Kind

HOLD = """
import sys, time
from pathlib import Path
from pipeline.runs.lock import run_lock
with run_lock(Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(60)
"""


@pytest.fixture
def holder(tmp_path):
    process = subprocess.Popen([sys.executable, "-c", HOLD, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "held\n"
    yield process
    process.kill()
    process.wait()
    process.stdout.close()


def test_the_second_run_is_told_who_and_since_when(tmp_path, holder, bench):
    second = CliRunner().invoke(app, ["run", str(bench.prototype), "-o", str(tmp_path)])
    assert second.exit_code == 5
    (line,) = second.stderr.splitlines()
    assert f"in use by process {holder.pid} on " in line and " since 20" in line
    assert line.endswith("wait for it to finish or use another folder")


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGTERM])
def test_a_dead_holder_holds_nothing(tmp_path, holder, end):
    os.kill(holder.pid, end)
    holder.wait()
    with run_lock(tmp_path):
        pass


def test_a_stopped_holder_still_holds(tmp_path, holder):
    os.kill(holder.pid, signal.SIGSTOP)
    time.sleep(0.05)
    with pytest.raises(RunLockedError), run_lock(tmp_path):
        pass
    os.kill(holder.pid, signal.SIGCONT)


@pytest.mark.parametrize("code", [errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP])
def test_a_file_system_without_locks_is_explained(tmp_path, monkeypatch, code):
    """As some network file systems answer."""

    def flock(*_):
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr("fcntl.flock", flock)
    with (
        pytest.raises(InputError, match=r"offers no file locks.*put the run on a local disk") as caught,
        run_lock(tmp_path),
    ):
        pass
    assert str(tmp_path) in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.usefixtures("interception")
@pytest.mark.parametrize("code", [errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP])
def test_a_run_where_the_kernel_refuses_locks(bench, code):
    """The system call itself is answered so, as on a network mount without a lock service; nothing is written."""
    bench.start("changed")
    before = {path: path.read_bytes() for path in bench.run.rglob("*") if path.is_file()}
    ended = bench.intercepted(lambda _: code, {"flock": Kind(73, 0)})
    assert ended.calls and ended.code == 2
    assert "offers no file locks" in ended.text and "local disk" in ended.text and "\n" not in ended.text
    assert {path: path.read_bytes() for path in bench.run.rglob("*") if path.is_file()} == before


def test_the_note_of_a_holder_is_not_trusted(tmp_path, holder):
    (tmp_path / ".lock-holder.json").write_text('{"pid": "x", "host": "\\u001b[31m"}')
    with pytest.raises(RunLockedError, match="in use by another process"), run_lock(tmp_path):
        pass


def test_a_deleted_lock_lets_nobody_in(tmp_path, holder):
    """The lock is the folder's; the file is for file systems that lock no folders."""
    (tmp_path / ".lock").unlink()
    with pytest.raises(RunLockedError, match=f"in use by process {holder.pid}"), run_lock(tmp_path):
        pass


def _no_folder_locks(monkeypatch):
    """As on NFS, where a lock needs a descriptor that can be written."""
    import fcntl

    flock = fcntl.flock

    def files_only(descriptor, operation):
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        flock(descriptor, operation)

    monkeypatch.setattr("fcntl.flock", files_only)


def test_where_folders_cannot_be_locked_the_file_is(tmp_path, monkeypatch, holder):
    _no_folder_locks(monkeypatch)
    with pytest.raises(RunLockedError), run_lock(tmp_path):
        pass


@pytest.mark.parametrize("another", [True, False])
def test_where_folders_cannot_be_locked_a_deleted_lock_ends_the_writing(tmp_path, monkeypatch, another):
    """Two writers at a time would leave a folder that fails `verify`; so the first one writes no more."""
    _no_folder_locks(monkeypatch)
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    with run_lock(run.root):
        run.commit(Recipe("s", "1", {}, {}), {"one.json": run.write_text("one.json", "1", {})})
        (run.root / ".lock").unlink()
        if another:  # process got in
            (run.root / ".lock").touch()
        with pytest.raises(RunLockedError, match=r"\.lock was removed while it was worked on"):
            run.commit(Recipe("s", "1", {}, {}), {"two.json": run.write_text("two.json", "2", {})})
    assert sorted(RunFolder.open(run.root).manifest.artifacts) == ["one.json"]
    assert verify_everything(run.root)[0].problems == []


def test_a_run_that_is_moved_away_is_written_no_more(tmp_path):
    run = RunFolder.create(tmp_path / "run", {}, tmp_path / "P.toml")
    with run_lock(run.root):
        written = {"one.json": run.write_text("one.json", "1", {})}
        run.root.rename(tmp_path / "other")
        run.root.mkdir()
        with pytest.raises(RunLockedError, match="was moved or replaced"):
            run.commit(Recipe("s", "1", {}, {}), written)
    assert not list(run.root.iterdir())
