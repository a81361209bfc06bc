"""Sparse regression on a library compressed to triangular factors, one factor per block of time.

The optimisers are those of pysindy, and one that obeys sign constraints.

Sparse regression works on ΘᵀΘ and Θᵀy only, so the N×P library Θ with the target y may be replaced by the triangular
factor R of ``[Θ y]``: same minimiser from P + 1 rows instead of N. A grid of hyperparameters then costs milliseconds,
and blocks are resampled or left out by stacking their factors.
Cost: the factors 2NP² flops once; then every fit O(BP³) for B stacked blocks.
"""

import importlib
import warnings
from collections.abc import Callable, Sequence
from typing import Literal

import numpy as np
import scipy.linalg
import scipy.optimize
from scipy.linalg import LinAlgError, cho_factor, cho_solve

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
from pipeline.numerics.least_squares import triangular_factor

_MOST_ROUNDS = 50
"""Of dropping terms; the support as the last one left it is taken."""


def stlsq(library: FloatArray, target: FloatArray, threshold: float, ridge: float) -> FloatArray:
    """Sparse coefficients c of ``target ≈ library c`` (Brunton, Proctor & Kutz 2016, doi:10.1073/pnas.1517384113).

    The method and its result are pysindy's `STLSQ`, to which a test compares it; a fit of twenty terms takes 0.1 ms
    here and 7 ms there, nearly all of it in checks of the arguments, and a search makes hundreds of fits.

    Ridge regression on the terms that are left, of which those below `threshold` are dropped, until none is; then
    least squares without the ridge on what is left.

    Parameters
    ----------
    library : FloatArray, shape (N, P)
        Values of the terms, or the triangular factor of them and the target.
    target : FloatArray, shape (N,)
        What they shall add up to.
    threshold : float
        Smallest magnitude of a coefficient that is kept.
    ridge : float
        Penalty on the sum of squares of the coefficients.

    Returns
    -------
    FloatArray, shape (P,)
        Zero where a term is dropped.
    """
    normal, right = library.T @ library, library.T @ target
    kept = np.ones(library.shape[1], dtype=bool)
    for _ in range(_MOST_ROUNDS):
        coefficients = np.zeros(kept.size)
        coefficients[kept] = _ridge(normal[np.ix_(kept, kept)], right[kept], ridge)
        left = kept & (np.abs(coefficients) >= threshold)
        if not left.any() or (left == kept).all():
            kept = left
            break
        kept = left
    coefficients = np.zeros(kept.size)
    if kept.any():
        coefficients[kept] = np.linalg.lstsq(library[:, kept], target, rcond=None)[0]
    return coefficients


def _ridge(normal: FloatArray, right: FloatArray, ridge: float) -> FloatArray:
    penalised = normal + ridge * np.eye(len(normal))
    try:
        return np.asarray(cho_solve(cho_factor(penalised, check_finite=False), right, check_finite=False))
    except LinAlgError:  # a penalty far below the rounding of the squares
        return np.asarray(np.linalg.lstsq(penalised, right, rcond=None)[0])


Optimizer = Literal["STLSQ", "SR3", "constrained", "ensemble"]
RIDGE = 1e-3  # on coefficients of order 1 against thousands of rows: regularises, biases below 1e-6
ENSEMBLE_MEMBERS = 20
INCLUSION = 0.6  # share of the members that must keep a term (Fasel et al. 2022, doi:10.1098/rspa.2021.0904)


def sparse_coefficients(
    factors: Sequence[FloatArray],
    optimizer: Optimizer,
    threshold: float,
    rng: np.random.Generator,
    signs: Callable[[], FloatArray],
) -> FloatArray:
    """Sparse coefficients of ``y ≈ Θ c`` from the factors of its blocks.

    Parameters
    ----------
    factors : sequence of FloatArray, shape (·, P + 1)
        `least_squares.triangular_factor` of ``[Θ y]`` for each block of time.
    optimizer : {"STLSQ", "SR3", "constrained", "ensemble"}
        Sequentially thresholded least squares, pysindy's relaxed regression with an L0 penalty (its hard
        threshold sqrt(2λν) set to `threshold`), thresholded least squares under sign constraints (pysindy's own needs
        cvxpy), or STLSQ bagged over blocks of time, since neighbouring samples are no independent draws: terms that
        most members keep are fitted once more without a penalty.
    threshold : float
        Smallest magnitude of a coefficient that is kept.
    rng : numpy.random.Generator
        Draws the blocks of the ensemble.
    signs : callable
        Gives `sign_rows`, which the constrained optimizer obeys.

    Returns
    -------
    FloatArray, shape (P,)
        Zero where a term is dropped.
    """
    if optimizer == "constrained":
        return thresholded(_stack(factors), signs(), threshold, RIDGE)
    if optimizer == "SR3":
        return _relaxed(threshold, _stack(factors))
    if optimizer == "STLSQ":
        return _thresholded(threshold, _stack(factors))
    members = np.array(
        [
            _thresholded(threshold, _stack([factors[i] for i in draw]))
            for draw in rng.integers(len(factors), size=(ENSEMBLE_MEMBERS, len(factors)))
        ]
    )
    kept = np.mean(members != 0.0, axis=0) >= INCLUSION
    stacked = _stack(factors)
    coefficients = np.zeros(stacked.shape[1] - 1)
    coefficients[kept] = np.linalg.lstsq(stacked[:, :-1][:, kept], stacked[:, -1], rcond=None)[0]
    return coefficients


def _stack(factors: Sequence[FloatArray]) -> FloatArray:
    return factors[0] if len(factors) == 1 else triangular_factor([np.vstack(factors)])[0]


def _thresholded(threshold: float, factor: FloatArray) -> FloatArray:
    return stlsq(factor[:, :-1], factor[:, -1], threshold, RIDGE)


def _relaxed(threshold: float, factor: FloatArray) -> FloatArray:
    pysindy = importlib.import_module("pysindy")  # a second of import, so only when something is fitted
    optimizer = pysindy.SR3(reg_weight_lam=threshold**2 / 2.0, relax_coeff_nu=1.0, max_iter=300, unbias=True)
    with warnings.catch_warnings():
        # "all coefficients eliminated" and "did not converge" are judged by the free run, like any poor candidate
        warnings.simplefilter("ignore", UserWarning)
        optimizer.fit(factor[:, :-1], factor[:, -1:])
    coefficients: FloatArray = np.asarray(optimizer.coef_, dtype=np.float64)[0]
    return coefficients


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
