"""Primal-dual Newton steps for total-variation regularisation, each one a fixed-interval smoother.

The problem, in steps (differences instead of derivatives, so no time appears):

    min over y of  lam Σ sqrt(t_i² + delta²) + ½ Σ (y_i − b_i)²,   t the second difference of y.

With the dual variables ``p`` (of t, |p| ≤ 1) and ``q`` (of y − b) the optimum is where

    y − b + q = 0,   p = t / r,   r = sqrt(t² + delta²),   q = lam Tᵀp,

and the Newton step of Chan, Golub & Mulet (1999) minimises
``½ Σ (dy + y − b + q)² + ½ lam Σ C (dt − mu)²`` with ``C = (1 − p t/r)/r`` and ``mu = (p − t/r)/C``.

Its matrix ``I + lam Tᵀ C T`` is banded, but factoring the band loses log10(lam/delta) digits: all of them at rig
rate, where delta falls and lam grows with the step.  The same minimum is the estimate of a chain of two summators
driven by noise of mean mu and variance 1/(lam C) and measured with unit variance; the covariance form of that
smoother (Kalman filter forward, Bryson-Frazier adjoint backward) is accurate from variance 0 to variance ∞, and
the adjoint is the new dual variable. For the variation of derivative m the chain has m + 1 summators.

Cost model: a step is one sweep forward and one backward without temporaries. It is bound by the latency of the
covariance recursion, in which a division and three additions wait for each other. A step for the third derivative takes
64 ns a sample, and 100 with the update and the duality gap; memory is 12 arrays of N doubles.

References
----------
T. F. Chan, G. H. Golub, P. Mulet, SIAM J. Sci. Comput. 20 (1999) 1964-1977, doi:10.1137/S1064827596299767.
J. Durbin, S. J. Koopman, Time Series Analysis by State Space Methods, 2nd ed., Oxford 2012, sections 4.3-4.5.
"""

import math
from typing import NamedTuple

import numpy as np

from .arrays import FloatArray
from .compiled import compiled, inner


def difference_weights(order: int) -> FloatArray:
    """Weight of sample j of the first m + 1 in ``∇^k y`` at the last of them, shape (m+1, m+1)."""
    return np.array([np.diff(np.eye(order + 1), k, axis=0)[-1] for k in range(order + 1)])


def start_covariance(weights: FloatArray, first_variance: float) -> FloatArray:
    """Covariance of the state after the first m + 1 samples, the very first of variance `first_variance`."""
    return np.asarray((np.r_[first_variance, np.ones(len(weights) - 1)] * weights) @ weights.T)


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
        covariance[0, k] = covariance[k, 0] = gains[k]
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
    t: FloatArray,
    lam: FloatArray,
    delta: float,
    covariance: FloatArray,
    gains: FloatArray,
    adjoint: FloatArray,
    product: FloatArray,
) -> float:
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


class Iterate(NamedTuple):
    """Data and unknowns of the Newton iteration, each of shape (N,); N ≥ 2.

    Attributes
    ----------
    b, y, t : FloatArray
        Data, regularised signal and its differences [signal].
    q, p : FloatArray
        Dual variables of y − b and of t.
    lam : FloatArray
        Weight of the total variation at each sample [signal].
    """

    b: FloatArray
    y: FloatArray
    t: FloatArray
    q: FloatArray
    p: FloatArray
    lam: FloatArray


class NewtonStep(NamedTuple):
    """A Newton step, which the kernels write, and their work space.

    Attributes
    ----------
    dy, dt, dp : FloatArray, shape (N,)
        Changes of the signal, its differences and their dual variables.
    gains : FloatArray, shape (N, m + 2)
        Filter gains and scaled innovations, for a variation of the derivative m.
    """

    dy: FloatArray
    dt: FloatArray
    dp: FloatArray
    gains: FloatArray


@compiled(inline="always")
def one_minus_product(p: float, g: float, cosine: float) -> float:
    """``1 − p g`` for ``g = sin a`` with ``cosine = cos a``, positive even where both round to 1."""
    difference = p - g
    cosine_p = math.sqrt(max(0.0, (1.0 - p) * (1.0 + p)))
    return 0.5 * (difference * difference + cosine * cosine + cosine_p * cosine_p)


@compiled(inline="always")
def driving_noise(t: float, p: float, inverse_lam: float, delta: float) -> tuple[float, float]:
    """Mean mu and variance 1/(lam C) of the change of the difference `t` in a Newton step.

    Parameters
    ----------
    t, p : float
        Difference [signal] and its dual variable.
    inverse_lam : float
        1/lam [1/signal].
    delta : float
        Rounding of the total variation [signal].
    """
    square = t * t + delta * delta
    inverse = 1.0 / math.sqrt(square)
    g = t * inverse
    inverse_curvature = square * inverse / one_minus_product(p, g, delta * inverse)
    return (p - g) * inverse_curvature, inverse_curvature * inverse_lam


@compiled(inline="always")
def excess(t: float, delta: float) -> float:
    """``sqrt(t² + delta²) − delta`` without its cancellation."""
    return t * t / (math.sqrt(t * t + delta * delta) + delta)


@compiled(inline="always")
def within_bounds(longest: float, p: float, dp: float) -> float:
    """The smaller of `longest` and the step at which ``p + step dp`` reaches ±1."""
    room = 1.0 - math.copysign(p, p * dp)
    size = abs(dp)
    return room / size if room < longest * size else longest


@compiled
def objective(at: Iterate, step: NewtonStep, share: float, delta: float) -> float:
    """Objective at ``(y, t) + share (dy, dt)`` less its value ``lam delta`` per difference for a straight line.

    Parameters
    ----------
    at : Iterate
        Start of the step.
    step : NewtonStep
        The step.
    share : float
        Part of it that is taken.
    delta : float
        Rounding of the total variation [signal].
    """
    variation = 0.0
    misfit = 0.0
    for i in range(at.b.size):
        variation += at.lam[i] * excess(at.t[i] + share * step.dt[i], delta)
        error = at.y[i] + share * step.dy[i] - at.b[i]
        misfit += error * error
    return variation + 0.5 * misfit


@compiled
def advance(at: Iterate, step: NewtonStep, primal: float, dual: float, delta: float) -> float:
    """Add `primal` times the step to y and t, and `dual` times the step to q and p, in place; return the duality gap.

    The gap, primal less dual objective, is a sum of squares.  With ``t = r sin a``, ``delta = r cos a`` and
    ``p = sin c`` each term of the variation's gap ``r − p t − delta sqrt(1 − p²)`` is ``r (1 − cos(a − c))``, which
    is half a sum of two squares.  The objective is strongly convex, so ``½‖y − y*‖² ≤ gap``.

    Parameters
    ----------
    at : Iterate
        Data and unknowns; moved (output).
    step : NewtonStep
        The step.
    primal, dual : float
        Parts of it that are taken.
    delta : float
        Rounding of the total variation [signal].
    """
    b, y, t, q, p, lam = at
    dy, dt, dp, _ = step
    variation = 0.0
    misfit = 0.0
    for i in range(b.size):
        q_new = q[i] + dual * (b[i] - y[i] - q[i] - dy[i])
        p_new = p[i] + dual * dp[i]
        y_new = y[i] + primal * dy[i]
        t_new = t[i] + primal * dt[i]
        q[i] = q_new
        p[i] = p_new
        y[i] = y_new
        t[i] = t_new
        square = t_new * t_new + delta * delta
        inverse = 1.0 / math.sqrt(square)
        between_sines = t_new * inverse - p_new
        between_cosines = delta * inverse - math.sqrt(max(0.0, (1.0 - p_new) * (1.0 + p_new)))
        variation += lam[i] * (square * inverse) * (between_sines * between_sines + between_cosines * between_cosines)
        error = y_new - b[i] + q_new
        misfit += error * error
    return 0.5 * (variation + misfit)


def newton_step(at: Iterate, step: NewtonStep, delta: float, order: int, first_variance: float) -> tuple[float, float]:
    """Write the Newton step; return the longest dual step and the objective after a full step.

    The longest dual step is the one that keeps |p| ≤ 1; the objective is that of `objective`. The smoother's state is
    the chain of m + 1 summators; its start is diffuse, as m + 1 samples fix it.

    Parameters
    ----------
    at : Iterate
        Where the step starts; N ≥ m + 1, ``t[:m+1] = 0``.
    step : NewtonStep
        The step (output).
    delta : float
        Rounding of the total variation [unit of the data].
    order : int
        Order m = 1, 2, … of the penalised derivative.
    first_variance : float
        0: the first sample is exact, 1: it is as noisy as the others.
    """
    start = difference_weights(order)
    room = np.zeros((2, order + 1))
    return _step(at, step, delta, first_variance, start, start_covariance(start, first_variance), room)


@compiled
def _step(
    at: Iterate,
    step: NewtonStep,
    delta: float,
    first_variance: float,
    start: FloatArray,
    cov: FloatArray,
    room: FloatArray,
) -> tuple[float, float]:
    b, y, _, q, _, _ = at
    dy, dt, dp, _ = step
    size = len(start)
    adjoint = room[1]
    _filter(at, step, delta, start, cov, room[0])
    longest, variation, misfit = _smooth(at, step, delta, adjoint)
    for j in range(size):
        response = 0.0
        for k in range(size):
            response += start[k, j] * adjoint[k]
        dy[j] = b[j] - y[j] - q[j] + (first_variance if j == 0 else 1.0) * response
        dt[j] = dp[j] = 0.0
        misfit += (y[j] + dy[j] - b[j]) ** 2
    return longest, variation + 0.5 * misfit


@compiled(inline="always")
def _filter(at: Iterate, step: NewtonStep, delta: float, start: FloatArray, cov: FloatArray, mean: FloatArray) -> None:
    """Kalman filter from the `start` of `difference_weights`; mean and variance of the noise go to `dt` and `dy`.

    The covariance `cov` is overwritten; the state's `mean` is zero before.
    """
    b, y, t, q, p, lam = at
    dy, dt, _, gains = step
    size = len(start)
    for j in range(size):
        for k in range(size):
            mean[k] += start[k, j] * (b[j] - y[j] - q[j])
    for i in range(size, b.size):
        mean_noise, variance = driving_noise(t[i], p[i], 1.0 / lam[i], delta)
        mean[size - 1] += mean_noise
        for k in range(size - 2, -1, -1):
            mean[k] += mean[k + 1]
        inverse = advance_covariance(cov, variance, gains[i, :size])
        innovation = b[i] - y[i] - q[i] - mean[0]
        for k in range(size):
            mean[k] += gains[i, k] * innovation
        gains[i, size] = innovation * inverse
        dt[i] = mean_noise
        dy[i] = variance


@compiled(inline="always")
def _smooth(at: Iterate, step: NewtonStep, delta: float, adjoint: FloatArray) -> tuple[float, float, float]:
    """Adjoint sweep: the longest dual step, variation and squared misfit.

    `adjoint`, zero before, holds that of the first sample after the start.
    """
    b, y, t, q, p, lam = at
    dy, dt, dp, gains = step
    size = len(adjoint)
    longest = math.inf
    variation = 0.0
    misfit = 0.0
    for i in range(b.size - 1, size - 1, -1):
        residual = gains[i, size]
        for k in range(size):
            residual -= gains[i, k] * adjoint[k]
        adjoint[0] += residual
        for k in range(1, size):
            adjoint[k] += adjoint[k - 1]
        dt[i] += dy[i] * adjoint[size - 1]
        dp[i] = adjoint[size - 1] / lam[i]
        longest = within_bounds(longest, p[i], dp[i])
        dy[i] = b[i] - y[i] - q[i] - residual
        variation += lam[i] * excess(t[i] + dt[i], delta)
        misfit += (q[i] + residual) ** 2
    return longest, variation, misfit
