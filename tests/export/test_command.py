"""`debist export`: every form from a run, its bounds those of the training logs, mistakes answered in a line."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from debist import open_run

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


def test_the_bounds_are_those_of_the_training_logs_alone(planted_run, tmp_path):
    RUNNER.invoke(app, ["export", str(planted_run), "--to", "json", "-o", str(tmp_path), "--model", "rbf-paper"])
    held = json.loads((tmp_path / "demo_1_rbf_paper.json").read_text(encoding="utf-8"))
    log = open_run(planted_run).log("a")
    assert held["validity"]["q"] == [log.q_m.min(), log.q_m.max()]
    assert held["validity"]["v"] == [[log.v1_V.min(), log.v1_V.max()], [log.v2_V.min(), log.v2_V.max()]]
    np.testing.assert_array_equal(held["check"]["t_s"], open_run(planted_run).log("b").t_s[:500])
