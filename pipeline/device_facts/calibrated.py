"""What the fit of the hybrid model makes of each physical quantity: nominal value, calibrated value, interval."""

from dataclasses import dataclass

import numpy as np

from pipeline.device_facts.datasheet import NINETY
from pipeline.joint.condensed_parameters import DEVIATIONS, Deviation
from pipeline.joint.parameters import QUANTITIES, VECTOR_NAMES, JointParameters
from pipeline.models.base import Model
from pipeline.models.hybrid import HybridModel


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
    """Every quantity that the fit of a hybrid model moves, those of the parameter set first; none of another model."""
    if not isinstance(model, HybridModel):
        return []
    widths = np.array([entry.width for entry in DEVIATIONS])
    deviations = model.theta[: len(DEVIATIONS)] * widths
    spread = np.sqrt(np.sum(model.spread[: len(DEVIATIONS)] ** 2, axis=1)) * widths
    found = [
        _one(entry, model.joint.parameters, float(at), float(sd))
        for entry, at, sd in zip(DEVIATIONS, deviations, spread, strict=True)
    ]
    return sorted(found, key=lambda one: one.nominal is None)


def _one(entry: Deviation, parameters: JointParameters, at: float, sd: float) -> Calibrated:
    ends = np.array([at, at - NINETY * sd, at + NINETY * sd])
    side, _, bare = entry.name.rpartition(".")
    name = ".".join(part for part in (side, bare.removeprefix("log ")) if part)
    logarithm = bare.startswith("log ")
    if entry.typical is not None:
        value, low, high = (float(entry.typical * np.exp(x)) for x in ends)
        return Calibrated(name, _UNITS.get(name.rstrip(" 0123456789"), "1"), None, value, low, high)
    if name in VECTOR_NAMES:
        nominal, unit = parameters.value(name), QUANTITIES[name].unit
        value, low, high = (float(nominal * np.exp(x) if logarithm else nominal + x) for x in ends)
        return Calibrated(name, unit, nominal, value, low, high)
    if logarithm:
        value, low, high = (float(np.exp(x)) for x in ends)
        return Calibrated(f"{name}, share of the nominal value", "1", 1.0, value, low, high)
    value, low, high = (float(x) for x in ends)
    return Calibrated(f"{name}, change", entry.unit, 0.0, value, low, high)


_UNITS = {
    "slow modulus": "Pa", "fast modulus": "Pa", "radius": "m", "viscosity": "N s/m", "drag": "N s²/m²",
    "stop force": "N", "creep stiffness": "N/m",
}  # fmt: skip
"""Units of quantities that the parameter set does not have."""
