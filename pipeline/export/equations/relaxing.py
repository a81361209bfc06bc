"""The data-driven joint for export: `pipeline.identification.relaxing_joint` in its own dimensionless numbers.

The right side stands here once more without sensitivities: there it is fused with them, because apart it costs the
identification a fifth of its time. A test holds the two together.
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from pipeline.export.realisation import Kernels, Realisation, Variable
from pipeline.identification.joint_problem import steps_per_sample
from pipeline.identification.relaxing_joint import (
    DAMPING,
    ESCAPE,
    FORCE,
    INPUT,
    POLYNOMIALS,
    Coefficients,
    basis_at,
)
from pipeline.models.rbf import RbfModel
from pipeline.numerics.arrays import FloatArray


class Constants(NamedTuple):
    """The joint, and what lies between it and the measured signals."""

    joint: Coefficients
    middle: float
    half: float
    volts: float
    squared: int
    offset: FloatArray
    lagged: int
    lag: float
    rest_at_zero: int


def drive(v: FloatArray, c: Constants, u: FloatArray) -> None:
    """Voltages over the largest trained one."""
    for i in range(len(c.offset)):
        u[i] = v[i] / c.volts


def acting(u: FloatArray, c: Constants, f: FloatArray) -> None:
    """Inputs of the equation of motion from those behind their lag: freed of their offset, squared."""
    for i in range(len(c.offset)):
        volts = u[i] - c.offset[i]
        if c.squared:
            volts = volts * volts
        f[i] = volts


def lagged_after(h: float, lagged: float, before: float, after: float, lag: float) -> float:
    """Lagged input after h [s] in which the input goes on a line, exactly (`numerics.identification.lag`)."""
    ratio = h / lag
    share = 1.0
    if ratio > 0.0:
        share = -float(np.expm1(-ratio)) / ratio
    kept = float(np.exp(-ratio))
    return kept * lagged + (share - kept) * before + (1.0 - share) * after


def lag(before: FloatArray, within: FloatArray, after: FloatArray, h: float, c: Constants, x: FloatArray) -> None:
    """Inputs at the nodes of a step behind their lag; a lag may be far shorter than the step."""
    first = 2 + len(c.joint.rates) + len(c.joint.slip_force)
    for i in range(len(c.offset)):
        at_start = x[first + i]
        at_middle = lagged_after(0.5 * h, at_start, before[i], within[i], c.lag)
        x[first + i] = lagged_after(0.5 * h, at_middle, within[i], after[i], c.lag)
        before[i] = at_start
        within[i] = at_middle
        after[i] = x[first + i]


def curves_at(x: float, c: Constants, values: FloatArray) -> None:
    """All curves at x."""
    basis, slopes = np.zeros(POLYNOMIALS + len(c.joint.centres)), np.zeros(POLYNOMIALS + len(c.joint.centres))
    basis_at(x, c.joint, basis, slopes)
    for i in range(c.joint.curves.shape[0]):
        value = 0.0
        for j in range(c.joint.curves.shape[1]):
            value += c.joint.curves[i, j] * basis[j]
        values[i] = value


def joint_rates(x: FloatArray, slip: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates of the displacement, its velocity and the relaxing elements under the inputs u behind their lag."""
    inputs, elements, slips = len(c.offset), len(c.joint.rates), len(c.joint.slip_force)
    values, f = np.zeros(c.joint.curves.shape[0]), np.zeros(len(c.offset))
    curves_at(x[0], c, values)
    acting(u, c, f)
    p = x[1]
    arm = x[0] - c.joint.inertia[1]
    total = values[FORCE] - values[DAMPING] * p - c.joint.inertia[0] * arm * p * p
    for n in range(inputs):
        total += values[INPUT + n] * f[n]
    for n in range(elements):
        total -= values[INPUT + inputs + n] * x[2 + n]
    for n in range(slips):
        total -= c.joint.slip_force[n] * slip[n]
    dx[0] = p
    dx[1] = total / (1.0 + c.joint.inertia[0] * arm * arm)
    for n in range(elements):
        change = values[INPUT + inputs + n] * p - c.joint.rates[n] * x[2 + n]
        for i in range(inputs):
            change += c.joint.coupling[n, i] * f[i]
        dx[2 + n] = change


def start(q0: float, qdot0: float, u: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """State as after a long rest under the inputs u or none, moving with qdot0."""
    elements, slips = len(c.joint.rates), len(c.joint.slip_force)
    rested, f = np.zeros(len(c.offset)), np.zeros(len(c.offset))
    x[0] = (q0 - c.middle) / c.half
    x[1] = qdot0 / c.half
    for i in range(len(c.offset)):
        if not c.rest_at_zero:
            rested[i] = u[i]
    if c.lagged:
        for i in range(len(c.offset)):
            x[2 + elements + slips + i] = rested[i]
    acting(rested, c, f)
    for n in range(elements):
        x[2 + n] = 0.0
        for i in range(len(c.offset)):
            x[2 + n] += c.joint.coupling[n, i] * f[i] / c.joint.rates[n]
    for n in range(slips):
        x[2 + elements + n] = 0.0


def slid(slip: float, travel: float, length: float) -> float:
    """Dahl state after a monotonous travel, exactly: it tends to ±1 exponentially in the distance."""
    side = 1.0 if travel >= 0.0 else -1.0
    return side + (slip - side) * float(np.exp(-abs(travel) / length))


def begin(x: FloatArray, z: FloatArray, h: float, c: Constants, base: FloatArray) -> None:
    """Friction states at the middle of the step, and where the step starts."""
    elements, slips = len(c.joint.rates), len(c.joint.slip_force)
    for n in range(slips):
        base[n] = slid(x[2 + elements + n], 0.5 * h * x[1], c.joint.slip_length[n])
    base[slips] = x[0]


def rates(x: FloatArray, z: FloatArray, base: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates within a step: friction holds its middle value, and `lag` has moved the lagged inputs."""
    elements = len(c.joint.rates)
    joint_rates(x, base, u, c, dx)
    for n in range(2 + elements, len(x)):
        dx[n] = 0.0


def finish(base: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """Friction states after the distance of the step."""
    elements, slips = len(c.joint.rates), len(c.joint.slip_force)
    for n in range(slips):
        x[2 + elements + n] = slid(x[2 + elements + n], x[0] - base[slips], c.joint.slip_length[n])


def flow(x: FloatArray, z: FloatArray, base: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates of all states, friction as Dahl's differential equation."""
    elements, slips = len(c.joint.rates), len(c.joint.slip_force)
    slip, acts = np.zeros(len(c.joint.slip_force) + 1), np.zeros(len(c.offset))
    for n in range(slips):
        slip[n] = x[2 + elements + n]
    for i in range(len(c.offset)):
        acts[i] = u[i]
        if c.lagged:
            acts[i] = x[2 + elements + slips + i]
            dx[2 + elements + slips + i] = (u[i] - acts[i]) / c.lag
    joint_rates(x, slip, acts, c, dx)
    for n in range(slips):
        dx[2 + elements + n] = (x[1] - abs(x[1]) * slip[n]) / c.joint.slip_length[n]


def read(x: FloatArray, dx: FloatArray, c: Constants, y: FloatArray) -> None:
    """Measured q, its velocity and acceleration."""
    y[0] = c.middle + c.half * x[0]
    y[1] = c.half * x[1]
    y[2] = c.half * dx[1]


def inside(x: FloatArray, c: Constants) -> bool:
    """Within two operating ranges of the training data."""
    return bool(abs(x[0]) < ESCAPE and np.isfinite(x[1]))


_KERNELS = Kernels(drive, start, begin, rates, finish, flow, read, inside)


def realise(model: RbfModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run."""
    p, s = model.parameters, model.parameters.scales
    coefficients: Coefficients = p.coefficients(model.theta)
    offset = model.theta[p.slices["input_offset"]]
    log_lag = model.theta[p.slices["input_lag"]]
    log_delay = model.theta[p.slices["input_delay"]]
    inputs = len(p.signs)
    constants = Constants(
        joint=coefficients,
        middle=s.middle,
        half=s.half,
        volts=s.volts,
        squared=int(p.law == "squared"),
        offset=offset if len(offset) else np.zeros(inputs),
        lagged=int(p.structure.input_lag),
        lag=float(np.exp(log_lag[0])) if len(log_lag) else 0.0,
        rest_at_zero=int(p.structure.rest_at_zero),
    )
    lagged = range(inputs) if p.structure.input_lag else ()
    return Realisation(
        kernels=replace(_KERNELS, lag=lag) if p.structure.input_lag else _KERNELS,
        constants=constants,
        inputs=inputs,
        states=(
            Variable("x", "1", "displacement from the middle of the operating range over half of it"),
            Variable("p", "1/s", "its rate", 10.0),
            *(Variable(f"w_{i}", "1/s", f"relaxing element {i}") for i in range(len(coefficients.rates))),
            *(Variable(f"s_{i}", "1", f"Dahl friction state {i}") for i in range(len(coefficients.slip_force))),
            *(Variable(f"input_{i}", "1", f"lagged input {i + 1} over the largest trained one") for i in lagged),
        ),
        memories=(),
        base=len(coefficients.slip_force) + 1,
        step=interval / steps_per_sample(p, interval, model.theta),
        delay=float(np.exp(log_delay[0])) if len(log_delay) else 0.0,
        spline=p.structure.hold == "cubic",
        structure=str(model.describe()["structure"]),
    )
