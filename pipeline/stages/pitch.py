"""The pitch angle φ(q) of a DE joint by the static map of its parameter set."""

from collections.abc import Callable

from pipeline.numerics.arrays import FloatArray
from pipeline.settings import Prototype
from pipeline.stages.joint_parameters import joint_parameters

PitchMap = Callable[[FloatArray], FloatArray]


def pitch_map(prototype: Prototype) -> PitchMap | None:
    """φ [rad] of q [m], NaN where q is NaN; None for a device without a parameter set."""
    if prototype.plant.parameters is None:
        return None
    from pipeline.physics.static_path import static_pitch_angle

    parameters = joint_parameters(prototype.plant.parameters)
    return lambda q: static_pitch_angle(q, parameters)
