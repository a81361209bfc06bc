"""The displacement of a joint whose angle was logged, by the joint's own kinematics."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...device.device import Device
from ...device.parameters import JointParameters
from ...errors import InputError
from ...numerics.arrays import FloatArray
from ...signals.columns import chunks, column
from ...signals.raw_log import RawLog


def with_displacement(log: RawLog, plant: Device, parameters: JointParameters | None) -> RawLog:
    """The log with the displacement of the joint [m] in place of its angle [rad]; one of a length as it is.

    Parameters
    ----------
    log : RawLog
        Its q, and a measured velocity, are those of the angle φ.
    plant : Device
        Says what was logged.
    parameters : JointParameters or None
        Geometry of the joint; `device` grants that a set is named where an angle is converted.

    Raises
    ------
    InputError
        Most of the angles lie beyond those of the joint, so that their unit, zero or sign is another.
    """
    if plant.angle is None or parameters is None:
        return log
    from ...models.analytical.statics import displacement_of_rotation, rotation_nodes

    time, phi = log.q
    low, high = rotation_nodes(parameters)[[0, -1], 1]
    middle = float(np.nanmedian(phi))
    if not low <= middle <= high:
        raise InputError(
            f"q: the angle is about {np.degrees(middle):.3g}°, but the joint turns from {np.degrees(low):.3g}° to "
            f"{np.degrees(high):.3g}°; correct unit, offset or scale of q in [channels], or leave plant.parameters out "
            "for another device"
        )
    velocity = log.velocity
    if velocity is not None:
        known = np.isfinite(time) & np.isfinite(phi)
        at = np.interp(velocity[0], time[known], phi[known])
        velocity = velocity[0], velocity[1] * displacement_of_rotation(at, parameters)[1]

    def displacement() -> Iterator[FloatArray]:
        """Its parts, so that a long log does not lie in memory."""
        return (displacement_of_rotation(phi[rows], parameters)[0] for rows in chunks(phi.size))

    q = time, column(phi.size, displacement(), np.float64)
    return replace(log, q=q, velocity=velocity)
