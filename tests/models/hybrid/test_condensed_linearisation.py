"""Exact Jacobians of the condensed joint against central differences of its rates."""

from collections.abc import Callable

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.generated.condensed_joint import SLIPS, STATES, STOP_ELEMENTS, STOPS
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.kernels import CURVES as CORRECTIONS, INDEX, VALUES, corrections_at, joint_rates, prepare
from pipeline.numerics.arrays import FloatArray
from tests.models.hybrid.linearisation import Linearised

BASIS = np.array([-0.02, 0.01, 0.008])
SIZE = np.array([0.01, 0.1, 0.1, 2.0, 0.05, 1.0, *9 * [0.01], *STOPS * [1.0]])
WIDTHS = condensed_parameters.correction_prior_std(NOMINAL)


def rates(y: FloatArray, u: FloatArray, k: FloatArray, weights: FloatArray) -> FloatArray:
    """Rates of state and stop operators that do not stick."""
    x, c, found = y[:STATES].copy(), np.empty(VALUES), np.empty(STATES)
    corrections_at(x[0], BASIS, weights, c)
    joint_rates(x, u, c, y[STATES:].copy(), x[[0, 2, 4]], prepare(k[None])[0], found)
    return np.concatenate([found, coordinates(y[[1, 3, 5]], k) / travels_of(k)])


def travels_of(k: FloatArray) -> FloatArray:
    return k[INDEX["stop_travel_0"] + np.array(STOP_ELEMENTS)]


def coordinates(shape: FloatArray, k: FloatArray) -> FloatArray:
    """Coordinates of the stop operators at (q, τ, β): friction's, then l²/6 times the curvature at Gauss's places."""
    q, tau, beta = shape
    l, polynomial = k[INDEX["l"]], np.polynomial.Polynomial
    xi = polynomial([0.0, 1.0])
    w = l * (q / l * (3 * xi**2 - 2 * xi**3) + tau * (xi**3 - xi**2) + beta * xi**2 * (1 - xi) ** 2)
    bent = w.deriv(2)(0.5 * (1.0 + np.polynomial.legendre.leggauss(3)[0])) / 6.0
    return np.concatenate([np.full(SLIPS, q + k[INDEX["friction_arm"]] * tau), np.repeat(bent, 2)])


def differences(function: Callable[[FloatArray], FloatArray], at: FloatArray, size: FloatArray) -> FloatArray:
    """Derivatives by central differences of fourth order, for entries moved by 1e-4 of their size."""
    columns = []
    for i, step in enumerate(1e-4 * size):
        ahead = np.zeros(len(at))
        ahead[i] = step
        near, far = function(at + ahead) - function(at - ahead), function(at + 2 * ahead) - function(at - 2 * ahead)
        columns.append((8.0 * near - far) / (12.0 * step))
    return np.array(columns).T


def off(found: FloatArray, expected: FloatArray, size: FloatArray) -> float:
    """Largest error of an effect as a share of the largest effect on the same rate."""
    effects = np.abs(expected * size).max(axis=1, keepdims=True) + 1e-30
    return float(np.max(np.abs(found - expected) * size / effects))


@pytest.mark.parametrize("seed", [0, 1, *(pytest.param(seed, marks=pytest.mark.long) for seed in (2, 3, 4))])
def test_jacobians_are_those_of_differences(seed: int) -> None:
    random = np.random.default_rng(seed)
    k = condensed_parameters.constants(NOMINAL, 0.5 * random.standard_normal(len(condensed_parameters.NAMES)), 1.26)
    weights = random.standard_normal((CORRECTIONS, 5)) * WIDTHS[:, None]
    y, u = random.standard_normal(STATES + STOPS) * SIZE, random.uniform(1e6, 9e6, 2)
    y[STATES:] = random.uniform(-0.9, 0.9, STOPS)
    found = Linearised(k, BASIS, weights, y[:STATES], y[STATES:], u)
    by_state = differences(lambda at: rates(at, u, k, weights), y, SIZE)
    np.testing.assert_allclose(found.f, rates(y, u, k, weights), rtol=1e-12, atol=1e-12 * np.abs(by_state @ SIZE).max())
    assert off(found.a, by_state, SIZE) < 1e-7
    by_input = differences(lambda at: rates(y, at, k, weights), u, np.full(2, 1e6))
    assert off(found.b, by_input, np.full(2, 1e6)) < 1e-7
    size = np.maximum(np.abs(k), 1e-3)
    size[INDEX["interior_inertia"]] = k[INDEX["interior_inertia"]]
    by_k = differences(lambda at: rates(y, u, at, weights), k, size)
    assert off(found.by_constants, by_k, size) < 1e-6  # 1e-7 and less but where a constant is near zero
    shares = np.repeat(WIDTHS, 5)
    by_weight = differences(lambda at: rates(y, u, k, at.reshape(CORRECTIONS, 5)), weights.ravel(), shares)
    assert off(found.by_weights.reshape(STATES + STOPS, -1), by_weight, shares) < 1e-7


def test_a_stop_operator_at_its_end_stays_there_until_the_motion_turns() -> None:
    k = condensed_parameters.constants(NOMINAL, np.zeros(len(condensed_parameters.NAMES)), 1.26)
    x, z, u = np.zeros(STATES), np.array([1.0, -1.0, *[0.5] * (STOPS - 2)]), np.zeros(2)
    x[1] = 0.1
    ahead = Linearised(k, BASIS, np.zeros((CORRECTIONS, 0)), x, z, u)
    travels = travels_of(k)
    np.testing.assert_allclose(ahead.f[STATES:], [0.0, *(coordinates(x[[1, 3, 5]], k) / travels)[1:]], atol=1e-9)
    assert ahead.a[STATES, 1] == 0.0
    assert ahead.a[STATES + 1, 1] == pytest.approx(1.0 / travels[1])
