"""`debist physics`: the JSON that scripts read, the figures, the errors."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from pipeline.commands.physics import app
from pipeline.device.device import JOINT
from pipeline.device.parameters import NOMINAL, TABLE1, joint_parameters
from pipeline.errors import InputError
from pipeline.models.analytical.calibration import Calibration
from pipeline.models.analytical.full_order import rest_state, simulate
from pipeline.models.analytical.reduced_order import pulse_sequence
from pipeline.models.analytical.statics import equilibria
from pipeline.store.schemas import KINEMATICS, schema_of
from pipeline.store.tables import write_pieces
from pipeline.workflow.studies.physics import write_parameters


def answer(*arguments: str) -> dict[str, object]:
    """The JSON document of a command."""
    result = CliRunner().invoke(app, [*arguments, "--json"], catch_exceptions=False)
    assert result.exit_code == 0
    return dict(json.loads(result.stdout))


def test_equilibria_json_has_the_promised_keys() -> None:
    document = answer("equilibria", "--parameters", "table1", "--b", "23mm", "--force", "1 mN")
    found = document["equilibria"]
    assert isinstance(found, list) and [set(e) for e in found] == [{"q_m", "phi_rad", "stable", "energy_J"}] * 3
    expected = equilibria(TABLE1, np.zeros(2), 1e-3)
    assert [e["q_m"] for e in found] == pytest.approx([e.q for e in expected], abs=1e-12)


def test_calibrate_reads_kinematics_and_writes_a_set(tmp_path: Path) -> None:
    truth = NOMINAL.with_values({"E": 1.7e9})
    t, v = pulse_sequence(count=3, dt=0.01)
    run = simulate(truth, t, v, rest_state(truth, equilibria(truth, v[0])[0].q, 0.0, v[0]))
    columns = {"t": t, "q": run.q, "v1": v[:, 0], "v2": v[:, 1], "segment": np.zeros(t.size, np.int32)}
    source, target = tmp_path / "kinematics.parquet", tmp_path / "joint.toml"
    write_pieces(source, schema_of(KINEMATICS, JOINT), [columns | {"qdot": run.qdot, "qddot": run.qddot}])
    document = answer("calibrate", str(source), "--paper", "--jobs", "1", "-o", str(target))
    assert set(document) >= {"parameters", "correlation", "rmse", "at_bound", "converged"}
    assert pytest.approx(1.7e9, rel=0.01) == joint_parameters(str(target)).E


def test_a_calibrated_set_replaces_nothing_of_others(tmp_path: Path) -> None:
    one = np.array([1.7e9])
    fit = Calibration(NOMINAL.with_values({"E": 1.7e9}), ("E",), one, 0.01 * one, one, (), 0.0, True, 1)
    target = tmp_path / "train.mat"
    target.write_bytes(b"a raw log")
    with pytest.raises(InputError, match="remove it"):
        write_parameters(fit, target)
    assert target.read_bytes() == b"a raw log"
    (tmp_path / "P1.toml").write_text('name = "P1"\n[logs]\ntrain = ["train.mat"]\n')
    with pytest.raises(InputError, match=r"train\.mat"):
        write_parameters(fit, target)
    assert target.read_bytes() == b"a raw log"
    own = tmp_path / "joint.toml"
    for _ in range(2):  # its own file is renewed
        write_parameters(fit, own)
    assert joint_parameters(str(own)).E == 1.7e9


def test_a_figure_never_replaces_a_file_of_others(tmp_path: Path) -> None:
    figure = tmp_path / "figure.svg"
    for _ in range(2):  # what the command wrote itself, it writes again
        answer("equilibria", "--figure", str(figure))
    figure.write_text("drawn by hand")
    with pytest.raises(InputError, match=r"figure\.svg: is there already .* name another place, or remove it"):
        answer("equilibria", "--figure", str(figure))
    assert figure.read_text() == "drawn by hand"
