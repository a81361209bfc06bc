"""Error of the prediction against its horizon: restarts along the record, simulated for a while."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray, runs_of, sample_interval
from pipeline.numerics.metrics import signal_range
from pipeline.scoring.intervals import BLOCK, Interval, rms_interval

MOST_STARTS = 400
WARM_UP = 1.0
"""How long before a restart [s] a model may look at the measurement, to know its hidden states."""

Simulate = Callable[[FloatArray, FloatArray, float, float], FloatArray]
"""``(t, v, q0, qdot0) -> q`` of shape (N,), NaN after a divergence."""

Predict = Callable[[FloatArray, FloatArray, FloatArray, FloatArray], FloatArray]
"""``(t, v, q, qdot) -> q``: see `pipeline.models.base.predict`."""


@dataclass(frozen=True)
class HorizonError:
    """Prediction error after a fixed time.

    Attributes
    ----------
    horizon_s : float
        How far ahead is predicted [s].
    nrmse : float or None
        RMS of the error of q at the horizon over the range of q (eq. 41); None if every start diverged or none exists.
    interval : Interval or None
        95 % moving-block bootstrap interval of `nrmse`, in blocks of as many neighbouring starts as 2 s hold; None with
        fewer than three blocks of them.
    starts : int
        Restarts made.
    diverged : int
        Those that diverged; they are counted here and not in `nrmse`.
    """

    horizon_s: float
    nrmse: float | None
    interval: Interval | None
    starts: int
    diverged: int


def horizon_error(
    predict: Predict,
    t: FloatArray,
    v: FloatArray,
    q: FloatArray,
    qdot: FloatArray,
    horizon_s: float,
    *,
    rng: np.random.Generator,
    most_starts: int = MOST_STARTS,
) -> HorizonError:
    """Restart at evenly spread samples and compare q at the horizon, as a predictive controller would find it.

    Before each restart the model is shown up to `WARM_UP` s of the measurement without a gap, from which it takes its
    hidden states; of what comes after, it sees the inputs alone.

    Parameters
    ----------
    predict : callable
        The model's prediction of q from the last of the measured rows on.
    t, q, qdot : FloatArray, shape (N,)
        Uniform time [s] and the measured state; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    horizon_s : float
        Time ahead [s]; rounded to samples, at least one.
    rng : numpy.random.Generator
        For the bootstrap.
    most_starts : int
        Upper bound of the restarts; starts are at least one horizon apart, but for the one-step horizon.
        Cost: the simulated time is at most that of the record, plus the call overhead of the restarts.
    """
    interval = sample_interval(t)
    ahead = max(1, round(horizon_s / interval))
    starts = _starts(q, qdot, ahead, most_starts)
    errors, known = np.empty(starts.size), np.zeros(q.size, dtype=np.int64)
    for rows in runs_of(np.isfinite(q) & np.isfinite(qdot)):
        known[rows] = rows.start
    for k, start in enumerate(starts):
        begin = max(int(known[start]), int(start) - round(WARM_UP / interval))
        seen, rows = slice(begin, int(start) + 1), slice(begin, int(start) + ahead + 1)
        errors[k] = predict(t[rows], v[rows], q[seen], qdot[seen])[-1] - q[start + ahead]
    good = errors[np.isfinite(errors)]
    span = signal_range(q)
    if not good.size or not span:
        return HorizonError(ahead * interval, None, None, starts.size, starts.size - good.size)
    spacing = float(np.median(np.diff(starts))) * interval if starts.size > 1 else BLOCK
    band = rms_interval(errors / span, max(1, round(BLOCK / spacing)), rng)
    value = float(np.sqrt(np.mean(good**2))) / span
    return HorizonError(ahead * interval, value, band, starts.size, starts.size - good.size)


def _starts(q: FloatArray, qdot: FloatArray, ahead: int, most: int) -> IntArray:
    """Rows whose state and whose target are measured, at least `ahead` apart, at most `most`."""
    last = q.size - ahead
    if last < 1:
        return np.zeros(0, dtype=np.int64)
    rows = np.arange(0, last, max(ahead, -(-last // most)))
    known = np.isfinite(q[rows]) & np.isfinite(qdot[rows]) & np.isfinite(q[rows + ahead])
    return np.asarray(rows[known], dtype=np.int64)
