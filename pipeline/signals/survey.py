"""The usable part of a raw log: its advancing rows with finite samples, in gap-free segments.

What is left out is counted and located. Columns that share a time base and valid rows share their segments.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import Literal

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import BoolArray, FloatArray, IntArray
from .columns import Signal, chunks, column, select
from .timebase import NO_CUTS, default_gap_limit, nominal_step, segments

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
        Rows with a finite stamp later than all finite ones before. Of equal stamps it is the first; after a step back
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
        Refuse a log whose time steps back; or leave out rows that do not advance and treat the place as a gap. Stamps
        that were unwrapped and still step back are treated so too.
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
