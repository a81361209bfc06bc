"""Motion of the full-order joint: adaptive steps of RODAS4 (`pipeline.solvers.stiff`), with exact Jacobians."""

from typing import NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.analytical_joint import motion, motion_slopes
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.inner_loops import copy_into, factorise, solve_factorised
from pipeline.solvers.stiff import R_S, RODAS4, STATES, Work, advance, factorise_stages, working

_TIME_DERIVATIVE = np.array([0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0])
"""How much of h ∂f/∂t each stage of RODAS4 takes."""

MOST_TRIES = 20_000
"""Steps between two samples, refused ones too, beyond which a run counts as diverged: a joint takes 2 to 20 in 10 ms;
one that blows up would never end."""


class _Motion(NamedTuple):
    """The joint in a run: parameters p, inputs, where the step starts, and room for what is computed at a state.

    `sample` (1,) and `offset` (1,) say where the step starts, [s] behind a sample; `rise` (3,) are the rates of
    voltages and force there; `f_t` (STATES,) is ∂f/∂t.
    """

    p: FloatArray
    v: FloatArray
    force: FloatArray
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


@compiled(inline="always")
def _motion(p: FloatArray, v: FloatArray, force: FloatArray) -> _Motion:
    return _Motion(
        p, v, force, np.zeros(1, np.int64), np.zeros(1), np.zeros(3), np.zeros(STATES), np.empty(2), np.empty(1),
        np.empty(STATES), np.empty((4, 4)), np.empty((4, 4)), np.empty(4, np.int64),
    )  # fmt: skip


@compiled(inline="always")
def _rate(s: _Motion, x: FloatArray, offset: float, mass: FloatArray, out: FloatArray) -> bool:
    """ẋ (11,) of the state x (11,) at `offset` [s] behind the sample, and M (4, 4); False if that is singular."""
    n = s.sample[0]
    for side in range(2):
        s.squares[side] = (s.v[n, side] + s.rise[side] * offset) ** 2
    s.load[0] = s.force[n] + s.rise[2] * offset
    motion(x, s.squares, s.load, s.p, mass, out)
    for i in range(4):
        for j in range(4):
            s.factors[i, j] = mass[i, j]
    if not factorise(s.factors, s.pivots):
        return False
    solve_factorised(s.factors, s.pivots, out[4:8])
    return True


@compiled(inline="always")
def _time_derivative(s: _Motion, slopes: FloatArray) -> None:
    """∂f/∂t by the inputs' rates where the step starts, whose mass matrix has just been factorised."""
    n, lever = s.sample[0], s.p[0] * s.p[0]
    for i in range(4):
        s.f_t[4 + i] = 0.0
        for side in range(2):
            volts = s.v[n, side] + s.rise[side] * s.offset[0]
            s.f_t[4 + i] -= 2.0 * slopes[R_S + 2 * i + side] * volts * s.rise[side]
        if i < 3:
            # ∂q/∂q_m = [l², l³, l⁴, 0]: the force acts on the tip.
            s.f_t[4 + i] += lever * s.rise[2]
            lever *= s.p[0]
    solve_factorised(s.factors, s.pivots, s.f_t[4:8])


@compiled(inline="always")
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
    """ẋ at a stage, with its share of h ∂f/∂t; the Jacobian is that of the step's start."""
    fine = _rate(s, work.at, s.offset[0] + RODAS4.nodes[stage] * h, s.mass, s.f)
    if stage == 0:
        fine = fine and factorise_stages(1.0 / (RODAS4.gamma * h), work)
    for i in range(STATES):
        work.right[i] = s.f[i] + _TIME_DERIVATIVE[stage] * h * s.f_t[i]
    return fine


@compiled(inline="always")
def _complete(work: Work, scale: FloatArray, x_new: FloatArray) -> float:
    """Stiffly accurate: the last stage completes the solution and is the error estimate; its RMS over the scale."""
    norm = 0.0
    for i in range(STATES):
        last = work.y[5, i]
        x_new[i] = work.at[i] + last
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
        Number of valid samples; N unless the run diverged, which is also what more than `MOST_TRIES` steps between two
        samples count as.

    Notes
    -----
    Cost: a step evaluates `motion` six times and `motion_slopes` once and factorises 4×4 seven times: 4 µs.
    """
    x, x_new, f0, h_next = x0.copy(), np.empty(STATES), np.empty(STATES), 1e-4
    counts[0], counts[1], s, work = 0, 0, _motion(p, v, force), working(6, 1)
    for sample in range(t.size):
        interval, offset, s.sample[0] = _rises(t, v, force, sample, s.rise), 0.0, sample
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
            s.offset[0], norm, remaining = offset, np.inf, interval - offset
            motion_slopes(x, s.squares, s.load, p, f0[4:8], work.slopes)
            _time_derivative(s, work.slopes)
            while norm > 1.0:
                tries += 1
                if tries > MOST_TRIES:
                    return sample + 1
                h = remaining if h_next >= remaining else min(h_next, 0.5 * remaining)
                norm = _complete(work, scale, x_new) if advance(RODAS4, _stage, s, x, h, work, 1) else np.inf
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
            copy_into(x, x_new)
    return t.size
