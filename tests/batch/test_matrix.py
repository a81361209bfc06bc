"""A matrix of settings: every combination, each checked before one runs, with logs where they were."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.settings.prototype import load_prototype
from pipeline.workflow.variants import write_matrix
from tests.prototypes import SMALL, motion, settings, write_csv

RUNNER = CliRunner()


def test_every_combination_is_a_settings_file_with_the_same_logs(tmp_path: Path) -> None:
    (tmp_path / "P.toml").write_text(SMALL)
    sets = ["identify.basis_functions=6,8", "differentiate.alpha=auto,0.01,1e-3"]
    variants = write_matrix(tmp_path / "P.toml", sets, tmp_path / "m")
    assert [variant.name for variant in variants] == [f"P-{number}" for number in range(1, 7)]
    read = [load_prototype(variant.path) for variant in variants]
    assert [(each.identify.basis_functions, each.differentiate.alpha) for each in read] == [
        (6, "auto"), (6, 0.01), (6, 1e-3), (8, "auto"), (8, 0.01), (8, 1e-3),
    ]  # fmt: skip
    assert {each.logs.train for each in read} == {(str(tmp_path / "log.csv"),)}
    assert read[0].channels == load_prototype(tmp_path / "P.toml").channels


@pytest.mark.parametrize(
    ("sets", "said"),
    [
        (["identify.basis_functions"], "write SECTION.KEY=VALUE"),
        (["identify.basis_function=6"], "did you mean"),
        (["identify.basis_functions=6,1"], "basis_functions"),
        (["name.x=1"], "'name' is no section"),
        ([], "at least one --set"),
    ],
)
def test_a_wrong_set_writes_nothing(tmp_path: Path, sets: list[str], said: str) -> None:
    (tmp_path / "P.toml").write_text(SMALL)
    with pytest.raises(InputError, match=r".") as caught:
        write_matrix(tmp_path / "P.toml", sets, tmp_path / "m")
    assert said in "\n".join((str(caught.value), *getattr(caught.value, "lines", ())))
    assert not (tmp_path / "m").exists()


@pytest.mark.long
def test_a_matrix_runs_and_compares(tmp_path: Path) -> None:
    write_csv(tmp_path / "log.csv", *motion(10.0, 200.0, 1, noise=3e-6))
    (tmp_path / "P.toml").write_text(settings())
    arguments = ["batch", str(tmp_path / "P.toml"), "--set", "identify.basis_functions=6,8"]
    done = RUNNER.invoke(app, [*arguments, "-o", str(tmp_path / "m"), "--json"])
    assert done.exit_code == 0, done.stderr
    runs = json.loads(done.stdout)["runs"]
    assert [run["settings"] for run in runs] == [{"identify.basis_functions": count} for count in (6, 8)]
    assert len({run["scores"][0]["nrmse"] for run in runs}) == 2
    table = RUNNER.invoke(app, [*arguments, "-o", str(tmp_path / "m")])
    assert "identify.basis_functions" in table.stdout and "train log rbf-paper" in table.stdout
    different = RUNNER.invoke(app, ["diff", str(tmp_path / "m/P-1"), str(tmp_path / "m/P-2"), "--format", "csv"])
    assert "settings,identify.basis_functions,6,8" in different.stdout.splitlines()
