"""The weak form of the planted equation, and which terms a library admits."""

import numpy as np

from pipeline.models.polynomial_dynamics import Q
from pipeline.models.sindy.weak_form import weak_rows
from pipeline.numerics.arrays import FloatArray

RATE = 8.0  # rad/s


def _oscillation(samples: int) -> tuple[FloatArray, FloatArray]:
    """Variables of q = sin ωt without input, and its velocity."""
    t = 0.002 * np.arange(samples)
    q, qdot = np.sin(RATE * t), RATE * np.cos(RATE * t)
    x = np.column_stack([q, qdot, np.tanh(qdot), np.sin(q), np.cos(q), np.zeros_like(q)])
    return x, qdot


def test_both_sides_of_an_oscillation_agree() -> None:
    """q̈ = −ω² q: integrated by parts, the target is −ω² times the column of q."""
    x, qdot = _oscillation(2000)
    exponents, rows, target = weak_rows(x, qdot, 0.002, 0.1, 40, angle=False)
    column = int(np.flatnonzero((exponents[:, Q] == 1) & (exponents.sum(axis=1) == 1))[0])
    np.testing.assert_allclose(target, -(RATE**2) * rows[:, column], rtol=1e-4, atol=1e-4 * np.abs(target).max())
