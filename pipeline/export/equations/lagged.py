"""The model of the paper's § 4.2 for export: RBF curves and a lagged velocity."""

from typing import NamedTuple

import numpy as np

from pipeline.export.realisation import Kernels, Realisation, Variable
from pipeline.models.rbf_paper import RbfPaperModel
from pipeline.numerics.arrays import FloatArray
from pipeline.solvers.lagged_free_run import escape_bounds, lagged_rbf_acceleration, steps_per_sample


class Constants(NamedTuple):
    """Basis, weights per unit mass (M, 2 + K), time constant and bounds."""

    centres: FloatArray
    weights: FloatArray
    bend: float
    lag: float
    low: float
    high: float
    squared: int
    inputs: int


def drive(v: FloatArray, c: Constants, u: FloatArray) -> None:
    """Voltages, squared where the force goes with their square."""
    for i in range(c.inputs):
        volts = v[i]
        if c.squared:
            volts = volts * volts
        u[i] = volts


def start(q0: float, qdot0: float, u: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """The lagged velocity starts as the velocity."""
    x[0] = q0
    x[1] = qdot0
    x[2] = qdot0


def begin(x: FloatArray, z: FloatArray, h: float, c: Constants, base: FloatArray) -> None:
    """Nothing holds during a step."""
    base[0] = 0.0


def rates(x: FloatArray, z: FloatArray, base: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates of displacement, velocity and lagged velocity (eq. 37)."""
    values = np.zeros(2 + c.inputs)
    dx[0] = x[1]
    dx[1] = lagged_rbf_acceleration(x[0], x[2], u, c.centres, c.weights, c.bend, values)
    dx[2] = (x[1] - x[2]) / c.lag


def finish(base: FloatArray, c: Constants, x: FloatArray, z: FloatArray) -> None:
    """Nothing changes only from step to step."""


def read(x: FloatArray, dx: FloatArray, c: Constants, y: FloatArray) -> None:
    """Displacement, velocity, acceleration."""
    y[0] = x[0]
    y[1] = x[1]
    y[2] = dx[1]


def inside(x: FloatArray, c: Constants) -> bool:
    """Within two operating ranges of the training data."""
    return bool(c.low <= x[0] <= c.high and np.isfinite(x[1]) and np.isfinite(x[2]))


_KERNELS = Kernels(drive, start, begin, rates, finish, rates, read, inside)


def realise(model: RbfPaperModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run; `unit` is that of q."""
    inputs = len(model.weights) - 2
    low, high = escape_bounds(float(model.centres[0]), float(model.centres[-1]))
    constants = Constants(
        centres=model.centres,
        weights=np.ascontiguousarray(model.weights.T) / model.mass,
        bend=0.5 / model.width**2,
        lag=model.lag,
        low=low,
        high=high,
        squared=int(model.inputs == "squared"),
        inputs=inputs,
    )
    return Realisation(
        kernels=_KERNELS,
        constants=constants,
        inputs=inputs,
        states=(
            Variable("displacement", unit, "displacement", 0.01),
            Variable("velocity", f"{unit}/s", "its velocity", 0.1),
            Variable("lagged_velocity", f"{unit}/s", "velocity that the friction feels", 0.1),
        ),
        memories=(),
        base=1,
        step=interval / steps_per_sample(interval, model.lag),
        delay=0.0,
        spline=False,
        structure=str(model.describe()["structure"]),
    )
