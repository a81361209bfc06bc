"""TVRegDiff: differentiation with total-variation regularisation, to convergence, in linear time.

The functional is Chartrand's (2011, eq. 3). With N samples ``y_0 … y_n`` (n = N − 1), step h, ``b_i = y_i − y_0`` and
``x`` the regularised signal less ``y_0``, the unknowns are the increments: ``u_i = (x_i − x_{i−1})/h`` for i = 1…n is
the derivative between two samples, ``x_0 = 0``, and

    ``J = alpha Σ_{j=1}^{n−1} sqrt((u_{j+1} − u_j)² + epsilon) + ½ Σ_{i=1}^{n} (x_i − b_i)²``.

Published codes begin the antiderivative one step before the first sample, as if that were there twice. That pulls the
first slope to zero, so that a straight line is not reproduced.

References
----------
R. Chartrand, Numerical differentiation of noisy, nonsmooth data, ISRN Appl. Math. 2011, 164564,
doi:10.5402/2011/164564.
"""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InputError
from .arrays import FloatArray
from .linear_filters import finite_difference
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
        True if y_0 is an unknown with its misfit in the sum; otherwise ``y_0 = b_0``.
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
        Reason for the end of the iteration.
    """

    y: FloatArray
    t: FloatArray
    objective: float
    gap: float
    iterations: int
    status: Status


def minimise_variation(problem: VariationProblem, *, tolerance: float, max_iterations: int) -> Minimiser:
    """Minimise to a duality gap of `tolerance` times the objective (less that of a straight line).

    A large delta makes the problem nearly quadratic and Newton's method safe, so delta comes down in steps from
    the size of the data's own differences; each reduction starts from the solution before.  The primal step is
    halved until the objective is at most the one before plus the gap, which falls; the dual one stays in |p| < 1.
    """
    if problem.differences == 0:
        return Minimiser(
            y=problem.b, t=np.zeros_like(problem.b), objective=0.0, gap=0.0, iterations=0, status="converged"
        )
    n = problem.b.size
    y, t, q, p, dy, dt, dp = np.zeros((7, n))
    at = Iterate(b=problem.b, y=y, t=t, q=q, p=p, lam=problem.lam_of_terms())  # the feasible constant signal
    step = NewtonStep(dy, dt, dp, np.empty((n, problem.order + 2)))
    # From the mean size of the data's own differences on; the median would be zero for a noise-free step.
    delta = max(problem.delta, float(np.abs(np.diff(problem.b, problem.order + 1)).mean()))
    value = objective(at, step, 0.0, delta)
    status: Status = "iteration limit"
    gap = 0.0
    iteration = 0
    pulled_back = 0
    while iteration < max_iterations:
        iteration += 1
        longest, full = newton_step(at, step, delta, problem.order, float(problem.fitted_start))
        primal, value = _descend(at, step, delta, value + gap, full)
        dual = min(1.0, _TO_THE_BOUND * longest)
        gap = advance(at, step, primal, dual, delta)
        if delta == problem.delta:
            if gap <= tolerance * value + problem.rounding():
                status = "converged"
                break
            if dual < _STUCK:
                if primal == 0.0 and pulled_back > _MOST_PULLS:
                    status = "limited by rounding"
                    break
                pulled_back += 1
                # The pair (q, p) stays feasible, its constraints being linear and homogeneous.
                at.p[:] *= _PULL_BACK
                at.q[:] *= _PULL_BACK
        elif gap <= _CLOSE_ENOUGH * value:
            delta = max(problem.delta, _REDUCTION * delta)
            value = objective(at, step, 0.0, delta)
    straight = problem.delta * float(at.lam[n - problem.differences :].sum())
    return Minimiser(
        y=at.y,
        t=at.t,
        objective=objective(at, step, 0.0, problem.delta) + straight,
        gap=advance(at, step, 0.0, 0.0, problem.delta),
        iterations=iteration,
        status=status,
    )


def _descend(at: Iterate, step: NewtonStep, delta: float, highest: float, value: float) -> tuple[float, float]:
    """Longest halving of the Newton step after which the objective is at most `highest`, and the objective there.

    `value` is the objective after the whole step.
    """
    share = 1.0
    while value > highest * (1.0 + _OBJECTIVE_ROUNDING):
        share *= 0.5
        if share < _LEAST_STEP:
            return 0.0, objective(at, step, 0.0, delta)
        value = objective(at, step, share, delta)
    return share, value


Order = Literal[1, 2, 3, 4]
Start = Literal["exact", "fitted"]


@dataclass(frozen=True)
class TvDerivative:
    """Derivative and regularised signal of `tvregdiff`, with the evidence that they are the minimiser.

    Attributes
    ----------
    derivative : FloatArray, shape (N,) or (N, k)
        Derivative at the samples [signal/s].
    integral : FloatArray, shape (N,) or (N, k)
        Regularised signal at the samples [signal]: the first sample plus the antiderivative.
    objective : float
        The functional J [signal²], summed over channels.
    gap : float
        Duality gap [signal²]: J exceeds its minimum by at most this; ``½‖integral − minimiser‖² ≤ gap``.
    iterations : int
        Newton steps of the slowest channel.
    converged : bool
        True if every channel met the tolerance.
    status : {"converged", "iteration limit", "limited by rounding"}
        Reason for the end of the slowest channel.
    """

    derivative: FloatArray
    integral: FloatArray
    objective: float
    gap: float
    iterations: int
    converged: bool
    status: Status


def tvregdiff(
    samples: ArrayLike,
    dt: float,
    *,
    alpha: float,
    epsilon: float = 1e-6,
    order: Order = 1,
    start: Start = "exact",
    weights: ArrayLike | None = None,
    tolerance: float = 1e-10,
    max_iterations: int = 200,
) -> TvDerivative:
    """Differentiate a uniformly sampled signal with total-variation regularisation of its derivative.

    Parameters
    ----------
    samples : array_like, shape (N,) or (N, k)
        Signal, at least two samples; columns are independent channels.
    dt : float
        Sampling interval [s].
    alpha : float
        Weight of the variation [signal·s]; 0.01 in the paper, for a signal in millimetres.
    epsilon : float, default 1e-6
        Rounding of the modulus [(signal/s)²].
        Scaling the signal by s together with ``alpha·s`` and ``epsilon·s²`` scales the derivative by s.
    order : {1, 2, 3, 4}, default 1
        Derivative m whose variation is penalised: m = 1 is the published method and leaves steps in the second
        derivative; with ``Δ^m x/h^m`` in place of u it leaves them in derivative m + 1.  Then alpha is in
        [signal·s^m], epsilon in [(signal/s^m)²].
    start : {"exact", "fitted"}, default "exact"
        ``exact``: the antiderivative starts in the first sample, whatever its noise.  ``fitted``: the start is
        estimated too, and the misfit of the first sample added to J.
    weights : array_like, shape (N,), optional
        Positive factors on alpha, one for each term of the variation, at the last of the ``order + 2`` samples that
        it spans (the values before the first such sample are not used): `jump_weights` makes them.
    tolerance : float, default 1e-10
        Duality gap over (J less its value for a straight line) at which the iteration stops.
    max_iterations : int, default 200
        Newton steps; 10 to 50 are usual.

    Returns
    -------
    TvDerivative

    Notes
    -----
    The objective that is returned is the module's J: with ``x = integral − samples[0]`` and ``u = diff(x)/dt``,
    ``J = alpha·sum(sqrt(diff(u)² + epsilon)) + ½·sum((x − b)²)``.

    The unknown derivative lies between the samples; what is returned is the mean of both neighbours, and at the ends
    their linear continuation, so it is not shifted by half a sample.  Higher orders are read off by finite differences
    of high order.

    Time and memory are linear in N (`pipeline.numerics.tv_newton`), with 10 to 50 Newton steps.

    Raises
    ------
    InputError
        Fewer than two samples, a sample that is not finite, or a parameter out of range.
    """
    data = np.asarray(samples, dtype=np.float64)
    factors = None if weights is None else np.asarray(weights, dtype=np.float64)
    _check(data, factors, order, start, dt=dt, alpha=alpha, epsilon=epsilon)
    columns = data[:, None] if data.ndim == 1 else data

    solved = []
    for column in columns.T:
        problem = VariationProblem(
            b=column - column[0],
            lam=alpha / dt**order,
            delta=math.sqrt(epsilon) * dt**order,
            order=order,
            fitted_start=start == "fitted",
            weights=factors,
        )
        solved.append(minimise_variation(problem, tolerance=tolerance, max_iterations=max_iterations))
    derivative = np.stack([_at_samples(channel.y, dt, order) for channel in solved], axis=1)
    integral = columns[0] + np.stack([channel.y for channel in solved], axis=1)
    slowest = max(solved, key=lambda channel: (channel.status != "converged", channel.iterations))
    return TvDerivative(
        derivative=derivative.reshape(data.shape),
        integral=integral.reshape(data.shape),
        objective=sum(channel.objective for channel in solved),
        gap=sum(channel.gap for channel in solved),
        iterations=max(channel.iterations for channel in solved),
        converged=slowest.status == "converged",
        status=slowest.status,
    )


def _check(data: FloatArray, factors: FloatArray | None, order: int, start: str, **positive: float) -> None:
    if data.ndim not in (1, 2) or data.shape[0] < 2 or data.size == 0:
        raise InputError(f"tvregdiff needs (N,) or (N, k) samples with N ≥ 2, got shape {data.shape}")
    if not np.isfinite(data).all():
        raise InputError("tvregdiff needs finite samples: split the record at its gaps first")
    if start not in ("exact", "fitted") or order not in (1, 2, 3, 4):
        raise InputError(f"tvregdiff has no order={order!r}, start={start!r}")
    if data.shape[0] <= order:
        raise InputError(f"tvregdiff of order {order} needs more than {order} samples")
    for name, value in positive.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(f"tvregdiff needs a positive, finite {name}, got {value}")
    n = data.shape[0]
    if factors is not None and (factors.shape != (n,) or not (np.isfinite(factors) & (factors > 0.0)).all()):
        raise InputError(f"tvregdiff needs {n} positive, finite weights, one a sample, got shape {factors.shape}")


def _at_samples(y: FloatArray, dt: float, order: int) -> FloatArray:
    """Derivative of the regularised signal at the samples [signal/s]."""
    if order > 1:
        return finite_difference(y, dt, 1)
    return np.asarray(np.gradient(y, dt, edge_order=2 if y.size > 2 else 1))
