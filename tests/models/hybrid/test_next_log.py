"""What a further log would show of a joint: derivatives, expected errors, and a log designed by them."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.next_log import slopes, uncertainty
from pipeline.models.hybrid.parameters import NAMES
from pipeline.numerics.arrays import FloatArray
from pipeline.workflow.studies.excitation_design import Requirements, design_next_log
from tests.export.conftest import planted_run  # noqa: F401 - a fixture
from tests.export.joints import hybrid, pulses

START = -0.0105
UNSURE = ("left.log C0", "right.log C0", "log E", "log eta", "log charging time")


@pytest.fixture(scope="module")
def model() -> HybridModel:
    """Five numbers are known to a hundredth of their prior, everything else far better."""
    joint = hybrid(centres=0)
    spread = np.diag([1e-2 if name in UNSURE else 1e-6 for name in NAMES])
    return replace(joint, spread=spread, diagnostics={"integrated_correlation_time": 4.0, "training_rms_m": 3e-6})


def run(model: HybridModel, theta: FloatArray, t: FloatArray, v: FloatArray) -> FloatArray:
    return 1e3 * replace(model, theta=theta).simulate(t, v, START, 0.0).q


def test_slopes_are_those_of_the_free_run(model: HybridModel) -> None:
    t, v = pulses(4.0)
    by_theta = slopes(model, t, v, START)
    for name in ("left.log C0", "log E", "delay"):
        step = 1e-4 * (np.arange(len(NAMES)) == NAMES.index(name))
        differences = (run(model, model.theta + step, t, v) - run(model, model.theta - step, t, v)) / 2e-4
        error = np.abs(by_theta[:, NAMES.index(name)] - differences).max()
        assert error < 0.03 * np.abs(differences).max(), name


def test_the_expected_error_is_the_spread_of_runs_of_the_posterior(model: HybridModel) -> None:
    t, v = pulses(4.0)
    unsure = uncertainty(replace(model, spread=0.1 * model.spread), t, v, START, 0.01)
    draws = model.theta + np.random.default_rng(1).standard_normal((200, len(NAMES))) @ (0.1 * model.spread)
    runs = np.array([run(model, theta, t, v) for theta in draws])
    assert unsure.error() == pytest.approx(1e-3 * np.sqrt(np.mean(np.var(runs, axis=0))), rel=0.15)


def test_a_designed_log_is_expected_to_beat_usual_ones_within_the_voltage(model: HybridModel) -> None:
    wanted = Requirements(duration=8.0, candidates=4, voltage=2900.0)
    made = design_next_log(model, START, 0.01, "validation", np.random.default_rng(2), wanted)
    assert made.designed < made.usual < made.now
    assert max(max(burst.left, burst.right) for burst in made.bursts) <= 2900.0
