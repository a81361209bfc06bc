"""Rates of `pipeline.joint.body` for `LANES` joints side by side, written by `generate_lanes`.

`block` is one flat array of rows of `LANES` numbers, one for each joint. Constants, state, stop operators, inputs and
corrections are read, the rates are written.
"""

import numba

from pipeline.joint.body import (
    _ARM,
    _BENDING,
    _BENDS,
    _BY_Q,
    _BY_TAU,
    _CREEP,
    _CREEP_K,
    _CREEP_R,
    _CROSS,
    _CURVE,
    _DRAG,
    _FAR_Q,
    _FAR_TAU,
    _INERTIA,
    _L,
    _LEFT,
    _LOSS,
    _MASS,
    _OFFSET,
    _QQQQ,
    _QQQT,
    _QQTT,
    _QTTT,
    _RATIO,
    _RELAX,
    _RIGHT,
    _RISE_QQ,
    _RISE_QT,
    _RISE_TT,
    _ROTATION,
    _SHORT,
    _SHORT_BB,
    _SHORT_QB,
    _SHORT_QQ,
    _SHORT_QT,
    _SHORT_TB,
    _SHORT_TT,
    _SIDE_FORCE,
    _SLOPES,
    _STEEP,
    _STIFF,
    _STIFF_BB,
    _STIFF_QQ,
    _STIFF_QT,
    _STIFF_TT,
    _STOP_F,
    _STOP_S,
    _STRETCH_REFERENCE,
    _TTTT,
    _VISC,
    _W,
    _WEIGHT,
    BRANCHES,
    CREEPS,
    ENTRIES,
    STATES,
    STOPS,
)
from pipeline.joint.correction_table import VALUES
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.vector_math import FAST, root

LANES = 8
CONSTANTS = 0
STATE = len(ENTRIES)
START = STATE + STATES
RATE = START + STATES
STOP = RATE + STATES
INPUT = STOP + STOPS
CORRECTION = INPUT + 2
TOTAL = CORRECTION + VALUES
ROWS = TOTAL + STATES
"""First row of each kind, and the number of rows."""


@numba.njit(inline="always", cache=True, error_model="numpy", fastmath=FAST)
def beam(
    block: FloatArray, j: int, big_q: float, tau: float, beta: float
) -> tuple[float, float, float, float, float, float, float]:
    """Gradient of the beam's energy and of u_y."""
    g_q = g_t = g_b = u = u_q = u_t = u_b = 0.0
    end = block[(CONSTANTS + _BY_Q) * LANES + j] * big_q + block[(CONSTANTS + _BY_TAU) * LANES + j] * tau
    for i in range(5):
        slope = big_q * _SLOPES[i, 0] + end * _SLOPES[i, 1] + beta * _SLOPES[i, 2]
        bend = big_q * _BENDS[i, 0] + end * _BENDS[i, 1] + beta * _BENDS[i, 2] - block[(CONSTANTS + _CURVE) * LANES + j]
        square = slope * slope
        by_bend = (
            _W[i]
            * bend
            * (
                1.0
                + block[(CONSTANTS + _STEEP) * LANES + j] * square
                + block[(CONSTANTS + _STIFF) * LANES + j] * bend * bend
            )
        )
        by_slope = _W[i] * block[(CONSTANTS + _STEEP) * LANES + j] * bend * bend * slope
        g_q += by_bend * _BENDS[i, 0] + by_slope * _SLOPES[i, 0]
        g_t += by_bend * _BENDS[i, 1] + by_slope * _SLOPES[i, 1]
        g_b += by_bend * _BENDS[i, 2] + by_slope * _SLOPES[i, 2]
        u -= _W[i] * square * (0.5 + 0.125 * block[(CONSTANTS + _SHORT) * LANES + j] * square)
        by_slope = _W[i] * slope * (1.0 + 0.5 * block[(CONSTANTS + _SHORT) * LANES + j] * square)
        u_q -= by_slope * _SLOPES[i, 0]
        u_t -= by_slope * _SLOPES[i, 1]
        u_b -= by_slope * _SLOPES[i, 2]
    by_q, by_tau = (block[(CONSTANTS + _BY_Q) * LANES + j], block[(CONSTANTS + _BY_TAU) * LANES + j])
    more_q = (
        block[(CONSTANTS + _SHORT_QQ) * LANES + j] * big_q
        + block[(CONSTANTS + _SHORT_QT) * LANES + j] * tau
        + block[(CONSTANTS + _SHORT_QB) * LANES + j] * beta
    )
    more_t = (
        block[(CONSTANTS + _SHORT_QT) * LANES + j] * big_q
        + block[(CONSTANTS + _SHORT_TT) * LANES + j] * tau
        + block[(CONSTANTS + _SHORT_TB) * LANES + j] * beta
    )
    more_b = (
        block[(CONSTANTS + _SHORT_QB) * LANES + j] * big_q
        + block[(CONSTANTS + _SHORT_TB) * LANES + j] * tau
        + block[(CONSTANTS + _SHORT_BB) * LANES + j] * beta
    )
    u -= 0.5 * (more_q * big_q + more_t * tau + more_b * beta)
    u_q += by_q * u_t - more_q
    u_t = by_tau * u_t - more_t
    u_b -= more_b
    g_q += by_q * g_t
    g_t *= by_tau
    q, t = (min(_FAR_Q, max(-_FAR_Q, big_q)), min(_FAR_TAU, max(-_FAR_TAU, tau)))
    qq, qt, tt = (q * q, q * t, t * t)
    quartic_q = (
        4.0 * block[(CONSTANTS + _QQQQ) * LANES + j] * qq
        + 3.0 * block[(CONSTANTS + _QQQT) * LANES + j] * qt
        + 2.0 * block[(CONSTANTS + _QQTT) * LANES + j] * tt
    ) * q + block[(CONSTANTS + _QTTT) * LANES + j] * tt * t
    quartic_t = (
        block[(CONSTANTS + _QQQT) * LANES + j] * qq * q
        + (
            2.0 * block[(CONSTANTS + _QQTT) * LANES + j] * qq
            + 3.0 * block[(CONSTANTS + _QTTT) * LANES + j] * qt
            + 4.0 * block[(CONSTANTS + _TTTT) * LANES + j] * tt
        )
        * t
    )
    g_q += quartic_q if abs(big_q) < _FAR_Q else 0.0
    g_t += quartic_t if abs(tau) < _FAR_TAU else 0.0
    stiffness, l = (block[(CONSTANTS + _BENDING) * LANES + j], block[(CONSTANTS + _L) * LANES + j])
    return (stiffness * g_q, stiffness * g_t, stiffness * g_b, l * u, l * u_q, l * u_t, l * u_b)


@numba.njit(inline="always", cache=True, error_model="numpy", fastmath=FAST)
def membrane(
    block: FloatArray,
    j: int,
    side: int,
    sign: float,
    q: float,
    sin: float,
    cos: float,
    u_y: float,
    square: float,
    strain: float,
) -> tuple[float, float, float, float, float, float]:
    """Tension of one membrane and how its length depends on the tip (eqs. 4 to 6, 11 as corrected, 12)."""
    a, c, l0 = (
        block[(CONSTANTS + side) * LANES + j],
        block[(CONSTANTS + (side + 1)) * LANES + j],
        block[(CONSTANTS + (side + 4)) * LANES + j],
    )
    x = -sign * (a * cos - block[(CONSTANTS + (side + 2)) * LANES + j]) + c * sin - q
    y = (
        block[(CONSTANTS + (side + 3)) * LANES + j]
        - block[(CONSTANTS + _L) * LANES + j]
        - u_y
        + c * cos
        + sign * a * sin
    )
    length = root(x * x + y * y)
    stretch = length / l0
    inverse = 1.0 / stretch
    by_length = -0.5 * root(inverse) * inverse / l0
    excess = stretch - _STRETCH_REFERENCE
    tension = (
        block[(CONSTANTS + (side + 5)) * LANES + j]
        * (2.0 * stretch - 2.0 * inverse * inverse)
        * (1.0 + block[(CONSTANTS + (side + 6)) * LANES + j] * excess)
    )
    tension -= (
        block[(CONSTANTS + (side + 7)) * LANES + j]
        * square
        * (1.0 + block[(CONSTANTS + (side + 8)) * LANES + j] * excess)
    )
    tension = tension / l0 + strain * by_length
    by_phi = (x * (sign * a * sin + c * cos) + y * (-c * sin + sign * a * cos)) / length
    return (
        tension,
        -x / length,
        -y / length,
        by_phi,
        by_length,
        block[(CONSTANTS + (side + 12)) * LANES + j] * by_length * by_length,
    )


@numba.njit(inline="always", cache=True, error_model="numpy", fastmath=FAST)
def frame_inertia(block: FloatArray, j: int, q: float, tau: float) -> tuple[float, float, float, float, float]:
    """Mass matrix of (q, τ) and how the frame's centre of mass rises with them."""
    by_q = -(block[(CONSTANTS + _RISE_QQ) * LANES + j] * q + block[(CONSTANTS + _RISE_QT) * LANES + j] * tau)
    by_tau = -(block[(CONSTANTS + _RISE_QT) * LANES + j] * q + block[(CONSTANTS + _RISE_TT) * LANES + j] * tau)
    mass = block[(CONSTANTS + _MASS) * LANES + j]
    return (
        mass * (1.0 + by_q * by_q),
        block[(CONSTANTS + _CROSS) * LANES + j] + mass * by_q * by_tau,
        block[(CONSTANTS + _INERTIA) * LANES + j] + mass * by_tau * by_tau,
        by_q,
        by_tau,
    )


@numba.njit(forceinline=True, cache=True, error_model="numpy", fastmath=FAST)
def lane_rates(block: FloatArray) -> None:
    """Rates of the state, written to `rates`."""
    for j in range(LANES):
        u1 = block[INPUT * LANES + j]
        u2 = block[(INPUT + 1) * LANES + j]
        q, p, tau, turning, l = (
            block[(STATE + 0) * LANES + j],
            block[(STATE + 1) * LANES + j],
            block[(STATE + 2) * LANES + j],
            block[(STATE + 3) * LANES + j],
            block[(CONSTANTS + _L) * LANES + j],
        )
        g_q, g_t, g_b, u_y, u_q, u_t, u_b = beam(block, j, q / l, tau, block[(STATE + 4) * LANES + j])
        scale = 1.0 / root(1.0 + block[(CONSTANTS + _ROTATION) * LANES + j] * tau * tau)
        sin = tau * scale
        cos = root(1.0 - sin * sin)
        turn = scale * scale * scale / cos
        speed = p / l
        u_dot = u_q * speed + u_t * turning
        strain1 = (
            block[(CONSTANTS + (_LEFT + 9)) * LANES + j] * block[(STATE + 5) * LANES + j]
            + block[(CONSTANTS + (_LEFT + 10)) * LANES + j] * block[(STATE + 7) * LANES + j]
            + block[(CONSTANTS + (_LEFT + 11)) * LANES + j] * block[(STATE + 9) * LANES + j]
        )
        strain2 = (
            block[(CONSTANTS + (_RIGHT + 9)) * LANES + j] * block[(STATE + 6) * LANES + j]
            + block[(CONSTANTS + (_RIGHT + 10)) * LANES + j] * block[(STATE + 8) * LANES + j]
            + block[(CONSTANTS + (_RIGHT + 11)) * LANES + j] * block[(STATE + 10) * LANES + j]
        )
        t1, q1, v1, f1, s1, d1 = membrane(block, j, _LEFT, -1.0, q, sin, cos, u_y, u1, strain1)
        t2, q2, v2, f2, s2, d2 = membrane(block, j, _RIGHT, 1.0, q, sin, cos, u_y, u2, strain2)
        f1, f2 = (f1 * turn, f2 * turn)
        rate1 = q1 * p + f1 * turning + v1 * u_dot
        rate2 = q2 * p + f2 * turning + v2 * u_dot
        t1, t2 = (t1 + d1 * rate1, t2 + d2 * rate2)
        axial = block[(CONSTANTS + _WEIGHT) * LANES + j] + t1 * v1 + t2 * v2
        beta_dot = -(g_b + axial * u_b) / (_STIFF_BB * block[(CONSTANTS + _LOSS) * LANES + j])
        end_dot = block[(CONSTANTS + _BY_Q) * LANES + j] * speed + block[(CONSTANTS + _BY_TAU) * LANES + j] * turning
        end_loss = block[(CONSTANTS + _LOSS) * LANES + j] * (_STIFF_QT * speed + _STIFF_TT * end_dot)
        force = -t1 * q1 - t2 * q2
        force -= (
            g_q
            + axial * u_q
            + block[(CONSTANTS + _LOSS) * LANES + j] * (_STIFF_QQ * speed + _STIFF_QT * end_dot)
            + block[(CONSTANTS + _BY_Q) * LANES + j] * end_loss
        ) / l
        moment = -(g_t + axial * u_t + t1 * f1 + t2 * f2 + block[(CONSTANTS + _BY_TAU) * LANES + j] * end_loss)
        moment += block[(CONSTANTS + _WEIGHT) * LANES + j] * block[(CONSTANTS + _OFFSET) * LANES + j] * sin * turn
        (
            rbf_force,
            rbf_damping,
            rbf_left,
            rbf_right,
            rbf_moment,
            rbf_stiffness,
            rbf_left_moment,
            rbf_right_moment,
            rbf_loss,
            moment_q,
            stiffness_q,
            left_q,
            right_q,
        ) = (
            block[(CORRECTION + 0) * LANES + j],
            block[(CORRECTION + 1) * LANES + j],
            block[(CORRECTION + 2) * LANES + j],
            block[(CORRECTION + 3) * LANES + j],
            block[(CORRECTION + 4) * LANES + j],
            block[(CORRECTION + 5) * LANES + j],
            block[(CORRECTION + 6) * LANES + j],
            block[(CORRECTION + 7) * LANES + j],
            block[(CORRECTION + 8) * LANES + j],
            block[(CORRECTION + 9) * LANES + j],
            block[(CORRECTION + 10) * LANES + j],
            block[(CORRECTION + 11) * LANES + j],
            block[(CORRECTION + 12) * LANES + j],
        )
        force += block[(CONSTANTS + _SIDE_FORCE) * LANES + j] + rbf_force + rbf_left * u1 + rbf_right * u2
        departure, departure_dot = (
            tau - block[(CONSTANTS + _RATIO) * LANES + j] * q / l,
            turning - block[(CONSTANTS + _RATIO) * LANES + j] * speed,
        )
        conjugate = rbf_moment - rbf_stiffness * departure + rbf_left_moment * u1 + rbf_right_moment * u2
        conjugate -= max(rbf_loss, -0.5 * _STIFF_TT * block[(CONSTANTS + _LOSS) * LANES + j]) * departure_dot
        moment += conjugate
        force -= block[(CONSTANTS + _RATIO) * LANES + j] * conjugate / l
        force += departure * (moment_q - 0.5 * stiffness_q * departure + left_q * u1 + right_q * u2)
        force -= (
            max(block[(CONSTANTS + _VISC) * LANES + j] + rbf_damping, 0.0)
            + block[(CONSTANTS + _DRAG) * LANES + j] * abs(p)
        ) * p
        play = (
            q
            - block[(START + 0) * LANES + j]
            + block[(CONSTANTS + _ARM) * LANES + j] * (tau - block[(START + 2) * LANES + j])
        )
        friction = 0.0
        for i in range(STOPS):
            friction += block[(CONSTANTS + (_STOP_F + i)) * LANES + j] * min(
                1.0, max(-1.0, block[(STOP + i) * LANES + j] + play / block[(CONSTANTS + (_STOP_S + i)) * LANES + j])
            )
        force -= friction
        moment -= block[(CONSTANTS + _ARM) * LANES + j] * friction
        for i in range(CREEPS):
            force -= block[(CONSTANTS + (_CREEP_K + i)) * LANES + j] * (q - block[(STATE + (_CREEP + i)) * LANES + j])
            block[(RATE + (_CREEP + i)) * LANES + j] = block[(CONSTANTS + (_CREEP_R + i)) * LANES + j] * (
                q - block[(STATE + (_CREEP + i)) * LANES + j]
            )
        inertia, cross, turning_inertia, rise_q, rise_t = frame_inertia(block, j, q, tau)
        centrifugal = block[(CONSTANTS + _MASS) * LANES + j] * (
            (block[(CONSTANTS + _RISE_QQ) * LANES + j] * p + 2.0 * block[(CONSTANTS + _RISE_QT) * LANES + j] * turning)
            * p
            + block[(CONSTANTS + _RISE_TT) * LANES + j] * turning * turning
        )
        force += rise_q * centrifugal
        moment += rise_t * centrifugal
        acceleration = (moment * inertia - cross * force) / (inertia * turning_inertia - cross * cross)
        block[(RATE + 0) * LANES + j] = p
        block[(RATE + 1) * LANES + j] = (force - cross * acceleration) / inertia
        block[(RATE + 2) * LANES + j] = turning
        block[(RATE + 3) * LANES + j] = acceleration
        block[(RATE + 4) * LANES + j] = beta_dot
        for i in range(BRANCHES):
            block[(RATE + (5 + 2 * i)) * LANES + j] = (
                s1 * rate1 - block[(CONSTANTS + (_RELAX + i)) * LANES + j] * block[(STATE + (5 + 2 * i)) * LANES + j]
            )
            block[(RATE + (6 + 2 * i)) * LANES + j] = (
                s2 * rate2 - block[(CONSTANTS + (_RELAX + i)) * LANES + j] * block[(STATE + (6 + 2 * i)) * LANES + j]
            )
