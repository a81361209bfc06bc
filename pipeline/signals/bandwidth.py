"""How fast a signal moves: the frequencies below which half and nearly all of its power lie."""

from typing import NamedTuple

import numpy as np

from pipeline.numerics.arrays import FloatArray

LEAST_PER_PERIOD = 5.0
"""Samples in a period of what moves, below which a record hardly shows it."""
ADVISED_PER_PERIOD = 8.0
"""The same of an interval that is advised."""
LOST_PER_PERIOD = 10.0 / 3.0
"""The same, below which decimation takes most of it: the kernel lets a third of its power pass."""
_NEARLY_ALL = 0.99
_WINDOW, _WINDOWS, _FEWEST = 1 << 14, 64, 32


class Bandwidth(NamedTuple):
    """Frequencies [Hz] below which half and 99 % of the power of a signal lie.

    Its mean and the floor of white noise are left out; NaN where nothing is left, or too few samples are given.
    """

    half: float
    most: float


def bandwidth(samples: FloatArray, step: float, noise: float) -> Bandwidth:
    """How fast a signal moves.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Finite samples, taken as uniform.
    step : float
        Sampling step [s].
    noise : float
        Standard deviation of the white noise in them.

    Notes
    -----
    Cost: the spectra of at most 64 windows of 2¹⁴ samples, spread over the signal: 6 ms of 10⁶ samples.
    """
    size = min(samples.size, _WINDOW)
    if size < _FEWEST:
        return Bandwidth(np.nan, np.nan)
    window, power = np.hanning(size), np.zeros(size // 2 + 1)
    windows = min(_WINDOWS, 2 * samples.size // size - 1)
    starts = np.linspace(0, samples.size - size, windows).astype(np.int64).tolist()
    for start in starts:
        part = samples[start : start + size]
        power += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
    floor = noise**2 * float(np.sum(window**2)) * len(starts)
    below: FloatArray = np.cumsum(np.maximum(power - floor, 0.0))
    if not below[-1] > 0.0:
        return Bandwidth(np.nan, np.nan)
    half, most = np.searchsorted(below, below[-1] * np.array([0.5, _NEARLY_ALL])) / (size * step)
    return Bandwidth(float(half), float(most))


def advised_interval(most: float, step: float) -> float:
    """Sample interval [s] for a signal that moves up to `most` [Hz] and was recorded with the step [s]."""
    return float(f"{max(1.0 / (ADVISED_PER_PERIOD * most), step):.4g}")
