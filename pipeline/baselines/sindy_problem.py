"""The sparse regression of the acceleration as compressed blocks of time, shared by all its candidates."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import scipy.ndimage

from pipeline.baselines.polynomial_dynamics import lag_state, monomials, scaled_variables
from pipeline.baselines.sindy_library import Library
from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.least_squares import triangular_factor
from pipeline.scoring.cross_validation import HeldOutBlock, held_out_blocks
from pipeline.signals.trajectory import Trajectory, operating_range
from pipeline.solvers.lagged_free_run import escape_bounds

TRUNCATE = 4.0  # half length of the filter in standard deviations
SUBBLOCKS = 8  # blocks per window for the ensemble's resampling, about 1 s each in a 37.5 s log


@dataclass(frozen=True)
class Factors:
    """Per window the triangular factors of its sub-blocks, and the RMS [m/s²] that their last columns are scaled by."""

    windows: list[list[FloatArray]]
    scale: float


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
    acceleration = float(np.sqrt(np.mean(np.concatenate([x.qddot for x in trajectories]) ** 2)))
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
            rows = np.column_stack([monomials(exponents, scaled[wide]), x.qddot[wide]])
            rows = _filtered(rows, filter_time / x.interval)[kept]
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


def _filtered(rows: FloatArray, width: float) -> FloatArray:
    """Gaussian filter of `width` samples along time; nothing below one sample."""
    if width < 1.0 or not len(rows):
        return rows
    return np.asarray(scipy.ndimage.gaussian_filter1d(rows, width, axis=0, truncate=TRUNCATE), dtype=np.float64)
