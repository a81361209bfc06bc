"""`debist control` on a run: files, JSON, and one clear line for what cannot be."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from typer.testing import CliRunner

from cli import app
from pipeline.control.ensemble import ensemble_of
from pipeline.control.switching_map import lowest_voltage
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.studies.controlled_run import ControlSettings, control_run
from tests.export.conftest import hybrid

pytestmark = pytest.mark.usefixtures("without_binaries")


def call(*arguments: object, code: int = 0) -> str:
    done = CliRunner().invoke(app, ["control", *map(str, arguments)])
    assert done.exit_code == code, done.output
    return done.stdout if code == 0 else done.stderr


def test_linear_models_are_written_for_other_tools(planted_run: Path, tmp_path: Path) -> None:
    told = json.loads(call("linearise", planted_run, "-o", tmp_path, "--json", "-q"))
    assert [each["stable"] for each in told["equilibria"]] == [True, False, True]
    matrices = loadmat(tmp_path / "linear.mat", squeeze_me=True)["equilibrium_2"]
    np.testing.assert_allclose(matrices["A"].item(), told["equilibria"][1]["A"])
    assert {path.name for path in tmp_path.glob("linear*")} == {"linear.json", "linear.mat"}
    assert len(told["equilibria"][0]["bode"]["f_Hz"]) == 200
    assert "unstable" in call("linearise", planted_run, "-o", tmp_path, "-q")


def test_a_design_is_kept_exported_and_made_again_only_when_asked_otherwise(planted_run: Path, tmp_path: Path) -> None:
    missing = CliRunner().invoke(app, ["export", str(planted_run), "--to", "controller", "-o", str(tmp_path)])
    if missing.exit_code:
        assert "debist control design" in missing.stderr
    told = json.loads(call("design", planted_run, "--json", "-q"))
    assert max(step["settling_s"] for step in told["predicted"]["steps"]) < 0.3
    assert "was not made" not in CliRunner().invoke(app, ["control", "design", str(planted_run)]).stderr
    refused = CliRunner().invoke(app, ["export", str(planted_run), "--to", "controller", "--model", "hybrid"])
    assert "takes no --model" in refused.stderr
    done = CliRunner().invoke(app, ["export", str(planted_run), "--to", "controller", "-o", str(tmp_path), "--json"])
    names = {Path(name).name for name in json.loads(done.stdout)["written"]}
    assert names == {f"controller.{ending}" for ending in ("h", "c", "m", "fmu")}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("design", "--max-voltage", "9kV"), "outside the trained range"),
        (("design", "--max-voltage", "2"), "no unit"),
        (("design", "--max-voltage", "300 V"), "not even by swinging it up"),
        (("design", "--lag", "1s"), "time constant"),
        (("design", "--slew", "100kV"), "--slew"),
        (("design", "--average-voltage", "0V"), "--average-voltage 0V: give a value above 0"),
        (("pulse", "--to", "left", "--from", "left"), "there already"),
        (("linearise", "--v1", "20kV"), "outside the trained range"),
    ],
)
def test_what_cannot_be_is_one_line(planted_run: Path, arguments: tuple[str, ...], said: str) -> None:
    command, *options = arguments
    told = call(command, planted_run, "-q", *options, code=2)
    assert said in told
    assert told.count("\n") == 1


def test_no_voltage_of_control_is_above_what_the_film_stands(planted_run: Path, tmp_path: Path) -> None:
    shutil.copytree(planted_run, tmp_path / "run")
    settings = RunFolder.open(planted_run).manifest.prototype
    settings["plant"]["film_thickness"] = {"value": 40.0, "unit": "µm"}
    root = RunFolder.create(tmp_path / "run", settings, tmp_path / "P.toml").root
    assert json.loads(call("design", root, "--json", "-q"))["largest_voltage_V"] == pytest.approx(2400.0)
    for command in (("design", "--max-voltage", "2.9kV"), ("linearise", "--v2", "2.9kV")):
        assert "above the 2400 V that the film stands" in call(command[0], root, "-q", *command[1:], code=2)
    limited = control_run(root).converters(ControlSettings(lag=3e-3))[0]
    assert ensemble_of(hybrid(), 0, limited).highest == pytest.approx(2400.0)
    assert lowest_voltage(hybrid(), replace(limited, highest=300.0), (-0.011, 0.0, 0.011), "right", 0.5) is None
