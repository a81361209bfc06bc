"""Online identification (§ 4.1): the weights of eq. 40 over a stream of samples, their convergence and their tracking.

The model is linear in its weights once the lag T_z is known, so recursive least squares can follow a joint while it
runs. Two questions decide whether that is of use. How long must a stream be until the curves are those of the whole
log? How fast and how noisily do they follow a joint that changes?

The information is carried as the triangular factor R of the exponentially weighted normal equations (QR-RLS; Haykin,
Adaptive Filter Theory, ch. 15). Unlike the covariance form P ← (P − K ψᵀP)/λ it never loses symmetry or definiteness,
however long the stream is and however poorly it excites.
"""

from itertools import pairwise

import numpy as np
import scipy.linalg

from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms

RIDGE = 1e-3
"""δ, weight of the starting value θ = 0."""
LOOKS = 120
"""Number of times at which the errors are measured."""


def follow(
    regressors: FloatArray, target: FloatArray, force: FloatArray, true_force: FloatArray, *, forgetting: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Feed a stream to recursive least squares, which minimises Σ_n λ^(N−n) (y_n − ψ_nᵀθ)² + λ^N δ² ‖S θ‖².

    S has the RMS of each column, so that the ridge δ is a pure number.

    Parameters
    ----------
    regressors : FloatArray, shape (N, P)
        Rows of eq. 40.
    target : FloatArray, shape (N,)
        m q̈ [N].
    force : FloatArray, shape (G, P)
        Rows that give the restoring force F [N] at G displacements.
    true_force : FloatArray, shape (N, G)
        F at each sample: constant rows, or those of a joint that drifts.
    forgetting : float
        λ in (0, 1]; the memory is 1/(1 − λ) samples.

    Returns
    -------
    samples : FloatArray, shape (K,)
        Samples taken in at each of K looks.
    curve_error : FloatArray, shape (K,)
        RMS over q of the estimated less the true restoring force, over the range of the true one.
    prediction_error : FloatArray, shape (K,)
        RMS since the last look of the acceleration predicted before its sample was taken in, over the RMS of all.
    """
    scales = np.maximum(np.sqrt(np.mean(regressors**2, axis=0)), 1e-300)
    factor = np.column_stack([np.diag(RIDGE * scales), np.zeros(len(scales))])
    stream = np.column_stack([regressors, target])
    span = np.ptp(true_force[0])
    usual = max(rms(target), 1e-300)
    weights = np.zeros(len(scales))
    rows = []
    for first, last in pairwise(np.unique(np.linspace(0, len(target), LOOKS + 1).astype(int))):
        error = target[first:last] - regressors[first:last] @ weights
        forgotten = forgetting ** (0.5 * np.arange(last - first, -1, -1))[:, None]
        block = np.vstack([forgotten[0] * factor, forgotten[1:] * stream[first:last]])
        factor = scipy.linalg.qr(block, mode="r")[0][: len(scales)]
        weights = scipy.linalg.solve_triangular(factor[:, :-1] / scales, factor[:, -1]) / scales
        rows.append((float(last), rms(force @ weights - true_force[last - 1]) / span, rms(error) / usual))
    samples, curve_error, prediction_error = np.array(rows).T
    return samples, curve_error, prediction_error


def drifted(
    regressors: FloatArray, target: FloatArray, weights: FloatArray, count: int, share: float
) -> tuple[FloatArray, FloatArray]:
    """The motion of a joint whose restoring force grows by a `share` of itself from first to last sample.

    Parameters
    ----------
    regressors : FloatArray, shape (N, P)
        Rows of eq. 40, of which the first `count` columns belong to c(q) q.
    target : FloatArray, shape (N,)
        m q̈ [N].
    weights : FloatArray, shape (P,)
        Of the whole log.
    count : int
        Columns of c(q) q.
    share : float
        Growth of c(q) q, as a share.

    Returns
    -------
    target : FloatArray, shape (N,)
        m q̈ with the drift planted.
    growth : FloatArray, shape (N,)
        Factor of the restoring force at each sample.
    """
    growth = 1.0 + share * np.linspace(0.0, 1.0, len(target))
    return target + (growth - 1.0) * (regressors[:, :count] @ weights[:count]), growth
