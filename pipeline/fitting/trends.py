"""Slow change of a quantity over repeated measurements of one device: none, a straight line, or one step.

Weighted least squares with the standard errors of the measurements, raised where the scatter about the better model is
larger (Birge 1932, doi:10.1103/PhysRev.40.207). Line and steps each move a constant along one direction. The null
distribution of the largest gain among them is simulated for the times and errors at hand.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from scipy.special import stdtrit

from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_95

FEWEST = 4
FEWEST_STEP = FEWEST + 2
"""Measurements from which a line and a step are looked for: three lie near some line by chance."""
_DRAWS = 20_000
_SEED = 2026
_WALKS = np.concatenate([[0.0], np.geomspace(1e-3, 1e4, 57)])
"""Variances of the random walk over the whole time, in mean squared errors."""


@dataclass(frozen=True)
class Trend:
    """Change of a quantity over time.

    Attributes
    ----------
    kind : {"unknown", "none", "line", "step"}
        "unknown" with fewer than `FEWEST` measurements, "none" where chance explains what is seen.
    slope, slope_error : float or None
        Of the straight line a unit of time, and half of its 95 % interval; None where unknown.
    step, step_error : float or None
        Size of the best step and half of its 95 % interval at that place; None below `FEWEST_STEP` measurements.
    at : float or None
        Time of the first measurement after the best step; None likewise.
    after, before : float or None
        Times of the measurements between which the step lies with 95 %; None likewise.
    """

    kind: Literal["unknown", "none", "line", "step"]
    slope: float | None = None
    slope_error: float | None = None
    step: float | None = None
    step_error: float | None = None
    at: float | None = None
    after: float | None = None
    before: float | None = None


def trend(t: FloatArray, y: FloatArray, errors: FloatArray, alarm: float) -> Trend:
    """The change that n measurements show.

    Parameters
    ----------
    t, y, errors : FloatArray, shape (n,)
        Times, ascending, values, and their standard errors.
    alarm : float
        Probability with which a change may be claimed where there is none.
    """
    n = len(t)
    if n < FEWEST:
        return Trend("unknown")
    places = np.arange(2, n - 1) if n >= FEWEST_STEP else np.arange(0)
    shapes = np.array([t - t[0], *(np.arange(n) >= place for place in places)], dtype=np.float64)
    constant = 1.0 / errors
    weighted = shapes / errors
    constant /= np.linalg.norm(constant)
    free = weighted - np.outer(weighted @ constant, constant)
    lengths = np.linalg.norm(free, axis=1)
    directions = free / lengths[:, None]
    left = y / errors - (y / errors @ constant) * constant
    moved = directions @ left
    misfits = np.maximum(left @ left - moved**2, 0.0)
    scatter = np.maximum(misfits / (n - 2), 1.0)
    half = stdtrit(n - 2, 0.975) * np.sqrt(scatter) / lengths
    chance = _chance(directions, constant, float((moved**2 / scatter).max()))
    line = Trend("line" if chance < alarm else "none", float(moved[0] / lengths[0]), float(half[0]))
    if not len(places):
        return line
    best = 1 + int(np.argmin(misfits[1:]))
    near = places[misfits[1:] <= misfits[best] + NORMAL_95**2 * scatter[best]]
    # The place of a step is one more number to choose (BIC).
    stepped = chance < alarm and misfits[best] / scatter.min() + np.log(n) < misfits[0] / scatter.min()
    return replace(
        line,
        kind="step" if stepped else line.kind,
        step=float(moved[best] / lengths[best]),
        step_error=float(half[best]),
        at=float(t[places[best - 1]]),
        after=float(t[near[0] - 1]),
        before=float(t[near[-1]]),
    )


def _chance(directions: FloatArray, constant: FloatArray, gain: float) -> float:
    """Share of simulated measurements without a change whose largest gain is at least this one."""
    noise = np.random.default_rng(_SEED).standard_normal((_DRAWS, len(constant)))
    noise -= np.outer(noise @ constant, constant)
    squares = (noise @ directions.T) ** 2
    left = np.sum(noise**2, axis=1)[:, None] - squares
    largest = np.max(squares / np.maximum(left, np.finfo(float).tiny), axis=1) * (len(constant) - 2)
    return float((1 + np.count_nonzero(largest >= gain)) / (1 + _DRAWS))


def smoothed(t: FloatArray, y: FloatArray, errors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values of a device that changes little, from all measurements together, and their standard errors.

    The prior is a random walk from anywhere, whose speed is the one with the largest likelihood; both results have
    shape (n,). It is the Rauch–Tung–Striebel smoother, written with covariances.
    """
    size = float(np.mean(errors**2))
    walk = np.minimum.outer(t - t[0], t - t[0]) / max(float(t[-1] - t[0]), np.finfo(float).tiny)
    anywhere = 1e6
    moved = (y - y.mean()) / np.sqrt(size)
    noise = np.diag(errors**2 / size)
    priors = [speed * walk + anywhere for speed in _WALKS]
    unlikely = [moved @ np.linalg.solve(p + noise, moved) + np.linalg.slogdet(p + noise)[1] for p in priors]
    prior = priors[int(np.argmin(unlikely))]
    gain = np.linalg.solve(prior + noise, prior).T
    variances = np.maximum(np.diag(gain @ noise), 0.0)  # (P − P (P + N)⁻¹ P) = P (P + N)⁻¹ N
    return y.mean() + np.sqrt(size) * (gain @ moved), np.sqrt(size * variances)
