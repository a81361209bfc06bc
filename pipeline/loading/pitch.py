"""The pitch angle φ(q) of a DE joint by the static map of its parameter set."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from pipeline.numerics.arrays import FloatArray

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters

PitchMap = Callable[[FloatArray], FloatArray]


def pitch_map(parameters: "JointParameters | None") -> PitchMap | None:
    """φ [rad] of q [m], NaN where q is NaN; None for a device without a parameter set."""
    if parameters is None:
        return None
    from pipeline.joint.static_path import static_pitch_angle

    return lambda q: static_pitch_angle(q, parameters)
