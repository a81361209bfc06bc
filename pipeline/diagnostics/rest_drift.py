"""Whether the places at which a device rests move in one direction over a log, as of a sensor that warms up."""

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray
from ..scoring.wells import NoWells, Wells, end_of_rest, places_of_rest
from . import limits


def rest_drift(
    t: FloatArray, q: FloatArray, v: FloatArray, interval: float, wells: Wells | NoWells, plant: Device
) -> float | None:
    """The common slope of the rests in both wells over time, by least squares; None where it is not sure or small.

    A rest in which q still swings counts the less.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Times [s] and displacement [m or rad]; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Step of the times [s].
    wells : Wells or NoWells
        Where the device rests.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    float or None
        [m/s or rad/s].
    """
    ends = [end_of_rest(rest, interval) for rest in places_of_rest(q, v, interval, plant=plant)]
    reach = float(np.nanmax(q) - np.nanmin(q))
    ends = [rows for rows in ends if np.isfinite(q[rows]).all()]
    times = np.array([np.mean(t[rows]) for rows in ends])
    places = np.array([np.median(q[rows]) for rows in ends])
    right = places > wells.barrier if isinstance(wells, Wells) else np.zeros(places.size, dtype=np.bool_)
    sides = [side for side in (~right, right) if side.any()]
    design = np.column_stack([*sides, times]) if sides else np.empty((0, 1))
    if len(design) <= 2 * design.shape[1] or reach == 0.0:
        return None
    sizes = np.array([np.hypot(np.ptp(q[rows]), limits.DRIFT * reach) for rows in ends])
    design = design / sizes[:, None]
    weights = np.linalg.lstsq(design, places / sizes, rcond=None)[0]
    left = places / sizes - design @ weights
    scatter = float(left @ left) / (len(design) - design.shape[1])
    error = float(np.sqrt(scatter * np.linalg.pinv(design.T @ design)[-1, -1]))
    rate = float(weights[-1])
    moved = abs(rate) * float(np.ptp(t))
    return rate if abs(rate) > limits.SURE * error and moved > limits.DRIFT * reach else None
