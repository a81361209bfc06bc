"""A log as the equations of the joint read it: in the units of the parameter set, and by its angle if that was logged.

Equal equations in other units describe devices of other sizes: with lengths × a, times × b, voltages × c and masses × d
every constant of the equations is multiplied by d^i a^j b^k c^l, its dimension being kg^i m^j s^k V^l.

The log of an angle has φ as a displacement q, by φ(q) of the joint at rest without voltage. In motion φ follows the
slope τ of the beam's tip, φ = arctan τ (eq. 1), which voltages and viscosity move beside q (2 to 4 mm RMS on simulated
joints of 50 mm range). The equations therefore read y = τ / (dτ/dq of slow motions), a length and linear in their
state.
"""

import dataclasses
from functools import cached_property
from typing import Annotated, Any

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass
from scipy.interpolate import CubicSpline

from ...generated.condensed_joint import BRANCHES, CONSTANTS, CREEPS, STOP_ELEMENTS, TIP_CONSTANTS
from ...numerics.arrays import FloatArray
from ...signals.log import Log
from ...units.units import POWERS
from ..model_file import STORED, Real, Unit

_UNITS = {
    "l": "m", "bending": "J", "bending_loss": "N·m·s", "mass": "kg", "cross": "kg·m", "inertia": "kg·m²",
    "gyration": "kg·m²", "interior_inertia": "kg·m²", "rise_qq": "1/m", "rise_tt": "m", "rise_tb": "m", "rise_bb": "m",
    "weight": "N", "offset": "m", "side_force": "N", "viscosity": "N·s/m", "friction_arm": "m",
    **{name: unit for name, _, _, unit in TIP_CONSTANTS},
    **{f"relaxation_{i}": "1/s" for i in range(BRANCHES)},
    **{f"{side}_{name}": "m" for side in ("left", "right") for name in ("a", "c", "e_z", "e_x", "l0")},
    **{f"{side}_elastic": "J" for side in ("left", "right")},
    **{f"{side}_electric": "F" for side in ("left", "right")},
    **{f"{side}_maxwell_{i}": "J" for side in ("left", "right") for i in range(BRANCHES)},
    **{f"{side}_viscous": "N·m·s" for side in ("left", "right")},
    **{f"stop_force_{i}": "N" for i in set(STOP_ELEMENTS)},
    **{f"stop_travel_{i}": "m" for i in set(STOP_ELEMENTS)},
    **{f"creep_stiffness_{i}": "N/m" for i in range(CREEPS)},
    **{f"creep_rate_{i}": "1/s" for i in range(CREEPS)},
    "softening_rate": "1/s",
}  # fmt: skip
"""Units of the constants of the kernels; what is not named is a number."""

DIMENSIONS = np.array([POWERS[_UNITS.get(name, "1")] for name in CONSTANTS])
"""Powers of kg, m, s and V in each of them, shape (len(CONSTANTS), 4)."""
_WEIGHTS = np.array(
    [POWERS[unit] for unit in ("N", "N·s/m", "N/V²", "N/V²", "N·m", "N·m", "N·m/V²", "N·m/V²", "N·m·s")]
)
"""Units of the weights of the corrections, rows as in `pipeline.models.hybrid.kernels`."""


_Size = Annotated[float, Field(ge=1e-3, le=1e3)]


@dataclass(frozen=True, config=STORED)
class Similarity:
    """Size of the device over that of the parameter set."""

    length: _Size = 1.0
    time: _Size = 1.0
    voltage: _Size = 1.0
    mass: _Size = 1.0
    origin: Annotated[Real, Unit("m")] = 0.0
    """Reading of the laser that corresponds to q = 0 of the parameter set."""

    @property
    def _units(self) -> FloatArray:
        return np.array([self.mass, self.length, self.time, self.voltage])

    @cached_property
    def constants(self) -> FloatArray:
        """Factors on the kernel's constants, shape (len(CONSTANTS),)."""
        return np.asarray(np.prod(self._units**DIMENSIONS, axis=1))

    @cached_property
    def weights(self) -> FloatArray:
        """Factors on the rows of the corrections' weights, shape (CURVES,)."""
        return np.asarray(np.prod(self._units**_WEIGHTS, axis=1))

    def in_reference_units(self, record: Log) -> Log:
        """A log of the device as one of the set's joint."""
        speed = self.length / self.time
        return dataclasses.replace(
            record,
            t=record.t / self.time,
            q=(record.q - self.origin) / self.length,
            qdot=record.qdot / speed,
            qddot=record.qddot / (speed / self.time),
            v=record.v / self.voltage,
            fine=None if record.fine is None else record.fine / self.voltage,
            past=None if record.past is None else record.past / self.voltage,
            velocity=None if record.velocity is None else record.velocity / speed,
        )


SAME = Similarity()
"""The set's own joint."""

ANGLE_IS_READ = (
    "{name} was identified from the angle of the joint, and {what} of it take a measured displacement; {way_out}"
)
"""Message with which uses of a model that read q alone refuse it."""
_NEWTON = 4
"""Steps from linear interpolation of 0.25 mm to rounding."""


@dataclasses.dataclass(frozen=True)
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
        return dataclasses.replace(log, q=q, qdot=qdot, qddot=qddot, velocity=velocity)
