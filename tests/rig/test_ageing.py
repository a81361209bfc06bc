"""A prototype days later is the same joint with the stated changes and other logs."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.rig.fleet import Experiment, draw

SHORT = {"kind": "nominal", "rate": 2000.0, "duration": 2.5, "format": "parquet"}


def test_the_joint_of_a_seed_ages_as_stated_and_its_logs_are_those_of_the_day() -> None:
    drift = {"capacitance_percent": -0.1, "stiffness_percent": 0.05, "charging_s": 20e-6, "laser_m": 2e-6}
    young, _, first = draw(Experiment(**SHORT), np.random.default_rng(3))
    same, bench, _ = draw(Experiment(**SHORT, age_days=0.0, drift=drift), np.random.default_rng(3))
    old, later, last = draw(Experiment(**SHORT, age_days=30.0, drift=drift), np.random.default_rng(3))
    np.testing.assert_array_equal(same.capacitance, young.capacitance)
    np.testing.assert_allclose(old.capacitance, 0.97 * young.capacitance)
    assert old.bending == pytest.approx(1.015 * young.bending)
    np.testing.assert_allclose(old.hinge_stiffness, 1.015 * young.hinge_stiffness)
    assert (later.charging, later.laser.zero) == (pytest.approx(600e-6), pytest.approx(60e-6))
    assert later.converters == bench.converters and later.probes == bench.probes
    begun = slice(0, 1000)  # at rest: what the laser reads is the joint and the zero
    np.testing.assert_allclose(last[0].record.q[begun] - last[0].record.true_q[begun], 60e-6, atol=12e-6)
    assert np.abs(last[0].record.v1 - first[0].record.v1).max() > 1000.0


def test_the_truth_states_age_and_changes(tmp_path: Path) -> None:
    (tmp_path / "old.toml").write_text("age_days = 30.0\n[drift]\nlaser_m = 1e-6\n")
    arguments = ["--kind", "nominal", "--rate", "2000", "--duration", "2", "--format", "parquet"]
    given = ["--experiment", str(tmp_path / "old.toml")]
    result = CliRunner().invoke(app, ["rig", "simulate", "-o", str(tmp_path), *arguments, *given])
    assert result.exit_code == 0, result.output
    truth = json.loads((tmp_path / "truth" / "truth.json").read_text(encoding="utf-8"))
    assert truth["experiment"]["age_days"] == 30.0 and truth["experiment"]["drift"]["laser_m"] == pytest.approx(1e-6)
    assert truth["bench"]["laser"]["zero"] == pytest.approx(30e-6)
    assert (tmp_path / "nominal-1-day30.toml").is_file()


@pytest.mark.parametrize(
    ("drift", "age", "message"),
    [({"capacitance_percent": -1.0}, 60.0, "more than half"), ({"charging_s": -1e-6}, 1.0, "negative")],
)
def test_a_change_that_cannot_be_is_refused(drift: dict[str, float], age: float, message: str) -> None:
    with pytest.raises(InputError, match=message):
        draw(Experiment(**SHORT, age_days=age, drift=drift), np.random.default_rng(3))
