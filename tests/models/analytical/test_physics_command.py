"""`debist physics`: the JSON that scripts read, the figures, the errors."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from pipeline.commands.physics import app
from pipeline.device.parameter_sets import joint_parameters
from pipeline.device.parameters import NOMINAL, TABLE1
from pipeline.errors import InputError
from pipeline.models.analytical.calibration import Calibration
from pipeline.models.analytical.full_order import rest_state, simulate
from pipeline.models.analytical.reduced_order import pulse_sequence
from pipeline.models.analytical.statics import equilibria
from pipeline.runs.schemas import KINEMATICS, RECORD, SIGNALS, resolve
from pipeline.runs.tables import write_table
from pipeline.tools.physics import write_parameters


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


def test_curves_json_has_the_promised_keys(tmp_path: Path) -> None:
    document = answer("curves", "--set", "b=24 mm", "--figure", str(tmp_path / "curves.svg"))
    assert set(document) == {"z_b_min_m", "z_b_max_m", "switching_voltage_V", "q_m", "force_N", "C1_F", "C2_F"}
    assert 1e3 * document["z_b_min_m"] == pytest.approx(4.435, abs=1e-3)  # type: ignore[operator]
    assert (tmp_path / "curves.svg").read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize(
    ("command", "title"),
    [
        ("simulate", "Full-order simulation"),
        ("modes", "Modes of the beam"),
        ("reduce", "Reduced against full model"),
    ],
)
def test_motions_print_tables_and_draw(command: str, title: str, tmp_path: Path) -> None:
    figure = tmp_path / "figure.png"
    result = CliRunner().invoke(app, [command, "--voltage", "2.5 kV", "--figure", str(figure)], catch_exceptions=False)
    assert result.exit_code == 0
    assert title in result.stdout
    assert figure.stat().st_size > 10_000


def test_a_motion_that_diverges_has_no_nan_in_its_table_and_no_modes() -> None:
    shown = CliRunner().invoke(app, ["simulate", "--voltage", "3MV"], catch_exceptions=False)
    assert shown.exit_code == 0 and "diverged at" in shown.stdout
    assert "nan" not in shown.stdout.lower()
    with pytest.raises(InputError, match=r"diverges at .* lower the voltage"):
        CliRunner().invoke(app, ["modes", "--voltage", "3MV"], catch_exceptions=False)


def test_calibrate_reads_kinematics_and_writes_a_set(tmp_path: Path) -> None:
    truth = NOMINAL.with_values({"E": 1.7e9})
    t, v = pulse_sequence(count=3, dt=0.01)
    run = simulate(truth, t, v, rest_state(truth, equilibria(truth, v[0])[0].q, 0.0, v[0]))
    columns = {"t": t, "q": run.q, "v1": v[:, 0], "v2": v[:, 1], "segment": np.zeros(t.size, np.int32)}
    source, target = tmp_path / "kinematics.parquet", tmp_path / "joint.toml"
    schema = resolve(KINEMATICS, displacement="m", inputs=("V", "V"))
    write_table(source, schema, columns | {"qdot": run.q_dot, "qddot": run.q_ddot})
    figure = tmp_path / "calibration.svg"
    once = tmp_path / "once.toml"
    once.write_text("starts = 1\n")
    document = answer(
        "calibrate", str(source), "--paper", "--search", str(once), "-o", str(target), "--figure", str(figure)
    )
    assert figure.read_text().startswith("<?xml")
    assert set(document) >= {"parameters", "correlation", "rmse", "at_bound", "converged"}
    assert pytest.approx(1.7e9, rel=0.01) == joint_parameters(str(target)).E


def test_calibrate_takes_the_voltages_of_the_record_beside_the_kinematics(tmp_path: Path) -> None:
    """Pulses that begin between the samples: the drawing's joint itself errs where they are taken from these alone."""
    t, v = pulse_sequence(count=3, dt=1e-3)
    v = np.roll(v, 5, axis=0)
    run = simulate(NOMINAL, t, v, rest_state(NOMINAL, equilibria(NOMINAL, v[0])[0].q, 0.0, v[0]))
    columns = {"t": t, "q": run.q, "v1": v[:, 0], "v2": v[:, 1], "segment": np.zeros(t.size, np.int32)}
    rows = slice(None, None, 10)
    kinematics = {name: column[rows] for name, column in (columns | {"qdot": run.q_dot, "qddot": run.q_ddot}).items()}
    source, record = tmp_path / "kinematics.parquet", tmp_path / "record.parquet"
    write_table(source, resolve(KINEMATICS, displacement="m", inputs=("V", "V")), kinematics)
    write_table(record, resolve(RECORD, displacement="m", inputs=("V", "V")), columns)
    once = tmp_path / "once.toml"
    once.write_text("starts = 1\n")
    command = ("calibrate", str(source), "--paper", "--search", str(once), "-o", str(tmp_path / "joint.toml"))
    told = answer(*command)["rmse"]
    record.unlink()
    assert told < 1e-5 < 5e-5 < answer(*command)["rmse"]


@pytest.mark.parametrize(
    ("command", "lacking"), [(["calibrate"], "'qdot'"), (["simulate", "--signals"], "'v2'")], ids=lambda given: given[0]
)
def test_a_table_of_another_stage_or_device_is_told_by_the_column_that_it_lacks(
    command: list[str], lacking: str, tmp_path: Path
) -> None:
    table = {"t": np.arange(3.0), "q": np.zeros(3), "v1": np.zeros(3), "segment": np.zeros(3, np.int32)}
    write_table(tmp_path / "signals.parquet", resolve(SIGNALS, displacement="m", inputs=("V",)), table)
    with pytest.raises(InputError, match=f"has no column {lacking}"):
        CliRunner().invoke(app, [*command, str(tmp_path / "signals.parquet")], catch_exceptions=False)
    with pytest.raises(InputError, match="no table of a run"):
        CliRunner().invoke(app, [*command, str(tmp_path / "P1.toml")], catch_exceptions=False)


def test_a_calibrated_set_replaces_nothing_of_others(tmp_path: Path) -> None:
    one = np.array([1.7e9])
    fit = Calibration(NOMINAL.with_values({"E": 1.7e9}), ("E",), one, 0.01 * one, one, (), 0.0, True, 1, one)
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


def test_figures_of_unknown_kind_and_bad_quantities_are_refused(tmp_path: Path) -> None:
    for arguments in (["--figure", str(tmp_path / "a.xyz")], ["--v1", "3"], ["--b", "3 kV"]):
        with pytest.raises(InputError):
            CliRunner().invoke(app, ["equilibria", *arguments], catch_exceptions=False)


def test_a_figure_never_replaces_a_file_of_others(tmp_path: Path) -> None:
    figure = tmp_path / "figure.svg"
    for _ in range(2):  # what the command wrote itself, it writes again
        answer("equilibria", "--figure", str(figure))
    figure.write_text("drawn by hand")
    with pytest.raises(InputError, match=r"figure\.svg: is there already .* name another place, or remove it"):
        answer("equilibria", "--figure", str(figure))
    assert figure.read_text() == "drawn by hand"
