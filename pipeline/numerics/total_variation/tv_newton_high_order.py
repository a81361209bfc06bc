"""The Newton step of `tv_newton` for a variation of the second or a higher derivative.

The smoother's state is the chain of m + 1 summators of `tv_chain`; everything else is as in
`tv_newton.newton_step`, whose case is m = 1 with its recursions written out: with loops over the state it takes three
times as long (64 ns a sample for 20).

Cost model: three divisions, two square roots and about (m+1)(m+5) multiplications and additions per sample and step.
"""

import math

import numpy as np

from pipeline.compiled import compiled
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.total_variation.tv_chain import advance_covariance, difference_weights, start_covariance
from pipeline.numerics.total_variation.tv_newton import driving_noise, excess, within_bounds


@compiled
def newton_step_high_order(
    b: FloatArray,
    y: FloatArray,
    t: FloatArray,
    q: FloatArray,
    p: FloatArray,
    lam: FloatArray,
    delta: float,
    order: int,
    first_variance: float,
    dy: FloatArray,
    dt: FloatArray,
    dp: FloatArray,
    gains: FloatArray,
) -> tuple[float, float]:
    """Write the Newton step into `dy`, `dt`, `dp`; return the longest dual step and the objective after a full step.

    Parameters as of `tv_newton.newton_step`, with the `order` m = 1, 2, … of the penalised derivative,
    N ≥ m + 1, ``t[:m+1] = 0``, and `gains` of shape (N, m + 2).
    """
    n = b.size
    size = order + 1
    mean = np.zeros(size)
    start = difference_weights(order)
    cov = start_covariance(start, first_variance)
    for j in range(size):
        for k in range(size):
            mean[k] += start[k, j] * (b[j] - y[j] - q[j])
    for i in range(size, n):
        mu, v = driving_noise(t[i], p[i], 1.0 / lam[i], delta)
        mean[order] += mu
        for k in range(order - 1, -1, -1):
            mean[k] += mean[k + 1]
        inverse = advance_covariance(cov, v, gains[i, :size])
        innovation = b[i] - y[i] - q[i] - mean[0]
        for k in range(size):
            mean[k] += gains[i, k] * innovation
        gains[i, size] = innovation * inverse
        dt[i] = mu
        dy[i] = v
    longest = math.inf
    variation = 0.0
    misfit = 0.0
    adjoint = np.zeros(size)
    for i in range(n - 1, order, -1):
        residual = gains[i, size]
        for k in range(size):
            residual -= gains[i, k] * adjoint[k]
        adjoint[0] += residual
        for k in range(1, size):
            adjoint[k] += adjoint[k - 1]
        dt[i] += dy[i] * adjoint[order]
        dp[i] = adjoint[order] / lam[i]
        longest = within_bounds(longest, p[i], dp[i])
        dy[i] = b[i] - y[i] - q[i] - residual
        variation += lam[i] * excess(t[i] + dt[i], delta)
        misfit += (q[i] + residual) ** 2
    for j in range(size):
        response = 0.0
        for k in range(size):
            response += start[k, j] * adjoint[k]
        dy[j] = b[j] - y[j] - q[j] + (first_variance if j == 0 else 1.0) * response
        dt[j] = 0.0
        dp[j] = 0.0
        misfit += (y[j] + dy[j] - b[j]) ** 2
    return longest, variation + 0.5 * misfit
