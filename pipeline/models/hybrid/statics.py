"""Statics of the condensed joint: equilibrium at a held tip, step length, and characteristic curves.

Characteristic curves are taken along the path on which the shape is at rest.
"""

import numpy as np

from ...generated.condensed_joint import (
    AT_REST,
    BENDS,
    DRY_LEVELS,
    FIRST_ELEMENT,
    SLIPS,
    SOFTENING,
    STATES,
    STOPS,
)
from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled, inner
from .kernels import (
    INDEX,
    VALUES,
    corrections_at,
    joint_rates,
    mass_matrix,
    prepare,
    rest_forces,
)

_L = INDEX["l"]
_RATIO = INDEX["slope_ratio"]
_BENDING = INDEX["bending"]
_STOP = INDEX["stop_force_0"]
_SOFTENING_RATE = INDEX["softening_rate"]

LONGEST_STEP = 5.5e-3
"""Longest step [s]: it damps a frame that turns at 28 Hz by 1 1/s, where its own loss is 10 to 20 1/s."""
FASTER = 1.15
"""Reserve of a stable step: a joint is faster than at rest, because its stiffness grows away from rest."""
_SHARES = np.linspace(-0.25, 0.25, 5)
"""Tip displacements over length at which the fastest rate is looked for."""
_OF_SLOPE = BENDS[1][1]
_OF_INTERIOR = BENDS[2][2]
"""Bending stiffness of a straight slender beam against τ and against β, over `bending`: the scale of their forces."""
_SECANTS = 20
"""Most steps to the displacement at a reading; five lead to rounding."""
_FARTHEST = (0.05, 0.15)
"""Largest changes of τ and β in an iteration."""
_SPEED = 1e-3  # m/s, small against every speed at which damping is nonlinear
_NUDGE = 1e-6  # m


@inner
def held_shape(
    q: float, softened: float, u: FloatArray, c: FloatArray, k: FloatArray, p: FloatArray
) -> tuple[float, float, float]:
    """Stable τ and β [1] of a joint at rest whose tip is held at q [m], and the force [N] on q there.

    The shape follows its own overdamped relaxation from that of slow motions, by implicit Euler steps that double:
    Newton's method in the end. A step is taken only where it goes down in energy (its matrix is positive definite) and
    is short. A buckled beam has unstable equilibria, and others far off that no joint takes. Newton's method alone ends
    in them. Cost: about 20 evaluations of the forces, 2 µs.

    Parameters
    ----------
    q : float
        Displacement of the tip [m].
    softened : float
        Share of their softening that has come over the membranes.
    u : FloatArray, shape (2,)
        Squared voltages [V²].
    c : FloatArray, shape (VALUES,)
        Corrections at q.
    k, p : FloatArray, shapes (len(CONSTANTS),) and (PREPARED,)
        Constants [SI], and the prepared ones.
    """
    x = np.zeros(STATES)
    forces = np.empty(3)
    by = np.empty(6)
    x[0], x[2], x[SOFTENING] = q, k[_RATIO] * q / k[_L], softened
    step = 0.05
    for _ in range(200):
        rest_forces(x, u, c, p, forces, by)
        f = forces[1] / (_OF_SLOPE * k[_BENDING])
        g = forces[2] / (_OF_INTERIOR * k[_BENDING])
        a = 1.0 / step - by[2] / (_OF_SLOPE * k[_BENDING])
        b = by[3] / (_OF_SLOPE * k[_BENDING])
        d = 1.0 / step - by[5] / (_OF_INTERIOR * k[_BENDING])
        e = by[4] / (_OF_INTERIOR * k[_BENDING])
        determinant = a * d - b * e
        tau = (d * f + b * g) / determinant
        beta = (e * f + a * g) / determinant
        down = a > 0.0 and determinant > 0.0
        if not (down and abs(tau) < _FARTHEST[0] and abs(beta) < _FARTHEST[1]):
            if step < 1e-9 or not np.isfinite(determinant):
                break
            step *= 0.25
            continue
        x[2] += tau
        x[4] += beta
        if abs(tau) + abs(beta) < 1e-11:
            if step > 1e3:
                break
            if step < 1e-2:  # on a ridge, where only a small step goes down
                x[4] += 1e-3
        step *= 2.0
    rest_forces(x, u, c, p, forces, by)
    return x[2], x[4], forces[0]


@compiled
def still(q: float, tau: float, beta: float) -> FloatArray:
    """The state at rest with this shape, shape (STATES,): strains have decayed, creep and softening have ended."""
    x = np.zeros(STATES)
    x[0], x[2], x[4] = q, tau, beta
    for i in range(len(AT_REST)):
        x[FIRST_ELEMENT + i] = AT_REST[i] * q
    x[SOFTENING] = 1.0
    return x


@compiled
def rest_state(
    q: float, u: FloatArray, k: FloatArray, p: FloatArray, basis: FloatArray, weights: FloatArray, age: float
) -> tuple[FloatArray, FloatArray]:
    """State (STATES,) and stop operators (STOPS,) as after a long rest at q [m] under constant squared voltages u [V²].

    The shape has relaxed, Maxwell strains have decayed, creep has caught up, and the layers of the beam are free of
    stress. Friction balances the remaining force as far as its capacity goes.

    Parameters
    ----------
    q : float
        Displacement of the tip [m].
    u : FloatArray, shape (2,)
        Squared voltages [V²].
    k, p : FloatArray, shapes (len(CONSTANTS),) and (PREPARED,)
        Constants [SI], and the prepared ones.
    basis, weights : FloatArray, shapes (3,) and (9, M)
        Of the corrections.
    age : float
        Time [s] for which the membranes have softened.
    """
    z = np.zeros(STOPS)
    c = np.zeros(VALUES)
    corrections_at(q, basis, weights, c)
    softened = 1.0 - np.exp(-k[_SOFTENING_RATE] * age)
    tau, beta, force = held_shape(q, softened, u, c, k, p)
    x = still(q, tau, beta)
    x[SOFTENING] = softened
    capacity = 0.0
    for i in range(SLIPS):
        capacity += k[_STOP + i]
    if capacity > 0.0:
        for i in range(SLIPS):
            z[i] = min(1.0, max(-1.0, force / capacity))
    return x, z


def rest_at_reading(
    reading: float,
    by: tuple[float, float],
    u: FloatArray,
    k: FloatArray,
    p: FloatArray,
    basis: FloatArray,
    weights: FloatArray,
    age: float,
) -> tuple[FloatArray, FloatArray]:
    """State and stop operators as after a long rest at a reading, by the secant method.

    Parameters
    ----------
    reading : float
        Reading [m] without the laser's offset.
    by : (float, float)
        Weights of q [1] and τ [m] in it.
    u, k, p, basis, weights, age
        As in `rest_state`.
    """
    q = reading
    x, z = rest_state(q, u, k, p, basis, weights, age)
    if by[1] == 0.0:
        return x, z
    slope = 1.0
    for _ in range(_SECANTS):
        error = by[0] * q + by[1] * x[2] - reading
        moved = -error / slope
        q += moved
        x, z = rest_state(q, u, k, p, basis, weights, age)
        found = by[0] * q + by[1] * x[2] - reading
        if abs(found) < 1e-14 or moved == 0.0:
            break
        slope = (found - error) / moved
    return x, z


def _jacobians(k: FloatArray, p: FloatArray, basis: FloatArray, weights: FloatArray) -> FloatArray:
    """∂ẋ/∂x at rest without voltage at `_SHARES`, by differences, shape (5, STATES, STATES)."""
    jacobians = np.empty((len(_SHARES), STATES, STATES))
    u = np.zeros(2)
    c = np.zeros(VALUES)
    at_rest = np.empty(STATES)
    rates = np.empty(STATES)
    for i in range(len(_SHARES)):
        x, z = rest_state(_SHARES[i] * k[_L], u, k, p, basis, weights, 0.0)
        start = x[[0, 2, 4]]
        corrections_at(x[0], basis, weights, c)
        joint_rates(x, u, c, z, start, p, at_rest)
        for j in range(STATES):
            moved = x.copy()
            moved[j] += 1e-7
            corrections_at(moved[0], basis, weights, c)
            joint_rates(moved, u, c, z, start, p, rates)
            jacobians[i, :, j] = (rates - at_rest) / 1e-7
    return jacobians


def substeps(k: FloatArray, basis: FloatArray, weights: FloatArray, dt: float, slowness: float = 1.0) -> int:
    """Runge-Kutta steps in a sample interval of `dt` [s] for joints k (B, n) or (n,), weights (B, 9, M) or (9, M).

    Runge-Kutta 4 must not let grow what decays at rest, |q| ≤ l/4, without voltage. The longest step is meant for the
    parameter set's joint; these are `slowness` times slower. Cost: 0.6 ms a joint.

    Parameters
    ----------
    k : FloatArray, shape (B, len(CONSTANTS)) or (len(CONSTANTS),)
        Constants of the joints.
    basis : FloatArray, shape (3,)
        Of the corrections.
    weights : FloatArray, shape (B, 9, M) or (9, M)
        Their weights.
    dt : float
        Sample interval [s].
    slowness : float
        Time unit of the joints over that of the parameter set.
    """
    many = np.atleast_2d(k)
    joints = zip(many, prepare(many), weights if weights.ndim == 3 else weights[None], strict=True)
    jacobians = np.concatenate([_jacobians(k_i, p_i, basis, w_i) for k_i, p_i, w_i in joints])
    fewest = int(np.ceil(dt / (slowness * LONGEST_STEP)))
    most = 3 * fewest  # the constants that a fit may try are absurd beyond
    if not np.all(np.isfinite(jacobians)):
        return most
    rates = np.linalg.eigvals(jacobians)
    decaying = rates[rates.real < 0.0]
    for steps in range(fewest, most):
        z = FASTER * dt / steps * decaying
        growth = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))
        if np.abs(growth).max() <= 1.0:
            return steps
    return most


def _shape_slopes(
    x: FloatArray, u: FloatArray, p: FloatArray, basis: FloatArray, weights: FloatArray, forces: FloatArray
) -> tuple[float, float]:
    """dτ/dq and dβ/dq [1/m] of the shape at rest, from the implicit function of its forces; fills those at x (3,)."""
    c = np.zeros(VALUES)
    by = np.empty(6)
    ahead = np.empty(3)
    q = x[0]
    x[0] = q + _NUDGE
    corrections_at(x[0], basis, weights, c)
    rest_forces(x, u, c, p, ahead, by)
    x[0] = q - _NUDGE
    corrections_at(x[0], basis, weights, c)
    rest_forces(x, u, c, p, forces, by)
    _, by_q1, by_q2 = (ahead - forces) / (2.0 * _NUDGE)
    x[0] = q
    corrections_at(q, basis, weights, c)
    rest_forces(x, u, c, p, forces, by)
    determinant = by[2] * by[5] - by[3] * by[4]
    return (by[3] * by_q2 - by[5] * by_q1) / determinant, (by[4] * by_q1 - by[2] * by_q2) / determinant


def _moving_force(x: FloatArray, slope: float, interior: float, speed: float, c: FloatArray, p: FloatArray) -> float:
    """Generalised force [N] on q, τ and β along the path at a speed [m/s], without voltage, friction and creep."""
    rates = np.empty(STATES)
    mass = np.empty(6)
    x[1], x[3], x[5] = speed, slope * speed, interior * speed
    joint_rates(x, np.zeros(2), c, np.zeros(STOPS), x[[0, 2, 4]], p, rates)
    mass_matrix(x, p, mass)
    along_q = mass[0] + slope * mass[1] + interior * mass[3]
    along_tau = mass[1] + slope * mass[2] + interior * mass[4]
    along_beta = mass[3] + slope * mass[4] + interior * mass[5]
    return float(along_q * rates[1] + along_tau * rates[3] + along_beta * rates[5])


def static_curves(q: FloatArray, k: FloatArray, basis: FloatArray, weights: FloatArray) -> FloatArray:
    """Curves at q [m], shape (4, n), without voltage.

    Parameters
    ----------
    q : FloatArray, shape (n,)
        Displacements [m].
    k : FloatArray, shape (len(CONSTANTS),)
        Constants [SI].
    basis, weights : FloatArray, shapes (3,) and (9, M)
        Of the corrections.

    Returns
    -------
    restoring
        F [N] that must be applied to hold q.
    damping
        Viscous coefficient [N·s/m] of beam, membranes and correction for slow motions; Maxwell branches, creep
        and dry friction are no coefficient and are left out.
    left, right
        g_i = ½ ∂C_i/∂q [N/V²] (eqs. 33, 40).
    """
    k = k.copy()
    k[[INDEX[level] for level in DRY_LEVELS]] = 0.0
    p = prepare(k[None])[0]
    curves = np.empty((4, len(q)))
    u = np.zeros(2)
    c = np.zeros(VALUES)
    forces = np.empty(3)
    by = np.empty(6)
    for i in range(len(q)):
        x, _ = rest_state(q[i], u, k, p, basis, weights, 0.0)
        slope, interior = _shape_slopes(x, u, p, basis, weights, forces)
        still = forces[0] + slope * forces[1] + interior * forces[2]
        curves[0, i] = -still
        corrections_at(q[i], basis, weights, c)
        for side, one in enumerate(np.eye(2)):
            rest_forces(x, 1e6 * one, c, p, forces, by)  # 1 kV², so that the difference is far above rounding
            curves[2 + side, i] = (forces[0] + slope * forces[1] + interior * forces[2] - still) / 1e6
        loss = _moving_force(x, slope, interior, -_SPEED, c, p) - _moving_force(x, slope, interior, _SPEED, c, p)
        curves[1, i] = 0.5 * loss / _SPEED
    return curves
