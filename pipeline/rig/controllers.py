"""Controllers for the closed loop: Python callables, and voltages that are played.

A controller ``made(q)`` gets the first reading [m] and returns ``step(q, target) -> (v_left, v_right)`` in m and V.
`run_loop` gives the compiled loop its address.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.rig.closed_loop import PERIOD

_STEP = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
Step = Callable[[float, float], tuple[float, float]]


@dataclass
class Controller:
    """A controller in memory.

    Attributes
    ----------
    step : int
        Address of its step function.
    begin : callable
        Told the first reading [m] before the first step.
    failure : list of Exception
        What its Python raised; the voltages are zero from there on.
    keep : tuple
        What must stay alive.
    """

    step: int
    begin: Callable[[float], None]
    failure: list[Exception] = field(default_factory=list)
    keep: tuple[Any, ...] = ()


def python_controller(made: Callable[[float], Step]) -> Controller:
    """A controller from a function that is told the first reading [m] and returns the step function."""
    failure: list[Exception] = []
    steps: list[Step] = []

    def begin(q: float) -> None:
        steps.append(made(q))

    def step(_state: Any, q: float, target: float, v: Any) -> None:
        """Write the voltages [V] for a reading and a target [m] into `v`; zero from the first failure on."""
        left = right = 0.0
        try:
            if not failure:
                left, right = steps[-1](q, target)
        except Exception as error:  # it cannot pass through the compiled loop
            failure.append(error)
        v[0], v[1] = left, right

    called = _STEP(step)
    return Controller(ctypes.cast(called, ctypes.c_void_p).value or 0, begin, failure, (called,))


def played(t: FloatArray, u: FloatArray) -> Controller:
    """A controller that looks at nothing and gives `u`, shape (N, 2) [V], each row from its time `t` [s] on."""
    rows = np.clip(np.searchsorted(t, np.arange(0.0, t[-1] + PERIOD, PERIOD) + 1e-9, side="right") - 1, 0, t.size - 1)
    commands = iter(u[rows].tolist())

    def step(_q: float, _target: float) -> tuple[float, float]:
        """The next row, and nothing after the last."""
        left, right = next(commands, (0.0, 0.0))
        return left, right

    return python_controller(lambda _q: step)
