"""The voltages of a log as they act on the joint: late, behind the electrodes, squared, on its integrator's half steps.

A membrane of capacitance C behind electrodes of resistance R charges with the time constant T = R C: T V̇ = v − V for
its voltage V under the measured v, from rest under the first one. What pulls is V².
"""

import numpy as np
from scipy.interpolate import CubicSpline

from ...errors import InputError
from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled, inner
from .parameters import Instruments


class DrivingVoltages:
    """Measured voltages of the two membranes between the samples of a log.

    Parameters
    ----------
    v : FloatArray, shape (N, 2) or (N, r, 2)
        Voltages [V] at the samples, or at r evenly spaced times of each sample interval, the first of which is the
        sample itself.
    dt : float
        Sample interval [s].

    Raises
    ------
    InputError
        There are not two voltages.
    """

    def __init__(self, v: FloatArray, dt: float) -> None:
        if v.shape[-1] != 2:
            raise InputError(f"the hybrid joint has two membranes; the log gives {v.shape[-1]} voltage(s)")
        self._samples = len(v)
        self._dt = dt
        self._per_sample = v.shape[1] if v.ndim == 3 else 1
        self._v = np.ascontiguousarray(v.reshape(-1, 2)[: self._per_sample * (len(v) - 1) + 1])
        self._spline = None if self.refined else CubicSpline(dt * np.arange(len(v)), self._v)
        self._largest = float(np.abs(self._v).max())

    @property
    def refined(self) -> bool:
        """True if the voltages are known between the samples."""
        return self._per_sample > 1

    def squared(self, steps: int, seen: Instruments, largest: float) -> FloatArray:
        """Squared voltages [V²] on the half steps, shape (2 steps (N−1) + 1, 2).

        Parameters
        ----------
        steps : int
            Runge-Kutta steps in a sample interval.
        seen : Instruments
            Delay, charging time, and what the probes read at zero voltage.
        largest : float
            Largest trained voltage [V]; above twice that, where the film breaks down, the force is held.

        Notes
        -----
        Voltages known at the samples only are a cubic spline: it restores an anti-aliased edge of a pulse far better
        than straight lines, whose square takes 1.7 ms from it at a sample interval of 10 ms. Finer ones are straight
        lines, and each half step sees the mean of their square around it, so that no edge falls between half steps:
        from the 1 ms record two free runs were within 0.013 % of the range of those with steps of 0.4 ms.
        Cost for 37.5 s at three steps in 10 ms: 0.2 ms from samples, 0.4 ms from a 1 ms record.
        """
        limit = 2.0 * largest
        half = self._dt / (2 * steps)
        count = 2 * steps * (self._samples - 1) + 1
        if self._spline is not None:
            return _spline_squares(self._spline.c, self._dt, count, half, seen.delay, seen.charging, seen.probe, limit)
        v = self._v
        probe = seen.probe
        spacing = self._dt / self._per_sample
        if self._largest + np.abs(probe).max() > limit:
            v, probe = np.clip(v - probe, -limit, limit), np.zeros(2)
        v, areas = _charged(v, spacing, seen.charging)
        return _mean_squares(v, areas, spacing, count, half, seen.delay, probe)


@compiled
def _spline_squares(
    c: FloatArray,
    spacing: float,
    count: int,
    width: float,
    delay: float,
    charging: float,
    probe: FloatArray,
    limit: float,
) -> FloatArray:
    """Squares of voltages behind their electrodes at i·width, shape (count, K).

    Measured are cubic splines, `delay` earlier, without `probe` and held at ± `limit`; `c` (4, N − 1, K) holds their
    coefficients of (t − t_n)³, …, 1. Between the nodes they go on lines. Cost: 4 ns each.
    """
    cells = c.shape[1]
    columns = c.shape[2]
    out = np.empty((count, columns))
    remaining, mean = _shares(width / charging)
    for j in range(columns):
        charged = before = 0.0
        for i in range(count):
            t = min(max(i * width - delay, 0.0), spacing * cells)
            cell = min(int(t / spacing), cells - 1)
            s = t - cell * spacing
            v = ((c[0, cell, j] * s + c[1, cell, j]) * s + c[2, cell, j]) * s + c[3, cell, j] - probe[j]
            v = min(max(v, -limit), limit)
            charged = v if i == 0 else remaining * charged + (mean - remaining) * before + (1.0 - mean) * v
            before = v
            out[i, j] = charged * charged
    return out


@inner
def _shares(ratio: float) -> tuple[float, float]:
    """Remaining share of a lagged value after `ratio` time constants, and the mean share until then.

    A step of a lag z behind x on a line: z⁺ = kept z + (mean − kept) x + (1 − mean) x⁺, see
    `pipeline.numerics.linear_filters`.
    """
    return np.exp(-ratio), -np.expm1(-ratio) / ratio


@compiled
def _charged(v: FloatArray, spacing: float, lag: float) -> tuple[FloatArray, FloatArray]:
    """Lines through `v` behind a lag, exact at their ends, (N, K), and integrals from the first end, (2, K, N).

    The integrals are those of the lines through what is found, and of their squares. Cost: 3 ns each.
    """
    charged = np.empty_like(v)
    areas = np.zeros((2, v.shape[1], len(v)))
    remaining, mean = _shares(spacing / lag)
    earlier = mean - remaining
    later = 1.0 - mean
    half = spacing / 2.0
    third = spacing / 3.0
    for column in range(v.shape[1]):
        charged[0, column] = v[0, column]
    for i in range(len(v) - 1):
        for column in range(v.shape[1]):
            a = charged[i, column]
            b = remaining * a + earlier * v[i, column] + later * v[i + 1, column]
            charged[i + 1, column] = b
            areas[0, column, i + 1] = areas[0, column, i] + half * (a + b)
            areas[1, column, i + 1] = areas[1, column, i] + third * (a * a + a * b + b * b)
    return charged, areas


@compiled
def _mean_squares(
    v: FloatArray, areas: FloatArray, spacing: float, count: int, width: float, delay: float, probe: FloatArray
) -> FloatArray:
    """Means of the squares of lines through `v` − `probe` over windows of `width` at i·width − delay, shape (count, K).

    Before the first and after the last value of `v`, which are `spacing` apart, it is constant. The means are
    differences of the integrals from its beginning (`_charged`), right to 1e-11 of the largest square. Cost: 3 ns for
    each window.
    """
    last = len(v) - 1
    columns = v.shape[1]
    per_second = 1.0 / spacing
    per_window = 1.0 / width
    out = np.empty((count, columns))
    for column in range(columns):
        lines = areas[0, column]
        squares = areas[1, column]
        off = probe[column]
        before = 0.0
        for i in range(count + 1):
            t = (i - 0.5) * width - delay
            knot = min(max(int(t * per_second), 0), last)
            s = t - knot * spacing
            a = v[knot, column]
            slope = 0.0 if t < 0.0 or knot == last else (v[knot + 1, column] - a) * per_second
            line = lines[knot] + s * (a + 0.5 * slope * s)
            here = squares[knot] + s * (a * a + slope * s * (a + 1.0 / 3.0 * slope * s)) - 2.0 * off * line
            if i > 0:
                out[i - 1, column] = (here - before) * per_window + off * off
            before = here
    return out
