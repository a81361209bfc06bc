"""Every mistake is told, and stops before the work is done."""

import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from tests.diagnostics.first_hour import MISTAKES, RUN, Mistake, write_logs

RUNNER = CliRunner()
pytestmark = pytest.mark.usefixtures("read_once")


@pytest.fixture(scope="module")
def before(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which nothing is wrong yet, with a finished run."""
    folder = tmp_path_factory.mktemp("before")
    write_logs(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        result = RUNNER.invoke(app, RUN)
    assert result.exit_code == 0, result.output
    return folder


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda mistake: mistake.done)
def test_it_is_told(mistake: Mistake, before: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "first-hour"
    shutil.copytree(before, folder)
    monkeypatch.chdir(folder)
    if mistake.arguments[0] == "status":  # a run knows its settings file by its path
        assert RUNNER.invoke(app, RUN).exit_code == 0
    mistake.make(folder)
    monkeypatch.setenv("COLUMNS", "200")
    result = RUNNER.invoke(app, mistake.arguments)
    assert result.exit_code == mistake.code, result.output
    assert mistake.said in result.output
    assert not list(folder.glob("new/**/model.h5"))
