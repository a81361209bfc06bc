"""What is left in the residual of a free run: its correlation with itself and with the inputs, and its spectrum.

The tests are those of MATLAB's ``resid`` (Ljung, System Identification, § 16.6): a residual without memory stays
inside the band of its autocorrelation, one that the inputs explain no further inside that of the cross-correlation. A
free run feeds nothing back, so that its residual rings with the device: that it is coloured alone is no fault, that
it correlates with the inputs is.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.device_facts.run_data import LogData, RunData, inputs_of, squared_inputs
from pipeline.numerics.arrays import BoolArray, FloatArray

LEVEL = 2.576
"""Standard deviations of a 99 % band."""

SEGMENTS = 8
"""Parts that overlap by half and whose spectra are averaged (Welch)."""


@dataclass(frozen=True)
class Residual:
    """The analysis of one residual.

    Attributes
    ----------
    lags : FloatArray, shape (2 L + 1,)
        Lags [s], from −L to L samples; positive where the residual follows the input.
    correlation : FloatArray, shape (2 L + 1,)
        Autocorrelation.
    band : float
        99 % of the autocorrelations of white noise lie within ± this.
    with_inputs : FloatArray, shape (K, 2 L + 1)
        Correlation with each input.
    input_bands : FloatArray, shape (K,)
        The same bounds for a residual that is as coloured, but independent of the input (Bartlett's formula).
    outside : float
        Share of the cross-correlations at lags from 0 on that lie outside their bands; 0.01 is what chance gives.
    frequency, density, measured_density : FloatArray, shape (F,)
        Frequency [Hz] and power spectral densities of residual and measured signal [unit²/Hz].
    """

    lags: FloatArray
    correlation: FloatArray
    band: float
    with_inputs: FloatArray
    input_bands: FloatArray
    outside: float
    frequency: FloatArray
    density: FloatArray
    measured_density: FloatArray


def analyse_residual(
    measured: FloatArray, calculated: FloatArray, inputs: FloatArray, interval: float, *, longest: float = 1.0
) -> Residual | None:
    """Analyse the longest stretch in which both signals are known; None if it is shorter than eight lags.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        NaN where masked or diverged.
    inputs : FloatArray, shape (N, K)
        What acts on the device, e.g. squared voltages.
    interval : float
        Sample interval [s].
    longest : float
        Largest lag [s].
    """
    rows = _longest(np.isfinite(measured) & np.isfinite(calculated))
    count = round(longest / interval)
    if rows.stop - rows.start < 8 * count:
        return None
    q, u = measured[rows], inputs[rows]
    residual = calculated[rows] - q
    n = len(residual)
    own = _correlation(residual, residual, count)
    crossed = np.array([_correlation(column, residual, count) for column in u.T])
    # Bartlett: the variance of a cross-correlation of independent signals is Σ ρ_ee ρ_uu / N over all lags.
    far = min(n - 1, 10 * count)
    colour = _correlation(residual, residual, far)
    variances = [float(np.sum(colour * _correlation(column, column, far))) / n for column in u.T]
    bands: FloatArray = LEVEL * np.sqrt(np.maximum(variances, 1.0 / n))
    beyond = np.abs(crossed[:, count:]) > bands[:, None]
    frequency, density = _spectrum(residual, interval)
    return Residual(
        interval * np.arange(-count, count + 1.0), own, LEVEL / float(np.sqrt(n)), crossed, bands,
        float(np.mean(beyond)), frequency, density, _spectrum(q, interval)[1],
    )  # fmt: skip


def _longest(known: BoolArray) -> slice:
    edges = np.flatnonzero(np.diff(np.concatenate(([False], known, [False])).astype(np.int8))).reshape(-1, 2)
    if not len(edges):
        return slice(0, 0)
    first, last = edges[int(np.argmax(edges[:, 1] - edges[:, 0]))]
    return slice(int(first), int(last))


def _correlation(x: FloatArray, y: FloatArray, count: int) -> FloatArray:
    """Correlation of x(t) with y(t + lag) at lags from −count to count samples, shape (2 count + 1,)."""
    n = len(x)
    a, b = x - x.mean(), y - y.mean()
    scale = float(np.sqrt(np.sum(a**2) * np.sum(b**2)))
    if scale == 0.0:
        return np.zeros(2 * count + 1)
    whole = np.fft.irfft(np.conj(np.fft.rfft(a, 2 * n)) * np.fft.rfft(b, 2 * n), 2 * n) / scale
    found: FloatArray = np.concatenate((whole[-count:], whole[: count + 1])) if count else whole[:1]
    return found


def _spectrum(x: FloatArray, interval: float) -> tuple[FloatArray, FloatArray]:
    """Frequencies and one-sided density by Welch's method: Hann windows that overlap by half, each without its mean.

    Equal to `scipy.signal.welch`, whose package takes longer to load than the whole analysis.
    """
    length = 2 * len(x) // (SEGMENTS + 1)
    parts = np.lib.stride_tricks.sliding_window_view(x, length)[:: length - length // 2]
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(length) / length)
    power = np.abs(np.fft.rfft(window * (parts - parts.mean(axis=1, keepdims=True)))) ** 2
    density: FloatArray = 2.0 * interval * power.mean(axis=0) / np.sum(window**2)
    density[-1] *= 0.5 if length % 2 == 0 else 1.0  # the highest frequency has no mirror image
    frequency: FloatArray = np.fft.rfftfreq(length, interval).astype(np.float64)
    return frequency[1:], density[1:]


def headline_residual(data: RunData, log: LogData) -> Residual | None:
    """Analysis of its free run's residual of q against what acts on the device; None of a short or missing run."""
    model = data.model_names[0]
    if model not in log.predictions:
        return None
    inputs = inputs_of(log.kinematics)
    acting = np.square(inputs) if squared_inputs(data) else inputs
    return analyse_residual(log.kinematics["q"], log.predictions[model]["q"], acting, log.interval)
