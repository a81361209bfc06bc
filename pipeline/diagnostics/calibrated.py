"""Physical quantities by the fit of the hybrid model: nominal value, calibrated value, interval."""

from dataclasses import dataclass

import numpy as np

from ..device.parameters import QUANTITIES, VECTOR_NAMES
from ..models.base import DynamicModel
from ..models.hybrid.model import HybridModel
from ..models.hybrid.parameters import DEVIATIONS, NAMES, OF_INSTRUMENTS, PRIOR_STD
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_90
from ..units.units import POWERS

_SIZES = [NAMES.index(f"log {unit}") for unit in ("length", "time", "voltage")]


@dataclass(frozen=True)
class Calibrated:
    """One quantity in SI.

    Attributes
    ----------
    name, unit : str
        As in the parameter set; a share of the nominal value ("1") where the set has no such quantity.
    nominal : float or None
        Value of the parameter set; None if it has none.
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


def calibrated(model: DynamicModel | None) -> list[Calibrated]:
    """Every quantity that the fit of a hybrid model moves, those of the parameter set first; empty for other models.

    Each is that of the device, whose size is another than the set's joint's.
    """
    quantities = [_one(model, i) for i in range(len(DEVIATIONS))] if isinstance(model, HybridModel) else []
    return sorted(quantities, key=lambda quantity: quantity.nominal is None)


def _one(model: HybridModel, i: int) -> Calibrated:
    """Deviation number i as a quantity: its value at the parameter set's size, times the device's size."""
    entry = DEVIATIONS[i]
    name = entry.quantity
    nominal = model.joint.parameters.value(name) if name in VECTOR_NAMES else None
    begin = nominal if nominal is not None else (entry.typical or float(entry.logarithm))
    powers = np.array(POWERS[entry.unit])
    row = np.zeros(len(DEVIATIONS))
    at = model.theta[: len(DEVIATIONS)] * PRIOR_STD
    by_size = np.zeros(len(_SIZES)) if i in OF_INSTRUMENTS else powers[1:] * PRIOR_STD[_SIZES]
    units = np.log([getattr(model.joint.similarity, unit) for unit in ("mass", "length", "time", "voltage")])
    if i not in OF_INSTRUMENTS:
        units[1:] += at[_SIZES]
    if entry.logarithm:
        row[i] = PRIOR_STD[i]
        if i in _SIZES:
            at[i] = row[i] = 0.0  # it is one of the units
        row[_SIZES] += by_size
        ends = begin * np.exp(at[i] + powers @ units + _bounds(model, row))
    else:
        factor = np.exp(powers @ units)
        row[i] = factor * PRIOR_STD[i]
        row[_SIZES] += factor * (begin + at[i]) * by_size
        ends = factor * (begin + at[i]) + _bounds(model, row)
    value, low, high = (float(end) for end in ends)
    if entry.typical is not None:
        return Calibrated(name, entry.unit, None, value, low, high)
    if nominal is not None:
        return Calibrated(name, QUANTITIES[name].unit, nominal, value, low, high)
    if entry.logarithm:
        return Calibrated(f"{name}, share of the nominal value", "1", 1.0, value, low, high)
    return Calibrated(f"{name}, change", entry.unit, 0.0, value, low, high)


def _bounds(model: HybridModel, row: FloatArray) -> FloatArray:
    """0 and the central 90 % about it of a number that depends on the deviations by `row`, shape (3,)."""
    deviation = float(np.sqrt(np.sum((row @ model.spread[: len(row)]) ** 2)))
    return NORMAL_90 * deviation * np.array([0.0, -1.0, 1.0])
