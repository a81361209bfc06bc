"""The identified joint as a controller's plant: states, forces, instruments, limits."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..generated.condensed_joint import BRANCHES, ELEMENT_STATES
from ..models.hybrid.kernels import VALUES, corrections_at, mass_matrix, prepare, rest_forces
from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled

if TYPE_CHECKING:
    from ..models.hybrid.model import HybridModel

NAMES = (
    "q", "q_dot", "tau", "tau_dot", "beta", "beta_dot",
    *(f"strain_{side}_{i}" for i in range(BRANCHES) for side in ("left", "right")),
    *(name for name, _ in ELEMENT_STATES),
)  # fmt: skip
"""States of the joint, see `pipeline.equations.condensed_joint`."""
UNITS = ("m", "m/s", "1", "1/s", "1", "1/s", *("1",) * (2 * BRANCHES), *(unit for _, unit in ELEMENT_STATES))


ASSUMED_LAG = 4e-3
"""Assumed time constant [s] of unknown converters."""


class Constants(NamedTuple):
    """What the kernels need of one joint: constants, prepared constants, RBF basis and weights."""

    k: FloatArray
    p: FloatArray
    basis: FloatArray
    weights: FloatArray


@dataclass(frozen=True)
class ControlledJoint:
    """One identified joint, or one draw from its posterior.

    Attributes
    ----------
    constants : Constants
        Of the joint.
    offset : float
        Of the laser [m]: reading = q + offset.
    delay : float
        Time [s] by which the voltages act later than measured.
    charging : float
        Time constant [s] with which the membranes charge through their electrodes.
    probe : FloatArray, shape (2,)
        Readings [V] of the probes at zero voltage.
    highest : float
        Largest trained voltage [V].
    wall : float
        Displacement [m] that no motion of the joint passes: half its length. The model's free runs end nearer.
    rests : tuple of float or None
        Readings [m] at which the logs show the joint at rest, left and right; None where they show no two wells.
    """

    constants: Constants
    offset: float
    delay: float
    charging: float
    probe: FloatArray
    highest: float
    wall: float
    rests: tuple[float, float] | None = None

    def reading(self, q: float) -> float:
        """What the laser shows [m] at the displacement q [m]."""
        return q + self.offset

    def displacement(self, reading: float) -> float:
        """The displacement [m] at which the laser shows `reading` [m]."""
        return reading - self.offset


def plant_of(model: "HybridModel", rests: tuple[float, float] | None = None) -> ControlledJoint:
    """The plant of an identified hybrid joint, whose logs show these rests (readings [m])."""
    theta = model.theta
    condensed = model.joint
    instruments = condensed.instruments(theta)
    k = condensed.in_use(theta)
    constants = Constants(k, prepare(k[None])[0], condensed.basis, condensed.weights(theta))
    probe = np.asarray(instruments.probe, dtype=np.float64)
    return ControlledJoint(
        constants,
        float(instruments.offset),
        float(instruments.delay),
        float(instruments.charging),
        probe,
        condensed.largest_voltage,
        0.5 * condensed.length,
        rests,
    )


@compiled
def inertia(x: FloatArray, p: FloatArray) -> FloatArray:
    """The mass matrix of (q, τ, β) at the state x, shape (3, 3) [kg, kg·m, kg·m²]; p are the prepared constants."""
    upper = np.zeros(6)
    mass_matrix(x, p, upper)
    return np.array([[upper[0], upper[1], upper[3]], [upper[1], upper[2], upper[4]], [upper[3], upper[4], upper[5]]])


@compiled
def forces(x: FloatArray, u1: float, u2: float, c: Constants) -> FloatArray:
    """Generalised forces on (q, τ, β) at rest [N, N·m, J], shape (3,), friction left out; u = v² [V²].

    Parameters
    ----------
    x : FloatArray, shape (STATES,)
        State.
    u1, u2 : float
        Squared voltages of left and right [V²].
    c : Constants
        Of the joint.
    """
    u = np.array([u1, u2])
    values = np.zeros(VALUES)
    out = np.empty(3)
    by_shape = np.empty(6)
    corrections_at(x[0], c.basis, c.weights, values)
    rest_forces(x, u, values, c.p, out, by_shape)
    return out
