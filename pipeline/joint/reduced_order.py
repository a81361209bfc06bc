"""Simulation of the reduced joint (eq. 26): one coordinate, two Maxwell strains, friction."""

from dataclasses import dataclass

import numpy as np

from pipeline.compiled import compiled
from pipeline.joint.reduction import ReducedJoint
from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class ReducedMotion:
    """Motion of the reduced joint at the samples: q [m], q̇ [m/s], q̈ [m/s²], Maxwell strains e (N, 2).

    All NaN behind `diverged_at` [s], where q left the range of the curves.
    """

    t: FloatArray
    q: FloatArray
    q_dot: FloatArray
    q_ddot: FloatArray
    e: FloatArray
    diverged_at: float | None


@compiled
def _rates(
    x: FloatArray, v1: float, v2: float, load: float, origin: float, spacing: float, coefficients: FloatArray,
    gain: FloatArray, rate: FloatArray, out: FloatArray,
) -> None:  # fmt: skip
    """ẋ of x = [q, q̇, e1, e2]; `load` is external force minus friction [N]."""
    cell = min(max(int((x[0] - origin) / spacing), 0), coefficients.shape[0] - 1)
    s, c = x[0] - (origin + cell * spacing), coefficients[cell]
    mass = ((c[3, 0] * s + c[2, 0]) * s + c[1, 0]) * s + c[0, 0]
    mass_slope = (3.0 * c[3, 0] * s + 2.0 * c[2, 0]) * s + c[1, 0]
    damping = ((c[3, 1] * s + c[2, 1]) * s + c[1, 1]) * s + c[0, 1]
    restoring = ((c[3, 2] * s + c[2, 2]) * s + c[1, 2]) * s + c[0, 2]
    total = load - damping * x[1] - restoring - 0.5 * mass_slope * x[1] ** 2
    for side in range(2):
        creep = (3.0 * c[3, 3 + side] * s + 2.0 * c[2, 3 + side]) * s + c[1, 3 + side]
        slope = (3.0 * c[3, 5 + side] * s + 2.0 * c[2, 5 + side]) * s + c[1, 5 + side]
        voltage = v1 if side == 0 else v2
        total += 0.5 * slope * voltage * voltage - gain[side] * creep * x[2 + side]
        out[2 + side] = creep * x[1] - rate[side] * x[2 + side]
    out[0], out[1] = x[1], total / mass


@compiled
def _friction(q: float, q_begin: float, zeta: float, s_c: float) -> float:
    """Dahl's state after a monotone displacement from `q_begin`: exact, so that no step is too long for it."""
    direction = 1.0 if q > q_begin else -1.0
    return float(direction + (zeta - direction) * np.exp(-abs(q - q_begin) / s_c))


@compiled
def _integrate(
    t: FloatArray, v: FloatArray, force: FloatArray, x: FloatArray, substeps: int, origin: float, spacing: float,
    coefficients: FloatArray, gain: FloatArray, rate: FloatArray, friction: FloatArray, out: FloatArray,
) -> int:  # fmt: skip
    """Classical Runge-Kutta 4; `out` (N, 5) takes q, q̇, q̈, e1, e2. Returns the number of valid samples.

    Cost: four evaluations of 40 ns a step.
    """
    k, at, zeta = np.empty((4, 4)), np.empty(4), 0.0
    ratios, last = (0.0, 0.5, 0.5, 1.0), origin + spacing * coefficients.shape[0]
    for n in range(t.size):
        load = force[n] - friction[0] * zeta
        _rates(x, v[n, 0], v[n, 1], load, origin, spacing, coefficients, gain, rate, k[0])
        out[n, 0], out[n, 1], out[n, 2], out[n, 3], out[n, 4] = x[0], x[1], k[0, 1], x[2], x[3]
        if not (origin < x[0] < last):
            return n
        if n == t.size - 1:
            break
        h = (t[n + 1] - t[n]) / substeps
        for m in range(substeps):
            q_begin = x[0]
            for s in range(4):
                for i in range(4):
                    at[i] = x[i] + (ratios[s] * h * k[s - 1, i] if s > 0 else 0.0)
                w = (m + ratios[s]) / substeps
                load = (1.0 - w) * force[n] + w * force[n + 1]
                if friction[0] > 0.0:
                    load -= friction[0] * _friction(at[0], q_begin, zeta, friction[1])
                _rates(
                    at, (1.0 - w) * v[n, 0] + w * v[n + 1, 0], (1.0 - w) * v[n, 1] + w * v[n + 1, 1], load,
                    origin, spacing, coefficients, gain, rate, k[s],
                )  # fmt: skip
            for i in range(4):
                x[i] += h / 6.0 * (k[0, i] + 2.0 * k[1, i] + 2.0 * k[2, i] + k[3, i])
            if friction[0] > 0.0:
                zeta = _friction(x[0], q_begin, zeta, friction[1])
    return t.size


def simulate_reduced(
    reduced: ReducedJoint,
    t: FloatArray,
    v: FloatArray,
    q0: float,
    qdot0: float,
    *,
    force: FloatArray | None = None,
    max_step: float = 1e-3,
) -> ReducedMotion:
    """Free run of the reduced joint, voltages and force linear between samples.

    Parameters
    ----------
    reduced : ReducedJoint
        Curves from `pipeline.joint.reduction`.
    t, v : FloatArray, shapes (N,) and (N, 2)
        Sample times [s] (uniform) and voltages [V].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s]; the Maxwell elements have relaxed.
    force : FloatArray, shape (N,), optional
        External force [N].
    max_step : float
        Longest step [s]. 1 ms resolves the joint's 2.8 Hz, and 9 Hz ring-downs, to 1e-7.
    """
    parameters = reduced.parameters
    substeps = max(1, int(np.ceil(float(np.max(np.diff(t))) / max_step - 1e-9))) if t.size > 1 else 1
    out = np.full((t.size, 5), np.nan)
    load = np.zeros(t.size) if force is None else np.ascontiguousarray(force)
    valid = _integrate(
        np.ascontiguousarray(t), np.ascontiguousarray(v), load, np.array([q0, qdot0, 0.0, 0.0]), substeps,
        reduced.q[0], reduced.q[1] - reduced.q[0], reduced.coefficients, reduced.creep_gain, reduced.creep_rate,
        np.array([parameters.F_c, parameters.s_c]), out,
    )  # fmt: skip
    out[valid:] = np.nan
    diverged_at = None if valid == t.size else float(t[valid])
    return ReducedMotion(t, out[:, 0], out[:, 1], out[:, 2], out[:, 3:], diverged_at)


def maxwell_strains(thickness: FloatArray, dt: float, rate: FloatArray) -> FloatArray:
    """e_i along a measured motion: ``ė = λ̇3 − rate·e`` with λ3 linear between samples, at rest before the first.

    Parameters
    ----------
    thickness : FloatArray, shape (N, 2)
        λ_{3,i}.
    dt : float
        Sample interval [s].
    rate : FloatArray, shape (2,)
        Y_MW/η_MW [1/s].
    """
    from scipy.signal import lfilter

    decay = np.exp(-rate * dt)
    steps = np.diff(thickness, axis=0, prepend=thickness[:1])
    gain = np.where(rate > 0.0, -np.expm1(-rate * dt) / np.where(rate > 0.0, rate * dt, 1.0), 1.0)
    return np.stack([lfilter([gain[i]], [1.0, -decay[i]], steps[:, i]) for i in range(2)], axis=1)


@compiled
def friction_state(q: FloatArray, s_c: float) -> FloatArray:
    """ζ (N,) of Dahl's friction along a measured motion, monotone between samples, relaxed at the first."""
    zeta = np.zeros(q.size)
    for n in range(1, q.size):
        zeta[n] = _friction(q[n], q[n - 1], zeta[n - 1], s_c)
    return zeta


def accelerate(reduced: ReducedJoint, t: FloatArray, v: FloatArray, q: FloatArray, q_dot: FloatArray) -> FloatArray:
    """q̈ [m/s²] of eq. 26 along a measured motion, shape (N,); NaN where q is NaN."""
    known = np.isfinite(q)
    filled = np.interp(t, t[known], q[known])
    value, slope = reduced.evaluate(filled)
    e = maxwell_strains(value[:, 3:5], float(t[1] - t[0]), reduced.creep_rate)
    parameters = reduced.parameters
    zeta = friction_state(filled, parameters.s_c) if parameters.F_c > 0.0 else np.zeros(t.size)
    force = 0.5 * (slope[:, 5:] * v**2).sum(axis=1) - (reduced.creep_gain * slope[:, 3:5] * e).sum(axis=1)
    force -= value[:, 1] * q_dot + value[:, 2] + 0.5 * slope[:, 0] * q_dot**2 + parameters.F_c * zeta
    return np.where(known, force / value[:, 0], np.nan)
