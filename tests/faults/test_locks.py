"""One writer per run: the second is told who and since when; the dead hold nothing; no locks is said so."""

import errno
import os
import signal
import subprocess
import sys
import time

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError, RunLockedError
from pipeline.store.atomic import is_held, run_lock
from tests.faults.system_calls import Kind

HOLD = """
import sys, time
from pathlib import Path
from pipeline.store.atomic import run_lock
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


def test_two_writers_do_not_mix_and_the_second_can_follow(tmp_path):
    with run_lock(tmp_path):
        with pytest.raises(RunLockedError, match=f"in use by process {os.getpid()} on "), run_lock(tmp_path):
            pass
        assert is_held(tmp_path)
    assert not is_held(tmp_path)
    with run_lock(tmp_path):
        pass


@pytest.mark.parametrize("kind", ["symbolic", "hard"])
def test_a_lock_that_leads_to_a_file_of_the_user_changes_none(tmp_path, kind):
    (tmp_path / "mine").write_text("mine")
    (tmp_path / "run").mkdir()
    lock = tmp_path / "run" / ".lock"
    lock.symlink_to(tmp_path / "mine") if kind == "symbolic" else lock.hardlink_to(tmp_path / "mine")
    try:
        with run_lock(tmp_path / "run"):
            pass
    except InputError as refused:
        assert kind == "symbolic" and ".lock: is a symbolic link" in str(refused)
    assert (tmp_path / "mine").read_text() == "mine"
