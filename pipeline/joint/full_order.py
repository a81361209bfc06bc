"""The full-order dynamic model (eqs. 19 to 23): simulation and initial states."""

from dataclasses import dataclass

import numpy as np

from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.generated.analytical_joint import dissipation, statics
from pipeline.joint.equilibria import equilibria, length_scales
from pipeline.joint.parameters import JointParameters
from pipeline.joint.static_path import StaticPath, hold_tip, unactuated_path
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.inner_loops import factorise, solve_factorised
from pipeline.solvers.rosenbrock import integrate
from pipeline.solvers.stiff import STATES

REACH = 0.06
"""Displacement [m] beyond which a run counts as diverged."""
_TYPICAL = np.array([0.1, 0.1, 0.1, 1e-3])
"""Typical contributions of q2, q3, q4 and u0 [m]: the three large ones cancel to some mm at the tip."""


@dataclass(frozen=True)
class FullOrderMotion:
    """A motion of the full-order joint at the samples.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s].
    qm, qm_dot, qm_ddot : FloatArray, shape (N, 4)
        Ritz coordinates and their rates; NaN behind a divergence.
    z : FloatArray, shape (N, 3)
        Maxwell strains of left and right membrane, friction state.
    q, q_dot, q_ddot, phi : FloatArray, shape (N,)
        Tip displacement [m], velocity [m/s], acceleration [m/s²] and tip rotation [rad].
    diverged_at : float or None
        Time [s] at which the state left the bounds.
    accepted, rejected : int
        Steps of the integrator.
    """

    t: FloatArray
    qm: FloatArray
    qm_dot: FloatArray
    qm_ddot: FloatArray
    z: FloatArray
    q: FloatArray
    q_dot: FloatArray
    q_ddot: FloatArray
    phi: FloatArray
    diverged_at: float | None
    accepted: int
    rejected: int


def state_scale(parameters: JointParameters) -> FloatArray:
    """Typical size of each state, shape (11,); tolerances are relative to it."""
    shape = _TYPICAL * length_scales(parameters.l)
    return np.concatenate([shape, 20.0 * shape, [0.1, 0.1, 1.0]])


def rest_state(
    parameters: JointParameters, q0: float, qdot0: float, v: FloatArray, z: FloatArray | None = None
) -> FloatArray:
    """State (11,) of a joint of which only q0 [m] and qdot0 [m/s] are known.

    The shape is static under the voltages `v` (2,), and lags behind the static path as far as the damping at
    qdot0 and the internal states `z` (3,) push it: a first-order slow manifold. Without `z` the Maxwell elements
    have relaxed, as after a long rest.

    Raises
    ------
    InputError
        No shape holds the tip at q0.
    """
    known, internal = np.array([[q0, qdot0]]), np.zeros((1, 3)) if z is None else z[None]
    try:
        path = unactuated_path(parameters)
    except InputError:
        return np.ravel(_rest_states(parameters, known, v[None], internal, _walked(parameters, q0)[None]))
    return np.ravel(rest_states(parameters, known, v[None], internal, path))


def rest_states(
    parameters: JointParameters, known: FloatArray, v: FloatArray, z: FloatArray, path: StaticPath
) -> FloatArray:
    """The same for many: states (W, 11) for q0 and qdot0 (W, 2), `v` (W, 2) and `z` (W, 3).

    The search for a shape starts from the nearest of `path`.
    """
    nearest = np.argmin(np.abs(path.q - known[:, :1]), axis=1)
    shapes = path.qm[nearest] + path.tangent[nearest] * (known[:, :1] - path.q[nearest, None])
    return _rest_states(parameters, known, v, z, shapes)


def _rest_states(
    parameters: JointParameters, known: FloatArray, v: FloatArray, z: FloatArray, shapes: FloatArray
) -> FloatArray:
    """Those found by Newton from `shapes` (W, 4)."""
    found = np.empty((len(known), STATES))
    held = _hold(known, v**2, z, shapes, parameters.vector(), found)
    if held < len(known):
        at = f"q = {1e3 * known[held, 0]:.2f} mm under {v[held]} V"
        raise InputError(f"the joint cannot be held at {at}; check q0 and its unit")
    return found


@compiled
def _hold(
    known: FloatArray, v_squared: FloatArray, z: FloatArray, shapes: FloatArray, p: FloatArray, found: FloatArray
) -> int:
    """Fill the states `found` (W, 11) that begin at `known` (W, 2); how many can be held, the first ones."""
    tangent, pivots, scale = np.empty(4), np.empty(5, np.int64), np.ones(4)
    gradient, hessian, system, right = np.empty(4), np.empty((4, 4)), np.empty((5, 5)), np.empty(5)
    damping, coupling, thickness = np.empty((4, 4)), np.empty((4, 3)), np.empty((2, 4))
    scale[0], scale[1], scale[2] = p[0] ** -2, p[0] ** -3, p[0] ** -4
    for w in range(len(known)):
        x, qdot = found[w], known[w, 1]
        for i in range(4):
            x[i] = shapes[w, i]
        force, _, _ = hold_tip(known[w, 0], x[:4], v_squared[w], p, tangent)
        if not np.isfinite(force):
            return w
        for i in range(4):
            x[4 + i] = tangent[i] * qdot
        for i in range(3):
            x[8 + i] = z[w, i]
        if qdot == 0.0 and x[8] == 0.0 and x[9] == 0.0 and x[10] == 0.0:
            continue
        # The change of shape, the tip held, by which elastic forces balance damping and internal forces.
        statics(x[:4], v_squared[w], p, gradient, hessian)
        dissipation(x[:4], p, damping, coupling, thickness)
        for i in range(4):
            right[i] = 0.0
            for j in range(4):
                system[i, j] = hessian[i, j] * scale[i] * scale[j]
                right[i] -= scale[i] * damping[i, j] * x[4 + j]
            for j in range(3):
                right[i] -= scale[i] * coupling[i, j] * x[8 + j]
            system[i, 4] = -1.0 if i < 3 else 0.0
            system[4, i] = -system[i, 4]
        system[4, 4], right[4] = 0.0, 0.0
        regular = factorise(system, pivots)
        if regular:
            solve_factorised(system, pivots, right)
        for i in range(4):
            x[i] += right[i] * scale[i] if regular else np.nan
    return len(known)


def _walked(parameters: JointParameters, q0: float) -> FloatArray:
    """A static shape (4,) with its tip at q0, without voltage, of a joint without a path through q = 0.

    It is found by walking from the nearest equilibrium; NaN if there is none.
    """
    rests = equilibria(parameters, np.zeros(2))
    if not rests:
        return np.full(4, np.nan)
    start = min(rests, key=lambda e: abs(e.q - q0))
    qm, tangent = start.qm.copy(), np.empty(4)
    for q in np.linspace(start.q, q0, 2 + int(min(abs(q0 - start.q) / 2.5e-4, 1e4))):
        hold_tip(q, qm, np.zeros(2), parameters.vector(), tangent)
    return qm


def simulate(
    parameters: JointParameters,
    t: FloatArray,
    v: FloatArray,
    x0: FloatArray,
    *,
    force: FloatArray | None = None,
    tolerance: float = 1e-6,
) -> FullOrderMotion:
    """Simulate the full-order model.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    t : FloatArray, shape (N,)
        Ascending sample times [s].
    v : FloatArray, shape (N, 2)
        Voltages [V], linear between samples.
    x0 : FloatArray, shape (11,)
        Initial state, e.g. `rest_state` or an equilibrium.
    force : FloatArray, shape (N,), optional
        External force along q [N], linear between samples.
    tolerance : float
        Local error of a step, relative to `state_scale`. 1e-6 keeps q within about 1 µm of the exact solution
        over 37.5 s wherever the motion itself is not sensitive (see the tests).

    Notes
    -----
    Cost: about 4 µs a step of the integrator.
    """
    count = t.size
    states, rates, steps = np.full((count, STATES), np.nan), np.full((count, STATES), np.nan), np.zeros(2, np.int64)
    load = np.zeros(count) if force is None else np.ascontiguousarray(force)
    valid = integrate(
        np.ascontiguousarray(t), np.ascontiguousarray(v), load, x0, parameters.vector(),
        tolerance * state_scale(parameters), REACH, states, rates, steps,
    )  # fmt: skip
    states[valid:], rates[valid:] = np.nan, np.nan
    qm, qm_dot, qm_ddot = states[:, :4], states[:, 4:8], rates[:, 4:8]
    levers, slopes = parameters.levers, parameters.slopes
    return FullOrderMotion(
        t, qm, qm_dot, qm_ddot, states[:, 8:], qm @ levers, qm_dot @ levers, qm_ddot @ levers, np.arctan(qm @ slopes),
        None if valid == count else float(t[min(valid, count - 1)]), int(steps[0]), int(steps[1]),
    )  # fmt: skip
