"""What there is to compare where the motion is chaotic.

A free run that starts a hair's breadth beside another stays beside it, or parts from it exponentially. Then no model
follows a log for long, however good it is, and the error of a free run says nothing of the model. What can be compared
is the error after a short time (`pipeline.scoring.horizons`), and how often the motion is where and how its power is
spread over the frequencies.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.signal import welch

from pipeline.numerics.arrays import FloatArray, longest_run

Simulate = Callable[[FloatArray, FloatArray, float, float], FloatArray]
"""``(t, v, q0, qdot0) -> q`` of shape (N,), NaN after a divergence."""

NUDGE = 1e-9
"""How far the second run starts beside the first, a share of the range of q."""

PARTED = 1e-2
"""Share of the range at which two runs have parted: ten million times the nudge, which no pulse near a separatrix
brings about by chance."""

SEGMENTS = 8
"""Half-overlapping parts of a record over which its spectrum is averaged, but for one."""

LEAST = 64
"""Samples below which a record has no statistics."""


@dataclass(frozen=True)
class Statistics:
    """How far two stationary motions are apart whose time histories cannot be compared.

    Attributes
    ----------
    histogram : float
        Mean distance by which one distribution of q must be moved to become the other (Wasserstein's first distance),
        over the range of q.
    spectrum : float
        Norm of the difference of the amplitude spectra over the norm of the measured one; 0 for equal spectra.
    """

    histogram: float
    spectrum: float


def parted_at(first: FloatArray, second: FloatArray, span: float) -> int | None:
    """Sample at which two runs of q, shape (N,), that started `NUDGE` of the range `span` apart have parted.

    None where they do not part, or one of them is not finite: then the motion is not known to be chaotic.
    """
    distance = np.abs(second - first) / span
    if not np.isfinite(distance).all() or not np.any(distance > PARTED):
        return None
    return int(np.argmax(distance > PARTED))


def lyapunov_exponent(
    simulate: Simulate, t: FloatArray, v: FloatArray, q: FloatArray, qdot: FloatArray, span: float,
    made: FloatArray | None = None,
) -> float | None:  # fmt: skip
    """Largest Lyapunov exponent [1/s] of a model along a log: growth of a nudge per time, averaged over the log.

    Pairs of runs start at the measured state, end where they have parted (or after twice the time in which the first
    pair did), and the next pair starts there (Benettin 1980, doi:10.1007/BF02128236).

    Parameters
    ----------
    simulate : callable
        The free run of a model, displacement only.
    t, q, qdot : FloatArray, shape (N,)
        Uniform time [s] and measured state, known at the first sample; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    span : float
        Range of q.
    made : FloatArray, shape (N,), optional
        The free run from the first sample, where it is known.

    Returns
    -------
    float or None
        None where the free run does not part from one beside it. Cost: two free runs, six for a chaotic log.
    """

    def pair(start: int, stop: int) -> tuple[FloatArray, FloatArray]:
        """Two runs over these rows, `NUDGE` apart at their start."""
        rows, q0, qdot0 = slice(start, stop), float(q[start]), float(qdot[start])
        whole = (start, stop) == (0, len(t))
        first = made if whole and made is not None else simulate(t[rows], v[rows], q0, qdot0)
        return first, simulate(t[rows], v[rows], q0 + NUDGE * span, qdot0)

    first = parted_at(*pair(0, len(t)), span)
    if first is None:
        return None
    growth, start, spent = 0.0, 0, 0
    known = np.flatnonzero(np.isfinite(q) & np.isfinite(qdot))
    while start + 1 < len(t):
        runs = pair(start, min(start + 2 * first + 2, len(t)))
        found = parted_at(*runs, span)
        last = len(runs[0]) - 1 if found is None else found
        distance = abs(runs[1][last] - runs[0][last]) / span
        if np.isfinite(distance) and (found is not None or start == 0 or last >= first):
            growth, spent = growth + float(np.log(max(distance, NUDGE**2) / NUDGE)), spent + last
        following = known[known >= start + max(1, last)]
        start = int(following[0]) if following.size else len(t)
    rate = growth / (spent * float(t[1] - t[0]))
    return rate if rate > 0.0 else None


def statistics(measured: FloatArray, calculated: FloatArray, interval: float) -> Statistics | None:
    """Distances of the distributions and spectra of two records of q.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,) and (M,)
        Records; NaN where masked. Both are cut to the longest stretch without NaN.
    interval : float
        Sample interval [s].

    Returns
    -------
    Statistics or None
        None with fewer than `LEAST` samples, or a measured record that is constant. Cost: that of sorting both.
    """
    a, b = measured[longest_run(np.isfinite(measured))], calculated[longest_run(np.isfinite(calculated))]
    count = min(a.size, b.size)
    span = float(np.ptp(a)) if a.size else 0.0
    if count < LEAST or span == 0.0:
        return None
    shares = (np.arange(count) + 0.5) / count
    moved = float(np.mean(np.abs(_quantiles(a, shares) - _quantiles(b, shares)))) / span
    length = 2 * count // SEGMENTS
    spectra = [np.sqrt(welch(x, 1.0 / interval, nperseg=length)[1]) for x in (a, b)]
    return Statistics(moved, float(np.linalg.norm(spectra[0] - spectra[1]) / np.linalg.norm(spectra[0])))


def _quantiles(values: FloatArray, shares: FloatArray) -> FloatArray:
    """As `numpy.quantile`, whose time for as many shares as values grows with their square."""
    return np.interp(shares * (values.size - 1), np.arange(values.size), np.sort(values))


def statistics_of_halves(measured: FloatArray, interval: float) -> Statistics | None:
    """The same between the halves of one record: what chance alone makes of a log that is half as long."""
    half = len(measured) // 2
    return statistics(measured[:half], measured[half:], interval)
