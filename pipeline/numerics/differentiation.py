"""Velocity and acceleration of a displacement record, one signature for all differentiators."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.stencils import finite_difference
from pipeline.numerics.tvregdiff import Order, tvregdiff

Method = Literal["tvregdiff", "savitzky-golay", "rts"]


@dataclass(frozen=True)
class Kinematics:
    """Displacement with its first two derivatives, all at the samples.

    Attributes
    ----------
    q_smooth, qdot, qddot : FloatArray, shape (N,)
        Smoothed displacement and its derivatives [signal, signal/s, signal/s²].
    alpha : float
        Regularisation parameter that was used [signal·s^order].
    noise_std : float
        Estimated standard deviation of the noise on the samples [signal].
    converged : bool
        Whether the differentiator met its tolerance.
    """

    q_smooth: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    alpha: float
    noise_std: float
    converged: bool


def noise_std(samples: FloatArray) -> float:
    """Standard deviation of white noise on a smooth signal, from the median of its fourth differences."""
    if samples.size < 6:
        return 0.0
    return float(1.4826 * np.median(np.abs(np.diff(samples, 4))) / np.sqrt(70.0))


def differentiate(
    samples: FloatArray,
    dt: float,
    *,
    method: Method = "tvregdiff",
    order: Order = 3,
    alpha: float | None = None,
    epsilon: float = 1e-12,
) -> Kinematics:
    """Velocity and acceleration at the samples of one gap-free stretch, shape (N,) each."""
    if method != "tvregdiff":
        raise InputError(f"unknown differentiator {method!r}")
    sigma = noise_std(samples)
    if samples.size <= order + 1:
        return Kinematics(
            samples, finite_difference(samples, dt, 1), finite_difference(samples, dt, 2), 0.0, sigma, True
        )
    weight = alpha if alpha is not None else max(sigma, 1e-12) * 0.03**order * np.sqrt(0.01 / dt)
    if order == 1:
        first = tvregdiff(samples, dt, alpha=weight, epsilon=epsilon)
        second = tvregdiff(first.derivative, dt, alpha=weight, epsilon=epsilon)
        done = first.converged and second.converged
        return Kinematics(first.integral, first.derivative, second.derivative, weight, sigma, done)
    fit = tvregdiff(samples, dt, alpha=weight, epsilon=epsilon, order=order, start="fitted")
    x = fit.integral
    return Kinematics(x, finite_difference(x, dt, 1), finite_difference(x, dt, 2), weight, sigma, fit.converged)
