"""Classical Runge-Kutta steps of fixed length: the one integrator of everything that is not stiff.

Inputs are given on the half steps, every run of a fit sees the same discretisation, and the result is a smooth function
of the constants. A run is reproducible to the last bit and bounded in time. The integrator takes a `system`: a
NamedTuple of arrays whose type says, through `integrator`, how its state moves. Friction that has no differential
equation moves exactly with the step, in `begin` and `finish`.

In a free run nothing is fed back from the measurement, and voltages are linear between samples.
"""

# mypy: disable-error-code="no-untyped-def,no-untyped-call"

from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any, Literal, NamedTuple

import numpy as np

from .arrays import FloatArray
from .compiled import FAST, Kernel, compiled, implement, inlinable, types

# No wrapper for calls from Python, which would be half of what a small function costs to compile.
_OPTIONS: Any = {
    "error_model": "numpy",
    "fastmath": FAST,
    "forceinline": True,
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
    "_nrt": False,  # a function that makes no array need not count who holds those that it is given
}
_NAMED = (types.NamedTuple, types.NamedUniTuple)

NODES = (0, 1, 1, 2)
AHEAD = (0.5, 0.5, 1.0, 0.0)
"""The method's table: the half step of each stage, and by which part of the step its rates lead to the next stage."""
SHARES = (1.0, 2.0, 2.0, 1.0)
ALL_SHARES = 6.0
"""Shares of the stages' rates in the step, and their sum."""
STAGE_NODES = np.array(NODES)
STAGE_AHEAD = np.array(AHEAD)
STAGE_SHARES = np.array(SHARES)
"""The same for kernels, in which a look-up in a tuple is a chain of branches."""


def inlined(function: Kernel) -> Kernel:
    """Inline a function that `rates` of a system call: it becomes a part of the run's machine code."""
    return inlinable(**_OPTIONS)(function)  # type: ignore[no-any-return]


# What `integrate` calls; the compiler puts in its place what `integrator` was given for the system's class. Systems of
# differential equations alone are given `begin` and `finish` themselves, which do nothing.


def begin(system, x, node):
    """A step begins at the state x and the half step `node`."""


def rates(system: Any, x: FloatArray, node: int, dx: FloatArray, acceleration: FloatArray) -> None:
    """Fill the rates of the state at the half step `node`, and the accelerations without an observer's pull.

    Parameters
    ----------
    system : NamedTuple
        The system.
    x : FloatArray, shape (S,)
        State.
    node : int
        Half step.
    dx : FloatArray, shape (S,)
        Rates (output).
    acceleration : FloatArray, shape (W,)
        Accelerations of the W displacements (output).
    """


def finish(system, x):
    """Move what moves only with whole steps; x is the state at the end of the step."""


def shown(system: Any, x: FloatArray, j: int, width: int) -> tuple[float, float]:
    """Displacement and velocity of one of the systems side by side, as they are written out.

    Parameters
    ----------
    system : NamedTuple
        The systems.
    x : FloatArray, shape (S,)
        Their state.
    j, width : int
        Number of the system, and of all.
    """
    raise NotImplementedError


def _first_states(system, x, j, width):
    """Outputs of systems whose first states are written out."""
    return x[j], x[width + j]


class Methods(NamedTuple):
    """Functions that move the systems of one type, with the names and arguments of those above."""

    begin: Callable[..., None]
    rates: Callable[..., None]
    finish: Callable[..., None]
    shown: Callable[..., tuple[float, float]] = _first_states


def integrator(kind: type, methods: Callable[[Any], Methods]) -> Callable[..., int]:
    """`integrate` for systems of a NamedTuple class, compiled with them.

    `methods` gives their functions; it gets their numba type, which differs between a batch and one.
    """

    @cache
    def of(system) -> Methods | None:
        """The methods, if the system is of this class."""
        return methods(system) if isinstance(system, _NAMED) and system.instance_class is kind else None

    @implement(begin, jit_options=_OPTIONS)
    def _begin(system, x, node):
        return own.begin if (own := of(system)) else None

    @implement(rates, jit_options=_OPTIONS)
    def _rates(system, x, node, dx, acceleration):
        return own.rates if (own := of(system)) else None

    @implement(finish, jit_options=_OPTIONS)
    def _finish(system, x):
        return own.finish if (own := of(system)) else None

    @implement(shown, jit_options=_OPTIONS)
    def _shown(system, x, j, width):
        return own.shown if (own := of(system)) else None

    integrate_kind = FunctionType(integrate.__code__, integrate.__globals__, f"integrate_{kind.__name__}")
    integrate_kind.__qualname__ = integrate_kind.__name__
    return compiled(fastmath=FAST, _nrt=False)(integrate_kind)


def workspace(x: FloatArray) -> FloatArray:
    """Workspace of `integrate` for a state x (S,), shape (4, S)."""
    return np.zeros((4, len(x)))


def integrate(
    system: Any, x: FloatArray, out: FloatArray, work: FloatArray, substeps: int, h: float, low: float, high: float
) -> int:
    """Integrate from x, which becomes the state at the last sample.

    Parameters
    ----------
    system : NamedTuple
        Of a class that has been given to `integrator`.
    x : FloatArray, shape (S,)
        State: W displacements, their W velocities, and whatever else moves.
    out : FloatArray, shape (N, 3, W)
        Displacement, velocity and acceleration at the samples, the first at the start; filled.
    work : FloatArray, shape (4, S)
        See `workspace`.
    substeps : int
        Steps between two samples.
    h : float
        Step [s].
    low, high : float
        The run ends as diverged where the first displacement leaves them or the first velocity is no number; with
        −∞ it runs to its end.

    Returns
    -------
    int
        Samples in `out` that are valid.
        Cost: four evaluations of the rates a step, and as many after the last, and 12 S multiplications.
    """
    samples, _, width = out.shape
    y = work[0]
    dx = work[1]
    total = work[2]
    acceleration = work[3, :width]
    final = 2 * substeps * (samples - 1)
    for sample in range(samples):
        if low > -np.inf and not (low <= x[0] <= high and np.isfinite(x[width])):
            return int(sample)
        for j in range(width):
            out[sample, 0, j], out[sample, 1, j] = shown(system, x, j, width)
        for step in range(substeps if sample < samples - 1 else 1):
            node = 2 * (sample * substeps + step)
            begin(system, x, node)
            within, length = (1, h) if node < final else (0, 0.0)
            for i in range(len(x)):
                y[i] = x[i]
                total[i] = 0.0
            for stage in range(len(NODES)):
                rates(system, y, node + within * STAGE_NODES[stage], dx, acceleration)
                if step == 0 and stage == 0:
                    for j in range(width):
                        out[sample, 2, j] = acceleration[j]
                share = STAGE_SHARES[stage]
                ahead = STAGE_AHEAD[stage] * length
                for i in range(len(x)):
                    total[i] += share * dx[i]
                    y[i] = x[i] + ahead * dx[i]
            for i in range(len(x)):
                x[i] += length / ALL_SHARES * total[i]
            if within:
                finish(system, x)
    return int(samples)


MAX_STEP = 5e-3
"""Longest integration step [s]: 70 steps per period of the 2.8 Hz ringing in a well, 20 of the fastest at 9 Hz."""

LAG_STEP = 0.5
"""Longest step as a share of the lag; Runge-Kutta 4 is stable up to 2.78 and accurate to 1e-4 at 0.5."""


def steps_per_sample(interval: float, time_constant: float) -> int:
    """Integration steps per sample interval for a model whose fastest lag is `time_constant` [s]."""
    return int(np.ceil(interval / min(MAX_STEP, LAG_STEP * time_constant)))


def escape_bounds(low: float, high: float) -> tuple[float, float]:
    """Displacements beyond which a run counts as diverged: two operating ranges past either end of the data."""
    return low - 2.0 * (high - low), high + 2.0 * (high - low)


@inlined
def between_samples(node: int, parts: int, samples: int) -> tuple[int, int, float]:
    """Samples about the half step `node`, `parts` of which are an interval, and its share of the way between them."""
    n = node // parts
    return n, min(n + 1, samples - 1), (node - n * parts) / parts


def bounded_run(
    integrate: Callable[..., int],
    system: NamedTuple,
    x: FloatArray,
    samples: int,
    steps: int,
    interval: float,
    bounds: tuple[float, float],
) -> tuple[FloatArray, int]:
    """q, q̇, q̈ of a system from x at the samples, (N, 3), NaN from where q leaves the bounds; and valid samples.

    Parameters
    ----------
    integrate : callable
        From `integrator`.
    system : NamedTuple
        The system.
    x : FloatArray, shape (S,)
        First state; becomes the last one.
    samples, steps : int
        N, and steps in a sample interval.
    interval : float
        Sample interval [s].
    bounds : (float, float)
        Displacements beyond which the run ends.
    """
    out = np.full((samples, 3, 1), np.nan)
    valid = integrate(system, x, out, workspace(x), steps, interval / steps, float(bounds[0]), float(bounds[1]))
    return out[:, :, 0], valid


def run_status(t: FloatArray, valid: int) -> tuple[Literal["ok", "diverged"], float | None]:
    """Status of a run with `valid` good samples, and the time [s] of its divergence."""
    return ("ok", None) if valid == len(t) else ("diverged", float(t[valid]))
