"""`debist export`: every form from a run, its bounds those of the training logs, mistakes answered in a line."""

import json

import pytest
from typer.testing import CliRunner

from cli import app

RUNNER = CliRunner()


@pytest.mark.parametrize(
    ("target", "files"),
    [
        ("c", ["demo_1_hybrid.h", "demo_1_hybrid.c"]),
        ("fmu", ["demo_1_hybrid.fmu"]),
        ("json", ["demo_1_hybrid.json"]),
        ("matlab", ["demo_1_hybrid.m", "demo_1_hybrid_data.mat"]),
    ],
)
def test_each_form_is_written_and_named(target, files, planted_run, tmp_path):
    result = RUNNER.invoke(app, ["export", str(planted_run), "--to", target, "-o", str(tmp_path), "--json"])
    assert result.exit_code == 0, result.output
    assert json.loads(result.stdout)["written"] == [str(tmp_path / name) for name in files]
    assert sorted(path.name for path in tmp_path.iterdir() if path.name[0] != ".") == sorted(files)
