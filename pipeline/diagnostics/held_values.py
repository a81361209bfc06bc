"""For how many samples a log keeps each value of a signal: a sensor or a bus that is slower than the recorder."""

import numpy as np

from ..numerics.arrays import FloatArray
from ..signals.columns import CHUNK

_FEWEST = 100
"""Changes that show how far apart they are."""
_SELDOM = 0.05
"""Share of the changes that may follow each other sooner, as beside a repaired gap."""


def held_samples(samples: FloatArray, resolution: float | None) -> int:
    """Samples between changes of a signal by more than a step of its converter; 1 where there are few changes.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Raw samples; the first 2²¹ that are finite count.
    resolution : float or None
        Step of the converter [signal], where there is one.
    """
    values = samples[: 16 * CHUNK]
    values = values[np.isfinite(values)]
    changes = np.flatnonzero(np.abs(np.diff(values)) > 1.5 * (resolution or 0.0))
    if changes.size < _FEWEST:
        return 1
    return int(np.quantile(np.diff(changes), _SELDOM))
