"""TVRegDiff against its functional, written down again here, and against what any differentiator must keep."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.optimize import minimize

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.tvregdiff import tvregdiff


def chartrand(n: int = 100, noise_std: float = 0.05, seed: int = 0) -> tuple[FloatArray, float]:
    x = np.linspace(0.0, 1.0, n)
    return np.abs(x - 0.5) + noise_std * np.random.default_rng(seed).standard_normal(n), float(x[1])


def functional(u: FloatArray, samples: FloatArray, h: float, alpha: float, epsilon: float) -> float:
    """Chartrand's functional of the derivative u, N − 1 values between the samples."""
    b = samples - samples[0]
    x = h * np.cumsum(u)
    variation = alpha * np.sum(np.sqrt(np.diff(u) ** 2 + epsilon))
    return float(variation + 0.5 * np.sum((x - b[1:]) ** 2))


@pytest.mark.parametrize("alpha", [pytest.param(1e-3, marks=pytest.mark.long), 1e-2, 0.2])
def test_objective_is_the_minimum_of_the_functional(alpha: float) -> None:
    samples, h = chartrand(20)
    epsilon = 1e-3
    result = tvregdiff(samples, h, alpha=alpha, epsilon=epsilon)
    start = np.zeros(samples.size - 1)
    reference = minimize(
        functional,
        start,
        args=(samples, h, alpha, epsilon),
        method="BFGS",
        options={"gtol": 1e-9, "maxiter": 20_000},
    )
    assert result.converged
    assert result.objective <= reference.fun * (1.0 + 1e-9)
    assert result.objective == pytest.approx(reference.fun, rel=1e-6)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
@pytest.mark.parametrize("start", ["exact", "fitted"])
def test_gap_bounds_the_distance_to_the_minimiser(order: int, start: str) -> None:
    samples, h = chartrand(400)
    best = tvregdiff(samples, h, alpha=1e-3, order=order, start=start, tolerance=1e-13)
    for steps in range(1, best.iterations):
        early = tvregdiff(samples, h, alpha=1e-3, order=order, start=start, tolerance=1e-13, max_iterations=steps)
        assert early.gap >= early.objective - best.objective - 1e-9 * best.objective
        assert 0.5 * np.sum((early.integral - best.integral) ** 2) <= early.gap + 1e-9 * best.objective
    assert early.status == "iteration limit" and not early.converged
    assert best.gap <= 1e-12 * best.objective


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 3.7e4, 1e12])
def test_unit_of_the_signal_does_not_matter(scale: float) -> None:
    samples, h = chartrand()
    one = tvregdiff(samples, h, alpha=0.2, epsilon=1e-6)
    other = tvregdiff(scale * samples, h, alpha=scale * 0.2, epsilon=scale**2 * 1e-6)
    np.testing.assert_allclose(other.derivative / scale, one.derivative, atol=1e-7)
    assert other.objective / scale**2 == pytest.approx(one.objective, rel=1e-10)


@pytest.mark.parametrize("kwargs", [{}, {"start": "fitted"}])
@pytest.mark.parametrize("n", [2, 3, 4, 100, 100_000])
@pytest.mark.parametrize("epsilon", [1e-12, 1e-2])
@pytest.mark.parametrize("dt", [1e-6, 1.0, 1e3])
def test_constant_and_linear_signals_are_exact(kwargs: dict[str, str], n: int, epsilon: float, dt: float) -> None:
    t = dt * np.arange(n)
    for slope in (0.0, 1.7):
        result = tvregdiff(slope * t - 4.0, dt, alpha=0.01, epsilon=epsilon, **kwargs)
        assert result.converged
        np.testing.assert_allclose(result.derivative, slope, atol=1e-9 * max(1.0, 1.0 / dt * 1e-6))
        np.testing.assert_allclose(result.integral, slope * t - 4.0, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_large_alpha_gives_the_polynomial_of_least_squares(order: int) -> None:
    samples, h = chartrand(120)
    t = h * np.arange(samples.size)
    fit = np.polyval(np.polyfit(t, samples, order), t)
    result = tvregdiff(samples, h, alpha=1e4, epsilon=1e-12, order=order, start="fitted")
    np.testing.assert_allclose(result.integral, fit, atol=1e-6)


def test_weights_scale_the_terms_of_the_variation() -> None:
    """Equal weights are a factor on alpha; others minimise the weighted functional, written down again here."""
    samples, h = chartrand(60)
    n = samples.size
    alone = tvregdiff(samples, h, alpha=0.06, epsilon=1e-3)
    equal = tvregdiff(samples, h, alpha=0.2, epsilon=1e-3, weights=np.full(n, 0.3))
    np.testing.assert_allclose(equal.derivative, alone.derivative, atol=1e-6)
    assert equal.objective == pytest.approx(alone.objective, rel=1e-9)

    weights = np.random.default_rng(1).uniform(0.1, 1.0, n)
    result = tvregdiff(samples, h, alpha=0.06, epsilon=1e-3, weights=weights)
    u = np.diff(result.integral) / h

    def weighted(u: FloatArray) -> float:
        misfit = functional(u, samples, h, 1e-300, 1e-3)
        return misfit + 0.06 * float(np.sum(weights[2:] * np.sqrt(np.diff(u) ** 2 + 1e-3)))

    assert result.objective == pytest.approx(weighted(u), rel=1e-9)
    rng = np.random.default_rng(2)
    for size in (1e-2, 1e-4):
        for _ in range(20):
            assert weighted(u + size * rng.standard_normal(u.size)) >= result.objective * (1.0 - 1e-12)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_converges_for_all_kinds_of_records_and_parameters(order: int) -> None:
    """Noise, walks, sines, quantised sines, steps and spikes, with alpha and epsilon over ten decades and more."""
    rng = np.random.default_rng(order)
    i = np.arange(300)
    for k in range(120):
        kinds = (
            rng.standard_normal(i.size),
            np.cumsum(rng.standard_normal(i.size)),
            np.sin(i / 5.0) + 0.01 * rng.standard_normal(i.size),
            np.round(20.0 * np.sin(i / 50.0)),
            (i > 150).astype(float),
            np.where(rng.random(i.size) < 0.02, 1e3, 0.1 * rng.standard_normal(i.size)),
        )
        unit, dt = 10.0 ** rng.uniform(-9, 9), 10.0 ** rng.uniform(-7, 3)
        alpha = 10.0 ** rng.uniform(-8, 4) * unit * dt**order
        epsilon = 10.0 ** rng.uniform(-24, 2) * (unit / dt**order) ** 2
        result = tvregdiff(unit * kinds[k % 6], dt, alpha=alpha, epsilon=epsilon, order=order)
        assert result.converged, (k % 6, result.status, alpha, epsilon, dt, unit)


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.floats(-1e3, 1e3, allow_subnormal=False), min_size=3, max_size=40),
    st.floats(-4, 3),
    st.floats(-12, -2),
)
def test_any_record_is_minimised(values: list[float], log_alpha: float, log_epsilon: float) -> None:
    samples = np.array(values)
    alpha, epsilon = 10.0**log_alpha, 10.0**log_epsilon
    result = tvregdiff(samples, 0.1, alpha=alpha, epsilon=epsilon)
    assert np.isfinite(result.derivative).all() and result.gap >= 0.0
    candidates = [np.full(samples.size - 1, slope) for slope in (0.0, np.ptp(samples))]
    candidates.append(np.diff(samples) / 0.1)
    lowest = min(functional(u, samples, 0.1, alpha, epsilon) for u in candidates)
    assert result.objective - result.gap <= lowest * (1.0 + 1e-9)
    if result.converged:
        assert result.objective <= lowest * (1.0 + 1e-9)


@pytest.mark.parametrize(
    ("samples", "kwargs", "word"),
    [
        ([1.0], {}, "N ≥ 2"),
        ([1.0, np.nan, 2.0], {}, "finite"),
        ([1.0, 2.0, 3.0], {"alpha": 0.0}, "alpha"),
        ([1.0, 2.0, 3.0], {"epsilon": -1.0}, "epsilon"),
        ([1.0, 2.0, 3.0], {"dt": np.inf}, "dt"),
        ([1.0, 2.0, 3.0], {"order": 3}, "order 3"),
        (np.zeros(9), {"order": 5}, "order=5"),
        ([1.0, 2.0, 3.0], {"weights": [1.0, 1.0]}, "3 positive, finite weights"),
    ],
)
def test_bad_input_is_one_line(samples: object, kwargs: dict[str, object], word: str) -> None:
    arguments = {"dt": 0.1, "alpha": 0.1} | kwargs
    with pytest.raises(InputError, match=word) as error:
        tvregdiff(samples, **arguments)
    assert "\n" not in str(error.value)
