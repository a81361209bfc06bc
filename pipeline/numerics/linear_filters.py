"""Linear filters of uniformly sampled signals: finite differences of high order, and exact first-order lags."""

import math

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from .arrays import FloatArray
from .compiled import compiled

_WIDTH = 7
_ONE_SIDED = 4
_ROUGHNESS_ORDER = 4
_SIDE = 7
"""Samples of one side over which its roughness is taken."""
_SMOOTHER = 10.0
"""Factor by which one side has to be smoother than the other and than the centred stencil to be preferred."""


def stencil_weights(offsets: FloatArray, derivative: int) -> FloatArray:
    """Weights of the finite difference for `derivative` that is exact for polynomials through all `offsets`.

    Parameters
    ----------
    offsets : FloatArray, shape (w,)
        Positions of the samples relative to where the derivative is wanted, in steps.
    derivative : int
        Order of the derivative.

    Returns
    -------
    FloatArray, shape (w,)
        Weights [1/step^derivative].
    """
    moments = np.zeros(offsets.size)
    moments[derivative] = math.factorial(derivative)
    return np.asarray(np.linalg.solve(np.vander(offsets, increasing=True).T, moments))


def finite_difference(x: FloatArray, dt: float, derivative: int) -> FloatArray:
    """First or second derivative at every sample, shape (N,), of order `dt`⁶ inside, `dt`³ or `dt`² at the ends.

    Seven samples are used, centred; towards the ends the stencil shrinks and stays centred, and the outermost samples
    take a one-sided one of four points, exact for cubics. A long one-sided stencil would be of higher order, but
    multiplies noise by ten there, and the first velocity is where a free run starts. Records under seven samples are
    treated as ends throughout; a derivative that a record is too short for is zero.
    """
    if x.size <= derivative:
        return np.zeros(x.size)
    half = _WIDTH // 2 if x.size >= _WIDTH else 0
    result = np.empty(x.size)
    if half:
        centre = stencil_weights(np.arange(-half, half + 1, dtype=np.float64), derivative)
        result[half : x.size - half] = np.correlate(x, centre, mode="valid")
    for i in range(half or -(-x.size // 2)):
        width = min(max(2 * i + 1, 4), x.size)
        weights = stencil_weights(np.arange(width, dtype=np.float64) - i, derivative)
        result[i] = weights @ x[:width]
        result[x.size - 1 - i] = (-1.0) ** derivative * (weights @ x[::-1][:width])
    return np.asarray(result / dt**derivative)


def finite_difference_at_jumps(x: FloatArray, dt: float, derivative: int) -> FloatArray:
    """Difference as in `finite_difference`, but one-sided where the centred stencil meets a jump of the acceleration.

    A step of the voltage makes the acceleration jump within a sample.  Centred stencils smear that over seven samples;
    the choice of the smoother side (as in essentially non-oscillatory schemes, Harten et al. 1987) does not.  The
    roughness of a side is the largest modulus of the fourth differences of seven samples.  A side is taken only if it
    is ten times smoother than the other side and than the centred stencil: the wrong side errs by the whole jump.

    References
    ----------
    A. Harten, B. Engquist, S. Osher, S. R. Chakravarthy, Uniformly high order accurate essentially non-oscillatory
    schemes III, J. Comput. Phys. 71 (1987) 231-303, doi:10.1016/0021-9991(87)90031-3.
    """
    result = finite_difference(x, dt, derivative)
    reach = _SIDE - 1
    if x.size <= 2 * reach:
        return result
    fourth = np.abs(np.diff(x, _ROUGHNESS_ORDER))
    roughness = sliding_window_view(fourth, _SIDE - _ROUGHNESS_ORDER).max(axis=1)  # of samples i … i + reach
    samples = np.arange(reach, x.size - reach)
    before, after, centred = (roughness[samples - shift] for shift in (reach, 0, _WIDTH // 2))
    for side, other, offsets in (
        (before, after, np.arange(1.0 - _ONE_SIDED, 1.0)),
        (after, before, np.arange(0.0, _ONE_SIDED)),
    ):
        chosen = samples[_SMOOTHER * side < np.minimum(other, centred)]
        stencil = chosen[:, None] + offsets.astype(np.int64)
        result[chosen] = x[stencil] @ stencil_weights(offsets, derivative) / dt**derivative
    return result


@compiled
def first_order_lag(
    x: FloatArray, interval: float, time_constant: float, start: float | None = None, held: bool = False
) -> tuple[FloatArray, FloatArray]:
    """Solve ż = (x − z)/T (eq. 37) and its sensitivity ∂z/∂ln T, from rest: z(0) = x(0).

    `x` is linear between samples, so with a = e^(−h/T), r = T(1 − a)/h the exact step is
    z⁺ = a z + (r − a) x + (1 − r) x⁺; no time step error, and T may be far below the interval.

    Parameters
    ----------
    x : FloatArray, shape (N,)
        The input at the samples.
    interval : float
        Sample interval h [s].
    time_constant : float
        T [s], positive.
    start : float, optional
        z(0), where it is not x(0).
    held : bool
        True if x keeps its value from sample to sample instead; then z⁺ = a z + (1 − a) x.

    Returns
    -------
    z, dz_dlogT : FloatArray, shape (N,)
        Cost: 10 flops per sample, a recurrence, about 5 ns per sample.
    """
    z = np.empty(len(x))
    sensitivity = np.empty(len(x))
    ratio = interval / time_constant
    a = np.exp(-ratio)
    r = -np.expm1(-ratio) / ratio
    da = a * ratio  # d/d ln T of a
    dr = r - a  # d/d ln T of r
    z[0], sensitivity[0] = x[0] if start is None else start, 0.0
    for n in range(1, len(x)):
        if held:
            z[n] = a * z[n - 1] + (1.0 - a) * x[n - 1]
            sensitivity[n] = a * sensitivity[n - 1] + da * (z[n - 1] - x[n - 1])
            continue
        z[n] = a * z[n - 1] + (r - a) * x[n - 1] + (1.0 - r) * x[n]
        sensitivity[n] = a * sensitivity[n - 1] + da * z[n - 1] + (dr - da) * x[n - 1] - dr * x[n]
    return z, sensitivity
