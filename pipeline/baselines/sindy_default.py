"""SINDy as pysindy comes: default library, optimiser and differentiation, nothing fixed and nothing tuned."""

import importlib
from collections.abc import Sequence

import numpy as np

from pipeline.baselines.polynomial_dynamics import FIRST_INPUT, QDOT, PolynomialDynamics, Q
from pipeline.baselines.weak_form import seeded
from pipeline.errors import InputError
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.free_run import escape_bounds

MILLI, KILO = 1e-3, 1e3


def fit_default_sindy(
    trajectories: Sequence[Trajectory], *, squared: bool = True, units: tuple[float, float] = (MILLI, KILO)
) -> PolynomialDynamics:
    """``pysindy.SINDy().fit(x, t=…, u=…)`` with x = [q, q̇] and u = v² (or v), everything else left alone.

    The defaults are second-degree polynomials, STLSQ with a threshold of 0.1 on raw coefficients and second-order
    finite differences; both equations are regressed, so q̇ = v is not guaranteed. The threshold makes the result
    depend on the units, so those of the log are taken, which is what its owner would fit. In SI all input terms of a
    rig in mm and kV would fall below the threshold at once.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches; velocities are used, accelerations are not.
    squared : bool
        Inputs v² or v.
    units : (float, float)
        Units of the log for q and the inputs, in SI.

    Raises
    ------
    InputError
        No data, a constant displacement, or differing sample intervals or inputs.
    """
    pysindy = importlib.import_module("pysindy")
    low, high = operating_range(trajectories)
    if len({x.v.shape[1] for x in trajectories}) != 1 or np.ptp([x.interval for x in trajectories]) > 1e-9:
        raise InputError("the training logs differ in inputs or sample interval; ingest them alike")
    inputs = trajectories[0].v.shape[1]
    length, volt = units
    input_scale = volt**2 if squared else volt
    model = pysindy.SINDy()
    with seeded():
        model.fit(
            [np.column_stack([x.q, x.qdot]) / length for x in trajectories],
            t=trajectories[0].interval,
            u=[(np.square(x.v) if squared else x.v) / input_scale for x in trajectories],
        )
    powers = np.asarray(model.feature_library.powers_, dtype=np.int64)
    exponents = np.zeros((len(powers), FIRST_INPUT + inputs), dtype=np.int64)
    exponents[:, [Q, QDOT, *range(FIRST_INPUT, FIRST_INPUT + inputs)]] = powers
    scales = np.array([length, length, 1.0, 1.0, 1.0, *[input_scale] * inputs])
    coefficients = length * np.asarray(model.coefficients(), dtype=np.float64)
    used = np.any(coefficients != 0.0, axis=0)
    return PolynomialDynamics(exponents[used], coefficients[:, used], scales, (), squared, *escape_bounds(low, high))
