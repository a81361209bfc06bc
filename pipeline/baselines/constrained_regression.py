"""Sparse regression under sign constraints: an equation that neither creates energy nor lets the joint run away."""

import numpy as np
import scipy.linalg
import scipy.optimize

from pipeline.baselines.polynomial_dynamics import (
    COSINE,
    FRICTION,
    LAG,
    QDOT,
    SINE,
    monomials,
    scaled_variables,
)
from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray

GRID = 21  # displacements at which damping, lag and friction must resist
MOST_REFITS = 50


def sign_rows(
    exponents: IntArray, scales: FloatArray, visited: tuple[float, float], edges: tuple[float, float]
) -> FloatArray:
    """Rows G with ``G c ≥ 0`` for the coefficients c of the acceleration in scaled variables, shape (R, P).

    Over the visited range the resistance to motion near rest takes energy and gives none: with d = −∂q̈/∂q̇ and
    k = −∂q̈/∂z, the real part of d + k/(1 + iωT_z) is no less than zero at any frequency if and only if d ≥ 0 and
    d + k ≥ 0; dry friction resists too. At the edges, where a free run counts as diverged, the joint at rest is pulled
    back (for polynomials; a pendulum may go round). The signs of the inputs are left to the data: a probe may be wired
    either way.

    Parameters
    ----------
    exponents : IntArray, shape (P, 6 + K)
        Candidate terms.
    scales : FloatArray, shape (6 + K,)
        As in `PolynomialDynamics`.
    visited : (float, float)
        Range of q in the training data.
    edges : (float, float)
        Displacements below and above which a run counts as diverged.
    """
    x = _at_rest(np.linspace(*visited, GRID), scales)
    damping, lag, friction = (_resistance(exponents, x, variable) for variable in (QDOT, LAG, FRICTION))
    rows = [damping, damping * scales[LAG] + lag * scales[QDOT], friction]
    if not exponents[:, [SINE, COSINE]].any():
        rows.append(monomials(exponents, _at_rest(np.array(edges), scales)) * np.array([[1.0], [-1.0]]))
    return np.vstack(rows)


def _resistance(exponents: IntArray, x: FloatArray, variable: int) -> FloatArray:
    """−∂q̈/∂(variable) where that variable is zero, as rows for the coefficients."""
    linear = exponents[:, variable] == 1
    reduced = exponents.copy()
    reduced[:, variable] -= linear
    rows: FloatArray = -monomials(reduced, x) * linear
    return rows


def _at_rest(q: FloatArray, scales: FloatArray) -> FloatArray:
    """Scaled variables at displacements q without motion and without input."""
    rest = np.zeros_like(q)
    inputs = np.zeros((q.size, scales.size - COSINE - 1))
    return scaled_variables(scales, True, inputs, q, rest, rest)


def constrained_least_squares(theta: FloatArray, y: FloatArray, signs: FloatArray, ridge: float) -> FloatArray:
    """The c of least ``|Θ c − y|² + ridge |c|²`` with ``G c ≥ 0``.

    Reduced to the point of least distance from the unconstrained minimum in the metric of Θ, which is a non-negative
    least-squares problem (Lawson & Hanson 1995, Solving Least Squares Problems, chapter 23.4). c = 0 is always allowed.

    Parameters
    ----------
    theta : FloatArray, shape (N, P)
        Θ.
    y : FloatArray, shape (N,)
        What it shall give.
    signs : FloatArray, shape (R, P)
        G.
    ridge : float
        Positive, so that the minimum is unique.

    Returns
    -------
    FloatArray, shape (P,)
        Cost: a QR of N + P rows and a non-negative least-squares problem of R unknowns and P + 1 equations.
    """
    terms = theta.shape[1]
    stacked = np.vstack([theta, np.sqrt(ridge) * np.eye(terms)])
    q, r = scipy.linalg.qr(stacked, mode="economic")
    free = scipy.linalg.solve_triangular(r, q[: len(y)].T @ y)
    norms = np.linalg.norm(signs, axis=1)
    g = signs[norms > 0.0] / norms[norms > 0.0, None]
    if np.all(g @ free >= 0.0):
        return np.asarray(free)
    a = scipy.linalg.solve_triangular(r, g.T, trans="T")  # G R⁻¹, transposed
    equations = np.vstack([a, -(g @ free)])
    target = np.zeros(terms + 1)
    target[-1] = 1.0
    residual = equations @ scipy.optimize.nnls(equations, target)[0] - target
    step: FloatArray = scipy.linalg.solve_triangular(r, -residual[:terms] / residual[terms])
    return np.asarray(free + step)


def thresholded(factor: FloatArray, signs: FloatArray, threshold: float, ridge: float) -> FloatArray:
    """Sequentially thresholded least squares whose every refit obeys the signs, shape (P,).

    Parameters
    ----------
    factor : FloatArray, shape (P + 1, P + 1)
        Triangular factor of ``[Θ y]``.
    signs : FloatArray, shape (R, P)
        `sign_rows`.
    threshold : float
        Smallest magnitude of a coefficient that is kept.
    ridge : float
        Regularisation of each refit.
    """
    terms = factor.shape[1] - 1
    kept: BoolArray = np.ones(terms, dtype=bool)
    coefficients = np.zeros(terms)
    for _ in range(MOST_REFITS):
        coefficients = np.zeros(terms)
        if not kept.any():
            break
        coefficients[kept] = constrained_least_squares(factor[:, :-1][:, kept], factor[:, -1], signs[:, kept], ridge)
        large = np.abs(coefficients) >= threshold
        if np.array_equal(large & kept, kept):
            break
        kept = large & kept
    return coefficients
