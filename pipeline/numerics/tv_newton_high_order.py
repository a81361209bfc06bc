"""The Newton step of `tv_newton` for a variation of the second or third derivative.

With ``t`` the (m+1)-th difference of y the smoother's state is the backward differences
``s_i = (y, ∇y, …, ∇^m y)_i``, a chain of m+1 summators: ``s_i = F (s_{i−1} + e_m t_i)`` with F the upper triangle
of ones, so multiplication by F is a cumulative sum from the highest difference down, and by Fᵀ one from the lowest
up.  Everything else is as in `tv_newton.newton_step`, whose case is m = 1.

Cost model: two divisions, a square root and about (m+1)(m+4) multiplications and additions per sample and step.
"""

import math

import numpy as np
from numba import njit

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.tv_newton import one_minus_product


@njit(cache=True)
def newton_step_high_order(
    b: FloatArray,
    y: FloatArray,
    t: FloatArray,
    q: FloatArray,
    p: FloatArray,
    lam: float,
    delta: float,
    order: int,
    first_variance: float,
    dy: FloatArray,
    dt: FloatArray,
    dp: FloatArray,
    gains: FloatArray,
) -> float:
    """Write the Newton step into `dy`, `dt`, `dp` and return the longest dual step that keeps |p| ≤ 1.

    Parameters as of `tv_newton.newton_step`, with the `order` m = 1, 2, … of the penalised derivative,
    N ≥ m + 1, ``t[:m+1] = 0``, and `gains` of shape (N, m + 2).
    """
    n = b.size
    size = order + 1
    mean = np.zeros(size)
    cov = np.zeros((size, size))
    # Diffuse start: the first m + 1 samples fix the state; `start[k, j]` is the weight of sample j in ∇^k y.
    start = np.zeros((size, size))
    start[0, order] = 1.0
    for k in range(1, size):
        for j in range(size):
            start[k, j] = start[k - 1, j] - (start[k - 1, j + 1] if j < order else 0.0)
    for j in range(size):
        z = b[j] - y[j] - q[j]
        weight = first_variance if j == 0 else 1.0
        for k in range(size):
            mean[k] += start[k, j] * z
            for l in range(size):
                cov[k, l] += weight * start[k, j] * start[l, j]
    for i in range(size, n):
        r = math.sqrt(t[i] * t[i] + delta * delta)
        g = t[i] / r
        s = r / one_minus_product(p[i], g, delta / r)
        mu = (p[i] - g) * s
        v = s / lam
        mean[order] += mu
        cov[order, order] += v
        for k in range(order - 1, -1, -1):
            mean[k] += mean[k + 1]
            for l in range(size):
                cov[k, l] += cov[k + 1, l]
        for l in range(order - 1, -1, -1):
            for k in range(size):
                cov[k, l] += cov[k, l + 1]
        inverse = 1.0 / (cov[0, 0] + 1.0)
        innovation = (b[i] - y[i] - q[i] - mean[0]) * inverse
        for k in range(size):
            mean[k] += cov[k, 0] * innovation
            gains[i, k] = cov[k, 0] * inverse
        gains[i, size] = innovation
        for k in range(1, size):
            for l in range(k, size):
                cov[k, l] -= gains[i, k] * cov[0, l]
                cov[l, k] = cov[k, l]
        for k in range(size):
            cov[0, k] = gains[i, k]
            cov[k, 0] = gains[i, k]
        dt[i] = mu
        dy[i] = v
    longest = math.inf
    adjoint = np.zeros(size)
    for i in range(n - 1, order, -1):
        residual = gains[i, size]
        for k in range(size):
            residual -= gains[i, k] * adjoint[k]
        adjoint[0] += residual
        for k in range(1, size):
            adjoint[k] += adjoint[k - 1]
        dt[i] += dy[i] * adjoint[order]
        step = adjoint[order] / lam
        dp[i] = step
        if step > 0.0:
            longest = min(longest, (1.0 - p[i]) / step)
        elif step < 0.0:
            longest = min(longest, (-1.0 - p[i]) / step)
        dy[i] = b[i] - y[i] - q[i] - residual
    for j in range(size):
        response = 0.0
        for k in range(size):
            response += start[k, j] * adjoint[k]
        dy[j] = b[j] - y[j] - q[j] + (first_variance if j == 0 else 1.0) * response
        dt[j] = 0.0
        dp[j] = 0.0
    return longest
