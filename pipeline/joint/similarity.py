"""Dynamic similarity: a joint that is a parameter set's in other units of length, time, voltage and mass.

Equal equations in other units describe devices of other sizes: with lengths × a, times × b, voltages × c and masses × d
every constant of the equations is multiplied by d^i a^j b^k c^l, its dimension being kg^i m^j s^k V^l.
"""

from dataclasses import asdict, dataclass, replace
from functools import cached_property

import numpy as np

from pipeline.generated.condensed_joint import BRANCHES, CONSTANTS, CREEPS, STOPS, TIP_DIMENSIONS
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.trajectory import Record

_NUMBER, _LENGTH, _MASS, _MOMENT = (0, 0, 0, 0), (0, 1, 0, 0), (1, 0, 0, 0), (1, 1, 0, 0)
_INERTIA, _FORCE, _ENERGY = (1, 2, 0, 0), (1, 1, -2, 0), (1, 2, -2, 0)
_RATE, _DAMPING, _ANGULAR_DAMPING = (0, 0, -1, 0), (1, 0, -1, 0), (1, 2, -1, 0)

_DIMENSION = {
    "l": _LENGTH, "bending": _ENERGY, "bending_loss": _ANGULAR_DAMPING, "mass": _MASS, "cross": _MOMENT,
    "inertia": _INERTIA, "gyration": _INERTIA, "interior_inertia": _INERTIA,
    "rise_qq": (0, -1, 0, 0), "rise_tt": _LENGTH, "rise_tb": _LENGTH, "rise_bb": _LENGTH,
    "weight": _FORCE, "offset": _LENGTH, "side_force": _FORCE, "viscosity": _DAMPING, **TIP_DIMENSIONS,
    "friction_arm": _LENGTH,
    **{f"relaxation_{i}": _RATE for i in range(BRANCHES)},
    **{f"{side}_{name}": _LENGTH for side in ("left", "right") for name in ("a", "c", "e_z", "e_x", "l0")},
    **{f"{side}_elastic": _ENERGY for side in ("left", "right")},
    **{f"{side}_electric": (1, 2, -2, -2) for side in ("left", "right")},
    **{f"{side}_maxwell_{i}": _ENERGY for side in ("left", "right") for i in range(BRANCHES)},
    **{f"{side}_viscous": _ANGULAR_DAMPING for side in ("left", "right")},
    **{f"stop_force_{i}": _FORCE for i in range(STOPS)},
    **{f"stop_travel_{i}": _LENGTH for i in range(STOPS)},
    **{f"creep_stiffness_{i}": (1, 0, -2, 0) for i in range(CREEPS)},
    **{f"creep_rate_{i}": _RATE for i in range(CREEPS)},
}  # fmt: skip
"""Powers of kg, m, s and V; what is not named is a number."""

DIMENSIONS = np.array([_DIMENSION.get(name, _NUMBER) for name in CONSTANTS])
"""Those powers of each constant of the kernels, shape (len(CONSTANTS), 4)."""
_WEIGHTS = np.array([
    _FORCE, _DAMPING, (1, 1, -2, -2), (1, 1, -2, -2),
    _ENERGY, _ENERGY, (1, 2, -2, -2), (1, 2, -2, -2), _ANGULAR_DAMPING,
])  # fmt: skip
"""Of the weights of the corrections, rows as in `pipeline.joint.correction_table`."""


@dataclass(frozen=True)
class Similarity:
    """A device in units of a parameter set's joint.

    Attributes
    ----------
    length, time, voltage, mass : float
        The device's over the set's.
    origin : float
        Reading [m] that corresponds to q = 0 of the set.
    """

    length: float = 1.0
    time: float = 1.0
    voltage: float = 1.0
    mass: float = 1.0
    origin: float = 0.0

    @property
    def _units(self) -> FloatArray:
        return np.array([self.mass, self.length, self.time, self.voltage])

    @cached_property
    def constants(self) -> FloatArray:
        """Factors on the kernel's constants, shape (len(CONSTANTS),)."""
        factors: FloatArray = np.prod(self._units**DIMENSIONS, axis=1)
        return factors

    @cached_property
    def weights(self) -> FloatArray:
        """Factors on the rows of the corrections' weights, shape (CURVES,)."""
        factors: FloatArray = np.prod(self._units**_WEIGHTS, axis=1)
        return factors

    def set_record(self, record: Record) -> Record:
        """A log of the device as one of the set's joint."""
        speed = self.length / self.time
        return replace(
            record,
            t=record.t / self.time,
            q=(record.q - self.origin) / self.length,
            qdot=record.qdot / speed,
            qddot=record.qddot / (speed / self.time),
            v=record.v / self.voltage,
            fine=None if record.fine is None else record.fine / self.voltage,
        )

    def to_json(self) -> dict[str, float]:
        """The factors by name."""
        return asdict(self)


SAME = Similarity()
"""The set's own joint."""
