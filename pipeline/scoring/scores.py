"""A free run against its measured record: one score per signal, and the rise and settling times of its switches."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.numerics.metrics import nrmse, rmse, signal_range
from pipeline.scoring.intervals import BLOCK, Interval, mean_interval, median_interval, rms_interval, share_interval
from pipeline.scoring.wells import LONGEST_WINDOW, NoWells, Wells, in_same_well, switch_accuracy

Status = Literal["ok", "diverged"]


@dataclass(frozen=True)
class Score:
    """How well a free run meets one measured signal.

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
    rng : numpy.random.Generator
        For the bootstrap.
    """
    block, scores = max(1, round(BLOCK / interval)), []
    for name, (measured, calculated) in signals.items():
        n = int(np.count_nonzero(np.isfinite(measured) & np.isfinite(calculated)))
        score = Score(name, None, None, None, n, status, diverged_at_s)
        if status == "ok":
            fraction, span = nrmse(measured, calculated), signal_range(measured)
            band = rms_interval(calculated - measured, block, rng) if fraction is not None else None
            of_range = band.over(span) if band and span else None
            score = replace(score, nrmse=fraction, rmse=rmse(measured, calculated), nrmse_interval=of_range)
        if name == "q" and isinstance(wells, Wells):
            same = in_same_well(measured, calculated, wells)
            switches = switch_accuracy(measured, calculated, v, interval, wells)
            score = replace(
                score,
                well_agreement=float(np.nanmean(same)) if np.isfinite(same).any() else None,
                well_agreement_interval=_agreement_interval(same, block, rng),
                switch_accuracy=switches.share,
                switch_accuracy_interval=share_interval(switches.right, switches.pulses),
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


STEP = 0.2  # of the largest voltage: a change by more between two looks 20 ms apart is a step, a chirp's slope is not
STEP_WINDOW = 0.02  # s
SHORTEST_RESPONSE = 0.8  # s; two ring periods, less shows no settling
SETTLED = 0.1  # of the step in q


@dataclass(frozen=True)
class StepResponse:
    """How one switch went.

    Attributes
    ----------
    rise_s : float or None
        From 10 to 90 % of the way to the final value [s]; None if the way is not completed.
    settling_s : float or None
        From the voltage step until q stays within ±10 % of the step [s]; None if it does not for the last 0.4 s.
    """

    rise_s: float | None
    settling_s: float | None


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


def voltage_steps(v: FloatArray, interval: float) -> IntArray:
    """The last rows before an input jumps by more than `STEP` of the largest voltage, one per jump, shape (n,)."""
    lag = max(1, round(STEP_WINDOW / interval))
    peak = float(np.max(np.abs(v), initial=0.0))
    jump = np.zeros(len(v), dtype=bool)
    jump[lag:] = np.any(np.abs(v[lag:] - v[:-lag]) > STEP * peak, axis=1)
    rises = np.flatnonzero(jump & ~np.concatenate([[False], jump[:-1]]))
    return np.asarray(rises - 1, dtype=np.int64)


def step_response(q: FloatArray, interval: float) -> StepResponse:
    """Rise and settling time of q from the first row, a voltage step, to the last, just before the next.

    The final value is the mean of the last 0.4 s, one period of the ring-down.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement, finite.
    interval : float
        Sample interval [s].
    """
    window = round(LONGEST_WINDOW / interval)
    final = float(np.mean(q[-window:]))
    step = final - q[0]
    if step == 0.0:
        return StepResponse(None, None)
    way = (q - q[0]) / step
    ten, ninety = (np.flatnonzero(way >= share) for share in (0.1, 0.9))
    rise = float(ninety[0] - ten[0]) * interval if ninety.size else None
    outside = np.flatnonzero(np.abs(way - 1.0) > SETTLED)
    settled = int(outside[-1]) + 1 if outside.size else 0
    return StepResponse(rise, settled * interval if settled <= q.size - window else None)


def response_errors(
    measured: FloatArray,
    calculated: FloatArray,
    v: FloatArray,
    interval: float,
    wells: Wells,
    rng: np.random.Generator,
) -> ResponseErrors:
    """Compare the times of all switches.

    A switch is a stretch between two voltage steps, at least 0.8 s long and without masked rows, that starts on one
    side of the barrier and ends on the other.

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
    """
    pairs: list[tuple[StepResponse, StepResponse]] = []
    switches = 0
    for rows in _stretches(voltage_steps(v, interval), len(v), round(SHORTEST_RESPONSE / interval)):
        if not np.all(np.isfinite(measured[rows])) or not _switches(measured[rows], wells, interval):
            continue
        switches += 1
        if np.all(np.isfinite(calculated[rows])) and _switches(calculated[rows], wells, interval):
            pairs.append((step_response(measured[rows], interval), step_response(calculated[rows], interval)))
    rise = _errors([(a.rise_s, b.rise_s) for a, b in pairs])
    settling = _errors([(a.settling_s, b.settling_s) for a, b in pairs])
    bands = median_interval(rise, rng), median_interval(settling, rng)
    return ResponseErrors(switches, len(pairs), _median(rise), _median(settling), *bands)


def _median(errors: Sequence[float]) -> float | None:
    return float(np.median(errors)) if errors else None


def _stretches(steps: IntArray, samples: int, shortest: int) -> list[slice]:
    edges = [*(int(s) for s in steps), samples]
    return [slice(a, b) for a, b in itertools.pairwise(edges) if b - a >= shortest]


def _switches(q: FloatArray, wells: Wells, interval: float) -> bool:
    last = wells.side(q[-round(LONGEST_WINDOW / interval) :])
    return bool(last.all() == last.any() and last[0] != wells.side(q[:1])[0])


def _errors(pairs: Sequence[tuple[float | None, float | None]]) -> list[float]:
    return [abs(b - a) for a, b in pairs if a is not None and b is not None]
