"""A free run against its measured record: scores by signal, and errors by horizon."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ..device.device import Device
from ..numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, sample_interval, samples_of
from ..numerics.metrics import fit_percent, nrmse, rms, rmse, signal_range
from .intervals import BLOCK, SEED, Interval, block_of, mean_interval, rms_interval, share_interval
from .wells import NoWells, Wells, in_same_well, switch_accuracy

Status = Literal["ok", "diverged"]
MOST_STARTS = 400
SHORTEST_HORIZON = 2.0
"""In sample intervals: a shorter one but for one step would be rounded to another time than that of its name."""


@dataclass(frozen=True)
class Score:
    """Errors of a free run against one measured signal.

    Attributes
    ----------
    signal : str
        q, phi, qdot or qddot.
    nrmse, rmse : float or None
        Eq. 41 (a fraction) and its numerator; None if undefined. A run that diverged has none: the error before the
        divergence would flatter it, and after it there is nothing to compare.
    nrmse_interval : Interval or None
        95 % moving-block bootstrap interval of `nrmse`; None for a record of less than three blocks.
    n : int
        Measured samples compared; for a run that diverged those up to then.
    status : {"ok", "diverged"}
        Of the whole run, the same for all signals.
    diverged_at_s : float or None
        Time of the divergence.
    well_agreement, switch_accuracy : float or None
        See `pipeline.scoring.wells`; for q of a device with two known wells only.
    well_agreement_interval, switch_accuracy_interval : Interval or None
        95 % intervals: moving-block bootstrap of the samples, Bayesian bootstrap of the pulses.
    """

    signal: str
    nrmse: float | None
    rmse: float | None
    nrmse_interval: Interval | None
    n: int
    status: Status
    diverged_at_s: float | None
    well_agreement: float | None = None
    switch_accuracy: float | None = None
    well_agreement_interval: Interval | None = None
    switch_accuracy_interval: Interval | None = None


def score_run(
    signals: Mapping[str, tuple[FloatArray, FloatArray]],
    v: FloatArray,
    interval: float,
    *,
    status: Status,
    diverged_at_s: float | None,
    wells: Wells | NoWells,
    plant: Device,
    rng: np.random.Generator,
) -> tuple[Score, ...]:
    """Score every signal of a free run.

    Parameters
    ----------
    signals : mapping of name to (measured, calculated)
        Vectors of shape (N,); NaN in `measured` masks a row, NaN in `calculated` is a divergence.
    v : FloatArray, shape (N, K)
        Measured inputs.
    interval : float
        Sample interval [s].
    status, diverged_at_s
        Of the free run.
    wells : Wells or NoWells
        `find_wells` of all logs of the device.
    plant : Device
        Its inputs, and whether it is the joint.
    rng : numpy.random.Generator
        For the bootstrap.
    """
    scores = []
    for name, (measured, calculated) in signals.items():
        score = Score(
            signal=name,
            nrmse=None,
            rmse=None,
            nrmse_interval=None,
            n=int(np.count_nonzero(np.isfinite(measured) & np.isfinite(calculated))),
            status=status,
            diverged_at_s=diverged_at_s,
        )
        block = block_of((calculated - measured,), interval, plant=plant)
        if status == "ok":
            fraction = nrmse(measured, calculated)
            span = signal_range(measured)
            band = rms_interval(calculated - measured, block, rng) if fraction is not None else None
            score = replace(
                score,
                nrmse=fraction,
                rmse=rmse(measured, calculated),
                nrmse_interval=Interval(band.low / span, band.high / span) if band and span else None,
            )
        if name == "q" and isinstance(wells, Wells):
            same = in_same_well(measured, calculated, wells)
            correct, pulses = switch_accuracy(measured, calculated, v, interval, wells, plant=plant)
            score = replace(
                score,
                well_agreement=float(np.nanmean(same)) if np.isfinite(same).any() else None,
                well_agreement_interval=_agreement_interval(same, block, rng),
                switch_accuracy=correct / pulses if pulses else None,
                switch_accuracy_interval=share_interval(correct, pulses),
            )
        scores.append(score)
    return tuple(scores)


def _agreement_interval(same: FloatArray, block: int, rng: np.random.Generator) -> Interval | None:
    """Interval of the share of samples that agree: of the bootstrap, and never narrower than that of so many blocks.

    Resampling cannot vary a record in which (nearly) all samples agree.
    """
    band = mean_interval(same, block, rng)
    blocks = int(np.count_nonzero(np.isfinite(same))) // block
    least = share_interval(round(float(np.nanmean(same)) * blocks), blocks) if band else None
    return Interval(min(band.low, least.low), max(band.high, least.high)) if band and least else band


Predict = Callable[[FloatArray, FloatArray, FloatArray, FloatArray, IntArray, IntArray], Iterable[FloatArray]]
"""``(t, v, seen, speed, starts, ahead) -> predictions``: see `pipeline.models.base.Predicts`."""


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
        """Mask of the samples at which all inputs are known, shape (N,)."""
        return np.asarray(np.all(np.isfinite(self.v).reshape(self.q.size, -1), axis=1))


@dataclass(frozen=True)
class HorizonError:
    """Prediction error after a fixed time.

    Attributes
    ----------
    horizon_s : float
        Horizon of the prediction [s].
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
    plant: Device | None,
    most_starts: int = MOST_STARTS,
) -> list[HorizonError]:
    """Restart at evenly spread samples and compare q at each horizon, as a predictive controller would find it.

    A model takes its hidden states from the measurement before a restart; of what comes after, it sees the inputs
    alone.

    Parameters
    ----------
    predict : callable
        The model's predictions of q from measured rows on.
    path : MeasuredPath
        The log.
    horizons : sequence of float
        Times ahead [s]; rounded to samples, at least one.
    plant : Device or None
        As in `pipeline.scoring.intervals.block_of`.
    most_starts : int
        Upper bound of the restarts of a horizon; they are at least one horizon apart, but for the one-step horizon.

    Notes
    -----
    Cost: a simulation of the record, one of at most as much for each horizon, and the call overhead of the restarts.
    """
    interval = sample_interval(path.t)
    aheads = [samples_of(horizon, interval) for horizon in horizons]
    starts = [_starts(path, ahead, most_starts) for ahead in aheads]
    rising = sorted(zip(aheads, starts, strict=True), key=lambda pair: pair[0])  # so that the farthest comes last
    farthest = {start: ahead for ahead, chosen in rising for start in chosen.tolist()}
    paths = dict(_predictions(predict, path, farthest))
    span = signal_range(path.q)
    return [
        _error(
            np.array([paths[start][ahead] - path.q[start + ahead] for start in chosen.tolist()]),
            chosen,
            ahead,
            interval,
            span,
            plant=plant,
        )
        for ahead, chosen in zip(aheads, starts, strict=True)
    ]


def predicted(predict: Predict, path: MeasuredPath, ahead: int) -> FloatArray:
    """Displacement `ahead` samples after each measured state, at the sample it is for, shape (N,); else NaN."""
    q = np.full(path.q.size, np.nan)
    starts = dict.fromkeys(_starts(path, ahead, path.q.size, apart=1).tolist(), ahead)
    for start, run in _predictions(predict, path, starts):
        q[start + ahead] = run[ahead]
    return q


def _predictions(predict: Predict, path: MeasuredPath, ahead: dict[int, int]) -> Iterator[tuple[int, FloatArray]]:
    """Rows and the predictions of q from them on, so many samples ahead, for rows whose state is measured."""
    measured = np.isfinite(path.q) & np.isfinite(path.qdot)
    for rows in runs_of(path.recorded):
        starts = np.array([start for start in sorted(ahead) if rows.start <= start < rows.stop], dtype=np.int64)
        if starts.size:
            part = slice(rows.start + int(np.argmax(measured[rows])), rows.stop)
            counts = np.array([ahead[start] for start in starts.tolist()], dtype=np.int64)
            runs = predict(path.t[part], path.v[part], path.q[part], path.qdot[part], starts - part.start, counts)
            yield from zip(starts.tolist(), runs, strict=True)


def _error(
    errors: FloatArray, starts: IntArray, ahead: int, interval: float, span: float | None, plant: Device | None
) -> HorizonError:
    """Summary of the errors `ahead` samples after the starts."""
    diverged = int(np.count_nonzero(~np.isfinite(errors)))
    error = HorizonError(ahead * interval, nrmse=None, interval=None, starts=starts.size, diverged=diverged)
    if diverged == starts.size or not span:
        return error
    errors = np.where(np.isfinite(errors), errors, span)
    spacing = float(np.median(np.diff(starts))) * interval if starts.size > 1 else BLOCK
    band = rms_interval(errors / span, block_of((errors,), spacing, plant=plant), np.random.default_rng(SEED))
    return replace(error, nrmse=rms(errors) / span, interval=band)


def _starts(path: MeasuredPath, ahead: int, most: int, apart: int | None = None) -> IntArray:
    """Rows whose state, target and inputs between are measured, at least `apart` (`ahead`) apart, at most `most`."""
    q = path.q
    last = q.size - ahead
    if last < 1:
        return np.zeros(0, dtype=np.int64)
    rows = np.arange(0, last, max(ahead if apart is None else apart, -(-last // most)))
    missing = np.concatenate(([0], np.cumsum(~path.recorded)))
    usable = np.isfinite(q[rows]) & np.isfinite(path.qdot[rows]) & np.isfinite(q[rows + ahead])
    usable &= missing[rows + ahead + 1] == missing[rows]
    return np.asarray(rows[usable], dtype=np.int64)


def fit_note(measured: FloatArray, free: FloatArray) -> str:
    """Fit of a free run in percent, or the reason why there is none, as text."""
    fit = fit_percent(measured, free)
    if fit is not None:
        return f"fit {fit:.1f} %".replace("-", "−")
    return "diverged" if rmse(measured, free) is None else "the measurement is constant"
