"""Motion of the full-order joint: adaptive steps of RODAS4 (`pipeline.solvers.stiff`), with exact Jacobians."""

from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.analytical_joint import motion, motion_slopes
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.small_linear import factorise, solve_factorised
from pipeline.solvers.stiff import R_S, RODAS4, STATES, Work, advance, factorise_stages, working

_TIME_DERIVATIVE = np.array([0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0])
"""How much of h ∂f/∂t each stage of RODAS4 takes."""


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


class _Motion(NamedTuple):
    """The joint in a step: parameters, voltages, force and their rates at a sample, M ∂f/∂t, room for one stage's."""

    p: FloatArray
    v: FloatArray
    force: float
    rise: FloatArray
    offset: FloatArray
    f_t: FloatArray
    squares: FloatArray
    load: FloatArray
    x: FloatArray
    f: FloatArray
    mass: FloatArray
    factors: FloatArray
    pivots: IntArray


@compiled(forceinline=True)
def _stage(system: _Motion, stage: int, h: float, work: Work) -> bool:
    """ẋ at a stage, with its share of h ∂f/∂t; the Jacobian is that of the step's start."""
    s = system
    for i in range(STATES):
        s.x[i] = work.at[i, 0]
    _inputs(s.offset[0] + RODAS4.nodes[stage] * h, s.v, s.force, s.rise, s.squares, s.load)
    fine = _rate(s.x, s.squares, s.load, s.p, s.mass, s.factors, s.pivots, s.f)
    if stage == 0:
        fine = fine and factorise_stages(1.0 / (RODAS4.gamma * h), work)
    for i in range(STATES):
        work.right[i, 0] = s.f[i] + _TIME_DERIVATIVE[stage] * h * s.f_t[i]
    return fine


@compiled
def _complete(work: Work, scale: FloatArray, x_new: FloatArray) -> float:
    """Stiffly accurate: the last stage completes the solution and is the error estimate; its RMS over the scale."""
    norm = 0.0
    for i in range(STATES):
        last = work.y[5, i, 0]
        x_new[i, 0] = work.at[i, 0] + last
        norm += (last / scale[i]) ** 2
    return float(np.sqrt(norm / STATES)) if np.isfinite(norm) else float(np.inf)


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
    x, x_new, state, f0, f_t = (
        np.empty((STATES, 1)),
        np.empty((STATES, 1)),
        x0.copy(),
        np.empty(STATES),
        np.zeros(STATES),
    )
    work, at, own, own_mass, begun = working(6, 1), np.empty(STATES), np.empty(STATES), np.empty((4, 4)), np.zeros(1)
    factors, pivots, squares, load = np.empty((4, 4)), np.empty(4, np.int64), np.empty(2), np.empty(1)
    rise, h_next = np.zeros(3), 1e-4
    counts[0], counts[1] = 0, 0
    for sample in range(t.size):
        interval, offset = _rises(t, v, force, sample, rise), 0.0
        motion_here = _Motion(
            p, v[sample], force[sample], rise, begun, f_t, squares, load, at, own, own_mass, factors, pivots
        )
        while offset == 0.0 or offset < interval:
            _inputs(offset, v[sample], force[sample], rise, squares, load)
            fine = _rate(state, squares, load, p, work.mass, factors, pivots, f0)
            if offset == 0.0:
                _copy(state, states[sample])
                _copy(f0, rates[sample])
                q = ((state[2] * p[0] + state[1]) * p[0] + state[0]) * p[0] * p[0]
                if not fine or not abs(q) < reach:
                    return sample
                if interval == 0.0:
                    break
            elif not fine:
                return sample + 1
            motion_slopes(state, squares, load, p, f0[4:8], work.slopes)
            _time_derivative(offset, v[sample], rise, p, work.slopes, f_t)
            solve_factorised(factors, pivots, f_t[4:8])
            norm, remaining, begun[0] = np.inf, interval - offset, offset
            for i in range(STATES):
                x[i, 0] = state[i]
            while norm > 1.0:
                h = remaining if h_next >= remaining else min(h_next, 0.5 * remaining)
                norm = _complete(work, scale, x_new) if advance(RODAS4, _stage, motion_here, x, h, work, 1) else np.inf
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
            for i in range(STATES):
                state[i] = x_new[i, 0]
    return t.size
