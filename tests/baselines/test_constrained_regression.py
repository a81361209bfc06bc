"""Least squares under sign constraints: optimality against a general solver, and an equation that makes no energy."""

import numpy as np
import pytest
import scipy.optimize

from pipeline.baselines.polynomial_dynamics import COSINE, FRICTION, LAG, QDOT, Q, monomials, scaled_variables
from pipeline.baselines.sindy_problem import Library
from pipeline.baselines.sparse_regression import constrained_least_squares, sign_rows, thresholded

SCALES = np.array([0.01, 0.2, 0.2, 0.02, 1.0, 1.0, 9e6, 9e6])


@pytest.mark.parametrize("seed", range(5))
def test_the_minimum_is_that_of_a_general_solver(seed: int) -> None:
    rng = np.random.default_rng(seed)
    theta, y, signs = rng.normal(size=(60, 6)), rng.normal(size=60), rng.normal(size=(9, 6))
    found = constrained_least_squares(theta, y, signs, 1e-3)

    def cost(c: np.ndarray) -> float:
        return float(np.sum((theta @ c - y) ** 2) + 1e-3 * np.sum(c**2))

    other = scipy.optimize.minimize(
        cost, np.zeros(6), method="SLSQP", options={"ftol": 1e-14},
        constraints={"type": "ineq", "fun": lambda c: signs @ c},
    )  # fmt: skip
    assert np.all(signs @ found >= -1e-9)
    assert cost(found) <= cost(other.x) + 1e-8
    np.testing.assert_allclose(found, other.x, atol=2e-5)


def test_constraints_that_the_data_obey_change_nothing() -> None:
    rng = np.random.default_rng(1)
    theta = rng.normal(size=(60, 4))
    y = theta @ np.array([1.0, 2.0, 3.0, 4.0])
    np.testing.assert_allclose(constrained_least_squares(theta, y, np.eye(4), 1e-12), [1.0, 2.0, 3.0, 4.0], rtol=1e-9)


def test_rows_say_resistance_and_restoring_force_in_their_own_units() -> None:
    """q̈ = a q̇ + b z + c tanh + e q³: G c ≥ 0 means a ≤ 0, a + b ≤ 0, c ≤ 0, e ≤ 0, whatever the scales."""
    exponents = np.zeros((4, 8), dtype=np.int64)
    exponents[[0, 1, 2, 3], [QDOT, LAG, FRICTION, Q]] = [1, 1, 1, 3]
    scales = SCALES.copy()
    scales[LAG] = 0.5  # another scale than q̇
    signs = sign_rows(exponents, scales, (-0.01, 0.012), (-0.05, 0.05))

    def allowed(a: float, b: float, c: float, e: float) -> bool:
        scaled = np.array([a * scales[QDOT], b * scales[LAG], c, e * scales[Q] ** 3])
        return bool(np.all(signs @ scaled >= -1e-12))

    assert allowed(-1.0, 0.9, -1.0, -1.0) and allowed(-1.0, -5.0, 0.0, 0.0)
    assert not allowed(0.1, -1.0, -1.0, -1.0)
    assert not allowed(-1.0, 1.1, -1.0, -1.0)
    assert not allowed(-1.0, 0.0, 0.1, -1.0)
    assert not allowed(-1.0, 0.0, -1.0, 0.1)


def test_an_undamped_oscillator_with_noise_gets_no_negative_damping() -> None:
    """Of 40 noisy records, plain least squares finds negative damping in many and the constrained fit in none."""
    exponents = Library("polynomial", 3, False, False, 0.0, 0).exponents(2)
    t = np.linspace(0.0, 6.0, 300)
    q, qdot = 0.01 * np.cos(17.0 * t), -0.17 * np.sin(17.0 * t)
    variables = scaled_variables(SCALES, True, np.zeros((300, 2)), q, qdot, np.zeros(300))
    library = monomials(exponents, variables)
    signs = sign_rows(exponents, SCALES, (-0.01, 0.01), (-0.05, 0.05))
    grid = np.linspace(-0.01, 0.01, 50)
    at_rest = scaled_variables(SCALES, True, np.zeros((50, 2)), grid, np.full(50, SCALES[QDOT]), np.zeros(50))
    still = scaled_variables(SCALES, True, np.zeros((50, 2)), grid, np.zeros(50), np.zeros(50))
    slope = monomials(exponents, at_rest) - monomials(exponents, still)
    assert not exponents[:, COSINE].any()
    given: dict[str, list[float]] = {"plain": [], "constrained": []}
    for seed in range(40):
        y = -(17.0**2) * q / 2.0 + 0.3 * np.random.default_rng(seed).normal(size=300)
        factor = np.linalg.qr(np.column_stack([library, y]), mode="r")
        fits = {
            "plain": np.linalg.lstsq(library, y, rcond=None)[0],
            "constrained": thresholded(factor, signs, 0.0, 1e-3),
        }
        for name, fit in fits.items():
            given[name].append(max(0.0, float(np.max(slope @ fit))))
    assert np.mean(np.array(given["plain"]) > 0.0) > 0.5
    assert np.max(given["constrained"]) < 0.02 * np.median(given["plain"])  # between the points of the grid


def test_small_terms_are_dropped_and_nothing_may_be_left() -> None:
    theta = np.random.default_rng(4).normal(size=(200, 3))
    factor = np.linalg.qr(np.column_stack([theta, theta @ np.array([1.0, 0.01, -2.0])]), mode="r")
    np.testing.assert_allclose(thresholded(factor, np.zeros((1, 3)), 0.1, 1e-9), [1.0, 0.0, -2.0], atol=1e-3)
    np.testing.assert_array_equal(thresholded(factor, np.zeros((1, 3)), 5.0, 1e-9), 0.0)
