"""A raw log's displacement and voltages on one uniform grid.

The segments of the log's survey are one stream of values there, with lines between them.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..numerics.arrays import FloatArray, IntArray
from .columns import CHUNK, ROUNDING, Stream
from .resampling import LEAST_RATIO, REACH, decimated, interpolated, uniform_grid
from .survey import Segments, Survey
from .timebase import LOCATED, default_gap_limit

Method = Literal["decimated", "interpolated"]


@dataclass(frozen=True)
class RecordReport:
    """Report on the making of a uniform record; times in s.

    Attributes
    ----------
    raw_rows, rows, masked_rows : int
        Rows of the log, rows of the record, and those of them that are masked (segment −1).
    raw_step, interval, gap_limit : float
        Nominal step of the log, step of the record, longest hole that is no gap.
    method : {"decimated", "interpolated"}
        Low-pass and decimated, or passed through (the log is about as coarse as the record).
    time_not_finite, repeated, backward : int
        Rows left out for their time stamp: NaN or infinite; equal to the one before; not later than an
        earlier one.
    q_not_finite, v_not_finite : int
        Samples left out because they are NaN or infinite (the second: voltages and a measured velocity together).
    gaps : int
        Holes longer than `gap_limit`, and places where time stepped back.
    gaps_at : tuple of (float, float)
        Last time before and first time after a gap, the first `LOCATED` ones.
    segments : int
        Gap-free segments of the record.
    """

    raw_rows: int
    rows: int
    masked_rows: int
    raw_step: float
    interval: float
    gap_limit: float
    method: Method
    time_not_finite: int
    repeated: int
    backward: int
    q_not_finite: int
    v_not_finite: int
    gaps: int
    gaps_at: tuple[tuple[float, float], ...]
    segments: int


@dataclass(frozen=True)
class UniformRecord:
    """A uniform record.

    Attributes
    ----------
    t : FloatArray, shape (M,)
        Time [s] of the log's own clock, from its first valid stamp on.
    q : FloatArray, shape (M,)
        Displacement [m or rad]; NaN where `segment` is −1.
    v : FloatArray, shape (M, k)
        Voltages [V], and behind them a measured velocity; straight lines across gaps (`inputs_unknown`).
    segment : NDArray[int32], shape (M,)
        Number of the gap-free segment, −1 where the kernel would reach across a gap.
    report : RecordReport
    """

    t: FloatArray
    q: FloatArray
    v: FloatArray
    segment: NDArray[np.int32]
    report: RecordReport


class Resampling:
    """A surveyed log on a uniform grid, piece by piece.

    Parameters
    ----------
    log : Survey
        The log.
    interval : float
        Step of the record [s].
    """

    def __init__(self, log: Survey, interval: float) -> None:
        self._log = log
        self._grid = uniform_grid(*log.span, interval)
        reach = max(REACH if _method(group.step, interval) == "decimated" else 0.5 for group in log.groups)
        self._valid = _valid_runs(self._grid, log.holes, reach * interval)
        missing = [count for group in log.groups for count in group.not_finite]
        self.report = RecordReport(
            raw_rows=log.rows.keep.size,
            rows=self._grid.size,
            masked_rows=self._grid.size - int(np.diff(self._valid).sum()),
            raw_step=log.rows.step,
            interval=interval,
            gap_limit=default_gap_limit(log.rows.step),
            method=_method(log.rows.step, interval),
            time_not_finite=log.rows.not_finite,
            repeated=log.rows.repeated,
            backward=log.rows.backward,
            q_not_finite=missing[0],
            v_not_finite=sum(missing[1:]),
            gaps=len(log.holes),
            gaps_at=tuple((float(a), float(b)) for a, b in log.holes[:LOCATED]),
            segments=len(self._valid),
        )

    def pieces(self) -> Iterator[UniformRecord]:
        """The record in pieces of some 10⁵ rows, each with the report of the whole; equal however the log was read.

        Notes
        -----
        Cost: one pass over the log, that of `decimated`, O(4 N (k + 1)); memory for some pieces.
        """
        streams = [Stream(resampled(group, self._grid, self.report.interval)) for group in self._log.groups]
        for first in range(0, self._grid.size, CHUNK):
            last = min(first + CHUNK, self._grid.size)
            values = np.concatenate([stream.read(last - first) for stream in streams])
            edges = np.searchsorted(self._valid.ravel(), np.arange(first, last), side="right")
            segment = np.where(edges % 2, edges // 2, -1).astype(np.int32)
            yield UniformRecord(
                t=self._grid[first:last],
                q=np.where(segment < 0, np.nan, values[0]),
                v=np.ascontiguousarray(values[1:].T),
                segment=segment,
                report=self.report,
            )

    def record(self) -> UniformRecord:
        """The whole record, in memory."""
        pieces = list(self.pieces())
        return UniformRecord(
            t=np.concatenate([piece.t for piece in pieces]),
            q=np.concatenate([piece.q for piece in pieces]),
            v=np.concatenate([piece.v for piece in pieces]),
            segment=np.concatenate([piece.segment for piece in pieces]),
            report=self.report,
        )


def _method(step: float, interval: float) -> Method:
    """Method for a log of that nominal step: decimated or interpolated; a thousandth is left to rounding."""
    return "decimated" if interval >= (LEAST_RATIO - 1e-3) * step else "interpolated"


def _valid_runs(grid: FloatArray, holes: FloatArray, reach: float) -> IntArray:
    """First and end index of each run of grid points out of reach of every hole, shape (S, 2)."""
    masked = np.stack(
        (np.searchsorted(grid, holes[:, 0] - reach, side="right"), np.searchsorted(grid, holes[:, 1] + reach)), axis=1
    )
    masked = masked[masked[:, 0] < masked[:, 1]]
    ends = np.concatenate(([0], np.maximum.accumulate(masked[:, 1])))  # holes are in order of their beginnings
    starts = np.concatenate((masked[:, 0], [grid.size]))
    open_ = starts > ends
    return np.stack((ends[open_], starts[open_]), axis=1)


def resampled(group: Segments, grid: FloatArray, interval: float) -> Iterator[FloatArray]:
    """Values of a group of columns at all points of a grid, shape (k, m), piece after piece.

    Parameters
    ----------
    group : Segments
        Columns with k members.
    grid : FloatArray, shape (M,)
        Uniform times [s] inside the group's time span.
    interval : float
        Their step [s].
    """
    position = 0
    for (low, high), (first, last, end) in _shares_of_grid(group, grid, interval):
        yield from _bridged(group, grid[position:first])
        wanted = end - first
        for piece in _segment(group, slice(low, high), grid[first:last], interval):
            yield piece[:, :wanted]
            wanted -= min(wanted, piece.shape[1])
        position = end
    yield from _bridged(group, grid[position:])


def _shares_of_grid(group: Segments, grid: FloatArray, interval: float) -> Iterator[tuple[IntArray, IntArray]]:
    """Rows of each segment that holds grid points; its first and end point, and the end of those it gives values to."""
    first = np.searchsorted(grid, group.edges[:, 0] - ROUNDING * interval)
    last = np.searchsorted(grid, group.edges[:, 1] + ROUNDING * interval, side="right")
    holds = np.flatnonzero(first < last)
    first = first[holds]
    last = last[holds]
    # Where two segments nearly touch, a point at the edge of both is the later one's.
    end = np.minimum(last, np.append(first[1:], grid.size))
    return zip(group.bounds[holds], np.stack((first, last, end), axis=1), strict=True)


def _segment(group: Segments, rows: slice, points: FloatArray, interval: float) -> Iterator[FloatArray]:
    """Values of one gap-free segment at its grid points."""
    time = group.time[rows]
    columns = [samples[rows] for samples in group.columns]
    if _method(group.step, interval) == "decimated":
        yield from decimated(time, columns, points, interval)
        return
    streams = [
        interpolated(time, samples, points, smooth=smooth)
        for samples, smooth in zip(columns, group.smooth, strict=True)
    ]
    yield from (np.stack(pieces) for pieces in zip(*streams, strict=True))


def _bridged(group: Segments, gap: FloatArray) -> Iterator[FloatArray]:
    """Straight lines from sample to sample at the points between two segments."""
    for first in range(0, gap.size, CHUNK):
        points = gap[first : first + CHUNK]
        low, high = np.searchsorted(group.time, points[[0, -1]])
        rows = slice(max(low - 1, 0), high + 1)
        yield np.stack([np.interp(points, group.time[rows], samples[rows]) for samples in group.columns])
