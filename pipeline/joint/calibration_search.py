"""Robust least squares within bounds: Levenberg-Marquardt steps that bend with the valley of the cost.

Materials and viscosities that act alike make the cost a narrow, curved valley, in which straight steps are short. The
second derivative of the residuals along a step says how the valley bends, and two more simulations tell it ("geodesic
acceleration": M. K. Transtrum, B. B. Machta, J. P. Sethna, Phys. Rev. E 83 (2011) 036701,
doi:10.1103/PhysRevE.83.036701).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pipeline.joint.calibration_problem import SimulatedProblem
from pipeline.numerics.arrays import BoolArray, FloatArray

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
    """Where a search ended: unknowns, cost, residuals, whether it converged; evaluations of all searches so far."""

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
    """What the soft-L1 loss multiplies the residuals by in its gradient."""
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
    made = _Search(problem, limit, tolerance)
    here, converged = made.point(x0), False
    while not converged and made.left > 0:
        if made.left <= limit // 2 and here.cost > HOPELESS * rival:
            break
        tick()
        found, converged = made.step(here)
        if found is None:
            break
        here = found
    return Ended(here.x, here.cost, here.residuals, converged, problem.problem.evaluations)


class _Search:
    """The damping and the simulations that are left."""

    def __init__(self, problem: SimulatedProblem, limit: int, tolerance: float) -> None:
        self.problem, self.left, self.tolerance, self.damping = problem, limit, tolerance, START
        self.lower, self.upper = problem.problem.lower, problem.problem.upper

    def point(self, x: FloatArray) -> _Point:
        """What a simulation gives, within the bounds."""
        self.left -= 1
        inside = np.clip(x, self.lower, self.upper)
        residuals = self.problem.residuals(inside)
        loss = np.sum(np.sqrt(1.0 + (residuals / LOSS_SCALE) ** 2) - 1.0)
        return _Point(inside, residuals, float(LOSS_SCALE**2 * loss))

    def step(self, here: _Point) -> tuple[_Point | None, bool]:
        """A point of lower cost, None if there is none; and whether no fall is left that matters."""
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
            found = self.point(here.x + step)
            if here.cost - found.cost < PREDICTED * predicted and found.cost < HOPELESS * here.cost and self.left > 2:
                bent = self._bent(here, step, free, matrix, weighted)
                found = bent if bent is not None and bent.cost < found.cost else found
            fall = here.cost - found.cost
            if fall > 0.0:
                surprise = (2.0 * fall / predicted - 1.0) ** 3
                self.damping = max(self.damping * max(WEAKENED, min(1.0 - surprise, 2.0)), WEAKEST)
                return found, fall < enough and self.damping <= UNDAMPED
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
        """The end of the step along the valley's bend; None if it bends too much to tell."""
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
