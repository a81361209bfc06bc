"""Structure of a data-driven joint, the scales that make it dimensionless, and the path of its inputs.

The input path leads from measured inputs to those at every half step: hold between samples, delay, lag, square.
"""

from dataclasses import replace
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import BeforeValidator, Field, dataclasses as stored, model_validator
from scipy.interpolate import CubicSpline

from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled
from ...numerics.linear_filters import first_order_lag
from ..model_file import STORED, Positive, Real, Unit, listed

Hold = Literal["linear", "zero", "cubic", "record"]
"""Course of an input between samples: on lines, held (a converter's zero-order hold), on a cubic spline, or as the
finer record has it."""

GAUSS = float(1.0 / np.sqrt(3.0))
"""Gauss's two points of [−1, 1], exact for cubics."""

OVERDAMPED = 7.0
"""Damping of an overdamped device to start from, in units of the frequency scale: its inertia acts for a hundredth of
the time in which it crosses half its range."""

ForceShape = Literal["curve", "polynomial", "offset"]
"""Restoring force: polynomial and Gaussians, the polynomial alone, or a constant (a free mass)."""


_MOST_ELEMENTS = 16
_Elements = Annotated[int, Field(ge=0, le=_MOST_ELEMENTS)]


@stored.dataclass(frozen=True, config=STORED)
class JointStructure:
    """Terms of the data-driven joint; the text below a field is its line of help in the file."""

    basis_functions: Annotated[int, Field(ge=2, le=200)] = 12
    """Gaussians of each curve."""
    smoothing: Annotated[float, Field(ge=1e-3, le=1e3)] = 1.0
    """Smoothing factor σ_n: the width over the distance of the centres."""
    rates: Annotated[
        tuple[Annotated[float, Field(ge=0.0)], ...],
        BeforeValidator(listed),
        Field(max_length=_MOST_ELEMENTS),
        Unit("1"),
    ] = (0.15, 1.5)
    """Relaxation rates of the hidden elements to start from, over the frequency scale."""
    shape_elements: _Elements = 1
    """Hidden shapes: the first so many elements (the slope of the tip, the beam's interior), whose rates depend on the
    displacement, and at which the inputs pull."""
    slips: _Elements = 1
    """States of Dahl friction."""
    arc: bool = True
    """True if the inertia may vary with the displacement (a tip on an arc)."""
    drag: bool = False
    """True if a fluid's drag acts, by the square of the speed."""
    stops: bool = False
    """True if the motion may meet two end stops."""
    input_lag: bool = False
    """True if the inputs act through a first-order lag (a propeller, a slow drive)."""
    effect_lags: bool = False
    """True if that lag follows the effect of the inputs, as heat or pressure follows a power."""
    turning_arm: bool = False
    """True if q is the angle of an arm on which weight acts: sin q and cos q instead of x and x² in the basis."""
    force: ForceShape = "curve"
    """Shape of the restoring force."""
    constant_damping: bool = False
    """True if the damping is a number instead of a curve."""
    constant_gain: bool = False
    """True if the input gains are numbers instead of curves."""
    hold: Hold = "linear"
    """Course of the inputs between samples."""
    rest_at_zero: bool = False
    """True if hidden states start as after a long rest without inputs, instead of under the first ones."""
    input_delay: bool = False
    """True if the inputs act later than they were measured by a constant time."""
    bent_input: bool = False
    """True if the inputs act by a curve of their own, steeper or flatter at zero than a line."""
    dead_zone: bool = False
    """True if small inputs have no effect."""
    overdamped: bool = False
    """True if inertia is expected to hardly matter beside damping (a soft actuator, a level, a temperature). The
    equation is the same; its start and its scales are those of the velocity."""

    @model_validator(mode="after")
    def _elements(self) -> Self:
        if self.shape_elements > len(self.rates):
            raise ValueError(f"{self.shape_elements} shape elements among {len(self.rates)} elements")
        return self


@stored.dataclass(frozen=True, config=STORED)
class JointScales:
    """Units of the dimensionless joint."""

    middle: Annotated[Real, Unit("{q}")]
    """Middle of the range of q."""
    half: Annotated[Positive, Unit("{q}")]
    """Half of the range of q."""
    volts: Annotated[Positive, Unit("{v}")]
    """Largest input of the training logs."""
    stiffness: Annotated[Positive, Unit("1/s²")]
    """RMS acceleration over half the range of q."""
    speed: Annotated[Real, Field(ge=0.0), Unit("1/s")] = 0.0
    """RMS velocity over half the range of q."""
    slope: Annotated[Real, Field(ge=0.0), Unit("1/s²")] = 0.0
    """RMS slope of the velocity between samples over half the range of q. Unlike accelerations it holds no noise that
    is faster than the samples."""

    @property
    def frequency(self) -> float:
        """Frequency scale of the joint [rad/s]."""
        return float(np.sqrt(2.0 * self.stiffness))

    @property
    def overdamped(self) -> "JointScales":
        """Scales for an overdamped device: the force scale follows from the speed, by damping of `OVERDAMPED`."""
        return replace(self, stiffness=2.0 * (OVERDAMPED * self.speed) ** 2)


def known_inputs(v: FloatArray) -> FloatArray:
    """Inputs row by row, shape (n, K), from those at the samples (N, K) or at r times of each interval (N, r, K)."""
    return v if v.ndim == 2 else v.reshape(-1, v.shape[2])


def spline_through(inputs: FloatArray) -> CubicSpline:
    """The cubic spline through inputs, over their numbers. Cost: 40 ns each."""
    return CubicSpline(np.arange(len(inputs)), inputs)


def drive_at_nodes(
    v: FloatArray,
    interval: float,
    steps: int,
    hold: Hold,
    delay: float = 0.0,
    spline: CubicSpline | None = None,
    *,
    squared: bool = False,
) -> FloatArray:
    """Inputs at every half step.

    Parameters
    ----------
    v : FloatArray, shape (N, K) or (N, r, K)
        Inputs at the samples, or at r evenly spaced times of each sample interval.
    interval : float
        Sample interval [s].
    steps : int
        Integration steps per interval.
    hold : str
        The inputs between the times at which they are known; "record" is linear between the finer ones, see
        `_record_nodes`.
    delay : float
        Time [s] by which they act later; before the first sample they are those of the first.
    spline : CubicSpline, optional
        `spline_through` the inputs, where it is known.
    squared : bool
        True if inputs act by their squares: then nodes of a record are signed roots of those of the squares.

    Returns
    -------
    FloatArray, shape (2·steps·(N−1)+1, K)
        With "zero" the value of a node is that of the step which begins at it, with a delay its mean over that step.
        Cost: 5 ns per node and input, on a spline 7 to 16.
    """
    inputs = known_inputs(v)
    spacing = interval * len(v) / len(inputs)
    half = interval / spacing / (2 * steps)
    # Counted in known times, so that a node on a sample is exactly on it.
    at: FloatArray = np.arange(2 * steps * (len(v) - 1) + 1, dtype=np.float64) * half - delay / spacing
    times = np.arange(len(inputs))
    if hold == "zero" and delay:
        return _held_means(inputs, at)
    if hold == "record":
        acting = np.ascontiguousarray(inputs * inputs if squared else inputs)
        means = _record_nodes(acting, float(at[0]), 2.0 * half, len(at) // 2)
        return np.sign(means) * np.sqrt(np.abs(means)) if squared else means
    at = np.clip(at, 0.0, times[-1])
    if hold == "zero":
        return np.ascontiguousarray(inputs[np.floor(at + 1e-9).astype(np.int64)])
    if hold == "cubic" and len(inputs) > 3:
        return np.ascontiguousarray((spline or spline_through(inputs))(at))
    return np.column_stack([np.interp(at, times, column) for column in inputs.T])


def _held_means(inputs: FloatArray, at: FloatArray) -> FloatArray:
    """Means of held inputs over each step, of two nodes: what a delay that ends within a step leaves of it.

    They change smoothly with the delay, so that it can be estimated; values at the nodes would jump.
    """
    before = min(0.0, np.floor(at[0]))
    times = np.concatenate(([before], np.arange(len(inputs) + 1)))
    ends = np.append(at[::2], 2.0 * at[-1] - at[-3])
    area = np.concatenate((before * inputs[:1], np.zeros_like(inputs[:1]), np.cumsum(inputs, axis=0)))
    means = np.column_stack([np.diff(np.interp(ends, times, column)) for column in area.T]) / (at[2] - at[0])
    return np.repeat(means, 2, axis=0)[: len(at)]


@compiled
def _record_nodes(inputs: FloatArray, first: float, step: float, steps: int) -> FloatArray:
    """Nodes of steps that move a mass as the record's lines do, shape (2·steps + 1, K).

    Lagrange's three polynomials of a step share out an impulse among its nodes, which Runge-Kutta weights by Simpson's
    rule: its size and its time are kept wherever it falls, and what is constant or a line stays so. Means over parts of
    a step would keep its size alone. Next to a jump a node may lie below the lowest input.

    Parameters
    ----------
    inputs : FloatArray, shape (R, K)
        Inputs at the times 0, 1, …, R − 1; constant before and after.
    first, step : float
        Beginning of the first step, and length of each, in intervals of these times.
    steps : int
        Number of steps.

    Notes
    -----
    Cost: 12 to 20 ns for each line of each input. Gauss's two points integrate a line times a parabola exactly.
    """
    last, columns = len(inputs) - 1, inputs.shape[1]
    nodes = np.zeros((2 * steps + 1, columns))
    whole = np.zeros((2 * steps + 1, 1))
    for n in range(steps):
        left = begin = first + n * step
        end = first + (n + 1) * step
        while left < end:
            right = min(end, np.floor(left) + 1.0)
            for side in (-GAUSS, GAUSS):
                point = 0.5 * (left + right) + 0.5 * side * (right - left)
                s = (point - begin) / step
                shares = ((1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0))
                place = min(max(point, 0.0), float(last))
                below = int(place)
                above = min(below + 1, last)
                for i in range(3):
                    weight = shares[i] * (right - left)
                    whole[2 * n + i, 0] += weight
                    for k in range(columns):
                        line = inputs[below, k] + (place - below) * (inputs[above, k] - inputs[below, k])
                        nodes[2 * n + i, k] += weight * line
            left = right
    return nodes / whole


def lagged(
    volts: FloatArray, half: float, lag: float, *, held: bool, rest_at_zero: bool
) -> tuple[FloatArray, FloatArray]:
    """Inputs behind a first-order lag, and their derivatives by its logarithm.

    Parameters
    ----------
    volts : FloatArray, shape (n, K)
        Inputs at every half step.
    half : float
        Half a step [s].
    lag : float
        Time constant [s].
    held : bool
        True if inputs are constant from node to node.
    rest_at_zero : bool
        True if the lag starts at zero instead of at the first input.
    """
    out = np.empty_like(volts)
    by_lag = np.empty_like(volts)
    for i in range(volts.shape[1]):
        start = 0.0 if rest_at_zero else float(volts[0, i])
        out[:, i], by_lag[:, i] = first_order_lag(np.ascontiguousarray(volts[:, i]), half, lag, start, held)
    return out, by_lag
