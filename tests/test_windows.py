"""The program on CPython for Windows, where `DEBIST_WINDOWS_PYTHON` names a command that runs it, as under Wine.

The command takes Python's arguments and the current folder, and sees Linux's root as drive Z, as Wine has it.
"""

import os
import shlex
import signal
import subprocess
from pathlib import Path

import pytest

from pipeline.rig.bench import Readings
from pipeline.rig.log import LAYOUTS
from tests.prototypes import motion, settings, write_csv

COMMAND = shlex.split(os.environ.get("DEBIST_WINDOWS_PYTHON", ""))
pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(not COMMAND, reason="DEBIST_WINDOWS_PYTHON names no Python for Windows"),
]
ROOT = "Z:" + str(Path(__file__).resolve().parents[1]).replace("/", "\\")
NAMES = ("a", "b")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two prototypes of a double well, in a folder whose name has a blank and an umlaut."""
    here = tmp_path_factory.mktemp("windows") / "Gelenk ä"
    here.mkdir()
    for name in NAMES:
        write_csv(here / f"{name} ü.csv", *motion(10.0, 200.0, 1, noise=3e-6))
        (here / f"{name} ü.toml").write_text(settings(name=name, train=f"{name} ü.csv"), encoding="utf-8")
    return here


def _started(folder, *arguments):
    return subprocess.Popen(
        [*COMMAND, "-m", "debist", *arguments], cwd=folder, env=os.environ | {"PYTHONPATH": ROOT},
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", start_new_session=True,
    )  # fmt: skip


def _debist(folder, *arguments):
    process = _started(folder, *arguments)
    printed, messages = process.communicate()
    return process.returncode, printed, messages


def test_it_is_windows(folder):
    command = [*COMMAND, "-c", "import sys; print(sys.platform)"]
    assert subprocess.check_output(command, cwd=folder, text=True).strip() == "win32"


@pytest.mark.parametrize("layout", ["mat", "mf4", "parquet"])
def test_a_log_is_read(folder, layout):
    name = f"Messung ö{LAYOUTS[layout].suffix}"
    t, q, v = motion(10.0, 200.0, 1)
    LAYOUTS[layout].save(Readings(t, q, *v.T), folder / name)
    code, printed, messages = _debist(folder, "inspect", name)
    assert code == 0 and name in printed and "2000" in printed, messages


def test_an_interrupted_batch_goes_on(folder):
    arguments = ("batch", *(f"{name} ü.toml" for name in NAMES), "-o", "Läufe 1", "--no-report")
    messages = ""
    with _started(folder, *arguments) as process:
        for line in process.stderr:
            messages += line
            if "[1/2]" in line:
                os.killpg(process.pid, signal.SIGINT)
    assert process.returncode == 130 and "interrupted; 1 of 2 prototypes are done" in messages, messages
    code, _, messages = _debist(folder, *arguments)
    assert code == 0 and "a: up to date" in messages, messages
    for name in NAMES:
        code, printed, messages = _debist(folder, "verify", f"Läufe 1/{name}")
        assert code == 0 and "all intact" in printed, messages
    assert not [file for file in folder.rglob("*.json") if b"\r" in file.read_bytes()]


def test_processes_of_a_run_give_its_error(folder):
    (folder / "short.csv").write_text("t,q\n")
    (folder / "short.toml").write_text(settings(name="short", train="short.csv"), encoding="utf-8")
    code, _, messages = _debist(folder, "run", "short.toml", "--jobs", "2", "-q")
    assert code == 2 and "short.csv" in messages and "Traceback" not in messages, messages


def test_the_demo_runs_to_its_end_with_stages_side_by_side(folder):
    code, printed, messages = _debist(folder, "demo", "-o", "Vorführung 1")
    assert code == 0 and "assessment: data good, model good" in printed, printed + messages
    assert (folder / "Vorführung 1/report.html").is_file()
    code, printed, messages = _debist(folder, "verify", "Vorführung 1")
    assert code == 0 and "all intact" in printed, messages
