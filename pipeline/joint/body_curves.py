"""Characteristic curves of the slow-coordinate joint, along the path on which its shape is at rest."""

import numba
import numpy as np

from pipeline.joint.body import _STIFF_BB, CREEPS, INDEX, STATES, STOPS, body_rates, frame_inertia
from pipeline.joint.body_run import rest_state, shape_flow
from pipeline.numerics.arrays import FloatArray

_CREEP = STATES - CREEPS
_LOSS = INDEX["bending_loss"]
_SPEED = 1e-3  # m/s, small against every speed at which damping is nonlinear
_NUDGE = 1e-6  # m, and of the shape


@numba.njit(cache=True)
def work_rate(
    x: FloatArray, u1: float, u2: float, slope: float, bubble: float, k: FloatArray, basis: FloatArray,
    weights: FloatArray,
) -> float:  # fmt: skip
    """Generalised force [N] along the path with dτ/dq = `slope`, dβ/dq = `bubble` [1/m]; friction and creep relaxed."""
    rates = np.zeros(STATES)
    body_rates(x, u1, u2, np.zeros(STOPS), x, k, basis, weights, rates)
    mass, cross, inertia, _, _ = frame_inertia(k, x[0], x[2])
    force = mass * rates[1] + cross * rates[3]
    moment = cross * rates[1] + inertia * rates[3]
    # The bubble has no inertia: the force on it is its loss times its rate.
    total: float = force + moment * slope + _STIFF_BB * k[_LOSS] * rates[4] * bubble
    return total


@numba.njit(cache=True)
def _slope(ahead: tuple[float, float], behind: tuple[float, float]) -> tuple[float, float]:
    return (ahead[0] - behind[0]) / (2.0 * _NUDGE), (ahead[1] - behind[1]) / (2.0 * _NUDGE)


@numba.njit(cache=True)
def shape_slopes(
    q: float, tau: float, beta: float, k: FloatArray, basis: FloatArray, weights: FloatArray
) -> tuple[float, float]:
    """dτ/dq and dβ/dq [1/m] of the shape at rest, from the implicit function shape_flow(q, τ, β) = 0."""
    h = _NUDGE
    by_q = _slope(
        shape_flow(q + h, tau, beta, 0.0, 0.0, k, basis, weights),
        shape_flow(q - h, tau, beta, 0.0, 0.0, k, basis, weights),
    )
    by_tau = _slope(
        shape_flow(q, tau + h, beta, 0.0, 0.0, k, basis, weights),
        shape_flow(q, tau - h, beta, 0.0, 0.0, k, basis, weights),
    )
    by_beta = _slope(
        shape_flow(q, tau, beta + h, 0.0, 0.0, k, basis, weights),
        shape_flow(q, tau, beta - h, 0.0, 0.0, k, basis, weights),
    )
    determinant = by_tau[0] * by_beta[1] - by_beta[0] * by_tau[1]
    return (
        (by_beta[0] * by_q[1] - by_beta[1] * by_q[0]) / determinant,
        (by_tau[1] * by_q[0] - by_tau[0] * by_q[1]) / determinant,
    )


@numba.njit(cache=True)
def static_curves(
    q: FloatArray, k: FloatArray, basis: FloatArray, weights: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Curves at q [m], shape (n,), without voltage.

    Returns
    -------
    restoring : FloatArray, shape (n,)
        F [N] that must be applied to hold q.
    damping : FloatArray, shape (n,)
        Viscous coefficient [N·s/m] of beam, membranes and correction for slow motions; Maxwell branches, creep
        and dry friction are no coefficient and are left out.
    left, right : FloatArray, shape (n,)
        g_i = ½ ∂C_i/∂q [N/V²] (eqs. 33, 40).
    """
    n = len(q)
    restoring, damping, left, right = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    for i in range(n):
        x, _ = rest_state(q[i], 0.0, 0.0, k, basis, weights)
        slope, bubble = shape_slopes(q[i], x[2], x[4], k, basis, weights)
        still = work_rate(x, 0.0, 0.0, slope, bubble, k, basis, weights)
        restoring[i] = -still
        # 1 kV², so that the difference is far above rounding.
        left[i] = (work_rate(x, 1e6, 0.0, slope, bubble, k, basis, weights) - still) / 1e6
        right[i] = (work_rate(x, 0.0, 1e6, slope, bubble, k, basis, weights) - still) / 1e6
        moving = x.copy()
        moving[1], moving[3] = _SPEED, slope * _SPEED
        backward = x.copy()
        backward[1], backward[3] = -_SPEED, -slope * _SPEED
        ahead = work_rate(moving, 0.0, 0.0, slope, 0.0, k, basis, weights)
        behind = work_rate(backward, 0.0, 0.0, slope, 0.0, k, basis, weights)
        # The loss of the bubble, which follows the path, joins that of q and τ.
        damping[i] = 0.5 * (behind - ahead) / _SPEED + _STIFF_BB * k[_LOSS] * bubble * bubble
    return restoring, damping, left, right
