"""SINDy's sparse polynomial equations for export."""

from typing import NamedTuple

import numpy as np

from pipeline.baselines.polynomial_dynamics import (
    COSINE,
    FIRST_INPUT,
    FRICTION,
    LAG,
    QDOT,
    SINE,
    Q,
    polynomial_rates,
)
from pipeline.export.equations.lagged import begin, finish, read, start
from pipeline.export.realisation import Kernels, Realisation, Variable
from pipeline.models.sindy import SindyModel
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.solvers.lagged_free_run import steps_per_sample


class Constants(NamedTuple):
    """Table of monomials, its coefficients, scales of the variables, time constant and bounds."""

    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    lag: float
    lagged: int
    low: float
    high: float
    squared: int


def drive(v: FloatArray, c: Constants, u: FloatArray) -> None:
    """Voltages, squared where the force goes with their square, over their scale."""
    for i in range(len(c.scales) - FIRST_INPUT):
        volts = v[i]
        if c.squared:
            volts = volts * volts
        u[i] = volts / c.scales[FIRST_INPUT + i]


def rates(x: FloatArray, z: FloatArray, base: FloatArray, u: FloatArray, c: Constants, dx: FloatArray) -> None:
    """Rates of displacement, velocity and lagged velocity."""
    scaled, found = np.zeros(len(c.scales)), np.zeros(2)
    scaled[Q] = x[0] / c.scales[Q]
    scaled[QDOT] = x[1] / c.scales[QDOT]
    scaled[LAG] = x[2] / c.scales[LAG]
    scaled[FRICTION] = np.tanh(x[1] / c.scales[FRICTION])
    scaled[SINE] = np.sin(x[0])
    scaled[COSINE] = np.cos(x[0])
    for i in range(len(c.scales) - FIRST_INPUT):
        scaled[FIRST_INPUT + i] = u[i]
    polynomial_rates(c.exponents, c.coefficients, scaled, found)
    dx[0] = found[0]
    dx[1] = found[1]
    dx[2] = 0.0
    if c.lagged:
        dx[2] = (x[1] - x[2]) / c.lag


def inside(x: FloatArray, c: Constants) -> bool:
    """Within two operating ranges of the training data."""
    return bool(c.low <= x[0] <= c.high and np.isfinite(x[1]))


_KERNELS = Kernels(drive, start, begin, rates, finish, rates, read, inside)


def realise(model: SindyModel, interval: float, unit: str = "m") -> Realisation:
    """The model for export, at the sample interval [s] of its run; `unit` is that of q."""
    d = model.dynamics
    lagged = d.lag_time > 0.0
    constants = Constants(
        exponents=d.exponents,
        coefficients=d.coefficients,
        scales=d.scales,
        lag=d.lag_time,
        lagged=int(lagged),
        low=d.low,
        high=d.high,
        squared=int(d.squared),
    )
    return Realisation(
        kernels=_KERNELS,
        constants=constants,
        inputs=d.scales.size - FIRST_INPUT,
        states=(
            Variable("displacement", unit, "displacement", 0.01),
            Variable("velocity", f"{unit}/s", "its velocity", 0.1),
            Variable(
                "lagged_velocity", f"{unit}/s", "velocity that a friction term feels; constant where there is none", 0.1
            ),
        ),
        memories=(),
        base=1,
        step=interval / steps_per_sample(interval, d.lag_time if lagged else np.inf),
        delay=0.0,
        spline=False,
        structure="; ".join(model.equations()),
    )
