"""Whether the places at which a device rests move in one direction over a log: a sensor that warms up, a mount that
slips.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.wells import NoWells, Wells
from pipeline.scoring.wells import rests as quiet_rows

_LAST = 3
"""Part of a rest, its last third, whose median is its place."""
_SETTLED = 0.035
"""Share of the range of q within which it stays there."""
_FEWEST = 5
"""Rests that distinguish a drift from creep."""
_SURELY, _REMARKABLE = 4.0, 0.02
"""Standard errors, and share of the range over the whole log, that a drift exceeds."""


@dataclass(frozen=True)
class RestDrift:
    """A drift of the rests: its rate with standard error [m/s or rad/s], and from how many rests."""

    rate: float
    error: float
    rests: int


def rest_drift(
    t: FloatArray, q: FloatArray, v: FloatArray, interval: float, wells: Wells | NoWells, *, joint: bool
) -> RestDrift | None:
    """The common slope of the rests in both wells over time, by least squares; None where none is sure or remarkable.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Times [s] and displacement; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Step of the times [s].
    wells : Wells or NoWells
        Where the device rests.
    joint : bool
        Whether the device can be the bistable joint.
    """
    reach, times, places = float(np.nanmax(q) - np.nanmin(q)), [], []
    for rows in quiet_rows(v, interval, joint=joint):
        last = slice(rows.stop - max(1, (rows.stop - rows.start) // _LAST), rows.stop)
        if np.isfinite(q[last]).all() and np.ptp(q[last]) < _SETTLED * reach:
            times.append(float(np.mean(t[last])))
            places.append(float(np.median(q[last])))
    at, place = np.array(times), np.array(places)
    middle = 0.5 * (wells.left + wells.right) if isinstance(wells, Wells) else -np.inf
    sides = [side for side in (place <= middle, place > middle) if np.count_nonzero(side) > 1]
    taken = np.any(sides, axis=0) if sides else np.zeros(0, dtype=np.bool_)
    count = int(np.count_nonzero(taken))
    if count < _FEWEST:
        return None
    design = np.column_stack([*(side[taken] for side in sides), at[taken] - at[taken].mean()])
    weights = np.linalg.lstsq(design, place[taken], rcond=None)[0]
    left = place[taken] - design @ weights
    scatter = float(left @ left) / max(count - design.shape[1], 1)
    error = float(np.sqrt(scatter * np.linalg.pinv(design.T @ design)[-1, -1]))
    drift = RestDrift(float(weights[-1]), error, count)
    sure = abs(drift.rate) > _SURELY * error and abs(drift.rate) * float(np.ptp(t)) > _REMARKABLE * reach
    return drift if sure else None
