"""The lag of the high-voltage converters, from the voltages that a log measured.

A converter responds to a commanded step with ``v = b + (a − b) e^(−t/lag)`` from the plateau a to the plateau b. The
logarithm of the share that is left of a step falls on a line, whose slope is −1/lag; no command need be known.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..numerics.arrays import FloatArray, runs_of, sample_interval, samples_of
from ..numerics.metrics import rms, robust_std
from ..signals.noise import REACH, noise_std

BLOCK = 2e-3
"""Window [s] in which a voltage step is sought."""
STILL = 6
SETTLED = 24
"""Blocks without a change that make a plateau, and those of its beginning that are looked at."""
CHANGE = 0.02
"""Share of the largest voltage by which a plateau's blocks may differ."""
HIGH = 0.8
"""Share that is left of a step, from which on its decay is looked at, until noise reaches it."""
LEAST_SAMPLES = 4
LEAST_STEPS = 3
CROOKED = 0.02
"""RMS share of a step that its exponential may miss; a ramp has 0.05 and more."""


@dataclass(frozen=True)
class ConverterLag:
    """Time constant of one converter.

    Attributes
    ----------
    lag : float
        Median over the steps [s].
    scatter : float
        Robust standard deviation of its logarithm over the steps.
    steps : int
        Their number.
    """

    lag: float
    scatter: float
    steps: int


def converter_lag(records: Sequence[tuple[FloatArray, FloatArray]]) -> ConverterLag | None:
    """The lag of one converter from the steps of some logs; None where they have fewer than `LEAST_STEPS`.

    Parameters
    ----------
    records : sequence of (t, v)
        Uniform records: time [s] and measured voltage [V], both of shape (N,).

    Notes
    -----
    In records of 1 ms a lag of 2 to 10 ms is found to 2 %, one of 1 ms 13 % too long, one of 14 or 20 ms 4 or 10 % too
    short, as the decay goes on in the plateau; a step with a shorter one is over before it is seen.
    """
    lags = np.concatenate([step_lags(t, v) for t, v in records])
    if lags.size < LEAST_STEPS:
        return None
    logs = np.log(lags)
    middle = float(np.median(logs))
    return ConverterLag(float(np.exp(middle)), robust_std(logs - middle), lags.size)


def step_lags(t: FloatArray, v: FloatArray) -> FloatArray:
    """The time constant [s] of every step of a measured voltage, shape (n,).

    Parameters
    ----------
    t, v : FloatArray, shape (N,)
        Uniform time [s], voltage [V]; a log with NaN in it has steps between them.

    Notes
    -----
    Cost: O(N), most of it the estimate of the noise.
    """
    interval = sample_interval(t)
    size = samples_of(BLOCK, interval)
    blocks = v[: v.size // size * size].reshape(-1, size)
    largest = float(np.nanmax(np.abs(v), initial=0.0))
    if len(blocks) < 2 * STILL or largest == 0.0:
        return np.empty(0)
    reached = REACH * noise_std(v[np.isfinite(v)])
    means = blocks.mean(axis=1)
    calm = np.zeros(len(means), dtype=bool)
    calm[1:] = np.abs(np.diff(means)) < CHANGE * largest
    plateaus = [run for run in runs_of(calm) if run.stop - run.start >= STILL]
    lags = []
    for before, after in pairwise(plateaus):
        end = _end(after)
        first = float(means[before.stop - STILL // 2 : before.stop - 1].mean())
        last = float(means[end].mean())
        low = reached / abs(last - first)
        if not low < HIGH:
            continue
        share = (v[(before.stop - 1) * size : end.stop * size] - last) / (first - last)
        lag = _decay(share, interval, low)
        if lag is not None:
            lags.append(lag)
    return np.array(lags)


def _end(plateau: slice) -> slice:
    """The second half of a plateau, or of its beginning, where a decay is over."""
    count = min(plateau.stop - plateau.start, SETTLED)
    return slice(plateau.start + count // 2, plateau.start + count)


def _decay(share: FloatArray, interval: float, low: float) -> float | None:
    """Time constant [s] of what is left of a step until `low`, by its logarithm weighed as its square is.

    None where it is shorter than the sample interval: then the first sample alone shows whether an edge is a decay.
    """
    gone = np.flatnonzero(~(share > low))
    started = np.flatnonzero(share < HIGH)
    if not (gone.size and started.size) or gone[0] - started[0] < LEAST_SAMPLES:
        return None
    part = share[started[0] : gone[0]]
    time = interval * np.arange(part.size)
    weights = part**2
    time = time - np.average(time, weights=weights)
    line = np.log(part)
    middle = np.average(line, weights=weights)
    slope = float(np.average(time * line, weights=weights) / np.average(time**2, weights=weights))
    missed = rms(np.exp(middle + slope * time) - part)
    return -1.0 / slope if -1.0 / interval < slope < 0.0 and missed < CROOKED else None
