"""The joint's rates, inertia and stop operators for the estimator: the generated kernels behind plain functions."""

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.condensed_joint import STATES, STOPS
from pipeline.joint.condensed_kernels import INDEX, VALUES, corrections_at, joint_rates, mass_matrix
from pipeline.numerics.arrays import FloatArray

_ARM, _TRAVEL = INDEX["friction_arm"], INDEX["stop_travel_0"]


@compiled
def body_rates(
    x: FloatArray, u1: float, u2: float, z: FloatArray, start: FloatArray, p: FloatArray, basis: FloatArray,
    weights: FloatArray, rates: FloatArray,
) -> None:  # fmt: skip
    """Fill the rates of the state x, both shape (STATES,), under squared voltages [V²].

    `z`, shape (STOPS,), are the stop operators at the state `start`, `p` the prepared constants; `basis` and `weights`
    see `pipeline.joint.condensed_kernels`. Cost: 0.2 µs.
    """
    u, c, begin = np.zeros(2), np.zeros(VALUES), np.zeros(2)
    u[0] = u1
    u[1] = u2
    begin[0] = start[0]
    begin[1] = start[2]
    corrections_at(x[0], basis, weights, c)
    joint_rates(x, u, c, z, begin, p, rates)


@compiled
def inertias(x: FloatArray, p: FloatArray) -> tuple[float, float, float]:
    """M_qq [kg], M_qτ [kg·m] and M_ττ [kg·m²] at the state x."""
    mass = np.zeros(3)
    mass_matrix(x, p, mass)
    return mass[0], mass[1], mass[2]


@compiled
def advance_stops(z: FloatArray, before: FloatArray, after: FloatArray, k: FloatArray) -> None:
    """Stop operators after the move from one state to another, in place: z ← clip(z + play / travel, −1, 1)."""
    play = after[0] - before[0] + k[_ARM] * (after[2] - before[2])
    for i in range(STOPS):
        z[i] = min(1.0, max(-1.0, z[i] + play / k[_TRAVEL + i]))


__all__ = ["STATES", "STOPS", "advance_stops", "body_rates", "inertias"]
