"""Dynamics whose right-hand side is a table of monomials: evaluation and free-run simulation."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from pipeline.codegen.numba_writer import formula
from pipeline.generated.terms import LAG as LAG_RATE
from pipeline.generated.terms import POLYNOMIAL_VARIABLES
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.lag import first_order_lag
from pipeline.solvers.fixed_step import Methods, integrator, no_begin, no_finish
from pipeline.solvers.free_run import LAG_STEP, between_samples, bounded_run, steps_per_sample

_variables, _lag_rate = formula(POLYNOMIAL_VARIABLES), formula(LAG_RATE)

# Columns of an exponent table; one column per input follows.
Q, QDOT, LAG, FRICTION, SINE, COSINE, FIRST_INPUT = 0, 1, 2, 3, 4, 5, 6


@dataclass(frozen=True)
class PolynomialDynamics:
    """``[q̇, q̈] = C · monomials(x)``, ``ż = (q̇ − z)/T_z``, x the scaled [q, q̇, z, tanh(q̇/w), sin q, cos q, u1 … uK].

    Attributes
    ----------
    exponents : IntArray, shape (P, 6 + K)
        Powers of the scaled variables, one row per monomial.
    coefficients : FloatArray, shape (2, P)
        Row 0 gives q̇ [m/s], row 1 gives q̈ [m/s²]. A fixed structure q̇ = v is a single entry in row 0.
    scales : FloatArray, shape (6 + K,)
        Scale of each variable [m, m/s, m/s, m/s, 1, 1, V² or V …]; entry 3 is the speed w inside the tanh.
    lag_time : float
        T_z [s] of the lag state; 0 where the model has none.
    squared : bool
        Whether the inputs are v² (electrostatic) or v.
    low, high : float
        Displacement [m] outside of which a run counts as diverged.
    """

    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    lag_time: float
    squared: bool
    low: float
    high: float


class PolynomialJoint(NamedTuple):
    """Dynamics in a run, with voltages v (N, K), `parts` half steps in a sample interval and room for variables.

    `factors` lists the variables whose product each monomial is, one monomial after the other; `ends`, shape (P,),
    tells where the factors of each end.
    """

    factors: IntArray
    ends: IntArray
    coefficients: FloatArray
    scales: FloatArray
    lag_time: float
    squared: bool
    trigonometric: bool
    v: FloatArray
    parts: int
    scaled: FloatArray


def _rates(system, x, node, dx, acceleration):  # type: ignore[no-untyped-def]
    """C · monomials(x); powers by repeated multiplication."""
    scaled, s = system.scaled, system.scales
    found = _variables((x[0], x[1], x[2], s[0], s[1], s[2], s[3]))
    for i in range(4):
        scaled[i] = found[i]
    if system.trigonometric:
        scaled[SINE], scaled[COSINE] = np.sin(x[0]), np.cos(x[0])
    n, following, share = between_samples(node, system.parts, len(system.v))
    for k in range(system.v.shape[1]):
        u = system.v[n, k] + share * (system.v[following, k] - system.v[n, k])
        scaled[FIRST_INPUT + k] = (u * u if system.squared else u) / system.scales[FIRST_INPUT + k]
    dx[0], dx[1], dx[2] = 0.0, 0.0, 0.0
    factor = 0
    for p in range(len(system.ends)):
        product = 1.0
        while factor < system.ends[p]:
            product *= scaled[system.factors[factor]]
            factor += 1
        dx[0] += system.coefficients[0, p] * product
        dx[1] += system.coefficients[1, p] * product
    if system.lag_time > 0.0:
        dx[2] = _lag_rate((x[1], x[2], system.lag_time))[0]
    acceleration[0] = dx[1]


MOST_STEPS = 20
"""Runge-Kutta steps in a sample interval, unless the lag needs more. Stable up to rates of 55 over that interval, of
which samples show nothing; beyond 0.1 s, steps of 5 ms would take minutes over the log of a slow device."""


def steps_between_samples(dynamics: PolynomialDynamics, interval: float) -> int:
    """Integration steps in a sample interval [s]."""
    most = min(steps_per_sample(interval, np.inf), MOST_STEPS)
    for_lag = int(np.ceil(interval / (LAG_STEP * dynamics.lag_time))) if dynamics.lag_time > 0.0 else 1
    return max(most, for_lag)


_integrate = integrator(PolynomialJoint, lambda kind: Methods(no_begin, _rates, no_finish))


def free_run(
    dynamics: PolynomialDynamics, v: FloatArray, interval: float, q0: float, qdot0: float, z0: float | None = None
) -> tuple[FloatArray, int]:
    """Simulate from an initial state by classical Runge-Kutta steps as in `pipeline.solvers.fixed_step`.

    Parameters
    ----------
    dynamics : PolynomialDynamics
        The right-hand side.
    v : FloatArray, shape (N, K)
        Voltages [V], linear between samples.
    interval : float
        Sample interval [s].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s].
    z0 : float, optional
        Initial lag state [m/s]; q̇0 if left out.

    Returns
    -------
    path : FloatArray, shape (N, 3)
        q, q̇, q̈; NaN from the sample on where the run left the bounds or stopped being finite.
    reached : int
        Samples simulated; N for a whole run.
        Cost: 4 evaluations of the table per step, about 1 ns per factor of a monomial.
    """
    d = dynamics
    steps = steps_between_samples(d, interval)
    variables = np.tile(np.arange(d.exponents.shape[1]), len(d.exponents))
    system = PolynomialJoint(
        np.repeat(variables, d.exponents.ravel()), np.cumsum(d.exponents.sum(axis=1)),
        d.coefficients, d.scales, d.lag_time, d.squared, bool(np.any(d.exponents[:, SINE : COSINE + 1])),
        np.ascontiguousarray(v), 2 * steps, np.zeros(d.scales.size),
    )  # fmt: skip
    start = np.array([q0, qdot0, qdot0 if z0 is None else z0], dtype=np.float64)
    return bounded_run(_integrate, system, start, len(v), steps, interval, (d.low, d.high))


def lag_state(qdot: FloatArray, interval: float, lag_time: float) -> FloatArray:
    """Z along a measured velocity, z(0) = q̇(0); zeros for a model without the lag state (`lag_time` 0)."""
    if lag_time == 0.0:
        return np.zeros_like(qdot)
    return first_order_lag(np.ascontiguousarray(qdot), interval, lag_time)[0]


def scaled_variables(
    scales: FloatArray, squared: bool, v: FloatArray, q: FloatArray, qdot: FloatArray, z: FloatArray
) -> FloatArray:
    """The scaled variables along a measured path, shape (N, 6 + K); columns as in `PolynomialDynamics`."""
    u = np.square(v) if squared else v
    state = {"q": q[:, None], "q_dot": qdot[:, None], "z": z[:, None]}
    factors = POLYNOMIAL_VARIABLES.evaluate(**state, scales=scales[:4])["variables"]
    return np.column_stack([factors, np.column_stack([np.sin(q), np.cos(q), u]) / scales[SINE:]])


def monomials(exponents: IntArray, x: FloatArray) -> FloatArray:
    """The library matrix: each row of `exponents` applied to the rows of `x`, shape (N, P)."""
    columns = np.ascontiguousarray(x.T)
    powers = [np.ones_like(columns), columns]
    for _ in range(int(exponents.max(initial=0)) - 1):
        powers.append(powers[-1] * columns)
    library = np.ones((len(exponents), len(x)))  # a term is a row here, so that its samples lie together
    for p, row in enumerate(exponents.tolist()):
        for k, power in enumerate(row):
            if power:
                library[p] *= powers[power][k]
    return np.ascontiguousarray(library.T)
