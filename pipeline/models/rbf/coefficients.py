"""The numbers in the equation of motion of the data-driven joint, and the basis of its curves.

F, d, h_l, g_k are weights times a common basis: four functions (`POLYNOMIALS`) and Gaussians. The Gaussians, and with
them every curve but F, go on as constants outside [low, high].
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from typing import NamedTuple

import numpy as np

from ...codegen.numba_writer import formula
from ...generated.terms import BELL, CLIPPED, POWERS, TURNING_ARM
from ...numerics.arrays import FloatArray, IntArray
from ...numerics.compiled import compiled, shared
from ...numerics.fixed_step import inlined

_powers = formula(POWERS)
_turning_arm = formula(TURNING_ARM)
_clipped = formula(CLIPPED)
_bell = formula(BELL)

POLYNOMIALS = 4
"""Basis functions 1, x, x², x³ before the Gaussians (1, sin q, cos q, x³ with a wall for a turning arm)."""

FORCE, DAMPING, INPUT = range(3)
"""Rows of the curve weights: F, d, then g_1 … g_K, then h_1 … h_L, then ρ, β_1 … β_K of each shape element."""

WEIGHT, RATE, SLIP_FORCE, SLIP_LENGTH, NUMBER, INPUT_SHAPE = range(6)
"""Kinds of parameters: the `kind` of `SensitivityParameters`; a `NUMBER` is one of those below."""

CENTRE, ARC, DRAG, STOPS = range(3, 7)
"""Places in `ObservedJoint.by` of derivatives by numbers of the equation: arm, arc, drag, the four of the stops."""


class Coefficients(NamedTuple):
    """Everything in the equation of motion but the inputs.

    curves (2+K+L+S(1+K), 4+M) of S shape elements · rates (L,) [1/s] · slip_force (D,), slip_length (D,) · inertia (2,)
    = a, x₀ · centres (M,) · bend = 1/(2σ²) · low, high: ends of the Gaussians' range · arm (2,): the angle q [rad] of a
    turning arm is arm[0] + arm[1] x; zeros for another joint · drag: κ · stops (4,): places of two end stops,
    their stiffness and resistance; empty without · ends (2, 4+M), at_ends (2,): basis and F at low and high.
    """

    curves: FloatArray
    rates: FloatArray
    slip_force: FloatArray
    slip_length: FloatArray
    inertia: FloatArray
    centres: FloatArray
    bend: float
    low: float
    high: float
    arm: FloatArray
    drag: float
    stops: FloatArray
    ends: FloatArray
    at_ends: FloatArray


class SensitivityParameters(NamedTuple):
    """Parameters of the sensitivities: P parameters in B blocks, one behind the other.

    Attributes
    ----------
    kind : IntArray, shape (B,)
        Kind of coefficient that the parameters of a block move.
    first : IntArray, shape (B,)
        Curve of a block of `WEIGHT`; else the element, input shape or number of its first parameter.
    column : IntArray, shape (B,)
        Basis function of the first parameter of a block of `WEIGHT`.
    start : IntArray, shape (B + 1,)
        First parameter of each block, then P.
    factor : FloatArray, shape (P,)
        Derivative of a curve weight, of the inertia, of a stop's number or of the logarithm of a slip length by the
        parameter. Rates, slip forces and drag are taken by their logarithms.
    """

    kind: IntArray
    first: IntArray
    column: IntArray
    start: IntArray
    factor: FloatArray


def no_sensitivities() -> SensitivityParameters:
    """Empty parameters for a simulation without sensitivities."""
    none = np.empty(0, dtype=np.int64)
    return SensitivityParameters(none, none, none, np.zeros(1, dtype=np.int64), np.empty(0))


@inlined
def shapes(c, inputs):
    """Number of relaxing elements with curves of their own."""
    return (len(c.curves) - INPUT - inputs - len(c.rates)) // (1 + inputs)


@shared
def basis_at(x: float, c: Coefficients, values: FloatArray, slopes: FloatArray, curvatures: FloatArray) -> None:
    """The basis (4 + M,) and its derivative at x, and the second derivative of the Gaussians (M,).

    Parameters
    ----------
    x : float
        Dimensionless displacement.
    c : Coefficients
        Numbers of the joint.
    values : FloatArray, shape (4 + M,)
        Takes the basis.
    slopes : FloatArray, shape (4 + M,)
        Takes its derivative.
    curvatures : FloatArray, shape (M,)
        Takes the second derivative of the Gaussians.
    """
    head = _powers((x,)) if c.arm[1] == 0.0 else _turning_arm((x, c.arm[0], c.arm[1]))
    for i in range(POLYNOMIALS):
        values[i], slopes[i] = head[i], head[POLYNOMIALS + i]
    inside, moving = _clipped((x, c.low, c.high))
    for i in range(len(c.centres)):
        value, slope, curvature = _bell((inside, c.centres[i], c.bend))
        values[POLYNOMIALS + i], slopes[POLYNOMIALS + i] = value, slope * moving
        curvatures[i] = curvature * moving


@compiled
def basis_rows(x: FloatArray, c: Coefficients) -> FloatArray:
    """The basis at all x, shape (N, 4 + M)."""
    values = np.empty((len(x), c.curves.shape[1]))
    slopes = np.empty(c.curves.shape[1])
    curvatures = np.empty(len(c.centres))
    for n in range(len(x)):
        basis_at(x[n], c, values[n], slopes, curvatures)
    return values
