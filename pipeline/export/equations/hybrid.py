"""The hybrid joint for export: `pipeline.joint.body` between its instruments."""

from typing import NamedTuple

import numpy as np

from pipeline.export.realisation import Kernels, Realisation, Variable
from pipeline.joint import condensed_parameters
from pipeline.joint.body import BRANCHES, CREEPS, STATES, STOPS, advance_stops, body_rates
from pipeline.joint.body_run import rest_state
from pipeline.joint.condensed_problem import DEVIATIONS
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray


class Constants(NamedTuple):
    """Constants of the body; readings of laser and probes; the voltage [V] above which the force is held; the wall."""

    k: FloatArray
    basis: FloatArray
    weights: FloatArray
    probe: FloatArray
    held_above: float
    gain: float
    offset: float
    wall: float


def drive(v: FloatArray, c: Constants, u: FloatArray) -> None:
    """Squared voltages [V²] without the probes' offsets."""
    for i in range(len(c.probe)):
        volts = min(c.held_above, max(-c.held_above, v[i] - c.probe[i]))
        u[i] = volts * volts


def start(q0: float, qdot0: float, u: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """State as after a long rest at the reading q0, moving with qdot0."""
    rest, stops = rest_state((q0 - c.offset) / c.gain, u[0], u[1], c.k, c.basis, c.weights)
    x[:] = rest
    x[1] = qdot0 / c.gain
    z[:] = stops


def begin(x: FloatArray, z: FloatArray, h: float, c: Constants, base: FloatArray) -> None:
    """The state at the start of a step: the stop operators count the play from there."""
    base[:] = x


def rates(x: FloatArray, z: FloatArray, base: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates of the state."""
    body_rates(x, u[0], u[1], z, base, c.k, c.basis, c.weights, dx)


def finish(base: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """The wall that confines the tip, and the stop operators after the step."""
    if abs(x[0]) > c.wall:
        x[0] = c.wall if x[0] > 0.0 else -c.wall
        x[1] = 0.0
    advance_stops(z, base, x, c.k)


def read(x: FloatArray, dx: FloatArray, c: Constants, y: FloatArray) -> None:
    """What the laser shows: q, its velocity and acceleration."""
    y[0] = c.gain * x[0] + c.offset
    y[1] = c.gain * x[1]
    y[2] = c.gain * dx[1]


def inside(x: FloatArray, c: Constants) -> bool:
    """The wall confines every run, so only a number that is none lies outside."""
    return bool(np.isfinite(x[0]))


_KERNELS = Kernels(drive, start, begin, rates, finish, rates, read, inside)


def realise(model: HybridModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run."""
    seen, body = condensed_parameters.instruments(model.theta[:DEVIATIONS]), model.body
    k = body.constants(model.theta)
    constants = Constants(
        k=k,
        basis=body.basis,
        weights=body.weights(model.theta),
        probe=seen.probe,
        held_above=2.0 * body.largest_voltage,
        gain=float(seen.gain),
        offset=float(seen.offset),
        wall=float(body.q_stop),
    )
    return Realisation(
        kernels=_KERNELS,
        constants=constants,
        inputs=2,
        states=_states(),
        memories=tuple(Variable(f"stop_{i}", "1", f"stop operator {i}, share of its force") for i in range(STOPS)),
        base=STATES,
        step=interval / body.substeps(model.theta, interval),
        delay=float(seen.delay),
        spline=True,
        structure=str(model.describe()["structure"]),
    )


def _states() -> tuple[Variable, ...]:
    strains = [
        Variable(f"strain_{side}_{i}", "1", f"strain of Maxwell element {i} of the {side} membrane", 0.1)
        for i in range(BRANCHES)
        for side in ("left", "right")
    ]
    return (
        Variable("tip", "m", "displacement of the tip, without the laser's gain and offset", 0.01),
        Variable("tip_speed", "m/s", "its velocity", 0.1),
        Variable("slope", "1", "slope of the beam at the tip", 0.1),
        Variable("slope_rate", "1/s", "its rate", 10.0),
        Variable("bubble", "1", "bubble shape of the beam", 0.1),
        *strains,
        *(Variable(f"creep_{i}", "m", f"displacement of creep element {i}", 0.01) for i in range(CREEPS)),
    )
