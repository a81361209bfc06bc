"""Ctrl-C, as a terminal sends it: what is kept is said, nothing is half-written, and the same command goes on."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from tests.diagnostics.first_hour import TOML, write_logs

_RUN = ("run", "P.toml", "-o", "run", "--no-report")
_STUDY = ("study", "basis", "run")
_KEPT = "finished step"
_HEEDING = (
    "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "  # a job in the background does not
    "import cli; cli.app()"
)


def _interrupted(folder: Path, command: tuple[str, ...], after: str) -> str:
    """Start a command as a shell does, send SIGINT to its process group after a line, and return what it said."""
    program = [sys.executable, "-c", _HEEDING, *command]
    said = ""
    with subprocess.Popen(
        program, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        assert process.stderr is not None
        for line in process.stderr:
            said += line
            if after in line:
                os.killpg(process.pid, signal.SIGINT)
                after = "sent once"
    assert process.returncode == 130, said
    assert "Traceback" not in said
    assert not list(folder.rglob("*.tmp*"))
    return said


def _goes_on(*command: str) -> str:
    result = CliRunner().invoke(app, command)
    assert result.exit_code == 0, result.output
    return result.output


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("interrupted")
    write_logs(folder)
    return folder


@pytest.mark.long
def test_a_run_and_its_study_keep_finished_steps(logs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(logs)
    said = _interrupted(logs, _RUN, "validation log: done")
    assert "debist: interrupted; the results of " in said and _KEPT in said and "goes on from there" in said
    again = _goes_on(*_RUN)
    assert "were up to date" in again and " 0 were up to date" not in again
    said = _interrupted(logs, _STUDY, "study basis")
    assert "debist: interrupted; no step was finished yet; the same command starts again" in said
    assert "figure:" in _goes_on(*_STUDY)


@pytest.mark.long
def test_a_batch_counts_what_is_done(logs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(logs)
    fleet = logs / "fleet"
    fleet.mkdir()
    for name in ("a", "b", "c"):
        text = TOML.replace('"P"', f'"{name}"').replace("train.csv", "../train.csv")
        (fleet / f"{name}.toml").write_text(text.replace("validation.csv", "../validation.csv"))
    said = _interrupted(logs, ("batch", "fleet", "-o", "runs", "--no-report"), "[1/3]")
    assert "debist: interrupted; 1 of 3 prototypes are done; the same command goes on with the rest" in said
    assert "a: up to date" in _goes_on("batch", "fleet", "-o", "runs", "--no-report")


@pytest.mark.long
@pytest.mark.parametrize("seconds", [2.0, 3.0, 4.0])
def test_a_batch_is_stopped_while_its_processes_begin(logs: Path, seconds: float, tmp_path: Path) -> None:
    program = [sys.executable, "-c", _HEEDING, "batch", str(logs / "P.toml"), "-o", str(tmp_path / "runs")]
    with subprocess.Popen(program, stderr=subprocess.PIPE, text=True, start_new_session=True) as process:
        time.sleep(seconds)
        os.killpg(process.pid, signal.SIGINT)
        errors = process.communicate()[1]
    assert [line.partition(";")[0] for line in errors.splitlines()] == ["debist: interrupted"]


@pytest.mark.long
def test_a_demo_goes_on(tmp_path: Path) -> None:
    said = _interrupted(tmp_path, ("demo", "-o", "demo"), "validation log: done")
    assert _KEPT in said
    status = _goes_on("status", str(tmp_path / "demo"), "--brief")
    assert "stale" in status
