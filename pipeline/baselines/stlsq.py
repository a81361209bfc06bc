"""Sequentially thresholded least squares (Brunton, Proctor & Kutz 2016, doi:10.1073/pnas.1517384113).

The method and its result are pysindy's `STLSQ`, to which a test compares it; a fit of twenty terms takes 0.1 ms here
and 7 ms there, nearly all of it in checks of the arguments, and a search makes hundreds of fits.
"""

import numpy as np
from scipy.linalg import LinAlgError, cho_factor, cho_solve

from pipeline.numerics.arrays import FloatArray


def stlsq(library: FloatArray, target: FloatArray, threshold: float, ridge: float, max_iter: int = 50) -> FloatArray:
    """Sparse coefficients c of ``target ≈ library c``.

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
