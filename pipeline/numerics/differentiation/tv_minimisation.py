"""The signal whose m-th derivative has the least total variation, by a primal-dual Newton method."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.differentiation.tv_newton import advance, duality_gap, newton_step, objective
from pipeline.numerics.differentiation.tv_newton_high_order import newton_step_high_order

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
    """``min over y of lam Σ sqrt(t_i² + delta²) + ½ Σ (y_i − b_i)²`` with t the (order + 1)-th difference of y.

    Attributes
    ----------
    b : FloatArray, shape (N,)
        Data less their first sample [signal]; N > order.
    lam, delta : float
        Weight and rounding of the variation [signal].
    order : int
        Order m of the difference whose variation is penalised.
    trapezoidal : bool
        m = 1 only: y is the trapezoidal sum of increments at the samples (Chartrand's small-scale form), with
        one more difference t_1 between the first two; otherwise the increments lie between the samples.
    fitted_start : bool
        Whether y_0 is an unknown with its misfit in the sum; otherwise ``y_0 = b_0``.
    """

    b: FloatArray
    lam: float
    delta: float
    order: int = 1
    trapezoidal: bool = False
    fitted_start: bool = False

    @property
    def differences(self) -> int:
        """Number of terms of the variation."""
        return self.b.size - self.order - (0 if self.trapezoidal else 1)

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
        self.problem = problem
        self.y, self.t, self.q, self.p, self.dy, self.dt, self.dp = (np.zeros(n) for _ in range(7))
        self.gains = np.empty((n, problem.order + 2))

    def find_step(self, delta: float) -> float:
        """Solve for the Newton step; return the longest dual step."""
        pb = self.problem
        state = (pb.b, self.y, self.t, self.q, self.p, pb.lam, delta)
        work = (1.0 if pb.fitted_start else 0.0, self.dy, self.dt, self.dp, self.gains)
        if pb.order == 1:
            return float(newton_step(*state, 0.5 if pb.trapezoidal else 1.0, *work))
        return float(newton_step_high_order(*state, pb.order, *work))

    def objective(self, delta: float, step: float = 0.0) -> float:
        """Objective less that of a straight line, `step` along the Newton direction."""
        pb = self.problem
        return float(objective(pb.b, self.y, self.t, self.dy, self.dt, step, pb.lam, delta))

    def gap(self, delta: float) -> float:
        """Duality gap."""
        pb = self.problem
        return float(duality_gap(pb.b, self.y, self.t, self.q, self.p, pb.lam, delta))

    def advance(self, primal: float, dual: float) -> None:
        """Take the step."""
        b = self.problem.b
        advance(b, self.y, self.t, self.q, self.p, self.dy, self.dt, self.dp, primal, dual)

    def shrink_dual(self) -> None:
        """Take all |p| away from 1; the pair (q, p) stays feasible, its constraints being linear and homogeneous."""
        self.p *= _PULL_BACK
        self.q *= _PULL_BACK


def minimise_variation(problem: VariationProblem, *, tolerance: float, max_iterations: int) -> Minimiser:
    """Minimise to a duality gap of `tolerance` times the objective (less that of a straight line).

    A large delta makes the problem nearly quadratic and Newton's method safe, so delta comes down in steps from
    the size of the data's own differences; each reduction starts from the solution before.  The primal step is
    halved until the objective falls, the dual one stays in |p| < 1.
    """
    if problem.differences == 0:
        return Minimiser(problem.b, np.zeros_like(problem.b), 0.0, 0.0, 0, "converged")
    it = _Iterate(problem)
    delta = max(problem.delta, _roughness(problem))
    value = it.objective(delta)
    status: Status = "iteration limit"
    iteration, pulled_back = 0, 0
    while iteration < max_iterations:
        iteration += 1
        dual = min(1.0, _TO_THE_BOUND * it.find_step(delta))
        primal, value = _descend(it, delta, value)
        it.advance(primal, dual)
        gap = it.gap(delta)
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
    constant = problem.lam * problem.delta * problem.differences
    return Minimiser(it.y, it.t, it.objective(problem.delta) + constant, it.gap(problem.delta), iteration, status)


def _roughness(problem: VariationProblem) -> float:
    """Mean size of the data's own differences [signal]; the median would be zero for a noise-free step."""
    differences = np.diff(problem.b, problem.order + 1)
    return float(np.abs(differences, out=differences).mean()) if differences.size else 0.0


def _descend(it: _Iterate, delta: float, value: float) -> tuple[float, float]:
    """Longest halving of the Newton step that does not raise the objective `value`, and the new objective."""
    step = 1.0
    while step > _LEAST_STEP:
        lower = it.objective(delta, step)
        if lower <= value * (1.0 + _OBJECTIVE_ROUNDING):
            return step, lower
        step *= 0.5
    return 0.0, value
