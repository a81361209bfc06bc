"""A raw log's displacement and voltages on one uniform grid; what was left out is counted and located."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray
from pipeline.numerics.resampling import LEAST_RATIO, REACH, decimate, interpolate, uniform_grid
from pipeline.numerics.timebase import LOCATED, advancing, default_gap_limit, nominal_step, segments

Method = Literal["decimated", "interpolated"]


@dataclass(frozen=True)
class RecordReport:
    """How a uniform record came about; times in s.

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
        Samples left out because they are NaN or infinite (voltages: the sum over the inputs).
    gaps : int
        Holes longer than `gap_limit`, and places where time stepped back.
    gaps_at : tuple of (float, float)
        Last time before and first time after a gap, the first `LOCATED` ones.
    segments : int
        Gap-free stretches of the record.
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
        Voltages [V]; straight lines across gaps, so that a free run can pass.
    segment : NDArray[int32], shape (M,)
        Number of the gap-free stretch, −1 where the kernel would reach across a gap.
    report : RecordReport
    """

    t: FloatArray
    q: FloatArray
    v: FloatArray
    segment: NDArray[np.int32]
    report: RecordReport


@dataclass(frozen=True)
class _Stretches:
    """Finite samples of some columns on one advancing time base, and its gap-free stretches.

    `smooth` tells displacements from voltages: how a column is interpolated where it is not decimated.
    """

    time: FloatArray
    columns: tuple[FloatArray, ...]
    smooth: tuple[bool, ...]
    bounds: IntArray

    @property
    def gaps(self) -> FloatArray:
        """Last time before and first time after each gap, shape (G, 2)."""
        return np.stack((self.time[self.bounds[:-1, 1] - 1], self.time[self.bounds[1:, 0]]), axis=1)


def uniform_record(
    time: FloatArray,
    q: FloatArray,
    v: FloatArray,
    interval: float,
    *,
    v_time: FloatArray | None = None,
    gap_limit: float | None = None,
    gaps: Literal["split", "refuse"] = "split",
    time_reversal: Literal["refuse", "split"] = "refuse",
) -> UniformRecord:
    """Bring a raw log onto a uniform grid, without delay and never across a gap.

    Rows with a stamp that is not finite or does not advance, and samples that are not finite, are left out and
    counted. A hole of at most `gap_limit` (a few lost samples) is passed over: its neighbours share its part of
    the time axis. A longer one is a gap: grid points whose kernel would reach into it are masked. Nothing is
    sorted.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s] of `q`, in the order of the log.
    q : FloatArray, shape (N,)
        Displacement [m or rad].
    v : FloatArray, shape (Nv, k)
        Voltages [V].
    interval : float
        Step of the record [s].
    v_time : FloatArray, shape (Nv,), optional
        Time stamps [s] of the voltages where they have their own; each signal is resampled from its own base.
    gap_limit : float, optional
        Longest hole [s] that is no gap; by default five nominal steps, at least 1 ms.
    gaps : {"split", "refuse"}
        Number the stretches, or refuse a log with gaps.
    time_reversal : {"refuse", "split"}
        Refuse a log whose time steps back; or leave out what does not advance and treat the place as a gap.

    Raises
    ------
    DataRefusedError
        No two valid rows, no common time span, or what the policies refuse.

    Notes
    -----
    Cost: that of `decimate`, O(4 N (k + 1)). Columns are copied only where a sample of them is left out.
    """
    base, broken, counts = _advancing_rows(time, time_reversal)
    raw_step = nominal_step(time[base])
    limit = default_gap_limit(raw_step) if gap_limit is None else gap_limit
    columns = [np.ascontiguousarray(v[:, j]) for j in range(v.shape[1])]
    linear = (False,) * len(columns)
    if v_time is None:
        groups = _finite_groups(time, (q, *columns), (True, *linear), base, broken, limit)
    else:
        v_base, v_broken, _ = _advancing_rows(v_time, time_reversal)
        v_limit = default_gap_limit(nominal_step(v_time[v_base])) if gap_limit is None else gap_limit
        groups = _finite_groups(time, (q,), (True,), base, broken, limit)
        groups += _finite_groups(v_time, columns, linear, v_base, v_broken, v_limit)
    holes = np.unique(np.concatenate([group.gaps for group in groups]), axis=0)
    if gaps == "refuse" and holes.size:
        raise DataRefusedError(
            f"{len(holes)} gap(s) longer than {limit * 1e3:.4g} ms, the first from {holes[0, 0]:.6g} s to "
            f'{holes[0, 1]:.6g} s; set [ingest] gaps = "split" to use the stretches between'
        )
    start, stop = max(g.time[0] for g in groups), min(g.time[-1] for g in groups)
    if not stop > start:
        raise DataRefusedError("displacement and voltages have no stretch of time in common")
    t = uniform_grid(float(start), float(stop), interval)
    rows = np.concatenate([_resample(group, t, interval) for group in groups])
    coarse = any(_method(group.time, interval) == "interpolated" for group in groups)
    segment = _segment_numbers(t, holes, (0.5 if coarse else REACH) * interval)
    return UniformRecord(
        t=t,
        q=np.where(segment < 0, np.nan, rows[0]),
        v=np.ascontiguousarray(rows[1:].T),
        segment=segment,
        report=RecordReport(
            raw_rows=time.size,
            rows=t.size,
            masked_rows=int(np.count_nonzero(segment < 0)),
            raw_step=raw_step,
            interval=interval,
            gap_limit=limit,
            method=_method(time[base], interval),
            **counts,
            q_not_finite=int(time.size - np.count_nonzero(np.isfinite(q))),
            v_not_finite=int(v.size - np.count_nonzero(np.isfinite(v))),
            gaps=len(holes),
            gaps_at=tuple((float(a), float(b)) for a, b in holes[:LOCATED]),
            segments=int(segment.max()) + 1,
        ),
    )


def _advancing_rows(
    time: FloatArray, time_reversal: Literal["refuse", "split"]
) -> tuple[BoolArray, FloatArray, dict[str, int]]:
    """Rows to keep, the times at which time stepped back, and the counts of what is left out."""
    keep = advancing(time)
    if keep.all():
        return keep, np.empty(0), {"time_not_finite": 0, "repeated": 0, "backward": 0}
    finite = np.flatnonzero(np.isfinite(time))
    steps = np.diff(time[finite])
    turns = time[finite[:-1][steps < 0.0]]
    if turns.size and time_reversal == "refuse":
        raise DataRefusedError(
            f"time steps back at {turns.size} place(s), first after {turns[0]:.6g} s; "
            'repair the log or set [ingest] time_reversal = "split"'
        )
    repeated = int(np.count_nonzero((steps == 0.0) & ~_behind(time[finite])))
    return (
        keep,
        turns,
        {
            "time_not_finite": int(time.size - finite.size),
            "repeated": repeated,
            "backward": int(finite.size - np.count_nonzero(keep)) - repeated,
        },
    )


def _behind(time: FloatArray) -> BoolArray:
    """Whether each stamp but the first is earlier than one before it, shape (N − 1,)."""
    behind: BoolArray = time[1:] < np.maximum.accumulate(time)[:-1]
    return behind


def _finite_groups(
    time: FloatArray,
    columns: Sequence[FloatArray],
    smooth: tuple[bool, ...],
    keep: BoolArray,
    turns: FloatArray,
    limit: float,
) -> list[_Stretches]:
    """Columns with the same valid rows share a group, so that they share the kernel's weights."""
    masks: list[tuple[BoolArray, list[int]]] = []
    for j, column in enumerate(columns):
        valid = keep & np.isfinite(column)
        for mask, members in masks[-1:]:
            if np.array_equal(mask, valid):
                members.append(j)
                break
        else:
            masks.append((valid, [j]))
    groups = []
    for valid, members in masks:
        if not valid.any():
            raise DataRefusedError("a signal holds no finite sample at all")
        whole = bool(valid.all())
        stamps = time if whole else time[valid]
        bounds = segments(stamps, limit)
        if turns.size:
            cuts = np.searchsorted(stamps, turns, side="right")
            edges = np.unique(np.concatenate((bounds.ravel(), cuts)))
            bounds = np.stack((edges[:-1], edges[1:]), axis=1)
        picked = tuple(columns[j] if whole else columns[j][valid] for j in members)
        groups.append(_Stretches(stamps, picked, tuple(smooth[j] for j in members), bounds))
    return groups


def _method(time: FloatArray, interval: float) -> Method:
    return "decimated" if interval >= LEAST_RATIO * nominal_step(time) else "interpolated"


def _resample(group: _Stretches, t: FloatArray, interval: float) -> FloatArray:
    """Values on the grid, shape (k, M): stretch by stretch, straight lines between the stretches."""
    time, columns = group.time, group.columns
    decimated = _method(time, interval) == "decimated"
    first = np.searchsorted(t, time[group.bounds[:, 0]] - 1e-6 * interval)
    last = np.searchsorted(t, time[group.bounds[:, 1] - 1] + 1e-6 * interval, side="right")
    values = np.empty((len(columns), t.size))
    inside = np.zeros(t.size, dtype=np.bool_)
    for (low, high), i, j in zip(group.bounds, first, last, strict=True):
        if i == j:
            continue
        stretch, parts = time[low:high], [column[low:high] for column in columns]
        if decimated:
            values[:, i:j] = decimate(stretch, parts, t[i:j], interval)
        else:
            values[:, i:j] = [
                interpolate(stretch, part, t[i:j], smooth=smooth)
                for part, smooth in zip(parts, group.smooth, strict=True)
            ]
        inside[i:j] = True
    if not inside.all():
        for row, column in zip(values, columns, strict=True):
            row[~inside] = np.interp(t[~inside], time, column)
    return values


def _segment_numbers(t: FloatArray, holes: FloatArray, reach: float) -> NDArray[np.int32]:
    """Number of the stretch of each grid point, −1 within reach of a hole, shape (M,)."""
    change = np.zeros(t.size + 1, dtype=np.int64)
    np.add.at(change, np.searchsorted(t, holes[:, 0] - reach, side="right"), 1)
    np.add.at(change, np.searchsorted(t, holes[:, 1] + reach, side="left"), -1)
    valid = np.cumsum(change[:-1]) == 0
    starts = np.diff(valid.astype(np.int8), prepend=np.int8(0)) == 1
    return np.where(valid, np.cumsum(starts) - 1, -1).astype(np.int32)
