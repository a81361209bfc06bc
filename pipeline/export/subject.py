"""What is exported: a model, what it was identified on, within which bounds it may be trusted, and its curves."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol, runtime_checkable

import numpy as np

from pipeline.models.base import Model
from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class Validity:
    """Bounds of the training logs; outside of them a model extrapolates.

    Attributes
    ----------
    q : (float, float)
        Least and largest displacement, in `q_unit`.
    qdot : (float, float)
        Least and largest velocity.
    v : tuple of (float, float)
        Least and largest value of each input, in `v_units`.
    sample_interval : float
        Interval [s] at which the model was identified, simulated and scored.
    q_unit : str
        m or rad.
    v_units : tuple of str
        SI unit of each input.
    """

    q: tuple[float, float]
    qdot: tuple[float, float]
    v: tuple[tuple[float, float], ...]
    sample_interval: float
    q_unit: str
    v_units: tuple[str, ...]


@dataclass(frozen=True)
class Subject:
    """A model of a run with everything that travels along.

    Attributes
    ----------
    prototype, name : str
        Names of the prototype and of the model.
    model : Model
        The model itself.
    validity : Validity
        Where it may be trusted.
    origin : str
        Content hash of the artifact that holds the model.
    t, v : FloatArray, shapes (N,), (N, K)
        Time [s] and voltages [V] of a log, validation first: the check that travels along.
    start : (float, float)
        Displacement and velocity at its first sample.
    """

    prototype: str
    name: str
    model: Model
    validity: Validity
    origin: str
    t: FloatArray
    v: FloatArray
    start: tuple[float, float]

    @property
    def identifier(self) -> str:
        """Name for files and functions: letters, digits and underscores."""
        text = "".join(c if c.isascii() and c.isalnum() else "_" for c in f"{self.prototype}_{self.name}")
        return text if text[0].isalpha() else f"m{text}"


@dataclass(frozen=True)
class Exported:
    """Files that were written, and what their user should know."""

    written: list[Path]
    notes: list[str] = field(default_factory=list)


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
