"""Rest, driven runs and step of the slow-coordinate joint (`pipeline.joint.body`), by classical Runge-Kutta.

The step is fixed: voltages are known on its half steps, every run of a fit sees the same discretisation, and the
result is a smooth function of the constants, as finite differences need it. Stop operators are exact in a step,
because they depend on the play since the step's start and not on a differential equation.
"""

import numba
import numpy as np

from pipeline.joint.body import CREEPS, INDEX, STATES, STOPS, advance_stops, body_rates, frame_inertia
from pipeline.numerics.arrays import FloatArray

_CREEP = STATES - CREEPS
_LOSS = INDEX["bending_loss"]
_STOP = INDEX["stop_force_0"]

LONGEST_STEP = 5e-3
"""Longest step [s]: it damps a frame that turns at 28 Hz by 0.6 1/s, where its own loss is 10 to 20 1/s."""
STABLE = 2.3
"""Largest |eigenvalue| × step; Runge-Kutta 4 is stable up to 2.7, and the stiffness grows away from rest."""
MOST_SUBSTEPS = 6
"""Bound on the work of a run whose constants are absurd, as a fit may try."""


@numba.njit(cache=True)
def drive_body(
    x0: FloatArray, z0: FloatArray, u: FloatArray, path: FloatArray, dt: float, substeps: int,
    k: FloatArray, basis: FloatArray, weights: FloatArray,
) -> FloatArray:  # fmt: skip
    """Acceleration [m/s²] along a prescribed path, shape (N,): only the hidden states are integrated.

    `path` holds q and q̇ on the half steps, shape (2 substeps (N−1) + 1, 2); `x0` and `z0` state and stop operators at
    the first sample; the rest is as in `pipeline.joint.body_batch`.
    """
    samples = (len(path) - 1) // (2 * substeps) + 1
    out = np.empty(samples)
    h = dt / substeps
    x, z, y, total = x0.copy(), z0.copy(), np.empty(STATES), np.empty(STATES)
    before = np.empty(STATES)
    rates = np.zeros(STATES)
    for n in range(samples):
        first = 2 * n * substeps
        x[:2] = path[first]
        body_rates(x, u[first, 0], u[first, 1], z, x, k, basis, weights, rates)
        out[n] = rates[1]
        if n == samples - 1:
            break
        for s in range(substeps):
            start = first + 2 * s
            y[:] = x
            before[:] = x
            total[:] = 0.0
            for stage in range(4):
                at = start + (stage + 1) // 2
                y[:2] = path[at]
                body_rates(y, u[at, 0], u[at, 1], z, before, k, basis, weights, rates)
                share = 2.0 if stage == 1 or stage == 2 else 1.0
                ahead = h if stage == 2 else 0.5 * h
                for i in range(2, STATES):
                    total[i] += share * rates[i]
                    y[i] = x[i] + ahead * rates[i]
            for i in range(2, STATES):
                x[i] += h / 6.0 * total[i]
            x[:2] = path[start + 2]
            advance_stops(z, before, x, k)
    return out


@numba.njit(cache=True)
def shape_flow(
    q: float, tau: float, beta: float, u1: float, u2: float, k: FloatArray, basis: FloatArray, weights: FloatArray
) -> tuple[float, float]:
    """Rates [1/s] at which the shape (τ, β) would relax at rest at q if nothing had inertia."""
    x, rates = np.zeros(STATES), np.zeros(STATES)
    x[0], x[2], x[4] = q, tau, beta
    x[_CREEP:] = q
    body_rates(x, u1, u2, np.zeros(STOPS), x, k, basis, weights, rates)
    # The moment alone: the cross inertia hands on a share of the force, which friction or a hand may hold.
    _, cross, inertia, _, _ = frame_inertia(k, q, tau)
    moment = inertia * rates[3] + cross * rates[1]
    return moment / (4.0 * k[_LOSS]), rates[4]


@numba.njit(cache=True)
def rest_state(
    q: float, u1: float, u2: float, k: FloatArray, basis: FloatArray, weights: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """State and stop operators as after a long rest at q [m] under constant squared voltages [V²].

    The shape has relaxed, Maxwell strains have decayed, creep has caught up, and friction balances what is left,
    as far as its capacity goes. A buckled beam has other equilibria than the stable one, and a plain Newton
    iteration jumps to them; here the relaxation itself is followed by implicit Euler steps that double, which is
    Newton's method in the end.
    """
    tau, beta, dt = 1.25 * q / k[0], 0.0, 1e-3
    for _ in range(60):
        f, g = shape_flow(q, tau, beta, u1, u2, k, basis, weights)
        f_tau, g_tau = shape_flow(q, tau + 1e-6, beta, u1, u2, k, basis, weights)
        f_beta, g_beta = shape_flow(q, tau, beta + 1e-6, u1, u2, k, basis, weights)
        a, b = 1.0 / dt - (f_tau - f) / 1e-6, (f_beta - f) / 1e-6
        c, d = (g_tau - g) / 1e-6, 1.0 / dt - (g_beta - g) / 1e-6
        determinant = a * d - b * c
        tau_step = (d * f + b * g) / determinant
        beta_step = (c * f + a * g) / determinant
        tau += tau_step
        beta += beta_step
        dt *= 2.0
        if abs(tau_step) + abs(beta_step) < 1e-11 and dt > 1e3:
            break
    x, z, rates = np.zeros(STATES), np.zeros(STOPS), np.zeros(STATES)
    x[0], x[2], x[4] = q, tau, beta
    x[_CREEP:] = q
    body_rates(x, u1, u2, z, x, k, basis, weights, rates)
    mass, cross, _, _, _ = frame_inertia(k, q, tau)
    force = mass * rates[1] + cross * rates[3]
    capacity = np.sum(k[_STOP : _STOP + STOPS])
    if capacity > 0.0:
        z[:] = min(1.0, max(-1.0, force / capacity))
    return x, z


def fastest_rate(k: FloatArray, basis: FloatArray, weights: FloatArray) -> float:
    """Largest magnitude [1/s] of the eigenvalues over |q| ≤ l/4 without voltage: it decides the step."""
    worst = 0.0
    for share in (-0.25, -0.12, 0.0, 0.12, 0.25):
        x, z = rest_state(share * k[0], 0.0, 0.0, k, basis, weights)
        jacobian = np.empty((STATES, STATES))
        centre, rates = np.empty(STATES), np.empty(STATES)
        body_rates(x, 0.0, 0.0, z, x, k, basis, weights, centre)
        for j in range(STATES):
            y = x.copy()
            y[j] += 1e-7
            body_rates(y, 0.0, 0.0, z, x, k, basis, weights, rates)
            jacobian[:, j] = (rates - centre) / 1e-7
        if not np.all(np.isfinite(jacobian)):
            return float("inf")
        worst = max(worst, float(np.abs(np.linalg.eigvals(jacobian)).max()))
    return worst


def substeps(k: FloatArray, basis: FloatArray, weights: FloatArray, dt: float, slowness: float = 1.0) -> int:
    """Runge-Kutta steps in a sample interval of `dt` [s], of a joint that is so many times slower than the set's."""
    needed = max(dt / (slowness * LONGEST_STEP), dt * fastest_rate(k, basis, weights) / STABLE)
    return int(np.ceil(min(needed, MOST_SUBSTEPS)))
