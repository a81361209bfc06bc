"""The residual of a free run: its correlation with itself and with the inputs, and its spectrum.

The tests are those of MATLAB's ``resid`` (Ljung, System Identification, § 16.6). A residual without memory stays inside
the band of its autocorrelation, and one without a trace of the inputs inside that of the cross-correlation. A
free run feeds nothing back, so its residual rings with the device. A coloured residual is therefore no fault; one that
correlates with the inputs is.
"""

from dataclasses import dataclass

import numpy as np

from ..numerics.arrays import FloatArray, runs_of, samples_of
from ..numerics.metrics import NORMAL_99
from .run_data import LogData, RunData

LONGEST_LAG = 1.0
"""Largest lag [s]."""
FEWEST_LAGS = 50
"""Largest lag in samples, of a slow device or a log too short for `LONGEST_LAG`."""
SHARE = 8
"""Least length of a segment over the largest lag."""

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
        Share of the cross-correlations at lags from 0 on that lie outside their bands; 0.01 by chance.
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
    measured: FloatArray, calculated: FloatArray, inputs: FloatArray, interval: float
) -> Residual | None:
    """Analyse the longest segment in which both signals are known; None if it is shorter than eight times the lags.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        NaN where masked or diverged.
    inputs : FloatArray, shape (N, K)
        Acting inputs, e.g. squared voltages.
    interval : float
        Sample interval [s].
    """
    known = np.isfinite(measured) & np.isfinite(calculated)
    rows = max(runs_of(known), key=lambda rows: rows.stop - rows.start, default=slice(0, 0))
    length = rows.stop - rows.start
    second = samples_of(LONGEST_LAG, interval)
    count = max(second if SHARE * second <= len(measured) else 1, min(FEWEST_LAGS, length // SHARE))
    if length < SHARE * count:
        return None
    q = measured[rows]
    residual = calculated[rows] - q
    with_inputs = np.array([_correlation(column, residual, count) for column in inputs[rows].T])
    # Bartlett: the variance of a cross-correlation of independent signals is Σ ρ_ee ρ_uu / N over all lags.
    far = min(length - 1, 10 * count)
    colour = _correlation(residual, residual, far)
    variances = [float(np.sum(colour * _correlation(column, column, far))) / length for column in inputs[rows].T]
    bands: FloatArray = NORMAL_99 * np.sqrt(np.maximum(variances, 1.0 / length))
    frequency, density = _spectrum(residual, interval)
    return Residual(
        lags=interval * np.arange(-count, count + 1.0),
        correlation=_correlation(residual, residual, count),
        band=NORMAL_99 / float(np.sqrt(length)),
        with_inputs=with_inputs,
        input_bands=bands,
        outside=float(np.mean(np.abs(with_inputs[:, count:]) > bands[:, None])),
        frequency=frequency,
        density=density,
        measured_density=_spectrum(q, interval)[1],
    )


def _correlation(x: FloatArray, y: FloatArray, count: int) -> FloatArray:
    """Correlation of x(t) with y(t + lag) at lags from −count to count samples, shape (2 count + 1,)."""
    from scipy.signal import correlate

    a = x - x.mean()
    b = y - y.mean()
    size = float(np.sqrt(np.sum(a**2) * np.sum(b**2))) or np.inf
    return np.asarray(correlate(b, a, method="fft")[len(x) - 1 - count : len(x) + count] / size)


def _spectrum(x: FloatArray, interval: float) -> tuple[FloatArray, FloatArray]:
    """Frequencies without zero and one-sided density by Welch's method."""
    from scipy.signal import welch

    frequency, density = welch(x, 1.0 / interval, nperseg=2 * len(x) // (SEGMENTS + 1))
    return frequency[1:], density[1:]


def main_residual(data: RunData, log: LogData) -> Residual | None:
    """Analysis of the main model's residual of q on a log, with the acting inputs; None of a short or missing run."""
    model = data.model_names[0]
    if model not in log.predictions:
        return None
    motion = log.motion
    return analyse_residual(motion.q, log.predictions[model]["q"], data.device.acting(motion.v), motion.interval)
