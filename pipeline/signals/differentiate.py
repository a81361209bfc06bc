"""Velocity and acceleration of a displacement record: one signature for all differentiators.

The default penalises the variation of the third derivative (order 3): neither velocity nor acceleration has steps
where the truth has none.  The derivatives of the regularised signal are taken by finite differences of high order
at the samples themselves; nothing is shifted by half a sample.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..numerics.linear_filters import finite_difference, finite_difference_at_jumps
from ..numerics.metrics import rms
from ..numerics.tvregdiff import Order, tvregdiff
from .noise import noise_std
from .smoothing_parameter import SmoothingParameter, smoothing_parameter

Method = Literal["tvregdiff", "savitzky-golay"]

PAPER_EPSILON = 1e-6
"""Rounding of the variation's corner beside a given α, for q in mm [(mm/s^order)²], degrees or mV."""
_WINDOW = 14.0
"""Window of the Savitzky-Golay filter in memory lengths of the smoother with the same noise and increments."""
_DEGREE = 5


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
        Total-variation regularised (default), SciPy's Savitzky-Golay filter of degree 5, or PyNumDiff's
        Rauch-Tung-Striebel smoother with constant acceleration.
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
        return _read_off(samples, dt, SmoothingParameter(0.0, 0.0, 0.0, settled=True))
    if method != "tvregdiff":
        return _savitzky_golay(samples, dt, smoothing_parameter(samples, dt, 2))
    if alpha is None or epsilon is None:
        if alpha != epsilon:
            raise InputError("alpha and epsilon belong together: both carry the unit of the samples")
        parameter = smoothing_parameter(samples, dt, order, reweighted=order > 1)
    else:
        parameter = SmoothingParameter(alpha, epsilon, noise_std(samples), settled=True)
    return _tvregdiff_twice(samples, dt, parameter) if order == 1 else _tvregdiff(samples, dt, parameter, order)


def _tvregdiff(samples: FloatArray, dt: float, parameter: SmoothingParameter, order: Order) -> Kinematics:
    fit = tvregdiff(
        samples,
        dt,
        alpha=parameter.alpha,
        epsilon=parameter.epsilon,
        order=order,
        start="fitted",
        weights=parameter.weights,
    )
    return _read_off(fit.integral, dt, parameter, fit.converged, fit.iterations)


def _tvregdiff_twice(samples: FloatArray, dt: float, parameter: SmoothingParameter) -> Kinematics:
    velocity = tvregdiff(samples, dt, alpha=parameter.alpha, epsilon=parameter.epsilon)
    acceleration = tvregdiff(velocity.derivative, dt, alpha=parameter.alpha, epsilon=parameter.epsilon)
    return Kinematics(
        q_smooth=velocity.integral,
        qdot=velocity.derivative,
        qddot=acceleration.derivative,
        alpha=parameter.alpha,
        epsilon=parameter.epsilon,
        noise_std=parameter.noise_std,
        converged=parameter.settled and velocity.converged and acceleration.converged,
        iterations=velocity.iterations + acceleration.iterations,
    )


def _read_off(
    x: FloatArray, dt: float, parameter: SmoothingParameter, converged: bool = True, iterations: int = 0
) -> Kinematics:
    difference = finite_difference if parameter.weights is None else finite_difference_at_jumps
    return _kinematics(x, difference(x, dt, 1), difference(x, dt, 2), parameter, converged, iterations)


def _kinematics(
    q_smooth: FloatArray,
    qdot: FloatArray,
    qddot: FloatArray,
    parameter: SmoothingParameter,
    converged: bool = True,
    iterations: int = 0,
) -> Kinematics:
    return Kinematics(
        q_smooth=q_smooth,
        qdot=qdot,
        qddot=qddot,
        alpha=parameter.alpha,
        epsilon=parameter.epsilon,
        noise_std=parameter.noise_std,
        converged=parameter.settled and converged,
        iterations=iterations,
    )


def _savitzky_golay(samples: FloatArray, dt: float, parameter: SmoothingParameter) -> Kinematics:
    from scipy.signal import savgol_filter

    # Per step (in units of the signal), the increments of a smoother of order 2 have the variance delta/lam; it
    # remembers about the sixth root of noise over increments.
    memory = (parameter.alpha / np.sqrt(parameter.epsilon) / dt**4) ** (1.0 / 6.0)
    window = max(_DEGREE + 2, 2 * int(_WINDOW * memory / 2.0) + 1)
    window = min(window, samples.size - 1 + samples.size % 2)
    degree = min(_DEGREE, window - 1)
    smooth, qdot, qddot = (
        savgol_filter(samples, window, degree, deriv=derivative, delta=dt) for derivative in (0, 1, 2)
    )
    return _kinematics(smooth, qdot, qddot, parameter)


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
