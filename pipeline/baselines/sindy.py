"""Sparse identification of the acceleration with q̇ = v kept, the treatment chosen by free runs over held-out blocks.

Beside it pysindy as it comes: default library, optimiser and differentiation, nothing fixed and nothing tuned.
"""

import importlib
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from pipeline.baselines.polynomial_dynamics import (
    FIRST_INPUT,
    LAG,
    QDOT,
    PolynomialDynamics,
    Q,
    free_run,
    lag_state,
    monomials,
    scaled_variables,
)
from pipeline.baselines.sindy_problem import Library, Problem, compressed_library, prepare_problem
from pipeline.baselines.sparse_regression import Optimizer, sign_rows, sparse_coefficients
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.least_squares import pseudo_inverse_fit, triangular_factor
from pipeline.numerics.metrics import rms
from pipeline.scoring.cross_validation import (
    free_run_error,
    simplest_within_one_standard_error,
)
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.free_run import escape_bounds

SearchStatus = Literal["completed", "limit"]
LAG_TIMES = (0.0, 0.02, 0.1, 0.5)  # s; T_z to try, 0 is "without the lag state"
DEGREES = (3, 5, 7)
START_THRESHOLD = 0.05
FILTER_TIMES = (0.0, 0.04, 0.16)  # s, standard deviation of the Gaussian that both sides are filtered with
THRESHOLDS = (0.0, 0.02, 0.05, 0.1, 0.2, 0.4)
_SHORTEST_LAG, _WHOLE = (
    0.25,
    1.0 - 1e-6,
)  # of a sample interval: a lag that is seen in samples, and all but for rounding
ENSEMBLE_THRESHOLDS = (0.1, 0.2)  # each costs 80 fits


@dataclass(frozen=True)
class Candidate:
    """One treatment: library, filter, optimiser and threshold.

    A filter applied to every candidate term and to the acceleration alike leaves the coefficients as they are and takes
    the noise of the second derivative away: the weak form of the equation with a Gaussian test function (Messenger &
    Bortz 2021, doi:10.1137/20M1343166). The threshold is relative: variables are scaled to a largest magnitude of 1 and
    the filtered acceleration to an RMS of 1, so a term is dropped if at the edge of the data it contributes less than
    `threshold` of that RMS.
    """

    library: Library
    filter_time: float
    optimizer: Optimizer
    threshold: float


@dataclass(frozen=True)
class SindyFit:
    """The chosen equation and how it was chosen.

    Attributes
    ----------
    dynamics : PolynomialDynamics
        Sparse right-hand side.
    candidate : Candidate
        The treatment chosen.
    fold_errors : FloatArray, shape (folds,)
        Free-run NRMSE of q on the held-out blocks; 1 stands for a run that diverged or missed everything.
    candidates_tried : int
        Size of the search.
    search_status : {"completed", "limit"}
        What ended it.
    library_terms, rank : int
        Columns and numerical rank of the scaled library on all training data.
    condition_number : float
        Of the scaled library.
    acceleration_residual : float
        RMS of the regression residual over the RMS of q̈.
    """

    dynamics: PolynomialDynamics
    candidate: Candidate
    fold_errors: FloatArray
    candidates_tried: int
    search_status: SearchStatus
    library_terms: int
    rank: int
    condition_number: float
    acceleration_residual: float


class _LimitReachedError(Exception):
    """The search has tried as many candidates as it may."""


def fit_sindy(
    trajectories: Sequence[Trajectory],
    *,
    squared: bool = True,
    angle: bool = False,
    most: int | None = None,
) -> SindyFit:
    """Fit the acceleration by the best fair treatment, chosen on the training data only.

    A coordinate search: lag time, friction and filter, then the library, then optimiser and threshold. Each
    candidate is fitted on all blocks but one and simulated freely over the block left out, from its measured first
    state. Of the candidates within one standard error of the best, the one with the fewest terms is taken (Breiman's
    rule) and refitted on everything.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches; all with the same inputs.
    squared : bool
        Inputs v² (electrostatic) or v.
    angle : bool
        Whether q is an angle [rad]: libraries of sin q and cos q are tried too.
    most : int, optional
        Candidates after which the search ends with what it has tried; it ends by itself if left out. Counted, so that
        no machine decides.

    Raises
    ------
    InputError
        No data, differing inputs, or a constant displacement.
    """
    importlib.import_module("pysindy")  # which is no part of the search time
    problem = prepare_problem(trajectories, squared)
    errors: dict[Candidate, FloatArray] = {}
    terms: dict[Candidate, int] = {}

    def error(candidate: Candidate) -> float:
        """Mean error over the folds, computed once for each candidate."""
        if candidate not in errors:
            if most is not None and len(errors) >= most:
                raise _LimitReachedError
            errors[candidate], terms[candidate] = _cross_validate(problem, candidate, np.random.default_rng(0))
        return float(errors[candidate].mean())

    status: SearchStatus = "completed"
    try:
        _search(error, angle, max(x.interval for x in trajectories))
    except _LimitReachedError:
        status = "limit"
    chosen = simplest_within_one_standard_error(errors, terms)
    return _refit(problem, chosen, errors[chosen], (len(errors), status), np.random.default_rng(0))


def _search(error: Callable[[Candidate], float], angle: bool, interval: float) -> None:
    """Try candidates in order of promise; each stage keeps the best of the one before.

    A lag far shorter than the sample interval [s] is over between two samples: its state and the velocity differ by the
    acceleration alone, which is what is sought. And a filter shorter than that does nothing.
    """
    lags = [lag for lag in LAG_TIMES if lag == 0.0 or lag >= _SHORTEST_LAG * interval]
    filters = [width for width in FILTER_TIMES if width == 0.0 or width >= _WHOLE * interval]

    def best_of(treatments: Iterable[tuple[Library, float]]) -> tuple[Library, float]:
        """The library and filter time of least held-out error."""
        return min(treatments, key=lambda pair: error(Candidate(pair[0], pair[1], "STLSQ", START_THRESHOLD)))

    library, filter_time = best_of(
        (Library(shape, 5, False, friction, lag), width)
        for shape in (("polynomial", "trigonometric") if angle else ("polynomial",))
        for lag in lags
        for friction in (False, True)
        for width in filters
    )
    shapes = [
        replace(library, degree=degree, full=full, friction=friction, coupling=coupling)
        for degree in DEGREES
        for full in (False, True)
        for friction in (False, True)
        for coupling in (0, 3)
    ]
    best = best_of((shape, filter_time) for shape in [library, *shapes])
    for threshold in THRESHOLDS:
        error(Candidate(best[0], best[1], "STLSQ", threshold))
    for threshold in THRESHOLDS:
        error(Candidate(best[0], best[1], "constrained", threshold))
    for threshold in THRESHOLDS[2:]:
        error(Candidate(best[0], best[1], "SR3", threshold))
    for threshold in ENSEMBLE_THRESHOLDS:
        error(Candidate(best[0], best[1], "ensemble", threshold))


def _fitted(
    problem: Problem, candidate: Candidate, without: int | None, rng: np.random.Generator
) -> PolynomialDynamics:
    """Fit a candidate on all folds, or on all but one."""
    factors = compressed_library(problem, candidate.library, candidate.filter_time)
    exponents = candidate.library.exponents(problem.inputs)
    used = factors.without(problem.windows, without, whole=candidate.optimizer != "ensemble")

    def signs() -> FloatArray:
        """What the constrained optimizer obeys."""
        return sign_rows(exponents, problem.scales, operating_range(problem.trajectories), (problem.low, problem.high))

    coefficients = sparse_coefficients(used, candidate.optimizer, candidate.threshold, rng, signs)
    kept = np.flatnonzero(coefficients)
    velocity = np.zeros((1, exponents.shape[1]), dtype=np.int64)
    velocity[0, QDOT] = 1
    table = np.zeros((2, kept.size + 1))
    table[0, 0] = problem.scales[QDOT]  # q̇ = v, not regressed
    lag_time = candidate.library.lag_time if exponents[kept][:, LAG].any() else 0.0
    table[1, 1:] = coefficients[kept] * factors.scale
    return PolynomialDynamics(
        np.vstack([velocity, exponents[kept]]), table, problem.scales, lag_time,
        problem.squared, problem.low, problem.high,
    )  # fmt: skip


def _cross_validate(problem: Problem, candidate: Candidate, rng: np.random.Generator) -> tuple[FloatArray, int]:
    """Free-run NRMSE of q for each held-out fold, and the most terms that any fold kept."""
    low, high = operating_range(problem.trajectories)
    folds: list[int | None] = [*problem.folds] if len(problem.folds) > 1 else [None]
    windows = compressed_library(problem, candidate.library, candidate.filter_time).windows
    errors, terms = [], 0
    for fold in folds:
        if not any(parts for w, parts in zip(problem.windows, windows, strict=True) if w.fold != fold):
            return np.ones(len(folds)), len(candidate.library.exponents(problem.inputs))  # shorter than the filter
        dynamics = _fitted(problem, candidate, fold, rng)
        terms = max(terms, len(dynamics.exponents) - 1)
        parts = []
        for w in problem.windows:
            if fold is None or w.fold == fold:
                x, rows = problem.trajectories[w.source], slice(w.start, w.stop)
                path, _ = free_run(dynamics, x.v[rows], x.interval, float(x.q[w.start]), float(x.qdot[w.start]))
                parts.append(free_run_error(x.q[rows], path[:, 0], high - low))
        errors.append(float(np.mean(parts)))
    return np.array(errors), terms


def _refit(
    problem: Problem,
    chosen: Candidate,
    errors: FloatArray,
    search: tuple[int, SearchStatus],
    rng: np.random.Generator,
) -> SindyFit:
    dynamics = _fitted(problem, chosen, None, rng)
    blocks = (
        f.copy() for parts in compressed_library(problem, chosen.library, chosen.filter_time).windows for f in parts
    )
    library = pseudo_inverse_fit(triangular_factor(blocks)[0], sum(len(x.t) for x in problem.trajectories))
    error = np.concatenate([_residual(problem, x, dynamics) for x in problem.trajectories])
    return SindyFit(
        dynamics, chosen, errors, *search, library.weights.size, library.rank, library.condition,
        rms(error) / problem.acceleration_scale,
    )  # fmt: skip


def _residual(problem: Problem, x: Trajectory, dynamics: PolynomialDynamics) -> FloatArray:
    """Measured minus modelled acceleration along a measured path."""
    z = lag_state(x.qdot, x.interval, dynamics.lag_time)
    variables = scaled_variables(problem.scales, problem.squared, x.v, x.q, x.qdot, z)
    residual: FloatArray = x.qddot - monomials(dynamics.exponents, variables) @ dynamics.coefficients[1]
    return residual


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
    with warnings.catch_warnings():
        # "all coefficients eliminated" is what the table then shows
        warnings.simplefilter("ignore", UserWarning)
        model.fit(
            [np.column_stack([x.q, x.qdot]) / length for x in trajectories],
            t=trajectories[0].interval,
            u=[(np.square(x.v) if squared else x.v) / input_scale for x in trajectories],
        )
    powers = np.asarray(model.feature_library.powers_, dtype=np.int64)
    exponents = np.zeros((len(powers), FIRST_INPUT + inputs), dtype=np.int64)
    exponents[:, [Q, QDOT, *range(FIRST_INPUT, FIRST_INPUT + inputs)]] = powers
    scales = np.array([length, length, length, 1.0, 1.0, 1.0, *[input_scale] * inputs])
    coefficients = length * np.asarray(model.coefficients(), dtype=np.float64)
    used = np.any(coefficients != 0.0, axis=0)
    return PolynomialDynamics(exponents[used], coefficients[:, used], scales, 0.0, squared, *escape_bounds(low, high))
