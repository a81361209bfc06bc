"""The usable part of a log: advancing rows, finite samples, gap-free stretches; what is left out is counted."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import FloatArray, IntArray, Samples
from pipeline.signals.columns import Rows, chunks, select, take
from pipeline.signals.timebase import advancing, default_gap_limit, nominal_step, segments

TimeReversal = Literal["refuse", "split"]


@dataclass(frozen=True)
class TimeRows:
    """The rows of a log whose stamps advance.

    Attributes
    ----------
    time : Samples, N of them
        All stamps [s].
    keep : Rows
        Rows with a finite stamp later than all before.
    turns : FloatArray
        Stamps [s] after which time stepped back.
    step : float
        Nominal step [s] of the rows kept.
    not_finite, repeated, backward : int
        Rows left out, by reason.
    """

    time: Samples
    keep: Rows
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
    time : Samples, N of them
        Strictly increasing stamps [s].
    columns : tuple of Samples, N each
        Finite samples.
    smooth : tuple of bool
        For each column, whether it is a displacement: how it is interpolated where it is not decimated.
    bounds : IntArray, shape (S, 2)
        First index and end index of each stretch.
    edges : FloatArray, shape (S, 2)
        First and last stamp [s] of each stretch.
    step : float
        Nominal step [s].
    not_finite : tuple of int
        For each column, the number of samples of the log that are NaN or infinite.
    """

    time: Samples
    columns: tuple[Samples, ...]
    smooth: tuple[bool, ...]
    bounds: IntArray
    edges: FloatArray
    step: float
    not_finite: tuple[int, ...]

    @property
    def gaps(self) -> FloatArray:
        """Last time before and first time after each gap, shape (G, 2)."""
        return np.stack((self.edges[:-1, 1], self.edges[1:, 0]), axis=1)


def advancing_rows(time: Samples, time_reversal: TimeReversal) -> TimeRows:
    """Find the rows whose stamps advance.

    Raises
    ------
    DataRefusedError
        Time steps back and the policy is "refuse", or time never advances.

    Notes
    -----
    Cost: one pass; the memory is that of a chunk and one bit a row.
    """
    flags, turns = [], []
    finite = repeated = kept = 0
    last, reached = np.nan, -np.inf  # the last finite stamp, and the latest
    for rows in chunks(time.size):
        part = time[rows]
        flags.append(advancing(part, reached))
        stamps = part[np.isfinite(part)]
        if stamps.size:
            steps = np.diff(stamps, prepend=last)
            turns.append(np.concatenate(([last], stamps[:-1]))[steps < 0.0])
            behind = stamps < np.maximum.accumulate(np.concatenate(([reached], stamps)))[:-1]
            repeated += int(np.count_nonzero((steps == 0.0) & ~behind))
            last, reached = float(stamps[-1]), max(reached, float(stamps.max()))
        finite += stamps.size
        kept += int(np.count_nonzero(flags[-1]))
    back = np.concatenate([np.empty(0), *turns])
    if back.size and time_reversal == "refuse":
        raise DataRefusedError(
            f"time steps back at {back.size} place(s), first after {back[0]:.6g} s; "
            'repair the log or set [ingest] time_reversal = "split"'
        )
    keep = Rows(flags)
    step = nominal_step(select(time, keep))
    return TimeRows(time, keep, back, step, time.size - finite, repeated, finite - kept - repeated)


def finite_stretches(
    rows: TimeRows,
    columns: Sequence[Samples],
    smooth: Sequence[bool],
    gap_limit: float | None,
    names: Sequence[str],
) -> list[Stretches]:
    """Split columns into gap-free stretches; neighbouring columns with the same valid rows share one result.

    Parameters
    ----------
    rows : TimeRows
        The columns' time base.
    columns : sequence of Samples, N each
        Samples; those that are not finite are left out.
    smooth : sequence of bool
        As `Stretches.smooth`.
    gap_limit : float or None
        Longest hole [s] that is no gap; None: by the nominal step.
    names : sequence of str
        Names of the columns, for the error.

    Raises
    ------
    DataRefusedError
        A column holds no finite sample.

    Notes
    -----
    Cost: one pass over the columns and one over the stamps; one bit a row and column.
    """
    limit = default_gap_limit(rows.step) if gap_limit is None else gap_limit
    shared: list[tuple[Rows, list[int]]] = []
    not_finite = []
    for j, column in enumerate(columns):
        valid, missing = _valid(rows, column)
        not_finite.append(missing)
        if shared and shared[-1][0].same(valid):
            shared[-1][1].append(j)
        else:
            shared.append((valid, [j]))
    found = []
    for valid, members in shared:
        if not valid.count:
            raise DataRefusedError(f"{names[members[0]]} holds no finite sample at all: no sensor, or another channel")
        stamps = select(rows.time, valid)
        bounds = _cut(segments(stamps, limit), stamps, rows.turns)
        edges = np.stack((take(stamps, bounds[:, 0]), take(stamps, bounds[:, 1] - 1)), axis=1)
        picked = tuple(select(columns[j], valid) for j in members)
        kinds, missed = tuple(smooth[j] for j in members), tuple(not_finite[j] for j in members)
        found.append(Stretches(stamps, picked, kinds, bounds, edges, rows.step, missed))
    return found


def _valid(rows: TimeRows, column: Samples) -> tuple[Rows, int]:
    """The rows with an advancing stamp and a finite sample; the number of samples that are not finite."""
    flags, missing = [], 0
    for chunk, span in enumerate(chunks(column.size)):
        finite = np.isfinite(column[span])
        missing += finite.size - int(np.count_nonzero(finite))
        flags.append(finite & rows.keep.flags(chunk))
    return Rows(flags), missing


def _cut(bounds: IntArray, stamps: Samples, turns: FloatArray) -> IntArray:
    """Stretches also end where time stepped back, however small the hole is that this leaves."""
    if turns.size == 0:
        return bounds
    before = np.zeros(turns.size, dtype=np.int64)
    for rows in chunks(stamps.size):
        before += np.searchsorted(stamps[rows], turns, side="right")
    edges = np.unique(np.concatenate((bounds.ravel(), before)))
    return np.stack((edges[:-1], edges[1:]), axis=1)
