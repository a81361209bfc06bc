"""SINDy recovers a planted sparse equation, simulates it, survives a round trip and names a divergence."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import JOINT, Device
from pipeline.models.model_type import model_from_tree
from pipeline.models.polynomial_dynamics import PolynomialDynamics, free_run
from pipeline.models.sindy.model import SindyModel, identify_sindy
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import nrmse
from pipeline.signals.log import Log
from pipeline.units.units import SiUnit

STIFFNESS, HARDENING, DAMPING, GAIN = 300.0, 2.0e6, 1.5, 1.0e-6
TRUTH = PolynomialDynamics(
    exponents=np.array(
        [
            [0, 1, 0, 0, 0, 0, 0],
            [1, 0, 0, 0, 0, 0, 0],
            [3, 0, 0, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, 1, 0],
            [0, 0, 0, 0, 0, 0, 1],
        ]
    ),
    coefficients=np.array([[1.0, 0, 0, 0, 0], [-DAMPING, STIFFNESS, -HARDENING, GAIN, -GAIN]]),
    scales=np.ones(7),
    lags=(),
    squared=True,
    low=-0.1,
    high=0.1,
)


def pulses(samples: int, seed: int) -> FloatArray:
    rng = np.random.default_rng(seed)
    v = np.zeros((samples, 2))
    for start in range(50, samples - 150, 170):
        v[start : start + 60, rng.integers(2)] = rng.uniform(1500.0, 3000.0)
    return v


def motion(samples: int = 2000, seed: int = 1) -> Log:
    v, t = pulses(samples, seed), 0.01 * np.arange(samples)
    path, reached = free_run(TRUTH, v, 0.01, -np.sqrt(STIFFNESS / HARDENING), 0.0)
    assert reached == samples
    return Log(t, *path.T, v)


@pytest.fixture(scope="module")
def model() -> SindyModel:
    return identify_sindy([motion()], replace(JOINT, known_mass=0.04))


def test_the_planted_equation_is_recovered(model: SindyModel) -> None:
    """Truth in the library, no noise: exactly its terms remain, their coefficients to 1 %."""
    d = model.dynamics
    terms = {
        tuple(row): value / np.prod(d.scales**row)
        for row, value in zip(d.exponents[1:], d.coefficients[1, 1:], strict=True)
    }
    expected = {tuple(row): value for row, value in zip(TRUTH.exponents, TRUTH.coefficients[1], strict=True)}
    assert set(terms) == set(expected)
    assert all(terms[key] == pytest.approx(expected[key], rel=1e-2) for key in expected)


def test_a_new_record_is_predicted_freely(model: SindyModel) -> None:
    new = motion(400, seed=5)
    run = model.simulate(new.t, new.v, float(new.q[0]), float(new.qdot[0]))
    assert run.status == "ok"
    assert nrmse(new.q, run.q) < 1e-2


def test_characteristic_curves_are_those_planted(model: SindyModel) -> None:
    q = np.linspace(-0.012, 0.012, 5)
    curves = model.curves(q)
    np.testing.assert_allclose(curves["F"], 0.04 * (HARDENING * q**3 - STIFFNESS * q), atol=1e-4)
    np.testing.assert_allclose(curves["d"], 0.04 * DAMPING, rtol=1e-3)
    np.testing.assert_allclose(curves["dC1_dq"], 2 * 0.04 * GAIN, rtol=1e-3)
    np.testing.assert_allclose(curves["dC2_dq"], -2 * 0.04 * GAIN, rtol=1e-3)


def test_round_trip_through_the_tree_changes_no_prediction(model: SindyModel) -> None:
    again = model_from_tree("sindy", model.to_tree())
    v, t = pulses(500, 3), 0.01 * np.arange(500)
    np.testing.assert_array_equal(again.simulate(t, v, -0.01, 0.0).q, model.simulate(t, v, -0.01, 0.0).q)


def test_a_count_in_its_description_is_a_number_of_python(model: SindyModel) -> None:
    assert isinstance(model.describe()["terms_kept"], int)


def test_divergence_is_a_status_with_a_time() -> None:
    """q̈ = +400 q leaves ±0.1 m from 1 mm after ln(200)/20 s = 0.265 s."""
    unstable = PolynomialDynamics(
        np.eye(2, 6, dtype=np.int64)[::-1],
        np.array([[1.0, 0.0], [0.0, 400.0]]),
        np.ones(6),
        (),
        True,
        -0.1,
        0.1,
    )
    run = SindyModel.of(unstable, JOINT).simulate(0.01 * np.arange(100), np.zeros((100, 1)), 1e-3, 0.0)
    assert run.status == "diverged"
    assert run.diverged_at_s == pytest.approx(np.log(200.0) / 20.0, abs=0.011)
    assert np.all(np.isnan(run.q[27:]))
    assert np.all(np.isfinite(run.q[:26]))


def test_a_pendulum_is_found_in_sines() -> None:
    """θ̈ = −20 sin θ − 0.8 θ̇ + 25 u²: the quarter drone's own equation, up to 80°."""
    pendulum = PolynomialDynamics(
        np.eye(6, dtype=np.int64)[[1, 3, 5]],
        np.array([[1.0, 0.0, 0.0], [-0.8, -20.0, 25.0]]),
        np.ones(6),
        (),
        True,
        -3.0,
        3.0,
    )
    rng = np.random.default_rng(2)
    v, t = np.repeat(rng.uniform(0.0, 0.8, 40), 75)[:, None], 0.01 * np.arange(3000)
    data = Log(t, *free_run(pendulum, v, 0.01, 0.0, 0.0)[0].T, v)
    model = identify_sindy([data], Device(None, SiUnit(1.0, "rad"), (SiUnit(1.0, "1"),), "squared", None))
    assert "sin q" in model.diagnostics["library"]
    acceleration = model_from_tree("sindy", model.to_tree()).equations()[1]
    for part in ("q̈ [rad/s²]", "-20 rad s^-2·sin q", " s^-1·q̇", "+25 rad s^-2·v1^2"):
        assert part in acceleration
    assert len(model.dynamics.exponents) == 4


def test_fine_voltages_act_between_the_samples() -> None:
    """A pulse of 5 ms that no sample shows moves the joint all the same."""
    t, v = 0.01 * np.arange(50), np.zeros((50, 10, 2))
    v[20, 3:8, 0] = 3000.0
    model = SindyModel.of(TRUTH, JOINT)
    start = -np.sqrt(STIFFNESS / HARDENING)
    moved = model.simulate(t, v, start, 0.0).q
    still = model.simulate(t, v[:, 0], start, 0.0).q
    assert np.ptp(moved) > 1e-4 > 10.0 * np.ptp(still)
