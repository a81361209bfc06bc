"""The exported model with its bounds and curves, and its realisation: states, constants, equations of motion."""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..codegen.graph import Graph, choose, function
from ..models.base import DynamicModel, HasCurves
from ..models.model_type import equations_of
from ..numerics.arrays import FloatArray
from ..system.names import slug
from ..units.quantity import quantity

_STRONGER = 1.05
_FARTHER = 0.6
"""Times the largest trained input, and the trained range from its middle, beyond which a model extrapolates."""
_WEAKER = (0.2e-3, 3e-3)
"""Shares of the largest trained input between which another one looks like kV."""


MATLAB_NAME = 63
"""Most letters of a name in MATLAB (namelengthmax)."""
BREAKPOINTS = 201
"""With this number linear interpolation is off by less than a thousandth of a curve's range."""
SCALARS = frozenset({"h", "q0", "qdot0"})
"""Inputs of functions that are single numbers."""


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

    def beyond(self, inputs: Sequence[FloatArray], q0: float | None = None) -> list[str]:
        """Sentences on inputs and a first displacement that the training logs do not reach, and on inputs in kV."""
        reached = [max(map(abs, span)) for span in self.v]
        largest = [float(np.nanmax(np.abs(v), initial=0.0)) for v in inputs]
        texts = [
            f"v{k} is up to {quantity(size, unit)}, in the training logs up to {quantity(most, unit)}: the model "
            "extrapolates"
            for k, (size, most, unit) in enumerate(zip(largest, reached, self.v_units, strict=True), start=1)
            if size > _STRONGER * most
        ]
        if _WEAKER[0] * max(reached) < max(largest) < _WEAKER[1] * max(reached):
            texts.append(
                f"v is up to {max(largest):.3g} {self.v_units[0]} only, in the training logs up to "
                f"{max(reached):.4g} {self.v_units[0]}; if it is in k{self.v_units[0]}, multiply by 1000"
            )
        low, high = self.q
        if q0 is not None and abs(q0 - 0.5 * (low + high)) > _FARTHER * (high - low):
            span = f"{quantity(low, self.q_unit, like=high)} to {quantity(high, self.q_unit, like=low)}"
            texts.append(f"q0 is {quantity(q0, self.q_unit)}, in the training logs q is {span}: the model extrapolates")
        return texts


@dataclass(frozen=True)
class Subject:
    """A model of a run with everything that travels along.

    Attributes
    ----------
    prototype, name : str
        Names of the prototype and of the model.
    model : DynamicModel
        The model itself.
    validity : Validity
        Range in which it may be trusted.
    origin : str
        Content hash of the artifact that holds the model.
    t, v : FloatArray, shapes (N,), (N, K)
        Time [s] from zero and voltages [V] of a log, validation first: the check that travels along.
    start : (float, float)
        Displacement and velocity at its first sample.
    curve_units : mapping of str to str
        SI units of its curves by the start of their names (`pipeline.device.device.Device.curve_units`).
    """

    prototype: str
    name: str
    model: DynamicModel
    validity: Validity
    origin: str
    t: FloatArray
    v: FloatArray
    start: tuple[float, float]
    curve_units: Mapping[str, str]

    @property
    def identifier(self) -> str:
        """Name for files and functions: letters, digits and underscores."""
        text = "".join(c if c.isascii() and c.isalnum() else "_" for c in f"{slug(self.prototype)}_{self.name}")
        text = text if text[0].isalpha() else f"m{text}"
        if len(text) <= MATLAB_NAME:
            return text
        digest = hashlib.sha256(text.encode()).hexdigest()[:8]  # separates it from others that begin alike
        return f"{text[: MATLAB_NAME - len(digest) - 1]}_{digest}"

    def realisation(self) -> "Realisation":
        """States, constants and kernels of the model at the sample interval of its run.

        Raises
        ------
        InputError
            A model of this type has no equations to write down elsewhere.
        """
        realise: Callable[[DynamicModel, float, str], Realisation] = equations_of(self.model.name)
        return realise(self.model, self.validity.sample_interval, self.validity.q_unit)


@dataclass(frozen=True)
class Exported:
    """Files that were written, and remarks for their user."""

    written: list[Path]
    notes: list[str] = field(default_factory=list)


def curve_tables(subject: Subject) -> list[dict[str, Any]]:
    """Restoring force F, damping d, and gains of the inputs; none for a model without curves.

    Each has a `name`, a `unit`, and the arrays `q` over the range of the training logs, and `values`, shape (201,).
    """
    if not isinstance(subject.model, HasCurves):
        return []
    q = np.linspace(*subject.validity.q, BREAKPOINTS)
    return [
        {"name": name, "unit": subject.curve_units[name.split("_")[0].rstrip("12")], "q": q, "values": values}
        for name, values in subject.model.curves(q).items()
    ]


@dataclass(frozen=True)
class Variable:
    """A number of the model: name in code, SI unit, meaning, and the size it usually has."""

    name: str
    unit: str
    meaning: str
    nominal: float = 1.0


@dataclass(frozen=True)
class Realisation:
    """A model in the form that is exported.

    Attributes
    ----------
    functions : dict of Graph
        How the model moves: K inputs u, N states x, Z hysteresis states z (which change only from step to step), B
        numbers `base` that hold during a step. A step of classical Runge-Kutta takes ``begin``, four times ``rates``,
        then ``finish``.

        ``drive``: v → u, inputs of the equations from the measured voltages. ``start``: q0, qdot0, u → x, z, as after a
        long rest. ``begin``: x, z, h → base. ``rates``: x, z, base, u → dx. ``finish``: base, x, z → x, z.
        ``read``: x, dx → y, the measured q, q̇, q̈. ``within``: x → ok, whether x lies within the bounds of the model.
        Where inputs lag, ``lag``: before, within, after, h, x → before, within, after, x replaces those at the start,
        the middle and the end of a step of length h [s] by what acts, and moves their states to its end; with h = 0
        they are what acts at x. Where an integrator with steps of its own needs other rates, ``flow``: as ``rates``;
        hysteresis states are moved by ``finish`` after its steps, too.
        Where the shape at rest is found by iteration, ``shape``: x, u → f, two forces on the states `held` and their
        four derivatives, and ``stick``: x, u → z.
    constants : dict
        The numbers of the equations by name, for a document.
    inputs : int
        K.
    states, hysteresis_states : tuple of Variable
        x and z, in order.
    base : int
        B.
    step : float
        Step [s] that debist itself takes at the sample interval of the run.
    delay : float
        Time [s] by which the voltages act later than they were measured.
    between : {"linear", "cubic", "zero"}
        Voltages between the samples: lines, a cubic spline, or held.
    structure : str
        The equations in a line.
    held : tuple of two int, optional
        States that are found by iteration at the start.
    """

    functions: dict[str, Graph]
    constants: dict[str, Any]
    inputs: int
    states: tuple[Variable, ...]
    hysteresis_states: tuple[Variable, ...]
    base: int
    step: float
    delay: float
    between: Literal["linear", "cubic", "zero"]
    structure: str
    held: tuple[int, int] | None = None


Values = list[Any]


def lagged_nodes(
    lagged: Values, before: Values, within: Values, after: Values, h: Any, lag: float
) -> tuple[Values, Values]:
    """Lagged inputs at the middle and the end of a step of h [s] whose inputs go on lines between its three nodes.

    The lag [s] may be far shorter than the step.

    Parameters
    ----------
    lagged : list, length K
        Lagged inputs at the beginning of the step.
    before, within, after : list, length K
        Inputs at the beginning, the middle and the end.
    h : number
        Length of the step [s].
    lag : float
        Time constant [s].
    """
    half = 0.5 * h
    middles = [_behind(half, lag, *interval) for interval in zip(lagged, before, within, strict=True)]
    return middles, [_behind(half, lag, *interval) for interval in zip(middles, within, after, strict=True)]


def _behind(h: Any, lag: float, lagged: Any, before: Any, after: Any) -> Any:
    """Lagged input after h [s] of an input that is linear in time."""
    ratio = h / lag
    positive = function("lt", 0.0, ratio)
    share = choose(positive, -function("expm1", -ratio) / choose(positive, ratio, 1.0), 1.0)
    decay = function("exp", -ratio)
    return decay * lagged + (share - decay) * before + (1.0 - share) * after
