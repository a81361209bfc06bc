"""The weak form of the planted equation, and which terms a library admits."""

import numpy as np

from pipeline.models.polynomial_dynamics import FIRST_INPUT, FRICTION, QDOT, Q
from pipeline.models.sindy.weak_form import admitted, weak_rows
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


def test_a_library_admits_no_term_above_its_degrees() -> None:
    x, qdot = _oscillation(300)
    x = np.column_stack([x, x[:, QDOT], x[:, FIRST_INPUT]])  # two lag states
    exponents, _, _ = weak_rows(x, qdot, 0.002, 0.1, 2, angle=True)
    lag = FIRST_INPUT + 1
    terms = exponents[admitted(exponents, 1, (3, 1, 2), friction=False, turning=False, lags={lag})]
    alone = terms[terms[:, 1:].sum(axis=1) == 0]
    assert sorted(alone[:, Q]) == [0, 1, 2, 3]
    assert sorted(terms[terms[:, QDOT] == 1][:, Q]) == [0, 1]
    assert sorted(terms[terms[:, FIRST_INPUT] == 1][:, Q]) == [0, 1, 2]
    assert sorted(terms[terms[:, lag] == 1][:, Q]) == [0, 1]
    assert not terms[:, [FRICTION, 3, 4, lag + 1]].any()
    circle = exponents[admitted(exponents, 1, (1, 0, 0), friction=True, turning=True, lags=set())]
    assert len(circle) == 3 + 3  # 1, sin q, cos q; q̇, tanh and u by themselves
