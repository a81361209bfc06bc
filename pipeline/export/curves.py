"""Characteristic curves of a model as tables with units (fig. 14)."""

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from pipeline.export.subject import Subject
from pipeline.numerics.arrays import FloatArray

BREAKPOINTS = 201
"""Linear interpolation between so many is off by less than a thousandth of a curve's range."""

_UNITS = {
    "m": {"F": "N", "d": "N·s/m", "dC": "F/m", "g": "N/V"},
    "rad": {"F": "N·m", "d": "N·m·s/rad", "dC": "F/rad", "g": "N·m/V"},
    "V": {"F": "V/s²", "d": "1/s", "dC": "1/(V·s²)", "g": "1/s²"},
}
"""By the start of a curve's name."""


@dataclass(frozen=True)
class CurveTable:
    """One curve over the range of the training logs."""

    name: str
    unit: str
    q: FloatArray
    values: FloatArray


@runtime_checkable
class _HasCurves(Protocol):
    def curves(self, q: FloatArray) -> dict[str, FloatArray]:
        """Characteristic curves at q."""


def curve_tables(subject: Subject) -> list[CurveTable]:
    """Restoring force F, damping d, and what the inputs do; none for a model without curves."""
    if not isinstance(subject.model, _HasCurves):
        return []
    q, units = np.linspace(*subject.validity.q, BREAKPOINTS), _UNITS[subject.validity.q_unit]
    return [
        CurveTable(name, units[name.split("_")[0].rstrip("12")], q, values)
        for name, values in subject.model.curves(q).items()
    ]
