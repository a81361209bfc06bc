import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pipeline.fitting.regression import basis_centres
from pipeline.models.paper.model import RbfPaperModel, identify_rbf_paper
from pipeline.signals.log import Log

MASS = 0.04


def planted_model():
    """A double well whose curves are exactly Gaussian networks, confined well past the visited range."""
    centres = basis_centres(-0.02, 0.02, 8)
    stiffness = 8.0 * (centres / 0.012) ** 2 - 8.0
    damping = 0.1 + 5.0 * np.abs(centres)
    gains = 4e-9 * (1.0 + 10.0 * centres), -4e-9 * (1.0 - 12.0 * centres)
    weights = np.array([stiffness, damping, *gains])
    return RbfPaperModel(centres=centres, smoothing=1.0, weights=weights, lag_s=0.03, mass_kg=MASS)


def pulses(t, rng):
    v = np.zeros((len(t), 2))
    for start in np.arange(0.3, t[-1] - 1.0, 1.1):
        v[(t >= start) & (t < start + 0.5), rng.integers(2)] = rng.uniform(1500, 3000)
    return v


def reference(model, t, v, start):
    """The same equations written down with NumPy and solved by an adaptive integrator."""

    def slope(s, y):
        bells = np.exp(-((y[0] - model.centres) ** 2) / (2 * model.width**2))
        c, d, g1, g2 = model.weights @ bells
        volts = [np.interp(s, t, v[:, k]) for k in range(2)]
        force = -c * y[0] - d * y[2] + g1 * volts[0] ** 2 + g2 * volts[1] ** 2
        return y[1], force / model.mass_kg, (y[1] - y[2]) / model.lag_s

    return solve_ivp(slope, (t[0], t[-1]), [*start, start[1]], t_eval=t, rtol=1e-9, atol=1e-12, max_step=2e-3).y


@pytest.fixture(scope="module")
def log():
    model = planted_model()
    t = 5.0 + 0.01 * np.arange(2200)
    v = pulses(t - 5.0, np.random.default_rng(5))
    run = model.simulate(t, v, 0.0121, 0.0)
    return Log(t, run.q, run.qdot, run.qddot, v)


def test_free_run_agrees_with_an_adaptive_integrator(log):
    model, part = planted_model(), slice(0, 250)
    run = model.simulate(log.t[part], log.v[part], log.q[0], 0.02)
    truth = reference(model, log.t[part], log.v[part], (log.q[0], 0.02))
    assert run.q == pytest.approx(truth[0], abs=2e-7)
    assert run.qdot == pytest.approx(truth[1], abs=2e-5)


def test_planted_curves_are_recovered_over_the_visited_range(log):
    model, truth = identify_rbf_paper([log], basis_functions=12, smoothing=1.0, mass=MASS), planted_model()
    run = model.simulate(log.t, log.v, log.q[0], log.qdot[0])
    assert run.status == "ok"
    assert np.std(run.q - log.q) < 0.01 * np.ptp(log.q)
    assert model.lag_s == pytest.approx(truth.lag_s, rel=0.15)


def test_bands_of_the_curves_cover_what_noise_does_to_them(log):
    """Identify the same motion under many draws of noise: the spread of the curves must be what one fit claims."""
    rng, q = np.random.default_rng(6), np.linspace(-0.012, 0.012, 8)
    model, curves, part = None, [], slice(0, 800)
    for _ in range(12):
        qddot = log.qddot[part] + 0.3 * rng.standard_normal(800)
        noisy = Log(log.t[part], log.q[part], log.qdot[part], qddot, log.v[part])
        model = identify_rbf_paper([noisy], basis_functions=12, smoothing=1.0, mass=MASS)
        curves.append(model.curves(q)["F"])
    claimed = model.curve_ensemble(q, 300)["F"].std(axis=0)
    assert np.sqrt(np.mean(np.var(curves, axis=0) / claimed**2)) == pytest.approx(1.0, abs=0.4)


def test_the_lag_is_a_minimum_of_the_cost(log):
    model = identify_rbf_paper([log], mass=MASS)
    assert model.diagnostics["lag_converged"]
    search = model.diagnostics["lag_search"]
    assert search["lag_s"][-1] == model.lag_s and np.all(np.diff(search["cost"]) < 0.0)
    assert search["rank"][-1] == model.diagnostics["rank"]
    assert search["condition"][-1] == pytest.approx(model.diagnostics["condition"], rel=1e-3)

    def residual(lag):
        from pipeline.fitting.regression import basis_values, curve_signals, regressor
        from pipeline.numerics.linear_filters import first_order_lag

        z, _ = first_order_lag(log.qdot, log.interval, lag)
        matrix = regressor(basis_values(log.q, model.centres, model.width), curve_signals(log.q, z, log.v**2))
        scale = np.linalg.norm(matrix, axis=0)
        weights = np.linalg.lstsq(matrix / scale, MASS * log.qddot, rcond=None)[0] / scale
        return np.sqrt(np.mean((MASS * log.qddot - matrix @ weights) ** 2))

    assert residual(model.lag_s) == pytest.approx(model.diagnostics["residual_rms"], rel=1e-6)
    assert residual(model.lag_s) <= min(residual(0.9 * model.lag_s), residual(1.1 * model.lag_s))


def test_a_run_that_escapes_ends_with_status_and_time(log):
    model = planted_model()
    run = model.simulate(log.t, np.full_like(log.v, 0.0), 0.05, 3.0)
    assert run.status == "diverged"
    assert log.t[0] < run.diverged_at_s <= log.t[-1]
    late = run.t >= run.diverged_at_s
    assert np.isnan(run.q[late]).all()
    assert np.isfinite(run.q[~late]).all()
