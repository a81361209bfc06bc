"""A run folder belongs to a prototype; what is wrong is known before any work; an edit is told by every command."""

import json
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from tests.faults.small_run import write_prototype

RUNNER = CliRunner()
pytestmark = pytest.mark.usefixtures("read_once")


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A settings file and its run up to the scores."""
    folder = tmp_path_factory.mktemp("small")
    prototype = write_prototype(folder)
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(folder / "run"), "--no-report", "-q"])
    assert result.exit_code == 0, result.output
    return prototype, folder / "run"


@pytest.fixture
def copy(small: tuple[Path, Path], tmp_path: Path) -> tuple[Path, Path]:
    """A copy of both that a test may edit; the run is known to be made from the copy."""
    folder = tmp_path / "copy"
    shutil.copytree(small[0].parent, folder)
    prototype, run = folder / small[0].name, folder / small[1].name
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(run), "--no-report", "-q"])
    assert "everything is up to date" in result.stdout, result.output
    return prototype, run


def _edit(prototype: Path, old: str, new: str) -> None:
    text = prototype.read_text()
    assert old in text
    prototype.write_text(text.replace(old, new))


def test_another_prototypes_folder_is_refused(copy: tuple[Path, Path]) -> None:
    prototype, run = copy
    before = {path: path.read_bytes() for path in run.rglob("*") if path.is_file()}
    _edit(prototype, 'name = "small"', 'name = "other"')
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(run)])
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert "holds the run of the prototype 'small', not of 'other'" in line and "--replace" in line
    assert {path: path.read_bytes() for path in run.rglob("*") if path.is_file()} == before
    assert RUNNER.invoke(app, ["run", str(prototype), "-o", str(run), "--replace", "--no-report"]).exit_code == 0


@pytest.mark.parametrize("plan", [[], ["--dry-run"]])
def test_a_file_in_place_of_the_run_folder_is_refused_by_the_plan_too(tmp_path: Path, plan: list[str]) -> None:
    prototype = write_prototype(tmp_path)
    (tmp_path / "FILE").write_text("mine")
    for place in (tmp_path / "FILE", tmp_path / "FILE" / "sub"):
        result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(place), *plan])
        assert result.exit_code == 2 and f"{place}: is no folder" in result.output, result.output
    result = RUNNER.invoke(app, ["demo", "-o", str(tmp_path / "FILE")])
    assert result.exit_code == 2 and "is no folder" in result.output and not (tmp_path / "FILE-rig").exists()
    assert (tmp_path / "FILE").read_text() == "mine"


def test_status_and_dry_run_say_what_an_edit_would_redo(copy: tuple[Path, Path]) -> None:
    prototype, run = copy
    prototype.write_text(prototype.read_text() + "[differentiate]\norder = 2\n")
    told = []
    for command in (["status", str(run)], ["run", str(prototype), "-o", str(run), "--dry-run"]):
        result = RUNNER.invoke(app, [*command, "--json"])
        assert result.exit_code == 0, result.output
        told.append(json.loads(result.stdout)["tasks"])
    assert told[0] == told[1]
    stale = {task["stage"]: task["reasons"] for task in told[0] if not task["up_to_date"]}
    assert "ingest" not in stale and "check" not in stale
    assert stale["differentiate"] == ["setting differentiate.order changed from 3 to 2"]
    result = RUNNER.invoke(app, ["identify", str(run)])
    assert "was edited since (setting differentiate.order changed from 3 to 2)" in result.stderr


def test_all_missing_logs_are_told_before_any_work(copy: tuple[Path, Path], tmp_path: Path) -> None:
    prototype, _ = copy
    _edit(prototype, '"train.csv"', '"train.csv", "second.csv"')
    _edit(prototype, '"validation.csv"', '"third.csv"')
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(tmp_path / "new")])
    assert result.exit_code == 2 and not (tmp_path / "new").exists()
    head, *lines = result.stderr.splitlines()
    assert head == "debist: logs: 2 mistakes"
    assert ["second.csv" in lines[0], "third.csv" in lines[1]] == [True, True]


@pytest.mark.parametrize("how", ["path", "link", "copy", "other format"])
def test_the_training_log_validates_nothing_under_another_name(copy: tuple[Path, Path], how: str) -> None:
    prototype, _ = copy
    log, other = prototype.parent / "train.csv", prototype.parent / "again.csv"
    if how == "path":
        _edit(prototype, '"validation.csv"', '"../copy/train.csv"')
    else:
        _edit(prototype, '"validation.csv"', '"again.csv"')
        if how == "link":
            other.symlink_to(log)
        elif how == "copy":
            shutil.copy(log, other)
        else:
            other.write_text(log.read_text().replace(",", ";"))
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(prototype.parent / "new"), "-q"])
    assert result.exit_code == 2, result.output
    assert "the training log 'train.csv'" in result.stderr


def test_names_of_any_script_work_end_to_end(small: tuple[Path, Path], tmp_path: Path) -> None:
    folder = tmp_path / "Prüfstand (neu)"
    folder.mkdir()
    for log, name in (("train.csv", "Training α (1).csv"), ("validation.csv", "Prüflauf [2].csv")):
        shutil.copy(small[0].parent / log, folder / name)
    prototype = folder / "Prüfling 1.toml"
    text = small[0].read_text().replace('"small"', '"Prüfling 1"').replace("train.csv", "Training α (1).csv")
    prototype.write_text(text.replace("validation.csv", "Prüflauf [2].csv"), encoding="utf-8")
    result = RUNNER.invoke(app, ["batch", str(folder), "-o", str(tmp_path / "runs"), "--jobs", "1"])
    assert result.exit_code == 0, result.output
    run = tmp_path / "runs" / "Pruefling-1"
    assert (run / "train" / "Training-alpha-1" / "kinematics.parquet").is_file()
    assert (run / "validation" / "Prueflauf-2" / "kinematics.parquet").is_file()
    page = (run / "report.html").read_text(encoding="utf-8")
    assert "<h1>Prüfling 1</h1>" in page and "Training α (1)" in page and "Prüflauf [2]" in page
    shown = RUNNER.invoke(app, ["validate", str(run), "-q"]).stdout
    assert "Prüflauf [2]" in shown and "Prueflauf-2" not in shown
    shown = RUNNER.invoke(app, ["validate", str(run), "-q", "--details"]).stdout
    assert "Training α (1)" in shown and "Training-alpha-1" not in shown
