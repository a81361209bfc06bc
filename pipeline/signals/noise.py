"""The noise of a record, estimated from the record alone."""

import math

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.metrics import robust_std
from .columns import CHUNK, differences

CHANCE = 0.01
"""Significance level of every test on a signal or a clock."""
REACH = 6.0
"""Standard deviations that none of 10⁶ normal samples exceeds, at that level."""
SELDOM = 0.01
"""Largest share of a signal that single faults are; what is more frequent is the signal."""
_SPACINGS = (1, 2)
_ORDERS = (4, 6)
_MOST_MOVING = 0.9
"""Share of the steps that are not zero, beyond which a quantiser does not show."""
_BALANCED = 0.25
"""Least share of the time that a signal of two values spends at either, so that it switches and does not flicker."""
_RESOLUTION = 1e-12
"""Share of the range of a record, or of its largest difference, below which a difference is only rounding."""


def white_noise(samples: FloatArray) -> float:
    """Standard deviation of the white noise on a smooth signal, as far as a quantiser does not hide it [signal].

    The median modulus of a high difference shows the noise and ignores rare events, such as the edges of a ring-down.
    The smallest of several differences is taken: order 6 lets less of the signal through than order 4, and
    between samples two apart the estimate is made at a quarter of the sampling rate, where an anti-alias
    filter has not yet taken the noise away. Cost: that of blocks, however long the signal is.
    """
    estimates = [
        robust_std(differences(samples, order, spacing)) / math.sqrt(math.comb(2 * order, order))
        for spacing in _SPACINGS
        for order in _ORDERS
        if samples.size > 2 * spacing * order
    ]
    return min(estimates, default=0.0)


def noise_std(samples: FloatArray) -> float:
    """Standard deviation of the noise on a smooth signal, with that of its quantiser [signal].

    A quantised signal at rest has differences of zero, and then the step of the quantiser over sqrt(12) is the
    estimate.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Uniformly sampled record, N ≥ 1.

    Returns
    -------
    float
        Zero if and only if the record is constant.
    """
    least = _RESOLUTION * float(np.ptp(samples))
    steps = np.abs(differences(samples))
    moving = steps[steps > least]
    quantised = 0 < moving.size <= _MOST_MOVING * steps.size
    return max(white_noise(samples), rounding(float(moving.min()) if quantised else None), least)


def noise_level(samples: FloatArray) -> float:
    """As `white_noise`, 0 for the steps of a command, which would make all of it noise."""
    level = white_noise(samples)
    is_command = level > 0.0 and float(np.ptp(samples)) <= 2.0 * REACH * level and is_stepped(samples)
    return 0.0 if is_command else level


def is_idle(samples: FloatArray) -> bool:
    """Whether finite samples show only noise: they span what 10⁶ normal ones do or less, and are no command."""
    return float(np.ptp(samples)) <= 2.0 * REACH * noise_std(samples) and not is_stepped(samples)


def rounding(resolution: float | None) -> float:
    """Standard deviation of what a sensor with such steps rounds off, 0 without steps [signal]."""
    return (resolution or 0.0) / math.sqrt(12.0)


def below_resolution(noise: float, resolution: float | None) -> bool:
    """Whether a sensor's steps hide its noise, so that its samples say nothing of it."""
    return noise < rounding(resolution)


def mostly_repeated(values: FloatArray) -> bool:
    """Whether a value occurs twice on average, or more often."""
    return 2 * int(np.unique(values).size) <= values.size


def resolution(samples: FloatArray) -> float | None:
    """Step of the converter that made these samples: the least distance of two different values.

    None in numbers without steps, where most values occur once and do not lie on a grid, or where all are equal. The
    first 2¹⁷ samples count.
    """
    finite = _excerpt(samples)
    values = np.unique(finite)
    if values.size < 2:
        return None
    apart = np.diff(values)
    least = float(apart[apart > _RESOLUTION * (values[-1] - values[0])].min())
    if mostly_repeated(finite):
        return least
    step = float((values[-1] - values[0]) / np.sum(np.round(apart / least)))  # a log rounds the steps of its sensor
    steps = apart / step
    off = 2.0 * float(np.max(np.abs(steps - np.round(steps))))  # at random it is uniform from 0 to 1
    return step if off**steps.size < CHANCE else None


def is_stepped(samples: FloatArray) -> bool:
    """Whether a signal stands still between its steps, as a command does: a PRBS, pulses, steps of any height.

    Three quarters of its values are held for two samples or more; noise and a converter's flicker are not. A signal of
    two values that spends a quarter of the time at either is one too. The first 2¹⁷ samples count.
    """
    values = _excerpt(samples)
    if values.size < 2:
        return False
    equal = _RESOLUTION * float(np.ptp(values))  # interpolation rounds
    runs = np.diff(np.flatnonzero(~(np.abs(np.diff(values, prepend=np.nan, append=np.nan)) <= equal)))
    if runs.size < 2 or np.quantile(runs, 0.25) >= 2.0:
        return runs.size > 1
    high = np.count_nonzero(values >= values.max() - equal)
    of_two = high + np.count_nonzero(values <= values.min() + equal) == values.size
    return of_two and bool(_BALANCED <= high / values.size <= 1.0 - _BALANCED)


def _excerpt(samples: FloatArray) -> FloatArray:
    """The finite ones of the first 2¹⁷ samples."""
    first = samples[:CHUNK]
    finite: FloatArray = first[np.isfinite(first)]
    return finite


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
