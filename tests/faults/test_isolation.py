"""Children run no file of the current folder and end with their parent; one that dies has not yet damned a file."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import cli
import pipeline
from pipeline.batch.worker import Workers, run_worker
from pipeline.child_processes import import_path, isolated
from pipeline.errors import InputError
from pipeline.process_copies import CAN_COPY
from pipeline.rig_logs import guarded, read_recording

PLANTED = ("cli", "typer", "numpy", "json", "pipeline", "multiprocessing", "sitecustomize")
POOL = """
import os, sys, time
from pipeline.child_processes import process_pool
if __name__ == "__main__":
    with process_pool(2) as pool:
        print(*sorted(set(pool.map(lambda_pid, range(8)))), flush=True)
        list(pool.map(time.sleep, [120, 120]))
"""


@pytest.fixture
def planted(tmp_path, monkeypatch):
    """A current folder full of modules that leave a file behind when they are run."""
    for name in PLANTED:
        (tmp_path / f"{name}.py").write_text(
            f"open({str(tmp_path / 'ran')!r}, 'a').write({name!r})\nraise SystemExit(9)\n"
        )
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend("")
    return tmp_path


def test_a_worker_runs_nothing_of_the_current_folder(planted):
    outcome = run_worker("cli:app", "P", Path("missing.toml"), planted / "runs")
    assert (outcome.exit_code, (planted / "ran").exists()) == (2, False), outcome.reason
    assert "missing.toml: no such file" in outcome.reason


@pytest.mark.skipif(not CAN_COPY, reason="processes cannot be copied here")
@pytest.mark.parametrize("warm", [False, pytest.param(True, marks=pytest.mark.long)])
def test_a_copied_worker_runs_nothing_of_the_current_folder(planted, warm):
    with Workers("cli:app", warm) as workers:
        outcomes = [workers.run("P", Path("missing.toml"), planted / "runs") for _ in range(2)]
        assert workers._copies is not None and not workers._copies.ended
    assert not (planted / "ran").exists()
    for outcome in outcomes:
        assert outcome.exit_code == 2 and "missing.toml: no such file" in outcome.reason


def test_a_reader_runs_nothing_of_the_current_folder(planted):
    (planted / "log.csv").write_text("t,q\n" + "".join(f"{i / 100},{i % 7}\n" for i in range(100)))
    assert read_recording(Path("log.csv")).listed == ("t", "q")
    assert not (planted / "ran").exists()


def test_the_import_path_leads_to_this_debist_wherever_it_lies(planted):
    command = isolated("import cli, pipeline; print(cli.__file__, pipeline.__file__)")
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert told == [cli.__file__, pipeline.__file__]
    assert str(planted) not in import_path()


def test_the_processes_of_a_pool_end_with_a_killed_parent(tmp_path):
    """As those of `debist study -j`; they would go on for hours, and hold the run's lock."""
    (tmp_path / "pool.py").write_text("import os\ndef lambda_pid(_):\n    return os.getpid()\n" + POOL)
    parent = subprocess.Popen([sys.executable, str(tmp_path / "pool.py")], stdout=subprocess.PIPE, text=True)
    assert parent.stdout is not None
    children = [int(pid) for pid in parent.stdout.readline().split()]
    parent.kill()
    parent.wait()
    parent.stdout.close()
    deadline = time.monotonic() + 20.0
    while any(_runs(pid) for pid in children) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert children and not [pid for pid in children if _runs(pid)]


def _runs(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


@pytest.mark.parametrize("deaths", [1, 2])
def test_a_reader_that_dies_reads_again_before_the_file_is_blamed(tmp_path, monkeypatch, deaths):
    """The first child writes some samples and dies of SIGABRT, as a library's thread may make it at its end."""
    path = tmp_path / "log.csv"
    path.write_text("t,q\n" + "".join(f"{i / 100},{i % 7}\n" for i in range(100)))
    whole, run_child, started = guarded.read_recording(path), guarded._run_child, []

    def dying(request, timeout):
        started.append(1)
        if len(started) > deaths:
            return run_child(request, timeout)
        os.write(request["data_fd"], b"\x01" * 24)
        return subprocess.CompletedProcess([], -signal.SIGABRT, b"", b"")

    monkeypatch.setattr(guarded, "_run_child", dying)
    if deaths == 1:
        again = read_recording(path)
        assert [list(c.samples) for c in again.channels] == [list(c.samples) for c in whole.channels]
    else:
        with pytest.raises(InputError, match="died of SIGABRT, and again at a second reading"):
            read_recording(path)
