"""Intervals of measures that stand on few events, such as the pulses or the switches of a record."""

from collections.abc import Sequence

import numpy as np
import scipy.special

from pipeline.scoring.moving_blocks import LEVEL, RESAMPLES, Interval

FEWEST = 4  # events; a median of fewer has no spread worth printing


def share_interval(right: int, events: int, *, level: float = LEVEL) -> Interval | None:
    """Interval of the share `right`/`events` by the Bayesian bootstrap of the events.

    Resampling 14 pulses that are all right gives 14 of 14 every time, an interval without width. The Bayesian bootstrap
    (Rubin 1981, doi:10.1214/aos/1176345338) with half an event of either outcome added is the interval of Jeffreys,
    Beta(right + ½, wrong + ½), which covers well from a few events on (Brown, Cai & DasGupta 2001,
    doi:10.1214/ss/1009213286). As there, it reaches 0 where nothing was right and 1 where everything was.

    Parameters
    ----------
    right, events : int
        Events that came out right, and all.
    level : float
        Coverage aimed at.

    Returns
    -------
    Interval or None
        As shares; None without events.
    """
    if events == 0:
        return None
    tail = (1.0 - level) / 2.0
    low, high = scipy.special.betaincinv(right + 0.5, events - right + 0.5, [tail, 1.0 - tail])
    return Interval(0.0 if right == 0 else float(low), 1.0 if right == events else float(high), level)


def median_interval(
    values: Sequence[float], rng: np.random.Generator, *, level: float = LEVEL, resamples: int = RESAMPLES
) -> Interval | None:
    """Percentile interval of the median of independent events; None with fewer than `FEWEST`.

    Parameters
    ----------
    values : sequence of float, length n
        One value per event.
    rng : numpy.random.Generator
        Draws the resamples.
    level : float
        Coverage aimed at.
    resamples : int
        Number of resamples. Cost: O(n · resamples).
    """
    if len(values) < FEWEST:
        return None
    draws = rng.choice(np.asarray(values), size=(resamples, len(values)))
    tail = (1.0 - level) / 2.0
    low, high = np.quantile(np.median(draws, axis=1), [tail, 1.0 - tail])
    return Interval(float(low), float(high), level)
