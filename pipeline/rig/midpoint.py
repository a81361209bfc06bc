"""Time steps of the full-order joint by the implicit midpoint rule.

The joint is stiff (slow modes near 20 rad/s, beam losses at −5·10⁴ 1/s), so the step is implicit. The midpoint rule is
of second order, A-stable, and neither adds nor removes energy in a linear conservative system. With
``x_m = x0 + h v_m/2`` a step solves

    ``M(x_m)·2(v_m − v0)/h + bias(x_m, v_m) = force(x_m, v_m)``

for the midpoint velocity by Newton's method with a Jacobian kept over several steps. The internal states are
eliminated: a viscous branch obeys ``e_m = (e0 + ε_m − ε0)/(1 + h/(2τ))``, friction is a closed expression of the
sliding since the start of the step.
"""

from typing import NamedTuple

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.compiled import compiled, copy_into, inner
from .elements import (
    elastic,
    hinge_angle,
    inertia,
    rubber_stress,
    slide,
    stretch,
    tip,
    viscous_strain,
    yielding,
)
from .parameters import RigParameters

_TOLERANCE = 1e-8  # of the Newton step on the midpoint velocity, relative to 1 + its size
_MAX_NEWTON = 30
KEEP = 12  # steps for which a Jacobian is kept; within a step it is renewed after eight iterations
_NUDGE = 1e-5  # change of a coordinate in the finite differences
GIVE = 0.3e-3  # [m] by which a wire gives way before it slides


class Load(NamedTuple):
    """What acts on a joint in N steps.

    Attributes
    ----------
    charge : FloatArray, shape (N, 2)
        Squared voltages, mean over the step [V²].
    force, spring : FloatArray, shape (N,)
        Force on q [N], and stiffness of a repelling spring [N/m].
    """

    charge: FloatArray
    force: FloatArray
    spring: FloatArray


class State(NamedTuple):
    """The joint at the start of a step."""

    x: FloatArray  # (n,)
    v: FloatArray  # (n,)
    branches: FloatArray  # (2, branches) viscous strains e
    strain: FloatArray  # (2,) what the branches saw
    z: FloatArray  # (elements,) friction [N]
    sliding: FloatArray  # (1,) [m]
    charge: FloatArray  # (2,) of the step
    layers: FloatArray  # (layers, n) elastic angles of yielding layers [rad]
    bends: FloatArray  # (n,) angles of the hinges [rad]
    age: FloatArray  # (1,) [s]
    hand: FloatArray  # (2,) force and spring of the step
    wire: FloatArray  # (2,) its anchor [m], and the force with which it slides [N]


class _Work(NamedTuple):
    """Arrays that are filled over and over."""

    x: FloatArray  # (n,) at the midpoint
    pose: FloatArray  # (3,) of the tip: q, u_y, φ
    jacobian: FloatArray  # (3, n)
    speed: FloatArray  # (3,) rates of the pose
    gradient: FloatArray  # (3,)
    load: FloatArray  # (3,)
    force: FloatArray  # (n,)
    bias: FloatArray  # (n,)
    matrix: FloatArray  # (n, n)
    branches: FloatArray  # (2, branches) at the midpoint
    z: FloatArray  # (elements,) as the last evaluation leaves it
    layers: FloatArray  # (layers, n) as the last evaluation leaves them
    middle: FloatArray  # (n,) rates at the midpoint of the last step
    inverse: FloatArray  # (n, n) that of the last Jacobian


@compiled(inline="always")
def _imbalance(vm: FloatArray, h: float, state: State, p: RigParameters, work: _Work, out: FloatArray) -> None:
    """Fill `out`, shape (n,), with the residual of the midpoint rule at the midpoint velocity `vm`."""
    n = vm.size
    x = work.x
    for j in range(n):
        x[j] = state.x[j] + 0.5 * h * vm[j]
    elastic(x, vm, p, work.force)
    yielding(x, state.bends, state.layers, p, work.force, work.layers)
    locate_tip(x, vm, p, work)
    _membrane_load(0.5 * h, state, p, work)
    rub = slide(
        state.z,
        work.pose[0] + p.friction_arm * work.pose[2] - state.sliding[0],
        work.speed[0] + p.friction_arm * work.speed[2],
        0.5 * h,
        p,
        work.z,
    )
    work.load[0] += state.hand[0] + state.hand[1] * work.pose[0] - rub
    work.load[1] -= p.mass * p.gravity
    work.load[2] -= p.friction_arm * rub
    inertia(x, vm, p, work.matrix, work.bias)
    for j in range(n):
        out[j] = work.bias[j] - work.force[j]
        for c in range(3):
            out[j] -= work.jacobian[c, j] * work.load[c]
        for k in range(n):
            out[j] += work.matrix[j, k] * (2.0 / h) * (vm[k] - state.v[k])


@compiled(inline="always")
def _membrane_load(dt: float, state: State, p: RigParameters, work: _Work) -> None:
    """Fill `work.load` with the membranes' forces along (q, u_y, φ), `dt` after the state; and `work.branches`."""
    work.load[0] = work.load[1] = work.load[2] = 0.0
    soft = 1.0 - p.softening * (1.0 - np.exp(-state.age[0] / p.softening_time))
    for side in range(2):
        l1 = stretch(side, work.pose, p, work.gradient)
        rate = 0.0
        for c in range(3):
            rate += work.gradient[c] * work.speed[c]
        strain, slope = viscous_strain(l1, p.strain)
        pull = soft * rubber_stress(l1, side, p) + p.kelvin_voigt * slope * slope * rate
        for b in range(p.branch_time.size):
            e = (state.branches[side, b] + strain - state.strain[side]) / (1.0 + dt / p.branch_time[b])
            work.branches[side, b] = e
            pull += p.branch_modulus[side, b] * e * slope
        electric = 0.5 * p.capacitance[side] * p.capacitance_exponent * l1 ** (p.capacitance_exponent - 1.0)
        conjugate = electric * state.charge[side] - p.volume[side] * pull
        for c in range(3):
            work.load[c] += conjugate * work.gradient[c]


@compiled(inline="always")
def _invert(a: FloatArray, inverse: FloatArray) -> None:
    """Fill `inverse` with the inverse of the small matrix `a`, which is destroyed: Gauss–Jordan with row pivots."""
    n = a.shape[0]
    for i in range(n):
        for j in range(n):
            inverse[i, j] = 1.0 if i == j else 0.0
    for c in range(n):
        pivot = c
        for i in range(c + 1, n):
            if abs(a[i, c]) > abs(a[pivot, c]):
                pivot = i
        for j in range(n):
            a[c, j], a[pivot, j] = a[pivot, j], a[c, j]
            inverse[c, j], inverse[pivot, j] = inverse[pivot, j], inverse[c, j]
        scale = 1.0 / a[c, c]
        for j in range(n):
            a[c, j] *= scale
            inverse[c, j] *= scale
        for i in range(n):
            if i != c:
                factor = a[i, c]
                for j in range(n):
                    a[i, j] -= factor * a[c, j]
                    inverse[i, j] -= factor * inverse[c, j]


@compiled(inline="always")
def _newton(h: float, renew: bool, state: State, p: RigParameters, work: _Work) -> bool:
    """Solve the step for `work.middle`, from what it holds; False if that fails. The Jacobian is renewed on demand."""
    vm = work.middle
    n = vm.size
    residuals = np.empty((n + 1, n))
    tangent = np.empty((n, n))
    for iteration in range(_MAX_NEWTON):
        columns = n if (renew and iteration == 0) or iteration % 8 == 7 else 0
        for j in range(columns + 1):  # the last evaluation is the unperturbed one
            unperturbed = vm[min(j, n - 1)]
            if j < columns:
                vm[j] += _NUDGE / h
            _imbalance(vm, h, state, p, work, residuals[j])
            vm[min(j, n - 1)] = unperturbed
        residual = residuals[columns]
        if columns > 0:
            for j in range(n):
                for i in range(n):
                    tangent[i, j] = (residuals[j, i] - residual[i]) * (h / _NUDGE)
            _invert(tangent, work.inverse)
        largest = 0.0
        size = 1.0
        for i in range(n):
            change = 0.0
            for j in range(n):
                change += work.inverse[i, j] * residual[j]
            vm[i] -= change
            if not abs(change) <= largest:  # so written, a NaN stays
                largest = abs(change)
            size = max(size, 1.0 + abs(vm[i]))
        if largest <= _TOLERANCE * size:
            return True
    return False


def at_rest(p: RigParameters, start: FloatArray, drag: float = 0.0) -> tuple[State, _Work]:
    """The joint at rest, its viscous branches and friction relaxed, and arrays for its steps.

    Parameters
    ----------
    p : RigParameters
        The joint.
    start : FloatArray, shape (n,)
        Its coordinates.
    drag : float
        Force [N] of a wire that slides; before that it gives way by `GIVE`.
    """
    n = start.size
    state = State(
        x=start.copy(),
        v=np.zeros(n),
        branches=np.zeros(p.branch_modulus.shape),
        strain=np.zeros(2),
        z=np.zeros(p.slip_force.size),
        sliding=np.zeros(1),
        charge=np.zeros(2),
        layers=np.zeros((p.plastic_share.size, n)),
        bends=np.array([hinge_angle(start, i) for i in range(n)]),
        age=np.zeros(1),
        hand=np.zeros(2),
        wire=np.array([0.0, drag]),
    )
    work = _Work(
        x=np.zeros(n),
        pose=np.zeros(3),
        jacobian=np.zeros((3, n)),
        speed=np.zeros(3),
        gradient=np.zeros(3),
        load=np.zeros(3),
        force=np.zeros(n),
        bias=np.zeros(n),
        matrix=np.zeros((n, n)),
        branches=np.zeros(p.branch_modulus.shape),
        z=np.zeros(p.slip_force.size),
        layers=np.zeros((p.plastic_share.size, n)),
        middle=np.zeros(n),
        inverse=np.zeros((n, n)),
    )
    tip(state.x, p, work.pose, work.jacobian)
    state.sliding[0] = work.pose[0] + p.friction_arm * work.pose[2]
    state.wire[0] = work.pose[0]
    return state, work


@inner
def locate_tip(x: FloatArray, v: FloatArray, p: RigParameters, work: _Work) -> None:
    """Fill pose, Jacobian and speed of the tip in `work`.

    Parameters
    ----------
    x, v : FloatArray, shape (n,)
        Coordinates and their rates.
    p : RigParameters
        The joint.
    work : _Work
        Arrays of the integrator.
    """
    tip(x, p, work.pose, work.jacobian)
    for c in range(3):
        work.speed[c] = 0.0
        for j in range(v.size):
            work.speed[c] += work.jacobian[c, j] * v[j]


@compiled(inline="always")
def advance(h: float, renew: bool, state: State, p: RigParameters, work: _Work) -> bool:
    """One step of `h` [s] under `state.charge` and `state.hand`; False if the joint cannot follow.

    `work.pose` must be that of the state (see `locate_tip`).

    Parameters
    ----------
    h : float
        Length of the step [s].
    renew : bool
        True if the inverse is made anew.
    state : State
        State of the joint, which is moved.
    p : RigParameters
        The joint.
    work : _Work
        Arrays of the integrator.
    """
    n = state.x.size
    for side in range(2):
        state.strain[side] = viscous_strain(stretch(side, work.pose, p, work.gradient), p.strain)[0]
    copy_into(work.middle, state.v)
    if not _newton(h, renew, state, p, work):
        return False
    for j in range(n):
        state.x[j] += h * work.middle[j]
        state.v[j] = 2.0 * work.middle[j] - state.v[j]
    for side in range(2):
        for b in range(p.branch_time.size):
            state.branches[side, b] = 2.0 * work.branches[side, b] - state.branches[side, b]
    tip(state.x, p, work.pose, work.jacobian)
    sliding = work.pose[0] + p.friction_arm * work.pose[2]
    shifted = sliding - state.sliding[0]
    slide(state.z, shifted, shifted / h, h, p, work.z)  # friction over the whole of the step just taken
    copy_into(state.z, work.z)
    state.sliding[0] = sliding
    yielding(state.x, state.bends, state.layers, p, work.force, work.layers)
    for i in range(n):
        state.bends[i] = hinge_angle(state.x, i)
        for k in range(p.plastic_share.size):
            state.layers[k, i] = work.layers[k, i]
    state.age[0] += h
    return True


@compiled
def march(
    p: RigParameters,
    state: State,
    work: _Work,
    load: Load,
    h: float,
    first: int,
    poses: FloatArray,
    rates: FloatArray,
) -> bool:
    """Move a joint by N steps.

    Parameters
    ----------
    p : RigParameters
        The joint.
    state, work : State, _Work
        From `at_rest`; moved.
    load : Load
        What acts.
    h : float
        Length of a step [s].
    first : int
        Number of the first step, of which every `KEEP`-th renews the Jacobian.
    poses, rates : FloatArray, shape (N + 1, 3)
        (q, u_y, φ) and their rates at the start of each step, and after the last (output).

    Returns
    -------
    bool
        False if Newton's method failed, as when a membrane is stretched beyond its rubber law.

    Notes
    -----
    Cost: about 2.5 residuals of 1.5 µs a step, and n more every twelve steps; 10 µs for each call.
    """
    steps = len(load.force)
    for step in range(steps + 1):
        locate_tip(state.x, state.v, p, work)
        copy_into(poses[step], work.pose)
        copy_into(rates[step], work.speed)
        if step == steps:
            break
        copy_into(state.charge, load.charge[step])
        q = work.pose[0]
        state.wire[0] = min(max(state.wire[0], q - GIVE), q + GIVE)
        state.hand[0] = load.force[step] - state.wire[1] * (q - state.wire[0]) / GIVE
        state.hand[1] = load.spring[step]
        if not advance(h, (first + step) % KEEP == 0, state, p, work):
            return False
    return True
