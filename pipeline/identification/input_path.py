"""From measured inputs to what acts at every half step: the hold between samples, a delay, a lag, a square."""

import numpy as np
from scipy.interpolate import CubicSpline

from pipeline.identification.joint_structure import Hold
from pipeline.identification.regressor import InputLaw
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.lag import first_order_lag


def drive_at_nodes(v: FloatArray, interval: float, steps: int, hold: Hold, delay: float = 0.0) -> FloatArray:
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

    Returns
    -------
    FloatArray, shape (2·steps·(N−1)+1, K)
        With "zero" the value of a node is that of the step which begins at it. Cost: 10 ns per node and input, three
        times that for a spline.
    """
    known = v if v.ndim == 2 else v.reshape(-1, v.shape[2])
    spacing = interval * len(v) / len(known)
    # Counted in known times, so that a node on a sample is exactly on it.
    at = np.arange(2 * steps * (len(v) - 1) + 1) * (interval / spacing / (2 * steps))
    if delay:
        at = at - delay / spacing
    times = np.arange(len(known))
    at = np.clip(at, 0.0, times[-1])
    if hold == "zero":
        return np.ascontiguousarray(known[np.floor(at + 1e-9).astype(np.int64)])
    if hold == "cubic" and len(known) > 3:
        return np.ascontiguousarray(CubicSpline(times, known)(at))
    return np.column_stack([np.interp(at, times, column) for column in known.T])


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


def extra_terms(inputs: int, law: InputLaw) -> int:
    """How many terms the refined law has beside one for each input."""
    return 2 if inputs == 1 else inputs * (inputs + 1) // 2


def input_terms(volts: FloatArray, law: InputLaw, *, refined: bool) -> tuple[FloatArray, FloatArray]:
    """What the input curves multiply, and the derivatives by each input.

    One term per input: v² or v. The refined law adds what a condensed hidden coordinate makes of them, the products of
    these terms (for two electrostatic inputs v₁⁴, v₁²v₂², v₂⁴); with one input v and v⁴ beside v², or v² and v³ beside v,
    since a drive's force need be no pure power.

    Parameters
    ----------
    volts : FloatArray, shape (n, K)
        Scaled inputs.
    law : {"squared", "linear"}
        The main terms.
    refined : bool
        Whether the others are added.

    Returns
    -------
    terms : FloatArray, shape (n, K')
    slopes : FloatArray, shape (n, K', K)
    """
    n, k = volts.shape
    main = volts * volts if law == "squared" else volts
    main_slope = 2.0 * volts if law == "squared" else np.ones_like(volts)
    count = k + (extra_terms(k, law) if refined else 0)
    terms, slopes = np.empty((n, count)), np.zeros((n, count, k))
    terms[:, :k] = main
    slopes[:, range(k), range(k)] = main_slope
    if refined and k == 1:
        powers = (1, 4) if law == "squared" else (2, 3)
        for column, power in enumerate(powers, start=1):
            terms[:, column] = volts[:, 0] ** power
            slopes[:, column, 0] = power * volts[:, 0] ** (power - 1)
    elif refined:
        pairs = [(i, j) for i in range(k) for j in range(i, k)]
        for column, (i, j) in enumerate(pairs, start=k):
            terms[:, column] = main[:, i] * main[:, j]
            slopes[:, column, i] += main_slope[:, i] * main[:, j]
            slopes[:, column, j] += main_slope[:, j] * main[:, i]
    return terms, slopes
