"""`debist check` and the first step of `debist run`: a mistake stops with exit code 3, by name, before any fit."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from tests.diagnostics.first_hour import TOML, write_logs

RUNNER = CliRunner()
pytestmark = pytest.mark.usefixtures("read_once")


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("logs")
    write_logs(folder)
    return folder


def _settings(logs: Path, name: str, *changes: tuple[str, str]) -> Path:
    text = TOML
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = logs / name
    path.write_text(text)
    return path


MISTAKES = {
    "v1 and v2 swapped": (
        [('channel = "v1"', 'channel = "_"'), ('channel = "v2"', 'channel = "v1"'), ('"_"', '"v2"')],
        "sides",
    ),
    "time in ms": ([('{ channel = "time", unit = "s" }', '{ channel = "time", unit = "min" }')], "rate"),
}


@pytest.mark.parametrize(("changes", "gate"), MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_stops_before_the_fit_and_names_what_would_accept_it(logs, tmp_path, changes, gate) -> None:
    settings = _settings(logs, f"{gate}.toml", *changes)
    for arguments in (["check", str(settings)], ["run", str(settings), "-o", str(tmp_path / "run")]):
        result = RUNNER.invoke(app, [*arguments, "-q"])
        assert result.exit_code == 3, result.output
        (line,) = [line for line in result.stderr.splitlines() if line.startswith("debist: ")]
        assert f'[quality] accept = ["{gate}"]' in line
    assert not list((tmp_path / "run").rglob("model.h5"))


def test_an_honest_prototype_passes_and_the_numbers_are_json(logs: Path) -> None:
    result = RUNNER.invoke(app, ["check", str(logs / "P.toml"), "-q", "--json"])
    assert result.exit_code == 0, result.output
    rows = json.loads(result.stdout)["rows"]
    assert {row["log"] for row in rows} == {"training log", "validation log"}
    assert not [row for row in rows if row["state"] == "wrong"]
    assert {"direction of v1", "noise of v2", "residual of the fit", "rests"} <= {row["what"] for row in rows}
    values = {row["what"]: row["values"] for row in rows if row["log"] == "training log"}
    assert list(values["rests"]) == ["left_m", "right_m"]
    assert values["range of v1"]["range_V"] == pytest.approx(3000.0, rel=0.2)


def test_what_is_accepted_by_name_runs_and_is_shown_in_the_report(logs: Path, tmp_path: Path) -> None:
    """A device that is wired the other way round says so in its settings."""
    changes, _ = MISTAKES["v1 and v2 swapped"]
    settings = _settings(logs, "accepted.toml", *changes, ("[identify]", '[quality]\naccept = ["sides"]\n[identify]'))
    run = tmp_path / "run"
    result = RUNNER.invoke(app, ["run", str(settings), "-o", str(run), "-q"])
    assert result.exit_code == 0, result.output
    assert "(accepted: sides)" in result.stderr
    page = (run / "report.html").read_text()
    assert "Logs against settings" in page and "(accepted: sides)" in page
    again = RUNNER.invoke(app, ["check", str(run)])
    assert again.exit_code == 0 and "(!)" in again.stdout
