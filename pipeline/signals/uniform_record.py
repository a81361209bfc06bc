"""A raw log's displacement and voltages on one uniform grid; what was left out is counted and located."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..errors import DataRefusedError
from ..numerics.arrays import FloatArray, IntArray
from .columns import CHUNK, Stream
from .resampling import LEAST_RATIO, REACH, uniform_grid
from .segments import (
    NO_CUTS,
    Segments,
    TimeReversal,
    TimeRows,
    advancing_rows,
    finite_segments,
    resampled,
)
from .timebase import LOCATED, default_gap_limit

Method = Literal["decimated", "interpolated"]

_SMOOTH = ("q", "velocity")  # columns of something with inertia, which has no steps


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


@dataclass(frozen=True)
class Survey:
    """A log whose usable segments are known.

    Attributes
    ----------
    rows : TimeRows
        Of the displacement's time base.
    groups : tuple of Segments
        Displacement first, then the voltages; columns with the same time base and valid rows share one.
    holes : FloatArray, shape (G, 2)
        Last time before and first time after each gap [s].
    """

    rows: TimeRows
    groups: tuple[Segments, ...]
    holes: FloatArray

    @property
    def span(self) -> tuple[float, float]:
        """First and last time [s] that all signals have in common."""
        starts, ends = zip(*((group.edges[0, 0], group.edges[-1, 1]) for group in self.groups), strict=True)
        return float(max(starts)), float(min(ends))


def survey(
    q: tuple[FloatArray, FloatArray],
    beside: Mapping[str, tuple[FloatArray, FloatArray]],
    *,
    gaps: Literal["split", "refuse"] = "split",
    time_reversal: TimeReversal = "refuse",
    cuts: FloatArray = NO_CUTS,
) -> Survey:
    """Find the usable segments of a log.

    Rows with a stamp that is not finite or does not advance, and samples that are not finite, are left out and
    counted. A hole of a few lost samples (`default_gap_limit`) is passed over: its neighbours share its part of
    the time axis. A longer one is a gap. Nothing is sorted.

    Parameters
    ----------
    q : (FloatArray, FloatArray)
        Time stamps [s] and displacement [m or rad], N each, in the order of the log.
    beside : mapping of name to (FloatArray, FloatArray)
        Time stamps [s] and samples of the voltages [V] and of what else was measured; the same object where they share
        a time base.
    gaps : {"split", "refuse"}
        Number the segments, or refuse a log with gaps.
    time_reversal : {"refuse", "split", "unwrap"}
        Refuse a log whose time steps back; or leave out what does not advance and treat the place as a gap, as also
        where stamps that were unwrapped do.
    cuts : FloatArray
        Stamps [s] behind which rows are missing though time goes on: treated as gaps too.

    Raises
    ------
    DataRefusedError
        No two valid rows, no common time span, or what the policies refuse.

    Notes
    -----
    Cost: two passes over the stamps and one over every column, in chunks.
    """
    rows = [advancing_rows(q[0], time_reversal, cuts)]
    groups: list[Segments] = []
    together: list[FloatArray] = [q[1]]
    names = ["q"]
    for name, (time, column) in beside.items():
        if time is not rows[-1].time:
            groups += finite_segments(rows[-1], together, [name in _SMOOTH for name in names], names)
            rows.append(advancing_rows(time, time_reversal, cuts))
            together = []
            names = []
        together.append(column)
        names.append(name)
    groups += finite_segments(rows[-1], together, [name in _SMOOTH for name in names], names)
    holes = np.unique(np.concatenate([group.gaps for group in groups]), axis=0)
    if gaps == "refuse" and holes.size:
        raise DataRefusedError(
            f"{len(holes)} gap(s) longer than {default_gap_limit(rows[0].step) * 1e3:.4g} ms, the first from "
            f'{holes[0, 0]:.6g} s to {holes[0, 1]:.6g} s; set [ingest] gaps = "split" to use the segments between'
        )
    result = Survey(rows[0], tuple(groups), holes)
    if not result.span[1] > result.span[0]:
        raise DataRefusedError("displacement and voltages have no segment of time in common")
    return result


def inputs_unknown(log: Survey, longest: float) -> list[tuple[float, float]]:
    """Times [s] between which an input was not recorded for more than `longest` s: last before and first after."""
    holes = np.concatenate([np.empty((0, 2)), *(group.gaps for group in log.groups if not all(group.smooth))])
    spans: list[tuple[float, float]] = []
    for start, stop in holes[np.argsort(holes[:, 0])].tolist():
        if stop - start > longest and spans and start <= spans[-1][1]:
            spans[-1] = spans[-1][0], max(stop, spans[-1][1])
        elif stop - start > longest:
            spans.append((start, stop))
    return spans


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
        self._grid = grid = uniform_grid(*log.span, interval)
        reach = max(REACH if _method(group.step, interval) == "decimated" else 0.5 for group in log.groups)
        self._valid = _valid_runs(grid, log.holes, reach * interval)
        missing = [count for group in log.groups for count in group.not_finite]
        self.report = RecordReport(
            raw_rows=log.rows.keep.size,
            rows=grid.size,
            masked_rows=grid.size - int(np.diff(self._valid).sum()),
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
        interval = self.report.interval
        streams = [
            Stream(resampled(group, self._grid, interval, decimate=_method(group.step, interval) == "decimated"))
            for group in self._log.groups
        ]
        for first in range(0, self._grid.size, CHUNK):
            last = min(first + CHUNK, self._grid.size)
            values = np.concatenate([stream.read(last - first) for stream in streams])
            segment = _segment_numbers(self._valid, first, last)
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
    near = np.searchsorted(grid, holes[:, 0] - reach, side="right"), np.searchsorted(grid, holes[:, 1] + reach)
    masked = np.stack(near, axis=1)
    masked = masked[masked[:, 0] < masked[:, 1]]
    ends = np.concatenate(([0], np.maximum.accumulate(masked[:, 1])))  # holes are in order of their beginnings
    starts = np.concatenate((masked[:, 0], [grid.size]))
    open_ = starts > ends
    return np.stack((ends[open_], starts[open_]), axis=1)


def _segment_numbers(valid: IntArray, first: int, last: int) -> NDArray[np.int32]:
    """Number of the segment of the grid points `first` … `last` − 1, −1 where they are masked."""
    numbers = np.full(last - first, -1, dtype=np.int32)
    for number in np.flatnonzero((valid[:, 1] > first) & (valid[:, 0] < last)).tolist():
        start, end = valid[number].tolist()
        numbers[max(start - first, 0) : min(end, last) - first] = number
    return numbers
