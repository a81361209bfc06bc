"""The usable part of a log: advancing rows, finite samples, gap-free segments, and these on a uniform grid.

Rows that are left out are counted. On the grid the segments are one stream of values, with lines between them.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import CHUNK, ROUNDING, chunks, column, select
from .resampling import decimated, interpolated
from .timebase import advancing, default_gap_limit, nominal_step, segments

TimeReversal = Literal["refuse", "split", "unwrap"]
NO_CUTS: FloatArray = np.empty(0)


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
    ends : FloatArray
        These, and the stamps [s] after which rows are missing though time goes on: a segment ends there.
    step : float
        Nominal step [s] of the rows kept.
    not_finite, repeated, backward : int
        Rows left out, by reason.
    """

    time: FloatArray
    keep: BoolArray
    turns: FloatArray
    ends: FloatArray
    step: float
    not_finite: int
    repeated: int
    backward: int


@dataclass(frozen=True)
class Segments:
    """Finite samples of some columns on one advancing time base, and its gap-free segments.

    Attributes
    ----------
    time : FloatArray, shape (N,)
        Strictly increasing stamps [s].
    columns : tuple of FloatArray, shape (N,) each
        Finite samples.
    smooth : tuple of bool
        For each column, whether it is a displacement: how it is interpolated where it is not decimated.
    bounds : IntArray, shape (S, 2)
        First index and end index of each segment.
    edges : FloatArray, shape (S, 2)
        First and last stamp [s] of each segment.
    step : float
        Nominal step [s].
    not_finite : tuple of int
        For each column, the number of samples of the log that are NaN or infinite.
    """

    time: FloatArray
    columns: tuple[FloatArray, ...]
    smooth: tuple[bool, ...]
    bounds: IntArray
    edges: FloatArray
    step: float
    not_finite: tuple[int, ...]

    @property
    def gaps(self) -> FloatArray:
        """Last time before and first time after each gap, shape (G, 2)."""
        return np.stack((self.edges[:-1, 1], self.edges[1:, 0]), axis=1)


def advancing_rows(time: FloatArray, time_reversal: TimeReversal, cuts: FloatArray = NO_CUTS) -> TimeRows:
    """Find the rows whose stamps advance; behind `cuts` [s] rows are missing though they do.

    Raises
    ------
    DataRefusedError
        Time steps back and the policy is "refuse", or time never advances.

    Notes
    -----
    Cost: one pass in chunks.
    """
    turns: list[FloatArray] = []
    usable = repeated = 0

    def flags() -> Iterator[BoolArray]:
        """Masks of the rows that advance in time, chunk by chunk; counts those left out."""
        nonlocal usable, repeated
        last, reached = np.nan, -np.inf  # the last finite stamp, and the latest
        for rows in chunks(time.size):
            part = time[rows]
            yield advancing(part, reached)
            stamps = part[np.isfinite(part)]
            if stamps.size:
                steps = np.diff(stamps, prepend=last)
                turns.append(np.concatenate(([last], stamps[:-1]))[steps < 0.0])
                behind = stamps < np.maximum.accumulate(np.concatenate(([reached], stamps)))[:-1]
                repeated += int(np.count_nonzero((steps == 0.0) & ~behind))
                last = float(stamps[-1])
                reached = max(reached, float(stamps.max()))
            usable += stamps.size

    keep = column(time.size, flags(), np.bool_)
    back = np.concatenate([np.empty(0), *turns])
    advanced = select(time, keep)
    backward = usable - advanced.size - repeated
    if back.size and time_reversal == "refuse":
        raise DataRefusedError(
            f"time steps back at {back.size} place(s), first after {back[0]:.6g} s; repair the log or set [ingest] "
            f'time_reversal = "split", which leaves out {backward} of {time.size} rows, or "unwrap" for a counter that '
            "begins anew"
        )
    return TimeRows(
        time=time,
        keep=keep,
        turns=back,
        ends=np.concatenate((back, cuts)),
        step=nominal_step(advanced),
        not_finite=time.size - usable,
        repeated=repeated,
        backward=backward,
    )


def finite_segments(
    rows: TimeRows, columns: Sequence[FloatArray], smooth: Sequence[bool], names: Sequence[str]
) -> list[Segments]:
    """Split columns into gap-free segments; neighbouring columns with the same valid rows share one result.

    Parameters
    ----------
    rows : TimeRows
        The columns' time base.
    columns : sequence of FloatArray, shape (N,) each
        Samples; those that are not finite are left out.
    smooth : sequence of bool
        As `Segments.smooth`.
    names : sequence of str
        Names of the columns, for the error.

    Raises
    ------
    DataRefusedError
        A column holds no finite sample.

    Notes
    -----
    Cost: one pass over the columns and one over the stamps, in chunks; where rows are left out, copies on disk.
    """
    shared: list[tuple[BoolArray, list[int]]] = []
    not_finite = []
    for j, samples in enumerate(columns):
        not_finite.append(sum(int(np.count_nonzero(~np.isfinite(samples[part]))) for part in chunks(samples.size)))
        valid = rows.keep if not not_finite[-1] else _both(samples, rows.keep)
        if shared and (shared[-1][0] is valid or np.array_equal(shared[-1][0], valid)):
            shared[-1][1].append(j)
        else:
            shared.append((valid, [j]))
    groups = []
    for valid, members in shared:
        if not valid.any():
            raise DataRefusedError(f"{names[members[0]]} holds no finite sample at all: no sensor, or another channel")
        stamps = select(rows.time, valid)
        bounds = _cut(segments(stamps, default_gap_limit(rows.step)), stamps, rows.ends)
        edges = stamps[np.stack((bounds[:, 0], bounds[:, 1] - 1), axis=1)]
        groups.append(
            Segments(
                time=stamps,
                columns=tuple(select(columns[j], valid) for j in members),
                smooth=tuple(smooth[j] for j in members),
                bounds=bounds,
                edges=edges,
                step=rows.step,
                not_finite=tuple(not_finite[j] for j in members),
            )
        )
    return groups


def _both(samples: FloatArray, keep: BoolArray) -> BoolArray:
    """The rows kept that have a finite sample."""
    return column(samples.size, (np.isfinite(samples[rows]) & keep[rows] for rows in chunks(samples.size)), np.bool_)


def _cut(bounds: IntArray, stamps: FloatArray, ends: FloatArray) -> IntArray:
    """Segments also end where time stepped back or rows are missing, even if the hole is small."""
    edges = np.unique(np.concatenate((bounds.ravel(), np.searchsorted(stamps, ends, side="right"))))
    return np.stack((edges[:-1], edges[1:]), axis=1)


def resampled(group: Segments, grid: FloatArray, interval: float, *, decimate: bool) -> Iterator[FloatArray]:
    """Values of a group of columns at all points of a grid, shape (k, m), piece after piece.

    Parameters
    ----------
    group : Segments
        Columns with k members.
    grid : FloatArray, shape (M,)
        Uniform times [s] inside the group's time span.
    interval : float
        Their step [s].
    decimate : bool
        Low-pass and decimate, or interpolate.
    """
    position = 0
    for (low, high), (first, last, end) in _shares_of_grid(group, grid, interval):
        if position < first:
            yield from _bridged(group, grid[position:first])
        wanted = end - first
        for piece in _segment(group, slice(low, high), grid[first:last], interval, decimate):
            yield piece[:, :wanted]
            wanted -= min(wanted, piece.shape[1])
        position = end
    if position < grid.size:
        yield from _bridged(group, grid[position:])


def _shares_of_grid(group: Segments, grid: FloatArray, interval: float) -> Iterator[tuple[IntArray, IntArray]]:
    """Rows of each segment that holds grid points; its first and end point, and the end of those it gives values to."""
    first = np.searchsorted(grid, group.edges[:, 0] - ROUNDING * interval)
    last = np.searchsorted(grid, group.edges[:, 1] + ROUNDING * interval, side="right")
    holds = np.flatnonzero(first < last)
    first, last = first[holds], last[holds]
    # Where two segments nearly touch, a point at the edge of both is the later one's.
    end = np.minimum(last, np.append(first[1:], grid.size))
    return zip(group.bounds[holds], np.stack((first, last, end), axis=1), strict=True)


def _segment(group: Segments, rows: slice, points: FloatArray, interval: float, decimate: bool) -> Iterator[FloatArray]:
    """Values of one gap-free segment at its grid points."""
    time = group.time[rows]
    columns = [samples[rows] for samples in group.columns]
    if decimate:
        yield from decimated(time, columns, points, interval)
        return
    streams = [
        interpolated(time, samples, points, smooth=smooth)
        for samples, smooth in zip(columns, group.smooth, strict=True)
    ]
    for pieces in zip(*streams, strict=True):
        yield np.stack(pieces)


def _bridged(group: Segments, gap: FloatArray) -> Iterator[FloatArray]:
    """Straight lines from sample to sample at the points between two segments."""
    for first in range(0, gap.size, CHUNK):
        points = gap[first : first + CHUNK]
        low, high = np.searchsorted(group.time, points[[0, -1]])
        rows = slice(max(low - 1, 0), high + 1)
        yield np.stack([np.interp(points, group.time[rows], samples[rows]) for samples in group.columns])
