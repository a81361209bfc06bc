"""Polynomial NARX: the next displacement from past ones and inputs, terms picked by orthogonal matching pursuit.

The regression is written in increments, δ_n = q_n − q_{n−1}, with the target δ_{n+1} − δ_n. That spans the same
polynomials as q_{n+1} = f(q_n, q_{n−1}, …, u_{n+1}, u_n, …) and is well conditioned where neighbouring samples are
nearly equal. Forward selection by orthogonalised correlation is the FROLS of the NARMAX literature (Chen, Billings
& Luo 1989, doi:10.1080/00207178908953472), here scikit-learn's `orthogonal_mp_gram`.
"""

import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numba
import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.free_run import escape_bounds
from pipeline.numerics.inner_validation import (
    HeldOutBlock,
    free_run_error,
    held_out_blocks,
    simplest_within_one_standard_error,
)
from pipeline.numerics.polynomial_dynamics import monomials
from pipeline.numerics.sparse_regression import block_factor
from pipeline.numerics.trajectory import Trajectory, operating_range

DEGREES = (3, 5, 7)
INCREMENTS = (1, 2, 3)
INPUT_LAGS = (1, 3)  # u_{n+1} alone, or u_{n+1}, u_n, u_{n−1}
TERMS = (4, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40, 50)
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


@dataclass(frozen=True)
class NarxFit:
    """The equation and how it was chosen.

    Attributes
    ----------
    equation : NarxEquation
        Fitted on all training data.
    fold_errors : FloatArray, shape (folds,)
        Free-run NRMSE of q on held-out blocks, 1 for diverged.
    library_terms : int
        Candidates that the terms were picked from.
    candidates_tried : int
        Structures times numbers of terms.
    """

    equation: NarxEquation
    fold_errors: FloatArray
    library_terms: int
    candidates_tried: int


@numba.njit(cache=True)
def _change(exponents, coefficients, x):  # type: ignore[no-untyped-def]
    """δ_{n+1} − δ_n from the scaled variables."""
    total = 0.0
    for p in range(exponents.shape[0]):
        product = coefficients[p]
        for k in range(exponents.shape[1]):
            for _ in range(exponents[p, k]):
                product *= x[k]
        total += product
    return total


@numba.njit(cache=True)
def _fill(n, now, delta, u, input_lags, scales, x):  # type: ignore[no-untyped-def]
    """The scaled variables of step n."""
    x[0] = now / scales[0]
    for j in range(delta.shape[0]):
        x[1 + j] = delta[j] / scales[1 + j]
    place = 1 + delta.shape[0]
    for k in range(u.shape[1]):
        for m in range(input_lags):
            x[place] = u[max(min(n + 1, u.shape[0] - 1) - m, 0), k] / scales[place]
            place += 1


@numba.njit(cache=True)
def _narx_run(exponents, coefficients, scales, increments, input_lags, u, q0, first_step, low, high):  # type: ignore[no-untyped-def]
    samples = u.shape[0]
    q = np.full(samples, np.nan)
    x = np.empty(exponents.shape[1])
    delta = np.full(increments, first_step)
    _fill(0, q0, delta, u, input_lags, scales, x)
    bend = _change(exponents, coefficients, x)
    for j in range(increments):
        delta[j] = first_step - (j + 0.5) * bend
    now = q0
    for n in range(samples):
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


def narx_run(equation: NarxEquation, v: FloatArray, q0: float, qdot0: float) -> tuple[FloatArray, int]:
    """Free run at the equation's own sample interval; before the first sample q followed a parabola of slope q̇0.

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

    Returns
    -------
    q : FloatArray, shape (N,)
        NaN after a divergence.
    reached : int
        Samples within the bounds. Cost: one evaluation of P monomials per sample, about 2 ns per factor.
    """
    e = equation
    u = np.ascontiguousarray(np.square(v) if e.squared else v)
    q, reached = _narx_run(
        e.exponents, e.coefficients, e.scales, e.structure.increments, e.structure.input_lags, u,
        float(q0), float(qdot0) * e.interval, e.low, e.high,
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
    e = equation
    x, _ = lagged_variables(e.structure, q, np.square(v) if e.squared else v)
    change = monomials(e.exponents, x / e.scales) @ e.coefficients / e.interval**2
    padded: FloatArray = np.pad(change, (first_step(e.structure), 1), mode="edge")
    return padded


def fit_narx(trajectories: Sequence[Trajectory], *, squared: bool = True) -> NarxFit:
    """Choose lags, degree and number of terms by free runs over held-out blocks of the training data.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches of one sample interval; only q and v are used.
    squared : bool
        Inputs v² or v.

    Raises
    ------
    InputError
        No data, a constant displacement, or differing sample intervals or inputs.
    """
    low, high = operating_range(trajectories)
    interval = trajectories[0].interval
    if len({x.v.shape[1] for x in trajectories}) != 1 or any(
        abs(x.interval / interval - 1) > 1e-3 for x in trajectories
    ):
        raise InputError("the training logs differ in inputs or sample interval; a NARX model needs one interval")
    blocks = held_out_blocks(trajectories)
    errors: dict[tuple[NarxStructure, int], FloatArray] = {}
    for degree in DEGREES:
        for increments in INCREMENTS:
            for input_lags in INPUT_LAGS:
                structure = NarxStructure(degree, increments, input_lags, trajectories[0].v.shape[1])
                path = _validate(trajectories, blocks, structure, squared, high - low)
                errors |= {(structure, terms): e for terms, e in path.items()}
    if not errors:
        raise InputError("the training stretches are too short for a NARX model; give longer logs")
    chosen = simplest_within_one_standard_error(errors, {key: key[1] for key in errors})
    equation = _equations(trajectories, blocks, chosen[0], squared, None, (chosen[1],))[chosen[1]]
    return NarxFit(equation, errors[chosen], len(chosen[0].exponents()), len(errors))


def _validate(
    trajectories: Sequence[Trajectory],
    blocks: list[HeldOutBlock],
    structure: NarxStructure,
    squared: bool,
    span: float,
) -> dict[int, FloatArray]:
    """Free-run errors of each fold for each number of terms."""
    folds = sorted({b.fold for b in blocks})
    errors: dict[int, list[float]] = {}
    for fold in folds:
        without = fold if len(folds) > 1 else None
        for terms, equation in _equations(trajectories, blocks, structure, squared, without, TERMS).items():
            parts = []
            for b in (b for b in blocks if b.fold == fold):
                x, rows = trajectories[b.source], slice(b.start, b.stop)
                q, _ = narx_run(equation, x.v[rows], float(x.q[b.start]), float(x.qdot[b.start]))
                parts.append(free_run_error(x.q[rows], q, span))
            errors.setdefault(terms, []).append(float(np.mean(parts)))
    return {terms: np.array(e) for terms, e in errors.items() if len(e) == len(folds)}


def _equations(
    trajectories: Sequence[Trajectory],
    blocks: list[HeldOutBlock],
    structure: NarxStructure,
    squared: bool,
    without: int | None,
    terms: Sequence[int],
) -> dict[int, NarxEquation]:
    """Equations of the given numbers of terms, fitted on all blocks but those of one fold: one pursuit for all."""
    raw = []
    for b in blocks:
        x = trajectories[b.source]
        if b.fold != without and b.stop - b.start > first_step(structure) + 2:
            v = x.v[b.start : b.stop]
            raw.append(lagged_variables(structure, x.q[b.start : b.stop], np.square(v) if squared else v))
    exponents = structure.exponents()
    if not raw:
        return {}
    scales = np.max([np.abs(x).max(axis=0) for x, _ in raw], axis=0)
    scales[scales == 0.0] = 1.0
    factor = np.vstack([block_factor(monomials(exponents, x / scales), y) for x, y in raw])
    low, high = escape_bounds(*operating_range(trajectories))
    equations = {}
    for count, coefficients in _pursuit(factor, terms).items():
        kept = np.flatnonzero(coefficients)
        equations[count] = NarxEquation(
            structure, exponents[kept], coefficients[kept], scales, trajectories[0].interval, squared, low, high
        )
    return equations


def _pursuit(factor: FloatArray, terms: Sequence[int]) -> dict[int, FloatArray]:
    """Coefficients after each of the given numbers of picks, from the triangular factor of [Θ y]."""
    from sklearn.linear_model import orthogonal_mp_gram

    theta, y = factor[:, :-1], factor[:, -1]
    norms = np.linalg.norm(theta, axis=0)
    norms[norms == 0.0] = 1.0
    unit = theta / norms
    most = min(max(terms), int(np.linalg.matrix_rank(unit)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # it says that it stopped early
        path = orthogonal_mp_gram(unit.T @ unit, unit.T @ y, n_nonzero_coefs=most, return_path=True)
    path = np.asarray(path, dtype=np.float64).reshape(unit.shape[1], -1)
    # a path that ends early has left no residual to pick from: more terms would be the same equation
    return {count: path[:, min(count, path.shape[1]) - 1] / norms for count in terms}
