"""The quality of one measured signal: rails, hum, spikes, frozen stretches, noise, and the size of its numbers."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.numerics.sampling.timebase import LOCATED

MAINS = (50.0, 60.0)
"""Mains frequencies [Hz] at which hum is looked for."""
_RAIL_RUN = 3
_SPIKE_NOISES = 12.0
_IDLE_NOISES = 12.0
_SECOND_DIFFERENCE_MEDIAN = 0.6745 * 2.449489742783178
_HUM_WINDOW = 4.0
_HUM_BAND = 8.0
_NOISE_BLOCKS, _NOISE_BLOCK = 64, 4096
_EXCERPT = 1 << 21
# Spans (largest minus smallest value) that a joint's signals have, by SI unit, with room on both sides.
_PLAUSIBLE_SPANS = {"m": (1e-5, 0.5), "rad": (1e-3, 20.0), "V": (0.5, 5e4)}


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


@dataclass(frozen=True)
class SignalQuality:
    """What one signal looks like, in its own unit; times in s.

    Attributes
    ----------
    n, not_finite : int
        Samples, and how many of them are NaN or infinite.
    not_finite_at : tuple of float
        Where, the first `LOCATED` of them.
    smallest, largest, mean : float
        Of the finite samples.
    noise : float
        Standard deviation of the white noise in it, from the median of second differences.
    low_rail, high_rail : float
        Share of the samples that stay at the smallest, at the largest value for three samples or more.
    longest_frozen : float
        Duration of the longest run of one and the same value [s].
    frozen_at : float
        Where that run starts [s].
    spikes : int
        Single samples that leave the line between their neighbours by more than 12 times the noise.
    spikes_at : tuple of float
        Where, the first `LOCATED` of them.
    hum : tuple of Hum
        Mains lines, as far as the sampling rate and the duration allow.
    """

    n: int
    not_finite: int
    not_finite_at: tuple[float, ...]
    smallest: float
    largest: float
    mean: float
    noise: float
    low_rail: float
    high_rail: float
    longest_frozen: float
    frozen_at: float
    spikes: int
    spikes_at: tuple[float, ...]
    hum: tuple[Hum, ...]

    @property
    def constant(self) -> bool:
        """Whether all finite samples are equal."""
        return self.smallest == self.largest

    @property
    def idle(self) -> bool:
        """Whether nothing but noise happens: the span is that of 10⁶ normal samples, or smaller."""
        return self.largest - self.smallest <= _IDLE_NOISES * self.noise


def examine_signal(time: FloatArray, samples: FloatArray, step: float) -> SignalQuality:
    """Describe one signal.

    Parameters
    ----------
    time : FloatArray, shape (N,)
        Time stamps [s], only used to locate what is found.
    samples : FloatArray, shape (N,)
        The signal; NaN and infinities allowed.
    step : float
        Nominal sampling step [s].

    Returns
    -------
    SignalQuality
        With NaN extremes where no sample is finite.

    Notes
    -----
    Cost: some ten passes over the samples; the hum's spectrum is taken of at most 2²¹ samples.
    """
    finite = np.isfinite(samples)
    bad = np.flatnonzero(~finite)
    stamps, values = (time, samples) if bad.size == 0 else (time[finite], samples[finite])
    if values.size == 0:
        nan = float("nan")
        located = tuple(time[bad[:LOCATED]].tolist())
        return SignalQuality(samples.size, bad.size, located, nan, nan, nan, nan, 0.0, 0.0, 0.0, nan, 0, (), ())
    smallest, largest, noise = float(values.min()), float(values.max()), noise_level(values)
    frozen, start = _longest_run(values)
    spikes = np.flatnonzero(_spikes(values, noise)) + 1
    return SignalQuality(
        n=samples.size,
        not_finite=bad.size,
        not_finite_at=tuple(time[bad[:LOCATED]].tolist()),
        smallest=smallest,
        largest=largest,
        mean=float(values.mean()),
        noise=noise,
        low_rail=_rail_share(values == smallest),
        high_rail=_rail_share(values == largest),
        longest_frozen=float(stamps[start + frozen - 1] - stamps[start]),
        frozen_at=float(stamps[start]),
        spikes=spikes.size,
        spikes_at=tuple(stamps[spikes[:LOCATED]].tolist()),
        hum=tuple(line for f in MAINS if (line := hum(values, step, f)) is not None),
    )


def noise_level(samples: FloatArray) -> float:
    """Standard deviation of white noise on a smooth signal, robust against steps and spikes.

    The second difference of white noise has √6 times its standard deviation; the median of its magnitude is
    0.6745 of that for a normal distribution. Where more than half of the second differences vanish (a coarsely
    quantised signal), their root mean square below the 90th percentile is taken.
    """
    if samples.size < 3:
        return 0.0
    if samples.size > _NOISE_BLOCKS * _NOISE_BLOCK:
        starts = np.linspace(0, samples.size - _NOISE_BLOCK, _NOISE_BLOCKS).astype(np.int64)
        second = np.concatenate([np.diff(samples[i : i + _NOISE_BLOCK], 2) for i in starts])
    else:
        second = np.diff(samples, 2)
    magnitude = np.abs(second)
    middle = float(np.median(magnitude))
    if middle > 0.0:
        return middle / _SECOND_DIFFERENCE_MEDIAN
    usual = magnitude[magnitude <= np.quantile(magnitude, 0.9)]
    return float(np.sqrt(np.mean(usual**2) / 6.0))


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
    power = _spectrum(samples[:_EXCERPT], size)
    resolution = 1.0 / (size * step)
    offset = np.abs(np.fft.rfftfreq(size, step) - frequency)
    line = offset <= 0.2 + 2.0 * resolution
    beside = (offset <= _HUM_BAND) & ~line
    # The mean of the logarithms' exponential is taken low by a few other lines; the median is not.
    floor = float(np.median(power[beside])) * int(line.sum())
    total = float(power[line].sum())
    if floor <= 0.0:
        return None
    return Hum(frequency, 10.0 * float(np.log10(total / floor)), float(np.sqrt(2.0 * max(total - floor, 0.0))))


def scale_suspicion(span: float, symbol: str) -> float | None:
    """By what factor numbers look too large, if a unit prefix seems to be wrong.

    Parameters
    ----------
    span : float
        Largest minus smallest value, in SI.
    symbol : str
        SI unit of the values.

    Returns
    -------
    float or None
        1000.0: looks 1000 times too large; 0.001: 1000 times too small, and so on; None where the span is
        plausible, zero, or the unit is not one with known spans.
    """
    low, high = _PLAUSIBLE_SPANS.get(symbol, (0.0, np.inf))
    if not np.isfinite(span) or span <= 0.0 or low <= span <= high:
        return None
    factor = 1000.0 if span > high else 0.001
    while not low <= span / factor <= high and 1e-9 < factor < 1e9:
        factor *= 1000.0 if span > high else 0.001
    return factor


def _spectrum(samples: FloatArray, size: int) -> FloatArray:
    """Mean power of each frequency bin, one-sided, scaled so that the bins of a line sum to its mean square."""
    window = np.hanning(size + 1)[:-1]
    power = np.zeros(size // 2 + 1)
    starts = range(0, samples.size - size + 1, size // 2)
    for i in starts:
        part = samples[i : i + size]
        power += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
    result: FloatArray = power * (2.0 / (len(starts) * size * np.sum(window**2)))
    return result


def _spikes(values: FloatArray, noise: float) -> BoolArray:
    """Single samples far off the line between neighbours that agree with each other, shape (N − 2,)."""
    off = np.abs(values[1:-1] - 0.5 * (values[:-2] + values[2:]))
    apart = np.abs(values[2:] - values[:-2])
    spikes: BoolArray = (off > _SPIKE_NOISES * noise) & (off > 4.0 * apart) & (noise > 0.0)
    return spikes


def _rail_share(at_rail: BoolArray) -> float:
    """Share of the samples in runs of at least `_RAIL_RUN` True."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], at_rail.astype(np.int8), [0]))))
    lengths = edges[1::2] - edges[::2]
    return float(lengths[lengths >= _RAIL_RUN].sum() / at_rail.size)


def _longest_run(values: FloatArray) -> tuple[int, int]:
    """Length and first index of the longest run of equal values."""
    edges = np.concatenate(([0], np.flatnonzero(np.diff(values) != 0.0) + 1, [values.size]))
    lengths = np.diff(edges)
    longest = int(np.argmax(lengths))
    return int(lengths[longest]), int(edges[longest])
