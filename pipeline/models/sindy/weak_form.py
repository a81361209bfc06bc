"""SINDy's regression in weak form: pysindy's feature library, integrated against test functions over each segment.

Both sides of q̈ = Σ c_p θ_p(x) are multiplied by a test function φ = (1 − s²)⁴ of half width H and integrated;
integration by parts leaves −∫ φ' q̇ dt on the left, so no second derivative of the measurement enters (Messenger &
Bortz 2021, doi:10.1137/20M1343166). Segments differ in length, which pysindy's weak library does not take in one fit
(dynamicslab/pysindy issue 187). Every segment has a library of its own, so no test function straddles a gap. pysindy
draws the places of test functions from NumPy's global state (its issue 485), which is seeded here and put back.

A `Problem` holds the rows for every candidate term and every held-out block.
"""

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
import pysindy
from scipy.interpolate import CubicHermiteSpline

from ...device.device import Device
from ...errors import InputError
from ...numerics.arrays import FloatArray, IntArray
from ...numerics.fixed_step import escape_bounds
from ...numerics.metrics import rms
from ...scoring.cross_validation import HeldOutBlock, held_out_blocks
from ...signals.log import Log, operating_range
from ..polynomial_dynamics import (
    COSINE,
    FIRST_INPUT,
    FRICTION,
    QDOT,
    SINE,
    Lag,
    PolynomialDynamics,
    Q,
    scaled_variables,
)

HIGHEST = 7
COUPLED = 4
"""Highest power of q alone, and of q as a factor of velocities, inputs and lags."""
LAG_SETS = ((), (1.0, 8.0), (2.0, 16.0), (1 / 3, 2.0, 8.0))
"""Lag times to try, over the time scale of the motion (RMS q̇ over RMS q̈: 60 ms for the joint)."""
TEST_FUNCTIONS = 500
"""In all training data together. They bound the cost, and cover the paper's log one and a half times."""
LEAST_SAMPLES = 2
"""Sample intervals in half a test function."""
STEPS = 30
MOST_ROWS = 60_000
"""Steps of the grid in half a test function, unless voltages are known more finely, and its most rows."""
SLOW = 0.05
"""Speed w of the smoothed friction tanh(q̇/w), over the largest speed."""
_SHORTEST_LAG = 0.25
"""Shortest lag as a share of a sample interval."""


@contextmanager
def seeded() -> Iterator[None]:
    """Pysindy's random draws from one seed, and its warnings, which free runs judge, out of the user's sight."""
    state = np.random.get_state()  # noqa: NPY002
    np.random.seed(0)  # noqa: NPY002
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        np.random.set_state(state)  # noqa: NPY002


def feature_library(variables: int, angle: bool) -> Any:
    """Pysindy's library of the powers of q, and of q (for an `angle` also sin q, cos q) times every other variable."""
    libraries = [pysindy.PolynomialLibrary(HIGHEST), pysindy.PolynomialLibrary(COUPLED), pysindy.IdentityLibrary()]
    libraries += [pysindy.PolynomialLibrary(1)] * angle
    inputs = [[Q], [Q], [k for k in range(variables) if k not in (Q, SINE, COSINE)], *[[SINE, COSINE]] * angle]
    tensors = [[0, 1, 1, 0], [0, 0, 1, 1]] if angle else [[0, 1, 1]]
    return pysindy.GeneralizedLibrary(libraries, tensors, inputs, exclude_libraries=[1, 2])


def exponents_of(names: list[str], variables: int) -> IntArray:
    """Powers of the variables in features that pysindy calls ``x0^2 x5``, shape (P, variables)."""
    table = np.zeros((len(names), variables), dtype=np.int64)
    for row, name in zip(table, names, strict=True):
        for factor in name.split():
            if factor != "1":
                variable, _, power = factor[1:].partition("^")
                row[int(variable)] += int(power or 1)
    return table


def weak_rows(
    x: FloatArray, qdot: FloatArray, interval: float, half_width: float, count: int, angle: bool
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Rows of the regression from one gap-free segment.

    Parameters
    ----------
    x : FloatArray, shape (N, V)
        Scaled variables along it.
    qdot : FloatArray, shape (N,)
        Velocity [m/s].
    interval : float
        Its sample interval [s].
    half_width : float
        H [s], less than half of the segment.
    count : int
        Test functions.
    angle : bool
        True if sin q and cos q are candidates.

    Returns
    -------
    exponents : IntArray, shape (P, V)
        The candidate terms.
    rows : FloatArray, shape (count, P)
        ∫ φ θ_p dt.
    target : FloatArray, shape (count,)
        −∫ φ' q̇ dt. Cost: about 2 ms a test function, nearly all of it in setting up pysindy's library.
    """
    features = feature_library(x.shape[1], angle)
    with seeded():
        terms = np.asarray(features.fit_transform(x))
        exponents = exponents_of(features.get_feature_names([f"x{k}" for k in range(x.shape[1])]), x.shape[1])
        first = np.sort(np.unique(exponents, axis=0, return_index=True)[1])  # the libraries share some terms
        weak = pysindy.WeakPDELibrary(
            pysindy.IdentityLibrary(), spatiotemporal_grid=interval * np.arange(len(x)), K=count, H_xt=half_width, p=4
        )
        rows = np.asarray(weak.fit_transform(terms[:, first]))
        return exponents[first], rows, np.asarray(weak.convert_u_dot_integral(qdot[:, None]))[:, 0]


@dataclass(frozen=True)
class Library:
    """Terms that may enter the equation of the acceleration.

    Attributes
    ----------
    degrees : (int, int, int)
        Highest power of q alone, as a factor of velocities and lags, and as a factor of inputs.
    turning : bool
        True if 1, sin q and cos q stand in the place of the powers of q (an angle).
    friction : bool
        A smoothed dry friction tanh(q̇/w).
    lags : tuple of float
        Times [s] of first-order lags of the velocity.
    lagged_inputs : bool
        True if the inputs enter lagged, too.
    """

    degrees: tuple[int, int, int]
    turning: bool
    friction: bool
    lags: tuple[float, ...]
    lagged_inputs: bool

    def __str__(self) -> str:
        """E.g. ``poly7(q) + poly3(q)·(q̇, z[0.06 s]) + poly4(q)·u + tanh q̇``."""
        z = "".join(f", z[{lag:.2g} s]" for lag in self.lags)
        u = "".join(f", u[{lag:.2g} s]" for lag in self.lags if self.lagged_inputs)
        alone, moving, driven = (f"poly{degree}(q)" for degree in self.degrees)
        if self.turning:
            alone, moving, driven = ("(1, sin q, cos q)" if degree else "1" for degree in self.degrees)
        return f"{alone} + {moving}·(q̇{z}{u}) + {driven}·u{' + tanh q̇' * self.friction}"


@dataclass(frozen=True)
class Problem:
    """The training data as rows of the weak form, of every candidate term and every held-out block.

    Attributes
    ----------
    trajectories : sequence of Log
        Gap-free segments.
    blocks : sequence of HeldOutBlock
        Their parts; `rows` and `targets` have an entry for each, of shapes (K, P) and (K,).
    exponents : IntArray, shape (P, V)
        The candidate terms.
    empty : PolynomialDynamics
        Scales, all lags and bounds, without terms.
    span : float
        Range of q [m or rad].
    time_scale : float
        RMS q̇ over RMS q̈ [s].
    half_width : float
        H of the test functions [s].
    """

    trajectories: Sequence[Log]
    blocks: Sequence[HeldOutBlock]
    rows: Sequence[FloatArray]
    targets: Sequence[FloatArray]
    exponents: IntArray
    empty: PolynomialDynamics
    span: float
    time_scale: float
    half_width: float

    def columns(self, library: Library) -> IntArray:
        """Places of the library's terms."""
        last = self.empty.scales.size
        lags = {
            last + k
            for k, lag in enumerate(self.empty.lags)
            if lag.time in library.lags and (lag.source == QDOT or library.lagged_inputs)
        }
        alone, moving, driven = library.degrees
        chosen = []
        for place, row in enumerate(self.exponents):
            circle = int(row[SINE] + row[COSINE])
            if (row[Q] if library.turning else circle) or (not library.turning and row[FRICTION] and row[Q]):
                continue
            others = [k for k in np.flatnonzero(row) if k not in (Q, SINE, COSINE)]
            limit = alone
            if others:
                (other,) = others
                if (other == FRICTION and not library.friction) or (other >= last and other not in lags):
                    continue
                limit = driven if FIRST_INPUT <= other < last else moving
            if (circle if library.turning else row[Q]) <= limit:
                chosen.append(place)
        return np.array(chosen, dtype=np.int64)

    def without(self, fold: int | None) -> tuple[FloatArray, FloatArray]:
        """The regression on all blocks but those of a fold."""
        used = [i for i, block in enumerate(self.blocks) if block.fold != fold]
        return np.concatenate([self.rows[i] for i in used]), np.concatenate([self.targets[i] for i in used])


def prepare_problem(trajectories: Sequence[Log], plant: Device) -> Problem:
    """Every candidate term in weak form.

    Raises
    ------
    InputError
        No data, differing inputs, a constant displacement, or segments that are too short.
    """
    low, high = operating_range(trajectories)
    if len({x.v.shape[-1] for x in trajectories}) != 1:
        raise InputError("the training logs differ in their number of inputs; identify them apart")
    speed = max(float(np.abs(x.qdot).max()) for x in trajectories) or 1.0
    volts = np.max([np.abs(x.drive).reshape(-1, x.v.shape[-1]).max(axis=0) for x in trajectories], axis=0)
    scales = np.array([max(abs(low), abs(high)), speed, SLOW * speed, 1.0, 1.0, *plant.acting(volts)])
    scales[scales == 0.0] = 1.0  # an input that is never used: its columns are zero whatever the scale
    acceleration = rms(np.concatenate([x.qddot for x in trajectories]))
    interval = max(x.interval for x in trajectories)
    time_scale = rms(np.concatenate([x.qdot for x in trajectories])) / acceleration if acceleration else interval
    followed = (QDOT, *range(FIRST_INPUT, scales.size))
    times = [time_scale * ratio for ratio in sorted({ratio for ratios in LAG_SETS for ratio in ratios})]
    lags = tuple(Lag(source, time) for time in times if time >= _SHORTEST_LAG * interval for source in followed)
    empty = PolynomialDynamics(
        np.zeros((0, scales.size + len(lags)), dtype=np.int64),
        np.zeros((2, 0)),
        scales,
        lags,
        plant.squared,
        *escape_bounds(low, high),
    )
    blocks = held_out_blocks(trajectories)
    half_width = _half_width(trajectories, blocks, time_scale)
    angle = plant.displacement.symbol == "rad"
    weak = [(block, *_weak_block(trajectories, block, empty, half_width, angle)) for block in blocks]
    used, exponents, rows, targets = zip(*(each for each in weak if len(each[1])), strict=True)
    return Problem(
        trajectories=trajectories,
        blocks=used,
        rows=rows,
        targets=targets,
        exponents=exponents[0],
        empty=empty,
        span=high - low,
        time_scale=time_scale,
        half_width=half_width,
    )


def _half_width(trajectories: Sequence[Log], blocks: Sequence[HeldOutBlock], time_scale: float) -> float:
    """Half width [s] of the test functions: the time scale of the motion, some samples, no more than a block holds.

    Raises
    ------
    InputError
        No block is that long.
    """
    length, interval = max(
        ((b.stop - b.start - 1) * trajectories[b.source].interval, trajectories[b.source].interval) for b in blocks
    )
    if length < 4.0 * LEAST_SAMPLES * interval:
        raise InputError("the training segments are too short for SINDy; give longer logs")
    return min(max(time_scale, LEAST_SAMPLES * interval), length / 4.0)


def _weak_block(
    trajectories: Sequence[Log], block: HeldOutBlock, empty: PolynomialDynamics, half_width: float, angle: bool
) -> tuple[IntArray, FloatArray, FloatArray]:
    """The block's rows on a grid at least as fine as its voltages; no terms where it is shorter than a test function.

    Between samples q and q̇ are cubic polynomials through the samples and their derivatives, voltages are linear.
    """
    samples = sum(len(x.t) for x in trajectories)
    x = trajectories[block.source].part(block.start, block.stop)
    if (len(x.t) - 1) * x.interval < 2.5 * half_width:
        return np.zeros((0, 0), dtype=np.int64), np.zeros((0, 0)), np.zeros(0)
    per_sample = x.drive.shape[1] if x.fine is not None else 1
    refined = max(1, min(max(per_sample, int(np.ceil(STEPS * x.interval / half_width))), MOST_ROWS // samples))
    places = np.arange((len(x.t) - 1) * refined + 1) / refined
    times = np.arange(len(x.t))
    voltages = x.drive.reshape(-1, x.v.shape[-1])
    v = np.column_stack([np.interp(places, np.arange(len(voltages)) / per_sample, column) for column in voltages.T])
    q = CubicHermiteSpline(times, x.q, x.interval * x.qdot)(places)
    qdot = CubicHermiteSpline(times, x.qdot, x.interval * x.qddot)(places)
    step = x.interval / refined
    count = max(1, round(TEST_FUNCTIONS * len(x.t) / samples))
    return weak_rows(scaled_variables(empty, v, q, qdot, step), qdot, step, half_width, count, angle)
