"""Sparse regression on a library compressed to triangular factors, one factor per block of time.

The optimisers are those of pysindy, and one that obeys sign constraints.

Sparse regression works on ΘᵀΘ and Θᵀy only, so the N×P library Θ with the target y may be replaced by the triangular
factor R of ``[Θ y]``: same minimiser from P + 1 rows instead of N. A grid of hyperparameters then costs milliseconds,
and blocks are resampled or left out by stacking their factors.
Cost: the factors 2NP² flops once; then every fit O(BP³) for B stacked blocks.
"""

import warnings
from collections.abc import Sequence
from typing import Literal

import numpy as np
from scipy.linalg import LinAlgError, cho_factor, cho_solve

from pipeline.baselines.constrained_regression import thresholded
from pipeline.numerics.arrays import FloatArray


def stlsq(library: FloatArray, target: FloatArray, threshold: float, ridge: float, max_iter: int = 50) -> FloatArray:
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
    max_iter : int
        Most rounds; the support as the last one left it is taken.

    Returns
    -------
    FloatArray, shape (P,)
        Zero where a term is dropped.
    """
    normal, right = library.T @ library, library.T @ target
    kept = np.ones(library.shape[1], dtype=bool)
    for _ in range(max_iter):
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
    signs: FloatArray,
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
    signs : FloatArray, shape (R, P)
        `sign_rows`, which the constrained optimizer obeys.

    Returns
    -------
    FloatArray, shape (P,)
        Zero where a term is dropped.
    """
    if optimizer == "constrained":
        return thresholded(_stack(factors), signs, threshold, RIDGE)
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
    return _upper(np.vstack(factors))


def _upper(rows: FloatArray) -> FloatArray:
    factor: FloatArray = np.asarray(np.linalg.qr(rows, mode="r"))
    return factor


def _thresholded(threshold: float, factor: FloatArray) -> FloatArray:
    return stlsq(factor[:, :-1], factor[:, -1], threshold, RIDGE)


def _relaxed(threshold: float, factor: FloatArray) -> FloatArray:
    import pysindy  # 2.7 s of import, so only when something is fitted

    optimizer = pysindy.SR3(reg_weight_lam=threshold**2 / 2.0, relax_coeff_nu=1.0, max_iter=300, unbias=True)
    with warnings.catch_warnings():
        # "all coefficients eliminated" and "did not converge" are judged by the free run, like any poor candidate
        warnings.simplefilter("ignore", UserWarning)
        optimizer.fit(factor[:, :-1], factor[:, -1:])
    coefficients: FloatArray = np.asarray(optimizer.coef_, dtype=np.float64)[0]
    return coefficients
