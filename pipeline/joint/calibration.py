"""Calibration of the analytical model (§ 3.3): bounded least squares on q over windows, from several starts.

Unknowns are scaled by what a designer does not know about them (`PRIORS`), logarithmically where a quantity is
positive. The same widths enter as a weak Gaussian prior, so that a parameter that a log says nothing about stays
where the designer put it instead of running to a bound.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from pipeline.errors import InputError
from pipeline.joint.calibration_windows import Windows, cut_windows, window_errors
from pipeline.joint.parameters import VECTOR_NAMES, JointParameters, quantity_of
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.signals.trajectory import Trajectory

PAPER_NAMES = ("Y", "eta_v", "eta_MW", "Y_MW", "E", "rho", "eta")
"""The seven parameters that the paper adjusts."""

ASYMMETRIC_NAMES = (
    "left.Y", "right.Y", "eta_v", "eta_MW", "Y_MW", "E", "rho", "eta",
    "left.eps_r", "right.eps_r", "left.b", "right.b", "kappa0",
)  # fmt: skip
"""The seven with a modulus per side, and what makes the sides differ: capacitance, mounts, a bent beam."""

FRICTION_NAMES = ("F_c",)
"""Dahl friction along q."""

RESOLUTION = 1e-3
"""Error of q [m] that weighs as much as one prior width; model errors are of this size."""

LOSS_SCALE = 3.0
"""Residual, in units of `RESOLUTION`, from which the soft-L1 loss grows linearly."""

STEP = 1e-2
"""Step of the differences in prior widths: some 10 µm of q, where the integrator's steps scatter by 0.4 µm."""

Report = Callable[[str, float], None]
"""Called with what is being done and the share that is done, 0 to 1."""


@dataclass(frozen=True)
class Prior:
    """Width and bounds of an unknown: factors of the starting value, or absolute [SI] where `relative` is false."""

    width: float
    lower: float
    upper: float
    relative: bool = True


_ELASTIC, _VISCOUS, _LENGTH = Prior(1.1, 0.7, 1.4), Prior(2.0, 0.05, 20.0), Prior(3e-4, -1.5e-3, 1.5e-3, False)
PRIORS = {
    "Y": _ELASTIC, "E": _ELASTIC, "eps_r": _ELASTIC, "rho": _ELASTIC, "m": Prior(1.02, 0.9, 1.1),
    "Y_MW": Prior(1.5, 0.1, 10.0), "eta_v": _VISCOUS, "eta_MW": _VISCOUS, "eta": _VISCOUS,
    "a": _LENGTH, "b": _LENGTH, "a0": _LENGTH, "e_x": _LENGTH, "e_z": _LENGTH, "l0": _LENGTH,
    "kappa0": Prior(0.1, -1.0, 1.0, False), "F_c": Prior(5e-3, 0.0, 0.05, False), "s_c": Prior(2.0, 0.1, 10.0),
}  # fmt: skip
"""What may be calibrated, and how well a designer knows it beforehand."""


@dataclass(frozen=True)
class Calibration:
    """Result of a calibration.

    Attributes
    ----------
    parameters : JointParameters
        The calibrated set.
    names : tuple of str
        What was fitted.
    values, standard_errors : FloatArray, shape (P,)
        Fitted values and their standard errors [SI], robust against errors that are correlated within a window.
    correlation : FloatArray, shape (P, P)
        Correlations of the estimates.
    at_bound : tuple of str
        Names that ended at a bound.
    rmse : float
        RMS of simulated minus measured q over the windows [m].
    converged : bool
        Whether the last search met its tolerance rather than its limit of evaluations.
    evaluations : int
        Simulations of all windows.
    start_costs : FloatArray, shape (S,)
        RMS error [m] that each start reached before the best was refined.
    """

    parameters: JointParameters
    names: tuple[str, ...]
    values: FloatArray
    standard_errors: FloatArray
    correlation: FloatArray
    at_bound: tuple[str, ...]
    rmse: float
    converged: bool
    evaluations: int
    start_costs: FloatArray


class _Problem:
    """Scaled unknowns x (P,), zero at the starting set, one prior width a unit."""

    def __init__(self, start: JointParameters, names: Sequence[str]) -> None:
        self.start, self.names = start, tuple(names)
        self.priors = [prior_of(name) for name in names]
        self.origin = np.array([start.value(name if name in VECTOR_NAMES else f"left.{name}") for name in names])
        low, high = zip(*(self._bounds(prior) for prior in self.priors), strict=True)
        self.lower, self.upper = np.array(low), np.array(high)
        self.evaluations = 0

    @staticmethod
    def _bounds(prior: Prior) -> tuple[float, float]:
        if prior.relative:
            return np.log(prior.lower) / np.log(prior.width), np.log(prior.upper) / np.log(prior.width)
        return prior.lower / prior.width, prior.upper / prior.width

    def values(self, x: FloatArray) -> FloatArray:
        """Values [SI] at x."""
        pairs = zip(self.priors, self.origin, x, strict=True)
        return np.array([o * prior.width**s if prior.relative else o + prior.width * s for prior, o, s in pairs])

    def slopes(self, x: FloatArray) -> FloatArray:
        """Derivatives of the values [SI] with respect to x."""
        pairs = zip(self.priors, self.values(x), strict=True)
        return np.array([v * np.log(prior.width) if prior.relative else prior.width for prior, v in pairs])

    def parameters(self, x: FloatArray) -> JointParameters:
        """The set at x."""
        return self.start.with_values(dict(zip(self.names, self.values(x), strict=True)))

    def residuals(self, x: FloatArray, windows: Windows) -> FloatArray:
        """Errors of q over `RESOLUTION`, then the prior's residuals, shape (samples + P,)."""
        return np.concatenate([window_errors(self.parameters(x), windows) / RESOLUTION, x])

    def jacobian(self, x: FloatArray, windows: Windows, pool: ThreadPoolExecutor) -> FloatArray:
        """One-sided differences, one simulation an unknown, on the pool's threads (the integrator frees the GIL)."""
        steps = np.where(x + STEP <= self.upper, STEP, -STEP)
        points = [x, *(x + step * unit for step, unit in zip(steps, np.eye(x.size), strict=True))]
        self.evaluations += len(points)
        base, *moved = pool.map(lambda point: self.residuals(point, windows), points)
        return np.stack([(column - base) / step for column, step in zip(moved, steps, strict=True)], axis=1)


def prior_of(name: str) -> Prior:
    """The prior of a parameter, the same for both sides.

    Raises
    ------
    InputError
        An unknown parameter, or one that calibration leaves alone.
    """
    quantity_of(name)
    attribute = name.rpartition(".")[2]
    if attribute not in PRIORS:
        raise InputError(f"parameter {name!r} cannot be calibrated; possible are {', '.join(PRIORS)}")
    return PRIORS[attribute]


def calibrate(
    motions: Sequence[Trajectory],
    start: JointParameters,
    rng: np.random.Generator,
    *,
    names: Sequence[str] = PAPER_NAMES,
    starts: int = 3,
    window: float = 2.5,
    max_evaluations: int = 25,
    jobs: int = 1,
    report: Report | None = None,
) -> Calibration:
    """Fit parameters to measured motions.

    Parameters
    ----------
    motions : sequence of Trajectory
        Gap-free measured motions with both voltages.
    start : JointParameters
        The designer's set: first start, centre of the prior, and value of everything that is not fitted.
    rng : numpy.random.Generator
        Draws the other starts from the prior.
    names : sequence of str
        What to fit, e.g. `PAPER_NAMES` or `ASYMMETRIC_NAMES` + `FRICTION_NAMES`.
    starts : int
        Number of starts; each is improved in five iterations, then the best is refined.
    window : float
        Duration of a window [s]. The last refinement uses windows three times as long: what is close enough not
        to lose the well can be held to the whole ring-down.
    max_evaluations : int
        Limit of iterations of the refinement.
    jobs : int
        Threads for the columns of the Jacobian.
    report : callable, optional
        Told about the progress.

    Notes
    -----
    Trust-region reflective least squares with soft-L1 loss: a window near a switching that ends in the wrong
    well must not decide the fit. Cost: (P + 2) simulations of all windows an iteration, 0.1 s each for 37.5 s.
    """
    problem, windows = _Problem(start, names), cut_windows(motions, window)
    share = _Share(report, starts * 5 + max_evaluations)
    with ThreadPoolExecutor(jobs) as pool:
        candidates = []
        for index in range(starts):
            draw = rng.standard_normal(len(problem.names)) if index else np.zeros(len(problem.names))
            x0 = np.clip(draw, 0.98 * problem.lower, 0.98 * problem.upper)
            x0 = np.where(problem.lower == 0.0, np.maximum(x0, 0.1), x0)
            candidates.append(_search(problem, x0, windows, pool, 5, share.at(f"start {index + 1} of {starts}")))
        best = min(candidates, key=lambda result: float(result.cost))
        wide = cut_windows(motions, 3.0 * window)
        refined = _search(problem, best.x, windows, pool, max_evaluations // 2, share.at("refining the best start"))
        final = _search(problem, refined.x, wide, pool, max_evaluations // 2, share.at("refining over long windows"))
    reached = np.array([_rmse(windows, result.fun) for result in candidates])
    return _result(problem, wide, final, reached)


class _Share:
    """Counts iterations for the progress report."""

    def __init__(self, report: Report | None, total: int) -> None:
        self.report, self.total, self.done = report, total, 0

    def at(self, text: str) -> Callable[[], None]:
        """A callable that counts one iteration of what `text` names."""

        def tick() -> None:
            self.done += 1
            if self.report is not None:
                self.report(text, min(1.0, self.done / self.total))

        return tick


def _search(
    problem: _Problem, x0: FloatArray, windows: Windows, pool: ThreadPoolExecutor, limit: int, tick: Callable[[], None]
) -> Any:
    """Least squares from one start; SciPy's result."""
    from scipy.optimize import least_squares

    def residuals(x: FloatArray) -> FloatArray:
        problem.evaluations += 1
        return problem.residuals(x, windows)

    def jacobian(x: FloatArray) -> FloatArray:
        tick()
        return problem.jacobian(x, windows, pool)

    return least_squares(
        residuals, x0, jacobian, bounds=(problem.lower, problem.upper),
        loss="soft_l1", f_scale=LOSS_SCALE, ftol=1e-5, xtol=1e-4, max_nfev=limit,
    )  # fmt: skip


def _covariance(jacobian: FloatArray, residuals: FloatArray, labels: IntArray) -> FloatArray:
    """Covariance of the scaled estimates, errors of one window being one observation (a sandwich estimate).

    K.-Y. Liang and S. L. Zeger, Biometrika 73 (1986) 13-22, doi:10.1093/biomet/73.1.13. The errors of q are those
    of a model, correlated over whole ring-downs; as independent samples they would promise ten times too much.
    """
    count = jacobian.shape[1]
    weights = (1.0 + (residuals / LOSS_SCALE) ** 2) ** -0.5
    scores = (weights * residuals)[:, None] * jacobian
    windows = int(labels.max()) + 1
    clusters = np.zeros((windows, count))
    np.add.at(clusters, labels, scores[:-count])
    meat = clusters.T @ clusters * (windows / max(windows - 1, 1)) + np.eye(count)
    bread = np.linalg.inv(jacobian.T @ (weights[:, None] * jacobian))
    return np.asarray(bread @ meat @ bread)


def _result(problem: _Problem, windows: Windows, final: Any, reached: FloatArray) -> Calibration:
    covariance = _covariance(final.jac, final.fun, windows.labels)
    deviations = np.sqrt(np.diag(covariance))
    at_bound = np.minimum(final.x - problem.lower, problem.upper - final.x) < 1e-3
    return Calibration(
        parameters=problem.parameters(final.x),
        names=problem.names,
        values=problem.values(final.x),
        standard_errors=np.abs(problem.slopes(final.x)) * deviations,
        correlation=covariance / np.outer(deviations, deviations),
        at_bound=tuple(name for name, bound in zip(problem.names, at_bound, strict=True) if bound),
        rmse=_rmse(windows, final.fun),
        converged=bool(final.status > 0),
        evaluations=problem.evaluations,
        start_costs=reached,
    )


def _rmse(windows: Windows, residuals: FloatArray) -> float:
    return float(RESOLUTION * np.sqrt(np.mean(residuals[: windows.samples] ** 2)))
