"""SINDy by pysindy: weak form and sparse regression are its estimators; ours is the choice, by held-out free runs.

Beside it pysindy as it comes: default library, optimiser and differentiation, nothing fixed and nothing tuned.
"""

import importlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from pipeline.baselines.polynomial_dynamics import (
    FIRST_INPUT,
    QDOT,
    Lag,
    PolynomialDynamics,
    Q,
    free_run,
    scaled_variables,
)
from pipeline.baselines.weak_form import admitted, seeded, weak_rows
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.least_squares import triangular_factor
from pipeline.numerics.metrics import rms
from pipeline.scoring.cross_validation import NEGLIGIBLE, HeldOutBlock, free_run_error, held_out_blocks
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.free_run import escape_bounds

SearchStatus = Literal["completed", "limit"]

LAG_SETS = ((), (1.0, 8.0), (2.0, 16.0), (1 / 3, 2.0, 8.0))
"""Lag times to try, over the time scale of the motion (RMS q̇ over RMS q̈: 60 ms for the joint)."""
MOST_INPUT_LAGS = 2
"""Of a set whose inputs are lagged, too: more terms than a log of this length decides."""
DEGREES = ((1, 0, 0), (3, 1, 1), (5, 2, 3), (7, 3, 4))
"""Highest power of q alone, as a factor of velocities and lags, and as a factor of inputs."""
TURNING = ((1, 0, 0), (1, 1, 1))
"""The same where sin q and cos q stand in the place of powers."""
THRESHOLDS = (0.01, 0.03, 0.1)
LEAST_THRESHOLD = 1e-3
RIDGE = 1e-6
TEST_FUNCTIONS = 1000
"""In all training data together. They bound the cost, and overlap more than twice on the paper's log."""
LEAST_SAMPLES = 2
"""Sample intervals in half a test function."""
STEPS, MOST_ROWS = 30, 60_000
"""Steps of the grid in half a test function, unless voltages are known more finely, and its most rows."""
EQUAL = 1.05
"""Of candidates whose held-out errors are within this factor of the lowest, the one with the fewest terms is taken."""
SLOW = 0.05
"""Speed w of the smoothed friction tanh(q̇/w), over the largest speed."""
_SHORTEST_LAG = 0.25
"""Of a sample interval: a lag that is seen in samples."""


@dataclass(frozen=True)
class Library:
    """What may enter the equation of the acceleration.

    Attributes
    ----------
    degrees : (int, int, int)
        Highest power of q alone, as a factor of velocities and lags, and as a factor of inputs.
    turning : bool
        Whether 1, sin q and cos q stand in the place of the powers of q (an angle).
    friction : bool
        A smoothed dry friction tanh(q̇/w).
    lags : tuple of float
        Times [s] of first-order lags of the velocity.
    lagged_inputs : bool
        Whether the inputs enter lagged, too.
    """

    degrees: tuple[int, int, int]
    turning: bool
    friction: bool
    lags: tuple[float, ...]
    lagged_inputs: bool

    def __str__(self) -> str:
        """E.g. ``poly7(q) + poly3(q)·(q̇, z[0.06 s]) + poly4(q)·u + tanh q̇``."""
        z = "".join(f", z[{lag:.2g} s]" for lag in self.lags)
        u = "".join(f", u[{lag:.2g} s]" for lag in self.lags if self.lagged_inputs)
        alone, moving, driven = (f"poly{degree}(q)" for degree in self.degrees)
        if self.turning:
            alone, moving, driven = ("(1, sin q, cos q)" if degree else "1" for degree in self.degrees)
        friction = " + tanh q̇" if self.friction else ""
        return f"{alone} + {moving}·(q̇{z}{u}) + {driven}·u{friction}"


@dataclass(frozen=True)
class Candidate:
    """One treatment: library and threshold of pysindy's STLSQ.

    Terms and acceleration are scaled to length 1 before the regression, so a term is dropped where it contributes less
    than `threshold` of the acceleration.
    """

    library: Library
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
    half_width : float
        Of the test functions [s].
    errors : dict of Candidate to FloatArray, shape (folds,)
        Free-run NRMSE of q on the held-out blocks of every candidate; 1 stands for a run that diverged or missed
        everything.
    search_status : {"completed", "limit"}
        What ended the search.
    library_terms, rank : int
        Columns and numerical rank of the scaled library on all training data.
    condition_number : float
        Of the scaled library.
    acceleration_residual : float
        RMS of the regression's residual over the RMS of its target.
    """

    dynamics: PolynomialDynamics
    candidate: Candidate
    half_width: float
    errors: dict[Candidate, FloatArray]
    search_status: SearchStatus
    library_terms: int
    rank: int
    condition_number: float
    acceleration_residual: float


@dataclass(frozen=True)
class Problem:
    """The training data as rows of the weak form, of every candidate term and every held-out block.

    Attributes
    ----------
    trajectories : sequence of Trajectory
        Gap-free stretches.
    blocks : list of HeldOutBlock
        Their parts; `rows` and `targets` have an entry for each, of shapes (K, P) and (K,).
    exponents : IntArray, shape (P, V)
        The candidate terms.
    empty : PolynomialDynamics
        Scales, all lags and bounds, without terms.
    """

    trajectories: Sequence[Trajectory]
    blocks: list[HeldOutBlock]
    rows: list[FloatArray]
    targets: list[FloatArray]
    exponents: IntArray
    empty: PolynomialDynamics
    span: float
    time_scale: float
    half_width: float

    def columns(self, library: Library) -> IntArray:
        """Places of the library's terms."""
        inputs, first = self.empty.inputs, self.empty.scales.size
        lags = {
            first + k
            for k, lag in enumerate(self.empty.lags)
            if lag.time in library.lags and (lag.source == QDOT or library.lagged_inputs)
        }
        return admitted(self.exponents, inputs, library.degrees, library.friction, library.turning, lags)

    def without(self, fold: int | None) -> tuple[FloatArray, FloatArray]:
        """The regression on all blocks but those of a fold."""
        used = [i for i, block in enumerate(self.blocks) if block.fold != fold]
        return np.concatenate([self.rows[i] for i in used]), np.concatenate([self.targets[i] for i in used])


class _LimitReachedError(Exception):
    """The search has tried as many candidates as it may."""


def fit_sindy(
    trajectories: Sequence[Trajectory], *, squared: bool = True, angle: bool = False, most: int | None = None
) -> SindyFit:
    """Fit the acceleration by pysindy's weak form, treated as held-out parts of the training data decide.

    A coordinate search: lags, then the library, then the threshold. Each candidate is fitted on all blocks but
    one and simulated freely over the block left out, from its measured first state. Of the candidates whose mean
    error is within a twentieth of the lowest, the one with the fewest terms is taken and refitted on everything.

    Parameters
    ----------
    trajectories : sequence of Trajectory
        Gap-free training stretches, all with the same inputs; voltages as finely as they are known.
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
        No data, differing inputs, a constant displacement, or stretches that are too short.
    """
    problem = prepare_problem(trajectories, squared, angle)
    errors: dict[Candidate, FloatArray] = {}
    terms: dict[Candidate, int] = {}

    def error(candidate: Candidate) -> float:
        """Mean error over the folds, computed once for each candidate."""
        if candidate not in errors:
            if most is not None and len(errors) >= most:
                raise _LimitReachedError
            errors[candidate], terms[candidate] = _cross_validate(problem, candidate)
        return float(errors[candidate].mean())

    status: SearchStatus = "completed"
    try:
        _search(error, angle, problem)
    except _LimitReachedError:
        status = "limit"
    means = {candidate: float(values.mean()) for candidate, values in errors.items()}
    limit = max(EQUAL * min(means.values()), NEGLIGIBLE)
    chosen = min((c for c in means if means[c] <= limit), key=lambda c: (terms[c], means[c]))
    return _refit(problem, chosen, errors, status)


def _search(error: Callable[[Candidate], float], angle: bool, problem: Problem) -> None:
    """Try candidates in order; each stage keeps the best of the one before."""
    present = {lag.time for lag in problem.empty.lags}
    sets = [tuple(ratio * problem.time_scale for ratio in ratios) for ratios in LAG_SETS]
    sets = [times for times in sets if present.issuperset(times)]

    def best_of(libraries: Iterable[Library]) -> Library:
        """The library of least held-out error."""
        return min(libraries, key=lambda library: error(Candidate(library, LEAST_THRESHOLD)))

    shapes = [(degrees, False) for degrees in DEGREES] + [(degrees, True) for degrees in TURNING if angle]
    library = best_of(
        Library(*shape, True, times, lagged)
        for shape in shapes[1::2]
        for times in sets
        for lagged in ((False, True) if 0 < len(times) <= MOST_INPUT_LAGS else (False,))
    )
    library = best_of(
        replace(library, degrees=degrees, turning=turning, friction=friction)
        for degrees, turning in shapes
        for friction in (False, True)
    )
    for threshold in THRESHOLDS:
        error(Candidate(library, threshold))


def prepare_problem(trajectories: Sequence[Trajectory], squared: bool, angle: bool) -> Problem:
    """Every candidate term in weak form.

    Raises
    ------
    InputError
        No data, differing inputs, a constant displacement, or stretches that are too short.
    """
    low, high = operating_range(trajectories)
    if len({x.v.shape[-1] for x in trajectories}) != 1:
        raise InputError("the training logs differ in their number of inputs; identify them apart")
    speed = max(float(np.abs(x.qdot).max()) for x in trajectories) or 1.0
    volts = np.max([np.abs(x.v).reshape(-1, x.v.shape[-1]).max(axis=0) for x in trajectories], axis=0)
    scales = np.array([max(abs(low), abs(high)), speed, SLOW * speed, 1.0, 1.0, *(volts**2 if squared else volts)])
    scales[scales == 0.0] = 1.0  # an input that is never used: its columns are zero whatever the scale
    acceleration = rms(np.concatenate([x.qddot for x in trajectories]))
    interval = max(x.interval for x in trajectories)
    time_scale = rms(np.concatenate([x.qdot for x in trajectories])) / acceleration if acceleration else interval
    followed = (QDOT, *range(FIRST_INPUT, scales.size))
    times = [time_scale * ratio for ratio in sorted({ratio for ratios in LAG_SETS for ratio in ratios})]
    lags = tuple(Lag(source, time) for time in times if time >= _SHORTEST_LAG * interval for source in followed)
    nothing = np.zeros((0, scales.size + len(lags)), dtype=np.int64)
    empty = PolynomialDynamics(nothing, np.zeros((2, 0)), scales, lags, squared, *escape_bounds(low, high))
    blocks = held_out_blocks(trajectories)
    half_width = _half_width(trajectories, blocks, time_scale)
    weak = [_weak_block(trajectories, block, empty, half_width, angle) for block in blocks]
    usable = [i for i, (exponents, _, _) in enumerate(weak) if len(exponents)]
    return Problem(
        trajectories, [blocks[i] for i in usable], [weak[i][1] for i in usable], [weak[i][2] for i in usable],
        weak[usable[0]][0], empty, high - low, time_scale, half_width,
    )  # fmt: skip


def _half_width(trajectories: Sequence[Trajectory], blocks: Sequence[HeldOutBlock], time_scale: float) -> float:
    """Half width [s] of the test functions: the time scale of the motion, some samples, no more than a block holds.

    Raises
    ------
    InputError
        No block holds so many samples.
    """
    length, interval = max(
        ((b.stop - b.start - 1) * trajectories[b.source].interval, trajectories[b.source].interval) for b in blocks
    )
    if length < 4.0 * LEAST_SAMPLES * interval:
        raise InputError("the training stretches are too short for SINDy; give longer logs")
    return min(max(time_scale, LEAST_SAMPLES * interval), length / 4.0)


def _weak_block(
    trajectories: Sequence[Trajectory], block: HeldOutBlock, empty: PolynomialDynamics, half_width: float, angle: bool
) -> tuple[IntArray, FloatArray, FloatArray]:
    """The block's rows on a grid at least as fine as its voltages; no terms where it is shorter than a test function.

    Between samples q and q̇ are cubic polynomials through the samples and their derivatives, voltages are linear.
    """
    samples = sum(len(x.t) for x in trajectories)
    x = trajectories[block.source].part(block.start, block.stop)
    if (len(x.t) - 1) * x.interval < 2.5 * half_width:
        return np.zeros((0, 0), dtype=np.int64), np.zeros((0, 0)), np.zeros(0)
    known = x.v.shape[1] if x.v.ndim == 3 else 1
    refined = max(1, min(max(known, int(np.ceil(STEPS * x.interval / half_width))), MOST_ROWS // samples))
    places = np.arange((len(x.t) - 1) * refined + 1) / refined
    times, voltages = np.arange(len(x.t)), x.v.reshape(-1, x.v.shape[-1])
    v = np.column_stack([np.interp(places, np.arange(len(voltages)) / known, column) for column in voltages.T])
    q = CubicHermiteSpline(times, x.q, x.interval * x.qdot)(places)
    qdot = CubicHermiteSpline(times, x.qdot, x.interval * x.qddot)(places)
    step, count = x.interval / refined, max(1, round(TEST_FUNCTIONS * len(x.t) / samples))
    return weak_rows(scaled_variables(empty, v, q, qdot, step), qdot, step, half_width, count, angle)


def _fitted(problem: Problem, candidate: Candidate, fold: int | None) -> PolynomialDynamics:
    """Fit a candidate on all folds, or on all but one."""
    columns = problem.columns(candidate.library)
    rows, target = problem.without(fold)
    theta, scaled, norms, length = _scaled(rows[:, columns], target)
    optimizer = importlib.import_module("pysindy").STLSQ(threshold=candidate.threshold, alpha=RIDGE)
    with seeded():
        optimizer.fit(theta, scaled[:, None])
    coefficients = np.nan_to_num(np.asarray(optimizer.coef_, dtype=np.float64)[0]) * length / norms
    kept, d = np.flatnonzero(coefficients), problem.empty
    terms = problem.exponents[columns[kept]]
    used = np.flatnonzero(terms[:, d.scales.size :].any(axis=0))
    velocity = np.zeros((1, d.scales.size + used.size), dtype=np.int64)
    velocity[0, QDOT] = 1
    table = np.zeros((2, kept.size + 1))
    table[0, 0], table[1, 1:] = d.scales[QDOT], coefficients[kept]  # q̇ = v, not regressed
    columns_left = np.concatenate([np.arange(d.scales.size), d.scales.size + used])
    return replace(
        d,
        exponents=np.vstack([velocity, terms[:, columns_left]]),
        coefficients=table,
        lags=tuple(d.lags[k] for k in used),
    )


def _scaled(rows: FloatArray, target: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, float]:
    """Triangular factor of the columns and the target, all of length 1, which has the same fits, and their lengths.

    Columns of nothing but zeros stay.
    """
    norms, length = np.linalg.norm(rows, axis=0), float(np.linalg.norm(target)) or 1.0
    norms[norms == 0.0] = 1.0
    factor, _ = triangular_factor([np.column_stack([rows / norms, target / length])])
    return factor[:, :-1], factor[:, -1], norms, length


def _cross_validate(problem: Problem, candidate: Candidate) -> tuple[FloatArray, int]:
    """Free-run NRMSE of q for each held-out fold, and the most terms that any fold kept."""
    folds = sorted({block.fold for block in problem.blocks})
    errors, terms = [], 0
    for fold in folds:
        dynamics = _fitted(problem, candidate, fold if len(folds) > 1 else None)
        terms = max(terms, len(dynamics.exponents) - 1)
        parts = []
        for block in (b for b in problem.blocks if b.fold == fold):
            x = problem.trajectories[block.source].part(block.start, block.stop)
            path, _ = free_run(dynamics, x.v, x.interval, float(x.q[0]), float(x.qdot[0]))
            parts.append(free_run_error(x.q, path[:, 0], problem.span))
        errors.append(float(np.mean(parts)))
    return np.array(errors), terms


def _refit(problem: Problem, chosen: Candidate, errors: dict[Candidate, FloatArray], status: SearchStatus) -> SindyFit:
    rows, target = problem.without(None)
    theta, scaled, _, _ = _scaled(rows[:, problem.columns(chosen.library)], target)
    dynamics = _fitted(problem, chosen, None)
    singular = np.linalg.svd(theta, compute_uv=False)
    rank = int(np.sum(singular > singular[0] * max(theta.shape) * np.finfo(np.float64).eps))
    residual = theta @ np.linalg.lstsq(theta, scaled, rcond=None)[0] - scaled
    return SindyFit(
        dynamics, chosen, problem.half_width, errors, status, theta.shape[1], rank,
        float(singular[0] / singular[rank - 1]), float(np.linalg.norm(residual)),
    )  # fmt: skip


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
    with seeded():
        model.fit(
            [np.column_stack([x.q, x.qdot]) / length for x in trajectories],
            t=trajectories[0].interval,
            u=[(np.square(x.v) if squared else x.v) / input_scale for x in trajectories],
        )
    powers = np.asarray(model.feature_library.powers_, dtype=np.int64)
    exponents = np.zeros((len(powers), FIRST_INPUT + inputs), dtype=np.int64)
    exponents[:, [Q, QDOT, *range(FIRST_INPUT, FIRST_INPUT + inputs)]] = powers
    scales = np.array([length, length, 1.0, 1.0, 1.0, *[input_scale] * inputs])
    coefficients = length * np.asarray(model.coefficients(), dtype=np.float64)
    used = np.any(coefficients != 0.0, axis=0)
    return PolynomialDynamics(exponents[used], coefficients[:, used], scales, (), squared, *escape_bounds(low, high))
