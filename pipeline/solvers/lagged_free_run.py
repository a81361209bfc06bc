"""Free run of the lagged RBF model (eqs. 37-40): nothing is fed back from the measurement.

Classical Runge-Kutta steps of fixed length with the voltages linear between samples. The fixed step makes a run
reproducible to the last bit and bounds its time; the number of steps per sample follows from the lag, the fastest
known time constant of the model.
"""

from typing import Literal

import numba
import numpy as np

from pipeline.numerics.arrays import FloatArray

MAX_STEP = 5e-3
"""Longest integration step [s]: 70 steps per period of the 2.8 Hz ringing in a well, 20 of the fastest at 9 Hz."""

NEGLIGIBLE = 37.0
"""Exponent beyond which a bell is below the rounding error of its neighbours."""

LAG_STEP = 0.5
"""Longest step as a share of the lag; Runge-Kutta 4 is stable up to 2.78 and accurate to 1e-4 at 0.5."""


def steps_per_sample(interval: float, time_constant: float) -> int:
    """Integration steps per sample interval for a model whose fastest lag is `time_constant` [s]."""
    return int(np.ceil(interval / min(MAX_STEP, LAG_STEP * time_constant)))


def escape_bounds(low: float, high: float) -> tuple[float, float]:
    """Displacements beyond which a run counts as diverged: two operating ranges past either end of the data."""
    return low - 2.0 * (high - low), high + 2.0 * (high - low)


@numba.njit(cache=True)
def _curves(q: float, centres: FloatArray, weights: FloatArray, bend: float, values: FloatArray) -> None:
    """All curves at q: values_s = Σ_i θ_s,i exp(−bend (q−ξ_i)²), without the negligible."""
    values[:] = 0.0
    for i in range(len(centres)):
        exponent = bend * (q - centres[i]) ** 2
        if exponent < NEGLIGIBLE:
            bell = np.exp(-exponent)
            for s in range(len(values)):
                values[s] += weights[i, s] * bell


@numba.njit(cache=True)
def lagged_rbf_acceleration(
    q: float, z: float, u: FloatArray, centres: FloatArray, weights: FloatArray, bend: float, values: FloatArray
) -> float:
    """q̈ = −c(q) q − d(q) z + Σ g_k(q) u_k of curves per unit mass; `bend` is 1/(2σ²), `values` (2 + K,) is filled."""
    _curves(q, centres, weights, bend, values)
    total: float = -values[0] * q - values[1] * z
    for k in range(len(u)):
        total += values[2 + k] * u[k]
    return total


@numba.njit(cache=True)
def lagged_rbf_run(
    v: FloatArray,
    squared: bool,
    interval: float,
    steps: int,
    start: tuple[float, float],
    centres: FloatArray,
    weights: FloatArray,
    width: float,
    time_constant: float,
    bounds: tuple[float, float],
) -> tuple[FloatArray, int]:
    """Integrate q̈ = −c q − d z + Σ g_k u_k, ż = (q̇ − z)/T_z from `start` with z(0) = q̇(0).

    Parameters
    ----------
    v : FloatArray, shape (N, K)
        Voltages at the samples [V], linear in between; u = v² if `squared`, else v.
    squared : bool
        Whether the force goes with the square of the voltage.
    interval : float
        Sample interval [s].
    steps : int
        Runge-Kutta steps per interval.
    start : (float, float)
        q(0) [m], q̇(0) [m/s].
    centres : FloatArray, shape (M,)
        ξ_i, in the unit of q.
    weights : FloatArray, shape (M, 2 + K)
        Columns c, d, g_1 … g_K, divided by the mass.
    width : float
        σ of the bells, in the unit of q.
    time_constant : float
        T_z [s].
    bounds : (float, float)
        The run ends as soon as q leaves them.

    Returns
    -------
    states : FloatArray, shape (N, 3)
        q, q̇, q̈ at the samples; NaN after divergence.
    valid : int
        Samples within the bounds; N if the run completed. Cost: 4·steps·N evaluations of M exponentials and
        (2 + K)·M products, about 60 ns each for M = 10.
    """
    count, inputs = v.shape
    states = np.full((count, 3), np.nan)
    values = np.empty(2 + inputs)
    u = np.empty(inputs)
    bend = 0.5 / (width * width)
    h = interval / steps
    q, p, z = start[0], start[1], start[1]
    for n in range(count):
        if not (bounds[0] <= q <= bounds[1] and np.isfinite(p) and np.isfinite(z)):
            return states, n
        for k in range(inputs):
            u[k] = v[n, k] ** 2 if squared else v[n, k]
        states[n] = q, p, lagged_rbf_acceleration(q, z, u, centres, weights, bend, values)
        if n == count - 1:
            break
        for step in range(steps):
            dq = dp = dz = 0.0
            sum_q = sum_p = sum_z = 0.0
            for stage in range(4):
                share = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
                where = (step + share) / steps
                for k in range(inputs):
                    volts = v[n, k] + where * (v[n + 1, k] - v[n, k])
                    u[k] = volts * volts if squared else volts
                q_s, p_s, z_s = q + share * h * dq, p + share * h * dp, z + share * h * dz
                dq = p_s
                dp = lagged_rbf_acceleration(q_s, z_s, u, centres, weights, bend, values)
                dz = (p_s - z_s) / time_constant
                weight = 1.0 if stage in (0, 3) else 2.0
                sum_q, sum_p, sum_z = sum_q + weight * dq, sum_p + weight * dp, sum_z + weight * dz
            q, p, z = q + h / 6.0 * sum_q, p + h / 6.0 * sum_p, z + h / 6.0 * sum_z
    return states, count


def run_status(t: FloatArray, valid: int) -> tuple[Literal["ok", "diverged"], float | None]:
    """Status of a run with `valid` good samples, and the time [s] of its divergence."""
    return ("ok", None) if valid == len(t) else ("diverged", float(t[valid]))
