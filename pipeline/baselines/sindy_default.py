"""pysindy as it comes: default library, optimiser and differentiation, nothing fixed and nothing tuned.

A test compares the coefficients with those of pysindy itself, whose import takes longer than all fits of a run.
"""

import itertools
from collections.abc import Sequence

import numpy as np

from pipeline.baselines.polynomial_dynamics import FIRST_INPUT, QDOT, PolynomialDynamics, Q, monomials
from pipeline.baselines.sparse_regression import stlsq
from pipeline.errors import InputError
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.lagged_free_run import escape_bounds

MILLI, KILO = 1e-3, 1e3
DEGREE, THRESHOLD, RIDGE, MOST_ROUNDS = 2, 0.1, 0.05, 20  # pysindy's


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
    low, high = operating_range(trajectories)
    if len({x.v.shape[1] for x in trajectories}) != 1 or np.ptp([x.interval for x in trajectories]) > 1e-9:
        raise InputError("the training logs differ in inputs or sample interval; ingest them alike")
    inputs = trajectories[0].v.shape[1]
    length, volt = units
    input_scale = volt**2 if squared else volt
    variables = [Q, QDOT, *range(FIRST_INPUT, FIRST_INPUT + inputs)]
    chosen = [(), *((k,) for k in variables), *itertools.combinations_with_replacement(variables, DEGREE)]
    exponents = np.array([[term.count(k) for k in range(FIRST_INPUT + inputs)] for term in chosen], dtype=np.int64)
    scales = np.array([length, length, length, 1.0, 1.0, 1.0, *[input_scale] * inputs])
    rows, rates = [], []
    for x in trajectories:
        state = np.column_stack([x.q, x.qdot]) / length
        others = np.ones((len(state), FIRST_INPUT - 2))
        rows.append(np.column_stack([state, others, (np.square(x.v) if squared else x.v) / input_scale]))
        rates.append(np.gradient(state, x.interval, axis=0, edge_order=2))
    library, targets = monomials(exponents, np.concatenate(rows)), np.concatenate(rates)
    found = np.array([stlsq(library, target, THRESHOLD, RIDGE, MOST_ROUNDS) for target in targets.T])
    used = np.any(found != 0.0, axis=0)
    return PolynomialDynamics(exponents[used], length * found[:, used], scales, 0.0, squared, *escape_bounds(low, high))
