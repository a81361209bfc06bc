"""What is exported: a model, what it was identified on, and within which bounds it may be trusted."""

from dataclasses import dataclass, field
from pathlib import Path

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
