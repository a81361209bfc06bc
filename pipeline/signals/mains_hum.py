"""Mains hum in a signal: a line in its spectrum."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray

MAINS = (50.0, 60.0)
"""Mains frequencies [Hz] at which hum is looked for."""
_HUM_WINDOW = 4.0
_HUM_BAND = 8.0
_STANDS_OUT = 10.0
"""Decibels over the spectrum beside it from which on a line is told."""
EXCERPT = 1 << 21
"""Samples of which a spectrum is taken at most."""


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
    power = _spectrum(samples[:EXCERPT], size)
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


def aliased(frequency: float, step: float) -> float:
    """Where a line [Hz] appears in samples that are a step [s] apart."""
    turns = frequency * step
    return abs(turns - round(turns)) / step


def _spectrum(samples: FloatArray, size: int) -> FloatArray:
    """Mean power of each frequency bin, one-sided, scaled so that the bins of a line sum to its mean square.

    Welch's average, as `scipy.signal.welch` makes it: to load that takes longer than to look at a log.
    """
    window = np.hanning(size + 1)[:-1]
    power = np.zeros(size // 2 + 1)
    starts = range(0, samples.size - size + 1, size // 2)
    for i in starts:
        part = samples[i : i + size]
        power += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
    result: FloatArray = power * (2.0 / (len(starts) * size * np.sum(window**2)))
    return result
