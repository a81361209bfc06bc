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
    """First or second derivative at every sample, shape (N,), of order `dt`⁶ inside and `dt`⁵ or better at the ends.

    Seven samples are used, centred where possible, fewer in a shorter record; a derivative that a record is too
    short for is zero.
    """
    width = min(_WIDTH, x.size)
    if width <= derivative:
        return np.zeros(x.size)
    result = np.empty(x.size)
    left = width // 2
    steps = np.arange(width, dtype=np.float64)
    for i in range(left):
        result[i] = stencil_weights(steps - i, derivative) @ x[:width]
    right = width - left - 1
    for i in range(right):
        result[x.size - 1 - i] = stencil_weights(steps - (width - 1 - i), derivative) @ x[x.size - width :]
    centre = stencil_weights(steps - left, derivative)
    result[left : x.size - right] = np.correlate(x, centre, mode="valid")
    return np.asarray(result / dt**derivative)
