"""A raw log's displacement and voltages on one uniform grid; what was left out is counted and located."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pipeline.errors import DataRefusedError
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.sampling.resampling import LEAST_RATIO, REACH, decimate, interpolate, uniform_grid
from pipeline.numerics.sampling.stretches import Stretches, TimeReversal, TimeRows, advancing_rows, finite_stretches
from pipeline.numerics.sampling.timebase import LOCATED, default_gap_limit

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


def uniform_record(
    time: FloatArray,
    q: FloatArray,
    v: FloatArray,
    interval: float,
    *,
    v_time: FloatArray | None = None,
    gap_limit: float | None = None,
    gaps: Literal["split", "refuse"] = "split",
    time_reversal: TimeReversal = "refuse",
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
    rows = advancing_rows(time, time_reversal)
    groups = _groups(rows, q, v, v_time, gap_limit, time_reversal)
    limit = default_gap_limit(rows.step) if gap_limit is None else gap_limit
    holes = np.unique(np.concatenate([group.gaps for group in groups]), axis=0)
    if gaps == "refuse" and holes.size:
        raise DataRefusedError(
            f"{len(holes)} gap(s) longer than {limit * 1e3:.4g} ms, the first from {holes[0, 0]:.6g} s to "
            f'{holes[0, 1]:.6g} s; set [ingest] gaps = "split" to use the stretches between'
        )
    start, stop = max(group.time[0] for group in groups), min(group.time[-1] for group in groups)
    if not stop > start:
        raise DataRefusedError("displacement and voltages have no stretch of time in common")
    t = uniform_grid(float(start), float(stop), interval)
    values = np.concatenate([_resample(group, t, interval) for group in groups])
    reach = max(REACH if _method(group.step, interval) == "decimated" else 0.5 for group in groups)
    segment = _segment_numbers(t, holes, reach * interval)
    report = RecordReport(
        raw_rows=time.size,
        rows=t.size,
        masked_rows=int(np.count_nonzero(segment < 0)),
        raw_step=rows.step,
        interval=interval,
        gap_limit=limit,
        method=_method(rows.step, interval),
        time_not_finite=rows.not_finite,
        repeated=rows.repeated,
        backward=rows.backward,
        q_not_finite=int(q.size - np.count_nonzero(np.isfinite(q))),
        v_not_finite=int(v.size - np.count_nonzero(np.isfinite(v))),
        gaps=len(holes),
        gaps_at=tuple((float(a), float(b)) for a, b in holes[:LOCATED]),
        segments=int(segment.max()) + 1,
    )
    return UniformRecord(
        t, np.where(segment < 0, np.nan, values[0]), np.ascontiguousarray(values[1:].T), segment, report
    )


def _groups(
    rows: TimeRows,
    q: FloatArray,
    v: FloatArray,
    v_time: FloatArray | None,
    gap_limit: float | None,
    time_reversal: TimeReversal,
) -> list[Stretches]:
    """Displacement first, then the voltages, each on its own time base."""
    voltages = [np.ascontiguousarray(column) for column in v.T]
    linear = [False] * len(voltages)
    if v_time is None:
        return finite_stretches(rows, [q, *voltages], [True, *linear], gap_limit)
    own = advancing_rows(v_time, time_reversal)
    return finite_stretches(rows, [q], [True], gap_limit) + finite_stretches(own, voltages, linear, gap_limit)


def _method(step: float, interval: float) -> Method:
    """Whether a log of that nominal step is decimated or passed through; a thousandth is left to rounding."""
    return "decimated" if interval >= (LEAST_RATIO - 1e-3) * step else "interpolated"


def _resample(group: Stretches, t: FloatArray, interval: float) -> FloatArray:
    """Values on the grid, shape (k, M): stretch by stretch, straight lines between the stretches."""
    time, columns = group.time, group.columns
    decimated = _method(group.step, interval) == "decimated"
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
