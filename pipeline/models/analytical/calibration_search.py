"""The least squares of a calibration: scaled unknowns with priors, and Levenberg-Marquardt steps within bounds.

Materials and viscosities that act alike make the cost a narrow, curved valley, in which straight steps are short. The
second derivative of the residuals along a step shows the valley's bend, and two more simulations measure it ("geodesic
acceleration": M. K. Transtrum, B. B. Machta, J. P. Sethna, Phys. Rev. E 83 (2011) 036701,
doi:10.1103/PhysRevE.83.036701).
"""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from pipeline.device_parameters import VECTOR_NAMES, JointParameters, quantity_of
from pipeline.errors import InputError
from pipeline.models.analytical.windows import WindowRuns, Windows, error_derivatives, simulate_windows
from pipeline.numerics.arrays import BoolArray, FloatArray

RESOLUTION = 1e-3
"""Error of q [m] that weighs as much as one prior width; model errors are of this size."""

STEP = 1e-4
"""Step in prior widths of the differences of the equations (not of their solution)."""


@dataclass(frozen=True)
class ParameterPrior:
    """Width and bounds of an unknown: factors of the starting value, or absolute [SI] where `relative` is false."""

    width: float
    lower: float
    upper: float
    relative: bool = True


_ELASTIC, _VISCOUS = ParameterPrior(1.1, 0.7, 1.4), ParameterPrior(2.0, 0.05, 20.0)
_LENGTH = ParameterPrior(3e-4, -1.5e-3, 1.5e-3, False)
PRIORS = {
    "Y": _ELASTIC, "E": _ELASTIC, "eps_r": _ELASTIC, "rho": _ELASTIC, "m": ParameterPrior(1.02, 0.9, 1.1),
    "Y_MW": ParameterPrior(1.5, 0.1, 10.0), "eta_v": _VISCOUS, "eta_MW": _VISCOUS, "eta": _VISCOUS,
    "a": _LENGTH, "b": _LENGTH, "a0": _LENGTH, "e_x": _LENGTH, "e_z": _LENGTH, "l0": _LENGTH,
    "kappa0": ParameterPrior(0.1, -1.0, 1.0, False), "F_c": ParameterPrior(5e-3, 0.0, 0.05, False),
    "s_c": ParameterPrior(2.0, 0.1, 10.0),
}  # fmt: skip
"""Parameters that may be calibrated, and the prior widths of a designer's values."""


def prior_of(name: str) -> ParameterPrior:
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


class CalibrationProblem:
    """Scaled unknowns x (P,), zero at the starting set, one prior width a unit.

    Parameters
    ----------
    start : JointParameters
        The designer's set.
    names : sequence of str
        What is fitted.
    pool : ThreadPoolExecutor
        Threads for the windows.
    """

    def __init__(self, start: JointParameters, names: Sequence[str], pool: ThreadPoolExecutor) -> None:
        self.start, self.names = start, tuple(names)
        self.priors = [prior_of(name) for name in names]
        self.origin = np.array([start.value(name if name in VECTOR_NAMES else f"left.{name}") for name in names])
        low, high = zip(*(self._bounds(prior) for prior in self.priors), strict=True)
        self.lower, self.upper = np.array(low), np.array(high)
        self.pool, self.evaluations = pool, 0

    @staticmethod
    def _bounds(prior: ParameterPrior) -> tuple[float, float]:
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

    def at(self, windows: Windows, tolerance: float) -> "SimulatedProblem":
        """The problem on these windows, simulated with this tolerance."""
        return SimulatedProblem(self, windows, tolerance)


class SimulatedProblem:
    """Residuals and their derivatives; a Jacobian uses the solution that its residuals came from."""

    def __init__(self, problem: CalibrationProblem, windows: Windows, tolerance: float) -> None:
        self.problem, self.windows, self.tolerance = problem, windows, tolerance
        self._made: dict[bytes, WindowRuns] = {}

    def residuals(self, x: FloatArray) -> FloatArray:
        """Errors of q over `RESOLUTION`, then the prior's residuals, shape (samples + P,)."""
        problem, key = self.problem, x.tobytes()
        if key not in self._made:
            problem.evaluations += 1
            self._made[key] = simulate_windows(problem.parameters(x), self.windows, self.tolerance, problem.pool)
        return np.concatenate([self._made[key].errors / RESOLUTION, x])

    def jacobian(self, x: FloatArray) -> FloatArray:
        """Derivatives of the residuals where they were computed, shape (samples + P, P)."""
        problem, runs = self.problem, self._made[x.tobytes()]
        self._made = {x.tobytes(): runs}  # a search never goes back behind a point that it took
        steps = np.where(x + STEP <= problem.upper, STEP, -STEP)
        moved = [problem.parameters(x + step * unit) for step, unit in zip(steps, np.eye(x.size), strict=True)]
        return np.vstack([error_derivatives(runs, moved, steps, problem.pool) / RESOLUTION, np.eye(x.size)])


LOSS_SCALE = 3.0
"""Residual, in units of `RESOLUTION`, from which the soft-L1 loss grows linearly."""

START, UNDAMPED, WEAKEST, STRONGEST = 1e-3, 1e-6, 1e-9, 1e6
"""Damping, in units of the normal matrix' diagonal: first, too small to shorten a step, least, largest."""

WEAKENED, STRENGTHENED = 1.0 / 3.0, 4.0
"""Factors of the damping after a step as good as predicted, and after one that leads uphill."""

PREDICTED = 0.9
"""Share of the predicted fall of the cost below which a step is bent."""

HOPELESS = 20.0
"""Factor of the cost beyond which a step is shortened, not bent, and a start given up: windows end in a wrong well."""

BEND, LARGEST_BEND = 0.2, 0.75
"""Share of a step over which its bend is measured, and the largest bend, relative to the step, that is trusted."""

JUMP = 100.0
"""Second derivative of a residual along a step beyond which its window jumped to another well."""


@dataclass(frozen=True)
class Ended:
    """End of a search: unknowns, cost, residuals, whether it converged; evaluations of all searches so far."""

    x: FloatArray
    cost: float
    residuals: FloatArray
    converged: bool
    evaluations: int


@dataclass(frozen=True)
class _Point:
    x: FloatArray
    residuals: FloatArray
    cost: float


def loss_weights(residuals: FloatArray) -> FloatArray:
    """Factors of the residuals in the gradient of the soft-L1 loss."""
    return np.asarray((1.0 + (residuals / LOSS_SCALE) ** 2) ** -0.5)


def search(
    problem: SimulatedProblem, x0: FloatArray, limit: int, tolerance: float, tick: Callable[[], None],
    rival: float = np.inf,
) -> Ended:  # fmt: skip
    """Improve `x0` until the cost falls by less than `tolerance` (relative), or `limit` simulations are done.

    After half of them it ends, too, where the cost of a `rival` start is hopelessly far below.

    Notes
    -----
    Cost: a step takes a Jacobian and one simulation if it falls as predicted, three more if it is bent.
    """
    descent = _Search(problem, limit, tolerance)
    here, converged = descent.point(x0), False
    while not converged and descent.left > 0:
        if descent.left <= limit // 2 and here.cost > HOPELESS * rival:
            break
        tick()
        lower, converged = descent.step(here)
        if lower is None:
            break
        here = lower
    return Ended(here.x, here.cost, here.residuals, converged, problem.problem.evaluations)


class _Search:
    """The damping and the simulations that are left."""

    def __init__(self, problem: SimulatedProblem, limit: int, tolerance: float) -> None:
        self.problem, self.left, self.tolerance, self.damping = problem, limit, tolerance, START
        self.lower, self.upper = problem.problem.lower, problem.problem.upper

    def point(self, x: FloatArray) -> _Point:
        """Result of a simulation within the bounds."""
        self.left -= 1
        inside = np.clip(x, self.lower, self.upper)
        residuals = self.problem.residuals(inside)
        loss = np.sum(np.sqrt(1.0 + (residuals / LOSS_SCALE) ** 2) - 1.0)
        return _Point(inside, residuals, float(LOSS_SCALE**2 * loss))

    def step(self, here: _Point) -> tuple[_Point | None, bool]:
        """A point of lower cost or None, and whether no relevant fall is left."""
        jacobian, weights = self.problem.jacobian(here.x), loss_weights(here.residuals)
        weighted = weights[:, None] * jacobian
        slope, matrix = weighted.T @ here.residuals, weighted.T @ jacobian
        enough, raised = self.tolerance * here.cost, False
        while self.left > 0 and self.damping < STRONGEST:
            step, free = self._damped(matrix, slope, here.x)
            predicted = -float(slope @ step + 0.5 * step @ matrix @ step)
            if predicted < enough and not raised and self.damping > UNDAMPED:
                self.damping *= WEAKENED  # a damped step may be all that is small
                continue
            if predicted < enough:
                return None, not raised  # a step that many failed ones have shortened says nothing
            reached = self.point(here.x + step)
            if (
                here.cost - reached.cost < PREDICTED * predicted
                and reached.cost < HOPELESS * here.cost
                and self.left > 2
            ):
                bent = self._bent(here, step, free, matrix, weighted)
                reached = bent if bent is not None and bent.cost < reached.cost else reached
            fall = here.cost - reached.cost
            if fall > 0.0:
                surprise = (2.0 * fall / predicted - 1.0) ** 3
                self.damping = max(self.damping * max(WEAKENED, min(1.0 - surprise, 2.0)), WEAKEST)
                return reached, fall < enough and self.damping <= UNDAMPED
            self.damping, raised = self.damping * STRENGTHENED, True
        return None, False

    def _damped(self, matrix: FloatArray, slope: FloatArray, x: FloatArray) -> tuple[FloatArray, BoolArray]:
        """The damped step from x, bent at every bound that it meets, and which unknowns meet none."""
        damped, step = self._with_damping(matrix), np.zeros(x.size)
        free = ~((x <= self.lower) & (slope > 0.0) | (x >= self.upper) & (slope < 0.0))
        while free.any():
            rest = slope[free] + damped[np.ix_(free, ~free)] @ step[~free]
            ahead = np.zeros(x.size)
            ahead[free] = -np.linalg.solve(damped[np.ix_(free, free)], rest) - step[free]
            room = np.where(ahead > 0.0, self.upper - x - step, self.lower - x - step)
            shares = np.divide(room, ahead, out=np.ones(x.size), where=ahead != 0.0)
            share = max(0.0, min(1.0, float(shares[free].min())))
            step += share * ahead
            if share == 1.0:
                break
            free &= shares > share
        return step, free

    def _bent(
        self, here: _Point, step: FloatArray, free: BoolArray, matrix: FloatArray, weighted: FloatArray
    ) -> _Point | None:
        """The end of the step along the valley's bend; None if the bend is too strong."""
        ahead, behind = (self.point(here.x + share * step).residuals for share in (BEND, -BEND))
        second = (ahead + behind - 2.0 * here.residuals) / BEND**2
        second[np.abs(second) > JUMP] = 0.0
        bend = np.zeros(step.size)
        pull = (weighted.T @ second)[free]
        bend[free] = -0.5 * np.linalg.solve(self._with_damping(matrix)[np.ix_(free, free)], pull)
        scale = np.sqrt(np.diag(matrix))
        if np.linalg.norm(scale * bend) > LARGEST_BEND * np.linalg.norm(scale * step):
            return None
        return self.point(here.x + step + bend)

    def _with_damping(self, matrix: FloatArray) -> FloatArray:
        return matrix + self.damping * np.diag(np.diag(matrix))
