"""What the fit of the hybrid model makes of each physical quantity: nominal value, calibrated value, interval."""

import re
from dataclasses import dataclass

import numpy as np

from pipeline.device_facts.datasheet import NINETY
from pipeline.generated.condensed_joint import TIP_DIMENSIONS
from pipeline.joint.condensed_parameters import DEVIATIONS, NAMES, OF_INSTRUMENTS
from pipeline.joint.parameters import QUANTITIES, VECTOR_NAMES
from pipeline.models.base import Model
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class Calibrated:
    """One quantity in SI.

    Attributes
    ----------
    name, unit : str
        As in the parameter set; a share of the nominal value ("1") where the set has no such quantity.
    nominal : float or None
        Value of the parameter set; None where it says nothing of it.
    value, low, high : float
        Calibrated value and its central 90 % by the model's posterior. Of what cannot be negative the interval is
        that of its logarithm.
    """

    name: str
    unit: str
    nominal: float | None
    value: float
    low: float
    high: float


def calibrated(model: Model | None) -> list[Calibrated]:
    """Every quantity that the fit of a hybrid model moves, those of the parameter set first; none of another model.

    Each is that of the device, whose size is another than the set's joint's.
    """
    if not isinstance(model, HybridModel):
        return []
    found = [_one(model, i) for i in range(len(DEVIATIONS))]
    return sorted(found, key=lambda one: one.nominal is None)


def _one(model: HybridModel, i: int) -> Calibrated:
    """Deviation number i as a quantity: what it is at the set's size, times the device's size."""
    entry, parameters = DEVIATIONS[i], model.joint.parameters
    side, _, bare = entry.name.rpartition(".")
    plain = bare.removeprefix("log ")
    name = ".".join(part for part in (side, plain) if part)
    logarithm, known = bare.startswith("log "), name in VECTOR_NAMES
    nominal = parameters.value(name) if known else None
    begin = nominal if nominal is not None else (entry.typical or float(logarithm))
    dimension = np.array(_DIMENSION.get(_unnumbered(plain), (0, 0, 0, 0)))
    at, row = model.theta[: len(DEVIATIONS)] * _WIDTHS, np.zeros(len(DEVIATIONS))
    units = np.log([getattr(model.joint.similarity, unit) for unit in ("mass", "length", "time", "voltage")])
    if i not in OF_INSTRUMENTS:
        units[1:] += at[_SIZES]
    if logarithm or entry.typical is not None:
        row[i] = _WIDTHS[i]
        if i in _SIZES:
            at[i] = row[i] = 0.0  # it is one of the units
        row[_SIZES] += dimension[1:] * _WIDTHS[_SIZES]
        ends = begin * np.exp(at[i] + dimension @ units + _bounds(model, row))
    else:
        factor = np.exp(dimension @ units)
        row[i] = factor * _WIDTHS[i]
        if i not in OF_INSTRUMENTS:
            row[_SIZES] += factor * (begin + at[i]) * dimension[1:] * _WIDTHS[_SIZES]
        ends = factor * (begin + at[i]) + _bounds(model, row)
    value, low, high = (float(end) for end in ends)
    if entry.typical is not None:
        return Calibrated(name, _UNITS.get(_unnumbered(name), "1"), None, value, low, high)
    if known:
        return Calibrated(name, QUANTITIES[name].unit, nominal, value, low, high)
    if logarithm:
        return Calibrated(f"{name}, share of the nominal value", "1", 1.0, value, low, high)
    return Calibrated(f"{name}, change", entry.unit, 0.0, value, low, high)


def _unnumbered(name: str) -> str:
    """The name of one of several alike without its number: "stop force 2" is a stop force, "C0" is itself."""
    return re.sub(r" \d+$", "", name)


def _bounds(model: HybridModel, row: FloatArray) -> FloatArray:
    """0 and the central 90 % about it of a number that depends on the deviations by `row`, shape (3,)."""
    sd = float(np.sqrt(np.sum((row @ model.spread[: len(row)]) ** 2)))
    return NINETY * sd * np.array([0.0, -1.0, 1.0])


_WIDTHS = np.array([entry.width for entry in DEVIATIONS])
_SIZES = [NAMES.index(f"log {unit}") for unit in ("length", "time", "voltage")]

_UNITS = {
    "slow modulus": "Pa", "fast modulus": "Pa", "radius": "m", "viscosity": "N s/m", "drag": "N s²/m²",
    "stop force": "N", "creep stiffness": "N/m",
}  # fmt: skip
"""Units of quantities that the parameter set does not have."""

_LENGTH, _STRESS = (0, 1, 0, 0), (1, -1, -2, 0)
_DIMENSION = {
    **dict.fromkeys(("E", "Y", "Y_MW", "slow modulus", "fast modulus"), _STRESS),
    **dict.fromkeys(("eta", "eta_v"), (1, -1, -1, 0)),
    **dict.fromkeys(("length", "a", "b", "e_x", "e_z", "offset", "radius", "friction arm", "stop travel"), _LENGTH),
    **dict.fromkeys(("time", "slow time", "fast time", "delay"), (0, 0, 1, 0)), "relaxation": (0, 0, -1, 0),
    **dict.fromkeys(("voltage", "probe"), (0, 0, 0, 1)), "C0": (1, 2, -2, -2), "laser offset": _LENGTH,
    **dict.fromkeys(("weight", "stop force"), (1, 1, -2, 0)), "creep stiffness": (1, 0, -2, 0),
    "viscosity": (1, 0, -1, 0), **{name.replace("_", " "): powers for name, powers in TIP_DIMENSIONS.items()},
}  # fmt: skip
"""Powers of kg, m, s and V; what is not named is a number."""
