"""Dynamic similarity: a joint that is a parameter set's in other units of length, time, voltage and mass.

Equal equations in other units describe devices of other sizes: with lengths × a, times × b, voltages × c and masses × d
every constant of the equations is multiplied by d^i a^j b^k c^l, its dimension being kg^i m^j s^k V^l.
"""

from dataclasses import replace
from functools import cached_property
from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic.dataclasses import dataclass

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
        return replace(
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
