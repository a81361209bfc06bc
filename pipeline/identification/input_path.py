"""From measured inputs to what acts at every half step: the hold between samples, a delay, a lag, a square."""

import numpy as np
from scipy.interpolate import CubicSpline

from pipeline.identification.joint_structure import Hold
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.lag import first_order_lag


def known_inputs(v: FloatArray) -> FloatArray:
    """Inputs row by row, shape (n, K), from those at the samples (N, K) or at r times of each interval (N, r, K)."""
    return v if v.ndim == 2 else v.reshape(-1, v.shape[2])


def spline_through(known: FloatArray) -> CubicSpline:
    """The cubic spline through inputs, over their numbers. Cost: 150 ns each."""
    return CubicSpline(np.arange(len(known)), known)


def drive_at_nodes(
    v: FloatArray, interval: float, steps: int, hold: Hold, delay: float = 0.0, spline: CubicSpline | None = None
) -> FloatArray:
    """Inputs at every half step.

    Parameters
    ----------
    v : FloatArray, shape (N, K) or (N, r, K)
        Inputs at the samples, or at r evenly spaced times of each sample interval.
    interval : float
        Sample interval [s].
    steps : int
        Integration steps per interval.
    hold : str
        The inputs between the times at which they are known; "record" is linear between the finer ones.
    delay : float
        Time [s] by which they act later; before the first sample they are what they were there.
    spline : CubicSpline, optional
        `spline_through` the inputs, where it is known.

    Returns
    -------
    FloatArray, shape (2·steps·(N−1)+1, K)
        With "zero" the value of a node is that of the step which begins at it, with a delay its mean over that step.
        Cost: 10 ns per node and input, with a delay or a spline 35.
    """
    known = known_inputs(v)
    spacing = interval * len(v) / len(known)
    # Counted in known times, so that a node on a sample is exactly on it.
    nodes = np.arange(2 * steps * (len(v) - 1) + 1, dtype=np.float64)
    at: FloatArray = nodes * (interval / spacing / (2 * steps)) - delay / spacing
    times = np.arange(len(known))
    if hold == "zero" and delay:
        return _held_means(known, at)
    at = np.clip(at, 0.0, times[-1])
    if hold == "zero":
        return np.ascontiguousarray(known[np.floor(at + 1e-9).astype(np.int64)])
    if hold == "cubic" and len(known) > 3:
        return np.ascontiguousarray((spline or spline_through(known))(at))
    return np.column_stack([np.interp(at, times, column) for column in known.T])


def _held_means(known: FloatArray, at: FloatArray) -> FloatArray:
    """Means of held inputs over each step, of two nodes: what a delay that ends within a step leaves of it.

    They change smoothly with the delay, so that it can be estimated; values at the nodes would jump.
    """
    before = min(0.0, np.floor(at[0]))
    times = np.concatenate(([before], np.arange(len(known) + 1)))
    ends = np.append(at[::2], 2.0 * at[-1] - at[-3])
    area = np.concatenate((before * known[:1], np.zeros_like(known[:1]), np.cumsum(known, axis=0)))
    means = np.column_stack([np.diff(np.interp(ends, times, column)) for column in area.T]) / (at[2] - at[0])
    return np.repeat(means, 2, axis=0)[: len(at)]


def lagged(
    volts: FloatArray, half: float, lag: float, *, held: bool, rest_at_zero: bool
) -> tuple[FloatArray, FloatArray]:
    """Inputs behind a first-order lag, and their derivatives by its logarithm.

    Parameters
    ----------
    volts : FloatArray, shape (n, K)
        Inputs at every half step.
    half : float
        Half a step [s].
    lag : float
        Time constant [s].
    held : bool
        Whether inputs are constant from node to node.
    rest_at_zero : bool
        Whether the lag starts at zero instead of at the first input.
    """
    out, by_lag = np.empty_like(volts), np.empty_like(volts)
    for i in range(volts.shape[1]):
        start = 0.0 if rest_at_zero else float(volts[0, i])
        out[:, i], by_lag[:, i] = first_order_lag(np.ascontiguousarray(volts[:, i]), half, lag, start, held)
    return out, by_lag
