"""Free and observed runs of many slow-coordinate joints through the same log, `LANES` of them at once.

The steps are those of `pipeline.joint.body_run`: classical Runge-Kutta at a fixed step, stop operators exact in it.
"""

import numba
import numpy as np
from numpy.typing import NDArray

from pipeline.generated.body_lanes import CORRECTION, INPUT, LANES, RATE, ROWS, START, STATE, STOP, TOTAL, lane_rates
from pipeline.joint.body import INDEX, STATES, STOPS
from pipeline.joint.body_run import rest_state
from pipeline.joint.correction_table import VALUES, look_up, table_span, tabulate
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.vector_math import FAST

_ARM, _TRAVEL = INDEX["friction_arm"], INDEX["stop_travel_0"]
_WIDTH = STATES * LANES


def run_batch(
    constants: FloatArray, weights: FloatArray, basis: FloatArray, u: FloatArray, variant: NDArray[np.int64],
    seen: FloatArray, start: FloatArray, observed: FloatArray, gain: FloatArray, dt: float, substeps: int,
    q_stop: float, lead: float, every_step: bool = False,
) -> FloatArray:  # fmt: skip
    """Simulate joints from rest, freely or held near a measured displacement by an observer.

    Parameters
    ----------
    constants : FloatArray, shape (B, len(ENTRIES))
        Constants of each joint.
    weights : FloatArray, shape (B, CORRECTIONS, M)
        Weights of its corrections.
    basis : FloatArray, shape (3,)
        See `pipeline.joint.body.corrections`.
    u : FloatArray, shape (V, 2 substeps (N−1) + 1, 2)
        Squared voltages [V²] on the half steps, as V different sets of instruments show them.
    variant : NDArray[int64], shape (B,)
        Which of them drives each joint.
    seen : FloatArray, shape (B, 2)
        Gain [1] and offset [m] of each joint's laser: reading = gain × q + offset.
    start : FloatArray, shape (2,) or (B, 2)
        Reading [m] and its rate [m/s] at the first sample, of all joints or of each.
    observed : FloatArray, shape (2 substeps (N−1) + 1,) or (0,)
        Reading [m] on the half steps, for the observer.
    gain : FloatArray, shape (N,)
        Observer pole L [1/s] in each sample interval; 0 is a free run.
    dt, substeps : float, int
        Sample interval [s] and Runge-Kutta steps in it.
    q_stop : float
        Displacement [m] of the wall that confines every run.
    lead : float
        dτ/dq [1/m] of slow motions: the observer moves q and τ together (see `run_lanes`).
    every_step : bool
        Return every Runge-Kutta step, not the samples alone.

    Returns
    -------
    FloatArray, shape (B, N, 3) or (B, substeps (N−1) + 1, 3)
        q, q̇, q̈ as the laser reads them; NaN from the sample on at which the state is no longer finite.
        Cost: 0.2 µs for each step of `LANES` joints and stage, and 0.07 µs for the corrections of each joint;
        37.5 s at 3.3 ms take 9 ms for one joint or eight.
    """
    count, span = len(constants), table_span(basis, weights.shape[2])
    alike = bool(np.all(weights == weights[:1]))
    tables = tabulate(basis, weights[:1] if alike else weights)
    starts = np.broadcast_to(start, (count, 2))
    shown = 1 if every_step else substeps
    out = np.empty((count, substeps * (len(gain) - 1) // shown + 1, 3))
    for first in range(0, count, LANES):
        lanes = np.minimum(np.arange(first, first + LANES), count - 1)
        kept = min(LANES, count - first)
        block = _resting(constants[lanes], weights[lanes], basis, u, variant[lanes], seen[lanes], starts[lanes])
        runs = run_lanes(
            block, u, variant[lanes], observed, np.ascontiguousarray(seen[lanes].T), gain, dt, substeps, span,
            tables, np.zeros(kept, dtype=np.int64) if alike else lanes[:kept], q_stop, lead,
        )  # fmt: skip
        out[first : first + kept] = runs[::shown].transpose(2, 0, 1)[:kept]
    lost = np.logical_or.accumulate(~np.isfinite(out).all(axis=2), axis=1)
    out[lost] = np.nan
    out *= seen[:, 0, None, None]
    out[:, :, 0] += seen[:, 1, None]
    return out


@numba.njit(cache=True)
def _resting(
    constants: FloatArray, weights: FloatArray, basis: FloatArray, u: FloatArray, variant: NDArray[np.int64],
    seen: FloatArray, start: FloatArray,
) -> FloatArray:  # fmt: skip
    """The block of joints at rest at the first sample."""
    block = np.zeros(ROWS * LANES)
    for j in range(LANES):
        k = constants[j]
        same = j > 0 and np.all(constants[j] == constants[j - 1]) and np.all(weights[j] == weights[j - 1])
        same = same and np.all(seen[j] == seen[j - 1]) and np.all(start[j] == start[j - 1])
        if not (same and variant[j] == variant[j - 1]):
            q = (start[j, 0] - seen[j, 1]) / seen[j, 0]
            x, z = rest_state(q, u[variant[j], 0, 0], u[variant[j], 0, 1], k, basis, weights[j])
            x[1] = start[j, 1] / seen[j, 0]
        for i in range(len(k)):
            block[i * LANES + j] = k[i]
        for i in range(STATES):
            block[(STATE + i) * LANES + j] = x[i]
        for i in range(STOPS):
            block[(STOP + i) * LANES + j] = z[i]
    return block


@numba.njit(cache=True, error_model="numpy", fastmath=FAST)
def run_lanes(
    block: FloatArray, u: FloatArray, variant: NDArray[np.int64], observed: FloatArray, seen: FloatArray,
    gain: FloatArray, dt: float, substeps: int, span: FloatArray, tables: FloatArray,
    table_of: NDArray[np.int64], q_stop: float, lead: float,
) -> FloatArray:  # fmt: skip
    """`LANES` runs from the state in `block`; q, q̇, q̈ at every step, shape (substeps (N−1) + 1, 3, LANES), no laser.

    The observer pulls along the slow motion of the beam, (q, τ) together: q̇ += 2L e, q̈ += L² e with e = q_m − q, and
    the same times dτ/dq for τ. Pulling at q alone leaves the pair of q and τ with a growing mode near the separatrix
    (rates up to 3 1/s), so that even the true joint drifts off its own measurement.
    """
    samples = len(gain)
    out = np.empty((substeps * (samples - 1) + 1, 3, LANES))
    h, state, begin, rate, total = dt / substeps, STATE * LANES, START * LANES, RATE * LANES, TOTAL * LANES
    for n in range(samples):
        pole, steps = gain[n], substeps if n < samples - 1 else 1  # the last one only shows the acceleration
        for s in range(steps):
            first = 2 * (n * substeps + s)
            for i in range(_WIDTH):
                block[begin + i] = block[state + i]
                block[total + i] = 0.0
            for stage in range(4):
                at = min(first + (stage + 1) // 2, u.shape[1] - 1)
                if stage != 2:
                    _inputs(block, u, variant, at)
                if tables.shape[1] > 0:
                    _correct(block, span, tables, table_of)
                lane_rates(block)
                if stage == 0:
                    row = n * substeps + s
                    for j in range(LANES):
                        out[row, 0, j], out[row, 1, j] = block[state + j], block[state + LANES + j]
                        out[row, 2, j] = block[rate + LANES + j]
                if pole > 0.0 and n < samples - 1:
                    _observe(block, observed[at], seen, pole, lead)
                share = 2.0 if stage == 1 or stage == 2 else 1.0
                ahead = h if stage == 2 else 0.5 * h
                for i in range(_WIDTH):
                    block[total + i] += share * block[rate + i]
                    block[state + i] = block[begin + i] + ahead * block[rate + i]
            for i in range(_WIDTH):
                block[state + i] = block[begin + i] + h / 6.0 * block[total + i]
            for j in range(LANES):
                q = block[state + j]
                if abs(q) > q_stop:
                    block[state + j] = q_stop if q > 0.0 else -q_stop
                    block[state + LANES + j] = 0.0
            _advance(block)
    return out


@numba.njit(cache=True, forceinline=True, error_model="numpy", fastmath=FAST)
def _inputs(block: FloatArray, u: FloatArray, variant: NDArray[np.int64], at: int) -> None:
    """Squared voltages on the half step `at`."""
    for j in range(LANES):
        block[INPUT * LANES + j] = u[variant[j], at, 0]
        block[(INPUT + 1) * LANES + j] = u[variant[j], at, 1]


@numba.njit(cache=True, forceinline=True, error_model="numpy", fastmath=FAST)
def _observe(block: FloatArray, reading: float, seen: FloatArray, pole: float, lead: float) -> None:
    for j in range(LANES):
        error = (reading - seen[1, j]) / seen[0, j] - block[STATE * LANES + j]
        pull, push = 2.0 * pole * error, pole * pole * error
        block[RATE * LANES + j] += pull
        block[(RATE + 1) * LANES + j] += push
        block[(RATE + 2) * LANES + j] += lead * pull
        block[(RATE + 3) * LANES + j] += lead * push


@numba.njit(cache=True, forceinline=True, error_model="numpy", fastmath=FAST)
def _advance(block: FloatArray) -> None:
    """Stop operators after a step: z ← clip(z + play / travel, −1, 1)."""
    for i in range(STOPS):
        for j in range(LANES):
            play = block[STATE * LANES + j] - block[START * LANES + j]
            play += block[_ARM * LANES + j] * (block[(STATE + 2) * LANES + j] - block[(START + 2) * LANES + j])
            z = block[(STOP + i) * LANES + j] + play / block[(_TRAVEL + i) * LANES + j]
            block[(STOP + i) * LANES + j] = min(1.0, max(-1.0, z))


@numba.njit(cache=True, forceinline=True, error_model="numpy", fastmath=FAST)
def _correct(block: FloatArray, span: FloatArray, tables: FloatArray, table_of: NDArray[np.int64]) -> None:
    """RBF corrections of each joint; lanes that only repeat the last one take over its own."""
    for j in range(len(table_of)):
        look_up(block[STATE * LANES + j], span, tables[table_of[j]], block, CORRECTION * LANES + j, LANES)
    last = len(table_of) - 1
    for i in range(VALUES):
        for j in range(last + 1, LANES):
            block[(CORRECTION + i) * LANES + j] = block[(CORRECTION + i) * LANES + last]
