"""The signal whose m-th derivative has the least total variation, by a primal-dual Newton method."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from .arrays import FloatArray
from .tv_newton import Iterate, NewtonStep, advance, newton_step, objective

Status = Literal["converged", "iteration limit", "limited by rounding"]

_REDUCTION = 0.1
"""Factor from one rounding of the corner to the next."""
_CLOSE_ENOUGH = 0.1
"""Duality gap over objective at which the rounding is lowered."""
_TO_THE_BOUND = 0.9
"""Share of the longest dual step: iterates near |p| = 1 would block the steps after."""
_LEAST_STEP = 1e-9
_STUCK = 1e-6
"""Dual step below which some |p| have rounded to 1 and hold up all others; then the dual variables are shrunk."""
_PULL_BACK = 0.9
_MOST_PULLS = 10
_OBJECTIVE_ROUNDING = 1e-13


@dataclass(frozen=True)
class VariationProblem:
    """``min over y of lam Σ w_i sqrt(t_i² + delta²) + ½ Σ (y_i − b_i)²``, t the (order + 1)-th difference of y.

    Attributes
    ----------
    b : FloatArray, shape (N,)
        Data less their first sample [signal]; N > order.
    lam, delta : float
        Weight and rounding of the variation [signal].
    order : int
        Order m of the difference whose variation is penalised.
    fitted_start : bool
        Whether y_0 is an unknown with its misfit in the sum; otherwise ``y_0 = b_0``.
    weights : FloatArray, shape (N,), optional
        Positive factors on lam, one for each difference, aligned with the later sample; the first are not used.
    """

    b: FloatArray
    lam: float
    delta: float
    order: int = 1
    fitted_start: bool = False
    weights: FloatArray | None = None

    @property
    def differences(self) -> int:
        """Number of terms of the variation."""
        return self.b.size - self.order - 1

    def lam_of_terms(self) -> FloatArray:
        """Weight of each difference, shape (N,) [signal]."""
        return np.full(self.b.size, self.lam) if self.weights is None else self.lam * self.weights

    def rounding(self) -> float:
        """Duality gap that rounding leaves, of the data and of dual variables near zero [signal²]."""
        eps = np.finfo(np.float64).eps
        data = self.b.size * (4.0 * eps * np.abs(self.b).max()) ** 2
        return float(data + self.differences * self.lam * self.delta * eps**2)


@dataclass(frozen=True)
class Minimiser:
    """The minimiser of a `VariationProblem` as far as it was found.

    Attributes
    ----------
    y, t : FloatArray, shape (N,)
        Regularised signal and its differences, ``t`` aligned with the later sample and zero where there is none.
    objective, gap : float
        Objective, and its distance from the minimum at most [signal²].
    iterations : int
        Newton steps.
    status : {"converged", "iteration limit", "limited by rounding"}
        Why the iteration stopped.
    """

    y: FloatArray
    t: FloatArray
    objective: float
    gap: float
    iterations: int
    status: Status


class _Iterate:
    """Unknowns, dual variables and Newton step; starts from the feasible constant signal."""

    def __init__(self, problem: VariationProblem) -> None:
        n = problem.b.size
        y, t, q, p, dy, dt, dp = (np.zeros(n) for _ in range(7))
        self.problem = problem
        self.at = Iterate(problem.b, y, t, q, p, problem.lam_of_terms())
        self.step = NewtonStep(dy, dt, dp, np.empty((n, problem.order + 2)))

    def find_step(self, delta: float) -> tuple[float, float]:
        """Solve for the Newton step; return the longest dual step and the objective after a full one."""
        problem = self.problem
        return newton_step(self.at, self.step, delta, problem.order, 1.0 if problem.fitted_start else 0.0)

    def objective(self, delta: float, share: float = 0.0) -> float:
        """Objective less that of a straight line, a `share` along the Newton step."""
        return float(objective(self.at, self.step, share, delta))

    def advance(self, delta: float, primal: float, dual: float) -> float:
        """Take the step; return the duality gap."""
        return float(advance(self.at, self.step, primal, dual, delta))

    def shrink_dual(self) -> None:
        """Take all |p| away from 1; the pair (q, p) stays feasible, its constraints being linear and homogeneous."""
        self.at.p[:] *= _PULL_BACK
        self.at.q[:] *= _PULL_BACK


def minimise_variation(problem: VariationProblem, *, tolerance: float, max_iterations: int) -> Minimiser:
    """Minimise to a duality gap of `tolerance` times the objective (less that of a straight line).

    A large delta makes the problem nearly quadratic and Newton's method safe, so delta comes down in steps from
    the size of the data's own differences; each reduction starts from the solution before.  The primal step is
    halved until the objective is at most the one before plus the gap, which falls; the dual one stays in |p| < 1.
    """
    if problem.differences == 0:
        return Minimiser(problem.b, np.zeros_like(problem.b), 0.0, 0.0, 0, "converged")
    it = _Iterate(problem)
    delta = max(problem.delta, _roughness(problem))
    value = it.objective(delta)
    status: Status = "iteration limit"
    gap = 0.0
    iteration = 0
    pulled_back = 0
    while iteration < max_iterations:
        iteration += 1
        longest, full = it.find_step(delta)
        primal, value = _descend(it, delta, value + gap, full)
        dual = min(1.0, _TO_THE_BOUND * longest)
        gap = it.advance(delta, primal, dual)
        if delta == problem.delta:
            if gap <= tolerance * value + problem.rounding():
                status = "converged"
                break
            if dual < _STUCK:
                if primal == 0.0 and pulled_back > _MOST_PULLS:
                    status = "limited by rounding"
                    break
                pulled_back += 1
                it.shrink_dual()
        elif gap <= _CLOSE_ENOUGH * value:
            delta = max(problem.delta, _REDUCTION * delta)
            value = it.objective(delta)
    constant = problem.delta * float(it.at.lam[problem.b.size - problem.differences :].sum())
    return Minimiser(
        it.at.y, it.at.t, it.objective(problem.delta) + constant, it.advance(problem.delta, 0.0, 0.0), iteration, status
    )


def _roughness(problem: VariationProblem) -> float:
    """Mean size of the data's own differences [signal]; the median would be zero for a noise-free step."""
    differences = np.diff(problem.b, problem.order + 1)
    return float(np.abs(differences, out=differences).mean()) if differences.size else 0.0


def _descend(it: _Iterate, delta: float, highest: float, full: float) -> tuple[float, float]:
    """Longest halving of the Newton step after which the objective is at most `highest`, and the objective there.

    `full` is the objective after the whole step.
    """
    step = 1.0
    value = full
    while value > highest * (1.0 + _OBJECTIVE_ROUNDING):
        step *= 0.5
        if step < _LEAST_STEP:
            return 0.0, it.objective(delta)
        value = it.objective(delta, step)
    return step, value
