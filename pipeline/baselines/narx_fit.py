"""Fit of a polynomial NARX: terms picked by orthogonal matching pursuit, structure chosen by held-out free runs.

Forward selection by orthogonalised correlation is the FROLS of the NARMAX literature (Chen, Billings & Luo 1989,
doi:10.1080/00207178908953472), here scikit-learn's `orthogonal_mp_gram`.
"""

import importlib
import itertools
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.baselines.narx import NarxEquation, NarxStructure, first_step, lagged_variables, narx_run
from pipeline.baselines.polynomial_dynamics import monomials
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.least_squares import triangular_factor
from pipeline.scoring.cross_validation import (
    HeldOutBlock,
    free_run_error,
    held_out_blocks,
    simplest_within_one_standard_error,
)
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.free_run import escape_bounds

DEGREES = (3, 5, 7)
INCREMENTS = (1, 2, 3)
INPUT_LAGS = (1, 3)  # u_{n+1} alone, or u_{n+1}, u_n, u_{n−1}
TERMS = (4, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40, 50)


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
    search_status : {"completed", "limit"}
        What ended the search.
    """

    equation: NarxEquation
    fold_errors: FloatArray
    library_terms: int
    candidates_tried: int
    search_status: Literal["completed", "limit"]


def fit_narx(trajectories: Sequence[Trajectory], *, squared: bool = True, most: int | None = None) -> NarxFit:
    """Choose lags, degree and number of terms by free runs over held-out blocks of the training data.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches of one sample interval; only q and v are used.
    squared : bool
        Inputs v² or v.
    most : int, optional
        Candidates (a structure with a number of terms) after which no further structure is tried; none if left out.

    Raises
    ------
    InputError
        No data, a constant displacement, or differing sample intervals or inputs.
    """
    importlib.import_module("sklearn.linear_model")  # which is no part of the search time
    low, high = operating_range(trajectories)
    interval = trajectories[0].interval
    if len({x.v.shape[1] for x in trajectories}) != 1 or any(
        abs(x.interval / interval - 1) > 1e-3 for x in trajectories
    ):
        raise InputError("the training logs differ in inputs or sample interval; a NARX model needs one interval")
    blocks = held_out_blocks(trajectories)
    errors: dict[tuple[NarxStructure, int], FloatArray] = {}
    status: Literal["completed", "limit"] = "completed"
    for degree, increments, input_lags in itertools.product(DEGREES, INCREMENTS, INPUT_LAGS):
        if most is not None and len(errors) >= most:
            status = "limit"
            break
        structure = NarxStructure(degree, increments, input_lags, trajectories[0].v.shape[1])
        path = _validate(trajectories, blocks, structure, squared, high - low)
        errors |= {(structure, terms): e for terms, e in path.items()}
    if not errors:
        raise InputError("the training stretches are too short for a NARX model; give longer logs")
    chosen = simplest_within_one_standard_error(errors, {key: key[1] for key in errors})
    compressed = _compressed(trajectories, blocks, chosen[0], squared)
    equation = _equations(trajectories, compressed, chosen[0], squared, None, (chosen[1],))[chosen[1]]
    return NarxFit(equation, errors[chosen], len(chosen[0].exponents()), len(errors), status)


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
    compressed = _compressed(trajectories, blocks, structure, squared)
    for fold in folds:
        without = fold if len(folds) > 1 else None
        for terms, equation in _equations(trajectories, compressed, structure, squared, without, TERMS).items():
            parts = []
            for b in (b for b in blocks if b.fold == fold):
                x, rows = trajectories[b.source], slice(b.start, b.stop)
                q, _ = narx_run(equation, x.v[rows], float(x.q[b.start]), float(x.qdot[b.start]))
                parts.append(free_run_error(x.q[rows], q, span))
            errors.setdefault(terms, []).append(float(np.mean(parts)))
    return {terms: np.array(e) for terms, e in errors.items() if len(e) == len(folds)}


@dataclass(frozen=True)
class _Compressed:
    """Scales of the lagged variables, and of each block its fold and the triangular factor of its regression."""

    scales: FloatArray
    factors: list[tuple[int, FloatArray]]


def _compressed(
    trajectories: Sequence[Trajectory], blocks: list[HeldOutBlock], structure: NarxStructure, squared: bool
) -> _Compressed:
    raw = []
    for b in blocks:
        x = trajectories[b.source]
        if b.stop - b.start > first_step(structure) + 2:
            v = x.v[b.start : b.stop]
            raw.append((b.fold, lagged_variables(structure, x.q[b.start : b.stop], np.square(v) if squared else v)))
    scales = np.max([np.abs(x).max(axis=0) for _, (x, _) in raw], axis=0) if raw else np.ones(0)
    scales[scales == 0.0] = 1.0
    exponents = structure.exponents()
    rows = ((fold, np.column_stack([monomials(exponents, x / scales), y])) for fold, (x, y) in raw)
    return _Compressed(scales, [(fold, triangular_factor([block])[0]) for fold, block in rows])


def _equations(
    trajectories: Sequence[Trajectory],
    compressed: _Compressed,
    structure: NarxStructure,
    squared: bool,
    without: int | None,
    terms: Sequence[int],
) -> dict[int, NarxEquation]:
    """Equations of the given numbers of terms, fitted on all blocks but those of one fold: one pursuit for all."""
    used = [factor for fold, factor in compressed.factors if fold != without]
    if not used:
        return {}
    factor, _ = triangular_factor([np.vstack(used)])
    exponents, scales = structure.exponents(), compressed.scales
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
