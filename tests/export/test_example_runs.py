"""Every form of every model of the example runs against the run's own model; the last device has one input."""

import json
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from fmpy.validation import validate_fmu
from scipy.io import loadmat
from typer.testing import CliRunner

from cli import app
from pipeline.export.sources import write_json, write_matlab
from pipeline.export.subject import Subject
from pipeline.settings.prototype import parse_prototype
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.run_contents import subject
from tests.export.fmu_runs import co_simulated, exchanged
from tests.export.joints import COMPILER, OCTAVE, CompiledModel, half_steps

EXAMPLES = Path(__file__).resolve().parents[2] / "benchmarks" / "prototypes"
RUNS = {"P1": "", "P2": "", "P3": "", "P3 from data alone": 'parameters = "nominal"', "quarter-drone": ""}
"""Example, and the line of its settings that is left out."""
MODELS = (None, "rbf-paper", "sindy")
TOLERANCE = 1e-6
SECONDS = 0.5  # Octave interprets: slower than the device
STEPS = 20_000  # driven from Python one by one

pytestmark = [pytest.mark.long, pytest.mark.skipif(COMPILER is None, reason="no C compiler here")]


@pytest.fixture(scope="module", params=RUNS)
def run(request: pytest.FixtureRequest, shared_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> RunFolder:
    """An example, run as its settings say, with SINDy as the only baseline."""
    folder = tmp_path_factory.mktemp("example")
    text = (EXAMPLES / f"{request.param.split()[0]}.toml").read_text(encoding="utf-8")
    text = text.replace("../../../shared", str(shared_folder)).replace(RUNS[request.param], "")
    (folder / "example.toml").write_text(f'{text}\n[compare]\nmodels = ["sindy"]\n', encoding="utf-8")
    result = CliRunner().invoke(app, ["run", str(folder / "example.toml"), "-o", str(folder / "run"), "--no-report"])
    assert result.exit_code == 0, result.output
    return RunFolder.open(folder / "run")


@pytest.fixture(params=MODELS)
def what(run: RunFolder, request: pytest.FixtureRequest) -> Subject:
    """A model of the run with the beginning of its validation log."""
    whole = subject(run, parse_prototype(run.manifest.prototype, "run"), request.param)
    interval = whole.validity.sample_interval
    count = round(STEPS * whole.realisation().step / interval)
    return replace(whole, t=whole.t[:count], v=whole.v[:count])


def deviation(found: np.ndarray, what: Subject) -> float:
    """Largest deviation of q from the model's own run, as a share of its range, up to where that run ends."""
    truth = what.model.simulate(what.t, what.v, *what.start).q[: len(found)]
    held = np.isfinite(truth)
    assert held.sum() >= 10
    return float(np.abs(found[: len(truth)] - truth)[held].max() / np.ptp(truth[held]))


def test_compiled_c_runs_like_the_model(what: Subject, tmp_path: Path) -> None:
    assert deviation(CompiledModel(what, tmp_path).free_run(half_steps(what))[:, 0], what) < TOLERANCE


def test_the_fmu_is_valid_and_runs_like_the_model(what: Subject, tmp_path: Path) -> None:
    truth = what.model.simulate(what.t, what.v, *what.start).q
    count = int(np.argmin(np.isfinite(truth))) or len(truth)  # beyond the model's bounds an FMU reports an error
    what = replace(what, t=what.t[: count - 1], v=what.v[: count - 1])
    assert deviation(co_simulated(what, tmp_path)[:, 0], what) < TOLERANCE
    (fmu,) = tmp_path.glob("*.fmu")
    assert validate_fmu(str(fmu)) == []
    functions = what.realisation().functions
    if "flow" not in functions:  # Dahl's friction is a differential equation there, and no longer debist's step
        assert deviation(exchanged(what, tmp_path), what) < TOLERANCE


@pytest.mark.skipif(OCTAVE is None, reason="no GNU Octave here")
def test_the_matlab_function_runs_like_the_model(what: Subject, tmp_path: Path) -> None:
    count = round(SECONDS / what.validity.sample_interval) + 1
    what = replace(what, t=what.t[:count], v=what.v[:count])
    write_matlab(what, tmp_path)
    name = what.identifier
    script = f"load {name}_data.mat; c = check; q = {name}(c.t, c.v, c.q0, c.qdot0); save -v6 found.mat q"
    subprocess.run([OCTAVE, "--norc", "--quiet", "--eval", script], cwd=tmp_path, check=True, capture_output=True)
    assert deviation(loadmat(tmp_path / "found.mat", squeeze_me=True)["q"], what) < TOLERANCE


def test_the_document_carries_the_models_run(what: Subject, tmp_path: Path) -> None:
    held = json.loads(write_json(what, tmp_path).written[0].read_text(encoding="utf-8"), parse_constant=pytest.fail)
    check = held["check"]
    q = what.model.simulate(np.array(check["t_s"]), np.array(check["v"]), check["q0"], check["qdot0"]).q
    np.testing.assert_array_equal(np.array(check["q"], dtype=float), q)


def test_the_crate_of_the_run_is_intact(run: RunFolder, tmp_path: Path) -> None:
    made = CliRunner().invoke(app, ["export", str(run.root), "--to", "crate", "-o", str(tmp_path), "--json"])
    assert made.exit_code == 0, made.output
    (packed,) = json.loads(made.stdout)["written"]
    with zipfile.ZipFile(packed) as archive:
        archive.extractall(tmp_path / "crate")
    assert CliRunner().invoke(app, ["verify", str(tmp_path / "crate/run")]).exit_code == 0
