"""Free run of the lagged RBF model (eqs. 37-40).

The number of steps per sample follows from the lag, the fastest known time constant of the model.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ...codegen.numba_writer import formula
from ...generated.terms import GAUSSIAN, LAGGED_RATES
from ...numerics.arrays import FloatArray
from ...numerics.fixed_step import Methods, between_samples, bounded_run, inlined, integrator, no_begin, no_finish

_gaussian = formula(GAUSSIAN)
_lagged_rates = formula(LAGGED_RATES)

REACH = 8.6
"""|q − ξ|/σ from which a bell is left out of a sum: exp(−37) is below rounding."""


class LaggedJoint(NamedTuple):
    """A joint of eqs. 37 to 40 in a run, see `lagged_rbf_run`.

    `parts` are half steps in a sample interval, `farthest` is the square of the reach of a bell (None: no term is left
    out), `inverse` is 1/σ, `u` and `values` have room for inputs and curves.
    """

    v: FloatArray
    squared: bool
    parts: int
    farthest: float | None
    centres: FloatArray
    weights: FloatArray
    inverse: float
    lag: float
    u: FloatArray
    values: FloatArray


def _rates(system, x, node, dx, acceleration):
    """The law under the inputs of the half step."""
    n, following, share = between_samples(node, system.parts, len(system.v))
    for k in range(system.v.shape[1]):
        u = system.v[n, k] + share * (system.v[following, k] - system.v[n, k])
        system.u[k] = u * u if system.squared else u
    _move(system, x, system.u, dx)
    acceleration[0] = dx[1]


@inlined
def _move(system, x, u, dx):
    """Curves at q as sums over the basis, without what is negligible; then the law."""
    for s in range(len(system.values)):
        system.values[s] = 0.0
    for i in range(len(system.centres)):
        distance = (x[0] - system.centres[i]) * system.inverse
        square = distance * distance
        if system.farthest is None or square < system.farthest:
            value = _gaussian((square,))[0]
            for s in range(len(system.values)):
                system.values[s] += system.weights[i, s] * value
    push = 0.0
    for k in range(len(u)):
        push += system.values[2 + k] * u[k]
    dx[0] = x[1]
    dx[1], dx[2] = _lagged_rates((x[0], x[1], x[2], system.values[0], system.values[1], push, system.lag))


_integrate = integrator(LaggedJoint, lambda kind: Methods(no_begin, _rates, no_finish))


@dataclass(frozen=True)
class LaggedLaw:
    """Numbers of eqs. 37 to 40.

    Attributes
    ----------
    centres : FloatArray, shape (M,)
        ξ_i, in the unit of q.
    weights : FloatArray, shape (M, 2 + K)
        Columns c, d, g_1 … g_K, divided by the mass.
    width : float
        σ of the bells, in the unit of q.
    lag : float
        T_z [s].
    squared : bool
        Whether the force goes with the square of the voltage.
    """

    centres: FloatArray
    weights: FloatArray
    width: float
    lag: float
    squared: bool = True

    def joint(self, v: FloatArray, parts: int, reach: float | None, u: FloatArray, values: FloatArray) -> LaggedJoint:
        """The system of a run.

        Parameters
        ----------
        v : FloatArray, shape (N, K)
            Voltages [V].
        parts : int
            Half steps in a sample interval.
        reach : float, optional
            Distance in σ from which a bell is left out; none is if left out.
        u, values : FloatArray, shapes (K,) and (2 + K,)
            Room for inputs and curves.
        """
        return LaggedJoint(
            v, self.squared, parts, None if reach is None else reach**2, np.ascontiguousarray(self.centres),
            np.ascontiguousarray(self.weights), 1.0 / self.width, float(self.lag), u, values,
        )  # fmt: skip


def lagged_rates(law: LaggedLaw, x: Sequence[Any], u: Sequence[Any]) -> list[Any]:
    """Rates of q, q̇ and z under the inputs u (K,): the law of a run for traced values."""
    values = np.empty(2 + len(u), dtype=object)
    nothing = np.empty(0)
    dx = np.empty(3, dtype=object)
    _move(law.joint(nothing, 1, None, nothing, values), x, u, dx)
    return list(dx)


def lagged_rbf_run(
    law: LaggedLaw, v: FloatArray, interval: float, steps: int, start: tuple[float, ...], bounds: tuple[float, float]
) -> tuple[FloatArray, int]:
    """Integrate q̈ = −c q − d z + Σ g_k u_k, ż = (q̇ − z)/T_z from `start`.

    Parameters
    ----------
    law : LaggedLaw
        The equation.
    v : FloatArray, shape (N, K)
        Voltages at the samples [V], linear in between; u = v² if `law.squared`, else v.
    interval : float
        Sample interval [s].
    steps : int
        Runge-Kutta steps per interval.
    start : tuple of float
        q(0) [m], q̇(0) [m/s] and z(0) [m/s], which is q̇(0) if left out.
    bounds : (float, float)
        The run ends as soon as q leaves them.

    Returns
    -------
    states : FloatArray, shape (N, 3)
        q, q̇, q̈ at the samples; NaN after divergence.
    valid : int
        Samples within the bounds; N if the run completed. Cost: 4·steps·N evaluations of M exponentials and
        (2 + K)·M products, about 60 ns each for M = 10.
    """
    inputs = v.shape[1]
    system = law.joint(np.ascontiguousarray(v), 2 * steps, REACH, np.zeros(inputs), np.zeros(2 + inputs))
    return bounded_run(_integrate, system, np.array([start[0], start[1], start[-1]]), len(v), steps, interval, bounds)
