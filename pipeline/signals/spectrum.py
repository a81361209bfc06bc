"""Spectra of a signal: how fast it moves, and how strongly mains hum shows in it."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..numerics.arrays import FloatArray
from .columns import BLOCKS, CHUNK
from .noise import REACH, noise_level

LEAST_PER_PERIOD = 5.0
"""Samples in a period of what moves, below which a record hardly shows it."""
ADVISED_PER_PERIOD = 8.0
"""The same for an advised interval."""
LOST_PER_PERIOD = 10.0 / 3.0
"""The same, below which decimation takes most of it: the kernel lets a third of its power pass."""
_NEARLY_ALL = 0.99
_WINDOW = 1 << 14


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
    if size < 2:
        return Bandwidth(np.nan, np.nan)
    below: FloatArray = np.cumsum(np.maximum(_spectrum(samples, size) - 2.0 * noise**2 / size, 0.0))
    if not below[-1] > 0.0:
        return Bandwidth(np.nan, np.nan)
    half, most = np.searchsorted(below, below[-1] * np.array([0.5, _NEARLY_ALL])) / (size * step)
    return Bandwidth(float(half), float(most))


def advised_interval(most: float, step: float) -> float:
    """Sample interval [s] for a signal that moves up to `most` [Hz] and was recorded with the step [s]."""
    return float(f"{max(1.0 / (ADVISED_PER_PERIOD * most), step):.4g}")


MAINS = (50.0, 60.0)
"""Mains frequencies [Hz] at which hum is looked for."""
_HUM_WINDOW = 4.0
_HUM_BAND = 8.0
_STANDS_OUT = 10.0
"""Decibels over the spectrum beside it above which a line is reported."""


@dataclass(frozen=True)
class Hum:
    """A mains line in a spectrum.

    Attributes
    ----------
    frequency : float
        Mains frequency [Hz].
    above_floor_db : float
        Power in the line's band over the power that the spectrum beside it would put there [dB].
    amplitude : float
        Amplitude of the line in the signal's unit, 0 where it does not rise over the floor.
    """

    frequency: float
    above_floor_db: float
    amplitude: float

    @property
    def stands_out(self) -> bool:
        """Whether the line is clearly over the spectrum beside it."""
        return self.above_floor_db > _STANDS_OUT


def hum(samples: FloatArray, step: float, frequency: float) -> Hum | None:
    """Mains hum from an averaged spectrum (Hann windows of 4 s, half overlapping).

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Finite samples, taken as uniform.
    step : float
        Sampling step [s].
    frequency : float
        Mains frequency [Hz]; the grid's drift of ±0.2 Hz is allowed for.

    Returns
    -------
    Hum or None
        None where the line or the floor beside it lies beyond the Nyquist frequency, or the record is shorter
        than two windows.
    """
    size = round(_HUM_WINDOW / step)
    if frequency + _HUM_BAND > 0.5 / step or samples.size < 2 * size:
        return None
    power = _spectrum(samples, size)
    bin_width = 1.0 / (size * step)
    offset = np.abs(np.fft.rfftfreq(size, step) - frequency)
    line = offset <= 0.2 + 2.0 * bin_width
    beside = (offset <= _HUM_BAND) & ~line
    # The mean of the logarithms' exponential is taken low by a few other lines; the median is not.
    floor = float(np.median(power[beside])) * int(line.sum())
    total = float(power[line].sum())
    if floor <= 0.0:
        return None
    return Hum(frequency, 10.0 * float(np.log10(total / floor)), float(np.sqrt(2.0 * max(total - floor, 0.0))))


def mains_at_another_rate(samples: FloatArray, step: float) -> tuple[Hum, float] | None:
    """A line where mains hum is if the clock is wrong by a factor of two, and the factor that puts its rate right.

    None where hum is in its place, or there is none. A line at 100 or 120 Hz may also be that of a rectifier. Steps of
    the signal, which have power at all frequencies, are left out: what counts are the differences that noise reaches.
    """
    steps = np.diff(samples[: BLOCKS * CHUNK])
    quiet = np.where(np.abs(steps) <= 2.0 * REACH * noise_level(samples), steps, 0.0)
    lines = [hum(quiet, step, frequency) for frequency in MAINS]
    if any(line is not None and line.stands_out for line in lines):
        return None
    for factor in (2.0, 0.5):
        for frequency in MAINS:
            line = hum(quiet, step, frequency / factor)
            if line is not None and line.stands_out:
                return line, factor
    return None


def aliased(frequency: float, step: float) -> float:
    """Where a line [Hz] appears in samples that are a step [s] apart."""
    turns = frequency * step
    return abs(turns - round(turns)) / step


def _spectrum(samples: FloatArray, size: int) -> FloatArray:
    """Mean power of each frequency bin, one-sided, scaled so that the bins of a line sum to its mean square.

    Welch's average of at most 64 windows that are spread over the signal.
    """
    window = np.hanning(size + 1)[:-1]
    power = np.zeros(size // 2 + 1)
    windows = min(BLOCKS, 2 * samples.size // size - 1)
    starts = np.linspace(0, samples.size - size, windows).astype(np.int64).tolist()
    for i in starts:
        part = samples[i : i + size]
        power += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
    return np.asarray(power * (2.0 / (len(starts) * size * np.sum(window**2))))
