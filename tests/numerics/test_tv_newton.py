"""The smoother's step against the dense Newton system that it stands for."""

import numpy as np
import pytest

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.tv_newton import Iterate, NewtonStep, newton_step


def dense_step(
    b: FloatArray, y: FloatArray, q: FloatArray, p: FloatArray, lam: FloatArray, delta: float, order: int, fitted: bool
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Chan, Golub & Mulet's Newton step by a dense solve."""
    difference = np.diff(np.eye(b.size), order + 1, axis=0)
    t = difference @ y
    r = np.sqrt(t**2 + delta**2)
    c = (1.0 - p * t / r) / r
    mu = (p - t / r) / c
    matrix = np.eye(b.size) + difference.T @ ((lam * c)[:, None] * difference)
    right = b - y - q + difference.T @ (lam * c * mu)
    dy = np.zeros(b.size)
    free = slice(0 if fitted else 1, None)
    dy[free] = np.linalg.solve(matrix[free, free], right[free])
    return dy, difference @ dy, t / r - p + c * (difference @ dy)


def objective(b: FloatArray, y: FloatArray, t: FloatArray, lam: FloatArray, delta: float) -> float:
    return float(np.sum(lam * (np.hypot(t, delta) - delta)) + 0.5 * np.sum((y - b) ** 2))


@pytest.mark.parametrize("order", [1, 2, 3, 4])
@pytest.mark.parametrize("fitted", [False, True])
@pytest.mark.parametrize("n", [6, 50, 200])
def test_smoother_is_the_newton_step(order: int, fitted: bool, n: int) -> None:
    rng = np.random.default_rng(n)
    b, y, q = np.cumsum(rng.standard_normal(n)), rng.standard_normal(n), rng.standard_normal(n)
    if not fitted:
        b[0] = y[0] = q[0] = 0.0
    t, p = np.zeros(n), np.zeros(n)
    t[order + 1 :] = np.diff(y, order + 1)
    p[order + 1 :] = rng.uniform(-0.95, 0.95, n - order - 1)
    lam, delta = 7.0 * rng.uniform(0.1, 1.0, n), 0.1
    expected = dense_step(b, y, q, p[order + 1 :], lam[order + 1 :], delta, order, fitted)
    full = objective(b, y + expected[0], np.append(np.zeros(order + 1), t[order + 1 :] + expected[1]), lam, delta)

    step = NewtonStep(*(np.empty(n) for _ in range(3)), np.empty((n, order + 2)))
    longest, value = newton_step(Iterate(b, y, t, q, p, lam), step, delta, order, float(fitted))
    dy, dt, dp, _ = step
    np.testing.assert_allclose(dy, expected[0], atol=1e-10)
    np.testing.assert_allclose(dt[order + 1 :], expected[1], atol=1e-10)
    np.testing.assert_allclose(dp[order + 1 :], expected[2], atol=1e-10)
    assert np.abs(p + longest * dp).max() == pytest.approx(1.0)
    assert value == pytest.approx(full)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_step_is_accurate_where_the_banded_matrix_is_singular(order: int) -> None:
    """With delta at 1e-20 of the data the matrix has a condition number of 1e20; the answer is a polynomial fit.

    Order 4 loses digits, which the next steps recover: each one solves for the rest of the one before.
    """
    n = 300
    i = np.arange(n)
    rng = np.random.default_rng(0)
    b = np.polyval(np.ones(order + 1), i / n) + rng.standard_normal(n)
    zero = np.zeros(n)
    step = NewtonStep(*(np.empty(n) for _ in range(3)), np.empty((n, order + 2)))
    newton_step(Iterate(b, zero, zero, zero, zero, np.ones(n)), step, 1e-20, order, 1.0)
    np.testing.assert_allclose(step.dy, np.polyval(np.polyfit(i, b, order), i), atol=1e-9 if order < 4 else 2e-6)
