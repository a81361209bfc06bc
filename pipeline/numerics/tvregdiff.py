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
from .tv_minimisation import Minimiser, Status, VariationProblem, minimise_variation

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
    _check(data, order, start)
    _check_positive(dt=dt, alpha=alpha, epsilon=epsilon)
    columns = data[:, None] if data.ndim == 1 else data
    factors = None if weights is None else _checked_weights(weights, data.shape[0])
    derivative = np.empty_like(columns)
    integral = np.empty_like(columns)
    solved = []
    for k in range(columns.shape[1]):
        problem = VariationProblem(
            b=columns[:, k] - columns[0, k],
            lam=alpha / dt**order,
            delta=math.sqrt(epsilon) * dt**order,
            order=order,
            fitted_start=start == "fitted",
            weights=factors,
        )
        minimiser = minimise_variation(problem, tolerance=tolerance, max_iterations=max_iterations)
        solved.append(minimiser)
        integral[:, k] = columns[0, k] + minimiser.y
        derivative[:, k] = _at_samples(minimiser, dt, order)
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


def _check(data: FloatArray, order: int, start: str) -> None:
    if data.ndim not in (1, 2) or data.shape[0] < 2 or data.size == 0:
        raise InputError(f"tvregdiff needs (N,) or (N, k) samples with N ≥ 2, got shape {data.shape}")
    if not np.isfinite(data).all():
        raise InputError("tvregdiff needs finite samples: split the record at its gaps first")
    if start not in ("exact", "fitted") or order not in (1, 2, 3, 4):
        raise InputError(f"tvregdiff has no order={order!r}, start={start!r}")
    if data.shape[0] <= order:
        raise InputError(f"tvregdiff of order {order} needs more than {order} samples")


def _checked_weights(weights: ArrayLike, n: int) -> FloatArray:
    factors = np.asarray(weights, dtype=np.float64)
    if factors.shape != (n,) or not (np.isfinite(factors) & (factors > 0.0)).all():
        raise InputError(f"tvregdiff needs {n} positive, finite weights, one a sample, got shape {factors.shape}")
    return factors


def _check_positive(**parameters: float) -> None:
    for name, value in parameters.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(f"tvregdiff needs a positive, finite {name}, got {value}")


def _at_samples(minimiser: Minimiser, dt: float, order: int) -> FloatArray:
    """Derivative at the samples [signal/s]."""
    y = minimiser.y
    if order > 1:
        return finite_difference(y, dt, 1)
    return np.asarray(np.gradient(y, dt, edge_order=2 if y.size > 2 else 1))
