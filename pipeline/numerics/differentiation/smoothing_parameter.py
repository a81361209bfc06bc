"""Automatic alpha and epsilon of TVRegDiff: the evidence for the prior that the functional implies.

With white noise of standard deviation sigma, the functional of order m is sigma² times the negative logarithm of a
posterior in which the increments w of derivative m are independent with the hyperbolic density

    p(w) ∝ exp(−c² sqrt(1 + (w/s)²)),   so that   alpha = c² sigma²/s,   epsilon = s²,

Gaussian below s and exponential above.  sigma comes from the record (`noise.noise_std`), the shape c² is fixed, and
the scale s follows from the record by MacKay's re-estimation: the data determine gamma of the M increments (the
effective number of parameters, `tv_chain.effective_parameters`), and so many should have the size that the prior
expects,

    c² Σ w²/(s sqrt(s² + w²)) = gamma.

With gamma = M this would be the scale of greatest likelihood of the increments themselves; but those of a smoothed
signal are smaller than the truth's, and the scale would shrink with them.  Solving and re-estimating alternate,
accelerated by secants in log s, until s changes by less than a twentieth.

References
----------
D. J. C. MacKay, Bayesian interpolation, Neural Computation 4 (1992) 415-447, doi:10.1162/neco.1992.4.3.415, eq. 4.9.
O. Barndorff-Nielsen, Exponentially decreasing distributions for the logarithm of particle size, Proc. R. Soc. A 353
(1977) 401-419, doi:10.1098/rspa.1977.0041.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.differentiation.noise import noise_std
from pipeline.numerics.differentiation.tv_chain import effective_parameters
from pipeline.numerics.differentiation.tv_minimisation import VariationProblem, minimise_variation

SHAPE = 0.3
"""c² of the hyperbolic density; from 0.1 to 1 the errors of both derivatives change by a sixth at most."""
_SAME_SCALE = 0.05
_ROUNDS = 25
_LONGEST_SECANT = 4.0
_SEARCH_TOLERANCE = 1e-6
_NOTHING = 0.5
"""Effective parameters below which the record is a polynomial and noise."""


@dataclass(frozen=True)
class SmoothingParameter:
    """Parameters of `tvregdiff` for one record.

    Attributes
    ----------
    alpha : float
        Weight of the variation [signal·s^m].
    epsilon : float
        Rounding of the modulus [(signal/s^m)²].
    noise_std : float
        Estimated standard deviation sigma of the noise [signal].
    effective_parameters : float
        Number gamma of increments that the data determine.
    settled : bool
        Whether the scale of the increments stopped changing.
    """

    alpha: float
    epsilon: float
    noise_std: float
    effective_parameters: float
    settled: bool


def smoothing_parameter(samples: FloatArray, dt: float, order: int) -> SmoothingParameter:
    """Choose alpha and epsilon for a record that is not constant.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Uniformly sampled record, N > order + 1, not constant.
    dt : float
        Sampling interval [s].
    order : int
        Derivative m whose variation is penalised.

    Returns
    -------
    SmoothingParameter
        Deterministic.  The cost is that of four to ten minimisations at a tolerance of 1e-6.
    """
    sigma = noise_std(samples)
    increments = samples.size - order - 1
    log_scale, before = float(np.log(sigma)), None
    settled = False
    for _ in range(_ROUNDS):
        scale = float(np.exp(log_scale))  # of the differences in steps [signal]
        problem = VariationProblem(
            b=samples - samples[0], lam=SHAPE * sigma**2 / scale, delta=scale, order=order, fitted_start=True
        )
        t = minimise_variation(problem, tolerance=_SEARCH_TOLERANCE, max_iterations=100).t
        determined = float(effective_parameters(t, problem.lam, problem.delta, order))
        if determined < _NOTHING or not t.any():
            settled = True
            break
        change = float(np.log(increment_scale(t[order + 1 :], determined / increments))) - log_scale
        if abs(change) < _SAME_SCALE:
            settled = True
            break
        stretch = 1.0
        if before is not None and change * before[1] > 0.0 and abs(change) < abs(before[1]):
            stretch = min(_LONGEST_SECANT, (log_scale - before[0]) / (before[1] - change))
        before = (log_scale, change)
        log_scale += stretch * change
    return SmoothingParameter(
        alpha=problem.lam * dt**order,
        epsilon=(problem.delta / dt**order) ** 2,
        noise_std=sigma,
        effective_parameters=determined,
        settled=settled,
    )


def increment_scale(increments: FloatArray, share: float) -> float:
    """Scale s that solves ``c² mean(w²/(s sqrt(s² + w²))) = share``, by Newton's method in log s from above.

    Parameters
    ----------
    increments : FloatArray, shape (M,)
        Increments w, not all zero, any unit.
    share : float
        Share of the increments that the data determine, gamma/M; 1 for increments that are known.

    Returns
    -------
    float
        s in the unit of `increments`.
    """
    squares = increments**2
    s2 = SHAPE * float(squares.mean()) / share  # an upper bound, as sqrt(s² + w²) ≥ s
    for _ in range(200):
        root = np.sqrt(s2 + squares)
        s = np.sqrt(s2)
        balance = SHAPE * float(np.mean(squares / root)) / s
        slope = balance + SHAPE * float(np.mean(squares * s2 / root**3)) / s
        step = float(np.log(balance / share)) * balance / slope
        s2 *= float(np.exp(2.0 * step))
        if abs(step) < 1e-6:
            break
    return float(np.sqrt(s2))
