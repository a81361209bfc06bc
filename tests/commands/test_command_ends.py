"""The last lines of commands: what a stage came to, in words and as JSON; a failure as JSON too."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.commands.console import Progress
from pipeline.workflow.engine import Task
from tests.faults.small_run import write_prototype

RUNNER = CliRunner()


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("ends")
    _lines("ingest", write_prototype(folder), "-o", folder / "run")
    return folder / "run"


def _lines(*arguments: object) -> list[str]:
    result = RUNNER.invoke(app, [*map(str, arguments), "-q"])
    assert result.exit_code == 0, result.output
    return result.stdout.splitlines()


@pytest.mark.parametrize(
    ("arguments", "text", "code"),
    [
        (("differentiate", "nowhere"), "no run here", 2),
        (("ingest", "nowhere.toml"), "no such file", 2),
        (("identify", "nowhere", "--surely"), "No such option: --surely", 2),
    ],
)
def test_a_failure_is_json_where_json_was_asked_for(arguments: tuple[str, ...], text: str, code: int) -> None:
    result = RUNNER.invoke(app, [*arguments, "--json"])
    error = json.loads(result.stdout)["error"]
    assert text in error["message"] and error["exit_code"] == result.exit_code == code
    assert text in result.stderr
    assert not RUNNER.invoke(app, arguments).stdout


def test_long_tasks_show_progress_without_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    task = Task("control", "map", "1", {}, (), ("x",), dict)
    with Progress() as progress:
        progress.started(task, ["first time"])
        for share in (0.0, 0.1, 0.3, 0.4, 0.8):
            progress.progressed(task, "map to the right", share)
    lines = capsys.readouterr().err.splitlines()
    assert lines[1:] == ["control map: map to the right, 30 %", "control map: map to the right, 80 %"]
