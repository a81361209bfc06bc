"""What every form of export needs of a model: states, units, constants, and kernels that say how it moves."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Variable:
    """A number of the model: name in code, SI unit, meaning, and the size it usually has."""

    name: str
    unit: str
    meaning: str
    nominal: float = 1.0


@dataclass(frozen=True)
class Kernels:
    """How a model moves, as Python kernels that can be translated (`pipeline.export.translate`).

    K inputs, N states x, Z memories z (which change only from step to step), B numbers `base` that hold during a
    step; c are the constants. A step of classical Runge-Kutta calls `begin`, four times `rates`, then `finish`.

    Attributes
    ----------
    drive : ``(v (K,), c, u (K,))``
        Fill the inputs of the equations from the measured voltages.
    start : ``(q0, qdot0, u, c, x (N,), z (Z,))``
        Fill the state as after a long rest.
    begin : ``(x, z, h, c, base (B,))``
        Fill what holds during a step of length h [s].
    rates : ``(x, z, base, u, c, dx (N,))``
        Fill the rates of the states within a step.
    finish : ``(base, c, x, z)``
        Move what changes only from step to step.
    flow : ``(x, z, base, u, c, dx (N,))``
        As `rates`, for an integrator with steps of its own.
    read : ``(x, dx, c, y (3,))``
        Fill the measured q, q̇, q̈.
    inside : ``(x, c) -> bool``
        Whether the state lies within the bounds of the model.
    lag : ``(before (K,), within (K,), after (K,), h, c, x)``, optional
        Where inputs lag: replace those at the start, the middle and the end of a step of length h [s] by what acts, and
        move their states to its end. With h = 0 they are what acts at x.
    """

    drive: Callable[..., None]
    start: Callable[..., None]
    begin: Callable[..., None]
    rates: Callable[..., None]
    finish: Callable[..., None]
    flow: Callable[..., None]
    read: Callable[..., None]
    inside: Callable[..., bool]
    lag: Callable[..., None] | None = None


@dataclass(frozen=True)
class Realisation:
    """A model in the form that is exported.

    Attributes
    ----------
    kernels : Kernels
    constants : NamedTuple
        What the kernels call c.
    inputs : int
        K.
    states, memories : tuple of Variable
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
    """

    kernels: Kernels
    constants: Any
    inputs: int
    states: tuple[Variable, ...]
    memories: tuple[Variable, ...]
    base: int
    step: float
    delay: float
    spline: bool
    structure: str
