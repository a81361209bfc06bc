"""A run of the data-driven joint, free or coupled to a measurement by an observer, with exact forward sensitivities.

λ > 0 couples a run to the measurement, with e = x_measured − x: ẋ = p + 2λ e, ṗ = … + λ² e. λ = 0 is the free run. A
wall one operating range past the data ends any motion there.

Sensitivities are those of the discrete scheme itself, so Gauss-Newton sees the exact Jacobian of what it minimises.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from typing import NamedTuple

import numpy as np

from ...numerics.arrays import FloatArray
from ...numerics.fixed_step import Methods, inlined, integrator, workspace
from .dynamics import (
    FORCE,
    INPUT,
    INPUT_SHAPE,
    INSIDE,
    LEFT,
    LOAD,
    NUMBER,
    RATE,
    RATE_NOW,
    RIGHT,
    SLIP_FORCE,
    WEIGHT,
    Coefficients,
    ObservedJoint,
    SensitivityParameters,
    basis_rows,
    element,
    move,
    shapes,
    slide,
)
from .structure import spline_through

_LARGEST = float(np.finfo(np.float64).max)

WALL = 3.0
"""|x| that no run passes: a wall one operating range past the data, where the motion stops."""


class Drive(NamedTuple):
    """Inputs of a run.

    Attributes
    ----------
    u : FloatArray, shape (n, K)
        Inputs at every half step, n = 2·steps·(N−1) + 1.
    du : FloatArray, shape (R, n, K)
        Their derivatives with respect to the R parameters of kind `INPUT_SHAPE`.
    rested : FloatArray, shape (K,)
        Inputs under which the relaxing elements were at rest before the first sample.
    held : bool
        True if inputs are constant from node to node and jump there, instead of continuous.
    """

    u: FloatArray
    du: FloatArray
    rested: FloatArray
    held: bool


class Coupling(NamedTuple):
    """Coupling of a run to a measurement.

    Attributes
    ----------
    measured : FloatArray, shape (N,)
        x, finite; a cubic spline between samples.
    share : FloatArray, shape (N,)
        Share of the gain that acts, 0 in gaps.
    gain : float
        λ [1/s]; 0 for the free run.
    """

    measured: FloatArray
    share: FloatArray
    gain: float


def _begin(system, x, node):
    n = node // system.parts
    parameters = len(system.wrt.factor)
    elements = len(system.c.rates)
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


def _rates(system, x, node, dx, acceleration):
    acting = min(node, int(system.now[0]) + 1) if system.held else node  # what is held jumps where the step ends
    error = system.measured[node] - x[0]
    gain = system.now[1]
    first = 2 + len(system.c.rates)
    slide(system.slip, x[0] - system.began[0], x[first:], system.began[1:], system.c, system.wrt, system.sliding)
    move(system, x, system.u[acting], dx)
    acceleration[0] = dx[1]
    dx[0] += 2.0 * gain * error
    dx[1] += gain * gain * error
    if len(system.wrt.factor) > 0:
        _carry(system, x, gain, dx)
        _force(system, x, acting, dx)


def _finish(system, x):
    first = 2 + len(system.c.rates)
    slide(system.slip, x[0] - system.began[0], x[first:], system.began[1:], system.c, system.wrt, system.slip)
    if abs(x[0]) > WALL:
        x[0], x[1] = WALL if x[0] > 0.0 else -WALL, 0.0
        for m in range(2 * len(system.wrt.factor)):
            x[first + m] = 0.0


_integrate = integrator(ObservedJoint, lambda kind: Methods(_begin, _rates, _finish))


@inlined
def _carry(system, x, gain, dx):
    """Rates of the sensitivities by the state."""
    c = system.c
    parameters = len(system.wrt.factor)
    first = 2 + len(system.c.rates)
    by_x = system.by[0] - gain * gain
    by_p = system.by[1]
    by_push = system.by[2]
    s0 = x[first : first + parameters]
    s1 = x[first + parameters : first + 2 * parameters]
    k0 = dx[first : first + parameters]
    k1 = dx[first + parameters : first + 2 * parameters]
    for m in range(parameters):
        k0[m] = s1[m] - 2.0 * gain * s0[m]
        k1[m] = by_x * s0[m] + by_p * s1[m]
    for n in range(len(system.sliding)):
        by_slip = -by_push * c.slip_force[n]
        for m in range(parameters):
            k1[m] += by_slip * system.sliding[n, 1 + m]
    values = system.values
    for n in range(len(c.rates)):
        row = INPUT + system.u.shape[1] + n
        at = first + (2 + n) * parameters
        load, pull, rate, own_slope = system.relaxing[:, n]
        s = x[at : at + parameters]
        k = dx[at : at + parameters]
        _, by_coupling, by_speed, _, by_own = element((values[row], x[1], rate, load))
        by_place = by_coupling * system.changes[row] + own_slope
        by_element = by_push * (pull - values[row])
        for m in range(parameters):
            k1[m] += by_element * s[m]
            k[m] = by_place * s0[m] + by_speed * s1[m] + by_own * s[m]


@inlined
def _force(system, x, node, dx):
    """Add the explicit derivatives of the rates by the parameters to those of the sensitivities."""
    c = system.c
    wrt = system.wrt
    du = system.du
    parameters = len(wrt.factor)
    inputs = system.u.shape[1]
    elements = len(c.rates)
    values = system.values
    relaxing = system.relaxing
    by_push = system.by[2]
    k1 = dx[2 + elements + parameters :]
    own = dx[2 + elements + 2 * parameters :]  # rows of the elements
    for block in range(len(wrt.kind)):
        kind = wrt.kind[block]
        if kind == WEIGHT:
            _force_by_weights(system, x, node, block, dx)
            continue
        for m in range(wrt.start[block], wrt.start[block + 1]):
            i = wrt.first[block] + m - wrt.start[block]
            if kind == RATE:
                own[i * parameters + m] -= c.rates[i] * relaxing[LOAD, i]
            elif kind == SLIP_FORCE:
                k1[m] -= by_push * c.slip_force[i] * system.sliding[i, 0]
            elif kind == NUMBER:
                k1[m] += system.by[i] * wrt.factor[m]
            elif kind == INPUT_SHAPE:
                for n in range(inputs):
                    k1[m] += by_push * values[INPUT + n] * du[i, node, n]
                    for s in range(shapes(c, inputs)):
                        row = INPUT + inputs + elements + s * (1 + inputs) + 1 + n
                        held = values[INPUT + inputs + s] * values[row] + x[2 + s] * system.changes[row]
                        k1[m] += by_push * held * du[i, node, n]
                        own[s * parameters + m] += relaxing[RATE_NOW, s] * values[row] * du[i, node, n]


@inlined
def _force_by_weights(system, x, node, block, dx):
    """Add the derivatives of the rates by the weights of one curve."""
    wrt = system.wrt
    parameters = len(wrt.factor)
    inputs = system.u.shape[1]
    elements = len(system.c.rates)
    row = wrt.first[block]
    at = wrt.start[block]
    count = wrt.start[block + 1] - at
    column = wrt.column[block]
    factor = wrt.factor[at : at + count]
    basis = system.basis[column : column + count]
    relaxing = system.relaxing
    first = 2 + elements + parameters + at
    k1 = dx[first : first + count]
    if row == FORCE:
        for j in range(count):
            k1[j] += system.by_curve[FORCE] * _force_weight(system, column + j) * factor[j]
    elif row < INPUT + inputs + elements:
        by_curve = system.by_curve[row]
        for j in range(count):
            k1[j] += by_curve * basis[j] * factor[j]
        if row >= INPUT + inputs:
            own = dx[first + (1 + row - INPUT - inputs) * parameters :]
            for j in range(count):
                own[j] += x[1] * basis[j] * factor[j]
    else:
        n, k = divmod(row - INPUT - inputs - elements, 1 + inputs)
        own = dx[first + (1 + n) * parameters :]
        if k == 0:
            load = relaxing[LOAD, n]
            for j in range(count):
                own[j] -= load * basis[j] * factor[j]
        else:
            drive = system.u[node, k - 1]
            by_value = system.by[2] * drive * system.values[INPUT + inputs + n]
            by_slope = system.by[2] * drive * x[2 + n]
            by_pull = relaxing[RATE_NOW, n] * drive
            slopes = system.slopes[column : column + count]
            for j in range(count):
                k1[j] += (by_value * basis[j] + by_slope * slopes[j]) * factor[j]
                own[j] += by_pull * basis[j] * factor[j]


@inlined
def _force_weight(system, j):
    """Derivative of the confined force by the weight of a basis function."""
    ends = system.c.ends
    by = system.by
    return by[INSIDE] * system.basis[j] + by[LEFT] * ends[0, j] + by[RIGHT] * ends[1, j]


def _rested(
    x: float, rest: FloatArray, change: FloatArray, c: Coefficients, wrt: SensitivityParameters
) -> tuple[FloatArray, FloatArray]:
    """Relaxing elements at rest at x under constant inputs, w = Σ β u (L,), and their sensitivities (L, P).

    `change` (R, K): derivatives of these inputs with respect to the parameters of kind `INPUT_SHAPE`.
    """
    w = np.zeros(len(c.rates))
    sensitivity = np.zeros((len(c.rates), len(wrt.factor)))
    at = basis_rows(np.array([x]), c)[0]
    inputs = len(rest)
    first = INPUT + inputs + len(c.rates)
    for n in range(shapes(c, inputs)):
        row = first + n * (1 + inputs) + 1
        pulls = c.curves[row : row + inputs] @ at
        w[n] = rest @ pulls
        for block in np.flatnonzero(wrt.kind == INPUT_SHAPE):
            for m in range(wrt.start[block], wrt.start[block + 1]):
                sensitivity[n, m] = change[wrt.first[block] + m - wrt.start[block]] @ pulls
    for block in np.flatnonzero((wrt.kind == WEIGHT) & (wrt.first >= first)):
        n, k = divmod(wrt.first[block] - first, 1 + inputs)
        if k > 0:
            here = slice(wrt.start[block], wrt.start[block + 1])
            columns = slice(wrt.column[block], wrt.column[block] + here.stop - here.start)
            sensitivity[n, here] = rest[k - 1] * at[columns] * wrt.factor[here]
    return w, sensitivity


def observed_run(
    c: Coefficients,
    drive: Drive,
    coupling: Coupling,
    start: FloatArray | tuple[float, float],
    interval: float,
    steps: int,
    wrt: SensitivityParameters,
) -> tuple[FloatArray, FloatArray, int]:
    """Integrate the joint over a record, coupled to the measurement by an observer.

    Parameters
    ----------
    c : Coefficients
        The joint.
    drive : Drive
        Its inputs.
    coupling : Coupling
        The measurement.
    start : sequence of 2 or 2 + L + D floats
        x(0), p(0) [1/s], and the hidden states w and s, at rest where left out.
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
        Samples before the state was no number.

    Notes
    -----
    Cost: 4·steps·N stages, each of M exponentials, two products for each weight of the curves, and about 3·(2+L+D)·P
    products for the sensitivities. A step with one input and M = 8 takes 0.4 µs, with P = 14 0.6 µs; with two inputs,
    three relaxing elements of which two are shapes, and M = 12, it takes 1.1 µs, with P = 169 4.7 µs.
    """
    u, du, rested, held = drive
    measured, observe, gain = coupling
    count = len(measured)
    elements = len(c.rates)
    slips = len(c.slip_force)
    parameters = len(wrt.factor)
    states = np.full((count, 3 + elements + slips), np.nan)
    sensitivity = np.zeros((count, parameters))
    change = du[:, 0] if np.all(rested == u[0]) else np.zeros_like(du[:, 0])  # offsets of resting inputs are small
    start = np.asarray(start, dtype=np.float64)
    w, w_sensitivity = _rested(float(start[0]), rested, np.ascontiguousarray(change), c, wrt)
    slip = np.zeros((slips, 1 + parameters))
    if len(start) > 2:
        w, slip[:, 0] = start[2 : 2 + elements], start[2 + elements :]
    x = np.concatenate([start[:2], w, np.zeros(2 * parameters), w_sensitivity.ravel()])
    nodes = np.arange(2 * steps * (count - 1) + 1) / (2 * steps)
    path = np.asarray(spline_through(measured)(nodes) if gain else np.zeros(len(nodes)))
    curves, functions = c.curves.shape
    system = ObservedJoint(
        c=c,
        wrt=wrt,
        u=np.ascontiguousarray(u),
        du=np.ascontiguousarray(du),
        held=held,
        measured=path,
        observer=gain * np.minimum(observe, np.append(observe[1:], observe[-1])),
        parts=2 * steps,
        now=np.zeros(2),
        began=np.zeros(1 + parameters),
        slip=slip,
        sliding=slip.copy(),
        basis=np.zeros(functions),
        slopes=np.zeros(functions),
        curvatures=np.zeros(len(c.centres)),
        values=np.zeros(curves),
        changes=np.zeros(curves),
        by_curve=np.zeros(curves),
        by=np.zeros(13),
        relaxing=np.zeros((4, elements)),
        states=states,
        sensitivity=sensitivity,
    )
    out = np.full((count, 3, 1), np.nan)
    # The wall keeps x, so that only what is no number ends a run.
    valid = _integrate(system, x, out, workspace(x), steps, interval / steps, -_LARGEST, _LARGEST)
    states[:, :3] = out[:, :, 0]
    return states, sensitivity, valid
