"""The examples of the three rigs run on a fresh clone: the command in their heading writes their logs."""

import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.long
@pytest.mark.parametrize("name", ["controldesk", "mdf", "german-csv"])
def test_its_logs_are_written_and_are_what_it_says(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "examples").mkdir()
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    (tmp_path / "examples" / f"{name}.toml").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (line,) = [line for line in text.splitlines() if line.startswith("# debist ")]
    result = CliRunner().invoke(app, shlex.split(line.removeprefix("# debist ")))
    assert result.exit_code == 0, result.output
    result = CliRunner().invoke(app, ["check", f"examples/{name}.toml", "-q"])
    assert result.exit_code == 0, result.output
    assert "no contradiction" in result.stdout
