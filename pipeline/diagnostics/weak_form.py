"""The acceleration of a log as a sum of smooth terms, in weak form: no derivative of the samples is taken.

Both sides of ``q̈ = f(q) + d(q) q̇ + Σ g_i(q) e_i`` are averaged under a bump ``φ(s) = (1 − s²)⁴`` of half width W; e_i
is the squared voltage, or the input itself. Partial integration moves the derivatives from q to the bump, so noise is
averaged over hundreds of samples. f is a polynomial of order 5, d has a constant and a square, each g_i is a parabola.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray, sample_interval

FORCE_ORDER = 5
GAIN_TERMS = 3
HALF_WIDTH = 5
"""Half width of the bump, in sample intervals of the identification: the motion is smooth over that."""
BLOCKS = 8
"""Parts of a log of which one at a time is left out: the spread of the results is their uncertainty (jackknife)."""
_MOST_SAMPLES = 600_000


@dataclass(frozen=True)
class LogSignals:
    """One log on a fine uniform grid.

    Attributes
    ----------
    name : str
        Title, for instance ``training log``.
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
    held : int
        Raw samples for which q keeps each value.
    sketch : tuple of (int, float)
        Hashes of some windows of the raw q, and where they begin [s] (`pipeline.diagnostics.copies`).
    """

    name: str
    t: FloatArray
    q: FloatArray
    v: FloatArray
    raw_step: float
    noise: float | None = None
    resolution: float | None = None
    held: int = 1
    sketch: tuple[tuple[int, float], ...] = ()

    @property
    def interval(self) -> float:
        """Step of the grid [s]."""
        return sample_interval(self.t)

    def every(self, step: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Times, displacement and inputs of every `step`-th row."""
        return self.t[::step], self.q[::step], np.ascontiguousarray(self.v[::step])


@dataclass(frozen=True)
class WeakTerms:
    """A log's averages under the bumps, of q and inputs scaled to size one.

    Attributes
    ----------
    size : float
        Standard deviation of q, by which it is scaled.
    rows : IntArray, shape (R,)
        Sample at the middle of each bump that meets no masked sample.
    q : FloatArray, shape (R,)
        Scaled displacement there.
    inertia : FloatArray, shape (R,)
        Averages of the scaled acceleration [1/s²].
    motion : FloatArray, shape (R, FORCE_ORDER + 3)
        Averages of the terms of f and d.
    inputs : FloatArray, shape (N, K, GAIN_TERMS)
        Averages of ``e_i``, ``e_i q``, ``e_i q²`` around every sample.
    interval : float
        Step of the samples [s].
    """

    size: float
    rows: IntArray
    q: FloatArray
    inertia: FloatArray
    motion: FloatArray
    inputs: FloatArray
    interval: float

    def design(self, lag: int = 0) -> FloatArray:
        """All terms, shape (R, P); the inputs are taken `lag` samples earlier."""
        late = np.take(self.inputs.reshape(len(self.inputs), -1), self.rows - lag, axis=0, mode="clip")
        return np.concatenate([self.motion, late], axis=1)


def weak_terms(log: LogSignals, acting: FloatArray, sample_interval: float) -> WeakTerms | None:
    """Average every term of a log, its first 600,000 samples if it is longer; None where too few bumps fit in.

    Parameters
    ----------
    log : LogSignals
        The log.
    acting : FloatArray, shape (N, K)
        The acting inputs. A block of them must determine all weights.
    sample_interval : float
        Sample interval [s] of the identification.

    Notes
    -----
    Cost: 15 convolutions with the bump for two inputs, 0.02 s for 40,000 samples.
    """
    half = _half_width(log, sample_interval)
    z, measured, size = _scaled(log)
    # Middles of bumps, a sample interval apart, that meet only measured samples.
    missing = np.concatenate(([0], np.cumsum(~measured)))
    middles = np.arange(half, len(measured) - half, half // HALF_WIDTH)
    rows = middles[missing[middles + half + 1] == missing[middles - half]]
    if rows.size < BLOCKS * (FORCE_ORDER + 3 + GAIN_TERMS * log.v.shape[1]):
        return None
    bump, slope, curvature = _bump(half, log.interval)
    motion = [_average(z**k, bump)[rows] for k in range(FORCE_ORDER + 1)]
    motion += [_average(z, slope)[rows], _average(z**3 / 3.0, slope)[rows]]  # z² ż is the rate of z³/3
    inertia = _average(z, curvature)[rows]
    return WeakTerms(
        size=size,
        rows=rows,
        q=z[rows],
        inertia=inertia,
        motion=np.column_stack(motion),
        inputs=_input_terms(acting, z, bump),
        interval=log.interval,
    )


def under_inputs(terms: WeakTerms, log: LogSignals, acting: FloatArray, sample_interval: float) -> WeakTerms:
    """The terms of a log of the same motion with other inputs.

    Parameters
    ----------
    terms : WeakTerms
        Terms of the log.
    log : LogSignals
        The log.
    acting : FloatArray, shape (N, K)
        The other acting inputs.
    sample_interval : float
        Sample interval [s] of the identification.
    """
    z, _, _ = _scaled(log)
    bump, _, _ = _bump(_half_width(log, sample_interval), log.interval)
    return replace(terms, inputs=_input_terms(acting, z, bump))


def solve(design: FloatArray, inertia: FloatArray) -> FloatArray:
    """Least squares with columns of equal size; directions that the data do not show are left at zero."""
    normal = design.T @ design
    size = np.sqrt(np.diag(normal))
    size = np.where(size > 0.0, size, 1.0)
    values, directions = np.linalg.eigh(normal / np.outer(size, size))
    shown = values > len(design) * np.finfo(float).eps * values[-1]
    answers = directions[:, shown].T @ (design.T @ inertia / size) / values[shown]
    return np.asarray(directions[:, shown] @ answers / size)


def residual(terms: WeakTerms, lag: int = 0) -> FloatArray:
    """Residual of the accelerations under the log's own weights, shape (R,); inputs act `lag` samples late.

    Cost: 0.2 ms for 4,000 bumps.
    """
    design = terms.design(lag)
    return terms.inertia - design @ solve(design, terms.inertia)


def unexplained(terms: WeakTerms) -> float:
    """RMS residual of the accelerations under the log's own weights, over their RMS."""
    size = max(float(np.linalg.norm(terms.inertia)), np.finfo(float).tiny)
    return float(np.linalg.norm(residual(terms))) / size


def _half_width(log: LogSignals, sample_interval: float) -> int:
    return max(HALF_WIDTH, round(HALF_WIDTH * sample_interval / log.interval))


def _scaled(log: LogSignals) -> tuple[FloatArray, BoolArray, float]:
    """The first samples of q, scaled.

    Returns
    -------
    z : FloatArray, shape (n,)
        q about its mean, over its size; zero where it is not measured. n is `_MOST_SAMPLES` at most.
    measured : BoolArray, shape (n,)
        Mask of the measured samples.
    size : float
        Standard deviation of q; 1 where it is zero or nothing is measured.
    """
    q = log.q[:_MOST_SAMPLES]
    measured = np.isfinite(q)
    size = float(np.std(q[measured])) if measured.any() else 0.0
    middle = float(np.mean(q[measured])) if measured.any() else 0.0
    return np.where(measured, (q - middle) / (size or 1.0), 0.0), measured, size or 1.0


def _input_terms(acting: FloatArray, z: FloatArray, bump: FloatArray) -> FloatArray:
    """`WeakTerms.inputs` of the acting inputs, each over its largest drive."""
    e = acting[: len(z)]
    drive = np.max(np.abs(e), axis=0)
    e = e / np.where(drive > 0.0, drive, 1.0)
    inputs = np.empty((*e.shape, GAIN_TERMS))
    for i in range(e.shape[1]):
        for k in range(GAIN_TERMS):
            inputs[:, i, k] = _average(e[:, i] * z**k, bump)
    return inputs


def _bump(half: int, h: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Weights, shape (2 half + 1,) each, that average a signal, its first and its second derivative under the bump."""
    s = np.arange(-half, half + 1) / half
    shape = 1.0 - s**2
    width = half * h
    bump = shape**4
    total = float(bump.sum())
    slope = -8.0 * s * shape**3 / width
    curvature = (-8.0 * shape**3 + 48.0 * s**2 * shape**2) / width**2
    return bump / total, slope / total, curvature / total


def _average(x: FloatArray, weights: FloatArray) -> FloatArray:
    return np.asarray(np.convolve(x, weights, "same"))
