"""Numbers and state equation of the data-driven joint, in a run of kernels and for traced values.

It is that of `pipeline.equations.elements`, which has one curve, relaxing element or friction state of each
kind; here they are summed over as many as a joint has. F goes on as its cubic outside [low, high], but restores there
at least as much as at the end, so that without inputs nothing rests far outside.

F, d, h_l, g_k are weights times a common basis: four functions (`POLYNOMIALS`) and Gaussians. The Gaussians, and with
them every curve but F, go on as constants outside [low, high].

Friction states are exact (`elements.dahl_move`): within a step they are those of the distance travelled so far.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...codegen.numba_writer import formula
from ...generated.terms import (
    ACCELERATION,
    BELL,
    CLIPPED,
    CONFINED_FORCE,
    DAHL_MOVE,
    ELEMENT,
    POWERS,
    STOP_FORCE,
    TURNING_ARM,
)
from ...numerics.arrays import FloatArray, IntArray
from ...numerics.compiled import compiled, shared
from ...numerics.fixed_step import inlined

_powers = formula(POWERS)
_turning_arm = formula(TURNING_ARM)
_clipped = formula(CLIPPED)
_bell = formula(BELL)
_acceleration = formula(ACCELERATION)
_dahl_move = formula(DAHL_MOVE)
_stop_force = formula(STOP_FORCE)
_confined = formula(CONFINED_FORCE)
element = formula(ELEMENT)

POLYNOMIALS = 4
"""Basis functions 1, x, x², x³ before the Gaussians (1, sin q, cos q, x³ with a wall for a turning arm)."""

FORCE, DAMPING, INPUT = range(3)
"""Rows of the curve weights: F, d, then g_1 … g_K, then h_1 … h_L, then ρ, β_1 … β_K of each shape element."""

WEIGHT, RATE, SLIP_FORCE, SLIP_LENGTH, NUMBER, INPUT_SHAPE = range(6)
"""Kinds of parameters: the `kind` of `SensitivityParameters`; a `NUMBER` is one of those below."""

CENTRE, ARC, DRAG, STOPS = range(3, 7)
"""Places in `ObservedJoint.by` of derivatives by numbers of the equation: arm, arc, drag, the four of the stops."""


class Coefficients(NamedTuple):
    """Everything in the equation of motion but the K inputs, for L relaxing elements, S of them shapes, and D slips.

    Attributes
    ----------
    curves : FloatArray, shape (2 + K + L + S (1 + K), 4 + M)
        Weights of the curves, in the order of the rows above.
    rates : FloatArray, shape (L,)
        Relaxation rates [1/s].
    slip_force, slip_length : FloatArray, shape (D,)
        Forces and lengths of Dahl friction.
    inertia : FloatArray, shape (2,)
        a and x₀ of a tip on an arc.
    centres : FloatArray, shape (M,)
        Centres of the Gaussians.
    bend : float
        1/(2σ²).
    low, high : float
        Ends of the Gaussians' range.
    arm : FloatArray, shape (2,)
        The angle q [rad] of a turning arm is arm[0] + arm[1] x; zeros for another joint.
    drag : float
        κ.
    stops : FloatArray, shape (4,) or (0,)
        Places of two end stops, their stiffness and resistance; empty without stops.
    ends : FloatArray, shape (2, 4 + M)
        Basis at `low` and `high`.
    at_ends : FloatArray, shape (2,)
        F there.
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


INSIDE, LEFT, RIGHT = range(STOPS + 4, STOPS + 7)
"""Places of the derivatives of the confined force by F, and by F at the ends of its reach."""

LOAD, PULL, RATE_NOW, OWN_SLOPE = range(4)
"""Rows of `ObservedJoint.relaxing`."""


class ObservedJoint(NamedTuple):
    """A joint in a run. The state is x, p and L relaxing elements, then their P sensitivities, row by row.

    Attributes
    ----------
    c, wrt, u, du, held
        As in `observed_run`.
    measured : FloatArray, shape (n,)
        x at every half step.
    observer : FloatArray, shape (N,)
        Observer gain of each interval [1/s].
    parts : int
        Half steps in an interval.
    now : FloatArray, shape (2,)
        Half step at which the step began, and its observer gain.
    began : FloatArray, shape (1 + P,)
        x there and its sensitivities.
    slip, sliding : FloatArray, shape (D, 1 + P)
        Friction states there, and as they act.
    basis, slopes : FloatArray, shape (4 + M,)
        Basis at x and its slopes.
    curvatures : FloatArray, shape (M,)
        Second derivatives of the Gaussians.
    values, changes : FloatArray, shape (C,)
        The C curves at x and their slopes.
    by_curve : FloatArray, shape (C,)
        Derivatives of ṗ by the curves.
    by : FloatArray, shape (13,)
        Derivatives of ṗ by x, p, push, arm, arc, drag and the four numbers of the stops; then those of the confined
        force from `INSIDE` on.
    relaxing : FloatArray, shape (4, L)
        Of each element its load, the inputs' pull on its place, its rate, and the part of ∂ẇ/∂x that its own curves
        make.
    states : FloatArray, shape (N, 3 + L + D)
        States at the samples; filled.
    sensitivity : FloatArray, shape (N, P)
        Sensitivities of x at the samples; filled.
    """

    c: Coefficients
    wrt: SensitivityParameters
    u: FloatArray
    du: FloatArray
    held: bool
    measured: FloatArray
    observer: FloatArray
    parts: int
    now: FloatArray
    began: FloatArray
    slip: FloatArray
    sliding: FloatArray
    basis: FloatArray
    slopes: FloatArray
    curvatures: FloatArray
    values: FloatArray
    changes: FloatArray
    by_curve: FloatArray
    by: FloatArray
    relaxing: FloatArray
    states: FloatArray
    sensitivity: FloatArray


@inlined
def move(system, x, u, dx):
    """Rates of the state without the observer, and what their derivatives need.

    Parameters
    ----------
    system : NamedTuple
        The joint with its arrays.
    x : FloatArray, shape (n,)
        State.
    u : FloatArray, shape (K,)
        Inputs that act.
    dx : FloatArray, shape (n,)
        Takes the rates.
    """
    c = system.c
    inputs = len(u)
    p = x[1]
    basis = system.basis
    slopes = system.slopes
    values = system.values
    by_curve = system.by_curve
    basis_at(x[0], c, basis, slopes, system.curvatures)
    push = change = 0.0
    for i in range(c.curves.shape[0]):
        value = slope = 0.0
        for j in range(c.curves.shape[1]):
            value += c.curves[i, j] * basis[j]
            slope += c.curves[i, j] * slopes[j]
        values[i], system.changes[i] = value, slope
    _load(system, x, u)
    for i in range(INPUT, INPUT + inputs + len(c.rates)):
        by_curve[i] = u[i - INPUT] if i < INPUT + inputs else -system.relaxing[LOAD, i - INPUT - inputs]
        push += values[i] * by_curve[i]
        change += system.changes[i] * by_curve[i]
    for n in range(shapes(c, inputs)):
        push += x[2 + n] * system.relaxing[PULL, n]
        change += values[INPUT + inputs + n] * system.relaxing[PULL, n]
        change += x[2 + n] * _bent_pull(system, n, u)
    for n in range(len(system.sliding)):
        push -= c.slip_force[n] * system.sliding[n, 0]
    stopped = _stopped(c, x[0], p)
    push, change = push + stopped[0], change + stopped[1]
    force, force_slope = _restoring(system, x[0])
    dx[0] = p
    dx[1], by_p, by_curve[FORCE], by_curve[DAMPING], by_push, by_arm, by_arc, by_drag = _acceleration(
        (p, force, values[DAMPING], push, x[0] - c.inertia[1], c.inertia[0], c.drag)
    )
    by_p += by_push * stopped[2]
    by_x = by_push * change + by_arm
    by_x += by_curve[FORCE] * force_slope + by_curve[DAMPING] * system.changes[DAMPING]
    for i in range(INPUT, INPUT + inputs + len(c.rates)):
        by_curve[i] *= by_push
    system.by[0], system.by[1], system.by[2] = by_x, by_p, by_push
    system.by[CENTRE], system.by[ARC], system.by[DRAG] = by_arm, by_arc, by_drag
    for i in range(len(c.stops)):
        system.by[STOPS + i] = by_push * stopped[3 + i]
    for n in range(len(c.rates)):
        dx[2 + n] = element((values[INPUT + inputs + n], p, system.relaxing[RATE_NOW, n], system.relaxing[LOAD, n]))[0]


@inlined
def _restoring(system, x):
    """Confined restoring force and its slope; its derivatives by F here and at the ends of its reach go to `by`."""
    c = system.c
    by = system.by
    force, by_place, by[INSIDE], by[LEFT], by[RIGHT] = _confined(
        (x, system.values[FORCE], c.at_ends[0], c.at_ends[1], c.low, c.high)
    )
    return force, by_place + by[INSIDE] * system.changes[FORCE]


@inlined
def _stopped(c, x, p):
    """Force of the end stops and its derivatives by x, p and their four numbers; zeros without stops."""
    if len(c.stops) == 0:
        return (0.0,) * 7
    return _stop_force((x, p, c.stops[0], c.stops[1], c.stops[2], c.stops[3]))


@inlined
def _load(system, x, u):
    """Fill loads of the elements, pulls of the inputs at their place, their rates, and the terms of both in ∂ẇ/∂x."""
    c = system.c
    inputs = len(u)
    relaxing = system.relaxing
    for n in range(len(c.rates)):
        relaxing[LOAD, n], relaxing[PULL, n] = x[2 + n], 0.0
        relaxing[RATE_NOW, n], relaxing[OWN_SLOPE, n] = c.rates[n], 0.0
    for n in range(shapes(c, inputs)):
        row = INPUT + inputs + len(c.rates) + n * (1 + inputs)
        for k in range(inputs):
            relaxing[LOAD, n] -= system.values[row + 1 + k] * u[k]
            relaxing[PULL, n] += system.changes[row + 1 + k] * u[k]
        relaxing[RATE_NOW, n] += system.values[row]
        relaxing[OWN_SLOPE, n] = relaxing[RATE_NOW, n] * relaxing[PULL, n] - system.changes[row] * relaxing[LOAD, n]


@inlined
def _bent_pull(system, n, u):
    """Slope of the pull, Σ β″ u: second derivatives of the Gaussians."""
    c = system.c
    inputs = len(u)
    total = 0.0
    row = INPUT + inputs + len(c.rates) + n * (1 + inputs) + 1
    for i in range(len(c.centres)):
        for k in range(inputs):
            total += c.curves[row + k, POLYNOMIALS + i] * u[k] * system.curvatures[i]
    return total


@shared
def slide(
    slip: FloatArray,
    way: float,
    there: FloatArray,
    here: FloatArray,
    c: Coefficients,
    wrt: SensitivityParameters,
    moved: FloatArray,
) -> None:
    """Dahl states and their sensitivities (D, 1 + P) after a monotonous travel.

    Parameters
    ----------
    slip : FloatArray, shape (D, 1 + P)
        Start of the travel.
    way : float
        Travel [half ranges].
    there, here : FloatArray, shape (P,)
        Sensitivities of the place at its end and at its beginning.
    c : Coefficients
        Slip lengths.
    wrt : SensitivityParameters
        P parameters.
    moved : FloatArray, shape (D, 1 + P)
        Filled.
    """
    for n in range(len(slip)):
        length = c.slip_length[n]
        value, by_state, by_travel, by_length = _dahl_move((slip[n, 0], way, length))
        for m in range(len(wrt.factor)):
            moved[n, 1 + m] = by_state * slip[n, 1 + m] + by_travel * (there[m] - here[m])
        for block in range(len(wrt.kind)):
            if wrt.kind[block] == SLIP_LENGTH:
                m = wrt.start[block] + n
                moved[n, 1 + m] += by_length * length * wrt.factor[m]
        moved[n, 0] = value


@compiled
def slid(x: FloatArray, length: float) -> FloatArray:
    """A Dahl state along a path, shape (N,), relaxed at its beginning. Cost: 5 ns per sample."""
    states = np.zeros(len(x))
    for n in range(1, len(x)):
        states[n] = _dahl_move((states[n - 1], x[n] - x[n - 1], length))[0]
    return states


def free_rates(c: Coefficients, x: Sequence[Any], slip: Sequence[Any], u: Sequence[Any]) -> list[Any]:
    """Rates of x, p and the elements (2 + L,) without an observer: the state equation of a run for traced values.

    Parameters
    ----------
    c : Coefficients
        The joint.
    x, slip, u : sequence
        State (2 + L,), friction states as they act (D,) and inputs (K,).
    """
    dx = np.empty(2 + len(c.rates), dtype=object)
    move(_traced(c, slip), x, u, dx)
    return list(dx)


def resting_elements(c: Coefficients, x: Any, u: Sequence[Any]) -> list[Any]:
    """Relaxing elements at rest at x, w = Σ β u (L,), for traced values."""
    system = _traced(c, ())
    basis_at(x, c, system.basis, system.slopes, system.curvatures)
    rests: list[Any] = [0.0] * len(c.rates)
    for n in range(shapes(c, len(u))):
        row = INPUT + len(u) + len(c.rates) + n * (1 + len(u)) + 1
        for k, curve in enumerate(c.curves[row : row + len(u)]):
            rests[n] = rests[n] + u[k] * sum(weight * value for weight, value in zip(curve, system.basis, strict=True))
    return rests


def _traced(c: Coefficients, slip: Sequence[Any]) -> ObservedJoint:
    """A joint whose arrays take traced values."""
    functions = c.curves.shape[1]
    sliding = np.empty((len(slip), 1), dtype=object)
    for n, value in enumerate(slip):
        sliding[n, 0] = value
    basis, slopes, curvatures = (np.empty(size, dtype=object) for size in (functions, functions, len(c.centres)))
    values, changes, by_curve = (np.empty(len(c.curves), dtype=object) for _ in range(3))
    nothing = np.empty(0)
    return ObservedJoint(
        c=c,
        wrt=no_sensitivities(),
        u=nothing,
        du=nothing,
        held=False,
        measured=nothing,
        observer=nothing,
        parts=1,
        now=nothing,
        began=nothing,
        slip=sliding,
        sliding=sliding,
        basis=basis,
        slopes=slopes,
        curvatures=curvatures,
        values=values,
        changes=changes,
        by_curve=by_curve,
        by=np.empty(13, dtype=object),
        relaxing=np.empty((4, len(c.rates)), dtype=object),
        states=nothing,
        sensitivity=nothing,
    )
