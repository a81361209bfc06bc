"""The command as its users meet it: help, JSON, errors as one line with the right exit code."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.commands.console import printable
from pipeline.store import layout
from pipeline.store.schemas import STUDIES
from pipeline.workflow.run_contents import TITLES
from tests.prototypes import SMALL_CSV

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


@pytest.mark.parametrize(
    "artifact",
    [
        *(layout.control(title) for title in TITLES),
        *(layout.study(name) for name in STUDIES),
        layout.PAPER,
        layout.paper_figure("fig-9", "svg"),
    ],
)
def test_what_no_stage_makes_names_a_command_that_there_is(artifact: str) -> None:
    command = layout.remade(artifact).split("`")[1]
    assert CliRunner().invoke(app, [*command.removeprefix("debist ").split(), "--help"]).exit_code == 0


def test_a_table_of_a_study_that_is_gone_is_no_longer_made() -> None:
    assert layout.remade("studies/folds-log.parquet") == "it is no longer made"
    assert layout.remade(layout.MODELS) == layout.remade("figures/train-train-models.svg") == ""


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


def test_a_plan_imports_neither_compiler_nor_scipy() -> None:
    code = "import sys, pipeline.workflow.run; print(*sys.modules)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {"scipy", "numba", "casadi", "pysindy", "matplotlib"}.isdisjoint(modules)


def _prototype(folder: Path, text: str) -> Path:
    path = folder / "P.toml"
    path.write_text(text, encoding="utf-8")
    return path


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
