"""Processes of their own run no file of the current folder and no main module, and end with their parent."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pipeline.system.isolation import Isolated, death
from tests.prototypes import SMALL_CSV

PLANTED = ("cli", "typer", "numpy", "struct", "json", "pipeline", "multiprocessing", "pyarrow", "sitecustomize")
SPAWN = "import socket; del socket.CMSG_LEN\n"  # without it, descriptors cannot be handed on, so nothing is forked
METHODS = pytest.mark.parametrize(
    "method", ["", pytest.param(SPAWN, marks=pytest.mark.long)], ids=["fork server", "spawn"]
)


def crashes(send):
    os.kill(os.getpid(), signal.SIGSEGV)


def fails(send):
    raise RuntimeError("boom")


def sleeps(send, *_):
    send(os.getpid())
    time.sleep(120)


@pytest.fixture
def planted(tmp_path, monkeypatch):
    """A current folder full of modules that leave a file behind when they are run, with a log."""
    folder = tmp_path / "planted"
    folder.mkdir()
    for name in PLANTED:
        (folder / f"{name}.py").write_text(f"open({str(folder / 'ran')!r}, 'a').write({name!r})\nraise SystemExit(9)\n")
    (folder / "log.csv").write_text(SMALL_CSV)
    monkeypatch.chdir(folder)
    return folder


def _run(script: str, *arguments: str, **options) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-P", "-c", script, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300, **options)


@METHODS
def test_a_reader_runs_nothing_of_the_current_folder(planted, method):
    ended = _run(method + "from cli import app; app()", "inspect", "log.csv")
    assert ended.returncode == 0, ended.stderr
    assert not (planted / "ran").exists()


@METHODS
def test_a_worker_runs_nothing_of_the_current_folder(planted, method):
    (planted / "P.toml").write_text("name = 1")
    ended = _run(method + "from cli import app; app()", "batch", "P.toml", "-o", "runs")
    assert ended.returncode == 6 and "P.toml" in ended.stderr, ended.stderr
    assert not (planted / "ran").exists()


@METHODS
def test_a_program_whose_path_begins_with_the_current_folder_hands_it_to_no_process(planted, method):
    script = "import sys\nfrom pathlib import Path\nfrom pipeline.rig_logs import read_recording\n"
    script += "import multiprocessing.connection, tempfile\nsys.path.insert(0, '')\n"
    ended = _run(method + script + "print(read_recording(Path('log.csv')).listed)")
    assert ended.stdout == "('time', 'q', 'u')\n", ended.stderr
    assert not (planted / "ran").exists()


@METHODS
def test_a_script_needs_no_guard(tmp_path, method):
    (tmp_path / "log.csv").write_text(SMALL_CSV)
    (tmp_path / "script.py").write_text(
        f"{method}import debist\nfrom pathlib import Path\nfrom pipeline.rig_logs import read_recording\n"
        "print('script')\nprint(read_recording(Path('log.csv')).listed)\n"
    )
    command = [sys.executable, "script.py"]
    ended = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False, timeout=300)
    assert ended.stdout == "script\n('time', 'q', 'u')\n", ended.stderr


def test_a_death_has_the_name_of_its_signal_and_a_failure_its_words():
    with Isolated(crashes) as process:
        assert list(process) == [] and death(process.exit_code()) == "SIGSEGV"
    with Isolated(fails) as process:
        assert list(process) == [] and process.exit_code() == 1 and "RuntimeError: boom" in process.words()
    assert "memory" in death(-signal.SIGKILL) and "memory" not in death(-signal.SIGABRT) + death(1)
    assert death(0xC0000005) == "exit code 0xc0000005"


def test_a_time_limit_ends_a_process():
    began = time.monotonic()
    with Isolated(sleeps, time_limit=1.0) as process:
        assert len(list(process)) <= 1 and process.exit_code() == -signal.SIGKILL and process.late
    assert time.monotonic() - began < 60.0


@METHODS
def test_a_process_ends_with_its_killed_parent(method):
    script = f"{method}from pipeline.system.isolation import Isolated\nfrom tests.faults.test_isolation import sleeps\n"
    script += "print(next(iter(Isolated(sleeps))), flush=True)\nimport time; time.sleep(120)\n"
    command = [sys.executable, "-c", script]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        pid = int(parent.stdout.readline())
        parent.kill()
    deadline = time.monotonic() + 30.0
    while _runs(pid) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not _runs(pid)


def _runs(pid: int) -> bool:
    try:
        os.kill(pid, 0)
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
