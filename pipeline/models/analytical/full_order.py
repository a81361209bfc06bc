"""The full-order dynamic model (eqs. 19 to 23): simulation by RODAS4, and initial states.

Steps are adaptive, with exact Jacobians (`pipeline.numerics.stiff`).
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...device.parameters import JointParameters
from ...errors import InputError
from ...generated.analytical_joint import dissipation, motion, motion_slopes, statics
from ...numerics.arrays import FloatArray, IntArray
from ...numerics.compiled import compiled, copy_into, factorise, inner, solve_factorised
from ...numerics.fixed_step import run_status
from ...numerics.stiff import FIRST_Z, INTERNAL, R_S, RITZ, RODAS4, STATES, Work, advance, factorise_stages, working
from ..base import FreeRun
from .statics import TYPICAL_SHAPE, StaticPath, equilibria, hold_tip, length_scales, unactuated_path

REACH = 0.06
"""Displacement [m] beyond which a run counts as diverged."""

MOST_TRIES = 20_000
"""Steps between two samples, refused ones too, beyond which a run counts as diverged: a joint takes 2 to 20 in 10 ms;
one that blows up would never end."""


@dataclass(frozen=True, kw_only=True)
class FullOrderMotion(FreeRun):
    """A motion of the full-order joint at the samples.

    Attributes
    ----------
    qm, qm_dot : FloatArray, shape (N, 4)
        Ritz coordinates and their rates; NaN behind a divergence.
    z : FloatArray, shape (N, 3)
        Maxwell strains of left and right membrane, friction state.
    phi : FloatArray, shape (N,)
        Tip rotation [rad].
    accepted, rejected : int
        Steps of the integrator.
    """

    qm: FloatArray
    qm_dot: FloatArray
    z: FloatArray
    phi: FloatArray
    accepted: int
    rejected: int


def state_scale(parameters: JointParameters) -> FloatArray:
    """Typical size of each state, shape (11,); tolerances are relative to it."""
    shape = TYPICAL_SHAPE * length_scales(parameters.l)
    return np.concatenate([shape, 20.0 * shape, [0.1, 0.1, 1.0]])


def rest_state(
    parameters: JointParameters, q0: float, qdot0: float, v: FloatArray, z: FloatArray | None = None
) -> FloatArray:
    """State (11,) of a joint of which only q0 [m] and qdot0 [m/s] are known.

    The shape is static under the voltages `v` (2,), and lags behind the static path as far as the damping at
    qdot0 and the internal states `z` (3,) drive it: a first-order slow manifold. Without `z` the Maxwell elements
    have relaxed, as after a long rest.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    q0, qdot0 : float
        Displacement [m] and velocity [m/s] of the tip.
    v : FloatArray, shape (2,)
        Voltages [V].
    z : FloatArray, shape (3,), optional
        Maxwell strains and friction state.

    Raises
    ------
    InputError
        No shape holds the tip at q0.
    """
    measured = np.array([[q0, qdot0]])
    internal = np.zeros((1, 3)) if z is None else z[None]
    try:
        path = unactuated_path(parameters)
    except InputError:
        return np.ravel(_rest_states(parameters, measured, v[None], internal, _walked(parameters, q0)[None]))
    return np.ravel(rest_states(parameters, measured, v[None], internal, path))


def rest_states(
    parameters: JointParameters, measured: FloatArray, v: FloatArray, z: FloatArray, path: StaticPath
) -> FloatArray:
    """States of rest of many joints, (W, 11), for q0 and qdot0 (W, 2), `v` (W, 2) and `z` (W, 3).

    The search for a shape starts from the nearest of `path`.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    measured : FloatArray, shape (W, 2)
        q0 [m] and qdot0 [m/s].
    v : FloatArray, shape (W, 2)
        Voltages [V].
    z : FloatArray, shape (W, 3)
        Maxwell strains and friction state.
    path : StaticPath
        Shapes from which the searches start.
    """
    nearest = np.argmin(np.abs(path.q - measured[:, :1]), axis=1)
    shapes = path.qm[nearest] + path.tangent[nearest] * (measured[:, :1] - path.q[nearest, None])
    return _rest_states(parameters, measured, v, z, shapes)


def dissipative_matrices(qm: FloatArray, p: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Damping at a shape q_m, shape (RITZ, RITZ), and coupling to the internal states, shape (RITZ, INTERNAL)."""
    damping = np.empty((RITZ, RITZ))
    coupling = np.empty((RITZ, INTERNAL))
    dissipation(qm, p, damping, coupling, np.empty((2, RITZ)))
    return damping, coupling


def _rest_states(
    parameters: JointParameters, measured: FloatArray, v: FloatArray, z: FloatArray, shapes: FloatArray
) -> FloatArray:
    """The states that Newton's method reaches from `shapes` (W, 4). Cost: 40 µs each."""
    p = parameters.vector()
    scale = length_scales(parameters.l)
    lever = np.array([1.0, 1.0, 1.0, 0.0])
    states = np.empty((len(measured), STATES))
    tangent = np.empty(RITZ)
    gradient = np.empty(RITZ)
    hessian = np.empty((RITZ, RITZ))
    system = np.zeros((RITZ + 1, RITZ + 1))
    for x, (q, qdot), volts, internal, shape in zip(states, measured, v, z, shapes, strict=True):
        x[:RITZ] = shape
        if not np.isfinite(hold_tip(q, x[:RITZ], volts**2, p, tangent)[0]):
            raise InputError(f"the joint cannot be held at q = {1e3 * q:.2f} mm under {volts} V; check q0 and its unit")
        x[RITZ:FIRST_Z], x[FIRST_Z:] = tangent * qdot, internal
        # The change of shape, the tip held, by which elastic forces balance damping and internal forces.
        statics(x[:RITZ], volts**2, p, gradient, hessian)
        damping, coupling = dissipative_matrices(x[:RITZ], p)
        system[:RITZ, :RITZ] = hessian * np.outer(scale, scale)
        system[:RITZ, RITZ] = -lever
        system[RITZ, :RITZ] = lever
        pull = scale * (damping @ x[RITZ:FIRST_Z] + coupling @ internal)
        x[:RITZ] -= scale * np.linalg.solve(system, np.append(pull, 0.0))[:RITZ]
    return states


def _walked(parameters: JointParameters, q0: float) -> FloatArray:
    """A static shape (4,) with its tip at q0, without voltage, of a joint without a path through q = 0.

    It is found by walking from the nearest equilibrium; NaN if there is none.
    """
    rests = equilibria(parameters, np.zeros(2))
    if not rests:
        return np.full(RITZ, np.nan)
    start = min(rests, key=lambda e: abs(e.q - q0))
    qm = start.qm.copy()
    for q in np.linspace(start.q, q0, 2 + int(min(abs(q0 - start.q) / 2.5e-4, 1e4))):
        hold_tip(q, qm, np.zeros(2), parameters.vector(), np.empty(RITZ))
    return qm


class Inputs(NamedTuple):
    """Inputs of a run, linear between the samples.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Ascending sample times [s].
    v : FloatArray, shape (N, 2)
        Voltages [V].
    force : FloatArray, shape (N,)
        External force along q [N].
    """

    t: FloatArray
    v: FloatArray
    force: FloatArray


class Solution(NamedTuple):
    """A run at the samples.

    Attributes
    ----------
    states, rates : FloatArray, shape (N, 11)
        States and their time derivatives.
    steps : IntArray, shape (2,)
        Accepted and rejected steps of the integrator.
    """

    states: FloatArray
    rates: FloatArray
    steps: IntArray


def no_solution(count: int) -> Solution:
    """An empty solution at `count` samples: NaN, no steps."""
    return Solution(np.full((count, STATES), np.nan), np.full((count, STATES), np.nan), np.zeros(2, np.int64))


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
    solution = no_solution(t.size)
    load = np.zeros(t.size) if force is None else force
    inputs = Inputs(np.ascontiguousarray(t), np.ascontiguousarray(v), np.ascontiguousarray(load))
    valid = integrate(inputs, x0, parameters.vector(), tolerance * state_scale(parameters), REACH, solution)
    solution.states[valid:] = np.nan
    solution.rates[valid:] = np.nan
    qm, qm_dot, z = np.split(solution.states, [RITZ, FIRST_Z], axis=1)
    levers = parameters.levers
    return FullOrderMotion(
        t,
        qm @ levers,
        qm_dot @ levers,
        solution.rates[:, RITZ:FIRST_Z] @ levers,
        *run_status(t, valid),
        qm=qm,
        qm_dot=qm_dot,
        z=z,
        phi=np.arctan(qm @ parameters.slopes),
        accepted=int(solution.steps[0]),
        rejected=int(solution.steps[1]),
    )


class _Motion(NamedTuple):
    """The joint in a run: parameters p, inputs, where the step starts, and room for what is computed at a state.

    `x`, `x_new` (STATES,) are the states at both ends of the step, and `f0` (STATES,) the rates at its start. `sample`
    (1,) and `offset` (1,) say where it starts, [s] behind a sample; `rise` (3,) are the rates of voltages and force
    there; `f_t` (STATES,) is ∂f/∂t.
    """

    p: FloatArray
    v: FloatArray
    force: FloatArray
    x: FloatArray
    x_new: FloatArray
    f0: FloatArray
    sample: IntArray
    offset: FloatArray
    rise: FloatArray
    f_t: FloatArray
    squares: FloatArray
    load: FloatArray
    f: FloatArray
    mass: FloatArray
    factors: FloatArray
    pivots: IntArray


@inner
def _rate(s: _Motion, x: FloatArray, offset: float, mass: FloatArray, out: FloatArray) -> bool:
    """ẋ (11,) of the state x (11,) at `offset` [s] behind the sample, and M (4, 4); False if that is singular."""
    n = s.sample[0]
    for side in range(2):
        s.squares[side] = (s.v[n, side] + s.rise[side] * offset) ** 2
    s.load[0] = s.force[n] + s.rise[2] * offset
    motion(x, s.squares, s.load, s.p, mass, out)
    for i in range(RITZ):
        for j in range(RITZ):
            s.factors[i, j] = mass[i, j]
    if not factorise(s.factors, s.pivots):
        return False
    solve_factorised(s.factors, s.pivots, out[RITZ:FIRST_Z])
    return True


@compiled(inline="always")
def _time_derivative(s: _Motion, slopes: FloatArray) -> None:
    """∂f/∂t by the inputs' rates where the step starts, whose mass matrix has just been factorised."""
    n = s.sample[0]
    lever = s.p[0] * s.p[0]
    for i in range(RITZ):
        s.f_t[RITZ + i] = 0.0
        for side in range(2):
            volts = s.v[n, side] + s.rise[side] * s.offset[0]
            s.f_t[RITZ + i] -= 2.0 * slopes[R_S + 2 * i + side] * volts * s.rise[side]
        if i < 3:
            # ∂q/∂q_m = [l², l³, l⁴, 0]: the force acts on the tip.
            s.f_t[RITZ + i] += lever * s.rise[2]
            lever *= s.p[0]
    solve_factorised(s.factors, s.pivots, s.f_t[RITZ:FIRST_Z])


@inner
def _rises(t: FloatArray, v: FloatArray, force: FloatArray, sample: int, rise: FloatArray) -> float:
    """Rates of voltages and force behind a sample, filled into `rise` (3,); interval to the next, 0 at the last."""
    if sample == t.size - 1:
        return 0.0
    interval = t[sample + 1] - t[sample]
    for side in range(2):
        rise[side] = (v[sample + 1, side] - v[sample, side]) / interval
    rise[2] = (force[sample + 1] - force[sample]) / interval
    return float(interval)


@compiled(inline="always")
def _stage(s: _Motion, stage: int, h: float, work: Work) -> bool:
    """ẋ at a stage, with its share of h ∂f/∂t; rates and Jacobian of the first are those of the step's start."""
    if stage == 0:
        fine = factorise_stages(1.0 / (RODAS4.gamma * h), work)
        copy_into(s.f, s.f0)
    else:
        fine = _rate(s, work.at, s.offset[0] + RODAS4.nodes[stage] * h, s.mass, s.f)
    for i in range(STATES):
        work.right[i] = s.f[i] + RODAS4.by_time[stage] * h * s.f_t[i]
    return fine


@compiled(inline="always")
def _complete(work: Work, scale: FloatArray, x_new: FloatArray) -> float:
    """Stiffly accurate: the last stage completes the solution and is the error estimate; its RMS over the scale."""
    norm = 0.0
    for i in range(STATES):
        last = work.y[-1, i]
        x_new[i] = work.at[i] + last
        norm += (last / scale[i]) ** 2
    return float(np.sqrt(norm / STATES)) if np.isfinite(norm) else float(np.inf)


def integrate(
    inputs: Inputs, x0: FloatArray, p: FloatArray, scale: FloatArray, reach: float, solution: Solution
) -> int:
    """Integrate under voltages and force that are linear between samples.

    Parameters
    ----------
    inputs : Inputs
        Every sample is a step's end, so that no step sees a kink of them.
    x0, p : FloatArray, shapes (11,) and (41,)
        Initial state and parameters.
    scale : FloatArray, shape (11,)
        Tolerated local error of each state: a step is accepted when the RMS of error / scale is below 1.
    reach : float
        |q| [m] beyond which the run counts as diverged.
    solution : Solution
        The solution at the samples (output).

    Returns
    -------
    int
        Number of valid samples; N unless the run diverged, which is also what more than `MOST_TRIES` steps between two
        samples count as.

    Notes
    -----
    Cost: a step evaluates `motion` six times and `motion_slopes` once and factorises 4×4 seven times: 4 µs.
    """
    motion = _Motion(
        p=p,
        v=inputs.v,
        force=inputs.force,
        x=x0.copy(),
        x_new=np.empty(STATES),
        f0=np.empty(STATES),
        sample=np.zeros(1, np.int64),
        offset=np.zeros(1),
        rise=np.zeros(3),
        f_t=np.zeros(STATES),
        squares=np.empty(2),
        load=np.empty(1),
        f=np.empty(STATES),
        mass=np.empty((RITZ, RITZ)),
        factors=np.empty((RITZ, RITZ)),
        pivots=np.empty(RITZ, np.int64),
    )
    return _integrate(inputs.t, motion, working(len(RODAS4.nodes), 1), scale, reach, solution)


@compiled(nogil=True)
def _integrate(t: FloatArray, s: _Motion, work: Work, scale: FloatArray, reach: float, solution: Solution) -> int:
    p = s.p
    x = s.x
    f0 = s.f0
    states, rates, steps = solution
    h_next = 1e-4
    for sample in range(t.size):
        interval = _rises(t, s.v, s.force, sample, s.rise)
        offset = 0.0
        s.sample[0] = sample
        tries = 0
        while offset == 0.0 or offset < interval:
            fine = _rate(s, x, offset, work.mass, f0)
            if offset == 0.0:
                copy_into(states[sample], x)
                copy_into(rates[sample], f0)
                q = ((x[2] * p[0] + x[1]) * p[0] + x[0]) * p[0] * p[0]
                if not fine or not abs(q) < reach:
                    return sample
                if interval == 0.0:
                    break
            elif not fine:
                return sample + 1
            s.offset[0] = offset
            norm = np.inf
            remaining = interval - offset
            motion_slopes(x, s.squares, s.load, p, f0[RITZ:FIRST_Z], work.slopes)
            _time_derivative(s, work.slopes)
            while norm > 1.0:
                tries += 1
                if tries > MOST_TRIES:
                    return sample + 1
                h = remaining if h_next >= remaining else min(h_next, 0.5 * remaining)
                norm = _complete(work, scale, s.x_new) if advance(RODAS4, _stage, s, x, h, work) else np.inf
                factor = min(5.0, max(0.2, 0.9 * max(norm, 1e-10) ** -0.25))
                if norm > 1.0:
                    steps[1] += 1
                    h_next = factor * h
                    if h_next < 1e-12 * interval:
                        return sample + 1
            steps[0] += 1
            # A step cut short by the sample's end is no reason against the longer one.
            h_next = max(factor * h, h_next) if h == remaining else factor * h
            offset = interval if h == remaining else offset + h
            copy_into(x, s.x_new)
    return t.size
