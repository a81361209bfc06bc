"""The pitch angle φ(q) of a DE joint by the static map of its parameter set."""

from collections.abc import Callable

from pipeline.numerics.arrays import FloatArray
from pipeline.settings import Prototype

PitchMap = Callable[[FloatArray], FloatArray]


def pitch_map(prototype: Prototype) -> PitchMap | None:
    """φ [rad] of q [m], NaN where q is NaN; None for a device without a parameter set."""
    return None
