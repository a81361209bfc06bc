"""The reading of a joint whose angle was logged.

Its log has the angle φ as a displacement q, by φ(q) of the joint at rest without voltage. In motion φ follows the slope
τ of the beam's tip, φ = arctan τ (eq. 1), which voltages and viscosity move beside q (2 to 4 mm RMS on simulated joints
of 50 mm range). The equations therefore read y = τ / (dτ/dq of slow motions), a length and linear in their state.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from ...numerics.arrays import FloatArray
from ...signals.log import Log

ANGLE_IS_READ = (
    "{name} was identified from the angle of the joint, and {what} of it take a measured displacement; {way_out}"
)
"""Message with which uses of a model that read q alone refuse it."""
_NEWTON = 4
"""Steps from linear interpolation of 0.25 mm to rounding."""


@dataclass(frozen=True)
class AngleReading:
    """Conversion between the displacement of a log and the reading of the equations.

    Attributes
    ----------
    rotation : FloatArray, shape (K, 2)
        Nodes of rising q [m] and φ [rad], by which the log was made; linear beyond.
    lead : float
        dτ/dq [1/m] of slow motions.
    """

    rotation: FloatArray
    lead: float

    @cached_property
    def _phi(self) -> Any:
        return CubicSpline(self.rotation[:, 0], self.rotation[:, 1])

    def _angle(self, q: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """φ of q, and its first and second derivative."""
        low, high = self.rotation[[0, -1], 0]
        inside = np.clip(q, low, high)
        slope = self._phi(inside, 1)
        return self._phi(inside) + slope * (q - inside), slope, np.where(q == inside, self._phi(inside, 2), 0.0)

    def read(self, q: FloatArray, qdot: FloatArray, qddot: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Reading [m] and its derivatives, of a displacement of the log and its derivatives."""
        phi, slope, bend = self._angle(q)
        tau = np.tan(phi)
        stretch = 1.0 + tau**2
        first = stretch * slope / self.lead
        second = stretch * (2.0 * tau * slope**2 + bend) / self.lead
        return tau / self.lead, first * qdot, first * qddot + second * qdot**2

    def shown(self, y: FloatArray, ydot: FloatArray, yddot: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Displacement of the log [m] and its derivatives, of a reading and its derivatives."""
        phi = np.arctan(self.lead * y)
        q = np.interp(phi, self.rotation[:, 1], self.rotation[:, 0])
        for _ in range(_NEWTON):
            there, slope, _ = self._angle(q)
            q = q - (there - phi) / slope
        zero = np.zeros_like(q)
        first = self.read(q, zero + 1.0, zero)[1]
        qdot = ydot / first
        return q, qdot, (yddot - self.read(q, qdot, zero)[2]) / first

    def log(self, log: Log) -> Log:
        """A log with the reading in place of its displacement."""
        q, qdot, qddot = self.read(log.q, log.qdot, log.qddot)
        velocity = None if log.velocity is None else self.read(log.q, log.velocity, log.qddot)[1]
        return replace(log, q=q, qdot=qdot, qddot=qddot, velocity=velocity)
