"""Derivatives of a smooth, uniformly sampled signal at its samples, by finite differences of high order."""

import math

import numpy as np

from pipeline.numerics.arrays import FloatArray

_WIDTH = 7


def stencil_weights(offsets: FloatArray, derivative: int) -> FloatArray:
    """Weights of the finite difference for `derivative` that is exact for polynomials through all `offsets`.

    Parameters
    ----------
    offsets : FloatArray, shape (w,)
        Positions of the samples relative to where the derivative is wanted, in steps.
    derivative : int
        Which derivative.

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
