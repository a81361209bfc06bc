"""Interpolation of unevenly sampled signals: for logs about as coarse as the record that is made of them."""

from collections.abc import Iterator

import numpy as np

from pipeline.numerics.arrays import FloatArray

_PIECE = 1 << 15
_STEEPEST = 1.5


def interpolated(time: FloatArray, samples: FloatArray, t_out: FloatArray, *, smooth: bool) -> Iterator[FloatArray]:
    """The same as `interpolate` of columns of any length, piece after piece."""
    for first in range(0, t_out.size, _PIECE):
        points = t_out[first : first + _PIECE]
        low, high = np.searchsorted(time, points[[0, -1]])
        rows = slice(max(low - 3, 0), high + 3)
        yield interpolate(time[rows], samples[rows], points, smooth=smooth)


def interpolate(time: FloatArray, samples: FloatArray, t_out: FloatArray, *, smooth: bool) -> FloatArray:
    """Interpolate one gap-free stretch; nothing is averaged, samples are passed through.

    Parameters
    ----------
    time, samples : FloatArray, shape (N,)
        Strictly increasing time stamps [s] and finite samples.
    t_out : FloatArray, shape (M,)
        Any times [s] within ``[time[0], time[-1]]``.
    smooth : bool
        True: cubic Hermite pieces with the slopes of three-point parabolas, error O(h³), for displacements;
        False: straight lines, which cannot overshoot, for voltages.

    Returns
    -------
    FloatArray, shape (M,)
    """
    if not smooth or time.size < 3:
        return np.interp(t_out, time, samples)
    from scipy.interpolate import CubicHermiteSpline

    value: FloatArray = CubicHermiteSpline(time, samples, _slopes(time, samples))(t_out)
    return value


def _slopes(time: FloatArray, samples: FloatArray) -> FloatArray:
    """Slopes of three-point parabolas, none so steep that it leads far out of its neighbours over the longer step.

    Of two stamps that nearly coincide, the noise between them is a slope without a bound. A slope d overshoots over a
    step h by 4/27 of d h at most, so at 1.5 times the changes beside it by less than a quarter of these; on even steps
    the limit is never reached.
    """
    steps, changes = np.diff(time), np.abs(np.diff(samples))
    longer, beside = np.maximum(steps[1:], steps[:-1]), changes[1:] + changes[:-1]
    limit = _STEEPEST * np.pad(beside / longer, 1, mode="edge")
    bounded: FloatArray = np.clip(np.gradient(samples, time, edge_order=2), -limit, limit)
    return bounded
