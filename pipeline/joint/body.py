"""The joint in slow coordinates: the analytical model without its stiff axial and inertial shape modes.

The full model (eq. 19) has ten states and eigenvalues up to 5e4 1/s, because the beam's higher shapes have almost
no inertia and a large viscosity. Here the beam is w(x) = l W(x/l) with

    W = Q h1 + τ h2 + β h3,   h1 = 3ξ² − 2ξ³,   h2 = ξ³ − ξ²,   h3 = ξ²(1 − ξ)²,

the polynomials of eq. 13 in other coordinates: Q = q/l is the tip's displacement, τ = w'(l) its slope and β a
bubble that moves neither. q and τ have inertia (a frame's, which Table 1 does not give: without any, τ would be
stiff and a least value stands in); β relaxes without; the axial strain u0 (10 µm) is a constant. What stays is
passive by construction without voltage: every force comes from a potential, a damper, a Maxwell element or a stop
operator.

What a real joint has and the paper's analytical model lacks is added: two sides of their own, generalised
Maxwell slip on q (F. Al-Bender, V. Lampaert and J. Swevers, IEEE Trans. Autom. Control 50 (2005) 1883,
doi:10.1109/TAC.2005.858676) as stop operators, linear creep elements on q, and RBF corrections (eq. 38): of restoring
force, damping and both electrostatic forces in q, and to second order in the shape's departure s = τ − ratio Q from
slow motion, because while it snaps the beam is not where a function of q alone would put it: the potential
−m(q) s + ½ b(q) s² − (h_left(q) u_1 + h_right(q) u_2) s and the loss c(q) ṡ². They are gradients and dampers, so the
joint stays passive; c never takes more than half of the slope's own loss.

State x: q [m], q̇ [m/s], τ [1], τ̇ [1/s], β [1]; e1, e2 [1] of each Maxwell branch; one creep displacement [m] per
creep element.
"""

import math

import numba
import numpy as np

from pipeline.numerics.arrays import FloatArray

STOPS = 3
"""Stop operators of the Maxwell-slip friction."""
CREEPS = 2
"""Creep elements on q."""
BRANCHES = 3
"""Maxwell elements of each membrane: the paper's, a slow one and a fast one."""
STATES = 5 + 2 * BRANCHES + CREEPS
"""Length of the state."""
_CREEP = 5 + 2 * BRANCHES

_SIDE = ("a", "c", "e_z", "e_x", "l0", "elastic", "hardening", "electric", "electric_slope", "maxwell_0", "maxwell_1",
         "maxwell_2", "viscous")  # fmt: skip
ENTRIES = (
    "l", "bending", "bending_loss", "steepening", "stiffening", "shortening", "curvature", "slope_by_q", "slope_by_tau",
    "shortening_qq", "shortening_qt", "shortening_tt", "shortening_qb", "shortening_tb", "shortening_bb", "rotation",
    "quartic_qqqq", "quartic_qqqt", "quartic_qqtt", "quartic_qttt", "quartic_tttt",
    "mass", "cross", "inertia", "rise_qq", "rise_qt", "rise_tt", "weight", "offset", "side_force",
    "relaxation_0", "relaxation_1", "relaxation_2",
    "viscosity", "drag", "friction_arm",
    *(f"left_{name}" for name in _SIDE),
    *(f"right_{name}" for name in _SIDE),
    *(f"stop_force_{i}" for i in range(STOPS)),
    *(f"stop_travel_{i}" for i in range(STOPS)),
    *(f"creep_stiffness_{i}" for i in range(CREEPS)),
    *(f"creep_rate_{i}" for i in range(CREEPS)),
    "slope_ratio",
)  # fmt: skip
"""Entries of the kernel's constants, all SI; `pipeline.joint.condensed_parameters` says how each is made."""

INDEX = {name: position for position, name in enumerate(ENTRIES)}
_L, _BENDING, _LOSS, _STEEP, _STIFF, _SHORT, _CURVE, _BY_Q, _BY_TAU = range(9)
_SHORT_QQ, _SHORT_QT, _SHORT_TT, _SHORT_QB, _SHORT_TB, _SHORT_BB, _ROTATION = range(9, 16)
_QQQQ, _QQQT, _QQTT, _QTTT, _TTTT = range(16, 21)
_MASS, _CROSS, _INERTIA, _RISE_QQ, _RISE_QT, _RISE_TT, _WEIGHT, _OFFSET, _SIDE_FORCE, _RELAX = range(21, 31)
_VISC, _DRAG, _ARM = (INDEX[name] for name in ("viscosity", "drag", "friction_arm"))
_LEFT, _RIGHT = INDEX["left_a"], INDEX["right_a"]
_STOP_F, _STOP_S = INDEX["stop_force_0"], INDEX["stop_travel_0"]
_CREEP_K, _CREEP_R = INDEX["creep_stiffness_0"], INDEX["creep_rate_0"]
_RATIO = INDEX["slope_ratio"]

CORRECTIONS = 9
"""Rows of the corrections' weights: force [N], damping [N·s/m], left and right electrostatic force [N/V²]; with the
shape's departure s from slow motion: moment m [N·m], stiffness b [N·m], left and right electrostatic moment h [N·m/V²],
loss c [N·m·s]."""
CURVED = slice(4, 8)
"""The rows whose slope along q acts too: m, b, h_left, h_right."""

_STRETCH_REFERENCE = 1.4
"""Stretch about which deviations from neo-Hooke and from C = C0 λ are counted: the pre-strain of figure 1."""

_FAR_Q, _FAR_TAU = 0.35, 0.6
"""Tip displacement over length and tip slope beyond which the quartic terms are constant; joints reach 0.28 and 0.4."""

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(5)
_XI = 0.5 * (_POINTS + 1.0)
_W = 0.5 * _WEIGHTS
"""Gauss-Legendre on [0, 1]; five points are exact but for the last of ten powers in W''² W'²."""
_SLOPES = np.ascontiguousarray(
    np.stack([6 * _XI - 6 * _XI**2, 3 * _XI**2 - 2 * _XI, 2 * _XI - 6 * _XI**2 + 4 * _XI**3], 1)
)
_BENDS = np.ascontiguousarray(np.stack([6 - 12 * _XI, 6 * _XI - 2, 2 - 12 * _XI + 12 * _XI**2], 1))
_STIFF_QQ, _STIFF_QT, _STIFF_TT, _STIFF_BB = 12.0, -6.0, 4.0, 0.8
"""∫ h_i'' h_j'' dξ; the bubble is orthogonal to the other two."""


@numba.njit(cache=True)
def beam(
    k: FloatArray, big_q: float, tau: float, beta: float
) -> tuple[float, float, float, float, float, float, float]:
    """Gradient of the beam's energy and of u_y.

    The beam's own slope is slope_by_q Q + slope_by_tau τ, because clamps and a printed beam of uneven section make
    another 2 × 2 stiffness than 12, −6, 4; so do the additions to the shortening. A beam that is no slender one of
    uniform section has other quartic terms as well: U/bending gains Σ quartic_ij Q^i τ^j, i + j = 4,
    whose arguments stop at `_FAR_Q` and `_FAR_TAU`, so that no sign of them lets the energy fall for ever.

    Returns
    -------
    tuple of float
        ∂U_s/∂(Q, τ, β) [J] of eq. 9 (as corrected), u_y [m] of eq. 2 and ∂u_y/∂(Q, τ, β) [m].
    """
    g_q = g_t = g_b = u = u_q = u_t = u_b = 0.0
    end = k[_BY_Q] * big_q + k[_BY_TAU] * tau
    for i in range(5):
        slope = big_q * _SLOPES[i, 0] + end * _SLOPES[i, 1] + beta * _SLOPES[i, 2]
        bend = big_q * _BENDS[i, 0] + end * _BENDS[i, 1] + beta * _BENDS[i, 2] - k[_CURVE]
        square = slope * slope
        by_bend = _W[i] * bend * (1.0 + k[_STEEP] * square + k[_STIFF] * bend * bend)
        by_slope = _W[i] * k[_STEEP] * bend * bend * slope
        g_q += by_bend * _BENDS[i, 0] + by_slope * _SLOPES[i, 0]
        g_t += by_bend * _BENDS[i, 1] + by_slope * _SLOPES[i, 1]
        g_b += by_bend * _BENDS[i, 2] + by_slope * _SLOPES[i, 2]
        u -= _W[i] * square * (0.5 + 0.125 * k[_SHORT] * square)
        by_slope = _W[i] * slope * (1.0 + 0.5 * k[_SHORT] * square)
        u_q -= by_slope * _SLOPES[i, 0]
        u_t -= by_slope * _SLOPES[i, 1]
        u_b -= by_slope * _SLOPES[i, 2]
    by_q, by_tau = k[_BY_Q], k[_BY_TAU]
    more_q = k[_SHORT_QQ] * big_q + k[_SHORT_QT] * tau + k[_SHORT_QB] * beta
    more_t = k[_SHORT_QT] * big_q + k[_SHORT_TT] * tau + k[_SHORT_TB] * beta
    more_b = k[_SHORT_QB] * big_q + k[_SHORT_TB] * tau + k[_SHORT_BB] * beta
    u -= 0.5 * (more_q * big_q + more_t * tau + more_b * beta)
    u_q += by_q * u_t - more_q
    u_t = by_tau * u_t - more_t
    u_b -= more_b
    g_q += by_q * g_t
    g_t *= by_tau
    q, t = min(_FAR_Q, max(-_FAR_Q, big_q)), min(_FAR_TAU, max(-_FAR_TAU, tau))
    qq, qt, tt = q * q, q * t, t * t
    quartic_q = (4.0 * k[_QQQQ] * qq + 3.0 * k[_QQQT] * qt + 2.0 * k[_QQTT] * tt) * q + k[_QTTT] * tt * t
    quartic_t = k[_QQQT] * qq * q + (2.0 * k[_QQTT] * qq + 3.0 * k[_QTTT] * qt + 4.0 * k[_TTTT] * tt) * t
    g_q += quartic_q if abs(big_q) < _FAR_Q else 0.0
    g_t += quartic_t if abs(tau) < _FAR_TAU else 0.0
    stiffness, l = k[_BENDING], k[_L]
    return stiffness * g_q, stiffness * g_t, stiffness * g_b, l * u, l * u_q, l * u_t, l * u_b


@numba.njit(cache=True)
def membrane(
    k: FloatArray, side: int, sign: float, q: float, sin: float, cos: float, u_y: float, square: float, strain: float
) -> tuple[float, float, float, float, float, float]:
    """Tension of one membrane and how its length depends on the tip (eqs. 4 to 6, 11 as corrected, 12).

    `strain` [N·m] is Σ V Y_MW e of its Maxwell elements.

    Returns
    -------
    tuple of float
        Tension T [N]; ∂L/∂q [1], ∂L/∂u_y [1], ∂L/∂φ [m]; ∂λ3/∂L [1/m]; viscous coefficient [N·s/m] along L.
    """
    a, c, l0 = k[side], k[side + 1], k[side + 4]
    x = -sign * (a * cos - k[side + 2]) + c * sin - q
    y = k[side + 3] - k[_L] - u_y + c * cos + sign * a * sin
    length = math.sqrt(x * x + y * y)
    stretch = length / l0
    inverse = 1.0 / stretch
    by_length = -0.5 * math.sqrt(inverse) * inverse / l0
    excess = stretch - _STRETCH_REFERENCE
    tension = k[side + 5] * (2.0 * stretch - 2.0 * inverse * inverse) * (1.0 + k[side + 6] * excess)
    tension -= k[side + 7] * square * (1.0 + k[side + 8] * excess)
    tension = tension / l0 + strain * by_length
    by_phi = (x * (sign * a * sin + c * cos) + y * (-c * sin + sign * a * cos)) / length
    return tension, -x / length, -y / length, by_phi, by_length, k[side + 12] * by_length * by_length


@numba.njit(cache=True)
def frame_inertia(k: FloatArray, q: float, tau: float) -> tuple[float, float, float, float, float]:
    """Mass matrix of (q, τ) and how the frame's centre of mass rises with them.

    Its height is y = −½ (rise_qq q² + 2 rise_qt q τ + rise_tt τ²), the shortening of a beam that bends and a frame that
    tilts, so T = ½ mass (q̇² + ẏ²) + cross q̇ τ̇ + ½ inertia τ̇². Positive definite, as inertia·mass > cross² makes it.

    Returns
    -------
    tuple of float
        M_qq [kg], M_qτ [kg·m], M_ττ [kg·m²], ∂y/∂q [1] and ∂y/∂τ [m].
    """
    by_q = -(k[_RISE_QQ] * q + k[_RISE_QT] * tau)
    by_tau = -(k[_RISE_QT] * q + k[_RISE_TT] * tau)
    mass = k[_MASS]
    return (
        mass * (1.0 + by_q * by_q),
        k[_CROSS] + mass * by_q * by_tau,
        k[_INERTIA] + mass * by_tau * by_tau,
        by_q,
        by_tau,
    )


@numba.njit(cache=True)
def corrections(
    q: float, basis: FloatArray, weights: FloatArray
) -> tuple[float, float, float, float, float, float, float, float, float, float, float, float, float]:
    """RBF corrections at q (eq. 38): the nine curves of `CORRECTIONS`, then the slopes of m, b, h_left, h_right.

    `basis` holds the first centre, the distance of the centres and the width σ [m]; `weights` is (CORRECTIONS, M). The
    bells of equidistant centres follow from three exponentials by a recurrence. Cost: 26 operations for each centre;
    `pipeline.joint.correction_table` has them at a cost that does not depend on M.
    """
    force = damping = left = right = moment = stiffness = left_moment = right_moment = loss = 0.0
    moment_q = stiffness_q = left_q = right_q = 0.0
    if weights.shape[1] > 0 and abs(q - basis[0]) < 30.0 * basis[2]:
        r, s = (q - basis[0]) / basis[2], basis[1] / basis[2]
        bell, ratio, shrink = math.exp(-0.5 * r * r), math.exp(r * s - 0.5 * s * s), math.exp(-s * s)
        for i in range(weights.shape[1]):
            slope = (i * s - r) / basis[2] * bell
            force += weights[0, i] * bell
            damping += weights[1, i] * bell
            left += weights[2, i] * bell
            right += weights[3, i] * bell
            moment += weights[4, i] * bell
            stiffness += weights[5, i] * bell
            left_moment += weights[6, i] * bell
            right_moment += weights[7, i] * bell
            loss += weights[8, i] * bell
            moment_q += weights[4, i] * slope
            stiffness_q += weights[5, i] * slope
            left_q += weights[6, i] * slope
            right_q += weights[7, i] * slope
            bell *= ratio
            ratio *= shrink
    return (
        force, damping, left, right, moment, stiffness, left_moment, right_moment, loss,
        moment_q, stiffness_q, left_q, right_q,
    )  # fmt: skip


@numba.njit(cache=True)
def body_rates(
    x: FloatArray, u1: float, u2: float, z: FloatArray, start: FloatArray, k: FloatArray, basis: FloatArray,
    weights: FloatArray, rates: FloatArray,
) -> None:  # fmt: skip
    """Rates of the state, written to `rates`.

    Parameters
    ----------
    x : FloatArray, shape (STATES,)
        State.
    u1, u2 : float
        Squares of the voltages [V²].
    z : FloatArray, shape (STOPS,)
        Stop operators at the state `start`, as a share of their capacity in [−1, 1]; what they are at x follows
        from the play since, so that they need no differential equation.
    start : FloatArray, shape (STATES,)
        See `z`.
    k, basis, weights : FloatArray
        Constants (`ENTRIES`), and the corrections (see `corrections`).
    rates : FloatArray, shape (STATES,)
        Filled.

    Notes
    -----
    About 150 ns: five Gauss points of 45 operations, two membranes with 4 roots and divisions each.
    """
    q, p, tau, turning, l = x[0], x[1], x[2], x[3], k[_L]
    g_q, g_t, g_b, u_y, u_q, u_t, u_b = beam(k, q / l, tau, x[4])
    # sin φ = τ / √(1 + s τ²): φ = arctan τ (eq. 1) for s = 1; arcsin τ, the slope along the arc, for s = 0.
    scale = 1.0 / math.sqrt(1.0 + k[_ROTATION] * tau * tau)
    sin = tau * scale
    cos = math.sqrt(1.0 - sin * sin)
    turn = scale * scale * scale / cos
    speed = p / l
    u_dot = u_q * speed + u_t * turning  # the bubble's share is 1e-3 of it
    strain1 = k[_LEFT + 9] * x[5] + k[_LEFT + 10] * x[7] + k[_LEFT + 11] * x[9]
    strain2 = k[_RIGHT + 9] * x[6] + k[_RIGHT + 10] * x[8] + k[_RIGHT + 11] * x[10]
    t1, q1, v1, f1, s1, d1 = membrane(k, _LEFT, -1.0, q, sin, cos, u_y, u1, strain1)
    t2, q2, v2, f2, s2, d2 = membrane(k, _RIGHT, 1.0, q, sin, cos, u_y, u2, strain2)
    f1, f2 = f1 * turn, f2 * turn
    rate1 = q1 * p + f1 * turning + v1 * u_dot
    rate2 = q2 * p + f2 * turning + v2 * u_dot
    t1, t2 = t1 + d1 * rate1, t2 + d2 * rate2
    axial = k[_WEIGHT] + t1 * v1 + t2 * v2
    beta_dot = -(g_b + axial * u_b) / (_STIFF_BB * k[_LOSS])
    end_dot = k[_BY_Q] * speed + k[_BY_TAU] * turning
    end_loss = k[_LOSS] * (_STIFF_QT * speed + _STIFF_TT * end_dot)
    force = -t1 * q1 - t2 * q2
    force -= (g_q + axial * u_q + k[_LOSS] * (_STIFF_QQ * speed + _STIFF_QT * end_dot) + k[_BY_Q] * end_loss) / l
    moment = -(g_t + axial * u_t + t1 * f1 + t2 * f2 + k[_BY_TAU] * end_loss)
    moment += k[_WEIGHT] * k[_OFFSET] * sin * turn
    (
        rbf_force, rbf_damping, rbf_left, rbf_right, rbf_moment, rbf_stiffness, rbf_left_moment, rbf_right_moment,
        rbf_loss, moment_q, stiffness_q, left_q, right_q,
    ) = corrections(q, basis, weights)  # fmt: skip
    force += k[_SIDE_FORCE] + rbf_force + rbf_left * u1 + rbf_right * u2
    departure, departure_dot = tau - k[_RATIO] * q / l, turning - k[_RATIO] * speed
    conjugate = rbf_moment - rbf_stiffness * departure + rbf_left_moment * u1 + rbf_right_moment * u2
    conjugate -= max(rbf_loss, -0.5 * _STIFF_TT * k[_LOSS]) * departure_dot
    moment += conjugate
    force -= k[_RATIO] * conjugate / l
    force += departure * (moment_q - 0.5 * stiffness_q * departure + left_q * u1 + right_q * u2)
    force -= (max(k[_VISC] + rbf_damping, 0.0) + k[_DRAG] * abs(p)) * p
    play = q - start[0] + k[_ARM] * (tau - start[2])
    friction = 0.0
    for i in range(STOPS):
        friction += k[_STOP_F + i] * min(1.0, max(-1.0, z[i] + play / k[_STOP_S + i]))
    force -= friction
    moment -= k[_ARM] * friction
    for i in range(CREEPS):
        force -= k[_CREEP_K + i] * (q - x[_CREEP + i])
        rates[_CREEP + i] = k[_CREEP_R + i] * (q - x[_CREEP + i])
    inertia, cross, turning_inertia, rise_q, rise_t = frame_inertia(k, q, tau)
    # What lifts the frame apart from q̈ and τ̈: ÿ = … − (rise_qq q̇² + 2 rise_qt q̇ τ̇ + rise_tt τ̇²).
    centrifugal = k[_MASS] * ((k[_RISE_QQ] * p + 2.0 * k[_RISE_QT] * turning) * p + k[_RISE_TT] * turning * turning)
    force += rise_q * centrifugal
    moment += rise_t * centrifugal
    acceleration = (moment * inertia - cross * force) / (inertia * turning_inertia - cross * cross)
    rates[0] = p
    rates[1] = (force - cross * acceleration) / inertia
    rates[2] = turning
    rates[3] = acceleration
    rates[4] = beta_dot
    for i in range(BRANCHES):
        rates[5 + 2 * i] = s1 * rate1 - k[_RELAX + i] * x[5 + 2 * i]
        rates[6 + 2 * i] = s2 * rate2 - k[_RELAX + i] * x[6 + 2 * i]


@numba.njit(cache=True)
def advance_stops(z: FloatArray, before: FloatArray, after: FloatArray, k: FloatArray) -> None:
    """Stop operators after the move from one state to another, in place: z ← clip(z + play / travel, −1, 1)."""
    play = after[0] - before[0] + k[_ARM] * (after[2] - before[2])
    for i in range(STOPS):
        z[i] = min(1.0, max(-1.0, z[i] + play / k[_STOP_S + i]))
