"""The regressor of eq. 40: every curve's bells times the signal that the curve multiplies."""

from typing import Literal

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray

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
