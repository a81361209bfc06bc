"""Error of the prediction against its horizon: restarts along a log, compared a fixed time after each."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, sample_interval, samples_of
from pipeline.numerics.metrics import rms, signal_range
from pipeline.scoring.intervals import BLOCK, SEED, Interval, block_of, rms_interval

MOST_STARTS = 400
WARM_UP, WARM_UP_SAMPLES = 1.0, 100
"""How long before a restart a model may look at the measurement, to know its hidden states: in s, and at least in
samples, because a slow device is sampled slowly."""

SHORTEST_HORIZON = 2.0
"""In sample intervals: a shorter one but for one step would be rounded to another time than its name says."""

Predict = Callable[[FloatArray, FloatArray, FloatArray, FloatArray], FloatArray]
"""``(t, v, q, qdot) -> q``: see `pipeline.models.base.predictor`."""


@dataclass(frozen=True)
class MeasuredPath:
    """A log as predictions are compared with it.

    Attributes
    ----------
    t, q, qdot : FloatArray, shape (N,)
        Uniform time [s] and the measured state; NaN where masked.
    v : FloatArray, shape (N, K) or (N, r, K)
        Inputs, as the predictor takes them; NaN where they are not known, which no prediction passes.
    """

    t: FloatArray
    v: FloatArray
    q: FloatArray
    qdot: FloatArray

    @property
    def recorded(self) -> BoolArray:
        """Where all inputs are known, shape (N,)."""
        return np.asarray(np.all(np.isfinite(self.v).reshape(self.q.size, -1), axis=1))


@dataclass(frozen=True)
class HorizonError:
    """Prediction error after a fixed time.

    Attributes
    ----------
    horizon_s : float
        How far ahead is predicted [s].
    nrmse : float or None
        RMS of the error of q at the horizon over the range of q (eq. 41). A restart that diverged counts as an error
        of the whole range. None if every start diverged or none exists.
    interval : Interval or None
        95 % moving-block bootstrap interval of `nrmse`, in blocks of neighbouring starts (`block_of`; of the joint
        as many as 2 s hold); None with fewer than three blocks of them.
    starts : int
        Restarts made.
    diverged : int
        Those that diverged.
    """

    horizon_s: float
    nrmse: float | None
    interval: Interval | None
    starts: int
    diverged: int


def horizon_errors(
    predict: Predict,
    path: MeasuredPath,
    horizons: Sequence[float],
    *,
    joint: bool,
    most_starts: int = MOST_STARTS,
    shared: bool = True,
) -> list[HorizonError]:
    """Restart at evenly spread samples and compare q at each horizon, as a predictive controller would find it.

    Before each restart the model is shown up to `WARM_UP` s (`WARM_UP_SAMPLES`) of the measurement without a gap, from
    which it takes its hidden states; of what comes after, it sees the inputs alone.

    Parameters
    ----------
    predict : callable
        The model's prediction of q from the last of the measured rows on.
    path : MeasuredPath
        The log.
    horizons : sequence of float
        Times ahead [s]; rounded to samples, at least one.
    joint : bool
        Whether the device can be the bistable joint, see `pipeline.scoring.intervals.block_of`.
    most_starts : int
        Upper bound of the restarts of a horizon; they are at least one horizon apart, but for the one-step horizon.
    shared : bool
        Read horizons that have a restart in common off one prediction; not for a model whose last sample depends on
        where the prediction ends, as one does that filters its samples.

    Notes
    -----
    Cost: the simulated time is at most that of the record for each horizon, plus the call overhead of the restarts.
    """
    q, interval = path.q, sample_interval(path.t)
    aheads = [samples_of(horizon, interval) for horizon in horizons]
    starts = [_starts(path, ahead, most_starts) for ahead in aheads]
    farthest: dict[tuple[int, int], int] = {}
    for ahead, chosen in zip(aheads, starts, strict=True):
        keys = [(start, 0 if shared else ahead) for start in chosen.tolist()]
        farthest |= {key: max(ahead, farthest.get(key, 0)) for key in keys}
    paths: dict[tuple[int, int], FloatArray] = {}
    begins = _shown_from(path)
    for (start, apart), ahead in farthest.items():
        paths[start, apart] = _restarted(predict, path, int(begins[start]), start, ahead)
    span = signal_range(q)
    return [
        _error(
            np.array([paths[start, 0 if shared else ahead][ahead] - q[start + ahead] for start in chosen.tolist()]),
            chosen, ahead, interval, span, joint=joint,
        )
        for ahead, chosen in zip(aheads, starts, strict=True)
    ]  # fmt: skip


def predicted(predict: Predict, path: MeasuredPath, ahead: int) -> FloatArray:
    """Displacement `ahead` samples after each measured state, at the sample it is for, shape (N,); else NaN."""
    q, begins = np.full(path.q.size, np.nan), _shown_from(path)
    for start in _starts(path, ahead, path.q.size, apart=1).tolist():
        q[start + ahead] = _restarted(predict, path, int(begins[start]), start, ahead)[ahead]
    return q


def _shown_from(path: MeasuredPath) -> IntArray:
    """From which row on a model is shown the measurement before it restarts in a row, without a gap between."""
    begins = np.zeros(path.q.size, dtype=np.int64)
    for rows in runs_of(np.isfinite(path.q) & np.isfinite(path.qdot) & path.recorded):
        begins[rows] = rows.start
    shown = max(round(WARM_UP / sample_interval(path.t)), WARM_UP_SAMPLES)
    return np.maximum(begins, np.arange(path.q.size) - shown)


def _restarted(predict: Predict, path: MeasuredPath, begin: int, start: int, ahead: int) -> FloatArray:
    """The prediction of q from one row on, shape (ahead + 1,)."""
    seen, rows = slice(begin, start + 1), slice(begin, start + ahead + 1)
    return predict(path.t[rows], path.v[rows], path.q[seen], path.qdot[seen])


def _error(
    errors: FloatArray, starts: IntArray, ahead: int, interval: float, span: float | None, *, joint: bool
) -> HorizonError:
    """What the errors `ahead` samples after the starts come to."""
    diverged = int(np.count_nonzero(~np.isfinite(errors)))
    if diverged == starts.size or not span:
        return HorizonError(ahead * interval, None, None, starts.size, diverged)
    errors = np.where(np.isfinite(errors), errors, span)
    spacing = float(np.median(np.diff(starts))) * interval if starts.size > 1 else BLOCK
    block = block_of((errors,), spacing, joint=joint)
    band = rms_interval(errors / span, block, np.random.default_rng(SEED))
    return HorizonError(ahead * interval, rms(errors) / span, band, starts.size, diverged)


def _starts(path: MeasuredPath, ahead: int, most: int, apart: int | None = None) -> IntArray:
    """Rows whose state, target and inputs between are measured, at least `apart` (`ahead`) apart, at most `most`."""
    q, qdot, last = path.q, path.qdot, path.q.size - ahead
    if last < 1:
        return np.zeros(0, dtype=np.int64)
    rows = np.arange(0, last, max(ahead if apart is None else apart, -(-last // most)))
    missing = np.concatenate(([0], np.cumsum(~path.recorded)))
    usable = np.isfinite(q[rows]) & np.isfinite(qdot[rows]) & np.isfinite(q[rows + ahead])
    usable &= missing[rows + ahead + 1] == missing[rows]
    return np.asarray(rows[usable], dtype=np.int64)
