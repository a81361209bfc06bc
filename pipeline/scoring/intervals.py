"""Intervals of error measures: moving blocks of a record resampled, measures of few events, and paired models."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray, samples_of

BLOCK = 2.0
"""Length [s] of the blocks of a joint: its ring-down decays by e² in 1.3 s, so blocks are nearly independent."""
MEMORIES = 3
"""Correlation times in a block: 95 % intervals of AR(1) errors 80 of them long then hold their RMS in 9 cases of 10."""
FEWEST_BLOCKS = 8
"""Blocks of another device's log, however long its errors stay correlated: fewer have no spread to resample."""
RESAMPLES = 1000
SEED = 0
"""Of the bootstrap: equal errors have equal intervals."""
LEVEL = 0.95
_TAILS = [(1.0 - LEVEL) / 2.0, 1.0 - (1.0 - LEVEL) / 2.0]


@dataclass(frozen=True)
class Interval:
    """A percentile interval of the stated level."""

    low: float
    high: float
    level: float = LEVEL


def interval_of(draws: FloatArray) -> Interval:
    """The percentile interval of resamples, shape (R,), without those that are NaN."""
    low, high = np.nanquantile(draws, _TAILS)
    return Interval(float(low), float(high))


def decorrelation_lag(error: FloatArray) -> int:
    """Samples over which an error or its square hangs together: the first lag with an autocorrelation under 1/e.

    Parameters
    ----------
    error : FloatArray, shape (N,)
        NaN where masked.

    Returns
    -------
    int
        One at least, and N where no lag is that low; of a constant error one. Cost: O(N log N).
    """
    return max(_first_low_lag(error), _first_low_lag(np.square(error)))


def _first_low_lag(series: FloatArray) -> int:
    finite = np.isfinite(series)
    if not finite.any():
        return 1
    rest = np.where(finite, series - np.mean(series[finite]), 0.0)
    sums, pairs = (
        np.fft.irfft(np.square(np.abs(np.fft.rfft(each, 2 * each.size))))[: each.size]
        for each in (rest, finite.astype(np.float64))
    )
    scatter = sums / np.maximum(np.round(pairs), 1.0)
    low = np.flatnonzero(scatter <= scatter[0] / np.e)
    return max(1, int(low[0]) if low.size else series.size)


def block_of(errors: Sequence[FloatArray], interval: float, plant: Device | None) -> int:
    """Block length [samples] for error series that are resampled at the same blocks.

    That of the joint is known, `BLOCK`. Other devices are slower or faster by orders of magnitude. A block is then
    `MEMORIES` times the longest correlation time of the errors, but at least `BLOCK` and at most an eighth of the log.
    Where the log cuts it, the interval is too narrow still.

    Parameters
    ----------
    errors : sequence of FloatArray, shape (N,)
        Calculated minus measured; NaN where masked.
    interval : float
        Sample interval [s].
    plant : Device or None
        None where nothing is known of it.
    """
    shortest = samples_of(BLOCK, interval)
    if plant is not None and plant.joint:
        return shortest
    block = max([shortest, *(MEMORIES * decorrelation_lag(error) for error in errors)])
    samples = min((int(np.count_nonzero(np.isfinite(error))) for error in errors), default=0)
    return block if samples < FEWEST_BLOCKS else min(block, samples // FEWEST_BLOCKS)


def block_means(squares: FloatArray, block: int, rng: np.random.Generator) -> FloatArray:
    """Means of moving-block resamples of a series (Künsch 1989, doi:10.1214/aos/1176347265), circular.

    Each resample joins blocks of `block` neighbours, drawn with replacement from all positions, up to the length of
    the series. Blocks wrap from the end to the start (Politis & Romano 1992). Else the last seconds would be drawn too
    seldom, in which a run that has gone wrong errs most.

    Parameters
    ----------
    squares : FloatArray, shape (N,)
        The series, here squared errors; NaN rows (masked) count in no mean.
    block : int
        Block length in samples; cut to N.
    rng : numpy.random.Generator
        Source of the block positions.

    Returns
    -------
    FloatArray, shape (RESAMPLES,)
        NaN for a resample that hit masked rows only.
        Cost: O(N + RESAMPLES·N/block) by prefix sums.
    """
    n = squares.size
    block = max(1, min(block, n))
    wrapped = np.concatenate([squares, squares[: block - 1]])
    finite = np.isfinite(wrapped)
    sums = np.concatenate([[0.0], np.cumsum(np.where(finite, wrapped, 0.0))])
    counts = np.concatenate([[0], np.cumsum(finite)])
    starts = rng.integers(n, size=(RESAMPLES, -(-n // block)))
    total = (sums[starts + block] - sums[starts]).sum(axis=1)
    size = (counts[starts + block] - counts[starts]).sum(axis=1)
    return np.asarray(np.divide(total, size, out=np.full(RESAMPLES, np.nan), where=size > 0))


def rms_interval(error: FloatArray, block: int, rng: np.random.Generator) -> Interval | None:
    """Percentile interval of the RMS of an error series with NaN at masked rows.

    Parameters
    ----------
    error : FloatArray, shape (N,)
        Calculated minus measured.
    block : int
        Block length in samples.
    rng : numpy.random.Generator
        Source of the block positions.

    Returns
    -------
    Interval or None
        In the unit of `error`; None with fewer than three blocks in the series, where there is no bootstrap.
    """
    means = mean_interval(np.square(error), block, rng)
    return None if means is None else Interval(float(np.sqrt(means.low)), float(np.sqrt(means.high)))


def mean_interval(values: FloatArray, block: int, rng: np.random.Generator) -> Interval | None:
    """Percentile interval of the mean of a series with NaN at masked rows; parameters and None as in `rms_interval`."""
    if np.count_nonzero(np.isfinite(values)) < 3 * block:
        return None
    return interval_of(block_means(values, block, rng))


def rms_difference_interval(
    error: FloatArray, other: FloatArray, block: int, rng: np.random.Generator
) -> Interval | None:
    """Percentile interval of RMS(error) − RMS(other), both resampled at the same blocks.

    Two models err at the same switches, so their RMS move together; the paired difference sees through that, the
    comparison of two separate intervals does not. Parameters and None as in `rms_interval`; the series are equally
    long and masked at the same rows.

    Parameters
    ----------
    error, other : FloatArray, shape (N,)
        Errors of the two models, NaN where masked.
    block : int
        Length of a block in samples.
    rng : numpy.random.Generator
        Draws the blocks.
    """
    if np.count_nonzero(np.isfinite(error)) < 3 * block:
        return None
    state = int(rng.integers(2**32))
    roots = [np.sqrt(block_means(np.square(e), block, np.random.default_rng(state))) for e in (error, other)]
    return interval_of(roots[0] - roots[1])


def share_interval(right: int, events: int) -> Interval | None:
    """Interval of the share `right`/`events` by the Bayesian bootstrap of the events.

    Resampling 14 pulses that are all right gives 14 of 14 every time, an interval without width. The Bayesian bootstrap
    (Rubin 1981, doi:10.1214/aos/1176345338) with half an event of either outcome added is the interval of Jeffreys,
    Beta(right + ½, wrong + ½). That covers well from a few events on (Brown, Cai & DasGupta 2001,
    doi:10.1214/ss/1009213286). As there, it reaches 0 where nothing was right and 1 where everything was.

    Parameters
    ----------
    right, events : int
        Events that came out right, and all.

    Returns
    -------
    Interval or None
        As shares; None without events.
    """
    from scipy.special import betaincinv

    if events == 0:
        return None
    low, high = betaincinv(right + 0.5, events - right + 0.5, _TAILS)
    return Interval(0.0 if right == 0 else float(low), 1.0 if right == events else float(high))


def excess_over_lowest(errors: Mapping[str, FloatArray], interval: float, plant: Device) -> dict[str, Interval | None]:
    """Paired bootstrap intervals of each model's RMS error less that of the model with the lowest.

    If an interval reaches zero, the record does not distinguish the model from the lowest. The lowest is chosen on
    the same record, so a lead that just excludes zero deserves the doubt of any choice among several.

    Parameters
    ----------
    errors : mapping of model to FloatArray, shape (N,)
        Calculated minus measured; NaN where masked, the same rows for all.
    interval, plant
        As in `block_of`; each model and the lowest have a block of their own.

    Returns
    -------
    mapping of model to Interval or None
        Of all models but the lowest; None for a record of less than three blocks. Empty for fewer than two models.
        Cost: one bootstrap of two series per model.
    """
    if len(errors) < 2:
        return {}
    squares = {model: float(np.nanmean(np.square(error))) for model, error in errors.items()}
    lowest = min(squares, key=squares.__getitem__)
    best = errors[lowest]
    return {
        model: rms_difference_interval(
            error, best, block_of((error, best), interval, plant), np.random.default_rng(SEED)
        )
        for model, error in errors.items()
        if model != lowest
    }
