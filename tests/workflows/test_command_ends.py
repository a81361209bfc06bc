"""The last lines of commands: what a stage came to, in words and as JSON; a failure as JSON too."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.commands.console import Progress
from pipeline.runs.engine import Task
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


def test_stages_end_with_what_they_found(small: Path) -> None:
    lines = _lines("ingest", small.parent / "small.toml", "-o", small)
    assert lines[0] == "training log: 1000 rows every 10.0 ms; 0 gaps"
    lines = _lines("differentiate", small)
    assert lines[0].startswith("training log: tvregdiff, α = ") and lines[0].endswith(" mm")
    lines = _lines("identify", small)
    assert lines[0].startswith("rbf-paper: identified in ") and lines[0].endswith("the headline")
    (result,) = json.loads("\n".join(_lines("identify", small, "--json")))["results"]
    assert result["model"] == "rbf-paper" and result["headline"] is True


def test_studies_end_with_a_conclusion(small: Path) -> None:
    alpha = "\n".join(_lines("study", "alpha", small))
    assert "by the noise of train/train, alpha is " in alpha and "mm·s^3, without reweighting" in alpha
    online = _lines("study", "online", small)
    assert len(online) < 20
    assert any(line.startswith("without drift, λ = 1 follows the curve best: ") for line in online)


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
