"""Dynamics whose right-hand side is a table of monomials: evaluation and free-run simulation."""

from dataclasses import dataclass

import numba
import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.lag import first_order_lag
from pipeline.solvers.lagged_free_run import steps_per_sample

# Columns of an exponent table; one column per input follows.
Q, QDOT, LAG, FRICTION, SINE, COSINE, FIRST_INPUT = 0, 1, 2, 3, 4, 5, 6


@dataclass(frozen=True)
class PolynomialDynamics:
    """``[q̇, q̈] = C · monomials(x)``, ``ż = (q̇ − z)/T_z``, x the scaled [q, q̇, z, tanh(q̇/w), sin q, cos q, u1 … uK].

    Attributes
    ----------
    exponents : IntArray, shape (P, 6 + K)
        Powers of the scaled variables, one row per monomial.
    coefficients : FloatArray, shape (2, P)
        Row 0 gives q̇ [m/s], row 1 gives q̈ [m/s²]. A fixed structure q̇ = v is a single entry in row 0.
    scales : FloatArray, shape (6 + K,)
        Scale of each variable [m, m/s, m/s, m/s, 1, 1, V² or V …]; entry 3 is the speed w inside the tanh.
    lag_time : float
        T_z [s] of the lag state; 0 where the model has none.
    squared : bool
        Whether the inputs are v² (electrostatic) or v.
    low, high : float
        Displacement [m] outside of which a run counts as diverged.
    """

    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    lag_time: float
    squared: bool
    low: float
    high: float


@numba.njit(cache=True)
def polynomial_rates(exponents, coefficients, x, out):  # type: ignore[no-untyped-def]
    """Add up C · monomials(x) into `out` (2,); powers by repeated multiplication, zero exponents cost a test."""
    out[0] = 0.0
    out[1] = 0.0
    for p in range(exponents.shape[0]):
        product = 1.0
        for k in range(exponents.shape[1]):
            for _ in range(exponents[p, k]):
                product *= x[k]
        out[0] += coefficients[0, p] * product
        out[1] += coefficients[1, p] * product


@numba.njit(cache=True)
def _scaled_state(state, u0, u1, fraction, squared, trigonometric, scales, x):  # type: ignore[no-untyped-def]
    """Fill the scaled variables; the voltage is linear between samples and squared afterwards."""
    x[0] = state[0] / scales[0]
    x[1] = state[1] / scales[1]
    x[2] = state[2] / scales[2]
    x[3] = np.tanh(state[1] / scales[3])
    if trigonometric:
        x[4] = np.sin(state[0])
        x[5] = np.cos(state[0])
    for k in range(u0.shape[0]):
        voltage = u0[k] + fraction * (u1[k] - u0[k])
        x[6 + k] = (voltage * voltage if squared else voltage) / scales[6 + k]


@numba.njit(cache=True)
def _free_run(exponents, coefficients, scales, lag_time, squared, low, high, v, dt, substeps, q0, qdot0):  # type: ignore[no-untyped-def]
    samples = v.shape[0]
    path = np.full((samples, 3), np.nan)
    x = np.zeros(6 + v.shape[1])
    trigonometric = np.any(exponents[:, 4:6])
    state = np.array([q0, qdot0, qdot0])
    stage = np.empty(3)
    slopes = np.zeros((4, 3))
    rate = np.empty(2)
    h = dt / substeps
    for n in range(samples):
        _scaled_state(state, v[n], v[n], 0.0, squared, trigonometric, scales, x)
        polynomial_rates(exponents, coefficients, x, rate)
        if not (low <= state[0] <= high and np.isfinite(rate[1])):
            return path, n
        path[n, 0], path[n, 1], path[n, 2] = state[0], state[1], rate[1]
        if n + 1 == samples:
            break
        for s in range(substeps):
            for r in range(4):
                reach = 0.0 if r == 0 else (h if r == 3 else 0.5 * h)
                for i in range(3):
                    stage[i] = state[i] + (reach * slopes[r - 1, i] if r > 0 else 0.0)
                _scaled_state(stage, v[n], v[n + 1], (s * h + reach) / dt, squared, trigonometric, scales, x)
                polynomial_rates(exponents, coefficients, x, rate)
                slopes[r, 0], slopes[r, 1] = rate[0], rate[1]
                slopes[r, 2] = (stage[1] - stage[2]) / lag_time if lag_time > 0.0 else 0.0
            for i in range(3):
                state[i] += h / 6.0 * (slopes[0, i] + 2.0 * slopes[1, i] + 2.0 * slopes[2, i] + slopes[3, i])
    return path, samples


def free_run(
    dynamics: PolynomialDynamics, v: FloatArray, interval: float, q0: float, qdot0: float
) -> tuple[FloatArray, int]:
    """Simulate from ``(q0, qdot0)`` with z(0) = q̇0 by classical Runge-Kutta steps as in `numerics.free_run`.

    Parameters
    ----------
    dynamics : PolynomialDynamics
        The right-hand side.
    v : FloatArray, shape (N, K)
        Voltages [V], linear between samples.
    interval : float
        Sample interval [s].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s].

    Returns
    -------
    path : FloatArray, shape (N, 3)
        q, q̇, q̈; NaN from the sample on where the run left the bounds or stopped being finite.
    reached : int
        Samples simulated; N for a whole run.
        Cost: 4 evaluations of the table per step, about 1 ns per factor of a monomial.
    """
    d = dynamics
    steps = steps_per_sample(interval, d.lag_time if d.lag_time > 0.0 else np.inf)
    path, reached = _free_run(
        d.exponents, d.coefficients, d.scales, d.lag_time, d.squared, d.low, d.high,
        np.ascontiguousarray(v), interval, steps, float(q0), float(qdot0),
    )  # fmt: skip
    return path, int(reached)


def lag_state(qdot: FloatArray, interval: float, lag_time: float) -> FloatArray:
    """Z along a measured velocity, z(0) = q̇(0); zeros for a model without the lag state (`lag_time` 0)."""
    if lag_time == 0.0:
        return np.zeros_like(qdot)
    return first_order_lag(np.ascontiguousarray(qdot), interval, lag_time)[0]


def scaled_variables(
    scales: FloatArray, squared: bool, v: FloatArray, q: FloatArray, qdot: FloatArray, z: FloatArray
) -> FloatArray:
    """The scaled variables along a measured path, shape (N, 6 + K); columns as in `PolynomialDynamics`."""
    u = np.square(v) if squared else v
    columns = np.column_stack([q, qdot, z, np.zeros_like(q), np.sin(q), np.cos(q), u]) / scales
    columns[:, FRICTION] = np.tanh(qdot / scales[FRICTION])
    return columns


def monomials(exponents: IntArray, x: FloatArray) -> FloatArray:
    """The library matrix: each row of `exponents` applied to the rows of `x`, shape (N, P)."""
    powers = [np.ones_like(x)]
    for _ in range(int(exponents.max(initial=0))):
        powers.append(powers[-1] * x)
    library = np.ones((len(x), len(exponents)))
    for p, row in enumerate(exponents):
        for k in np.flatnonzero(row):
            library[:, p] *= powers[row[k]][:, k]
    return library
