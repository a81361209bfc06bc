"""The command as its users meet it: help, JSON, errors as one line with the right exit code."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.batch.worker import Outcome
from pipeline.commands.console import printable, progress_report, working
from pipeline.commands.outcome import BatchProgress
from pipeline.loading.run_models import TITLES
from pipeline.runs import layout
from pipeline.runs.schemas import STUDIES
from tests.prototypes import SMALL, SMALL_CSV

RUNNER = CliRunner()


def _commands() -> list[list[str]]:
    from typer.main import get_command

    def walk(group: object, path: list[str]) -> list[list[str]]:
        found = []
        for name, command in getattr(group, "commands", {}).items():
            found += walk(command, [*path, name]) if hasattr(command, "commands") else [[*path, name]]
        return found

    return walk(get_command(app), [])


@pytest.mark.parametrize("command", _commands(), ids=" ".join)
def test_every_command_has_help_with_an_example_and_json(command: list[str]) -> None:
    shown = RUNNER.invoke(app, [*command, "--help"]).output
    assert "Example: debist" in " ".join(shown.split())
    assert "--json" in shown


@pytest.mark.parametrize("command", [c for c in _commands() if c[0] in ("batch", "rig", "study")], ids=" ".join)
def test_what_simulates_or_fits_many_can_be_quiet(command: list[str]) -> None:
    assert "-q " in RUNNER.invoke(app, [*command, "--help"]).output


def test_nothing_is_told_of_progress_where_a_terminal_is_to_be_quiet(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with working("simulating", quiet=True), progress_report("designing", quiet=True) as report:
        assert report is None
    with BatchProgress(1, quiet=True) as progress:
        progress.started("a")
        progress.finished(Outcome("a", Path("a.toml"), 1, "no q"))
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    "artifact",
    [
        *(layout.control(title) for title in TITLES),
        *(layout.study(name) for name in STUDIES),
        layout.folds("rbf"),
        layout.PAPER,
        layout.paper_figure("fig-9", "svg"),
    ],
)
def test_what_no_stage_makes_names_a_command_that_there_is(artifact: str) -> None:
    command = layout.command_of(artifact)
    assert command and CliRunner().invoke(app, [*command.split(), "--help"]).exit_code == 0


def test_what_stages_make_names_none() -> None:
    made = (
        layout.MODELS,
        layout.SCORES,
        layout.REPORT,
        layout.CHECK,
        layout.record("train", "a"),
        layout.baseline("x"),
    )
    assert not any(map(layout.command_of, made))


def test_help_imports_nothing_heavy() -> None:
    code = "import sys, cli; from typer.main import get_command; get_command(cli.app); print(*sys.modules)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    heavy = {
        "numpy",
        "scipy",
        "pandas",
        "pyarrow",
        "h5py",
        "numba",
        "casadi",
        "pysindy",
        "matplotlib",
        "pint",
        "pydantic",
    }
    assert heavy.isdisjoint(modules)


def _prototype(folder: Path, text: str) -> Path:
    path = folder / "P.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_mistyped_command_is_answered_with_the_right_one() -> None:
    result = RUNNER.invoke(app, ["inspct", "x"])
    assert result.exit_code == 2
    assert "inspect" in result.stderr


def test_a_folder_without_a_run_is_said_so_and_left_alone(tmp_path: Path) -> None:
    for command in ("status", "verify", "differentiate", "identify", "validate", "compare"):
        result = RUNNER.invoke(app, [command, str(tmp_path)])
        assert (result.exit_code, "no run here" in result.stderr) == (2, True), command
    assert list(tmp_path.iterdir()) == []


def test_nothing_from_a_file_reaches_the_terminal_raw() -> None:
    assert printable("a\x1b[31mb\n\u202ec") == "a\\x1b[31mb\\n\\u202ec"


def test_inspect_prints_one_json_document(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text(SMALL_CSV, encoding="utf-8")
    result = RUNNER.invoke(app, ["inspect", str(tmp_path / "log.csv"), "--json"])
    document = json.loads(result.stdout)
    assert [channel["name"] for channel in document["channels"]] == ["time", "q", "u"]
    assert document["time_bases"][0]["step_s"] == pytest.approx(0.01)


def test_version() -> None:
    from pipeline import __version__

    assert RUNNER.invoke(app, ["--version"]).output.strip() == f"debist {__version__}"


def test_a_displacement_of_kilometres_is_remarked_on(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text(SMALL_CSV, encoding="utf-8")
    path = _prototype(tmp_path, SMALL.replace('unit = "mm"', 'unit = "km"'))
    result = RUNNER.invoke(app, ["ingest", str(path), "-o", str(tmp_path / "run"), "-q"])
    assert result.exit_code == 0
    assert "looks 1000× too large" in result.stderr


def test_python_runs_the_module_as_the_command():
    shown = subprocess.run([sys.executable, "-m", "debist", "--version"], capture_output=True, text=True, check=True)
    assert shown.stdout.startswith("debist ")
