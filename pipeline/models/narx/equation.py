"""Polynomial NARX: the next displacement from past displacements and inputs; free run, and choice of lags and terms.

The equation is written in increments, δ_n = q_n − q_{n−1}, with the target δ_{n+1} − δ_n. That spans the same
polynomials as q_{n+1} = f(q_n, q_{n−1}, …, u_{n+1}, u_n, …) and is well conditioned where neighbouring samples are
nearly equal. Terms are picked by forward selection, the FROLS of the NARMAX literature (Chen, Billings & Luo 1989,
doi:10.1080/00207178908953472): scikit-learn's `orthogonal_mp_gram`.
"""

import importlib
import itertools
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.models.polynomial_dynamics import monomials
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.scoring.cross_validation import free_run_error, held_out_blocks, simplest_within_one_standard_error
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.fixed_step import escape_bounds

COUPLING_DEGREE = 3  # degree in q of the factors of older increments and inputs
DEGREES, INCREMENTS, INPUT_LAGS = (3, 5, 7), (1, 2, 3), (1, 3)  # u_{n+1} alone, or u_{n+1}, u_n, u_{n−1}
TERMS = (4, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40, 50)


class NarxStructure(NamedTuple):
    """Candidate terms: poly_degree(q_n, δ_n), poly3(q_n)⊗(older δ), poly3(q_n)⊗(inputs).

    `degree` is the total degree in q_n and δ_n. There are `increments` L: δ_n … δ_{n−L+1}, so L + 1 past displacements;
    and `input_lags` M of each of K `inputs`: u_{n+1} … u_{n+2−M}. The newest may be used: inputs are measured, not
    predicted. The variables are ordered q, δ…, u1 by lag, u2 by lag.
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
    """A difference equation at a fixed sample interval.

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
        Sample interval [s] of the equation.
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

    def lagged_inputs(self, v: FloatArray) -> FloatArray:
        """Inputs as they act at each step, shape (N, K·M); lags that reach beyond the record repeat its ends."""
        u, lags = np.square(v) if self.squared else v, np.arange(self.structure.input_lags)
        rows = np.clip(np.arange(1, len(u) + 1)[:, None] - lags, 0, len(u) - 1)
        return np.hstack([column[rows] for column in u.T])

    def regression(self, q: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray, int]:
        """Terms, shape (R, P), and targets, shape (R,), of the steps whose lags lie in the record; the first of these.

        Raises
        ------
        InputError
            There are none.
        """
        first = max(self.structure.increments, self.structure.input_lags - 2)
        if len(q) < first + 2:
            raise InputError(f"the record has {len(q)} samples; the lags of this NARX equation reach over {first + 2}")
        n, delta = np.arange(first, len(q) - 1), np.diff(q, prepend=q[0])
        older = [delta[n - j] for j in range(self.structure.increments)]
        x = np.column_stack([q[n], *older, self.lagged_inputs(v)[n]])
        return monomials(self.exponents, x / self.scales), delta[n + 1] - delta[n], first


class _Polynomial(NamedTuple):
    """Monomials (P, V), their coefficients (P,), scales of the variables (V,), and the bounds of q."""

    exponents: IntArray
    coefficients: FloatArray
    scales: FloatArray
    low: float
    high: float


@compiled
def _change(polynomial: _Polynomial, x: FloatArray) -> float:
    """δ_{n+1} − δ_n from the scaled variables."""
    exponents, coefficients, _, _, _ = polynomial
    total: float = 0.0
    for p in range(exponents.shape[0]):
        product = coefficients[p]
        for k in range(exponents.shape[1]):
            for _ in range(exponents[p, k]):
                product *= x[k]
        total += product
    return total


@compiled
def _run(polynomial: _Polynomial, u: FloatArray, q: FloatArray, delta: FloatArray, begin: int) -> int:
    """Fill q behind row `begin`, which follows the increments `delta`; return the first row out of bounds, or N."""
    older = len(delta)
    for n in range(begin, len(q)):
        if not polynomial.low <= q[n] <= polynomial.high:
            q[n] = np.nan
            return n
        x = np.concatenate((q[n : n + 1], delta, u[n])) / polynomial.scales
        change = delta[0] + _change(polynomial, x)
        delta[1:] = delta[: older - 1].copy()
        delta[0] = change
        if n + 1 < len(q):
            q[n + 1] = q[n] + change
    return len(q)


def narx_run(
    equation: NarxEquation, v: FloatArray, q0: float, qdot0: float, seen: FloatArray | None = None
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
    seen : FloatArray, shape (M,), optional
        Displacement [m] of the first M samples where it was measured, of which the last is q0: the run begins there.

    Returns
    -------
    q : FloatArray, shape (N,)
        NaN after a divergence, and before the run begins.
    reached : int
        Samples within the bounds. Cost: one evaluation of P monomials per sample, about 2 ns per factor.
    """
    e, q, first = equation, np.full(len(v), np.nan), float(qdot0) * equation.interval
    begin, u, ages = 0 if seen is None else len(seen) - 1, e.lagged_inputs(v), np.arange(e.structure.increments)
    polynomial = _Polynomial(e.exponents, e.coefficients, e.scales, e.low, e.high)
    q[begin] = q0
    x = np.concatenate([[q0], np.full(ages.size, first), u[begin]]) / e.scales
    delta = np.array(first - (ages + 0.5) * _change(polynomial, x), dtype=np.float64)
    if seen is not None:
        past = np.diff(seen)[::-1][: ages.size]
        delta[: past.size] = past
    return q, int(_run(polynomial, u, q, delta, begin))


def fit_narx(
    trajectories: Sequence[Trajectory], *, squared: bool = True, most: int | None = None
) -> tuple[NarxEquation, dict[str, Any]]:
    """Choose lags, degree and number of terms by free runs over held-out blocks of the training data.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches of one sample interval; only q and v are used.
    squared : bool
        Inputs v² or v.
    most : int, optional
        Candidates (a structure with a number of terms) after which no further structure is tried; none if left out.

    Returns
    -------
    equation : NarxEquation
        Fitted on all training data.
    diagnostics : dict
        How it was chosen.

    Raises
    ------
    InputError
        No data, a constant displacement, differing sample intervals or inputs, or stretches that are too short.
    """
    span = float(np.ptp(operating_range(trajectories)))
    interval, inputs = trajectories[0].interval, trajectories[0].v.shape[1]
    if any(x.v.shape[1] != inputs or abs(x.interval / interval - 1) > 1e-3 for x in trajectories):
        raise InputError("the training logs differ in inputs or sample interval; a NARX model needs one interval")
    parts = [(b.fold, trajectories[b.source].part(b.start, b.stop)) for b in held_out_blocks(trajectories)]
    folds, fitted = sorted({fold for fold, _ in parts}), {}
    errors: dict[tuple[NarxStructure, int], FloatArray] = {}
    for shape in itertools.product(DEGREES, INCREMENTS, INPUT_LAGS):
        if most is not None and len(errors) >= most:
            break
        empty = _without_terms(NarxStructure(*shape, inputs), trajectories, squared)
        grams = [(fold, _gram(empty, x)) for fold, x in parts if len(x.t) > 2 + max(shape[1:])]
        paths = {f: _pursuit(empty, [g for fold, g in grams if fold != f or len(folds) == 1]) for f in folds}
        for terms in set(TERMS).intersection(*paths.values()):
            held_out = [[_error(paths[f][terms], x, span) for fold, x in parts if fold == f] for f in folds]
            errors[empty.structure, terms] = np.array([np.mean(values) for values in held_out])
        fitted[empty.structure] = _pursuit(empty, [gram for _, gram in grams])
    if not errors:
        raise InputError("the training stretches are too short for a NARX model; give longer logs")
    structure, terms = chosen = simplest_within_one_standard_error(errors, {key: key[1] for key in errors})
    return fitted[structure][terms], {
        "library_terms": len(structure.exponents()),
        "inner_validation_nrmse": float(errors[chosen].mean()),
        "inner_validation_nrmse_of_folds": errors[chosen],
        "candidates_tried": len(errors),
        "search_status": "completed" if len(fitted) == len(DEGREES) * len(INCREMENTS) * len(INPUT_LAGS) else "limit",
    }


def _without_terms(structure: NarxStructure, trajectories: Sequence[Trajectory], squared: bool) -> NarxEquation:
    """All candidate terms, no coefficients; variables are scaled by their largest magnitudes."""
    q, delta = (max(float(np.abs(np.diff(x.q, n)).max()) for x in trajectories) for n in (0, 1))
    u = np.max([np.abs(x.v).max(axis=0) for x in trajectories], axis=0) ** (2 if squared else 1)
    scales = np.concatenate([[q], np.full(structure.increments, delta), np.repeat(u, structure.input_lags)])
    scales[scales == 0.0] = 1.0
    low, high = escape_bounds(*operating_range(trajectories))
    interval = trajectories[0].interval
    return NarxEquation(structure, structure.exponents(), np.zeros(0), scales, interval, squared, low, high)


def _gram(equation: NarxEquation, x: Trajectory) -> FloatArray:
    theta, target, _ = equation.regression(x.q, x.v)
    rows = np.column_stack([theta, target])
    return rows.T @ rows


def _pursuit(empty: NarxEquation, grams: Sequence[FloatArray]) -> dict[int, NarxEquation]:
    """Equations of each number of terms, from the Gram matrices of [Θ y]: one pursuit for all; none without data."""
    if not grams:
        return {}
    gram = np.sum(grams, axis=0)
    norms = np.sqrt(np.diag(gram))
    norms[norms == 0.0] = 1.0
    gram = gram / np.outer(norms, norms)
    most = min(max(TERMS), int(np.linalg.matrix_rank(gram[:-1, :-1], hermitian=True)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # it says that it stopped early
        pursue = importlib.import_module("sklearn.linear_model").orthogonal_mp_gram
        path = pursue(gram[:-1, :-1], gram[:-1, -1], n_nonzero_coefs=most, return_path=True)
    path = np.reshape(path, (len(gram) - 1, -1)) * (norms[-1] / norms[:-1, None])
    # a path that ends early has left no residual to pick from: more terms would be the same equation
    columns = {terms: path[:, min(terms, path.shape[1]) - 1] for terms in TERMS}
    return {
        terms: replace(empty, exponents=empty.exponents[c != 0.0], coefficients=c[c != 0.0])
        for terms, c in columns.items()
    }


def _error(equation: NarxEquation, x: Trajectory, span: float) -> float:
    q, _ = narx_run(equation, x.v, float(x.q[0]), float(x.qdot[0]))
    return free_run_error(x.q, q, span)
