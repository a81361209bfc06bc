"""The anti-alias kernel by which logs are decimated: a low pass without delay that hardly rings.

With x the distance of a sample from the grid point in output intervals T and y = (x/2)²,

    K(x) = (1 − y)² Σ_k a_k y^k   for |x| ≤ 2, else 0,

evaluated at the samples' actual times and weighted by their trapezoidal share of the time axis. It is
symmetric, so phase and group delay are zero and a step stays where it is (the 50 % point to within the raw
sampling). The coefficients solve a linear program: least stop-band gain under bounds on the step response's
overshoot and on the droop at 0.1/T. Figures (T = 10 ms in brackets):

=============================  ==========================
overshoot of a step            1.5 %, before and after, gone 2 T away from the step
rise time, 10 to 90 %          0.87 T (8.7 ms)
droop at 0.1/T (10 Hz)         1.0 %
−3 dB                          0.41/T (41 Hz)
at 0.5/T, the Nyquist limit    −5.2 dB
at 0.9/T, aliased onto 0.1/T   −19 dB
at 1/T, aliased onto 0         −27 dB
beyond 1.08/T                  below −40 dB
white noise, RMS               0.92 sqrt(raw step / T) times the raw one
=============================  ==========================

A sharper filter would ring: a steep cut at 0.5/T overshoots a voltage step by about 9 % (Gibbs). Where a drive
steps, ringing is worse than the little noise that folds over.
"""

from functools import cache

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray

REACH = 2.0
"""Half width of the kernel in output intervals."""

_COEFFICIENTS = (1.1192, -12.2297, 52.0192, -112.3366, 126.2552, -60.1179)


def filtered_samples(values: FloatArray, ratio: int) -> FloatArray:
    """Every `ratio`-th value of a uniform signal, low-pass filtered as a log is when it is brought to its samples.

    Parameters
    ----------
    values : FloatArray, shape (…, ratio (N−1) + 1, C)
        C signals.
    ratio : int
        Values in a sample interval.

    Returns
    -------
    FloatArray, shape (…, N, C)
        The first and the last two samples, where the kernel would be cut, are the values themselves. Between values
        the signal is a cubic spline: the kernel at the values alone widens it twofold at a ratio of 2.
        Cost: 4 `ratio` multiply-adds for each.
    """
    samples: FloatArray = values[..., ::ratio, :].copy()
    if samples.shape[-2] > 2 * REACH:
        reach = int(REACH) * ratio
        windows = np.lib.stride_tricks.sliding_window_view(values, 2 * reach + 1, axis=-2)[..., ::ratio, :, :]
        samples[..., int(REACH) : -int(REACH), :] = windows @ _weights(ratio)
    return samples


@cache
def _weights(ratio: int) -> FloatArray:
    """Integral of the kernel times the cubic spline that is 1 at one of `ratio` values in a sample interval, each."""
    from scipy.interpolate import CubicSpline

    nodes = np.arange(-int(REACH) * ratio, int(REACH) * ratio + 1) / ratio
    fine = np.linspace(-REACH, REACH, 64 * (len(nodes) - 1) + 1)
    weights: FloatArray = kernel(fine) @ CubicSpline(nodes, np.eye(len(nodes)))(fine)
    weights /= weights.sum()
    return weights


def sharpened(samples: FloatArray, usable: BoolArray) -> FloatArray:
    """What a smooth signal was before `decimate`, from its samples, shape (N,).

    The kernel's response is 1 + m2/2 D² + m4/24 D⁴ + … in derivatives D per sample interval, m2 and m4 being its
    moments; the inverse is taken to fourth order, in differences of five samples. Where one of them is not `usable` a
    sample stays as it is. Cost: 10 flops each; noise at the Nyquist limit grows by a quarter.
    """
    sharp = samples.copy()
    if len(samples) < 5:
        return sharp
    second = np.diff(samples, 2)
    fourth = np.diff(second, 2)
    by_second, by_fourth = _SHARPENING
    inside = np.lib.stride_tricks.sliding_window_view(usable, 5).all(axis=1)
    sharp[2:-2] += np.where(inside, by_second * second[1:-1] + by_fourth * fourth, 0.0)
    return sharp


def kernel(x: FloatArray) -> FloatArray:
    """The decimation kernel K(x), unnormalised, for |x| ≤ 2 in output intervals; any shape."""
    y = x * (1.0 / REACH)
    y *= y
    value = np.full_like(y, _COEFFICIENTS[-1])
    for coefficient in _COEFFICIENTS[-2::-1]:
        value *= y
        value += coefficient
    return _times_window(value, y)


def slope_window(x: FloatArray) -> FloatArray:
    """The positive window (1 − y)² of the local slope."""
    y = x * (1.0 / REACH)
    y *= y
    return _times_window(np.ones_like(y), y)


def _times_window(value: FloatArray, y: FloatArray) -> FloatArray:
    np.subtract(1.0, y, out=y)
    value *= y
    value *= y
    return value


def _sharpening() -> tuple[float, float]:
    """Factors of second and fourth differences in `sharpened`: D² = δ² − δ⁴/12."""
    fine = np.linspace(-REACH, REACH, 4001)
    weights = kernel(fine)
    m2, m4 = (float(np.sum(weights * fine**power) / np.sum(weights)) for power in (2, 4))
    return -m2 / 2.0, m2 / 24.0 + (m2 / 2.0) ** 2 - m4 / 24.0


_SHARPENING = _sharpening()
