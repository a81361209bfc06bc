"""Mistakes of every kind in one settings file are told at once: keys, units, logs that are not there."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import SeveralMistakesError
from pipeline.workflow.place import load_settings

_WRONG = """
name = "P"
[logs]
train = ["missing.mat"]
validation = ["lost.csv"]
[channels]
q = { channel = "a", unit = "Kelvin" }
v1 = { channel = "b", unit = "kV", scle = 3 }
v2 = { channel = "c", unit = "mm" }
[plnt]
mass = { value = 1.0, unit = "g" }
"""
_KEYS = ["channels.v1.scle", "plnt"]
_UNITS = ["channels.q.unit", "channels.v2.unit"]
_LOGS = ["missing.mat", "lost.csv"]


@pytest.mark.parametrize(
    ("mended", "told"),
    [({}, _KEYS + _UNITS + _LOGS), ({", scle = 3": "", "plnt": "plant"}, _UNITS + _LOGS)],
    ids=["keys, units and logs", "units and logs"],
)
def test_all_mistakes_are_told_at_once(tmp_path: Path, mended: dict[str, str], told: list[str]) -> None:
    text = _WRONG
    for wrong, right in mended.items():
        text = text.replace(wrong, right)
    settings = tmp_path / "P.toml"
    settings.write_text(text)
    with pytest.raises(SeveralMistakesError) as caught:
        load_settings(settings)
    assert caught.value.lines[0] == f"{settings}: {len(told)} mistakes"
    assert all(key in line for key, line in zip(told, caught.value.lines[1:], strict=True))
    for command in (
        ["run", str(settings)],
        ["run", str(settings), "-o", str(tmp_path / "run")],
        ["check", str(settings)],
    ):
        said = CliRunner().invoke(app, command)
        assert said.exit_code == 2 and all(key in said.stderr for key in told)
    assert not (tmp_path / "run").exists()
