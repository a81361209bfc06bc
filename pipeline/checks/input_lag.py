"""Whether what a log shows is a lag of its inputs, not a delay: electrodes that charge slowly, a slow drive."""

from dataclasses import replace

import numpy as np

from pipeline.checks.weak_form import LogSignals, WeakTerms, under_inputs, unexplained
from pipeline.numerics.arrays import samples_of
from pipeline.numerics.linear_filters import first_order_lag

LAGS = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0)
"""Time constants that are tried, in sample intervals of the identification."""
SURELY = 0.93
"""Residual under the best lag over that under the best delay, up to which it is a lag. Ten simulated joints whose
recorders began 40 ms apart have 0.96 to 1.48, six whose electrodes charge with 40 ms 0.77 to 0.91."""


def input_lag(log: LogSignals, terms: WeakTerms, sample_interval: float, reach: int, *, squared: bool) -> float | None:
    """Time constant [s] of a lag of all inputs that explains the accelerations surely better than one delay of them.

    Parameters
    ----------
    log : LogSignals
        The log.
    terms : WeakTerms
        Its terms.
    sample_interval : float
        Of the identification [s].
    reach : int
        Largest delay that is tried, in sample intervals.
    squared : bool
        Whether inputs act by their squares.

    Returns
    -------
    float or None
        None where a delay does as well. Cost: 0.1 s for 40,000 samples, nearly all of it the terms behind each lag.
    """
    step = samples_of(sample_interval, terms.interval)
    count = terms.push.shape[1]
    late = min(unexplained(terms, step * intervals * np.ones(count, dtype=np.int64)) for intervals in range(reach + 1))
    residuals = np.array([_behind(log, terms, lag * sample_interval, sample_interval, squared=squared) for lag in LAGS])
    return LAGS[int(np.argmin(residuals))] * sample_interval if residuals.min() < SURELY * late else None


def _behind(log: LogSignals, terms: WeakTerms, lag: float, sample_interval: float, *, squared: bool) -> float:
    """The residual with inputs behind a lag [s]."""
    v = np.column_stack([first_order_lag(np.ascontiguousarray(column), log.interval, lag)[0] for column in log.v.T])
    return unexplained(under_inputs(terms, replace(log, v=v), sample_interval, squared=squared))
