"""Characteristic curves of the condensed joint, along the path on which its shape is at rest."""

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.condensed_joint import DRY_LEVELS, STATES, STOPS
from pipeline.joint.condensed_kernels import (
    INDEX,
    VALUES,
    corrections_at,
    joint_rates,
    mass_matrix,
    prepare,
    rest_forces,
)
from pipeline.joint.condensed_statics import rest_state
from pipeline.numerics.arrays import FloatArray

_SPEED = 1e-3  # m/s, small against every speed at which damping is nonlinear
_NUDGE = 1e-6  # m


@compiled(inline="always")
def _shape_slopes(
    x: FloatArray, u: FloatArray, p: FloatArray, basis: FloatArray, weights: FloatArray, forces: FloatArray
) -> tuple[float, float]:
    """dτ/dq and dβ/dq [1/m] of the shape at rest, from the implicit function of its forces; fills those at x (3,)."""
    c, by, ahead = np.zeros(VALUES), np.empty(6), np.empty(3)
    q = x[0]
    x[0] = q + _NUDGE
    corrections_at(x[0], basis, weights, c)
    rest_forces(x, u, c, p, ahead, by)
    x[0] = q - _NUDGE
    corrections_at(x[0], basis, weights, c)
    rest_forces(x, u, c, p, forces, by)
    by_q1, by_q2 = (ahead[1] - forces[1]) / (2.0 * _NUDGE), (ahead[2] - forces[2]) / (2.0 * _NUDGE)
    x[0] = q
    corrections_at(q, basis, weights, c)
    rest_forces(x, u, c, p, forces, by)
    determinant = by[2] * by[5] - by[3] * by[4]
    return (by[3] * by_q2 - by[5] * by_q1) / determinant, (by[4] * by_q1 - by[2] * by_q2) / determinant


@compiled
def _moving_force(x: FloatArray, slope: float, interior: float, speed: float, c: FloatArray, p: FloatArray) -> float:
    """Generalised force [N] on q, τ and β along the path at a speed [m/s], without voltage, friction and creep."""
    u, z, start, rates, mass = np.zeros(2), np.zeros(STOPS), np.empty(2), np.empty(STATES), np.empty(6)
    x[1], x[3], x[5] = speed, slope * speed, interior * speed
    start[0], start[1] = x[0], x[2]
    joint_rates(x, u, c, z, start, p, rates)
    mass_matrix(x, p, mass)
    along_q = mass[0] + slope * mass[1] + interior * mass[3]
    along_tau = mass[1] + slope * mass[2] + interior * mass[4]
    along_beta = mass[3] + slope * mass[4] + interior * mass[5]
    force: float = along_q * rates[1] + along_tau * rates[3] + along_beta * rates[5]
    return force


@compiled
def curves_at(q: FloatArray, k: FloatArray, p: FloatArray, basis: FloatArray, weights: FloatArray) -> FloatArray:
    """The four curves of `static_curves`, shape (4, n)."""
    found, u, c, forces, by = np.empty((4, len(q))), np.zeros(2), np.zeros(VALUES), np.empty(3), np.empty(6)
    for i in range(len(q)):
        x, _ = rest_state(q[i], u, k, p, basis, weights)
        slope, interior = _shape_slopes(x, u, p, basis, weights, forces)
        still = forces[0] + slope * forces[1] + interior * forces[2]
        found[0, i] = -still
        corrections_at(q[i], basis, weights, c)
        for side in range(2):
            u[side] = 1e6  # 1 kV², so that the difference is far above rounding
            rest_forces(x, u, c, p, forces, by)
            found[2 + side, i] = (forces[0] + slope * forces[1] + interior * forces[2] - still) / 1e6
            u[side] = 0.0
        loss = _moving_force(x, slope, interior, -_SPEED, c, p) - _moving_force(x, slope, interior, _SPEED, c, p)
        found[1, i] = 0.5 * loss / _SPEED
    return found


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
    k = k.copy()
    k[[INDEX[level] for level in DRY_LEVELS]] = 0.0
    restoring, damping, left, right = curves_at(q, k, prepare(k[None])[0], basis, weights)
    return restoring, damping, left, right
