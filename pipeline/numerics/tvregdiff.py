"""TVRegDiff: differentiation with total-variation regularisation, to convergence, in linear time.

The functional is Chartrand's (2011, eq. 3), in the two discrete forms that are in use.  With N samples
``y_0 … y_n`` (n = N − 1), step h, ``b_i = y_i − y_0`` and ``x`` the regularised signal less ``y_0``:

``large`` (the default; increments are the unknowns, ``x_0 = 0``)
    ``u_i = (x_i − x_{i−1})/h`` for i = 1…n is the derivative between two samples,
    ``J = alpha Σ_{j=1}^{n−1} sqrt((u_{j+1} − u_j)² + epsilon) + ½ Σ_{i=1}^{n} (x_i − b_i)²``.

``small`` (values at the samples are the unknowns, trapezoidal antiderivative)
    ``u_0 … u_n`` at the samples, ``x_i = h (½u_0 + u_1 + … + u_{i−1} + ½u_i)``,
    ``J = alpha h Σ_{j=0}^{n−1} sqrt(((u_{j+1} − u_j)/h)² + epsilon) + ½ Σ_{i=1}^{n} (x_i − b_i)²``.

Published codes number the samples ``y_1 … y_n`` (n = N) in the same formulas and take ``b_i = y_i − y_1``: the
antiderivative then starts one step before the first sample, as if that were there twice, which pulls the first
slope to zero, so that a straight line is not reproduced.  That is ``start="published"``.

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

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.linear_filters import finite_difference
from pipeline.numerics.tv_minimisation import Minimiser, Status, VariationProblem, minimise_variation

Form = Literal["large", "small"]
Order = Literal[1, 2, 3, 4]
Start = Literal["exact", "fitted", "published"]


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
        Whether every channel met the tolerance.
    status : {"converged", "iteration limit", "limited by rounding"}
        Why the slowest channel stopped.
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
    form: Form = "large",
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
        Rounding of the modulus: [(signal/s)²] in the form ``large``, [(signal/s²)²] in ``small``.
        Scaling the signal by s together with ``alpha·s`` and ``epsilon·s²`` scales the derivative by s.
    order : {1, 2, 3, 4}, default 1
        Derivative m whose variation is penalised: m = 1 is the published method and leaves steps in the second
        derivative; with ``Δ^m x/h^m`` in place of u it leaves them in derivative m + 1.  Then alpha is in
        [signal·s^m], epsilon in [(signal/s^m)²], and the form is ``large``.
    form : {"large", "small"}, default "large"
        Discrete functional, see the module.
    start : {"exact", "fitted", "published"}, default "exact"
        ``exact``: the antiderivative starts in the first sample, whatever its noise.  ``fitted``: the start is
        estimated too, and the misfit of the first sample added to J.  ``published``: it starts one step before
        the first sample, as in the original codes (the sums of J then run over one term more).
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
    The objective that is returned is the module's J of the chosen form.  From the result, ``large`` (the default):
    ``x = integral − samples[0]``, ``u = diff(x)/dt``, ``J = alpha·sum(sqrt(diff(u)² + epsilon)) + ½·sum((x − b)²)``;
    ``small``: the same with ``u = derivative`` and ``alpha·dt·sum(sqrt((diff(u)/dt)² + epsilon))``.

    In the form ``large`` the unknown derivative lies between the samples; what is returned is the mean of both
    neighbours, and at the ends their linear continuation, so it is not shifted by half a sample.  In ``small`` the
    unknowns are the values at the samples.  Higher orders are read off by finite differences of high order.

    Time and memory are linear in N (`pipeline.numerics.tv_newton`), with 10 to 50 Newton steps.

    Raises
    ------
    InputError
        Fewer than two samples, a sample that is not finite, or a parameter out of range.
    """
    data = np.asarray(samples, dtype=np.float64)
    _check(data, order, form, start)
    _check_positive(dt=dt, alpha=alpha, epsilon=epsilon)
    columns = data[:, None] if data.ndim == 1 else data
    factors = None if weights is None else _checked_weights(weights, data.shape[0])
    if start == "published":
        columns = np.concatenate((columns[:1], columns))
        factors = None if factors is None else np.concatenate((factors[:1], factors))
    derivative, integral = np.empty_like(columns), np.empty_like(columns)
    solved = []
    for k in range(columns.shape[1]):
        problem = VariationProblem(
            b=columns[:, k] - columns[0, k],
            lam=alpha / dt**order,
            delta=math.sqrt(epsilon) * dt ** (2 if form == "small" else order),
            order=order,
            trapezoidal=form == "small",
            fitted_start=start == "fitted",
            weights=factors,
        )
        minimiser = minimise_variation(problem, tolerance=tolerance, max_iterations=max_iterations)
        solved.append(minimiser)
        integral[:, k] = columns[0, k] + minimiser.y
        derivative[:, k] = _at_samples(minimiser, dt, problem)
    slowest = max(solved, key=lambda channel: (channel.status != "converged", channel.iterations))
    return TvDerivative(
        derivative=derivative[-data.shape[0] :].reshape(data.shape),
        integral=integral[-data.shape[0] :].reshape(data.shape),
        objective=sum(channel.objective for channel in solved),
        gap=sum(channel.gap for channel in solved),
        iterations=max(channel.iterations for channel in solved),
        converged=slowest.status == "converged",
        status=slowest.status,
    )


def _check(data: FloatArray, order: int, form: str, start: str) -> None:
    if data.ndim not in (1, 2) or data.shape[0] < 2 or data.size == 0:
        raise InputError(f"tvregdiff needs (N,) or (N, k) samples with N ≥ 2, got shape {data.shape}")
    if not np.isfinite(data).all():
        raise InputError("tvregdiff needs finite samples: split the record at its gaps first")
    if form not in ("large", "small") or start not in ("exact", "fitted", "published") or order not in (1, 2, 3, 4):
        raise InputError(f"tvregdiff has no order={order!r}, form={form!r}, start={start!r}")
    if data.shape[0] <= order or (form == "small" and order != 1):
        raise InputError(f"tvregdiff of order {order} needs more than {order} samples and the form 'large'")


def _checked_weights(weights: ArrayLike, n: int) -> FloatArray:
    factors = np.asarray(weights, dtype=np.float64)
    if factors.shape != (n,) or not (np.isfinite(factors) & (factors > 0.0)).all():
        raise InputError(f"tvregdiff needs {n} positive, finite weights, one a sample, got shape {factors.shape}")
    return factors


def _check_positive(**parameters: float) -> None:
    for name, value in parameters.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(f"tvregdiff needs a positive, finite {name}, got {value}")


def _at_samples(minimiser: Minimiser, dt: float, problem: VariationProblem) -> FloatArray:
    """Derivative at the samples [signal/s]."""
    y, t = minimiser.y, minimiser.t
    if problem.trapezoidal:
        return np.asarray((y[1] - y[0] - 0.5 * t[1] + np.cumsum(t)) / dt)
    if problem.order > 1:
        return finite_difference(y, dt, 1)
    return np.asarray(np.gradient(y, dt, edge_order=2 if y.size > 2 else 1))
