"""What every form of export needs of a model: states, units, constants, and functions that say how it moves."""

import importlib
from dataclasses import dataclass
from typing import Any

from pipeline.codegen.graph import Graph
from pipeline.errors import InputError
from pipeline.model_list import ENTRIES
from pipeline.models.base import Model
from pipeline.models.store import kind


@dataclass(frozen=True)
class Variable:
    """A number of the model: name in code, SI unit, meaning, and the size it usually has."""

    name: str
    unit: str
    meaning: str
    nominal: float = 1.0


SCALARS = frozenset({"h", "q0", "qdot0"})
"""Inputs of functions that are single numbers."""


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
        they are what acts at x. Where an integrator with steps of its own needs other rates, ``flow``: as ``rates``.
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
    spline : bool
        Whether voltages are a cubic spline between the samples, or lines.
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
    spline: bool
    structure: str
    held: tuple[int, int] | None = None


def realise(model: Model, interval: float, unit: str = "m") -> Realisation:
    """States, constants and kernels of a model.

    Parameters
    ----------
    model : Model
        Identified model or baseline.
    interval : float
        Sample interval [s] of its run; it decides the step.
    unit : str
        Unit of q, m or rad.

    Raises
    ------
    InputError
        A model of this kind has no equations to write down elsewhere.
    """
    equations = kind(model.name).equations
    if not equations:
        others = ", ".join(one.name for one in ENTRIES if kind(one.name).equations)
        raise InputError(f"the model {model.name} has no export; choose one of {others} with --model")
    module, _, function = equations.partition(":")
    made: Realisation = getattr(importlib.import_module(module), function)(model, interval, unit)
    return made
