"""What bounds the work of SINDy's search, and that it leaves the results as they are."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.ndimage

from pipeline.baselines.polynomial_dynamics import FIRST_INPUT, QDOT, PolynomialDynamics, Q, free_run
from pipeline.baselines.polynomial_dynamics import steps_between_samples as steps
from pipeline.baselines.sindy import fit_sindy
from pipeline.baselines.sindy_problem import TRUNCATE, _filtered
from pipeline.signals.trajectory import Trajectory
from pipeline.solvers.free_run import steps_per_sample


def _oscillator(rate: float, damping: float, lag_time: float = 0.0) -> PolynomialDynamics:
    """``q̈ = −ω² q − 2 ζ ω q̇ + u``, ω a rate [1/s]."""
    exponents = np.zeros((3, FIRST_INPUT + 1), dtype=np.int64)
    exponents[[0, 1, 2], [QDOT, Q, FIRST_INPUT]] = 1
    table = np.array([[1.0, 0.0, 0.0], [-2.0 * damping * rate, -(rate**2), 1.0]])
    return PolynomialDynamics(exponents, table, np.ones(FIRST_INPUT + 1), lag_time, False, -1e9, 1e9)


def test_a_slow_log_takes_few_steps_and_a_fast_one_as_many_as_ever() -> None:
    joint = _oscillator(1.0, 0.1)
    for interval in (1e-4, 0.01, 0.05, 0.1):
        assert steps(joint, interval) == steps_per_sample(interval, np.inf)
        assert steps(replace(joint, lag_time=0.02), interval) == steps_per_sample(interval, 0.02)
    assert steps(joint, 6.0) == 20
    assert steps(replace(joint, lag_time=6.0), 60.0) == 20
    assert steps(replace(joint, lag_time=0.5), 60.0) == 240  # which Runge-Kutta needs to be stable


@pytest.mark.parametrize(("rate", "damping"), [(0.2, 0.1), (0.4, 2.0)])
def test_a_slow_device_is_simulated_as_exactly(rate: float, damping: float) -> None:
    """Decay from a displacement, at 6 s a sample, against the exact solution."""
    t = 6.0 * np.arange(60)
    found, reached = free_run(_oscillator(rate, damping), np.zeros((t.size, 1)), 6.0, 1.0, 0.0)
    slow, fast = np.roots([1.0, 2.0 * damping * rate, rate**2])
    exact = ((fast * np.exp(slow * t) - slow * np.exp(fast * t)) / (fast - slow)).real
    assert reached == t.size
    assert np.abs(found[:, 0] - exact).max() < 1e-4


def test_a_wide_filter_gives_the_same_rows() -> None:
    rows, width = np.random.default_rng(0).standard_normal((2000, 3)).cumsum(axis=0), 60.3
    kept = slice(300, 1700, 30)
    whole = scipy.ndimage.gaussian_filter1d(rows, width, axis=0, truncate=TRUNCATE)
    np.testing.assert_allclose(_filtered(rows, width, kept), whole[kept], rtol=1e-11)
    assert _filtered(rows, width, slice(300, 300)).shape == (0, 3)


def test_of_lags_and_filters_those_far_shorter_than_a_sample_are_not_tried() -> None:
    """Such a filter does nothing, and such a lag makes the acceleration a difference of two regressors."""
    tried = {}
    for interval in (0.01, 0.5, 6.0):
        rng, t = np.random.default_rng(1), interval * np.arange(900)
        rate, v = 0.05 / interval, np.repeat(rng.standard_normal(45), 20)[:, None]
        path, _ = free_run(_oscillator(rate, 0.5), rate**2 * v, interval, 0.0, 0.0)
        fit = fit_sindy([Trajectory(t, *path.T.copy(), v)], squared=False)
        assert float(fit.fold_errors.mean()) < 1e-3
        assert fit.dynamics.lag_time == 0.0 or fit.dynamics.lag_time >= 0.25 * interval
        tried[interval] = fit.candidates_tried
    assert tried[0.01] > tried[0.5] > tried[6.0]
