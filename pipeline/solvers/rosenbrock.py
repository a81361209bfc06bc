"""RODAS4 for the full-order joint: linearly implicit, L-stable, order 4(3), adaptive, compiled.

E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, § IV.7,
doi:10.1007/978-3-642-05221-7. The joint's spectrum (−5e4, −1366 ± 7955i … −0.7 ± 20.7i) rules explicit methods
out; a Rosenbrock method needs no Newton iteration, restarts for free after a voltage step, and, with exact
Jacobians from automatic differentiation, one 4×4 factorisation a step.

The stage system for x = [q_m, q̇_m, z] is reduced to the velocities before it is factorised: q_m enters as the
integral of q̇_m and ż is diagonal in z.
"""

from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.analytical_joint import motion, motion_slopes
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


R_Q, R_V, R_Z, Z_Q, Z_V, Z_Z, R_S, SLOPES = 0, 16, 32, 44, 56, 68, 71, 79
"""Where the blocks of `motion_slopes` begin: r_q, r_v (4, 4), r_z (4, 3), z_q, z_v (3, 4), z_z (3,), r_s (4, 2)."""


@compiled
def _rate(
    x: FloatArray, squares: FloatArray, load: FloatArray, p: FloatArray, mass: FloatArray, factors: FloatArray,
    pivots: IntArray, out: FloatArray,
) -> bool:  # fmt: skip
    """ẋ (11,), the mass matrix and its factors; False if that is singular."""
    motion(x, squares, load, p, mass, out)
    for i in range(4):
        for j in range(4):
            factors[i, j] = mass[i, j]
    if not factorise(factors, pivots):
        return False
    solve_factorised(factors, pivots, out[4:8])
    return True


@compiled
def factorise_stages(shift: float, mass: FloatArray, slopes: FloatArray, factors: FloatArray, pivots: IntArray) -> bool:
    """Factorise the velocity block of ``shift·I − J``, multiplied by M: q_m and z are eliminated."""
    inverse = 1.0 / shift
    for i in range(4):
        for j in range(4):
            factors[i, j] = shift * mass[i, j] + slopes[R_V + 4 * i + j] + inverse * slopes[R_Q + 4 * i + j]
    for k in range(3):
        relaxed = 1.0 / (shift - slopes[Z_Z + k])
        for j in range(4):
            coupled = relaxed * (slopes[Z_V + 4 * k + j] + inverse * slopes[Z_Q + 4 * k + j])
            for i in range(4):
                factors[i, j] += slopes[R_Z + 3 * i + k] * coupled
    return bool(factorise(factors, pivots))


@compiled
def solve_stage(
    shift: float, mass: FloatArray, slopes: FloatArray, factors: FloatArray, pivots: IntArray, right: FloatArray,
    out: FloatArray,
) -> None:  # fmt: skip
    """Solve ``(shift·I − J) out = right``, shape (11,), with the factors of `factorise_stages`."""
    inverse, velocity, internal = 1.0 / shift, out[4:8], out[8:]
    for k in range(3):
        internal[k] = right[8 + k]
        for j in range(4):
            internal[k] += inverse * slopes[Z_Q + 4 * k + j] * right[j]
        internal[k] /= shift - slopes[Z_Z + k]
    for i in range(4):
        velocity[i] = 0.0
        for j in range(4):
            velocity[i] += mass[i, j] * right[4 + j] - inverse * slopes[R_Q + 4 * i + j] * right[j]
        for k in range(3):
            velocity[i] -= slopes[R_Z + 3 * i + k] * internal[k]
    solve_factorised(factors, pivots, velocity)
    for i in range(4):
        out[i] = inverse * (right[i] + velocity[i])
    for k in range(3):
        internal[k] = right[8 + k]
        for j in range(4):
            internal[k] += slopes[Z_Q + 4 * k + j] * out[j] + slopes[Z_V + 4 * k + j] * velocity[j]
        internal[k] /= shift - slopes[Z_Z + k]


@compiled
def _inputs(
    offset: float, v: FloatArray, force: float, rise: FloatArray, squares: FloatArray, load: FloatArray
) -> None:
    """Inputs at `offset` [s] behind the sample at which they are `v` and `force`; `rise` (3,) are their rates."""
    for side in range(2):
        squares[side] = (v[side] + rise[side] * offset) ** 2
    load[0] = force + rise[2] * offset


@compiled
def _time_derivative(
    offset: float, v: FloatArray, rise: FloatArray, p: FloatArray, slopes: FloatArray, f_t: FloatArray
) -> None:
    """M ∂f/∂t of the velocities, by the inputs' rates."""
    lever = p[0] * p[0]
    for i in range(4):
        f_t[4 + i] = 0.0
        for side in range(2):
            f_t[4 + i] -= 2.0 * slopes[R_S + 2 * i + side] * (v[side] + rise[side] * offset) * rise[side]
        if i < 3:
            # ∂q/∂q_m = [l², l³, l⁴, 0]: the force acts on the tip.
            f_t[4 + i] += lever * rise[2]
            lever *= p[0]


@compiled
def _rises(t: FloatArray, v: FloatArray, force: FloatArray, sample: int, rise: FloatArray) -> float:
    """Rates of voltages and force behind a sample, filled into `rise` (3,); interval to the next, 0 at the last."""
    if sample == t.size - 1:
        return 0.0
    interval = t[sample + 1] - t[sample]
    for side in range(2):
        rise[side] = (v[sample + 1, side] - v[sample, side]) / interval
    rise[2] = (force[sample + 1] - force[sample]) / interval
    return float(interval)


@compiled
def _copy(source: FloatArray, target: FloatArray) -> None:
    """An assignment of slices would compile seconds longer, for the message that it could raise."""
    for i in range(STATES):
        target[i] = source[i]


@compiled
def _combine(
    base: FloatArray, weights: FloatArray, over: float, stages: FloatArray, count: int, out: FloatArray
) -> None:
    """Base plus the first `count` stages by their weights / `over`."""
    for i in range(STATES):
        out[i] = base[i]
        for j in range(count):
            out[i] += weights[j] / over * stages[j, i]


@compiled
def _complete(x_new: FloatArray, last: FloatArray, scale: FloatArray) -> float:
    """Stiffly accurate: the last stage completes the solution and is the error estimate; its RMS over the scale."""
    norm = 0.0
    for i in range(STATES):
        x_new[i] += last[i]
        norm += (last[i] / scale[i]) ** 2
    return float(np.sqrt(norm / STATES)) if np.isfinite(norm) else float(np.inf)


class _Work(NamedTuple):
    """What a step is computed in: its stages (6, STATES), then inputs, vectors, matrices and pivots at one of them."""

    stages: FloatArray
    squares: FloatArray
    load: FloatArray
    f: FloatArray
    right: FloatArray
    mass: FloatArray
    factors: FloatArray
    block: FloatArray
    pivots: IntArray


@compiled
def _work() -> _Work:
    return _Work(
        np.empty((6, STATES)), np.empty(2), np.empty(1), np.empty(STATES), np.empty(STATES), np.empty((4, 4)),
        np.empty((4, 4)), np.empty((4, 4)), np.empty((2, 4), np.int64),
    )  # fmt: skip


@compiled(forceinline=True)
def _attempt(
    x: FloatArray, offset: float, h: float, v: FloatArray, force: float, rise: FloatArray, p: FloatArray,
    f_t: FloatArray, mass: FloatArray, slopes: FloatArray, scale: FloatArray, work: _Work, x_new: FloatArray,
) -> float:  # fmt: skip
    """A step of length `h` from x at `offset` behind a sample to `x_new`: its error, infinite where it fails."""
    shift = 1.0 / (_GAMMA * h)
    fine = factorise_stages(shift, mass, slopes, work.block, work.pivots[1])
    for stage in range(6):
        if not fine:
            return np.inf
        _combine(x, _A[stage], 1.0, work.stages, stage, x_new)
        _inputs(offset + _NODES[stage] * h, v, force, rise, work.squares, work.load)
        fine = _rate(x_new, work.squares, work.load, p, work.mass, work.factors, work.pivots[0], work.f)
        for i in range(STATES):
            work.f[i] += _TIME_DERIVATIVE[stage] * h * f_t[i]
        _combine(work.f, _C[stage], h, work.stages, stage, work.right)
        solve_stage(shift, mass, slopes, work.block, work.pivots[1], work.right, work.stages[stage])
    return _complete(x_new, work.stages[5], scale) if fine else np.inf


@compiled(nogil=True)
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
    Cost: a step evaluates `motion` six times and `motion_slopes` once and factorises 4×4 seven times: 4 µs.
    """
    x, x_new, f0, f_t, slopes = x0.copy(), x0.copy(), x0.copy(), np.zeros(STATES), np.empty(SLOPES)
    mass, factors, pivots = np.empty((4, 4)), np.empty((4, 4)), np.empty(4, np.int64)
    squares, load, rise, h_next = np.empty(2), np.empty(1), np.zeros(3), 1e-4
    counts[0], counts[1], work = 0, 0, _work()
    for sample in range(t.size):
        interval, offset = _rises(t, v, force, sample, rise), 0.0
        while offset == 0.0 or offset < interval:
            _inputs(offset, v[sample], force[sample], rise, squares, load)
            fine = _rate(x, squares, load, p, mass, factors, pivots, f0)
            if offset == 0.0:
                _copy(x, states[sample])
                _copy(f0, rates[sample])
                q = ((x[2] * p[0] + x[1]) * p[0] + x[0]) * p[0] * p[0]
                if not fine or not abs(q) < reach:
                    return sample
                if interval == 0.0:
                    break
            elif not fine:
                return sample + 1
            motion_slopes(x, squares, load, p, f0[4:8], slopes)
            _time_derivative(offset, v[sample], rise, p, slopes, f_t)
            solve_factorised(factors, pivots, f_t[4:8])
            norm, remaining = np.inf, interval - offset
            while norm > 1.0:
                h = remaining if h_next >= remaining else min(h_next, 0.5 * remaining)
                norm = _attempt(x, offset, h, v[sample], force[sample], rise, p, f_t, mass, slopes, scale, work, x_new)
                factor = min(5.0, max(0.2, 0.9 * max(norm, 1e-10) ** -0.25))
                if norm > 1.0:
                    counts[1] += 1
                    h_next = factor * h
                    if h_next < 1e-12 * interval:
                        return sample + 1
            counts[0] += 1
            # A step cut short by the sample's end says nothing against the longer one.
            h_next = max(factor * h, h_next) if h == remaining else factor * h
            offset = interval if h == remaining else offset + h
            _copy(x_new, x)
    return t.size
