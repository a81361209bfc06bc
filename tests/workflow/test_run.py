"""The whole run on the demo's raw logs: recovered truth, reruns, corruption found, JSON as in the contract."""

import json
import shutil
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from matplotlib import pyplot
from typer.testing import CliRunner

from cli import app
from pipeline.api.run import open_run
from pipeline.errors import InputError
from pipeline.models.model_type import model_from_tree
from pipeline.models.paper.model import RbfPaperModel
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.run import run_status
from tests.double_well import DoubleWell
from tests.workflow.double_well_logs import write_logs

RUNNER = CliRunner()
pytestmark = pytest.mark.usefixtures("read_once")

# The default model and the baselines have tests of their own; here the chain counts, not the last digit.
_QUICK = '\n[identify]\nmodels = ["rbf-paper"]\n[compare]\nmodels = ["sindy"]\n'


@pytest.fixture(scope="module")
def demo(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The settings file of a double well and its run, all but the report."""
    folder = tmp_path_factory.mktemp("demo")
    prototype = write_logs(folder / "rig")
    prototype.write_text(prototype.read_text() + _QUICK)
    result = RUNNER.invoke(app, ["run", str(prototype), "-o", str(folder / "run"), "--no-report", "--json"])
    assert result.exit_code == 0, result.output
    scores = json.loads(result.stdout)["scores"]
    assert {score["model"] for score in scores} == {"rbf-paper", "sindy"}
    return prototype, folder / "run"


@pytest.fixture
def copy(demo: tuple[Path, Path], tmp_path: Path) -> tuple[Path, Path]:
    """A copy of the run that a test may spoil."""
    shutil.copytree(demo[1], tmp_path / "run")
    return demo[0], tmp_path / "run"


def test_the_planted_curves_are_recovered(demo: tuple[Path, Path]) -> None:
    """Between the wells: force within 6 % of its largest value (RMS; narrow bells ripple), gains and damping 10 %."""
    model = model_from_tree("rbf-paper", RunFolder.open(demo[1]).read_tree("model.h5", "rbf-paper"))
    assert isinstance(model, RbfPaperModel)
    truth = DoubleWell()
    q = np.linspace(-truth.left_well, truth.right_well, 45)
    planted, found = truth.curves(q), model.curves(q)
    force = planted["c"] * q
    assert np.sqrt(np.mean((found["F"] - force) ** 2)) < 0.06 * np.max(np.abs(force))
    assert np.max(np.abs(found["d"] - planted["d"])) < 0.10 * np.max(planted["d"])
    for k in (1, 2):
        gain = planted[f"g{k}"]
        assert np.max(np.abs(found[f"dC{k}_dq"] / 2 - gain)) < 0.10 * np.max(np.abs(gain))


def test_the_signals_are_the_truth_in_si(demo: tuple[Path, Path]) -> None:
    table = pq.read_table(demo[1] / "train" / "train" / "signals.parquet").to_pydict()
    t, q, v1 = (np.array(table[name]) for name in ("t", "q", "v1"))
    assert np.allclose(np.diff(t), 0.01)
    assert 0.010 < np.nanmax(np.abs(q)) < 0.026
    assert 2900.0 < v1.max() < 3100.0


def test_a_second_run_changes_nothing(demo: tuple[Path, Path]) -> None:
    files = {path: path.read_bytes() for path in sorted(demo[1].rglob("*")) if path.is_file()}
    result = RUNNER.invoke(app, ["run", str(demo[0]), "-o", str(demo[1]), "--no-report"])
    assert "everything is up to date" in result.stdout
    assert files == {path: path.read_bytes() for path in sorted(demo[1].rglob("*")) if path.is_file()}
    assert all(task.up_to_date for task in run_status(demo[1]) if task.stage != "report")


def test_changed_settings_reach_the_later_stages(copy: tuple[Path, Path], tmp_path: Path) -> None:
    """Even where the stage that reads the settings file has nothing to do. Results of before the change are named."""
    prototype, run = copy
    shutil.copytree(prototype.parent, tmp_path / "rig")
    changed = tmp_path / "rig" / prototype.name
    changed.write_text(changed.read_text() + "[differentiate]\norder = 2\n")
    assert "up to date" in RUNNER.invoke(app, ["ingest", str(changed), "-o", str(run)]).stdout
    result = RUNNER.invoke(app, ["differentiate", str(run)])
    assert "setting differentiate.order changed from 3 to 2" in result.stderr
    assert "warning" not in result.stderr
    with pytest.warns(UserWarning, match=r"some results are older than train/.*/kinematics.parquet") as warned:
        open_run(run).scores()
    assert warned[0].filename == __file__
    told = RUNNER.invoke(app, ["diff", str(run), str(run)]).stderr.splitlines()
    assert len(told) == 1
    assert told[0].startswith(f"warning: {run}: some results are older than train/")


def test_scores_are_as_the_contract_says(demo: tuple[Path, Path]) -> None:
    table = pq.read_table(demo[1] / "scores.parquet")
    contract = {"log", "role", "model", "signal", "nrmse", "rmse", "unit", "n", "status", "diverged_at_s"}
    assert contract | {"well_agreement", "switch_accuracy"} <= set(table.column_names)
    rows = table.to_pylist()
    assert {(row["role"], row["log"]) for row in rows} == {("train", "train"), ("validation", "validation")}
    assert all((row["well_agreement"] is not None) == (row["signal"] == "q") for row in rows)
    assert all(row["nrmse"] is None or 0.0 < row["nrmse"] < 1.0 for row in rows)
    for row in (row for row in rows if row["signal"] == "q"):
        assert row["nrmse_one_step"] < min(row["nrmse_100ms"], row["nrmse_1s"])
        assert row["nrmse_low"] <= row["nrmse"] <= row["nrmse_high"]


def test_a_figure_is_drawn_as_a_whole_or_as_a_segment(demo: tuple[Path, Path]) -> None:
    run = open_run(demo[1])
    name = "validation-validation-models"
    assert run.figures[name] == "Measured against models, validation log"
    whole, part = (run.plot(name, **segment)[0] for segment in ({}, {"start": 2.0, "stop": 3.0}))
    low, high = whole.get_xlim()
    assert low < 2.0 < 3.0 < high and part.get_xlim() == pytest.approx((2.0, 3.0), abs=0.011)
    for arguments, message in (
        ({"figure": "validation-validation-model"}, f"did you mean {name!r}"),
        ({"figure": name, "models": ["narx"]}, "has no model 'narx'; it has rbf-paper"),
        ({"figure": name, "start": 3.0, "stop": 2.0}, "start 3 is not below stop 2"),
        ({"figure": name, "start": 1e4}, "choose a segment inside"),
    ):
        with pytest.raises(InputError, match=message):
            run.plot(**arguments)
    pyplot.close("all")


def test_the_stages_one_by_one_come_to_the_same(demo: tuple[Path, Path], tmp_path: Path) -> None:
    prototype, whole = demo
    run = tmp_path / "run"
    for command in (
        ["ingest", str(prototype), "-o", str(run)],
        *([stage, str(run)] for stage in ("differentiate", "identify", "validate")),
    ):
        result = RUNNER.invoke(app, command)
        assert result.exit_code == 0, result.output
    made = RunFolder.open(run).manifest.artifacts
    reference = RunFolder.open(whole).manifest.artifacts
    for name in ("model.h5", "validation/validation/predictions/rbf-paper.parquet"):
        assert made[name].content_hash == reference[name].content_hash


@pytest.mark.parametrize("study", ["alpha", "basis", "data"])
def test_a_study_is_a_table_and_a_figure(copy: tuple[Path, Path], study: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from pipeline.workflow.studies import study as stage

    monkeypatch.setattr(stage, "ALPHAS", (1e-9, 1e-6, 1e-3))
    monkeypatch.setattr(stage, "BASIS_FUNCTIONS", (6, 10))
    monkeypatch.setattr(stage, "REPEATS", 1)
    result = RUNNER.invoke(app, ["study", study, str(copy[1]), "--json"])
    assert result.exit_code == 0, result.output
    columns = {name: np.array(values) for name, values in json.loads(result.stdout)["columns"].items()}
    assert (copy[1] / "studies" / f"{study}.svg").read_text().startswith("<?xml")
    if study == "alpha":  # more regularisation: further from the record, and smoother
        np.testing.assert_allclose(columns["alpha_mm_s3"], stage.ALPHAS)  # as the settings take it
        assert np.all(np.diff(columns["misfit_m"]) > 0.0)
        assert np.all(np.diff(columns["roughness_m_per_s2"]) < 0.0)
    elif study == "basis":  # more functions of one width over distance fit the training data better
        assert np.all(
            columns["mse_m_per_s2_squared"][columns["basis_functions"] == 10]
            < columns["mse_m_per_s2_squared"][columns["basis_functions"] == 6]
        )
    else:
        assert np.all(columns["nrmse_low"] <= columns["nrmse"])
        assert np.all(columns["nrmse"] <= 1.0)
    again = RUNNER.invoke(app, ["study", study, str(copy[1])])
    assert f"Study of {study}" in again.stdout and "first time" not in again.stderr
    assert RUNNER.invoke(app, ["verify", str(copy[1])]).exit_code == 0
