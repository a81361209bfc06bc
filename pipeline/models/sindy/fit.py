"""Fits of SINDy by pysindy: the equation chosen by held-out free runs, and pysindy's own defaults.

Weak form and sparse regression are pysindy's estimators.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pysindy

from ...device.device import Device
from ...errors import InputError
from ...fitting.regression import triangular_factor
from ...numerics.arrays import FloatArray
from ...numerics.fixed_step import escape_bounds
from ...scoring.cross_validation import NEGLIGIBLE, HeldOutBlock, free_run_error, mean_over_folds
from ...signals.log import Log, operating_range
from ..polynomial_dynamics import FIRST_INPUT, QDOT, PolynomialDynamics, Q, free_run
from .weak_form import LAG_SETS, Library, Problem, prepare_problem, seeded

MOST_INPUT_LAGS = 2
"""Most lags of a set with lagged inputs: a log of this length does not determine more terms."""
DEGREES = ((1, 0, 0), (3, 1, 1), (5, 2, 3), (7, 3, 4))
"""Highest power of q alone, as a factor of velocities and lags, and as a factor of inputs."""
TURNING = ((1, 0, 0), (1, 1, 1))
"""Highest powers where sin q and cos q take the place of powers."""
THRESHOLDS = (0.01, 0.03, 0.1)
LEAST_THRESHOLD = 1e-3
RIDGE = 1e-6
STARTS = 4
"""Free runs over the parts of each held-out block: a single passage near a barrier decides less than in one run."""


@dataclass(frozen=True)
class Treatment:
    """One treatment: library and threshold of pysindy's STLSQ.

    Terms and acceleration are scaled to length 1 before the regression, so a term is dropped where it contributes less
    than `threshold` of the acceleration.
    """

    library: Library
    threshold: float


def fit_sindy(
    trajectories: Sequence[Log], plant: Device, *, most: int | None = None
) -> tuple[PolynomialDynamics, dict[str, Any]]:
    """Fit the acceleration by pysindy's weak form, treated as held-out parts of the training data decide.

    A coordinate search: lags, then the library, then the threshold. Each candidate is fitted on all blocks but
    one and simulated freely over `STARTS` parts of the block left out, each from its measured first state. The
    candidate of the lowest mean error is refitted on everything; among negligible errors the fewest terms decide.

    Parameters
    ----------
    trajectories : sequence of Log
        Gap-free training segments, all with the same inputs; voltages as finely as they are known.
    plant : Device
        Action of the inputs. Where q is an angle, libraries of sin q and cos q are tried too.
    most : int, optional
        Candidates after which the search ends with what it has tried; it ends by itself if left out. Counted, so that
        no machine decides.

    Returns
    -------
    dynamics : PolynomialDynamics
        Sparse right-hand side.
    notes : dict
        Choice of the equation, by the names of `pipeline.models.model_file`. The held-out error is the free-run NRMSE
        of q, the mean over the parts of a block; 1 stands for a run that diverged or missed everything.

    Raises
    ------
    InputError
        No data, differing inputs, a constant displacement, or segments that are too short.
    """
    problem = prepare_problem(trajectories, plant)
    errors: dict[Treatment, FloatArray] = {}
    terms: dict[Treatment, int] = {}
    refused = set[Treatment]()

    def error(candidate: Treatment) -> float:
        """Mean error over the folds, computed once for each candidate; infinite beyond the limit of candidates."""
        if candidate not in errors:
            if most is not None and len(errors) >= most:
                refused.add(candidate)
                return np.inf
            errors[candidate], terms[candidate] = _cross_validate(problem, candidate)
        return float(errors[candidate].mean())

    _search(error, problem, angle=plant.displacement.symbol == "rad")
    means = {candidate: float(values.mean()) for candidate, values in errors.items()}
    limit = max(min(means.values()), NEGLIGIBLE)
    chosen = min((c for c in means if means[c] <= limit), key=lambda c: (terms[c], means[c]))
    return _refit(problem, chosen, errors, "limit" if refused else "completed")


def _search(error: Callable[[Treatment], float], problem: Problem, *, angle: bool) -> None:
    """Try candidates in order; each stage keeps the best of the one before."""
    present = {lag.time for lag in problem.empty.lags}
    scaled = (tuple(ratio * problem.time_scale for ratio in ratios) for ratios in LAG_SETS)
    sets = [times for times in scaled if present.issuperset(times)]

    def best_of(libraries: Iterable[Library]) -> Library:
        """The library of least held-out error."""
        return min(libraries, key=lambda library: error(Treatment(library, LEAST_THRESHOLD)))

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
        error(Treatment(library, threshold))


def _fitted(problem: Problem, candidate: Treatment, fold: int | None) -> PolynomialDynamics:
    """Fit a candidate on all folds, or on all but one."""
    columns = problem.columns(candidate.library)
    rows, target = problem.without(fold)
    theta, scaled, norms, length = _scaled(rows[:, columns], target)
    optimizer = pysindy.STLSQ(threshold=candidate.threshold, alpha=RIDGE)
    with seeded():
        optimizer.fit(theta, scaled[:, None])
    coefficients = np.nan_to_num(np.asarray(optimizer.coef_, dtype=np.float64)[0]) * length / norms
    nonzero = np.flatnonzero(coefficients)
    d = problem.empty
    terms = problem.exponents[columns[nonzero]]
    used = np.flatnonzero(terms[:, d.scales.size :].any(axis=0))
    velocity = np.arange(d.scales.size + used.size) == QDOT
    table = np.zeros((2, nonzero.size + 1))
    table[0, 0] = d.scales[QDOT]  # q̇ = v, not regressed
    table[1, 1:] = coefficients[nonzero]
    columns_left = np.concatenate([np.arange(d.scales.size), d.scales.size + used])
    return replace(
        d,
        exponents=np.vstack([velocity, terms[:, columns_left]]),
        coefficients=table,
        lags=tuple(d.lags[k] for k in used),
    )


def _scaled(rows: FloatArray, target: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, float]:
    """Triangular factor of the columns and the target, all of length 1, which has the same fits, and their lengths.

    Columns of zeros stay.
    """
    norms = np.linalg.norm(rows, axis=0)
    length = float(np.linalg.norm(target)) or 1.0
    norms[norms == 0.0] = 1.0
    factor, _ = triangular_factor([np.column_stack([rows / norms, target / length])])
    return factor[:, :-1], factor[:, -1], norms, length


def _cross_validate(problem: Problem, candidate: Treatment) -> tuple[FloatArray, int]:
    """Free-run NRMSE of q for each held-out fold, and the most terms that any fold kept."""
    folds = sorted({block.fold for block in problem.blocks})
    fitted = {fold: _fitted(problem, candidate, fold if len(folds) > 1 else None) for fold in folds}
    errors = [
        np.mean([_error(problem, fit, b, i) for b in problem.blocks if b.fold == fold for i in range(STARTS)])
        for fold, fit in fitted.items()
    ]
    return np.array(errors), max(len(fit.exponents) - 1 for fit in fitted.values())


def _error(problem: Problem, dynamics: PolynomialDynamics, block: HeldOutBlock, part: int) -> float:
    """Free-run NRMSE of q over one of the `STARTS` parts of a block."""
    first, last = (block.start + (block.stop - block.start) * i // STARTS for i in (part, part + 1))
    whole = problem.trajectories[block.source]
    x = whole.part(first, last)
    path, _ = free_run(dynamics, x.drive, whole.interval, float(x.q[0]), float(x.qdot[0]))
    return free_run_error(x.q, path[:, 0], problem.span)


def _refit(
    problem: Problem, chosen: Treatment, errors: dict[Treatment, FloatArray], status: str
) -> tuple[PolynomialDynamics, dict[str, Any]]:
    rows, target = problem.without(None)
    theta, scaled, _, _ = _scaled(rows[:, problem.columns(chosen.library)], target)
    dynamics = _fitted(problem, chosen, None)
    singular = np.linalg.svd(theta, compute_uv=False)
    rank = int(np.sum(singular > singular[0] * max(theta.shape) * np.finfo(np.float64).eps))
    residual = theta @ np.linalg.lstsq(theta, scaled, rcond=None)[0] - scaled
    mean, band = mean_over_folds(errors[chosen])
    return dynamics, {
        "library": str(chosen.library),
        "library_terms": theta.shape[1],
        "terms_kept": int(np.count_nonzero(dynamics.coefficients[1])),
        "test_function_half_width_s": problem.half_width,
        "optimizer": "STLSQ",
        "threshold_of_rms_acceleration": chosen.threshold,
        "inner_validation_nrmse": mean,
        "inner_validation_nrmse_interval": np.array([mean, mean] if band is None else [band.low, band.high]),
        "inner_validation_nrmse_of_folds": errors[chosen],
        "candidates_tried": len(errors),
        "search_status": status,
        "rank": rank,
        "condition": float(singular[0] / singular[rank - 1]),
        "acceleration_residual": float(np.linalg.norm(residual)),
    }


def fit_default_sindy(trajectories: Sequence[Log], plant: Device) -> tuple[PolynomialDynamics, dict[str, Any]]:
    """``pysindy.SINDy().fit(x, t=…, u=…)`` with x = [q, q̇] and u = v² (or v), everything else left alone.

    The defaults are second-degree polynomials, STLSQ with a threshold of 0.1 on raw coefficients and second-order
    finite differences; both equations are regressed, so q̇ = v is not guaranteed. The threshold makes the result depend
    on the units, so those of the log are taken, as its owner would do. In SI all input terms of a rig in mm and kV
    would fall below the threshold at once.

    Parameters
    ----------
    trajectories : sequence of Log
        Gap-free training segments; velocities are used, accelerations are not.
    plant : Device
        Action of the inputs, and the units of the log.

    Raises
    ------
    InputError
        No data, a constant displacement, or differing sample intervals or inputs.
    """
    low, high = operating_range(trajectories)
    if len({x.v.shape[1] for x in trajectories}) != 1 or np.ptp([x.interval for x in trajectories]) > 1e-9:
        raise InputError("the training logs differ in inputs or sample interval; ingest them alike")
    inputs = trajectories[0].v.shape[1]
    length = plant.displacement.factor
    input_scale = plant.inputs[0].factor ** (2 if plant.squared else 1)
    model = pysindy.SINDy()
    with seeded():
        model.fit(
            [np.column_stack([x.q, x.qdot]) / length for x in trajectories],
            t=trajectories[0].interval,
            u=[plant.acting(x.v) / input_scale for x in trajectories],
        )
    powers = np.asarray(model.feature_library.powers_, dtype=np.int64)
    exponents = np.zeros((len(powers), FIRST_INPUT + inputs), dtype=np.int64)
    exponents[:, [Q, QDOT, *range(FIRST_INPUT, FIRST_INPUT + inputs)]] = powers
    scales = np.array([length, length, 1.0, 1.0, 1.0, *[input_scale] * inputs])
    coefficients = length * np.asarray(model.coefficients(), dtype=np.float64)
    used = np.any(coefficients != 0.0, axis=0)
    dynamics = PolynomialDynamics(
        exponents[used], coefficients[:, used], scales, (), plant.squared, *escape_bounds(low, high)
    )
    return dynamics, {
        "library": "poly2(q, q̇, u), pysindy's default, in the units of the log",
        "terms_kept": int(np.count_nonzero(coefficients[1])),
    }
