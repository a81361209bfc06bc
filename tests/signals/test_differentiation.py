"""Velocity and acceleration: exactness, invariances, robustness, and the parameters that a record is given."""

import differentiation_signals as signals
import numpy as np
import pytest

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.linear_filters import finite_difference, finite_difference_at_jumps
from pipeline.numerics.tv_newton import effective_parameters
from pipeline.numerics.tvregdiff import tvregdiff
from pipeline.signals.differentiate import Kinematics, alpha_study, differentiate, smoothing_parameter
from pipeline.signals.noise import noise_std

METHODS = [
    {"order": 1},
    {"order": 2},
    {"order": 3},
    {"order": 4},
    {"method": "savitzky-golay"},
]


def rms(error: FloatArray) -> float:
    return float(np.sqrt(np.mean(error**2)))


def noisy_ring_down(noise_std: float = 0.003, seed: int = 1, n: int = 4000) -> tuple[signals.Signal, FloatArray]:
    record = signals.ring_down(n, frequencies=(2.8, 6.0))
    return record, record.noisy(noise_std, np.random.default_rng(seed))


# ------------------------------------------------------------------ the differentiators


@pytest.mark.parametrize("kwargs", METHODS)
def test_lengths_signs_and_size(kwargs: dict[str, object]) -> None:
    record, samples = noisy_ring_down()
    k = differentiate(samples, record.dt, **kwargs)
    assert k.q_smooth.shape == k.qdot.shape == k.qddot.shape == samples.shape
    assert rms(k.qdot - record.first) < 0.02 * rms(record.first)
    assert rms(k.qddot - record.second) < 0.25 * rms(record.second)
    assert k.noise_std == pytest.approx(0.003, rel=0.1)
    assert k.converged and k.alpha > 0.0


@pytest.mark.parametrize("kwargs", METHODS)
def test_neither_derivative_lags(kwargs: dict[str, object]) -> None:
    """The lag that explains most of the error, by least squares; a hundredth of the sampling interval counts."""
    record = signals.sine(1500)
    k = differentiate(record.noisy(1e-3, np.random.default_rng(0)), record.dt, **kwargs)
    inside = slice(100, -100)
    for found, truth in ((k.qdot, record.first), (k.qddot, record.second)):
        change = np.gradient(truth, record.dt)[inside]
        lag = -np.dot((found - truth)[inside], change) / np.dot(change, change)
        assert abs(lag) < 0.1 * record.dt


@pytest.mark.parametrize("kwargs", METHODS)
def test_unit_does_not_matter(kwargs: dict[str, object]) -> None:
    record, samples = noisy_ring_down(n=1500)
    millimetres = differentiate(samples, record.dt, **kwargs)
    metres = differentiate(1e-3 * samples, record.dt, **kwargs)
    np.testing.assert_allclose(1e3 * metres.qdot, millimetres.qdot, atol=1e-3 * rms(record.first))
    np.testing.assert_allclose(1e3 * metres.qddot, millimetres.qddot, atol=1e-3 * rms(record.second))


def test_paper_method_is_tvregdiff_applied_twice() -> None:
    _, samples = noisy_ring_down(n=800)
    k = differentiate(samples, 0.01, order=1, alpha=0.01, epsilon=1e-6)
    velocity = tvregdiff(samples, 0.01, alpha=0.01, epsilon=1e-6)
    acceleration = tvregdiff(velocity.derivative, 0.01, alpha=0.01, epsilon=1e-6)
    np.testing.assert_array_equal(k.qdot, velocity.derivative)
    np.testing.assert_array_equal(k.qddot, acceleration.derivative)
    assert (k.alpha, k.epsilon) == (0.01, 1e-6)


@pytest.mark.parametrize("kwargs", METHODS)
@pytest.mark.parametrize("n", range(1, 16))
def test_short_records(kwargs: dict[str, object], n: int) -> None:
    t = 1e-3 * np.arange(n)
    noise = 1e-6 * np.random.default_rng(n).standard_normal(n)
    for samples in (np.full(n, 2.0), 2.0 + 3.0 * t, 2.0 + 3.0 * t + noise):
        k = differentiate(samples, 1e-3, **kwargs)
        assert k.qdot.shape == k.qddot.shape == (n,)
        assert np.isfinite(k.qdot).all() and np.isfinite(k.qddot).all()
        if n > 1:
            slope = 0.0 if np.ptp(samples) == 0.0 else 3.0
            assert np.abs(k.qdot - slope).max() < 0.2


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_noiseless_record(order: int) -> None:
    record = signals.chirp(3000)
    k = differentiate(record.value, record.dt, order=order)
    assert rms(k.qdot - record.first) < 2e-3 * rms(record.first)
    assert rms(k.qddot - record.second) < 2e-3 * rms(record.second)


@pytest.mark.parametrize("step", [1e-4, 3e-4, 0.01])
def test_quantised_record(step: float) -> None:
    record = signals.ring_down(4000, frequencies=(2.8, 6.0))
    k = differentiate(step * np.round(record.value / step), record.dt)
    assert k.converged
    assert k.noise_std == pytest.approx(step / np.sqrt(12.0), rel=0.5)
    assert rms(k.qdot - record.first) < 0.02 * rms(record.first)
    assert rms(k.qddot - record.second) < 0.2 * rms(record.second)


def test_hum_is_not_amplified() -> None:
    record, samples = noisy_ring_down(0.001)
    hum, w = 0.005, 2.0 * np.pi * 50.0
    t = record.dt * np.arange(samples.size)
    k = differentiate(samples + hum * np.sin(w * t), record.dt)
    clean = differentiate(samples, record.dt)
    assert rms(k.qddot - clean.qddot) < 1.2 * hum * w**2 / np.sqrt(2.0)
    assert rms(k.qdot - clean.qdot) < 1.2 * hum * w / np.sqrt(2.0)


@pytest.mark.parametrize(
    ("samples", "kwargs", "word"),
    [
        (np.array([]), {}, "finite"),
        (np.zeros((3, 2)), {}, "shape"),
        (np.array([0.0, np.nan, 1.0]), {}, "gaps"),
        (np.arange(9.0), {"method": "spline"}, "spline"),
        (np.arange(9.0) ** 2, {"alpha": -1.0}, "alpha"),
    ],
)
def test_bad_input(samples: FloatArray, kwargs: dict[str, object], word: str) -> None:
    with pytest.raises(InputError, match=word):
        differentiate(samples, 1e-3, **kwargs)


# ------------------------------------------------------------------ finite differences


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6, 7, 8, 50])
@pytest.mark.parametrize("derivative", [1, 2])
def test_finite_differences_are_exact_for_cubics_everywhere(n: int, derivative: int) -> None:
    t = 0.1 * np.arange(n) - 0.3
    coefficients = np.arange(1.0, min(n, 4) + 1.0)
    expected = np.polyval(np.polyder(coefficients, derivative), t) if n > derivative else np.zeros(n)
    np.testing.assert_allclose(finite_difference(np.polyval(coefficients, t), 0.1, derivative), expected, atol=1e-8)


@pytest.mark.parametrize("derivative", [1, 2])
def test_finite_differences_are_exact_for_the_sixth_degree_inside(derivative: int) -> None:
    t = 0.1 * np.arange(50) - 0.3
    coefficients = np.arange(1.0, 8.0)
    expected = np.polyval(np.polyder(coefficients, derivative), t)[3:-3]
    found = finite_difference(np.polyval(coefficients, t), 0.1, derivative)[3:-3]
    np.testing.assert_allclose(found, expected, rtol=1e-9)


@pytest.mark.parametrize("place", np.linspace(-0.4, 0.4, 8))
def test_no_stencil_reaches_across_a_jump_of_the_acceleration(place: float) -> None:
    """A parabola that begins anywhere between two samples, on a slow sine: both branches come out."""
    t = np.arange(-30.0, 31.0)
    since = np.maximum(t - place, 0.0)
    x = 0.5 * since**2 + np.sin(0.02 * t)
    velocity, acceleration = since + 0.02 * np.cos(0.02 * t), (since > 0.0) - 4e-4 * np.sin(0.02 * t)
    np.testing.assert_allclose(finite_difference_at_jumps(x, 1.0, 1), velocity, atol=1e-6)
    np.testing.assert_allclose(finite_difference_at_jumps(x, 1.0, 2), acceleration, atol=1e-6)
    assert np.abs(finite_difference(x, 1.0, 2) - acceleration).max() > 0.05


# ------------------------------------------------------------------ noise and parameters


def test_noise_of_a_moving_record() -> None:
    for noise in (3e-4, 3e-3, 1e-2):
        _, samples = noisy_ring_down(noise)
        assert noise_std(samples) == pytest.approx(noise, rel=0.07)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_effective_parameters_are_the_trace_of_the_smoother(order: int) -> None:
    n, delta = 60, 0.2
    lam = np.linspace(0.5, 3.0, n - order - 1)
    t = np.zeros(n)
    t[order + 1 :] = np.random.default_rng(order).standard_normal(n - order - 1)
    difference = np.diff(np.eye(n), order + 1, axis=0)
    weights = 1.0 / np.sqrt(t[order + 1 :] ** 2 + delta**2)
    trace = np.trace(np.linalg.inv(np.eye(n) + difference.T @ ((lam * weights)[:, None] * difference)))
    assert effective_parameters(t, np.append(np.ones(order + 1), lam), delta, order) == pytest.approx(trace - order - 1)


@pytest.mark.parametrize("order", [2, 3])
@pytest.mark.parametrize("noise", [3e-4, 1e-2])
def test_automatic_alpha_is_near_the_best(order: int, noise: float) -> None:
    """Against the truth, which the choice does not know: no alpha on a grid beats it by much."""
    record, samples = noisy_ring_down(noise, n=3000)
    automatic = differentiate(samples, record.dt, order=order)
    how = {"order": order, "epsilon": automatic.epsilon}
    errors = [
        rms(differentiate(samples, record.dt, alpha=factor * automatic.alpha, **how).qdot - record.first)
        for factor in np.geomspace(1e-3, 1e3, 13)
    ]
    assert rms(automatic.qdot - record.first) < 1.6 * min(errors)
    assert rms(automatic.qdot - record.first) < 0.4 * max(errors)


def without_reweighting(samples: FloatArray, dt: float, order: int) -> Kinematics:
    chosen = smoothing_parameter(samples, dt, order)
    return differentiate(samples, dt, order=order, alpha=chosen.alpha, epsilon=chosen.epsilon)


@pytest.mark.parametrize("order", [3, 4])
@pytest.mark.parametrize("noise", [3e-4, 3e-3, 1e-2])
def test_reweighting_keeps_jumps_of_the_acceleration(order: int, noise: float) -> None:
    record = signals.ring_down()
    samples = record.noisy(noise, np.random.default_rng(7))
    plain, reweighted = without_reweighting(samples, record.dt, order), differentiate(samples, record.dt, order=order)
    assert reweighted.converged
    assert rms(reweighted.qdot - record.first) < 0.65 * rms(plain.qdot - record.first)
    assert rms(reweighted.qddot - record.second) < 0.8 * rms(plain.qddot - record.second)


@pytest.mark.parametrize("record", [signals.sine(), signals.chirp()], ids=lambda record: record.name)
@pytest.mark.parametrize("noise", [1e-3, 1e-2])
def test_reweighting_leaves_smooth_records_alone(record: signals.Signal, noise: float) -> None:
    samples = record.noisy(noise, np.random.default_rng(7))
    plain, reweighted = without_reweighting(samples, record.dt, 3), differentiate(samples, record.dt)
    assert rms(reweighted.qdot - record.first) < 1.05 * rms(plain.qdot - record.first)
    assert rms(reweighted.qddot - record.second) < 1.05 * rms(plain.qddot - record.second)


def test_alpha_study_shows_over_and_under_smoothing() -> None:
    record, samples = noisy_ring_down(n=1000)
    study = alpha_study(samples, record.dt, np.geomspace(1e-7, 1.0, 8))
    assert study.qdot.shape == study.qddot.shape == (8, 1000)
    assert (np.diff(study.misfit) > 0.0).all()
    assert study.misfit[0] < study.automatic.noise_std < study.misfit[-1]
    assert study.roughness[0] > 3.0 * study.roughness[-1]
    errors = [rms(qdot - record.first) for qdot in study.qdot]
    assert 0 < int(np.argmin(errors)) < 7
