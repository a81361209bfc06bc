"""Radial basis functions on equidistant centres (eqs. 34-39), and the regressor that they make (eq. 40)."""

from typing import Literal

import numpy as np

from pipeline.compiled import compiled
from pipeline.errors import InputError
from pipeline.generated.basis_functions import NAMES, basis_function
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


def basis_values(q: FloatArray, centres: FloatArray, width: float, basis: str = "gaussian") -> FloatArray:
    """Values φ_i(q) of a basis function about each centre (eq. 38).

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Where to evaluate.
    centres : FloatArray, shape (M,)
        ξ_i, in the unit of q.
    width : float
        σ = σ_n Δξ, in the unit of q.
    basis : str
        Name of the function, see `pipeline.model_list`.

    Returns
    -------
    FloatArray, shape (N, M)
        Cost: N·M exponentials, about 5 ns each.
    """
    return _values(np.ascontiguousarray(q), centres, width, NAMES.index(basis))


@compiled
def _values(q: FloatArray, centres: FloatArray, width: float, kind: int) -> FloatArray:
    values = np.empty((len(q), len(centres)))
    for n in range(len(q)):
        for i in range(len(centres)):
            distance = (q[n] - centres[i]) / width
            values[n, i] = basis_function(kind, distance * distance)[0]
    return values


InputLaw = Literal["squared", "linear"]


def input_signal(v: FloatArray, law: InputLaw) -> FloatArray:
    """What the input curves multiply: v² for an electrostatic input (eq. 33), v for a force-like one.

    An electrostatic force is even in the voltage, so a negative voltage acts like a positive one.
    """
    if law not in ("squared", "linear"):
        raise InputError(f"inputs = {law!r} is unknown; choose squared or linear")
    return v * v if law == "squared" else v


def curve_signals(q: FloatArray, z: FloatArray, u: FloatArray) -> FloatArray:
    """Signals that the curves c, d, g_1 … g_K multiply in eq. 40: [−q, −z, u], shape (N, 2 + K)."""
    return np.column_stack((-q, -z, u))


def regressor(basis: FloatArray, signals: FloatArray) -> FloatArray:
    """Regressor ψᵀ of eq. 40, curve by curve, shape (N, S·M).

    Parameters
    ----------
    basis : FloatArray, shape (N, M)
        φ_i(q_n).
    signals : FloatArray, shape (N, S)
        One column per curve.
    """
    return (signals[:, :, None] * basis[:, None, :]).reshape(len(basis), -1)
