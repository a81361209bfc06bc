"""The chain of summators behind variation problems of any order: covariances of its filter, effective parameters.

With ``t`` the (m+1)-th difference of y, the state ``s_i = (y, ∇y, …, ∇^m y)_i`` of backward differences obeys
``s_i = F (s_{i−1} + e_m t_i)`` with F the upper triangle of ones: multiplication by F is a cumulative sum from the
highest difference down, by Fᵀ one from the lowest up.  Measured is ``y_i`` with unit variance; t_i is noise of
variance v_i.  The first m + 1 samples fix the state.

Covariances are kept exactly symmetric: an asymmetry from rounding would be amplified from sample to sample.
"""

import math

import numpy as np

from .arrays import FloatArray
from .compiled import compiled, inner


def difference_weights(order: int) -> FloatArray:
    """Weight of sample j of the first m + 1 in ``∇^k y`` at the last of them, shape (m+1, m+1)."""
    weights = np.zeros((order + 1, order + 1))
    weights[0, order] = 1.0
    for k in range(1, order + 1):
        for j in range(order + 1):
            weights[k, j] = weights[k - 1, j] - (weights[k - 1, j + 1] if j < order else 0.0)
    return weights


def start_covariance(weights: FloatArray, first_variance: float) -> FloatArray:
    """Covariance of the state after the first m + 1 samples, the very first of variance `first_variance`."""
    covariance = np.empty(weights.shape)
    for k in range(weights.shape[0]):
        for l in range(weights.shape[0]):
            covariance[k, l] = first_variance * weights[k, 0] * weights[l, 0]
            for j in range(1, weights.shape[1]):
                covariance[k, l] += weights[k, j] * weights[l, j]
    return covariance


@inner
def advance_covariance(covariance: FloatArray, variance: float, gains: FloatArray) -> float:
    """One sample: predict with noise of `variance`, measure; write the m + 1 gains, return 1/(innovation variance)."""
    order = covariance.shape[0] - 1
    covariance[order, order] += variance
    for k in range(order - 1, -1, -1):
        for l in range(order + 1):
            covariance[k, l] += covariance[k + 1, l]
    for l in range(order - 1, -1, -1):
        for k in range(order + 1):
            covariance[k, l] += covariance[k, l + 1]
    inverse = float(1.0 / (covariance[0, 0] + 1.0))
    for k in range(order + 1):
        gains[k] = covariance[k, 0] * inverse
    for k in range(1, order + 1):
        for l in range(k, order + 1):
            covariance[k, l] -= gains[k] * covariance[0, l]
            covariance[l, k] = covariance[k, l]
    for k in range(order + 1):
        covariance[0, k] = gains[k]
        covariance[k, 0] = gains[k]
    return inverse


def effective_parameters(t: FloatArray, lam: FloatArray, delta: float, order: int) -> float:
    """Effective number of the differences `t` that the data determine, the trace of the smoother less m + 1.

    The smoother is that of the variances ``v_i = sqrt(t_i² + delta²)/lam_i``, whose estimate the minimiser of
    the variation problem is; difference i counts ``1 − (variance given the data)/v_i``, between 0 (the prior decides)
    and 1 (the data decide).

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Differences of the minimiser [signal], zero in the first m + 1 places.
    lam : FloatArray, shape (N,)
        Weights of the variation's terms [signal].
    delta : float
        Their rounding [signal].
    order : int
        m.

    Returns
    -------
    float
        Between 0 and N − m − 1.

    Notes
    -----
    One sweep forward for the gains and one backward for the adjoint's covariance (Durbin & Koopman 2012,
    eq. 4.42), about 3 (m+1)² multiplications and additions each per sample, (m + 2) N doubles.
    """
    size = order + 1
    room = np.empty((t.size, size + 1)), np.zeros((size, size)), np.zeros(size)
    return float(_determined(t, lam, delta, start_covariance(difference_weights(order), 1.0), *room))


@compiled
def _determined(
    t: FloatArray, lam: FloatArray, delta: float, covariance: FloatArray, gains: FloatArray, adjoint: FloatArray,
    product: FloatArray,
) -> float:  # fmt: skip
    n = t.size
    order = len(product) - 1
    size = order + 1
    for i in range(size, n):
        variance = math.sqrt(t[i] * t[i] + delta * delta) / lam[i]
        gains[i, size] = advance_covariance(covariance, variance, gains[i, :size])
    total = 0.0
    for i in range(n - 1, order, -1):
        quadratic = 0.0
        for k in range(size):
            product[k] = 0.0
            for l in range(size):
                product[k] += adjoint[k, l] * gains[i, l]
            quadratic += product[k] * gains[i, k]
        for k in range(size):
            adjoint[0, k] -= product[k]
            adjoint[k, 0] -= product[k]
        adjoint[0, 0] += gains[i, size] + quadratic
        for k in range(1, size):
            for l in range(size):
                adjoint[k, l] += adjoint[k - 1, l]
        for l in range(1, size):
            for k in range(size):
                adjoint[k, l] += adjoint[k, l - 1]
        for k in range(1, size):
            for l in range(k):
                adjoint[k, l] = adjoint[l, k]
        total += math.sqrt(t[i] * t[i] + delta * delta) / lam[i] * adjoint[order, order]
    return total
