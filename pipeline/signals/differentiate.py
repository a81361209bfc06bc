"""Velocity and acceleration of a displacement record: one signature for all differentiators, and automatic parameters.

The default penalises the variation of the third derivative (order 3): neither velocity nor acceleration has steps
where the truth has none.  The derivatives of the regularised signal are taken by finite differences of high order
at the samples themselves; nothing is shifted by half a sample.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..numerics.linear_filters import finite_difference, finite_difference_at_jumps
from ..numerics.metrics import rms
from ..numerics.tv_newton import effective_parameters
from ..numerics.tvregdiff import Order, TvDerivative, VariationProblem, minimise_variation, tvregdiff
from .noise import noise_std

SHAPE = 0.3
"""c² of the hyperbolic density; from 0.1 to 1 the errors of both derivatives change by a sixth at most."""
SHAPE_REWEIGHTED = 2.0
"""c² = nu + 1 of the density with reweighting; from 1 to 2 the errors change little."""
_SAME_SCALE = 0.05
_ROUNDS = 25
_LONGEST_SECANT = 4.0
_SEARCH_TOLERANCE = 1e-3
"""Of a minimisation within the search, whose scale need not be known better than by a twentieth."""
PAPER_EPSILON = 1e-6
"""Rounding of the variation's corner beside a given α, for q in mm [(mm/s^order)²], degrees or mV."""
_WINDOW = 14.0
"""Window of the Savitzky-Golay filter in memory lengths of the smoother with the same noise and increments."""
_DEGREE = 5  # of the polynomials in a window


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
    settled : bool
        True if the scale of the increments stopped changing.
    weights : FloatArray, shape (N,), optional
        Weights of the variation's terms, with reweighting.
    """

    alpha: float
    epsilon: float
    noise_std: float
    settled: bool
    weights: FloatArray | None = None


def smoothing_parameter(samples: FloatArray, dt: float, order: int, *, reweighted: bool = False) -> SmoothingParameter:
    """Choose alpha, epsilon and, with reweighting, the weights for a record that is not constant.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Uniformly sampled record, N > order + 1, not constant.
    dt : float
        Sampling interval [s].
    order : int
        Derivative m whose variation is penalised.
    reweighted : bool
        True if the record may jump: Cauchy's density for the increments instead of the hyperbolic one.

    Returns
    -------
    SmoothingParameter
        Deterministic.  The cost is that of four to ten minimisations at a tolerance of 1e-3.

    Notes
    -----
    With white noise of standard deviation sigma, the functional of order m is sigma² times the negative logarithm of a
    posterior in which the increments w of derivative m are independent with the hyperbolic density

        p(w) ∝ exp(−c² sqrt(1 + (w/s)²)),   so that   alpha = c² sigma²/s,   epsilon = s²,

    Gaussian below s and exponential above. sigma comes from the record (`noise.noise_std`), the shape c² is fixed, and
    the scale s follows from the record by MacKay's re-estimation: the data determine gamma of the M increments (the
    effective number of parameters, `tv_newton.effective_parameters`), and so many should have the size that the prior
    expects,

        c² Σ w²/(s sqrt(s² + w²)) = gamma.

    Where the signal may jump, that prior is too narrow: one large increment costs as much as it is high. The reweighted
    variation (`jump_weights`) stands for Student's t with nu degrees of freedom, c² = nu + 1, whose EM algorithm it is:
    each round weights the terms by the increments of the round before, and the weights enter the equation above. nu =
    1, Cauchy's density.

    With gamma = M this would be the scale of greatest likelihood of the increments themselves. But those of a smoothed
    signal are smaller than the truth's, and the scale would shrink with them. Solving and re-estimating alternate,
    accelerated by secants in log s, until s changes by less than a twentieth.

    References
    ----------
    D. J. C. MacKay, Bayesian interpolation, Neural Computation 4 (1992) 415-447, doi:10.1162/neco.1992.4.3.415, eq.
    4.9.
    O. Barndorff-Nielsen, Exponentially decreasing distributions for the logarithm of particle size, Proc. R. Soc. A 353
    (1977) 401-419, doi:10.1098/rspa.1977.0041.
    K. L. Lange, R. J. A. Little, J. M. G. Taylor, Robust statistical modeling using the t distribution, J. Amer.
    Statist. Assoc. 84 (1989) 881-896, doi:10.1080/01621459.1989.10478852.
    """
    sigma = noise_std(samples)
    increments = samples.size - order - 1
    shape = SHAPE_REWEIGHTED if reweighted else SHAPE
    weights = np.ones(samples.size)
    log_scale = float(np.log(sigma))
    before = None
    settled = True
    t = None
    for _ in range(_ROUNDS):
        scale = float(np.exp(log_scale))  # of the differences in steps [signal]
        if reweighted and t is not None:
            weights = jump_weights(t, scale, order)
        problem = VariationProblem(
            b=samples - samples[0],
            lam=shape * sigma**2 / scale,
            delta=scale,
            order=order,
            fitted_start=True,
            weights=weights,
        )
        t = minimise_variation(problem, tolerance=_SEARCH_TOLERANCE, max_iterations=100).t
        determined = float(effective_parameters(t, problem.lam_of_terms(), problem.delta, order))
        if round(determined) == 0 or not t.any():  # a polynomial and noise
            break
        target = increment_scale(t[order + 1 :], determined / increments, shape, weights[order + 1 :])
        change = float(np.log(target)) - log_scale
        if abs(change) < _SAME_SCALE:
            break
        factor = _step_factor(log_scale, change, before)
        before = (log_scale, change)
        log_scale += factor * change
    else:
        settled = False
    return SmoothingParameter(
        alpha=problem.lam * dt**order,
        epsilon=(problem.delta / dt**order) ** 2,
        noise_std=sigma,
        settled=settled,
        weights=weights if reweighted else None,
    )


def _step_factor(log_scale: float, change: float, before: tuple[float, float] | None) -> float:
    """Factor on the re-estimated `change`: a secant while changes shrink, a half where they alternate."""
    if before is None or abs(change) >= abs(before[1]):
        return 1.0
    if change * before[1] < 0.0:
        return 0.5
    return min(_LONGEST_SECANT, (log_scale - before[0]) / (before[1] - change))


def increment_scale(increments: FloatArray, share: float, shape: float, weights: FloatArray) -> float:
    """Scale s that solves ``c² mean(k w²/(s sqrt(s² + w²))) = share``, by Newton's method in log s from above.

    Parameters
    ----------
    increments : FloatArray, shape (M,)
        Increments w, not all zero, any unit.
    share : float
        Share of the increments that the data determine, gamma/M; 1 for increments that are known.
    shape : float
        c².
    weights : FloatArray, shape (M,)
        Weights k of the increments.

    Returns
    -------
    float
        s in the unit of `increments`.
    """
    squares = increments**2
    s2 = shape * float(np.mean(weights * squares)) / share  # an upper bound, as sqrt(s² + w²) ≥ s
    for _ in range(200):
        root = np.sqrt(s2 + squares)
        s = np.sqrt(s2)
        balance = shape * float(np.mean(weights * squares / root)) / s
        slope = balance + shape * float(np.mean(weights * squares * s2 / root**3)) / s
        step = float(np.log(balance / share)) * balance / slope
        s2 *= float(np.exp(2.0 * step))
        if abs(step) < 1e-6:
            break
    return float(np.sqrt(s2))


def jump_weights(t: FloatArray, delta: float, order: int) -> FloatArray:
    """Weights that lift the penalty where the differences `t` of the last solution are large.

    Solving again with the weight ``delta/sqrt(T_i² + delta²)``, T_i the largest modulus of the differences up to
    `order` places from i, reweights the variation (Candès, Wakin & Boyd 2008). The fixed point minimises
    ``½ log(t² + delta²)`` instead of the modulus. Its price for a jump hardly grows with the height, so jumps keep
    their height and the rest can be smoothed more.  Neighbours share the largest weight loss because a jump of a
    lower derivative makes as many large differences of alternating sign.

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Differences [signal], zero in the first ``order + 1`` places.
    delta : float
        Size [signal] above which a difference is large.
    order : int
        Order m of the difference whose variation is penalised.

    Returns
    -------
    FloatArray, shape (N,)
        In (0, 1].

    References
    ----------
    E. J. Candès, M. B. Wakin, S. P. Boyd, Enhancing sparsity by reweighted l1 minimization, J. Fourier Anal. Appl. 14
    (2008) 877-905, doi:10.1007/s00041-008-9045-x.
    """
    around = sliding_window_view(np.pad(np.abs(t), order), 2 * order + 1)
    return np.asarray(delta / np.hypot(around.max(axis=1), delta))


Method = Literal["tvregdiff", "savitzky-golay"]


@dataclass(frozen=True)
class Kinematics:
    """Displacement with its first two derivatives, all at the samples.

    Attributes
    ----------
    q_smooth, qdot, qddot : FloatArray, shape (N,)
        Smoothed displacement and its derivatives [signal, signal/s, signal/s²].
    alpha, epsilon : float
        Parameters of TVRegDiff [signal·s^m, (signal/s^m)²]; those that its principle suggests where another
        differentiator was used, whose own parameter follows from them.  Both are zero for a record that is
        constant or too short to regularise.
    noise_std : float
        Estimated standard deviation of the noise on the samples [signal].
    converged : bool
        True if the differentiator met its tolerance and an automatic parameter settled.
    iterations : int
        Newton steps of TVRegDiff, 0 for the others.
    """

    q_smooth: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    alpha: float
    epsilon: float
    noise_std: float
    converged: bool
    iterations: int


def differentiate(
    samples: FloatArray,
    dt: float,
    *,
    method: Method = "tvregdiff",
    order: Order = 3,
    alpha: float | None = None,
    epsilon: float | None = None,
) -> Kinematics:
    """Velocity and acceleration at the samples of one gap-free segment.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Displacement [m or rad, or any unit], N ≥ 1, finite.
    dt : float
        Sampling interval [s].
    method : {"tvregdiff", "savitzky-golay"}
        Total-variation regularised (default), or SciPy's Savitzky-Golay filter of degree 5.
    order : {1, 2, 3, 4}, default 3
        Derivative m whose variation `tvregdiff` penalises.  1 is the published method: the acceleration is found
        by applying it again, with the same numbers for both parameters.  2 lets the acceleration jump.
    alpha, epsilon : float, optional
        Parameters of `tvregdiff` [signal·s^m, (signal/s^m)²]; both are chosen from the record
        (`smoothing_parameter`) if both are left out; one alone is refused.

    Returns
    -------
    Kinematics

    Raises
    ------
    InputError
        Samples that are empty or not finite, parameters that are not positive, an unknown method.
    """
    if samples.ndim != 1 or samples.size == 0 or not np.isfinite(samples).all():
        raise InputError("differentiate needs a segment of finite samples, shape (N,): split the record at its gaps")
    if method not in ("tvregdiff", "savitzky-golay"):
        raise InputError(f"unknown differentiator {method!r}: use tvregdiff or savitzky-golay")
    if order not in (1, 2, 3, 4):
        raise InputError(f"order is {order!r}: use 1, 2, 3 or 4")
    if samples.size <= order + 2 or np.ptp(samples) == 0.0:
        return _kinematics(
            SmoothingParameter(0.0, 0.0, 0.0, settled=True),
            samples,
            finite_difference(samples, dt, 1),
            finite_difference(samples, dt, 2),
        )
    if method != "tvregdiff":
        return _savitzky_golay(samples, dt, smoothing_parameter(samples, dt, 2))
    if alpha is None or epsilon is None:
        if alpha != epsilon:
            raise InputError("alpha and epsilon belong together: both carry the unit of the samples")
        parameter = smoothing_parameter(samples, dt, order, reweighted=order > 1)
    else:
        parameter = SmoothingParameter(alpha, epsilon, noise_std(samples), settled=True)
    if order == 1:
        velocity = tvregdiff(samples, dt, alpha=parameter.alpha, epsilon=parameter.epsilon)
        acceleration = tvregdiff(velocity.derivative, dt, alpha=parameter.alpha, epsilon=parameter.epsilon)
        return _kinematics(
            parameter, velocity.integral, velocity.derivative, acceleration.derivative, velocity, acceleration
        )
    fit = tvregdiff(
        samples,
        dt,
        alpha=parameter.alpha,
        epsilon=parameter.epsilon,
        order=order,
        start="fitted",
        weights=parameter.weights,
    )
    difference = finite_difference if parameter.weights is None else finite_difference_at_jumps
    return _kinematics(parameter, fit.integral, difference(fit.integral, dt, 1), difference(fit.integral, dt, 2), fit)


def _kinematics(
    parameter: SmoothingParameter, q_smooth: FloatArray, qdot: FloatArray, qddot: FloatArray, *fits: TvDerivative
) -> Kinematics:
    return Kinematics(
        q_smooth=q_smooth,
        qdot=qdot,
        qddot=qddot,
        alpha=parameter.alpha,
        epsilon=parameter.epsilon,
        noise_std=parameter.noise_std,
        converged=parameter.settled and all(fit.converged for fit in fits),
        iterations=sum(fit.iterations for fit in fits),
    )


def _savitzky_golay(samples: FloatArray, dt: float, parameter: SmoothingParameter) -> Kinematics:
    from scipy.signal import savgol_filter

    # Per step (in units of the signal), the increments of a smoother of order 2 have the variance delta/lam; it
    # remembers about the sixth root of noise over increments.
    memory = (parameter.alpha / np.sqrt(parameter.epsilon) / dt**4) ** (1.0 / 6.0)
    window = max(_DEGREE + 2, 2 * int(_WINDOW * memory / 2.0) + 1)
    window = min(window, samples.size - 1 + samples.size % 2)
    smooth, qdot, qddot = (
        savgol_filter(samples, window, min(_DEGREE, window - 1), deriv=derivative, delta=dt) for derivative in (0, 1, 2)
    )
    return _kinematics(parameter, smooth, qdot, qddot)


@dataclass(frozen=True)
class AlphaStudy:
    """One differentiation of a record for each of K regularisation parameters.

    Attributes
    ----------
    alphas : FloatArray, shape (K,)
        Regularisation parameters [signal·s^order].
    misfit : FloatArray, shape (K,)
        RMS of record less regularised signal [signal]: at the noise's standard deviation or below, the parameter
        smooths noise only; above it, the signal too.
    roughness : FloatArray, shape (K,)
        Mean modulus of the change of the acceleration from sample to sample [signal/s²]: large where noise is
        left.
    qdot, qddot : FloatArray, shape (K, N)
        Velocity and acceleration [signal/s, signal/s²].
    automatic : SmoothingParameter
        Choice for the record without reweighting, with its estimate of the noise.
    """

    alphas: FloatArray
    misfit: FloatArray
    roughness: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    automatic: SmoothingParameter


def alpha_study(
    samples: FloatArray, dt: float, alphas: FloatArray, *, order: Order = 1, epsilon: float | None = None
) -> AlphaStudy:
    """Differentiate a record with each of several regularisation parameters.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Gap-free, uniformly sampled record [signal], not constant, N > order + 2.
    dt : float
        Sampling interval [s].
    alphas : FloatArray, shape (K,)
        Regularisation parameters [signal·s^order]; the paper compares 0.0001 to 1 for millimetres.
    order : {1, 2, 3, 4}, default 1
        Derivative whose variation is penalised; 1 is the paper's.
    epsilon : float, optional
        Rounding of the modulus [(signal/s^order)²], the automatic one by default.

    Returns
    -------
    AlphaStudy

    Raises
    ------
    InputError
        As `differentiate`.
    """
    automatic = smoothing_parameter(samples, dt, order)
    rounding = automatic.epsilon if epsilon is None else epsilon
    runs = [differentiate(samples, dt, order=order, alpha=float(alpha), epsilon=rounding) for alpha in alphas]
    return AlphaStudy(
        alphas=np.asarray(alphas, dtype=np.float64),
        misfit=np.array([rms(run.q_smooth - samples) for run in runs]),
        roughness=np.array([np.mean(np.abs(np.diff(run.qddot))) for run in runs]),
        qdot=np.array([run.qdot for run in runs]),
        qddot=np.array([run.qddot for run in runs]),
        automatic=automatic,
    )
