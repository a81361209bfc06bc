"""A free run against its measured record: one score per signal."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray
from ..numerics.metrics import nrmse, rmse, signal_range
from .intervals import Interval, block_of, mean_interval, rms_interval, share_interval
from .wells import NoWells, Wells, in_same_well, switch_accuracy

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
        score = Score(name, None, None, None, n, status, diverged_at_s)
        block = block_of((calculated - measured,), interval, plant=plant)
        if status == "ok":
            fraction = nrmse(measured, calculated)
            span = signal_range(measured)
            band = rms_interval(calculated - measured, block, rng) if fraction is not None else None
            of_range = band.over(span) if band and span else None
            score = replace(score, nrmse=fraction, rmse=rmse(measured, calculated), nrmse_interval=of_range)
        if name == "q" and isinstance(wells, Wells):
            same = in_same_well(measured, calculated, wells)
            switches = switch_accuracy(measured, calculated, v, interval, wells, plant=plant)
            score = replace(
                score,
                well_agreement=float(np.nanmean(same)) if np.isfinite(same).any() else None,
                well_agreement_interval=_agreement_interval(same, block, rng),
                switch_accuracy=switches.share,
                switch_accuracy_interval=share_interval(switches.correct, switches.pulses),
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
