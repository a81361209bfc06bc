"""A free run against its measured record: scores by signal, errors by horizon, and times of the switches."""

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ..device.device import Device
from ..numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, sample_interval, samples_of
from ..numerics.metrics import fit_percent, nrmse, rms, rmse, settling_index, signal_range
from .intervals import BLOCK, SEED, Interval, block_of, mean_interval, median_interval, rms_interval, share_interval
from .wells import LONGEST_WINDOW, NoWells, Wells, in_same_well, switch_accuracy

Status = Literal["ok", "diverged"]


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
        n = int(np.count_nonzero(np.isfinite(measured) & np.isfinite(calculated)))
        score = Score(
            signal=name, nrmse=None, rmse=None, nrmse_interval=None, n=n, status=status, diverged_at_s=diverged_at_s
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
                nrmse_interval=band.over(span) if band and span else None,
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
    least = None if band is None else share_interval(round(float(np.nanmean(same)) * blocks), blocks)
    if band is None or least is None:
        return band
    return Interval(min(band.low, least.low), max(band.high, least.high))


MOST_STARTS = 400

SHORTEST_HORIZON = 2.0
"""In sample intervals: a shorter one but for one step would be rounded to another time than that of its name."""

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
    farthest: dict[int, int] = {}
    for ahead, chosen in zip(aheads, starts, strict=True):
        farthest |= {start: max(ahead, farthest.get(start, 0)) for start in chosen.tolist()}
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
    starts = _starts(path, ahead, path.q.size, apart=1).tolist()
    for start, ahead_of in _predictions(predict, path, dict.fromkeys(starts, ahead)):
        q[start + ahead] = ahead_of[ahead]
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
    if diverged == starts.size or not span:
        return HorizonError(
            horizon_s=ahead * interval, nrmse=None, interval=None, starts=starts.size, diverged=diverged
        )
    errors = np.where(np.isfinite(errors), errors, span)
    spacing = float(np.median(np.diff(starts))) * interval if starts.size > 1 else BLOCK
    band = rms_interval(errors / span, block_of((errors,), spacing, plant=plant), np.random.default_rng(SEED))
    return HorizonError(
        horizon_s=ahead * interval, nrmse=rms(errors) / span, interval=band, starts=starts.size, diverged=diverged
    )


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


STEP = 0.2  # of the largest voltage: a change by more between two looks 20 ms apart is a step, a chirp's slope is not
STEP_WINDOW = 0.02  # s
SHORTEST_RESPONSE = 0.8  # s; two ring periods, less shows no settling
SETTLED = 0.1  # of the step in q


@dataclass(frozen=True)
class ResponseErrors:
    """Median absolute errors of the simulated times over the switches of a record.

    Attributes
    ----------
    switches : int
        Switches of the measurement whose response is long enough to be judged.
    followed : int
        Those in which the simulation switched too.
    rise_s, settling_s : float or None
        Median of |simulated − measured| [s] over the switches followed where both times exist; None if there is none.
    rise_interval, settling_interval : Interval or None
        95 % bootstrap intervals of these medians over the switches; None with fewer than four.
    """

    switches: int
    followed: int
    rise_s: float | None
    settling_s: float | None
    rise_interval: Interval | None
    settling_interval: Interval | None


def voltage_steps(v: FloatArray, interval: float, plant: Device) -> IntArray:
    """The last rows before an input jumps by more than `STEP` of its `peaks`, one per jump, shape (n,)."""
    lag = samples_of(STEP_WINDOW, interval)
    jump = np.zeros(len(v), dtype=bool)
    jump[lag:] = np.any(np.abs(v[lag:] - v[:-lag]) > STEP * plant.peaks(v), axis=1)
    rises = np.flatnonzero(jump & ~np.concatenate([[False], jump[:-1]]))
    return np.asarray(rises - 1, dtype=np.int64)


def step_response(q: FloatArray, interval: float) -> tuple[float | None, float | None]:
    """Rise and settling time of q from the first row, a voltage step, to the last, just before the next.

    The final value is the mean of the last 0.4 s, one period of the ring-down.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement, finite.
    interval : float
        Sample interval [s].

    Returns
    -------
    rise : float or None
        From 10 to 90 % of the way to the final value [s]; None if the way is not completed.
    settling : float or None
        From the voltage step until q stays within ±10 % of the step [s]; None if it does not for the last 0.4 s.
    """
    window = samples_of(LONGEST_WINDOW, interval)
    step = float(np.mean(q[-window:])) - q[0]
    if step == 0.0:
        return None, None
    way = (q - q[0]) / step
    ten, ninety = (np.flatnonzero(way >= share) for share in (0.1, 0.9))
    rise = float(ninety[0] - ten[0]) * interval if ninety.size else None
    settled = int(settling_index(way - 1.0, SETTLED))
    return rise, settled * interval if settled <= q.size - window else None


def response_errors(
    measured: FloatArray,
    calculated: FloatArray,
    v: FloatArray,
    interval: float,
    wells: Wells,
    rng: np.random.Generator,
    *,
    plant: Device,
) -> ResponseErrors:
    """Compare the times of all switches.

    A switch is a segment between two voltage steps that starts on one side of the barrier and ends on the other. It
    counts if it lasts at least 0.8 s and no row is masked.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        q [m]; NaN where masked, NaN after divergence.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Sample interval [s].
    wells : Wells
        The wells of the device.
    rng : numpy.random.Generator
        For the bootstrap.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    pairs = []
    switches = 0
    shortest = samples_of(SHORTEST_RESPONSE, interval)
    for begin, end in itertools.pairwise([*voltage_steps(v, interval, plant=plant).tolist(), len(v)]):
        rows = slice(begin, end)
        known = end - begin >= shortest and np.all(np.isfinite(measured[rows]))
        if not known or not _switches(measured[rows], wells, interval):
            continue
        switches += 1
        if np.all(np.isfinite(calculated[rows])) and _switches(calculated[rows], wells, interval):
            pairs.append((step_response(measured[rows], interval), step_response(calculated[rows], interval)))
    rise = _errors([(own, other) for (own, _), (other, _) in pairs])
    settling = _errors([(own, other) for (_, own), (_, other) in pairs])
    return ResponseErrors(
        switches=switches,
        followed=len(pairs),
        rise_s=_median(rise),
        settling_s=_median(settling),
        rise_interval=median_interval(rise, rng),
        settling_interval=median_interval(settling, rng),
    )


def _median(errors: Sequence[float]) -> float | None:
    return float(np.median(errors)) if errors else None


def _switches(q: FloatArray, wells: Wells, interval: float) -> bool:
    last = wells.side(q[-samples_of(LONGEST_WINDOW, interval) :])
    return bool(last.all() == last.any() and last[0] != wells.side(q[:1])[0])


def _errors(pairs: Sequence[tuple[float | None, float | None]]) -> list[float]:
    return [abs(b - a) for a, b in pairs if a is not None and b is not None]
