"""The usable part of a log: advancing rows, finite samples, gap-free stretches; what is left out is counted."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray
from pipeline.numerics.sampling.timebase import advancing, default_gap_limit, nominal_step, segments

TimeReversal = Literal["refuse", "split"]


@dataclass(frozen=True)
class TimeRows:
    """The rows of a log whose stamps advance.

    Attributes
    ----------
    time : FloatArray, shape (N,)
        All stamps [s].
    keep : BoolArray, shape (N,)
        Rows with a finite stamp later than all before.
    turns : FloatArray
        Stamps [s] after which time stepped back.
    step : float
        Nominal step [s] of the rows kept.
    not_finite, repeated, backward : int
        Rows left out, by reason.
    """

    time: FloatArray
    keep: BoolArray
    turns: FloatArray
    step: float
    not_finite: int
    repeated: int
    backward: int


@dataclass(frozen=True)
class Stretches:
    """Finite samples of some columns on one advancing time base, and its gap-free stretches.

    Attributes
    ----------
    time : FloatArray, shape (N,)
        Strictly increasing stamps [s].
    columns : tuple of FloatArray, shape (N,) each
        Finite samples.
    smooth : tuple of bool
        For each column, whether it is a displacement: how it is interpolated where it is not decimated.
    bounds : IntArray, shape (S, 2)
        First index and end index of each stretch.
    step : float
        Nominal step [s].
    """

    time: FloatArray
    columns: tuple[FloatArray, ...]
    smooth: tuple[bool, ...]
    bounds: IntArray
    step: float

    @property
    def gaps(self) -> FloatArray:
        """Last time before and first time after each gap, shape (G, 2)."""
        return np.stack((self.time[self.bounds[:-1, 1] - 1], self.time[self.bounds[1:, 0]]), axis=1)


def advancing_rows(time: FloatArray, time_reversal: TimeReversal) -> TimeRows:
    """Find the rows whose stamps advance.

    Raises
    ------
    DataRefusedError
        Time steps back and the policy is "refuse", or time never advances.
    """
    keep = advancing(time)
    if keep.all():
        return TimeRows(time, keep, np.empty(0), nominal_step(time), 0, 0, 0)
    stamps = time[np.isfinite(time)]
    steps = np.diff(stamps)
    turns = stamps[:-1][steps < 0.0]
    if turns.size and time_reversal == "refuse":
        raise DataRefusedError(
            f"time steps back at {turns.size} place(s), first after {turns[0]:.6g} s; "
            'repair the log or set [ingest] time_reversal = "split"'
        )
    behind = stamps[1:] < np.maximum.accumulate(stamps)[:-1]
    repeated = int(np.count_nonzero((steps == 0.0) & ~behind))
    backward = int(stamps.size - np.count_nonzero(keep)) - repeated
    return TimeRows(time, keep, turns, nominal_step(time[keep]), int(time.size - stamps.size), repeated, backward)


def finite_stretches(
    rows: TimeRows, columns: Sequence[FloatArray], smooth: Sequence[bool], gap_limit: float | None
) -> list[Stretches]:
    """Split columns into gap-free stretches; neighbouring columns with the same valid rows share one result.

    Parameters
    ----------
    rows : TimeRows
        The columns' time base.
    columns : sequence of FloatArray, shape (N,) each
        Samples; those that are not finite are left out.
    smooth : sequence of bool
        As `Stretches.smooth`.
    gap_limit : float or None
        Longest hole [s] that is no gap; None: by the nominal step.

    Raises
    ------
    DataRefusedError
        A column holds no finite sample.
    """
    limit = default_gap_limit(rows.step) if gap_limit is None else gap_limit
    shared: list[tuple[BoolArray, list[int]]] = []
    for j, column in enumerate(columns):
        valid = rows.keep & np.isfinite(column)
        if shared and np.array_equal(shared[-1][0], valid):
            shared[-1][1].append(j)
        else:
            shared.append((valid, [j]))
    found = []
    for valid, members in shared:
        if not valid.any():
            raise DataRefusedError("a signal holds no finite sample at all")
        whole = bool(valid.all())
        stamps = rows.time if whole else rows.time[valid]
        picked = tuple(columns[j] if whole else columns[j][valid] for j in members)
        bounds = _cut(segments(stamps, limit), stamps, rows.turns)
        found.append(Stretches(stamps, picked, tuple(smooth[j] for j in members), bounds, rows.step))
    return found


def _cut(bounds: IntArray, stamps: FloatArray, turns: FloatArray) -> IntArray:
    """Stretches also end where time stepped back, however small the hole is that this leaves."""
    if turns.size == 0:
        return bounds
    edges = np.unique(np.concatenate((bounds.ravel(), np.searchsorted(stamps, turns, side="right"))))
    return np.stack((edges[:-1], edges[1:]), axis=1)
