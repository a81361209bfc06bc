"""What a data-driven joint consists of, and the units that make it dimensionless."""

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

Hold = Literal["linear", "zero", "cubic", "record"]
"""How an input goes on between samples: on lines, held (a converter's zero-order hold), on a cubic spline, or as the
finer record has it."""

OVERDAMPED = 7.0
"""Damping of an overdamped device to start from, in units of the frequency scale: its inertia acts for a hundredth of
the time in which it crosses half its range."""

ForceShape = Literal["curve", "polynomial", "offset"]
"""Restoring force: polynomial and Gaussians, the polynomial alone, or a constant (a free mass)."""


@dataclass(frozen=True)
class JointStructure:
    """What the data-driven joint consists of.

    Attributes
    ----------
    basis_functions : int
        Gaussians M per curve.
    smoothing : float
        σ_n.
    rates : tuple of float
        Relaxation rates of the L hidden elements to start from, in units of the joint's own frequency scale.
    shape_elements : int
        The first so many elements are hidden shapes (the slope of the tip, the beam's interior): their rates depend on
        the displacement, and the inputs pull at them.
    slips : int
        Dahl friction states.
    arc : bool
        Whether the inertia may vary with the displacement (a tip on an arc).
    input_lag : bool
        Whether the inputs act through a first-order lag (a propeller, a slow drive).
    drag : bool
        Whether a fluid's drag acts, by the square of the speed.
    stops : bool
        Whether the motion may meet two end stops.
    turning_arm : bool
        Whether q is the angle of an arm on which weight acts: sin q and cos q instead of x and x² in the basis.
    force : {"curve", "polynomial", "offset"}
        Shape of the restoring force.
    constant_damping, constant_gain : bool
        Whether d and the g_k are numbers instead of curves.
    hold : {"linear", "zero", "cubic", "record"}
        The inputs between samples.
    rest_at_zero : bool
        Whether hidden states start as after a long rest without inputs, instead of under the first ones.
    input_delay : bool
        Whether the inputs act later than they were measured by a constant time.
    bent_input : bool
        Whether the inputs act by a curve of their own, steeper or flatter at zero than a line.
    dead_zone : bool
        Whether small inputs do nothing.
    overdamped : bool
        Whether damping is expected to hold the motion so much that inertia hardly matters (a soft actuator, a level, a
        temperature). The equation is the same; its start and its scales are of the velocity, not the acceleration.
    """

    basis_functions: int = 12
    smoothing: float = 1.0
    rates: tuple[float, ...] = (0.15, 1.5)
    shape_elements: int = 1
    slips: int = 1
    arc: bool = True
    drag: bool = False
    stops: bool = False
    input_lag: bool = False
    turning_arm: bool = False
    force: ForceShape = "curve"
    constant_damping: bool = False
    constant_gain: bool = False
    hold: Hold = "linear"
    rest_at_zero: bool = False
    input_delay: bool = False
    bent_input: bool = False
    dead_zone: bool = False
    overdamped: bool = False

    @property
    def remembers_inputs(self) -> bool:
        """Whether a hidden state depends on what the inputs were before the first sample."""
        return self.input_lag or self.shape_elements > 0

    def to_tree(self) -> dict[str, Any]:
        """Plain values."""
        return {**vars(self), "rates": np.array(self.rates)}


@dataclass(frozen=True)
class Scales:
    """Units of the dimensionless joint.

    Middle and half range of q, largest |v|, RMS of q̈ [1/s²] and of q̇ [1/s] over half the range.
    """

    middle: float
    half: float
    volts: float
    stiffness: float
    speed: float = 0.0

    @property
    def frequency(self) -> float:
        """Frequency scale of the joint [rad/s]."""
        return float(np.sqrt(2.0 * self.stiffness))

    @property
    def overdamped(self) -> "Scales":
        """The same where damping of `OVERDAMPED` times the frequency scale makes the force scale of the speed."""
        return replace(self, stiffness=2.0 * (OVERDAMPED * self.speed) ** 2)
