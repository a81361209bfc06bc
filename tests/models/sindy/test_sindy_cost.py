"""What bounds the work of SINDy's search, and that it leaves the results as they are."""

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.models.polynomial_dynamics import FIRST_INPUT, QDOT, PolynomialDynamics, Q, free_run
from pipeline.models.sindy.fit import fit_sindy
from pipeline.signals.log import Log


def _oscillator(rate: float, damping: float) -> PolynomialDynamics:
    """``q̈ = −ω² q − 2 ζ ω q̇ + u``, ω a rate [1/s]."""
    exponents = np.zeros((3, FIRST_INPUT + 1), dtype=np.int64)
    exponents[[0, 1, 2], [QDOT, Q, FIRST_INPUT]] = 1
    table = np.array([[1.0, 0.0, 0.0], [-2.0 * damping * rate, -(rate**2), 1.0]])
    return PolynomialDynamics(exponents, table, np.ones(FIRST_INPUT + 1), (), False, -1e9, 1e9)


@pytest.mark.parametrize(("rate", "damping"), [(0.2, 0.1), (0.4, 2.0)])
def test_a_slow_device_is_simulated_as_exactly(rate: float, damping: float) -> None:
    """Decay from a displacement, at 6 s a sample, against the exact solution."""
    t = 6.0 * np.arange(60)
    found, reached = free_run(_oscillator(rate, damping), np.zeros((t.size, 1)), 6.0, 1.0, 0.0)
    slow, fast = np.roots([1.0, 2.0 * damping * rate, rate**2])
    exact = ((fast * np.exp(slow * t) - slow * np.exp(fast * t)) / (fast - slow)).real
    assert reached == t.size
    assert np.abs(found[:, 0] - exact).max() < 1e-4


@pytest.mark.parametrize("interval", [pytest.param(0.01, marks=pytest.mark.long), 6.0])
def test_a_device_of_any_speed_is_found(interval: float) -> None:
    """An oscillator of one linear input, sampled 100 times in a period: lags follow its time scale."""
    rng, t = np.random.default_rng(1), interval * np.arange(900)
    rate, v = 0.05 / interval, np.repeat(rng.standard_normal(45), 20)[:, None]
    path, _ = free_run(_oscillator(rate, 0.5), rate**2 * v, interval, 0.0, 0.0)
    dynamics, notes = fit_sindy([Log(t, *path.T.copy(), v)], JOINT.under_other_action)
    assert notes["inner_validation_nrmse"] < 1e-2
    assert all(lag.time >= 0.25 * interval for lag in dynamics.lags)
