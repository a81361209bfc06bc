"""Calibration of the analytical model (§ 3.3): bounded least squares on q over windows.

Unknowns are scaled by what a designer does not know about them (`PRIORS`), logarithmically where a quantity is
positive. The same widths enter as a weak prior: a parameter that a log does not determine stays where the designer put
it, instead of running to a bound. The prior has the soft-L1 loss of the data, so a parameter that a log determines well
may lie far from there.
"""

import itertools
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from scipy.optimize import OptimizeResult, least_squares

from ...device.parameters import VECTOR_NAMES, JointParameters, quantity_of
from ...errors import InputError
from ...fitting.descent import PARAMETER_STEP
from ...numerics.arrays import BoolArray, FloatArray, IntArray
from ...numerics.metrics import rms
from ...signals.log import MOST_SAMPLES, Log, within
from .windows import WindowRuns, Windows, cut_windows, error_derivatives, simulate_windows

RESOLUTION = 1e-3
"""Error of q [m] that weighs as much as one prior width; model errors are of this size."""


@dataclass(frozen=True)
class ParameterPrior:
    """Width and bounds of an unknown: factors of the starting value, or absolute [SI] where `relative` is false."""

    width: float
    lower: float
    upper: float
    relative: bool = True

    def widths(self, value: float) -> float:
        """A factor or a change in prior widths."""
        return float(np.log(value) / np.log(self.width)) if self.relative else value / self.width


_ELASTIC = ParameterPrior(1.1, 0.7, 1.4)
_VISCOUS = ParameterPrior(2.0, 0.05, 20.0)
_LENGTH = ParameterPrior(3e-4, -1.5e-3, 1.5e-3, False)
PRIORS = {
    "Y": _ELASTIC, "E": _ELASTIC, "eps_r": _ELASTIC, "rho": _ELASTIC, "m": ParameterPrior(1.02, 0.9, 1.1),
    "Y_MW": ParameterPrior(1.5, 0.1, 10.0), "eta_v": _VISCOUS, "eta_MW": _VISCOUS, "eta": _VISCOUS,
    "a": _LENGTH, "b": _LENGTH, "a0": _LENGTH, "e_x": _LENGTH, "e_z": _LENGTH, "l0": _LENGTH,
    "kappa0": ParameterPrior(0.1, -1.0, 1.0, False), "F_c": ParameterPrior(5e-3, 0.0, 0.05, False),
    "s_c": ParameterPrior(2.0, 0.1, 10.0),
}  # fmt: skip
"""Parameters that may be calibrated, the same for both sides, and the prior widths of a designer's values."""


class CalibrationProblem:
    """Scaled unknowns x (P,), zero at the starting set, one prior width a unit.

    Parameters
    ----------
    start : JointParameters
        The designer's set.
    names : sequence of str
        Names of the fitted unknowns.
    pool : ThreadPoolExecutor
        Threads for the windows.
    """

    def __init__(self, start: JointParameters, names: Sequence[str], pool: ThreadPoolExecutor) -> None:
        self.start = start
        self.names = tuple(names)
        self.priors = [PRIORS[name.rpartition(".")[2]] for name in names]
        self.origin = np.array([start.value(name if name in VECTOR_NAMES else f"left.{name}") for name in names])
        self.lower = np.array([prior.widths(prior.lower) for prior in self.priors])
        self.upper = np.array([prior.widths(prior.upper) for prior in self.priors])
        self.pool = pool
        self.evaluations = 0

    def values(self, x: FloatArray) -> FloatArray:
        """Values [SI] at x."""
        return np.array(
            [
                o * prior.width**s if prior.relative else o + prior.width * s
                for prior, o, s in zip(self.priors, self.origin, x, strict=True)
            ]
        )

    def slopes(self, x: FloatArray) -> FloatArray:
        """Derivatives of the values [SI] with respect to x."""
        return np.array(
            [
                value * np.log(prior.width) if prior.relative else prior.width
                for prior, value in zip(self.priors, self.values(x), strict=True)
            ]
        )

    def parameters(self, x: FloatArray) -> JointParameters:
        """The set at x."""
        return self.start.with_values(dict(zip(self.names, self.values(x), strict=True)))


class SimulatedProblem:
    """Residuals and their derivatives; a Jacobian uses the solution that its residuals came from."""

    def __init__(self, problem: CalibrationProblem, windows: Windows, tolerance: float) -> None:
        self.problem = problem
        self.windows = windows
        self.tolerance = tolerance
        self._made: dict[bytes, WindowRuns] = {}

    def residuals(self, x: FloatArray) -> FloatArray:
        """Errors of q over `RESOLUTION`, then the prior's residuals, shape (samples + P,)."""
        problem = self.problem
        key = x.tobytes()
        if key not in self._made:
            problem.evaluations += 1
            self._made[key] = simulate_windows(problem.parameters(x), self.windows, self.tolerance, problem.pool)
        return np.concatenate([self._made[key].errors / RESOLUTION, x])

    def jacobian(self, x: FloatArray) -> FloatArray:
        """Derivatives of the residuals where they were computed, shape (samples + P, P)."""
        problem = self.problem
        runs = self._made[x.tobytes()]
        self._made = {x.tobytes(): runs}  # a search never goes back behind a point that it took
        steps = np.where(x + PARAMETER_STEP <= problem.upper, PARAMETER_STEP, -PARAMETER_STEP)
        moved = [problem.parameters(x + step * unit) for step, unit in zip(steps, np.eye(x.size), strict=True)]
        return np.vstack([error_derivatives(runs, moved, steps, problem.pool) / RESOLUTION, np.eye(x.size)])


LOSS_SCALE = 3.0
"""Residual, in units of `RESOLUTION`, from which the soft-L1 loss grows linearly."""

SMALLEST_STEP = 1e-4
"""Change of the unknowns, relative to their size, below which a search has converged."""

NEAR_ZERO = 0.1
"""Prior widths at which a parameter starts that may not be negative: at its bound a search would leave it."""


PAPER_NAMES = ("Y", "eta_v", "eta_MW", "Y_MW", "E", "rho", "eta")
"""The seven parameters that the paper adjusts."""

ASYMMETRIC_NAMES = (
    "left.Y", "right.Y", "eta_v", "eta_MW", "Y_MW", "E", "rho", "eta",
    "left.eps_r", "right.eps_r", "left.b", "right.b", "kappa0",
)  # fmt: skip
"""The seven with a modulus per side, and what makes the sides differ: capacitance, mounts, a bent beam."""

FRICTION_NAMES = ("F_c",)
"""Dahl friction along q."""

WRONG_WELL_ERROR_M = 5e-3
"""Error of q [m] from which a window is lost: the simulation is in another well than the joint."""

SEARCH = 1e-2
"""Tolerance of the integrator while the optimum is looked for: 18 µm of q, where model errors are of 0.1 to 1 mm."""

REFINEMENT = 1e-3
"""Tolerance of the integrator at the optimum: 1.4 µm of q."""


@dataclass(frozen=True)
class Calibration:
    """Result of a calibration.

    Attributes
    ----------
    parameters : JointParameters
        The calibrated set.
    names : tuple of str
        Names of the fitted unknowns.
    values, standard_errors : FloatArray, shape (P,)
        Fitted values and their standard errors [SI], robust against errors that are correlated within a window.
    correlation : FloatArray, shape (P, P)
        Correlations of the estimates.
    at_bound : tuple of str
        Names that ended at a bound.
    rmse : float
        RMS of simulated minus measured q over the windows [m].
    converged : bool
        True if the last search met its tolerance rather than its limit of evaluations.
    evaluations : int
        Simulations of all windows.
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


WINDOW = 1.0
"""Duration of a window [s]. The last refinement uses windows seven to eight times as long: what is close enough not to
lose the well can be held to the whole ring-down."""
FIRST_EVALUATIONS = 6
"""Limit of simulations of every third window, with which a search begins. Without it one of 35 simulated joints is lost
and a fit takes a third to a half longer. More starts, from elsewhere, ended in the same place on 30 of them."""
MOST_EVALUATIONS = 60
"""Limit of simulations in each refinement."""


def calibrate(
    motions: Sequence[Log],
    start: JointParameters,
    *,
    names: Sequence[str] = PAPER_NAMES,
    jobs: int = 1,
    report: Callable[[str, float], None] | None = None,
) -> Calibration:
    """Fit parameters to measured motions.

    Parameters
    ----------
    motions : sequence of Log
        Gap-free measured motions with both voltages, of which `MOST_SAMPLES` are taken at most.
    start : JointParameters
        The designer's set: start, centre of the prior, and value of everything that is not fitted.
    names : sequence of str
        Unknowns to fit, e.g. `PAPER_NAMES` or `ASYMMETRIC_NAMES` + `FRICTION_NAMES`.
    jobs : int
        Threads for the windows.
    report : callable, optional
        Called with what is being done and the share that is done, 0 to 1.

    Raises
    ------
    InputError
        An unknown parameter, or one that calibration leaves alone.

    Notes
    -----
    Least squares with soft-L1 loss by SciPy's trust region within bounds (Branch, Coleman & Li 1999,
    doi:10.1137/S1064827595289108): a window near a switching that ends in the wrong well must not decide the fit.
    Gradients are those of the variational equations. Cost: an iteration on 37.5 s at 10 ms takes 0.1 to 0.2 s of
    processor time, a third of that at first; a calibration 1.4 to 3.7 s (35 simulated joints).
    """
    for name in names:
        quantity_of(name)  # refuses a name that is no parameter
        if name.rpartition(".")[2] not in PRIORS:
            raise InputError(f"parameter {name!r} cannot be calibrated; possible are {', '.join(PRIORS)}")
    taken = within(motions, MOST_SAMPLES)
    short = cut_windows(taken, WINDOW)
    wide = cut_windows(taken, 7.5 * WINDOW)
    total = FIRST_EVALUATIONS + 3 * MOST_EVALUATIONS
    done = itertools.count(1)
    with ThreadPoolExecutor(jobs) as pool:
        problem = CalibrationProblem(start, names, pool)
        some = SimulatedProblem(problem, Windows(short.motions, short.spans[::3], short.parts[::3]), SEARCH)
        final = SimulatedProblem(problem, wide, REFINEMENT)

        def improve(
            name: str, windows: SimulatedProblem, x0: FloatArray, tolerance: float, limit: int = MOST_EVALUATIONS
        ) -> OptimizeResult:
            """Improve x0 over some windows until the cost falls by less than the relative `tolerance`, or by `limit`
            simulations. Each step is reported under a name.
            """

            def jacobian(x: FloatArray) -> FloatArray:
                """The derivatives with which a step begins."""
                if report is not None:
                    report(name, min(1.0, next(done) / total))
                return windows.jacobian(x)

            return least_squares(
                windows.residuals,
                x0,
                jacobian,
                (problem.lower, problem.upper),
                loss="soft_l1",
                f_scale=LOSS_SCALE,
                ftol=tolerance,
                xtol=SMALLEST_STEP,
                max_nfev=limit,
            )

        x0 = np.where(problem.lower == 0.0, NEAR_ZERO, 0.0)
        near = improve("fitting some short windows", some, x0, 1e-2, FIRST_EVALUATIONS)
        refined = improve("fitting short windows", SimulatedProblem(problem, short, SEARCH), near.x, 3e-2)
        lost_windows = _lost(wide, final.residuals(refined.x))
        if lost_windows.any():
            followed = SimulatedProblem(problem, wide.resolved(lost_windows, short), SEARCH)
            refined = improve("fitting windows that are followed", followed, refined.x, 5e-2)
        return _result(final, improve("fitting long windows", final, refined.x, 1e-4))


def _covariance(jacobian: FloatArray, residuals: FloatArray, labels: IntArray) -> FloatArray:
    """Covariance of the scaled estimates, errors of one window being one observation (a sandwich estimate).

    K.-Y. Liang and S. L. Zeger, Biometrika 73 (1986) 13-22, doi:10.1093/biomet/73.1.13. The errors of q are those
    of a model, correlated over whole ring-downs; as independent samples they would promise ten times too much.
    """
    count = jacobian.shape[1]
    weights = (1.0 + (residuals / LOSS_SCALE) ** 2) ** -0.5  # of the residuals in the gradient of the soft-L1 loss
    windows = int(labels.max()) + 1
    clusters = np.zeros((windows, count))
    np.add.at(clusters, labels, ((weights * residuals)[:, None] * jacobian)[:-count])
    # The rows of the prior, one for each unknown, weigh here as they do in the bread.
    meat = clusters.T @ clusters * (windows / max(windows - 1, 1)) + np.diag(weights[-count:] ** 2)
    bread = np.linalg.inv(jacobian.T @ (weights[:, None] * jacobian))
    return np.asarray(bread @ meat @ bread)


def _lost(windows: Windows, residuals: FloatArray) -> BoolArray:
    """Mask of the windows that the simulation leaves: their errors do not show the way back."""
    errors = RESOLUTION * np.abs(residuals[: windows.samples])
    labels = windows.labels
    return np.array([errors[labels == w].max(initial=0.0) > WRONG_WELL_ERROR_M for w in range(len(windows.spans))])


def _result(simulated: SimulatedProblem, final: OptimizeResult) -> Calibration:
    problem = simulated.problem
    windows = simulated.windows
    residuals = simulated.residuals(final.x)
    covariance = _covariance(simulated.jacobian(final.x), residuals, windows.labels)
    deviations = np.sqrt(np.diag(covariance))
    at_bound = np.minimum(final.x - problem.lower, problem.upper - final.x) < 1e-3
    return Calibration(
        parameters=problem.parameters(final.x),
        names=problem.names,
        values=problem.values(final.x),
        standard_errors=np.abs(problem.slopes(final.x)) * deviations,
        correlation=covariance / np.outer(deviations, deviations),
        at_bound=tuple(name for name, bound in zip(problem.names, at_bound, strict=True) if bound),
        rmse=RESOLUTION * rms(residuals[: windows.samples]),
        converged=final.status > 0,
        evaluations=problem.evaluations,
    )
