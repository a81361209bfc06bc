"""Polynomial NARX: the next displacement from past displacements and inputs; terms, free run, one-step prediction.

The equation is written in increments, δ_n = q_n − q_{n−1}, with the target δ_{n+1} − δ_n. That spans the same
polynomials as q_{n+1} = f(q_n, q_{n−1}, …, u_{n+1}, u_n, …) and is well conditioned where neighbouring samples are
nearly equal.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.baselines.polynomial_dynamics import monomials
from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, IntArray

COUPLING_DEGREE = 3  # degree in q of the factors of older increments and inputs


@dataclass(frozen=True)
class NarxStructure:
    """Candidate terms: poly_degree(q_n, δ_n), poly3(q_n)⊗(older δ), poly3(q_n)⊗(inputs).

    Attributes
    ----------
    degree : int
        Total degree in q_n and δ_n.
    increments : int
        δ_n … δ_{n−L+1}, so L + 1 past displacements.
    input_lags : int
        u_{n+1} … u_{n+2−M} of each input. The newest may be used: inputs are measured, not predicted.
    inputs : int
        Number of inputs K; the variables are ordered q, δ…, u1 by lag, u2 by lag.
    """

    degree: int
    increments: int
    input_lags: int
    inputs: int

    def exponents(self) -> IntArray:
        """The exponent table, shape (P, 1 + L + K·M)."""
        variables = 1 + self.increments + self.inputs * self.input_lags
        powers = [{0: i, 1: j} for i in range(self.degree + 1) for j in range(self.degree + 1 - i)]
        powers += [{0: i, k: 1} for k in range(2, variables) for i in range(COUPLING_DEGREE + 1)]
        return np.array([[p.get(k, 0) for k in range(variables)] for p in powers], dtype=np.int64)


@dataclass(frozen=True)
class NarxEquation:
    """A fitted difference equation at a fixed sample interval.

    Attributes
    ----------
    structure : NarxStructure
        Which lags the variables are.
    exponents : IntArray, shape (P, 1 + L + K·M)
        The terms kept.
    coefficients : FloatArray, shape (P,)
        Their weights [m] in δ_{n+1} − δ_n.
    scales : FloatArray, shape (1 + L + K·M,)
        Scales of the variables.
    interval : float
        Sample interval [s] that the equation belongs to.
    squared : bool
        Whether u = v² or u = v.
    low, high : float
        Displacement [m] outside of which a run counts as diverged.
    """

    structure: NarxStructure
    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    interval: float
    squared: bool
    low: float
    high: float


_NOTHING = np.zeros(0)


@compiled
def _change(exponents: IntArray, coefficients: FloatArray, x: FloatArray) -> float:
    """δ_{n+1} − δ_n from the scaled variables."""
    total: float = 0.0
    for p in range(exponents.shape[0]):
        product = coefficients[p]
        for k in range(exponents.shape[1]):
            for _ in range(exponents[p, k]):
                product *= x[k]
        total += product
    return total


@compiled
def _fill(
    n: int, now: float, delta: FloatArray, u: FloatArray, input_lags: int, scales: FloatArray, x: FloatArray
) -> None:
    """The scaled variables of step n."""
    x[0] = now / scales[0]
    for j in range(delta.shape[0]):
        x[1 + j] = delta[j] / scales[1 + j]
    place = 1 + delta.shape[0]
    for k in range(u.shape[1]):
        for m in range(input_lags):
            x[place] = u[max(min(n + 1, u.shape[0] - 1) - m, 0), k] / scales[place]
            place += 1


@compiled
def _narx_run(
    exponents: IntArray, coefficients: FloatArray, scales: FloatArray, increments: int, input_lags: int, u: FloatArray,
    q0: float, first_step: float, low: float, high: float, seen: FloatArray,
) -> tuple[FloatArray, int]:  # fmt: skip
    samples, begin = u.shape[0], max(len(seen) - 1, 0)
    q = np.full(samples, np.nan)
    x = np.empty(exponents.shape[1])
    delta = np.full(increments, first_step)
    _fill(begin, q0, delta, u, input_lags, scales, x)
    bend = _change(exponents, coefficients, x)
    for j in range(increments):
        delta[j] = seen[begin - j] - seen[begin - j - 1] if j < begin else first_step - (j + 0.5) * bend
    now = q0
    for n in range(begin, samples):
        if not low <= now <= high:
            return q, n
        q[n] = now
        _fill(n, now, delta, u, input_lags, scales, x)
        change = delta[0] + _change(exponents, coefficients, x)
        for j in range(increments - 1, 0, -1):
            delta[j] = delta[j - 1]
        delta[0] = change
        now += change
    return q, samples


def narx_run(
    equation: NarxEquation, v: FloatArray, q0: float, qdot0: float, seen: FloatArray = _NOTHING
) -> tuple[FloatArray, int]:
    """Free run at the equation's own sample interval; before what was seen q followed a parabola of slope q̇0.

    Its bend is the acceleration that the equation itself gives, so that increments, which are velocities half a
    sample earlier, start without that lag.

    Parameters
    ----------
    equation : NarxEquation
        The difference equation.
    v : FloatArray, shape (N, K)
        Inputs at the samples [V].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s].
    seen : FloatArray, shape (M,)
        Displacement [m] of the first M samples where it was measured, of which the last is q0: the run begins there.

    Returns
    -------
    q : FloatArray, shape (N,)
        NaN after a divergence, and before the run begins.
    reached : int
        Samples within the bounds. Cost: one evaluation of P monomials per sample, about 2 ns per factor.
    """
    e = equation
    u = np.ascontiguousarray(np.square(v) if e.squared else v)
    q, reached = _narx_run(
        e.exponents, e.coefficients, e.scales, e.structure.increments, e.structure.input_lags, u,
        float(q0), float(qdot0) * e.interval, e.low, e.high, np.ascontiguousarray(seen),
    )  # fmt: skip
    return q, int(reached)


def lagged_variables(structure: NarxStructure, q: FloatArray, u: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Variables and target of each step that a gap-free record offers.

    Parameters
    ----------
    structure : NarxStructure
        Which lags.
    q : FloatArray, shape (N,)
        Displacement.
    u : FloatArray, shape (N, K)
        Inputs as they act (v² or v).

    Returns
    -------
    x : FloatArray, shape (N − 1 − first, 1 + L + K·M)
        Unscaled; row r belongs to n = first + r with ``first = max(L, M − 2)``.
    target : FloatArray, shape (N − 1 − first,)
        δ_{n+1} − δ_n.
    """
    first = first_step(structure)
    n = np.arange(first, q.size - 1)
    delta = np.diff(q, prepend=q[0])
    columns = [q[n], *(delta[n - j] for j in range(structure.increments))]
    columns += [u[n + 1 - m, k] for k in range(u.shape[1]) for m in range(structure.input_lags)]
    return np.column_stack(columns), delta[n + 1] - delta[n]


def first_step(structure: NarxStructure) -> int:
    """The first sample whose lags all lie in the record."""
    return max(structure.increments, structure.input_lags - 2)


def accelerations(equation: NarxEquation, v: FloatArray, q: FloatArray) -> FloatArray:
    """One-step predictions along a measured path as accelerations (δ_{n+1} − δ_n)/h², shape (N,).

    The first rows, whose lags reach before the record, and the last one repeat their neighbour.
    """
    e, needed = equation, first_step(equation.structure) + 2
    if q.size < needed:
        raise InputError(f"the record has {q.size} samples; the lags of this NARX equation reach over {needed}")
    x, _ = lagged_variables(e.structure, q, np.square(v) if e.squared else v)
    change = monomials(e.exponents, x / e.scales) @ e.coefficients / e.interval**2
    padded: FloatArray = np.pad(change, (first_step(e.structure), 1), mode="edge")
    return padded
