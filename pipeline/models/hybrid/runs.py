"""Runs of the condensed joint: free, or coupled to a measurement by an observer.

One joint runs alone; many run `BATCH` at a time, side by side in vector registers. The steps are those of
`pipeline.numerics.fixed_step`; stop operators are exact in them.
"""

# mypy: disable-error-code="no-untyped-def"

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ...codegen.numba_writer import kernel
from ...generated.condensed_joint import RATES, STATES, STOP_MOVE, STOPS
from ...numerics.arrays import FloatArray, IntArray
from ...numerics.fixed_step import SHARES, Methods, inlined, integrator, workspace
from .kernels import VALUES, corrections_at, prepare
from .statics import rest_at_reading

BATCH = 8
"""Joints side by side."""
_RATES = {1: kernel(RATES), BATCH: kernel(RATES, BATCH)}
_STOP_MOVE = {1: kernel(STOP_MOVE), BATCH: kernel(STOP_MOVE, BATCH)}


class Joints(NamedTuple):
    """One joint in a run, or `BATCH` side by side: W joints, numbers of each entry of all joints in a row.

    Attributes
    ----------
    slots : tuple of W zeros
        Its length makes W known to the compiler.
    p : FloatArray, shape (PREPARED · W,)
        Prepared constants.
    c, own, z, start, u, now : FloatArray, shapes (VALUES · W,), (VALUES,), (STOPS · W,), (3 W,), (2 W,), (3,)
        Filled in a run: corrections of all joints and of one, stop operators, (q, τ, β) at the start of the step,
        squared voltages [V²]; half step and observer pole of the step, and its stage.
    squares : FloatArray, shape (V, H, 2)
        Squared voltages [V²] on the H half steps, as V different sets of instruments show them.
    variant : IntArray, shape (W,)
        Index of the set that drives each joint.
    basis, weights : FloatArray, shapes (3,) and (W, CURVES, M)
        Of the corrections, see `pipeline.models.hybrid.kernels.corrections_at`.
    offset : FloatArray, shape (W,)
        Of the laser [m]: reading = q + offset.
    observed, pole : FloatArray, shapes (H,) and (H,)
        Reading [m] that an observer follows and its pole L [1/s]; both (0,) in a free run.
    wall, lead : float
        Displacement [m] that confines the runs; dτ/dq [1/m] of slow motions.
    reading : (float, float)
        See `Stepping`.
    points, slips : FloatArray, shapes (steps + 1, 4, STATES) and (steps + 1, STOPS)
        Filled in a run of one joint: states at all stages, and stop operators where steps begin. Empty in other runs.
    """

    slots: tuple[int, ...]
    p: FloatArray
    c: FloatArray
    own: FloatArray
    z: FloatArray
    start: FloatArray
    u: FloatArray
    now: FloatArray
    squares: FloatArray
    variant: IntArray
    basis: FloatArray
    weights: FloatArray
    offset: FloatArray
    observed: FloatArray
    pole: FloatArray
    wall: float
    lead: float
    reading: tuple[float, float]
    points: FloatArray = np.zeros((0, len(SHARES), STATES))
    slips: FloatArray = np.zeros((0, STOPS))


@inlined
def observer(error: float, pole: float, lead: float) -> tuple[float, float, float, float]:
    """Terms of an observer in the rates of q, q̇, τ and τ̇ when q is `error` [m] behind the reading.

    It pulls along the slow motion of the beam, (q, τ) together: q̇ += 2L e, q̈ += L² e, L being its `pole` [1/s], and
    the same times dτ/dq = `lead` [1/m] for τ. An observer that pulls at q alone has a growing mode of q and τ near the
    separatrix, with rates up to 3 1/s. Even the true joint then drifts off its own measurement. It is linear in
    `error`.
    """
    velocity = 2.0 * pole * error
    acceleration = pole * pole * error
    return velocity, acceleration, lead * velocity, lead * acceleration


def _reading(system, x, j, width):
    """Reading of a joint, and its rate."""
    by_q, by_tau = system.reading
    return by_q * x[j] + by_tau * x[2 * width + j], by_q * x[width + j] + by_tau * x[3 * width + j]


def _methods(system: Any) -> Methods:
    """Methods of W joints, for the compiler.

    Each of them is written out. A function that takes `system` counts references of its arrays at each call, which took
    the free run of one joint from 5 to 8 ms.
    """
    w = len(system.types[0])
    equations = _RATES[w]
    stop_move = _STOP_MOVE[w]

    def begin(system, x, node):
        """Start of the step, from which the stop operators count the play."""
        for j in range(w):
            system.start[j], system.start[w + j], system.start[2 * w + j] = x[j], x[2 * w + j], x[4 * w + j]
        system.now[0], system.now[2] = node, 0.0
        if w == 1 and len(system.slips) > 0:
            for i in range(STOPS):
                system.slips[node // 2, i] = system.z[i]
        system.now[1] = system.pole[node] if len(system.pole) > 0 else 0.0

    def rates(system, x, node, dx, acceleration):
        """State equation with the corrections at q, and the terms of the observer."""
        if w == 1 and len(system.points) > 0:
            step = int(system.now[0]) // 2
            stage = int(system.now[2])
            for i in range(STATES):
                system.points[step, stage, i] = x[i]
            system.now[2] += 1.0
        for j in range(w):
            system.u[j] = system.squares[system.variant[j], node, 0]
            system.u[w + j] = system.squares[system.variant[j], node, 1]
        if system.weights.shape[2] > 0:
            for j in range(w):
                corrections_at(x[j], system.basis, system.weights[j], system.own)
                for i in range(VALUES):
                    system.c[i * w + j] = system.own[i]
        equations((x, system.u, system.c, system.z, system.start, system.p, dx))
        by_q, by_tau = system.reading
        for j in range(w):
            acceleration[j] = by_q * dx[w + j] + by_tau * dx[3 * w + j]
        pole = system.now[1]
        if pole > 0.0:
            for j in range(w):
                error = system.observed[node] - system.offset[j] - (by_q * x[j] + by_tau * x[2 * w + j])
                q, speed, tau, turning = observer(error, pole, system.lead)
                dx[j] += q
                dx[w + j] += speed
                dx[2 * w + j] += tau
                dx[3 * w + j] += turning

    def finish(system, x):
        """The wall holds the tip, and the stop operators move."""
        for j in range(w):
            if abs(x[j]) > system.wall:
                x[j] = system.wall if x[j] > 0.0 else -system.wall
                x[w + j] = 0.0
        stop_move((x, system.z, system.start, system.p, system.z))

    return Methods(begin, rates, finish, _reading)


integrate_joints = integrator(Joints, _methods)


class JointCoefficients(NamedTuple):
    """Constants and corrections of B joints.

    Attributes
    ----------
    constants : FloatArray, shape (B, len(CONSTANTS))
    weights : FloatArray, shape (B, 9, M)
        Of the corrections.
    basis : FloatArray, shape (3,)
        See `pipeline.models.hybrid.kernels.corrections_at`.
    """

    constants: FloatArray
    weights: FloatArray
    basis: FloatArray


class Driving(NamedTuple):
    """Voltages and lasers of B joints, and how their runs start.

    Attributes
    ----------
    squares : FloatArray, shape (V, 2 substeps (N−1) + 1, 2)
        Squared voltages [V²] on the half steps, as V different sets of instruments show them.
    variant : IntArray, shape (B,)
        Index of the set that drives each joint.
    offset : FloatArray, shape (B,)
        Of each joint's laser [m]: reading = q + offset.
    start : FloatArray, shape (3,) or (B, 3)
        Reading [m] and its rate [m/s] at the first sample, and the time [s] since the recording began, of all joints or
        of each.
    """

    squares: FloatArray
    variant: IntArray
    offset: FloatArray
    start: FloatArray


class Followed(NamedTuple):
    """Measurement that an `observer` follows.

    Attributes
    ----------
    reading : FloatArray, shape (2 substeps (N−1) + 1,) or (0,)
        Reading [m] on the half steps.
    pole : FloatArray, shape (N,)
        Observer pole L [1/s] in each sample interval; 0 is a free run.
    """

    reading: FloatArray
    pole: FloatArray


class Stepping(NamedTuple):
    """Steps of a run, and the numbers that all its joints share.

    Attributes
    ----------
    dt, substeps : float, int
        Sample interval [s] and Runge-Kutta steps in it.
    wall : float
        Displacement [m] of the wall that confines every run.
    lead : float
        dτ/dq [1/m] of slow motions.
    reading : (float, float)
        Weights of q [1] and τ [m] in the reading [m]: q alone, or τ alone where the angle was measured.
    """

    dt: float
    substeps: int
    wall: float
    lead: float
    reading: tuple[float, float] = (1.0, 0.0)


def run_joints(
    coefficients: JointCoefficients,
    driving: Driving,
    followed: Followed,
    stepping: Stepping,
    *,
    every_step: bool = False,
) -> FloatArray:
    """Simulate joints from rest, freely or held near a measured displacement by an `observer`.

    Parameters
    ----------
    coefficients, driving, followed, stepping
        The joints, their voltages, the measurement, the steps.
    every_step : bool
        Return every Runge-Kutta step, not the samples alone.

    Returns
    -------
    FloatArray, shape (B, N, 3) or (B, substeps (N−1) + 1, 3)
        q, q̇, q̈ as the laser reads them; NaN from the sample on at which the state is no longer finite.
        Cost: 37.5 s at 5 ms take 3 ms for one joint and 5 ms for eight.
    """
    constants, weights, basis = coefficients
    count = len(constants)
    samples = len(followed.pole)
    substeps = stepping.substeps
    shown, parts = (substeps * (samples - 1) + 1, 1) if every_step else (samples, substeps)
    prepared = prepare(constants)
    poles = np.repeat(followed.pole, 2 * substeps) if np.any(followed.pole > 0.0) else np.zeros(0)
    out = np.empty((count, shown, 3))
    width = 1 if count == 1 else BATCH
    for first in range(0, count, width):
        chosen = np.minimum(np.arange(first, first + width), count - 1)
        x, z = _at_rest(coefficients, prepared, driving, stepping, chosen)
        shown_states = np.empty((shown, 3, width))
        system = Joints(
            slots=(0,) * width,
            p=_rows(prepared[chosen]),
            c=np.zeros(VALUES * width),
            own=np.zeros(VALUES),
            z=z,
            start=np.zeros(3 * width),
            u=np.zeros(2 * width),
            now=np.zeros(3),
            squares=driving.squares,
            variant=driving.variant[chosen],
            basis=basis,
            weights=weights[chosen],
            offset=driving.offset[chosen],
            observed=followed.reading,
            pole=poles,
            wall=stepping.wall,
            lead=stepping.lead,
            reading=stepping.reading,
        )
        integrate_joints(system, x, shown_states, workspace(x), parts, stepping.dt / substeps, -np.inf, np.inf)
        out[first : first + width] = shown_states.transpose(2, 0, 1)[: count - first]
    if not np.isfinite(out.sum()):
        out[np.logical_or.accumulate(~np.isfinite(out).all(axis=2), axis=1)] = np.nan
    out[:, :, 0] += driving.offset[:, None]
    return out


def continued_runs(
    coefficients: JointCoefficients,
    driving: Driving,
    followed: Followed,
    stepping: Stepping,
    starts: IntArray,
    ahead: IntArray,
) -> Iterator[FloatArray]:
    """Free runs of one joint from samples up to which an `observer` has held it near a measurement.

    Parameters
    ----------
    coefficients, driving, followed, stepping
        As in `run_joints`, of one joint.
    starts, ahead : IntArray, shape (S,)
        Rising samples, and how many each run goes on.

    Yields
    ------
    FloatArray, shape (ahead + 1,)
        q [m] as the laser reads it.
        Cost: a run to the last start, and the runs themselves, with 30 µs for each call.
    """
    prepared = prepare(coefficients.constants)
    only = np.zeros(1, dtype=np.int64)
    none = np.zeros(0)
    parts = 2 * stepping.substeps
    poles = np.repeat(followed.pole, parts)
    x, z = _at_rest(coefficients, prepared, driving, stepping, only)
    work = workspace(x)

    def moved(x: FloatArray, z: FloatArray, first: int, count: int, *, held: bool) -> FloatArray:
        """The next samples of q; x and z become those of the last."""
        nodes = slice(parts * first, parts * (first + count) + 1)
        out = np.empty((count + 1, 3, 1))
        system = Joints(
            slots=(0,),
            p=prepared[0],
            c=np.zeros(VALUES),
            own=np.zeros(VALUES),
            z=z,
            start=np.zeros(3),
            u=np.zeros(2),
            now=np.zeros(3),
            squares=driving.squares[:, nodes],
            variant=only,
            basis=coefficients.basis,
            weights=coefficients.weights,
            offset=driving.offset,
            observed=followed.reading[nodes] if held else none,
            pole=poles[nodes] if held else none,
            wall=stepping.wall,
            lead=stepping.lead,
            reading=stepping.reading,
        )
        integrate_joints(system, x, out, work, stepping.substeps, stepping.dt / stepping.substeps, -np.inf, np.inf)
        return np.asarray(out[:, 0, 0] + driving.offset)

    at = 0
    for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
        moved(x, z, at, start - at, held=True)
        at = start
        yield moved(x.copy(), z.copy(), start, count, held=False)


def _rows(values: FloatArray) -> FloatArray:
    """Numbers of W joints, (W, n), entry by entry: (n · W,)."""
    return np.ascontiguousarray(values.T).ravel()


def _at_rest(
    coefficients: JointCoefficients,
    prepared: FloatArray,
    driving: Driving,
    stepping: Stepping,
    chosen: IntArray,
) -> tuple[FloatArray, FloatArray]:
    """States and stop operators of the chosen joints at rest at the first sample, in rows."""
    x = np.empty((len(chosen), STATES))
    z = np.empty((len(chosen), STOPS))
    starts = np.broadcast_to(driving.start, (len(prepared), 3))
    for j, i in enumerate(chosen):
        reading, rate, age = starts[i]
        x[j], z[j] = rest_at_reading(
            reading - driving.offset[i],
            stepping.reading,
            driving.squares[driving.variant[i], 0],
            coefficients.constants[i],
            prepared[i],
            coefficients.basis,
            coefficients.weights[i],
            age,
        )
        x[j, 1] = rate
        x[j, 3] = stepping.reading[1] * stepping.lead**2 * rate
    return _rows(x), _rows(z)
