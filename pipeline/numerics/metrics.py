"""Error measures of a calculated against a measured signal, and how a joint follows a step of its target.

Masked rows are left out; what is undefined is None.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from .arrays import FloatArray, IntArray

NORMAL_MEDIAN = 1.482602218505602
"""Standard deviation over median modulus of a normal variable."""

NORMAL_90 = 1.6448536269514722
NORMAL_95 = 1.959963984540054
NORMAL_99 = 2.5758293035489004
"""Standard deviations of half a normal variable's central 90 %, 95 % and 99 %."""


def rms(values: FloatArray) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(values**2)))


def rmse(measured: FloatArray, calculated: FloatArray) -> float | None:
    """Root mean square error, in the unit of the signals.

    Parameters
    ----------
    measured : FloatArray, shape (N,)
        Measured signal; rows that are NaN are masked and left out.
    calculated : FloatArray, shape (N,)
        Calculated signal, same unit.

    Returns
    -------
    float or None
        None where it is undefined: no measured row, or a calculated value that is not finite on a
        measured row (a diverged simulation has no error, it has a time of divergence).

    Raises
    ------
    InputError
        The two signals are not equally long vectors.
    """
    measured, calculated = np.asarray(measured, dtype=np.float64), np.asarray(calculated, dtype=np.float64)
    if measured.shape != calculated.shape or measured.ndim != 1:
        raise InputError(f"measured {measured.shape} and calculated {calculated.shape} must be equally long vectors")
    rows = np.isfinite(measured)
    error = calculated[rows] - measured[rows]
    if error.size == 0 or not np.all(np.isfinite(error)):
        return None
    # Scaled by the largest error, so that the square neither overflows nor underflows.
    largest = float(np.max(np.abs(error)))
    if largest == 0.0:
        return 0.0
    value = largest * float(np.sqrt(np.mean(np.square(error / largest))))
    return value if np.isfinite(value) else None


def signal_range(measured: FloatArray) -> float | None:
    """``max − min`` over the finite rows, the denominator of eq. 41; None where no row is finite."""
    finite = np.asarray(measured, dtype=np.float64)[np.isfinite(measured)]
    return float(np.ptp(finite)) if finite.size else None


def nrmse(measured: FloatArray, calculated: FloatArray) -> float | None:
    """Normalised root mean square error, eq. 41: the RMS of the error over ``max − min`` of the measurement.

    Parameters
    ----------
    measured : FloatArray, shape (N,)
        Measured signal; rows that are NaN are masked and left out.
    calculated : FloatArray, shape (N,)
        Calculated signal, same unit.

    Returns
    -------
    float or None
        A fraction (0.05 is 5 %). None where it is undefined: the measurement is constant, empty, or the
        calculated signal is not finite on a measured row.

    Raises
    ------
    InputError
        The two signals are not equally long vectors.
    """
    error = rmse(measured, calculated)
    span = signal_range(measured)
    if error is None or span is None or span == 0.0 or not np.isfinite(span):
        return None
    return error / span


def fit_percent(measured: FloatArray, calculated: FloatArray) -> float | None:
    """Fit as MATLAB's `compare` states it: 100 (1 − ‖y − ŷ‖/‖y − mean y‖) %, over the measured rows.

    100 is a perfect fit, 0 that of a constant, and it may be negative. None where `nrmse` is undefined.
    """
    error = rmse(measured, calculated)
    if error is None or not signal_range(measured):
        return None
    return 100.0 * (1.0 - error / float(np.std(measured[np.isfinite(measured)])))


def settling_index(error: FloatArray, band: float) -> IntArray:
    """First row from which an error, shape (…, N), stays within ±`band`; N where it is outside at the end."""
    outside = np.abs(error) > band
    last = error.shape[-1] - np.argmax(outside[..., ::-1], axis=-1)
    return np.asarray(np.where(outside.any(axis=-1), last, 0))


def robust_std(deviations: FloatArray) -> float:
    """Standard deviation of a normal variable about zero, from the median of its modulus; outliers do not count."""
    return NORMAL_MEDIAN * float(np.median(np.abs(deviations)))


BAND = 0.05
"""Half width of the band in which a joint has settled, as a share of the wells' distance."""


@dataclass(frozen=True)
class Step:
    """One step of the target, from it to the next.

    Attributes
    ----------
    t_s, target_m : float
        Time and value of the new target.
    settling_s : float or None
        Time [s] after which q stays within the band about the target; None if it is outside at the end.
    overshoot_m : float
        Overshoot [m] of q beyond the target, at least 0.
    rms_m : float
        RMS [m] of q − target over the second half of the step.
    """

    t_s: float
    target_m: float
    settling_s: float | None
    overshoot_m: float
    rms_m: float


def step_metrics(t: FloatArray, q: FloatArray, target: FloatArray, distance: float) -> list[Step]:
    """Metrics of every step of a target that is constant in between.

    Parameters
    ----------
    t, q, target : FloatArray, shape (N,)
        Time [s], displacement and target [m]; all finite.
    distance : float
        Distance of the wells [m].
    """
    first = np.flatnonzero(np.diff(target, prepend=np.nan) != 0.0)
    return [
        one_step(t[begin:end], q[begin:end], float(target[begin]), distance)
        for begin, end in zip(first, [*first[1:], len(t)], strict=True)
    ]


def one_step(t: FloatArray, q: FloatArray, target: float, distance: float) -> Step:
    """Metrics of a segment with one target, from its first row on.

    Parameters
    ----------
    t : FloatArray, shape (n,)
        Times [s].
    q : FloatArray, shape (n,)
        Displacement [m].
    target : float
        Target [m].
    distance : float
        Distance of the wells [m].
    """
    error = q - target
    settled = int(settling_index(error, BAND * distance))
    direction = -np.sign(error[0]) if abs(error[0]) > BAND * distance else 1.0
    return Step(
        t_s=float(t[0]),
        target_m=target,
        settling_s=float(t[settled] - t[0]) if settled < len(t) else None,
        overshoot_m=max(0.0, float(np.max(direction * error))),
        rms_m=rms(error[len(error) // 2 :]),
    )
