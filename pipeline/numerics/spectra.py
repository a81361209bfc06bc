"""Spectra and correlations of records, by the discrete Fourier transform."""

import numpy as np

from pipeline.numerics.arrays import FloatArray


def power_density(x: FloatArray, interval: float, length: int) -> tuple[FloatArray, FloatArray]:
    """Frequencies [Hz] and one-sided power density of x by P. D. Welch's method (doi:10.1109/TAU.1967.1161901).

    Parameters
    ----------
    x : FloatArray, shape (N,)
        Samples.
    interval : float
        Between them [s].
    length : int
        Of a segment, at most N: segments overlap by half, lose their mean, and are weighed by Hann's window.
    """
    segments = np.lib.stride_tricks.sliding_window_view(x, length)[:: length - length // 2]
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(length) / length)
    lines = np.fft.rfft((segments - segments.mean(axis=1, keepdims=True)) * window)
    power = np.mean(np.abs(lines) ** 2, axis=0) * interval / np.sum(window**2)
    power[1 : (length + 1) // 2] *= 2.0  # the negative frequencies; there is none of zero and of half the rate
    return np.arange(power.size) / (length * interval), np.asarray(power, dtype=np.float64)


def correlation(x: FloatArray, y: FloatArray) -> FloatArray:
    """Σ x(t) y(t + lag) at lags from −(N − 1) to N − 1 of two records of shape (N,), shape (2 N − 1,)."""
    size = 2 * x.size - 1
    padded = 1 << (size - 1).bit_length()
    product = np.fft.irfft(np.conj(np.fft.rfft(x, padded)) * np.fft.rfft(y, padded), padded)
    return np.concatenate([product[padded - x.size + 1 :], product[: x.size]])
