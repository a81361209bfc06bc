"""Simulators of joints made after one drawing: the reduced analytical model with workshop tolerances."""

import numpy as np

from pipeline.errors import InputError
from pipeline.excitation.design import Simulator
from pipeline.joint.equilibria import equilibria
from pipeline.joint.parameters import JointParameters
from pipeline.joint.reduced_order import simulate_reduced
from pipeline.joint.reduction import reduce_joint
from pipeline.numerics.arrays import FloatArray

_RELATIVE = 0.03  # of the stiffness, rubber and permittivity, uniform
_FREE_LENGTH = 0.3e-3  # m, of each membrane, uniform
_MOST_DRAWS = 40


def drawn_simulators(parameters: JointParameters, rng: np.random.Generator, count: int) -> list[Simulator]:
    """The joint as drawn, and `count` − 1 joints with tolerances that still rest in two wells.

    Raises
    ------
    InputError
        The drawing has no two wells, or too few of the joints made after it have.

    Notes
    -----
    Cost: some 50 ms a joint; a run of 37.5 s takes 4 ms.
    """
    first = _simulator(parameters)
    if first is None:
        raise InputError("the parameter set has no two wells at zero voltage; see `debist physics equilibria`")
    simulators = [first]
    for _ in range(_MOST_DRAWS):
        if len(simulators) == count:
            return simulators
        made = _simulator(_made(parameters, rng))
        if made is not None:
            simulators.append(made)
    if len(simulators) < count:
        raise InputError(
            f"only {len(simulators)} of {_MOST_DRAWS} joints made after the drawing have two wells; "
            "take fewer with --joints, or a drawing that is less near the edge"
        )
    return simulators


def _made(parameters: JointParameters, rng: np.random.Generator) -> JointParameters:
    """A joint as a workshop makes it: both membranes each with its own tolerances."""
    names = ("E", "left.Y", "right.Y", "left.eps_r", "right.eps_r")
    values = {name: parameters.value(name) * (1.0 + rng.uniform(-_RELATIVE, _RELATIVE)) for name in names}
    for name in ("left.l0", "right.l0"):
        values[name] = parameters.value(name) + rng.uniform(-_FREE_LENGTH, _FREE_LENGTH)
    return parameters.with_values(values)


def _simulator(parameters: JointParameters) -> Simulator | None:
    """Motion of the reduced joint from rest in its left well; None without two wells."""
    stable = [found.q for found in equilibria(parameters, np.zeros(2)) if found.stable]
    if len(stable) < 2:
        return None
    reduced, start = reduce_joint(parameters), min(stable)

    def simulate(t: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Displacement [m] and velocity [m/s], shape (N,), at t [s] under the voltages v [V], shape (N, 2)."""
        motion = simulate_reduced(reduced, t, v, start, 0.0)
        return motion.q, motion.q_dot

    return simulate
