"""Dynamics whose right-hand side is a table of monomials: evaluation and free-run simulation."""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..codegen.graph import function, trace
from ..codegen.numba_writer import formula
from ..generated.terms import LAG, POLYNOMIAL_VARIABLES
from ..numerics.arrays import FloatArray, IntArray
from ..numerics.fixed_step import (
    LAG_STEP,
    Methods,
    begin,
    between_samples,
    bounded_run,
    finish,
    inlined,
    integrator,
    steps_per_sample,
)
from ..numerics.linear_filters import first_order_lag

_variables = formula(POLYNOMIAL_VARIABLES)
_lag_rate = formula(LAG)
_turned = formula(trace(lambda q: {"of": [function("sin", q[0]), function("cos", q[0])]}, q=1))

Q, QDOT, FRICTION, SINE, COSINE, FIRST_INPUT = range(6)
"""Columns of an exponent table; one column per input follows, then one per lag."""
MOST_STEPS = 20
"""Runge-Kutta steps in a sample interval, unless a lag needs more. Stable up to rates of 55 over that interval, of
which samples show nothing; beyond 0.1 s, steps of 5 ms would take minutes over the log of a slow device."""
MOST_LAG_STEPS = 1000
"""A fit takes no lag that needs a hundredth of them; a file may name any."""


@dataclass(frozen=True)
class Lag:
    """A state ż = (x − z)/T that follows the scaled variable x: the velocity, or an input.

    Attributes
    ----------
    source : int
        Column of x in the exponent table: `QDOT` or that of an input.
    time : float
        T [s].
    """

    source: int
    time: float


@dataclass(frozen=True)
class PolynomialDynamics:
    """``[q̇, q̈] = C · monomials(x)``, x the scaled [q, q̇, tanh(q̇/w), sin q, cos q, u1 … uK, z1 … zL].

    Attributes
    ----------
    exponents : IntArray, shape (P, 5 + K + L)
        Powers of the scaled variables, one row per monomial.
    coefficients : FloatArray, shape (2, P)
        Row 0 gives q̇ [m/s], row 1 gives q̈ [m/s²]. A fixed structure q̇ = v is a single entry in row 0.
    scales : FloatArray, shape (5 + K,)
        Scale of each variable [m, m/s, m/s, 1, 1, V² or V …]; entry 2 is the speed w inside the tanh.
    lags : tuple of Lag
        The lag states, which are scaled as what they follow.
    squared : bool
        True if the inputs are v² (electrostatic), false if v.
    low, high : float
        Range of displacements [m]; outside a run counts as diverged.
    """

    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    lags: tuple[Lag, ...]
    squared: bool
    low: float
    high: float

    @property
    def inputs(self) -> int:
        """Number of inputs K."""
        return int(self.scales.size) - FIRST_INPUT


class PolynomialJoint(NamedTuple):
    """Dynamics in a run, with voltages v (N, K), `refined` times as fine as the samples, and room for variables.

    `factors` lists the variables whose product each monomial is, one monomial after the other; `ends`, shape (P,),
    gives the end of the factors of each. `parts` half steps are a sample interval. Lags follow the variables `sources`.
    """

    factors: IntArray
    ends: IntArray
    coefficients: FloatArray
    scales: FloatArray
    sources: IntArray
    lag_times: FloatArray
    squared: bool
    trigonometric: bool
    v: FloatArray
    refined: int
    parts: int
    scaled: FloatArray


def _rates(system, x, node, dx, acceleration):
    """State equation under the inputs of the half step."""
    n, following, share = between_samples(node * system.refined, system.parts, len(system.v))
    for k in range(system.v.shape[1]):
        u = system.v[n, k] + share * (system.v[following, k] - system.v[n, k])
        system.scaled[FIRST_INPUT + k] = (u * u if system.squared else u) / system.scales[FIRST_INPUT + k]
    _move(system, x, dx)
    acceleration[0] = dx[1]


@inlined
def _move(system, x, dx):
    """C · monomials(x), the inputs being in `scaled`; powers by repeated multiplication."""
    scaled = system.scaled
    s = system.scales
    lags = len(system.sources)
    moving = _variables((x[0], x[1], s[0], s[1], s[2]))
    for i in range(3):
        scaled[i] = moving[i]
    if system.trigonometric:
        scaled[SINE], scaled[COSINE] = _turned((x[0],))
    for i in range(lags):
        scaled[len(s) + i] = x[2 + i]
        dx[2 + i] = _lag_rate((scaled[system.sources[i]], x[2 + i], system.lag_times[i]))[0]
    dx[0], dx[1] = 0.0, 0.0
    factor = 0
    for p in range(len(system.ends)):
        product = 1.0
        while factor < system.ends[p]:
            product *= scaled[system.factors[factor]]
            factor += 1
        dx[0] += system.coefficients[0, p] * product
        dx[1] += system.coefficients[1, p] * product


def polynomial_rates(dynamics: PolynomialDynamics, x: Sequence[Any], u: Sequence[Any]) -> list[Any]:
    """Rates of q, q̇ and the lag states under the scaled inputs u (K,): the state equation for traced values."""
    scaled = np.empty(dynamics.exponents.shape[1], dtype=object)
    dx = np.empty(len(x), dtype=object)
    scaled[FIRST_INPUT : FIRST_INPUT + len(u)] = u
    _move(_system(dynamics, np.empty((0, 0)), 1, 1)._replace(scaled=scaled), x, dx)
    return list(dx)


def _system(d: PolynomialDynamics, v: FloatArray, refined: int, parts: int) -> PolynomialJoint:
    """The dynamics under voltages v (N, K)."""
    variables = np.tile(np.arange(d.exponents.shape[1]), len(d.exponents))
    return PolynomialJoint(
        factors=np.repeat(variables, d.exponents.ravel()),
        ends=np.cumsum(d.exponents.sum(axis=1)),
        coefficients=d.coefficients,
        scales=d.scales,
        sources=np.array([lag.source for lag in d.lags], dtype=np.int64),
        lag_times=np.array([lag.time for lag in d.lags], dtype=np.float64),
        squared=d.squared,
        trigonometric=bool(np.any(d.exponents[:, SINE : COSINE + 1])),
        v=v,
        refined=refined,
        parts=parts,
        scaled=np.zeros(d.exponents.shape[1]),
    )


def steps_between_samples(dynamics: PolynomialDynamics, interval: float, refined: int = 1) -> int:
    """Integration steps in a sample interval [s], in which voltages are known `refined` times."""
    most = min(max(steps_per_sample(interval, np.inf), (refined + 1) // 2), MOST_STEPS)
    shortest = min((lag.time for lag in dynamics.lags), default=np.inf)
    return max(most, int(min(np.ceil(interval / (LAG_STEP * shortest)), MOST_LAG_STEPS)))


_integrate = integrator(PolynomialJoint, lambda kind: Methods(begin, _rates, finish))


def free_run(
    dynamics: PolynomialDynamics, v: FloatArray, interval: float, q0: float, qdot0: float, z0: FloatArray | None = None
) -> tuple[FloatArray, int]:
    """Simulate from an initial state by classical Runge-Kutta steps as in `pipeline.numerics.fixed_step`.

    Parameters
    ----------
    dynamics : PolynomialDynamics
        The right-hand side.
    v : FloatArray, shape (N, K) or (N, r, K)
        Voltages [V] at the samples, or at r times of each sample interval; linear between them.
    interval : float
        Sample interval [s].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s].
    z0 : FloatArray, shape (L,), optional
        Initial lag states, scaled; what they follow if left out.

    Returns
    -------
    path : FloatArray, shape (N, 3)
        q, q̇, q̈; NaN from the sample on where the run left the bounds or stopped being finite.
    reached : int
        Samples simulated; N for a whole run.
        Cost: 4 evaluations of the table per step, about 1 ns per factor of a monomial.
    """
    d = dynamics
    refined = v.shape[1] if v.ndim == 3 else 1
    steps = steps_between_samples(d, interval, refined)
    flat = np.ascontiguousarray(v.reshape(-1, v.shape[-1]))
    system = _system(d, flat, refined, 2 * steps)
    if z0 is None:
        z0 = _followed(d, flat[:1], np.array([q0]), np.array([qdot0]))[0, system.sources]
    start = np.concatenate([[q0, qdot0], z0]).astype(np.float64)
    return bounded_run(_integrate, system, start, len(v), steps, interval, (d.low, d.high))


def _followed(d: PolynomialDynamics, v: FloatArray, q: FloatArray, qdot: FloatArray) -> FloatArray:
    """The scaled variables without the lag states, shape (N, 5 + K)."""
    u = np.square(v) if d.squared else v
    moving = POLYNOMIAL_VARIABLES.evaluate(q=q[:, None], q_dot=qdot[:, None], scales=d.scales[:SINE])["variables"]
    return np.column_stack([moving, np.sin(q), np.cos(q), u / d.scales[FIRST_INPUT:]])


def scaled_variables(
    d: PolynomialDynamics, v: FloatArray, q: FloatArray, qdot: FloatArray, interval: float
) -> FloatArray:
    """The scaled variables along a measured path, shape (N, 5 + K + L), lag states as after a long rest at its start.

    Parameters
    ----------
    d : PolynomialDynamics
        Scales and lags; its monomials are not used.
    v : FloatArray, shape (N, K)
        Voltages [V].
    q, qdot : FloatArray, shape (N,)
        Displacement [m] and velocity [m/s].
    interval : float
        Sample interval [s].
    """
    x = _followed(d, v, q, qdot)
    lagged = [first_order_lag(np.ascontiguousarray(x[:, lag.source]), interval, lag.time)[0] for lag in d.lags]
    return np.column_stack([x, *lagged])


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
