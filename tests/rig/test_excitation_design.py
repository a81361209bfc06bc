"""Designed sequences tell more than plain ones, keep the limits, and are what the rig plays."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.device.parameters import NOMINAL
from pipeline.errors import InputError
from pipeline.fitting.information import ScaledRegressor, conditioning, log_information
from pipeline.rig.excitation import (
    Sequence,
    alternating_pulses,
    command,
    load_sequence,
    random_excitation,
    save_sequence,
)
from pipeline.rig.fleet import Experiment, simulate_prototype
from pipeline.settings.file import read_options
from pipeline.workflow.studies.excitation import DesignFile
from pipeline.workflow.studies.excitation_design import (
    Design,
    Requirements,
    assess,
    design_excitation,
    drawn_simulators,
)

WANTED = Requirements(duration=14.0, candidates=6)


@pytest.fixture(scope="module")
def simulators():
    return drawn_simulators(NOMINAL, np.random.default_rng(0), 2)


@pytest.fixture(scope="module")
def design(simulators) -> Design:
    return design_excitation(simulators, np.random.default_rng(1), WANTED)


def motion(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    t = np.arange(3000) * 0.01
    q = 0.012 * np.sin(2 * np.pi * 0.37 * t + seed)
    return q, np.gradient(q, t), 3000.0 * rng.random((t.size, 2))


def test_information_adds_up_and_does_not_care_for_units() -> None:
    q, qdot, v = motion(0)
    weights = ScaledRegressor.over(q, qdot, v.max(axis=0))
    once = weights.information(q, qdot, v, 0.01)
    assert log_information(1e6 * once) - log_information(5e5 * once) == pytest.approx(np.log(2.0), rel=1e-3)
    scaled = replace(weights, scales=weights.scales * np.array([1.0, 7.0, 1e3, 1e-3]))
    other = scaled.information(q, qdot, v, 0.01)
    assert conditioning(other).log_det == pytest.approx(conditioning(once).log_det, rel=1e-9)
    assert conditioning(other).condition == pytest.approx(conditioning(once).condition, rel=1e-6)
    rows = np.linalg.qr(np.random.default_rng(1).standard_normal((50, 8)))[0]
    assert conditioning(rows.T @ rows).log_det == pytest.approx(0.0, abs=1e-9)
    assert conditioning(rows.T @ rows).condition == pytest.approx(1.0)


def test_a_design_beats_plain_pulses_and_random_programmes(design, simulators) -> None:
    assert design.efficiency > 1.5
    random = [
        assess(
            simulators, design.weights, design.wells, random_excitation(np.random.default_rng(s), duration=14.0), 14.0
        )
        for s in range(8)
    ]
    assert design.designed.criterion > max(each.criterion for each in random)
    assert design.designed.covered > design.plain.covered
    assert min(design.designed.crossings) >= 4, "both wells, on every joint"


def test_a_design_keeps_the_limits_and_follows_the_seed(design, simulators) -> None:
    t = np.arange(14_000) * 1e-3
    u = command(design.bursts, t)
    assert u.min() >= 0.0 and u.max() <= 3000.0
    assert (u[t < 1.0] == 0.0).all() and (u[-190:] == 0.0).all()
    again = design_excitation(simulators, np.random.default_rng(1), WANTED)
    assert (command(again.bursts, t) == u).all()
    pulses = design_excitation(
        simulators[:1], np.random.default_rng(1), replace(WANTED, kinds=("pulse",), candidates=2)
    )
    assert {burst.shape for burst in pulses.bursts} == {"pulse"}


@pytest.mark.parametrize("ending", [".csv", ".mat"])
def test_a_sequence_is_read_back_as_it_was_written(ending: str, tmp_path: Path) -> None:
    t = np.arange(4000) / 1e3
    sequence = Sequence(t, command(alternating_pulses(duration=4.0), t))
    path, beside = save_sequence(tmp_path / f"s{ending}", sequence, {"seed": np.int64(3)})
    found = load_sequence(path)
    np.testing.assert_allclose(found.u, sequence.u, atol=1e-4)
    assert found.duration == pytest.approx(4.0) and json.loads(beside.read_text()) == {"seed": 3}
    fine = np.arange(40_000) / 1e4
    held = found.at(fine)
    assert (held == np.repeat(found.u, 10, axis=0)).all()


def test_the_virtual_rig_plays_a_sequence(tmp_path: Path) -> None:
    from pyarrow import parquet

    t = np.arange(5000) / 1e3
    save_sequence(tmp_path / "s.csv", Sequence(t, command(alternating_pulses(duration=5.0), t)), {})
    experiment = Experiment(kind="nominal", rate=2000.0, duration=2.0, format="parquet", play=str(tmp_path / "s.csv"))
    simulate_prototype(tmp_path, "X", experiment, seed=1)
    played = parquet.read_table(tmp_path / "truth" / "train.parquet").to_pydict()
    assert len(played["t"]) == 5000
    for name, level in (("v1", 1.5), ("v2", 3.5)):
        v = np.array(played[name])
        assert v[round(level * 1e3)] == pytest.approx(3000.0, rel=1e-3), "the converter has settled in the pulse"
    assert parquet.read_table(tmp_path / "truth" / "validation.parquet").num_rows == 2000


def test_the_command_designs_writes_and_says_what_it_gains(tmp_path: Path) -> None:
    (tmp_path / "d.toml").write_text("candidates = 8\njoints = 1\nmax_field_V_per_um = 50.0\nrate_Hz = 500.0\n")
    options = ["--duration", "8s", "--design", str(tmp_path / "d.toml")]
    result = CliRunner().invoke(app, ["rig", "excite", "-o", str(tmp_path / "e.csv"), *options, "--json"])
    assert result.exit_code == 0, result.output
    document = json.loads(result.stdout)
    assert document["largest_voltage_v"] == pytest.approx(2500.0) and document["relative_d_efficiency"] > 1.0
    sequence = load_sequence(tmp_path / "e.csv")
    assert sequence.t.size == 4000 and sequence.u.max() <= 2500.0
    assert json.loads((tmp_path / "e.json").read_text())["seed"] == 1


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('kinds = ["fire"]', "kinds"),
        ("rate_Hz = 1.0", "rate_Hz: input should be greater than or equal to 100"),
        ("rest = 1.0", "did you mean 'rest_s'"),
        ('model = "rbf"', "model is gone; leave it out: a sequence is designed for the joint of --parameters"),
    ],
)
def test_a_mistake_in_the_file_of_a_design_is_one_line(text: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "d.toml").write_text(text)
    with pytest.raises(InputError, match=words):
        read_options(tmp_path / "d.toml", DesignFile)
