"""A raw log's displacement and voltages on one uniform grid; what was left out is counted and located.

The usable part of a log are its advancing rows with finite samples, in gap-free segments. On the grid the segments are
one stream of values, with lines between them.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import CHUNK, ROUNDING, Signal, Stream, chunks, column, select
from .resampling import LEAST_RATIO, REACH, decimated, interpolated, uniform_grid
from .timebase import LOCATED, NO_CUTS, default_gap_limit, nominal_step, segments

Method = Literal["decimated", "interpolated"]
TimeReversal = Literal["refuse", "split", "unwrap"]

_SMOOTH = ("q", "velocity")  # columns of something with inertia, which has no steps


@dataclass(frozen=True)
class TimeRows:
    """The rows of a log whose stamps advance.

    Attributes
    ----------
    time : FloatArray, shape (N,)
        All stamps [s].
    keep : BoolArray, shape (N,)
        Rows with a finite stamp later than all finite ones before: of equal stamps the first, and after a step back
        none until time has passed the point where it turned.
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
            finite = np.isfinite(part)
            latest = np.maximum.accumulate(np.concatenate(([reached], np.where(finite, part, -np.inf))))
            yield finite & (part > latest[:-1])
            stamps = part[finite]
            if stamps.size:
                steps = np.diff(stamps, prepend=last)
                turns.append(np.concatenate(([last], stamps[:-1]))[steps < 0.0])
                repeated += int(np.count_nonzero((steps == 0.0) & (stamps == latest[:-1][finite])))
                last = float(stamps[-1])
            reached = float(latest[-1])
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


def finite_segments(rows: TimeRows, columns: Mapping[str, FloatArray]) -> list[Segments]:
    """Split columns into gap-free segments; neighbouring columns with the same valid rows share one result.

    Parameters
    ----------
    rows : TimeRows
        The columns' time base.
    columns : mapping of name to FloatArray, shape (N,) each
        Samples; those that are not finite are left out.

    Raises
    ------
    DataRefusedError
        A column holds no finite sample.

    Notes
    -----
    Cost: one pass over the columns and one over the stamps, in chunks; where rows are left out, copies on disk.
    """
    shared: list[tuple[BoolArray, list[str]]] = []
    not_finite = {}
    for name, samples in columns.items():
        not_finite[name] = sum(int(np.count_nonzero(~np.isfinite(samples[part]))) for part in chunks(samples.size))
        both = (np.isfinite(samples[part]) & rows.keep[part] for part in chunks(samples.size))
        valid = column(samples.size, both, np.bool_) if not_finite[name] else rows.keep
        if shared and (shared[-1][0] is valid or np.array_equal(shared[-1][0], valid)):
            shared[-1][1].append(name)
        else:
            shared.append((valid, [name]))
    groups = []
    for valid, names in shared:
        if not valid.any():
            raise DataRefusedError(f"{names[0]} holds no finite sample at all: no sensor, or another channel")
        stamps = select(rows.time, valid)
        bounds = segments(stamps, default_gap_limit(rows.step), rows.ends)
        groups.append(
            Segments(
                time=stamps,
                columns=tuple(select(columns[name], valid) for name in names),
                smooth=tuple(name in _SMOOTH for name in names),
                bounds=bounds,
                edges=stamps[bounds - [0, 1]],
                step=rows.step,
                not_finite=tuple(not_finite[name] for name in names),
            )
        )
    return groups


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
    q: Signal,
    beside: Mapping[str, Signal],
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
    signals = {"q": q, **beside}
    rows: list[TimeRows] = []
    groups: list[Segments] = []
    for _, names in groupby(signals, key=lambda name: id(signals[name][0])):
        together = {name: signals[name][1] for name in names}
        rows.append(advancing_rows(signals[next(iter(together))][0], time_reversal, cuts))
        groups += finite_segments(rows[-1], together)
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
    first, last = first[holds], last[holds]
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
    for pieces in zip(*streams, strict=True):
        yield np.stack(pieces)


def _bridged(group: Segments, gap: FloatArray) -> Iterator[FloatArray]:
    """Straight lines from sample to sample at the points between two segments."""
    for first in range(0, gap.size, CHUNK):
        points = gap[first : first + CHUNK]
        low, high = np.searchsorted(group.time, points[[0, -1]])
        rows = slice(max(low - 1, 0), high + 1)
        yield np.stack([np.interp(points, group.time[rows], samples[rows]) for samples in group.columns])
