"""NARX: `narx`, a polynomial difference equation at the sample interval of the log, as a black box to compare with.

    δ_{n+1} − δ_n = Σ_p c_p θ_p(q_n, δ_n, …, δ_{n−L+1}, u_{n+1}, u_n, …),   δ_n = q_n − q_{n−1}

Written in increments δ the equation spans the same polynomials as q_{n+1} = f(q_n, q_{n−1}, …, u_{n+1}, u_n, …), and
is well conditioned where neighbouring samples are nearly equal. A free run uses its own past displacements.

**Estimation.** Terms are picked by forward selection, the FROLS of the NARMAX literature (Chen, Billings & Luo 1989,
doi:10.1080/00207178908953472), as scikit-learn's `orthogonal_mp_gram`. Degree, number of lags and number of terms are
the simplest within one standard error of the least error of free runs on held-out blocks.
"""

import itertools
import warnings
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import model_validator

from ..device.device import Device
from ..errors import InputError
from ..numerics.arrays import FloatArray, IntArray, sample_interval
from ..numerics.compiled import compiled
from ..numerics.fixed_step import escape_bounds, run_status
from ..numerics.linear_filters import finite_difference
from ..scoring.cross_validation import free_run_error, held_out_blocks, simplest_within_one_standard_error
from ..signals.log import Log, operating_range
from .base import FreeRun, checked
from .model_file import (
    MOST_INPUTS,
    Exponents,
    ModelFile,
    Positive,
    PositiveRow,
    Sizes,
    Span,
    Table,
    Unit,
)
from .model_type import ModelType
from .polynomial_dynamics import monomials

MOST_LAGS = 64
"""Increments, or lags of an input."""
COUPLING_DEGREE = 3  # degree in q of the factors of older increments and inputs
DEGREES, INCREMENTS, INPUT_LAGS = (3, 5, 7), (1, 2, 3), (1, 3)  # u_{n+1} alone, or u_{n+1}, u_n, u_{n−1}
TERMS = (4, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40, 50)
Shape = tuple[int, int, int]
"""Total degree in q_n and δ_n, increments L, and lags M of each input: u_{n+1} … u_{n+2−M}. The newest may be used:
inputs are measured, not predicted."""


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
def _run(
    exponents: IntArray,
    coefficients: FloatArray,
    scales: FloatArray,
    bounds: FloatArray,
    u: FloatArray,
    q: FloatArray,
    delta: FloatArray,
    begin: int,
) -> int:
    """Fill q behind row `begin`, which follows the increments `delta`; return the first row out of bounds, or N."""
    older = len(delta)
    x = np.empty(len(scales))
    for n in range(begin, len(q)):
        if not bounds[0] <= q[n] <= bounds[1]:
            q[n] = np.nan
            return n
        x[0] = q[n] / scales[0]
        for i in range(older):
            x[1 + i] = delta[i] / scales[1 + i]
        for i in range(u.shape[1]):
            x[1 + older + i] = u[n, i] / scales[1 + older + i]
        change = delta[0] + _change(exponents, coefficients, x)
        for i in range(older - 1, 0, -1):
            delta[i] = delta[i - 1]
        delta[0] = change
        if n + 1 < len(q):
            q[n + 1] = q[n] + change
    return len(q)


def _check_interval(t: FloatArray, interval: float, name: str) -> None:
    """Refuse a record whose sample interval differs by more than a thousandth from that of a model [s].

    Raises
    ------
    InputError
        It does.
    """
    given = sample_interval(t)
    if abs(given / interval - 1.0) > 1e-3:
        raise InputError(f"the model {name} steps at {interval:g} s, the record at {given:g} s; resample the log")


class NarxModel(ModelFile):
    """A difference equation for q at a fixed sample interval, and its file.

    P terms of X = 1 + L + K·M variables: q, L increments δ of it, and M lags of each of the K inputs.
    """

    sizes: ClassVar[Sizes] = {"P": (1, 500), "X": (2, 1 + MOST_LAGS * (1 + MOST_INPUTS))}
    name: ClassVar[str] = "narx"
    fine_voltages: ClassVar[bool] = False
    structure: Annotated[IntArray, Table("4", 0, MOST_LAGS, whole=True)]
    """Degree, increments L, lags M of the inputs, number K of inputs."""
    exponents: Exponents
    """Powers of the scaled variables, a row for each monomial."""
    coefficients: Annotated[FloatArray, Table("P"), Unit("{q}")]
    """Weights of the terms in the next increment of q."""
    scales: Annotated[PositiveRow, Unit("SI")]
    """Scale of each variable: displacement, increments, inputs."""
    interval_s: Annotated[Positive, Unit("s")]
    """Sample interval of the equation."""
    inputs: Literal["squared", "linear"]
    """Action of the inputs: squared or linear."""
    bounds: Annotated[Span, Unit("{q}")]
    """Smallest and largest displacement, beyond which a run counts as diverged."""

    @model_validator(mode="after")
    def _lags(self) -> Self:
        _, increments, input_lags, inputs = self.structure.tolist()
        if increments < 1 or not 1 <= inputs <= MOST_INPUTS or len(self.scales) != 1 + increments + inputs * input_lags:
            raise ValueError(f"structure {self.structure.tolist()} does not fit the {len(self.scales)} variables")
        return self

    @property
    def input_count(self) -> int:
        """Number of voltages that it takes."""
        return int(self.structure[3])

    @checked
    def simulate(self, t: FloatArray, v: FloatArray, q0: float, qdot0: float) -> FreeRun:
        """Free run; see `pipeline.models.base.DynamicModel.simulate`.

        Inputs are taken at the samples. q̇ and q̈ are differences of sixth order of the simulated q.

        Raises
        ------
        InputError
            The record has another sample interval than the equation.
        """
        _check_interval(t, self.interval_s, self.name)
        q, reached = self.run(v, np.array([q0]), qdot0)
        qdot, qddot = np.full((2, q.size), np.nan)
        qdot[:reached] = finite_difference(q[:reached], self.interval_s, 1)
        qddot[:reached] = finite_difference(q[:reached], self.interval_s, 2)
        return FreeRun(t, q, qdot, qddot, *run_status(t, reached))

    def predict(
        self, t: FloatArray, v: FloatArray, seen: FloatArray, speed: FloatArray, starts: IntArray, ahead: IntArray
    ) -> Iterator[FloatArray]:
        """Predictions from the measured past that the equation looks at; see `pipeline.models.base.Predicts`."""
        _check_interval(t, self.interval_s, self.name)
        reach = int(self.structure.max())
        unmeasured = np.maximum.accumulate(np.where(np.isfinite(seen), -1, np.arange(len(seen))))
        for start, count in zip(starts.tolist(), ahead.tolist(), strict=True):
            first = max(int(unmeasured[start]) + 1, start - reach)
            run, _ = self.run(v[first : start + count + 1], seen[first : start + 1], float(speed[start]))
            yield run[start - first :]

    def run(self, v: FloatArray, seen: FloatArray, qdot0: float) -> tuple[FloatArray, int]:
        """Free run at the equation's own sample interval; before the seen samples q follows a parabola of slope q̇0.

        Its bend is the acceleration that the equation itself gives, so that increments, which are velocities half a
        sample earlier, start without that lag.

        Parameters
        ----------
        v : FloatArray, shape (N, K)
            Inputs at the samples [V].
        seen : FloatArray, shape (M,)
            Displacement [m] of the first M samples; the run begins at the last of them.
        qdot0 : float
            Velocity [m/s] there.

        Returns
        -------
        q : FloatArray, shape (N,)
            NaN after a divergence, and before the run begins.
        reached : int
            Samples within the bounds. Cost: one evaluation of P monomials per sample, about 2 ns per factor.
        """
        q = np.full(len(v), np.nan)
        first = float(qdot0) * self.interval_s
        begin = len(seen) - 1
        u = self._lagged(v)
        ages = np.arange(self.structure[1])
        q[begin] = seen[-1]
        x = np.concatenate([seen[-1:], np.full(ages.size, first), u[begin]]) / self.scales
        delta = np.array(first - (ages + 0.5) * _change(self.exponents, self.coefficients, x), dtype=np.float64)
        past = np.diff(seen)[::-1][: ages.size]
        delta[: past.size] = past
        return q, int(_run(self.exponents, self.coefficients, self.scales, self.bounds, u, q, delta, begin))

    def _lagged(self, v: FloatArray) -> FloatArray:
        """Inputs that act at each step, shape (N, K·M); lags beyond the record repeat its ends."""
        u = np.square(v) if self.inputs == "squared" else v
        rows = np.clip(np.arange(1, len(u) + 1)[:, None] - np.arange(self.structure[2]), 0, len(u) - 1)
        return np.hstack([column[rows] for column in u.T])

    def describe(self) -> dict[str, Any]:
        """Structure and how it was chosen."""
        degree, increments, input_lags, _ = self.structure.tolist()
        return {
            "structure": "polynomial NARX",
            "sample_interval_s": self.interval_s,
            "degree": degree,
            "past_displacements": increments + 1,
            "input_lags": input_lags,
            "terms_kept": len(self.exponents),
            **self.diagnostics,
        }


def identify_narx(trajectories: Sequence[Log], plant: Device, *, most: int | None = None) -> NarxModel:
    """Choose lags, degree and number of terms by free runs over held-out blocks of the training data.

    Parameters
    ----------
    trajectories : sequence of Log
        Gap-free segments of the training logs, all of one sample interval; only q and v are used.
    plant : Device
        Action of the inputs.
    most : int, optional
        Candidates (a structure with a number of terms) after which no further structure is tried; none if left out.

    Raises
    ------
    InputError
        No data, a constant displacement, differing sample intervals or inputs, or segments that are too short.
    """
    span = float(np.ptp(operating_range(trajectories)))
    first = trajectories[0]
    if any(x.v.shape[1] != first.v.shape[1] or abs(x.interval / first.interval - 1) > 1e-3 for x in trajectories):
        raise InputError("the training logs differ in inputs or sample interval; a NARX model needs one interval")
    parts = [(b.fold, trajectories[b.source].part(b.start, b.stop)) for b in held_out_blocks(trajectories)]
    folds = sorted({fold for fold, _ in parts})
    fitted = dict[Shape, dict[int, NarxModel]]()
    errors: dict[tuple[Shape, int], FloatArray] = {}
    for shape in itertools.product(DEGREES, INCREMENTS, INPUT_LAGS):
        if most is not None and len(errors) >= most:
            break
        library = _library(shape, trajectories, plant)
        grams = [(fold, _gram(library, x)) for fold, x in parts if len(x.t) > 2 + max(shape[1:])]
        paths = {f: _pursuit(library, [g for fold, g in grams if fold != f or len(folds) == 1]) for f in folds}
        for terms in set(TERMS).intersection(*paths.values()):
            held_out = [[_error(paths[f][terms], x, span) for fold, x in parts if fold == f] for f in folds]
            errors[shape, terms] = np.array([np.mean(values) for values in held_out])
        fitted[shape] = _pursuit(library, [gram for _, gram in grams])
    if not errors:
        raise InputError("the training segments are too short for a NARX model; give longer logs")
    shape, terms = chosen = simplest_within_one_standard_error(errors, {key: key[1] for key in errors})
    diagnostics = {
        "library_terms": len(_library(shape, trajectories, plant).exponents),
        "inner_validation_nrmse": float(errors[chosen].mean()),
        "inner_validation_nrmse_of_folds": errors[chosen],
        "candidates_tried": len(errors),
        "search_status": "completed" if len(fitted) == len(DEGREES) * len(INCREMENTS) * len(INPUT_LAGS) else "limit",
    }
    return fitted[shape][terms].model_copy(update={"diagnostics": diagnostics})


def _library(shape: Shape, trajectories: Sequence[Log], plant: Device) -> NarxModel:
    """All terms poly_degree(q_n, δ_n), poly3(q_n)⊗(older δ), poly3(q_n)⊗(inputs), without weights.

    Variables are scaled by their largest magnitudes.
    """
    degree, increments, input_lags = shape
    q, delta = (max(float(np.abs(np.diff(x.q, n)).max()) for x in trajectories) for n in (0, 1))
    u = plant.acting(np.max([np.abs(x.v).max(axis=0) for x in trajectories], axis=0))
    scales = np.concatenate([[q], np.full(increments, delta), np.repeat(u, input_lags)])
    scales[scales == 0.0] = 1.0
    powers = [{0: i, 1: j} for i in range(degree + 1) for j in range(degree + 1 - i)]
    powers += [{0: i, k: 1} for k in range(2, scales.size) for i in range(COUPLING_DEGREE + 1)]
    return NarxModel(
        structure=np.array([*shape, u.size]),
        exponents=np.array([[p.get(k, 0) for k in range(scales.size)] for p in powers]),
        coefficients=np.zeros(len(powers)),
        scales=scales,
        interval_s=trajectories[0].interval,
        inputs=plant.action,
        bounds=np.array(escape_bounds(*operating_range(trajectories))),
    )


def _gram(library: NarxModel, x: Log) -> FloatArray:
    """Gram matrix of [Θ y]: the terms and the targets of the steps whose lags lie in the record."""
    _, increments, input_lags, _ = library.structure.tolist()
    n = np.arange(max(increments, input_lags - 2), len(x.q) - 1)
    delta = np.diff(x.q, prepend=x.q[0])
    variables = np.column_stack([x.q[n], *(delta[n - j] for j in range(increments)), library._lagged(x.v)[n]])
    rows = np.column_stack([monomials(library.exponents, variables / library.scales), delta[n + 1] - delta[n]])
    return np.asarray(rows.T @ rows)


def _pursuit(library: NarxModel, grams: Sequence[FloatArray]) -> dict[int, NarxModel]:
    """Equations of each number of terms, from the Gram matrices of [Θ y]: one pursuit for all; none without data."""
    from sklearn.linear_model import orthogonal_mp_gram

    if not grams:
        return {}
    gram = np.sum(grams, axis=0)
    norms = np.sqrt(np.diag(gram))
    norms[norms == 0.0] = 1.0
    gram = gram / np.outer(norms, norms)
    most = min(max(TERMS), int(np.linalg.matrix_rank(gram[:-1, :-1], hermitian=True)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # it says that it stopped early
        path = orthogonal_mp_gram(gram[:-1, :-1], gram[:-1, -1], n_nonzero_coefs=most, return_path=True)
    path = np.reshape(path, (len(gram) - 1, -1)) * (norms[-1] / norms[:-1, None])
    # a path that ends early has left no residual to pick from: more terms would be the same equation
    columns = {terms: path[:, min(terms, path.shape[1]) - 1] for terms in TERMS}
    return {
        terms: library.model_copy(update={"exponents": library.exponents[c != 0.0], "coefficients": c[c != 0.0]})
        for terms, c in columns.items()
    }


def _error(model: NarxModel, x: Log, span: float) -> float:
    return free_run_error(x.q, model.run(x.v, x.q[:1], float(x.qdot[0]))[0], span)


NARX = ModelType(
    lambda data: identify_narx(data.segments, data.device, most=data.compare.candidates),
    NarxModel,
)
