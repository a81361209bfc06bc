"""Calibration of the analytical model (§ 3.3): bounded least squares on q over windows, from several starts.

Unknowns are scaled by what a designer does not know about them (`PRIORS`), logarithmically where a quantity is
positive. The same widths enter as a weak prior, so that a parameter that a log says nothing about stays where the
designer put it instead of running to a bound; it has the soft-L1 loss of the data, so what a log is sure of may lie far
from there.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from ...device.parameters import JointParameters
from ...numerics.arrays import BoolArray, FloatArray, IntArray
from ...numerics.metrics import rms
from ...signals.log import MOST_SAMPLES, Log, within
from .calibration_problem import (
    LOSS_SCALE,
    RESOLUTION,
    CalibrationProblem,
    Ended,
    SimulatedProblem,
    search,
)
from .windows import Windows, cut_windows

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

Report = Callable[[str, float], None]
"""Called with what is being done and the share that is done, 0 to 1."""


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


WINDOW = 1.0
"""Duration of a window [s]. The last refinement uses windows seven to eight times as long: what is close enough not to
lose the well can be held to the whole ring-down."""
MOST_EVALUATIONS = 60
"""Limit of simulations in each refinement."""


def calibrate(
    motions: Sequence[Log],
    start: JointParameters,
    rng: np.random.Generator,
    *,
    names: Sequence[str] = PAPER_NAMES,
    starts: int = 3,
    jobs: int = 1,
    report: Report | None = None,
) -> Calibration:
    """Fit parameters to measured motions.

    Parameters
    ----------
    motions : sequence of Log
        Gap-free measured motions with both voltages, of which `MOST_SAMPLES` are taken at most.
    start : JointParameters
        The designer's set: first start, centre of the prior, and value of everything that is not fitted.
    rng : numpy.random.Generator
        Draws the other starts from the prior.
    names : sequence of str
        What to fit, e.g. `PAPER_NAMES` or `ASYMMETRIC_NAMES` + `FRICTION_NAMES`.
    starts : int
        Number of starts. Each is improved in up to five iterations on a third of the windows, then the best is refined.
    jobs : int
        Threads for the windows.
    report : callable, optional
        Receives the progress.

    Notes
    -----
    Least squares with soft-L1 loss (`calibration_problem`): a window near a switching that ends in the wrong well must
    not decide the fit. Gradients are those of the variational equations. Cost: an iteration on 37.5 s
    at 10 ms takes 0.1 to 0.2 s of processor time, a third of that while starts are compared; a calibration with three
    starts 2 to 4 s (nine simulated joints).
    """
    taken = within(motions, MOST_SAMPLES)
    short = cut_windows(taken, WINDOW)
    wide = cut_windows(taken, 7.5 * WINDOW)
    share = _Share(report, starts * 5 + 3 * MOST_EVALUATIONS)
    with ThreadPoolExecutor(jobs) as pool:
        problem = CalibrationProblem(start, names, pool)
        sample = problem.at(short.thinned(3), SEARCH)
        every = problem.at(short, SEARCH)
        final = problem.at(wide, REFINEMENT)

        def improve(name: str, windows: SimulatedProblem, x0: FloatArray, limit: int, tolerance: float) -> Ended:
            """A search from x0 over some windows, reported under a name."""
            return search(windows, x0, limit, tolerance, share.at(name))

        candidates: list[Ended] = []
        for index in range(starts):
            draw = rng.standard_normal(len(problem.names)) if index else np.zeros(len(problem.names))
            x0 = np.clip(draw, 0.98 * problem.lower, 0.98 * problem.upper)
            x0 = np.where(problem.lower == 0.0, np.maximum(x0, 0.1), x0)
            candidates.append(improve(f"start {index + 1} of {starts}", sample, x0, 6, 1e-2))
        best = min(candidates, key=lambda result: result.cost)
        refined = improve("refining the best start", every, best.x, MOST_EVALUATIONS, 3e-2)
        lost_windows = _lost(wide, final.residuals(refined.x))
        if lost_windows.any():
            followed = problem.at(wide.resolved(lost_windows, short), SEARCH)
            refined = improve("refining over windows that are followed", followed, refined.x, MOST_EVALUATIONS, 5e-2)
        improved = improve("refining over long windows", final, refined.x, MOST_EVALUATIONS, 1e-4)
        reached = np.array([_rmse(sample.windows, result.residuals) for result in candidates])
        return _result(final, improved, reached)


class _Share:
    """Counts iterations for the progress report."""

    def __init__(self, report: Report | None, total: int) -> None:
        self.report = report
        self.total = total
        self.done = 0

    def at(self, text: str) -> Callable[[], None]:
        """A callable that counts one iteration of what `text` names."""

        def tick() -> None:
            """One iteration is done."""
            self.done += 1
            if self.report is not None:
                self.report(text, min(1.0, self.done / self.total))

        return tick


def _covariance(jacobian: FloatArray, residuals: FloatArray, labels: IntArray) -> FloatArray:
    """Covariance of the scaled estimates, errors of one window being one observation (a sandwich estimate).

    K.-Y. Liang and S. L. Zeger, Biometrika 73 (1986) 13-22, doi:10.1093/biomet/73.1.13. The errors of q are those
    of a model, correlated over whole ring-downs; as independent samples they would promise ten times too much.
    """
    count = jacobian.shape[1]
    weights = (1.0 + (residuals / LOSS_SCALE) ** 2) ** -0.5  # of the residuals in the gradient of the soft-L1 loss
    scores = (weights * residuals)[:, None] * jacobian
    windows = int(labels.max()) + 1
    clusters = np.zeros((windows, count))
    np.add.at(clusters, labels, scores[:-count])
    # The rows of the prior, one for each unknown, weigh here as they do in the bread.
    meat = clusters.T @ clusters * (windows / max(windows - 1, 1)) + np.diag(weights[-count:] ** 2)
    bread = np.linalg.inv(jacobian.T @ (weights[:, None] * jacobian))
    return np.asarray(bread @ meat @ bread)


def _lost(windows: Windows, residuals: FloatArray) -> BoolArray:
    """Mask of the windows that the simulation leaves: their errors do not show the way back."""
    errors = RESOLUTION * np.abs(residuals[: windows.samples])
    labels = windows.labels
    return np.array([errors[labels == w].max(initial=0.0) > WRONG_WELL_ERROR_M for w in range(len(windows.spans))])


def _result(simulated: SimulatedProblem, final: Ended, reached: FloatArray) -> Calibration:
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
        rmse=_rmse(windows, residuals),
        converged=final.converged,
        evaluations=final.evaluations,
        start_costs=reached,
    )


def _rmse(windows: Windows, residuals: FloatArray) -> float:
    return RESOLUTION * rms(residuals[: windows.samples])
