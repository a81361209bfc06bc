"""Gaussian radial basis functions on equidistant centres (eqs. 34-39).

The paper prints exp(E/2σ²) in eq. 35; eq. 38 has the minus sign that a bell needs, and it is used here.
"""

import numpy as np

from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray


def basis_centres(low: float, high: float, count: int) -> FloatArray:
    """Equidistant centres ξ_i from `low` to `high`, shape (count,) (eq. 39).

    Raises
    ------
    InputError
        Fewer than two centres, or an empty range.
    """
    if count < 2:
        raise InputError(f"{count} basis functions cannot span a range; at least 2 are needed")
    if not high > low:
        raise InputError(f"the operating range from {low:g} to {high:g} is empty")
    return np.linspace(low, high, count)


def basis_width(centres: FloatArray, smoothing: float) -> float:
    """Standard deviation σ = σ_n Δξ of the bells, in the unit of the centres (after eq. 38)."""
    if not smoothing > 0.0:
        raise InputError(f"the smoothing factor σ_n must be positive, it is {smoothing:g}")
    return smoothing * float(centres[1] - centres[0])


@compiled
def gaussian_basis(q: FloatArray, centres: FloatArray, width: float) -> FloatArray:
    """Values φ_i(q) = exp(−(q−ξ_i)²/(2σ²)) (eq. 38).

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Where to evaluate.
    centres : FloatArray, shape (M,)
        ξ_i, in the unit of q.
    width : float
        σ = σ_n Δξ, in the unit of q.

    Returns
    -------
    FloatArray, shape (N, M)
        Cost: N·M exponentials, about 5 ns each.
    """
    values = np.empty((len(q), len(centres)))
    scale = 1.0 / (np.sqrt(2.0) * width)
    for n in range(len(q)):
        for i in range(len(centres)):
            distance = (q[n] - centres[i]) * scale
            values[n, i] = np.exp(-distance * distance)
    return values
