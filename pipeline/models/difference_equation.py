"""What models share that step from sample to sample: their free run, and the sample interval that they need."""

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray, sample_interval
from ..numerics.fixed_step import run_status
from ..numerics.linear_filters import finite_difference
from .base import FreeRun


def sampled_run(t: FloatArray, q: FloatArray, reached: int, interval: float) -> FreeRun:
    """A free run from its displacement at the samples; q̇ and q̈ are differences of sixth order.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Time [s] and displacement [m], NaN after a divergence.
    reached : int
        Samples within the bounds.
    interval : float
        Sample interval [s] of the model.
    """
    qdot, qddot = np.full((2, q.size), np.nan)
    qdot[:reached] = finite_difference(q[:reached], interval, 1)
    qddot[:reached] = finite_difference(q[:reached], interval, 2)
    return FreeRun(t, q, qdot, qddot, *run_status(t, reached))


def check_interval(t: FloatArray, interval: float, name: str) -> None:
    """Refuse a record whose sample interval differs by more than a thousandth from that of a model [s].

    Raises
    ------
    InputError
        It does.
    """
    given = sample_interval(t)
    if abs(given / interval - 1.0) > 1e-3:
        raise InputError(f"the model {name} steps at {interval:g} s, the record at {given:g} s; resample the log")
