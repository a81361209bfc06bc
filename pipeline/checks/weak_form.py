"""The acceleration of a log as a sum of smooth terms, in weak form: no derivative of the samples is taken.

Both sides of ``q̈ = f(q) + d(q) q̇ + Σ g_i(q) e_i`` (e_i: the squared voltage, or the input itself) are averaged under a
bump ``φ(s) = (1 − s²)⁴`` of half width W; the derivatives of q move to the bump by partial integration, so noise is
averaged over hundreds of samples. f is a polynomial of order 5, d has a constant and a square, each g_i is a parabola.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray, IntArray, sample_interval

FORCE_ORDER = 5
GAIN_TERMS = 3
HALF_WIDTH = 5.0
"""Half width of the bump, in sample intervals of the identification: the motion is smooth over that."""
_BUMPS_PER_WIDTH = 5
_MOST_SAMPLES = 600_000
_LEAST_ROWS = 60
_LEAST_SHOWN = 1e-12  # of the normal equations: the square of 1e-6 of the design


@dataclass(frozen=True)
class LogSignals:
    """One log on a fine uniform grid.

    Attributes
    ----------
    name : str
        As people read it, for instance ``training log``.
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q : FloatArray, shape (N,)
        Displacement [m or rad], NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs, finite.
    raw_step : float
        Step of the raw log [s].
    noise, resolution : float or None
        Noise of the raw q (standard deviation) and step of its converter, where there is one [m or rad].
    hum : tuple of float
        Mains lines [Hz] in it.
    """

    name: str
    t: FloatArray
    q: FloatArray
    v: FloatArray
    raw_step: float
    noise: float | None = None
    resolution: float | None = None
    hum: tuple[float, ...] = ()

    @property
    def interval(self) -> float:
        """Step of the grid [s]."""
        return sample_interval(self.t)

    def every(self, step: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Times, displacement and inputs of every `step`-th row."""
        return self.t[::step], self.q[::step], np.ascontiguousarray(self.v[::step])


@dataclass(frozen=True)
class Scales:
    """By what the terms are scaled, so that logs of one device can be compared: middle and size of q, size of e."""

    middle: float
    size: float
    drive: FloatArray


@dataclass(frozen=True)
class WeakTerms:
    """A log's averages under the bumps.

    Attributes
    ----------
    scales : Scales
    rows : IntArray, shape (R,)
        Sample at the middle of each bump that meets no masked sample.
    q : FloatArray, shape (R,)
        Scaled displacement there.
    inertia : FloatArray, shape (R,)
        Averages of the scaled acceleration [1/s²].
    motion : FloatArray, shape (R, FORCE_ORDER + 3)
        Averages of the terms of f and d.
    push : FloatArray, shape (N, K, GAIN_TERMS)
        Averages of ``e_i``, ``e_i q``, ``e_i q²`` around every sample.
    interval : float
        Step of the samples [s].
    """

    scales: Scales
    rows: IntArray
    q: FloatArray
    inertia: FloatArray
    motion: FloatArray
    push: FloatArray
    interval: float

    def design(self, lags: IntArray | None = None) -> FloatArray:
        """All terms, shape (R, P); input i is taken `lags[i]` samples earlier."""
        shifts = np.zeros(self.push.shape[1], dtype=np.int64) if lags is None else lags
        taken = [
            self.push[np.clip(self.rows - shift, 0, len(self.push) - 1), i] for i, shift in enumerate(shifts.tolist())
        ]
        return np.concatenate([self.motion, *taken], axis=1)


def scales_of(log: LogSignals, *, squared: bool) -> Scales:
    """The scales of a log; an input that does nothing has scale 1."""
    q = log.q[np.isfinite(log.q)]
    drive = np.max(np.abs(log.v), axis=0) ** (2 if squared else 1)
    return Scales(float(np.mean(q)), float(np.std(q)) or 1.0, np.where(drive > 0.0, drive, 1.0))


def weak_terms(log: LogSignals, sample_interval: float, scales: Scales, *, squared: bool) -> WeakTerms | None:
    """Average every term of a log, its first 600,000 samples if it is longer; None where too few bumps fit in.

    Cost: some 20 convolutions with the bump, 0.1 s for 40,000 samples.
    """
    h = log.interval
    half = max(4, round(HALF_WIDTH * sample_interval / h))
    n = min(len(log.q), _MOST_SAMPLES)
    measured = np.isfinite(log.q[:n])
    z = np.where(measured, (log.q[:n] - scales.middle) / scales.size, 0.0)
    v = log.v[:n]
    e = (v**2 if squared else v) / scales.drive
    rows = _usable(measured, half)
    if rows.size < _LEAST_ROWS:
        return None
    bump, slope, curvature = _bump(half, h)
    motion = [_average(z**k, bump)[rows] for k in range(FORCE_ORDER + 1)]
    motion += [_average(z, slope)[rows], _average(z**3 / 3.0, slope)[rows]]  # z² ż is the rate of z³/3
    push = np.empty((n, e.shape[1], GAIN_TERMS))
    for i in range(e.shape[1]):
        for k in range(GAIN_TERMS):
            push[:, i, k] = _average(e[:, i] * z**k, bump)
    return WeakTerms(scales, rows, z[rows], _average(z, curvature)[rows], np.column_stack(motion), push, h)


def solve(design: FloatArray, inertia: FloatArray) -> FloatArray:
    """Least squares with columns of equal size; directions that the data do not show are left at zero."""
    size = np.linalg.norm(design, axis=0)
    size = np.where(size > 0.0, size, 1.0)
    scaled = design / size
    weights: FloatArray = np.linalg.lstsq(scaled.T @ scaled, scaled.T @ inertia, rcond=_LEAST_SHOWN)[0] / size
    return weights


def _usable(measured: BoolArray, half: int) -> IntArray:
    """Middles of bumps that meet only measured samples."""
    missing = np.concatenate(([0], np.cumsum(~measured)))
    middles = np.arange(half, len(measured) - half, max(1, half // _BUMPS_PER_WIDTH))
    usable: IntArray = middles[missing[middles + half + 1] == missing[middles - half]]
    return usable


def _bump(half: int, h: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Weights that average a signal, its first and its second derivative."""
    s = np.arange(-half, half + 1) / half
    shape, width = 1.0 - s**2, half * h
    bump = shape**4
    total = float(bump.sum())
    slope = -8.0 * s * shape**3 / width
    curvature = (-8.0 * shape**3 + 48.0 * s**2 * shape**2) / width**2
    return bump / total, slope / total, curvature / total


def _average(x: FloatArray, weights: FloatArray) -> FloatArray:
    result: FloatArray = np.convolve(x, weights, "same")
    return result


def unexplained(terms: WeakTerms, delays: IntArray | None = None) -> float:
    """RMS residual of the accelerations under the log's own weights, over their RMS.

    Inputs act `delays` samples later than logged. Cost: 0.3 ms for 4,000 bumps.
    """
    design = terms.design(delays)
    own = terms.inertia - design @ solve(design, terms.inertia)
    return float(np.linalg.norm(own) / max(float(np.linalg.norm(terms.inertia)), np.finfo(float).tiny))
