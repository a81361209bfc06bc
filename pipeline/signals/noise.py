"""The noise of a record and its spectrum: how fast it moves, and how strongly mains hum shows in it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.metrics import robust_std
from .columns import BLOCKS, CHUNK, differences

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
_FEWEST = 100
"""Changes that show how far apart they are."""
_SELDOM = 0.05
"""Share of the changes that may follow each other sooner, as beside a repaired gap."""
LEAST_PER_PERIOD = 5.0
"""Samples in a period of what moves, below which a record hardly shows it."""
ADVISED_PER_PERIOD = 8.0
"""The same for an advised interval."""
LOST_PER_PERIOD = 10.0 / 3.0
"""The same, below which decimation takes most of it: the kernel lets a third of its power pass."""
_NEARLY_ALL = 0.99
_WINDOW = 1 << 14
MAINS = (50.0, 60.0)
"""Mains frequencies [Hz] at which hum is looked for."""
_HUM_WINDOW = 4.0
_HUM_BAND = 8.0
_STANDS_OUT = 10.0
"""Decibels over the spectrum beside it above which a line is reported."""


def white_noise(samples: FloatArray) -> float:
    """Standard deviation of the white noise on a smooth signal, as far as a quantiser does not hide it [signal].

    The median modulus of a high difference shows the noise and ignores rare events, such as the edges of a ring-down.
    The smallest of several differences is taken. Order 6 lets less of the signal through than order 4. Between samples
    two apart the estimate is made at a quarter of the sampling rate, where an anti-alias filter has not yet taken the
    noise away. Cost: that of blocks, however long the signal is.
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
    resolution = float(moving.min()) if 0 < moving.size <= _MOST_MOVING * steps.size else None
    return max(white_noise(samples), rounding(resolution), least)


def noise_level(samples: FloatArray) -> float:
    """Noise as by `white_noise`, 0 for the steps of a command, which would make all of it noise."""
    level = white_noise(samples)
    is_command = level > 0.0 and float(np.ptp(samples)) <= 2.0 * REACH * level and is_stepped(samples)
    return 0.0 if is_command else level


def is_idle(samples: FloatArray) -> bool:
    """True if finite samples are only noise: they span no more than 10⁶ normal ones, and are no command."""
    return float(np.ptp(samples)) <= 2.0 * REACH * noise_std(samples) and not is_stepped(samples)


def rounding(resolution: float | None) -> float:
    """Standard deviation of what a sensor with such steps rounds off, 0 without steps [signal]."""
    return (resolution or 0.0) / math.sqrt(12.0)


def below_resolution(noise: float, resolution: float | None) -> bool:
    """True if a sensor's steps hide its noise, so that it cannot be estimated from the samples."""
    return noise < rounding(resolution)


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
    if 2 * values.size <= finite.size:  # a value occurs twice on average, or more often
        return least
    step = float((values[-1] - values[0]) / np.sum(np.round(apart / least)))  # a log rounds the steps of its sensor
    steps = apart / step
    off = 2.0 * float(np.max(np.abs(steps - np.round(steps))))  # at random it is uniform from 0 to 1
    return step if off**steps.size < CHANCE else None


def is_stepped(samples: FloatArray) -> bool:
    """True if a signal stands still between its steps, as a command does: a PRBS, pulses, steps of any height.

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


def _excerpt(samples: FloatArray, most: int = CHUNK) -> FloatArray:
    """The finite ones of the first samples."""
    first = samples[:most]
    return np.asarray(first[np.isfinite(first)])


def held_samples(samples: FloatArray, resolution: float | None) -> int:
    """Samples between changes of a signal by more than a step of its converter; 1 where there are few changes.

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Raw samples; the first 2²¹ that are finite count.
    resolution : float or None
        Step of the converter [signal], where there is one.
    """
    changes = np.flatnonzero(np.abs(np.diff(_excerpt(samples, 16 * CHUNK))) > 1.5 * (resolution or 0.0))
    return 1 if changes.size < _FEWEST else int(np.quantile(np.diff(changes), _SELDOM))


class Bandwidth(NamedTuple):
    """Frequencies [Hz] below which half and 99 % of the power of a signal lie.

    Its mean and the floor of white noise are left out; NaN where nothing is left, or too few samples are given.
    """

    half: float
    most: float


def bandwidth(samples: FloatArray, step: float, noise: float) -> Bandwidth:
    """Bandwidth of a signal [Hz].

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
    power = _spectrum(samples, size) - 2.0 * noise**2 / size if size > 1 else np.zeros(1)
    below: FloatArray = np.cumsum(np.maximum(power, 0.0))
    if not below[-1] > 0.0:
        return Bandwidth(np.nan, np.nan)
    half, most = np.searchsorted(below, below[-1] * np.array([0.5, _NEARLY_ALL])) / (size * step)
    return Bandwidth(float(half), float(most))


def advised_interval(most: float, step: float) -> float:
    """Sample interval [s] for a signal that moves up to `most` [Hz] and was recorded with the step [s]."""
    return float(f"{max(1.0 / (ADVISED_PER_PERIOD * most), step):.4g}")


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
        """True if the line is clearly over the spectrum beside it."""
        return self.above_floor_db > _STANDS_OUT


def hum(samples: FloatArray, step: float, frequencies: Sequence[float] = MAINS) -> tuple[Hum, ...]:
    """Mains hum from an averaged spectrum (Hann windows of 4 s, half overlapping).

    Parameters
    ----------
    samples : FloatArray, shape (N,)
        Finite samples, taken as uniform.
    step : float
        Sampling step [s].
    frequencies : sequence of float
        Mains frequencies [Hz]; the grid's drift of ±0.2 Hz is allowed for.

    Returns
    -------
    tuple of Hum
        Without those whose line, or the floor beside it, lies beyond the Nyquist frequency; none where the record is
        shorter than two windows.
    """
    size = round(_HUM_WINDOW / step)
    shown = [frequency for frequency in frequencies if frequency + _HUM_BAND <= 0.5 / step]
    if not shown or samples.size < 2 * size:
        return ()
    power = _spectrum(samples, size)
    bins = np.asarray(np.fft.rfftfreq(size, step), dtype=np.float64)
    return tuple(line for frequency in shown if (line := _line(power, bins, frequency)) is not None)


def _line(power: FloatArray, bins: FloatArray, frequency: float) -> Hum | None:
    """The line at a frequency of a spectrum over its `bins` [Hz]; None where there is nothing beside it."""
    offset = np.abs(bins - frequency)
    line = offset <= 0.2 + 2.0 * bins[1]  # and the width of two bins
    # The mean of the logarithms' exponential is taken low by a few other lines; the median is not.
    floor = float(np.median(power[(offset <= _HUM_BAND) & ~line])) * int(line.sum())
    total = float(power[line].sum())
    amplitude = float(np.sqrt(2.0 * max(total - floor, 0.0)))
    return Hum(frequency, 10.0 * float(np.log10(total / floor)), amplitude) if floor > 0.0 else None


def mains_at_another_rate(samples: FloatArray, step: float) -> tuple[Hum, float] | None:
    """A line where mains hum is if the clock is wrong by a factor of two, and the factor that puts its rate right.

    None where hum is in its place, or there is none. A line at 100 or 120 Hz may also be that of a rectifier. Steps of
    the signal, which have power at all frequencies, are left out: what counts are the differences that noise reaches.
    """
    steps = np.diff(samples[: BLOCKS * CHUNK])
    quiet = np.where(np.abs(steps) <= 2.0 * REACH * noise_level(samples), steps, 0.0)
    if any(line.stands_out for line in hum(quiet, step)):
        return None
    elsewhere = (
        (line, factor)
        for factor in (2.0, 0.5)
        for line in hum(quiet, step, [frequency / factor for frequency in MAINS])
        if line.stands_out
    )
    return next(elsewhere, None)


def aliased(frequency: float, step: float) -> float:
    """Frequency [Hz] at which a line [Hz] appears in samples that are a step [s] apart."""
    turns = frequency * step
    return abs(turns - round(turns)) / step


def _spectrum(samples: FloatArray, size: int) -> FloatArray:
    """Mean power of each frequency bin, one-sided, scaled so that the bins of a line sum to its mean square.

    Welch's average of at most 64 windows that are spread over the signal.
    """
    window = np.hanning(size + 1)[:-1]
    power = np.zeros(size // 2 + 1)
    starts = np.linspace(0, samples.size - size, min(BLOCKS, 2 * samples.size // size - 1)).astype(np.int64).tolist()
    for i in starts:
        part = samples[i : i + size]
        power += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2
    return np.asarray(power * (2.0 / (len(starts) * size * np.sum(window**2))))
