"""The data-driven joint in a run, free or coupled to a measurement by an observer, with exact forward sensitivities.

The laws are those of `pipeline.equations.data_driven_joint`, where each stands for one curve, relaxing element or
friction state; here they are summed over as many as a joint has. F, d, h_l, g_k are weights times a common basis: four
functions (`POLYNOMIALS`) and Gaussians. The Gaussians, and with them every curve but F, go on as constants outside
[low, high]; F goes on as its cubic, but restores there at least as much as at the end, so that without inputs nothing
rests far outside. A wall one operating range past the data ends any other motion there.

λ > 0 couples a run to the measurement by an observer, with e = x_measured − x: ẋ = p + 2λ e, ṗ = … + λ² e. λ = 0 is
the free run. Friction states are exact (`elements.dahl_move`): held at their middle value during a step and then moved
by the distance travelled (second order).

Sensitivities are those of the discrete scheme itself, so Gauss-Newton sees the exact Jacobian of what it minimises.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from pipeline.codegen.numba_writer import formula
from pipeline.compiled import compiled, shared
from pipeline.generated.terms import (
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
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.solvers.fixed_step import Methods, between_samples, inlined, integrator, workspace

_powers, _turning_arm, _clipped, _bell = formula(POWERS), formula(TURNING_ARM), formula(CLIPPED), formula(BELL)
_acceleration, _element, _dahl_move = formula(ACCELERATION), formula(ELEMENT), formula(DAHL_MOVE)
_stop_force, _confined = formula(STOP_FORCE), formula(CONFINED_FORCE)

POLYNOMIALS = 4
"""Basis functions 1, x, x², x³ before the Gaussians (1, sin q, cos q, x³ with a wall for a turning arm)."""

FORCE, DAMPING, INPUT = 0, 1, 2
"""Rows of the curve weights: F, d, then g_1 … g_K, then h_1 … h_L, then ρ, β_1 … β_K of each shape element."""

WEIGHT, RATE, SLIP_FORCE, SLIP_LENGTH, NUMBER, INPUT_SHAPE = range(6)
"""Kinds of parameters: the `kind` of `SensitivityParameters`; a `NUMBER` is one of those below."""

CENTRE, ARC, DRAG, STOPS = 3, 4, 5, 6
"""Places in `ObservedJoint.by` of derivatives by numbers of the equation: arm, arc, drag, the four of the stops."""

INSIDE, LEFT, RIGHT = 10, 11, 12
"""Places of the derivatives of the confined force by F, and by F at the ends of its reach."""

_LARGEST = float(np.finfo(np.float64).max)

LOAD, PULL, RATE_NOW, OWN_SLOPE = range(4)
"""Rows of `ObservedJoint.relaxing`."""

WALL = 3.0
"""|x| that no run passes: a wall one operating range past the data, where the motion stops."""


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
    """Parameters of the sensitivities, P entries each.

    kind, first, second (P,) name the coefficient (curve row and basis column for `WEIGHT`, element for `RATE`, …);
    factor (P,) is the derivative of a curve weight, of the inertia, of a stop's number or of the logarithm of a slip
    length with respect to the parameter. Rates, slip forces and drag are taken by their logarithms.
    """

    kind: IntArray
    first: IntArray
    second: IntArray
    factor: FloatArray


def no_sensitivities() -> SensitivityParameters:
    """For a simulation without sensitivities."""
    none = np.empty(0, dtype=np.int64)
    return SensitivityParameters(none, none, none, np.empty(0))


@inlined
def _shapes(c, inputs):
    return (len(c.curves) - INPUT - inputs - len(c.rates)) // (1 + inputs)


@shared
def basis_at(x: float, c: Coefficients, values: FloatArray, slopes: FloatArray, curvatures: FloatArray) -> None:
    """The basis (4 + M,) and its derivative at x, and the second derivative of the Gaussians (M,)."""
    head = _powers((x,)) if c.arm[1] == 0.0 else _turning_arm((x, c.arm[0], c.arm[1]))
    for i in range(POLYNOMIALS):
        values[i], slopes[i] = head[i], head[POLYNOMIALS + i]
    inside, moving = _clipped((x, c.low, c.high))
    for i in range(len(c.centres)):
        value, slope, curvature = _bell((inside, c.centres[i], c.bend))
        values[POLYNOMIALS + i], slopes[POLYNOMIALS + i] = value, slope * moving
        curvatures[i] = curvature * moving


@compiled
def basis(x: FloatArray, c: Coefficients) -> FloatArray:
    """The basis at all x, shape (N, 4 + M)."""
    values, slopes = np.empty((len(x), c.curves.shape[1])), np.empty(c.curves.shape[1])
    curvatures = np.empty(len(c.centres))
    for n in range(len(x)):
        basis_at(x[n], c, values[n], slopes, curvatures)
    return values


class ObservedJoint(NamedTuple):
    """A joint in a run. The state is x, p and L relaxing elements, then their P sensitivities, row by row.

    c, wrt, u, du, held as in `observed_run` · measured (N,) · observer (N,): its gain of each interval [1/s] · parts:
    half steps in an interval · half: half a step [s] · now (2,): half step at which the step began, its observer gain ·
    began (1 + P,): x there and its sensitivities · slip, middle (D, 1 + P): friction states, as they act in a step ·
    basis, slopes (4 + M,), curvatures (M,), values, changes (C,): basis and the C curves, and their slopes · by_curve
    (C,), by (13,): derivatives of ṗ by the curves, and by x, p, push, arm, arc, drag, stops; of F by F (`INSIDE`) ·
    relaxing (4, L): of each element its load, the inputs' pull on its place, its rate, and the part of ∂ẇ/∂x that its
    own curves make · states, sensitivity: at the samples, filled.
    """

    c: Coefficients
    wrt: SensitivityParameters
    u: FloatArray
    du: FloatArray
    held: bool
    measured: FloatArray
    observer: FloatArray
    parts: int
    half: float
    now: FloatArray
    began: FloatArray
    slip: FloatArray
    middle: FloatArray
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


def _begin(system, x, node):
    n, parameters, elements = node // system.parts, len(system.wrt.kind), len(system.c.rates)
    first = 2 + elements
    system.now[0], system.now[1] = node, system.observer[n]
    if node == n * system.parts:
        for i in range(elements):
            system.states[n, 3 + i] = x[2 + i]
        for i in range(len(system.slip)):
            system.states[n, first + 1 + i] = system.slip[i, 0]
        for m in range(parameters):
            system.sensitivity[n, m] = x[first + m]
    system.began[0] = x[0]
    for m in range(parameters):
        system.began[1 + m] = x[first + m]
    slide(system.slip, system.half, x[1], x[first + parameters :], system.c, system.wrt, system.middle)


def _rates(system, x, node, dx, acceleration):
    acting = min(node, int(system.now[0]) + 1) if system.held else node  # what is held jumps where the step ends
    n, following, share = between_samples(node, system.parts, len(system.measured))
    seen = system.measured[n] + share * (system.measured[following] - system.measured[n])
    error, gain = seen - x[0], system.now[1]
    _move(system, x, system.u[acting], dx)
    acceleration[0] = dx[1]
    dx[0] += 2.0 * gain * error
    dx[1] += gain * gain * error
    if len(system.wrt.kind) > 0:
        _carry(system, x, gain, dx)
        _force(system, x, acting, dx)


def _finish(system, x):
    first = 2 + len(system.c.rates)
    for m in range(len(system.wrt.kind)):
        system.began[1 + m] = x[first + m] - system.began[1 + m]
    slide(system.slip, 1.0, x[0] - system.began[0], system.began[1:], system.c, system.wrt, system.slip)
    if abs(x[0]) > WALL:
        x[0], x[1] = WALL if x[0] > 0.0 else -WALL, 0.0
        for m in range(2 * len(system.wrt.kind)):
            x[first + m] = 0.0


_integrate = integrator(ObservedJoint, lambda kind: Methods(_begin, _rates, _finish))


@inlined
def _move(system, x, u, dx):
    """Rates of the state without the observer, and what their derivatives need."""
    c, inputs, p = system.c, len(u), x[1]
    basis, slopes, values, by_curve = system.basis, system.slopes, system.values, system.by_curve
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
    for n in range(_shapes(c, inputs)):
        push += x[2 + n] * system.relaxing[PULL, n]
        change += values[INPUT + inputs + n] * system.relaxing[PULL, n]
        change += x[2 + n] * _bent_pull(system, n, u)
    for n in range(len(system.middle)):
        push -= c.slip_force[n] * system.middle[n, 0]
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
        rate, load = system.relaxing[RATE_NOW, n], system.relaxing[LOAD, n]
        dx[2 + n] = _element((values[INPUT + inputs + n], p, rate, load))[0]


@inlined
def _restoring(system, x):
    """Confined restoring force and its slope; its derivatives by F here and at the ends of its reach go to `by`."""
    c, by = system.c, system.by
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
    c, inputs, relaxing = system.c, len(u), system.relaxing
    for n in range(len(c.rates)):
        relaxing[LOAD, n], relaxing[PULL, n] = x[2 + n], 0.0
        relaxing[RATE_NOW, n], relaxing[OWN_SLOPE, n] = c.rates[n], 0.0
    for n in range(_shapes(c, inputs)):
        row = INPUT + inputs + len(c.rates) + n * (1 + inputs)
        for k in range(inputs):
            relaxing[LOAD, n] -= system.values[row + 1 + k] * u[k]
            relaxing[PULL, n] += system.changes[row + 1 + k] * u[k]
        relaxing[RATE_NOW, n] += system.values[row]
        own = relaxing[RATE_NOW, n] * relaxing[PULL, n] - system.changes[row] * relaxing[LOAD, n]
        relaxing[OWN_SLOPE, n] = own


@inlined
def _bent_pull(system, n, u):
    """Slope of the pull, Σ β″ u: second derivatives of the Gaussians."""
    c, inputs, total = system.c, len(u), 0.0
    row = INPUT + inputs + len(c.rates) + n * (1 + inputs) + 1
    for i in range(len(c.centres)):
        for k in range(inputs):
            total += c.curves[row + k, POLYNOMIALS + i] * u[k] * system.curvatures[i]
    return total


@inlined
def _carry(system, x, gain, dx):
    """Rates of the sensitivities by the state."""
    c, parameters, first = system.c, len(system.wrt.kind), 2 + len(system.c.rates)
    by_x, by_p, by_push = system.by[0] - gain * gain, system.by[1], system.by[2]
    s0, s1 = x[first : first + parameters], x[first + parameters : first + 2 * parameters]
    k0, k1 = dx[first : first + parameters], dx[first + parameters : first + 2 * parameters]
    for m in range(parameters):
        k0[m] = s1[m] - 2.0 * gain * s0[m]
        k1[m] = by_x * s0[m] + by_p * s1[m]
    for n in range(len(system.middle)):
        by_slip = -by_push * c.slip_force[n]
        for m in range(parameters):
            k1[m] += by_slip * system.middle[n, 1 + m]
    values, changes = system.values, system.changes
    for n in range(len(c.rates)):
        row, at = INPUT + system.u.shape[1] + n, first + (2 + n) * parameters
        load, pull, rate, own_slope = system.relaxing[:, n]
        s, k = x[at : at + parameters], dx[at : at + parameters]
        _, by_coupling, by_speed, _, by_own = _element((values[row], x[1], rate, load))
        by_place, by_element = by_coupling * changes[row] + own_slope, by_push * (pull - values[row])
        for m in range(parameters):
            k1[m] += by_element * s[m]
            k[m] = by_place * s0[m] + by_speed * s1[m] + by_own * s[m]


@inlined
def _force(system, x, node, dx):
    """Add the explicit derivatives of the rates by the parameters to those of the sensitivities."""
    c, wrt, u, du = system.c, system.wrt, system.u, system.du
    parameters, inputs, elements = len(wrt.kind), u.shape[1], len(c.rates)
    basis, by_curve, values, relaxing = system.basis, system.by_curve, system.values, system.relaxing
    by_push = system.by[2]
    k1 = dx[2 + elements + parameters :]
    own = dx[2 + elements + 2 * parameters :]  # rows of the elements
    for m in range(parameters):
        kind, i, j = wrt.kind[m], wrt.first[m], wrt.second[m]
        if kind == WEIGHT:
            weight = (_force_weight(system, j) if i == FORCE else basis[j]) * wrt.factor[m]
            if i < INPUT + inputs + elements:
                k1[m] += by_curve[i] * weight
                if i >= INPUT + inputs:
                    own[(i - INPUT - inputs) * parameters + m] += weight * x[1]
                continue
            n, k = divmod(i - INPUT - inputs - elements, 1 + inputs)
            if k == 0:
                own[n * parameters + m] -= weight * relaxing[LOAD, n]
            else:
                slope, drive = system.slopes[j] * wrt.factor[m], u[node, k - 1]
                k1[m] += by_push * drive * (values[INPUT + inputs + n] * weight + x[2 + n] * slope)
                own[n * parameters + m] += relaxing[RATE_NOW, n] * drive * weight
        elif kind == RATE:
            own[i * parameters + m] -= c.rates[i] * relaxing[LOAD, i]
        elif kind == SLIP_FORCE:
            k1[m] -= by_push * c.slip_force[i] * system.middle[i, 0]
        elif kind == NUMBER:
            k1[m] += system.by[i] * wrt.factor[m]
        elif kind == INPUT_SHAPE:
            for n in range(inputs):
                k1[m] += by_push * values[INPUT + n] * du[i, node, n]
                for s in range(_shapes(c, inputs)):
                    row = INPUT + inputs + elements + s * (1 + inputs) + 1 + n
                    held = values[INPUT + inputs + s] * values[row] + x[2 + s] * system.changes[row]
                    k1[m] += by_push * held * du[i, node, n]
                    own[s * parameters + m] += relaxing[RATE_NOW, s] * values[row] * du[i, node, n]


@inlined
def _force_weight(system, j):
    """Derivative of the confined force by the weight of a basis function."""
    ends, by = system.c.ends, system.by
    return by[INSIDE] * system.basis[j] + by[LEFT] * ends[0, j] + by[RIGHT] * ends[1, j]


@shared
def slide(
    slip: FloatArray, share: float, way: float, way_sensitivity: FloatArray, c: Coefficients,
    wrt: SensitivityParameters, moved: FloatArray,
) -> None:  # fmt: skip
    """Dahl states and their sensitivities (D, 1 + P) after a monotonous travel, a `share` of the way."""
    for n in range(len(slip)):
        length = c.slip_length[n]
        value, by_state, by_travel, by_length = _dahl_move((slip[n, 0], share * way, length))
        for m in range(len(wrt.kind)):
            moved[n, 1 + m] = by_state * slip[n, 1 + m] + by_travel * share * way_sensitivity[m]
            if wrt.kind[m] == SLIP_LENGTH and wrt.first[m] == n:
                moved[n, 1 + m] += by_length * length * wrt.factor[m]
        moved[n, 0] = value


@compiled
def slid(x: FloatArray, length: float) -> FloatArray:
    """A Dahl state along a path, shape (N,), relaxed at its beginning. Cost: 20 ns per sample."""
    states = np.zeros(len(x))
    for n in range(1, len(x)):
        states[n] = _dahl_move((states[n - 1], x[n] - x[n - 1], length))[0]
    return states


def _rested(
    x: float, rest: FloatArray, change: FloatArray, c: Coefficients, wrt: SensitivityParameters
) -> tuple[FloatArray, FloatArray]:
    """Relaxing elements at rest at x under constant inputs, w = Σ β u (L,), and their sensitivities (L, P).

    `change` (R, K): derivatives of these inputs with respect to the parameters of kind `INPUT_SHAPE`.
    """
    w, sensitivity = np.zeros(len(c.rates)), np.zeros((len(c.rates), len(wrt.kind)))
    at, inputs = basis(np.array([x]), c)[0], len(rest)
    first = INPUT + inputs + len(c.rates)
    for n in range(_shapes(c, inputs)):
        row = first + n * (1 + inputs) + 1
        pulls = c.curves[row : row + inputs] @ at
        w[n] = rest @ pulls
        for m in np.flatnonzero(wrt.kind == INPUT_SHAPE):
            sensitivity[n, m] = change[wrt.first[m]] @ pulls
    for m in np.flatnonzero((wrt.kind == WEIGHT) & (wrt.first >= first)):
        n, k = divmod(wrt.first[m] - first, 1 + inputs)
        if k > 0:
            sensitivity[n, m] = rest[k - 1] * at[wrt.second[m]] * wrt.factor[m]
    return w, sensitivity


def free_rates(c: Coefficients, x: Sequence[Any], slip: Sequence[Any], u: Sequence[Any]) -> list[Any]:
    """Rates of x, p and the elements (2 + L,) without an observer: the law of a run for traced values.

    Parameters
    ----------
    c : Coefficients
        The joint.
    x, slip, u : sequence
        State (2 + L,), friction states as they act (D,) and inputs (K,).
    """
    system = _traced(c, slip)
    dx = np.empty(2 + len(c.rates), dtype=object)
    _move(system, x, u, dx)
    return list(dx)


def resting_elements(c: Coefficients, x: Any, u: Sequence[Any]) -> list[Any]:
    """Relaxing elements at rest at x, w = Σ β u (L,), for traced values."""
    system = _traced(c, ())
    basis_at(x, c, system.basis, system.slopes, system.curvatures)
    first = INPUT + len(u) + len(c.rates)
    rests: list[Any] = [0.0] * len(c.rates)
    for n in range(_shapes(c, len(u))):
        row = first + n * (1 + len(u)) + 1
        for k, curve in enumerate(c.curves[row : row + len(u)]):
            rests[n] = rests[n] + u[k] * sum(weight * value for weight, value in zip(curve, system.basis, strict=True))
    return rests


def _traced(c: Coefficients, slip: Sequence[Any]) -> ObservedJoint:
    """A joint whose arrays take traced values."""
    functions, curves = c.curves.shape[1], len(c.curves)
    middle = np.empty((len(slip), 1), dtype=object)
    for n, value in enumerate(slip):
        middle[n, 0] = value
    basis, slopes, curvatures = (np.empty(size, dtype=object) for size in (functions, functions, len(c.centres)))
    values, changes, by_curve = (np.empty(curves, dtype=object) for _ in range(3))
    nothing = np.empty(0)
    return ObservedJoint(
        c, no_sensitivities(), nothing, nothing, False, nothing, nothing, 1, 0.0, nothing, nothing, middle, middle,
        basis, slopes, curvatures, values, changes, by_curve, np.empty(13, dtype=object),
        np.empty((4, len(c.rates)), dtype=object), nothing, nothing,
    )  # fmt: skip


class Drive(NamedTuple):
    """Inputs of a run.

    u (n, K) at every half step, n = 2·steps·(N−1)+1 · du (R, n, K): their derivatives with respect to the R parameters
    of kind `INPUT_SHAPE` · rested (K,): those under which the relaxing elements were at rest before the first sample ·
    held: whether inputs are constant from node to node and jump there, instead of continuous.
    """

    u: FloatArray
    du: FloatArray
    rested: FloatArray
    held: bool


class Coupling(NamedTuple):
    """Coupling of a run to a measurement.

    measured (N,): x, finite, linear between samples · share (N,) of the gain that acts, 0 in gaps · gain λ [1/s]; 0 for
    the free run.
    """

    measured: FloatArray
    share: FloatArray
    gain: float


def observed_run(
    c: Coefficients, drive: Drive, coupling: Coupling, start: tuple[float, float], interval: float, steps: int,
    wrt: SensitivityParameters,
) -> tuple[FloatArray, FloatArray, int]:  # fmt: skip
    """Integrate the joint over a record, coupled to the measurement by an observer.

    Parameters
    ----------
    c : Coefficients
        The joint.
    drive : Drive
        Its inputs.
    coupling : Coupling
        The measurement.
    start : (float, float)
        x(0), p(0) [1/s].
    interval : float
        Sample interval [s].
    steps : int
        Runge-Kutta steps per interval.
    wrt : SensitivityParameters
        P parameters; `no_sensitivities()` for a plain simulation.

    Returns
    -------
    states : FloatArray, shape (N, 3 + L + D)
        x, p, ṗ (without the observer's part), w, s; NaN after divergence.
    sensitivity : FloatArray, shape (N, P)
        ∂x/∂θ.
    valid : int
        Samples before the state was no number. Cost: 4·steps·N stages of M exponentials, 2·(2+K+L)·(4+M) products and
        about 3·(2+L+D)·P products for the sensitivities: with one input and M = 8 0.3 µs per step, 0.5 with P = 14;
        with two inputs, two shapes and M = 12 1.0 µs, 5.9 with P = 169.
    """
    (u, du, rested, held), (measured, observe, gain) = drive, coupling
    count, elements, slips, parameters = len(measured), len(c.rates), len(c.slip_force), len(wrt.kind)
    states = np.full((count, 3 + elements + slips), np.nan)
    sensitivity = np.zeros((count, parameters))
    change = du[:, 0] if np.all(rested == u[0]) else np.zeros_like(du[:, 0])  # offsets of resting inputs are small
    w, w_sensitivity = _rested(start[0], rested, np.ascontiguousarray(change), c, wrt)
    x = np.concatenate([start, w, np.zeros(2 * parameters), w_sensitivity.ravel()])
    slip = np.zeros((slips, 1 + parameters))
    basis, slopes, curvatures = np.zeros(c.curves.shape[1]), np.zeros(c.curves.shape[1]), np.zeros(len(c.centres))
    values, changes, by_curve = np.zeros((3, len(c.curves)))
    system = ObservedJoint(
        c, wrt, np.ascontiguousarray(u), np.ascontiguousarray(du), held, np.ascontiguousarray(measured),
        gain * np.minimum(observe, np.append(observe[1:], observe[-1])), 2 * steps, 0.5 * interval / steps,
        np.zeros(2), np.zeros(1 + parameters), slip, slip.copy(), basis, slopes, curvatures, values, changes,
        by_curve, np.zeros(13), np.zeros((4, elements)), states, sensitivity,
    )  # fmt: skip
    out = np.full((count, 3, 1), np.nan)
    # The wall keeps x, so that only what is no number ends a run.
    valid = _integrate(system, x, out, workspace(x), steps, interval / steps, -_LARGEST, _LARGEST)
    states[:, :3] = out[:, :, 0]
    return states, sensitivity, valid
