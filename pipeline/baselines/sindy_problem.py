"""The sparse regression of the acceleration: libraries of candidate terms, and compressed blocks of time."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import scipy.ndimage

from pipeline.baselines.polynomial_dynamics import (
    COSINE,
    FIRST_INPUT,
    FRICTION,
    LAG,
    QDOT,
    SINE,
    Q,
    lag_state,
    monomials,
    scaled_variables,
)
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.least_squares import triangular_factor
from pipeline.numerics.metrics import rms
from pipeline.scoring.cross_validation import HeldOutBlock, held_out_blocks
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.free_run import escape_bounds

Shape = Literal["polynomial", "trigonometric"]


@dataclass(frozen=True)
class Library:
    """What may enter the equation of the acceleration.

    Attributes
    ----------
    shape : {"polynomial", "trigonometric"}
        Functions of q: its powers, or 1, sin q and cos q (an angle).
    degree : int
        Total degree of the polynomial in q and q̇; of the powers of q̇ for the trigonometric shape.
    full : bool
        All products up to the degree; otherwise only powers of q̇ up to 1, so F(q) and d(q)·q̇.
    friction : bool
        f(q)·tanh(q̇/w), a smoothed dry friction.
    lag_time : float
        f(q)·z with ż = (q̇ − z)/T_z, T_z in s; 0 leaves the lag state out.
    coupling : int
        Degree of the polynomial f(q) that multiplies z, tanh and the inputs; 0 lets them act alike everywhere. Any
        other number means 1, sin q and cos q for the trigonometric shape.
    """

    shape: Shape
    degree: int
    full: bool
    friction: bool
    lag_time: float
    coupling: int = 3

    def exponents(self, inputs: int) -> IntArray:
        """The exponent table, shape (P, 6 + inputs); inputs enter as f(q)⊗u, never among themselves."""
        rows = [_row(inputs, powers) for powers in self._body()]
        factors = [LAG] * (self.lag_time > 0.0) + [FRICTION] * self.friction
        factors += [FIRST_INPUT + k for k in range(inputs)]
        rows += [_row(inputs, f | {factor: 1}) for factor in factors for f in self._couplings()]
        return np.array(rows, dtype=np.int64)

    def _body(self) -> list[dict[int, int]]:
        if self.shape == "trigonometric":
            return [f | {QDOT: j} for f in _CIRCLE for j in range(self.degree + 1 if self.full else 2)]
        return [{Q: i, QDOT: j} for i in range(self.degree + 1) for j in range(self.degree + 1 - i if self.full else 2)]

    def _couplings(self) -> list[dict[int, int]]:
        if self.shape == "trigonometric":
            return _CIRCLE if self.coupling else [{}]
        return [{Q: i} for i in range(self.coupling + 1)]

    def __str__(self) -> str:
        """E.g. ``poly5(q) ⊗ (1, q̇) + poly3(q) ⊗ (z[0.02 s], tanh q̇, u)``."""
        circle = "(1, sin q, cos q)"
        if self.shape == "trigonometric":
            body = f"{circle} ⊗ poly{self.degree if self.full else 1}(q̇)"
        else:
            body = f"poly{self.degree}(q, q̇)" if self.full else f"poly{self.degree}(q) ⊗ (1, q̇)"
        lag = [f"z[{self.lag_time:g} s]"] if self.lag_time > 0.0 else []
        factors = ", ".join([*lag, *(["tanh q̇"] if self.friction else []), "u"])
        if self.coupling == 0:
            return f"{body} + ({factors})"
        return f"{body} + {circle if self.shape == 'trigonometric' else f'poly{self.coupling}(q)'} ⊗ ({factors})"


_CIRCLE: list[dict[int, int]] = [{}, {SINE: 1}, {COSINE: 1}]


def _row(inputs: int, powers: dict[int, int]) -> list[int]:
    return [powers.get(k, 0) for k in range(FIRST_INPUT + inputs)]


TRUNCATE = 4.0  # half length of the filter in standard deviations
_WIDE = 50.0  # samples, the width from which on a filter is evaluated at the rows that are kept alone
SUBBLOCKS = 8  # blocks per window for the ensemble's resampling, about 1 s each in a 37.5 s log


@dataclass(frozen=True)
class Factors:
    """Per window the triangular factors of its sub-blocks, and the RMS [m/s²] that their last columns are scaled by."""

    windows: list[list[FloatArray]]
    scale: float
    stacked: dict[int | None, FloatArray] = field(default_factory=dict)

    def without(self, windows: Sequence[HeldOutBlock], fold: int | None, *, whole: bool) -> list[FloatArray]:
        """The factors of all windows but those of a fold; as a `whole`, one factor, kept for the next optimiser."""
        if whole and fold in self.stacked:
            return [self.stacked[fold]]
        used = [f for w, parts in zip(windows, self.windows, strict=True) if w.fold != fold for f in parts]
        if not whole:
            return used
        self.stacked[fold], _ = triangular_factor([np.vstack(used)])
        return [self.stacked[fold]]


@dataclass
class Problem:
    """Scaled training data, cut into windows; compressed libraries are kept, fits of one library share them."""

    trajectories: Sequence[Trajectory]
    squared: bool
    windows: list[HeldOutBlock]
    scales: FloatArray
    acceleration_scale: float
    low: float
    high: float
    factors: dict[tuple[Library, float], Factors] = field(default_factory=dict)

    @property
    def inputs(self) -> int:
        """Number of inputs K."""
        return int(self.trajectories[0].v.shape[1])

    @property
    def folds(self) -> list[int]:
        """Folds that hold a window."""
        return sorted({w.fold for w in self.windows})


def prepare_problem(trajectories: Sequence[Trajectory], squared: bool) -> Problem:
    """Scales, bounds and held-out windows of the training data.

    Raises
    ------
    InputError
        No data, differing inputs, or a constant displacement.
    """
    low, high = operating_range(trajectories)
    if len({x.v.shape[1] for x in trajectories}) != 1:
        raise InputError("the training logs differ in their number of inputs; identify them apart")
    u = np.concatenate([np.square(x.v) if squared else np.abs(x.v) for x in trajectories])
    speed = max(float(np.abs(x.qdot).max()) for x in trajectories)
    acceleration = rms(np.concatenate([x.qddot for x in trajectories]))
    scales = np.array([max(abs(low), abs(high)), speed, speed, 0.1 * speed, 1.0, 1.0, *u.max(axis=0)])
    scales[scales == 0.0] = 1.0  # an input that is never used: its columns are zero whatever the scale
    bounds = escape_bounds(low, high)
    return Problem(trajectories, squared, held_out_blocks(trajectories), scales, acceleration or 1.0, *bounds)


def compressed_library(problem: Problem, library: Library, filter_time: float) -> Factors:
    """Compressed regression of one library; rows are built, filtered and compressed one sub-block at a time."""
    if (library, filter_time) in problem.factors:
        return problem.factors[library, filter_time]
    exponents = library.exponents(problem.inputs)
    variables = []
    for x in problem.trajectories:
        z = lag_state(x.qdot, x.interval, library.lag_time)
        variables.append(scaled_variables(problem.scales, problem.squared, x.v, x.q, x.qdot, z))
    squares, count = 0.0, 0
    windows: list[list[FloatArray]] = []
    for w in problem.windows:
        x, scaled, parts = problem.trajectories[w.source], variables[w.source], []
        for span in itertools.pairwise(np.linspace(w.start, w.stop, SUBBLOCKS + 1).astype(int)):
            wide, kept = _filter_rows(w, (int(span[0]), int(span[1])), filter_time / x.interval)
            if kept.stop <= kept.start:  # a filter longer than the window
                continue
            rows = np.column_stack([monomials(exponents, scaled[wide]), x.qddot[wide]])
            rows = _filtered(rows, filter_time / x.interval, kept)
            squares, count = squares + float(np.sum(rows[:, -1] ** 2)), count + len(rows)
            if len(rows):
                parts.append(triangular_factor([rows])[0])
        windows.append(parts)
    scale = float(np.sqrt(squares / max(count, 1))) or 1.0
    for part in itertools.chain.from_iterable(windows):
        part[:, -1] /= scale
    problem.factors[library, filter_time] = Factors(windows, scale)
    return problem.factors[library, filter_time]


def _filter_rows(window: HeldOutBlock, span: tuple[int, int], width: float) -> tuple[slice, slice]:
    """Rows to filter for a sub-block, and which of the filtered ones to keep.

    The filter reaches into the neighbouring sub-blocks, not beyond the window: held-out rows stay unseen. Where it
    would, the row is dropped, because a truncated average does not cancel the noise of differences.
    """
    reach = int(np.ceil(TRUNCATE * width)) if width >= 1.0 else 0
    low, high = max(span[0] - reach, window.start), min(span[1] + reach, window.stop)
    first, last = max(span[0], window.start + reach), min(span[1], window.stop - reach)
    return slice(low, high), slice(first - low, max(last, first) - low, max(1, int(width / 2)))


def _filtered(rows: FloatArray, width: float, kept: slice) -> FloatArray:
    """The rows `kept` of a Gaussian filter of `width` samples along time; nothing is filtered below one sample.

    Of a wide one only they are evaluated: a log of 50 kHz has widths of thousands.
    """
    if width < 1.0 or not len(rows):
        return rows[kept]
    if width < _WIDE:
        filtered = scipy.ndimage.gaussian_filter1d(rows, width, axis=0, truncate=TRUNCATE)
        return np.asarray(filtered[kept], dtype=np.float64)
    reach = int(TRUNCATE * width + 0.5)
    kernel = np.exp(-0.5 * np.square(np.arange(-reach, reach + 1) / width))
    kernel /= kernel.sum()
    found = [kernel @ rows[row - reach : row + reach + 1] for row in range(*kept.indices(len(rows)))]
    return np.array(found).reshape(-1, rows.shape[1])
