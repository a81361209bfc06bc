"""RODAS4 for the full-order joint: linearly implicit, L-stable, order 4(3), adaptive, compiled.

E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, § IV.7,
doi:10.1007/978-3-642-05221-7. The joint's spectrum (−5e4, −1366 ± 7955i … −0.7 ± 20.7i) rules explicit methods
out; a Rosenbrock method needs no Newton iteration, restarts for free after a voltage step, and, with exact
Jacobians from automatic differentiation, one 4×4 factorisation a step.

The stage system for x = [q_m, q̇_m, z] is reduced to the velocities before it is factorised: q_m enters as the
integral of q̇_m and ż is diagonal in z.
"""

# mypy: disable-error-code="untyped-decorator"

from typing import NamedTuple

import numpy as np
from numba import njit

from pipeline.generated.analytical_joint import dynamics, linearisation
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.small_linear import factorise, solve_factorised

STATES = 11
"""q_m (4), q̇_m (4), Maxwell strains (2), friction state (1)."""

_GAMMA = 0.25
_A = np.array(
    [
        [0.0, 0.0, 0.0, 0.0, 0.0],
        [1.544, 0.0, 0.0, 0.0, 0.0],
        [0.9466785280815826, 0.2557011698983284, 0.0, 0.0, 0.0],
        [3.314825187068521, 2.896124015972201, 0.9986419139977817, 0.0, 0.0],
        [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 0.0],
        [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0],
    ]
)
_C = np.array(
    [
        [0.0, 0.0, 0.0, 0.0, 0.0],
        [-5.6688, 0.0, 0.0, 0.0, 0.0],
        [-2.430093356833875, -0.2063599157091915, 0.0, 0.0, 0.0],
        [-0.1073529058151375, -9.594562251023355, -20.47028614809616, 0.0, 0.0],
        [7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160, 0.0],
        [8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054],
    ]
)
_NODES = np.array([0.0, 0.386, 0.21, 0.63, 1.0, 1.0])
_TIME_DERIVATIVE = np.array([0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0])


class Workspace(NamedTuple):
    """Arrays that live through an integration; without them every step would allocate twenty.

    What takes a workspace is inlined: a call would count twenty references up and down, a fifth of a step's cost.
    """

    x_new: FloatArray
    right: FloatArray
    f: FloatArray
    f0: FloatArray
    f_t: FloatArray
    stages: FloatArray
    mass: FloatArray
    mass_lu: FloatArray
    mass_pivots: IntArray
    factors: FloatArray
    pivots: IntArray
    r_q: FloatArray
    r_v: FloatArray
    r_z: FloatArray
    r_s: FloatArray
    z_q: FloatArray
    z_v: FloatArray
    z_z: FloatArray
    voltage: FloatArray
    v_squared: FloatArray
    load: FloatArray


@njit(cache=True, error_model="numpy")
def _workspace() -> Workspace:
    return Workspace(
        np.empty(STATES), np.empty(STATES), np.empty(STATES), np.empty(STATES), np.zeros(STATES),
        np.empty((6, STATES)),
        np.empty((4, 4)), np.empty((4, 4)), np.empty(4, np.int64), np.empty((4, 4)), np.empty(4, np.int64),
        np.empty((4, 4)), np.empty((4, 4)), np.empty((4, 3)), np.empty((4, 2)),
        np.empty((3, 4)), np.empty((3, 4)), np.empty(3),
        np.empty(2), np.empty(2), np.empty(1),
    )  # fmt: skip


@njit(cache=True, error_model="numpy", forceinline=True)
def _copy(source: FloatArray, target: FloatArray) -> None:
    """An assignment of slices would compile seconds longer, for the message that it could raise."""
    for i in range(source.size):
        target[i] = source[i]


@njit(cache=True, error_model="numpy", inline="always")
def _set_inputs(
    offset: float, v: FloatArray, slope: FloatArray, load: float, load_slope: float, work: Workspace
) -> None:
    """Inputs at `offset` [s] behind the sample at which they are `v` and `load`."""
    for side in range(2):
        work.voltage[side] = v[side] + slope[side] * offset
        work.v_squared[side] = work.voltage[side] ** 2
    work.load[0] = load + load_slope * offset


@njit(cache=True, error_model="numpy", inline="always")
def _derivative(x: FloatArray, p: FloatArray, work: Workspace, mass: FloatArray, out: FloatArray) -> bool:
    """ẋ (11,) under the present inputs, and the mass matrix; False if that is singular."""
    dynamics(x[:4], x[4:8], x[8:], work.v_squared, work.load, p, mass, out[4:8], out[8:])
    for i in range(4):
        out[i] = x[4 + i]
        for j in range(4):
            work.mass_lu[i, j] = mass[i, j]
    if not factorise(work.mass_lu, work.mass_pivots):
        return False
    solve_factorised(work.mass_lu, work.mass_pivots, out[4:8])
    return True


@njit(cache=True, error_model="numpy", inline="always")
def _linearise(x: FloatArray, slope: FloatArray, load_slope: float, p: FloatArray, work: Workspace) -> bool:
    """f, ∂f/∂t and the Jacobian's blocks at the beginning of a step."""
    if not _derivative(x, p, work, work.mass, work.f0):
        return False
    linearisation(
        x[:4], x[4:8], x[8:], work.v_squared, work.load, p, work.f0[4:8],
        work.r_q, work.r_v, work.r_z, work.z_q, work.z_v, work.z_z, work.r_s,
    )  # fmt: skip
    lever = p[0] * p[0]
    for i in range(4):
        work.f_t[4 + i] = -2.0 * (
            work.r_s[i, 0] * work.voltage[0] * slope[0] + work.r_s[i, 1] * work.voltage[1] * slope[1]
        )
        if i < 3:
            # ∂q/∂q_m = [l², l³, l⁴, 0]: the force acts on the tip.
            work.f_t[4 + i] += lever * load_slope
            lever *= p[0]
    solve_factorised(work.mass_lu, work.mass_pivots, work.f_t[4:8])
    return True


@njit(cache=True, error_model="numpy", inline="always")
def _factorise_stages(shift: float, work: Workspace) -> bool:
    """Factorise the velocity block of ``shift·I − J``, multiplied by M: q_m and z are eliminated."""
    for i in range(4):
        for j in range(4):
            value = shift * work.mass[i, j] + work.r_v[i, j] + work.r_q[i, j] / shift
            for k in range(3):
                value += work.r_z[i, k] * (work.z_v[k, j] + work.z_q[k, j] / shift) / (shift - work.z_z[k])
            work.factors[i, j] = value
    return bool(factorise(work.factors, work.pivots))


@njit(cache=True, error_model="numpy", inline="always")
def _solve_stage(shift: float, work: Workspace, out: FloatArray) -> None:
    """Solve ``(shift·I − J) out = work.right``, shape (11,)."""
    right, velocity = work.right, out[4:8]
    for i in range(4):
        value = 0.0
        for j in range(4):
            value += work.mass[i, j] * right[4 + j] - work.r_q[i, j] * right[j] / shift
        for k in range(3):
            internal = right[8 + k]
            for j in range(4):
                internal += work.z_q[k, j] * right[j] / shift
            value -= work.r_z[i, k] * internal / (shift - work.z_z[k])
        velocity[i] = value
    solve_factorised(work.factors, work.pivots, velocity)
    for i in range(4):
        out[i] = (right[i] + velocity[i]) / shift
    for k in range(3):
        value = right[8 + k]
        for j in range(4):
            value += work.z_q[k, j] * out[j] + work.z_v[k, j] * velocity[j]
        out[8 + k] = value / (shift - work.z_z[k])


@njit(cache=True, error_model="numpy", inline="always")
def _attempt_step(
    x: FloatArray, h: float, offset: float, v: FloatArray, slope: FloatArray, load: float, load_slope: float,
    p: FloatArray, scale: FloatArray, work: Workspace,
) -> float:  # fmt: skip
    """One step from `x` into `work.x_new`; returns the RMS of error / scale, infinite if the step failed."""
    shift = 1.0 / (_GAMMA * h)
    if not _factorise_stages(shift, work):
        return np.inf
    for s in range(6):
        if s == 0:
            _copy(work.f0, work.f)
        else:
            for i in range(STATES):
                work.x_new[i] = x[i]
                for j in range(s):
                    work.x_new[i] += _A[s, j] * work.stages[j, i]
            _set_inputs(offset + _NODES[s] * h, v, slope, load, load_slope, work)
            if not _derivative(work.x_new, p, work, work.mass_lu, work.f):
                return np.inf
        for i in range(STATES):
            work.right[i] = work.f[i] + _TIME_DERIVATIVE[s] * h * work.f_t[i]
            for j in range(s):
                work.right[i] += _C[s, j] / h * work.stages[j, i]
        _solve_stage(shift, work, work.stages[s])
    # Stiffly accurate: the last stage completes the solution and is the error estimate.
    norm = 0.0
    for i in range(STATES):
        work.x_new[i] += work.stages[5, i]
        norm += (work.stages[5, i] / scale[i]) ** 2
    return np.sqrt(norm / STATES) if np.isfinite(norm) else np.inf


@njit(cache=True, error_model="numpy", nogil=True)
def integrate(
    t: FloatArray, v: FloatArray, force: FloatArray, x0: FloatArray, p: FloatArray,
    scale: FloatArray, reach: float, states: FloatArray, rates: FloatArray, counts: IntArray,
) -> int:  # fmt: skip
    """Integrate under voltages and force that are linear between samples.

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Sample times [s]; every sample is a step's end, so that no step sees a kink of the inputs.
    v, force : FloatArray, shapes (N, 2) and (N,)
        Voltages [V] and force along q [N].
    x0, p : FloatArray, shapes (11,) and (41,)
        Initial state and parameters.
    scale : FloatArray, shape (11,)
        Tolerated local error of each state: a step is accepted when the RMS of error / scale is below 1.
    reach : float
        |q| [m] beyond which the run counts as diverged.
    states, rates : FloatArray, shape (N, 11)
        The solution and its time derivative at the samples (output).
    counts : IntArray, shape (2,)
        Accepted and rejected steps (output).

    Returns
    -------
    int
        Number of valid samples; N unless the run diverged.

    Notes
    -----
    Cost: a step evaluates `dynamics` six times and `linearisation` once and factorises 4×4 seven times.
    """
    x, work = x0.copy(), _workspace()
    counts[0], counts[1] = 0, 0
    h_next, slope = 1e-4, np.zeros(2)
    for sample in range(t.size):
        _copy(x, states[sample])
        slope[0], slope[1], load_slope = 0.0, 0.0, 0.0
        if sample < t.size - 1:
            for side in range(2):
                slope[side] = (v[sample + 1, side] - v[sample, side]) / (t[sample + 1] - t[sample])
            load_slope = (force[sample + 1] - force[sample]) / (t[sample + 1] - t[sample])
        _set_inputs(0.0, v[sample], slope, force[sample], load_slope, work)
        q = ((x[2] * p[0] + x[1]) * p[0] + x[0]) * p[0] * p[0]
        if not _linearise(x, slope, load_slope, p, work) or not abs(q) < reach:
            return sample
        _copy(work.f0, rates[sample])
        if sample == t.size - 1:
            break
        offset, interval = 0.0, t[sample + 1] - t[sample]
        while offset < interval:
            remaining = interval - offset
            h = remaining if h_next >= remaining else min(h_next, 0.5 * remaining)
            norm = _attempt_step(x, h, offset, v[sample], slope, force[sample], load_slope, p, scale, work)
            factor = min(5.0, max(0.2, 0.9 * max(norm, 1e-10) ** -0.25))
            if norm > 1.0:
                counts[1] += 1
                h_next = factor * h
                if h_next < 1e-12 * interval:
                    return sample + 1
                continue
            counts[0] += 1
            _copy(work.x_new, x)
            # A step cut short by the sample's end says nothing against the longer one.
            h_next = max(factor * h, h_next) if h == remaining else factor * h
            offset = interval if h == remaining else offset + h
            if offset < interval:
                _set_inputs(offset, v[sample], slope, force[sample], load_slope, work)
                if not _linearise(x, slope, load_slope, p, work):
                    return sample + 1
    return t.size
