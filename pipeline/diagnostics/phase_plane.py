"""The plane of q and q̇: where the device moved without voltage, and the well in which a model comes to rest."""

from typing import Any

import numpy as np

from ..models.base import DynamicModel, SimulatesMany
from ..numerics.arrays import FloatArray
from .run_data import LogData, RunData

BASIN_COLUMNS = 41
BASIN_ROWS = 29
BASIN_TIME, BASIN_STEP = 2.5, 0.01  # s; seven periods decide the well, and the step of the signals
UNFORCED = 0.05  # of the largest input: its square is a quarter of a per cent, within what probes read at rest
ON = 0.3  # of an input's largest value: there it acts on the motion
VISITED = 0.01  # share of the training samples at either end that count as not visited for the frame
MARGIN = 0.04
"""Margin on either side of the map of the basins, as a share of the measured range."""

OUTCOMES = ("ends in the left well", "ends in the right well", "diverges")
"""Outcome of a cell, by its class in `basin_map`."""

Classes = np.ndarray[Any, np.dtype[np.int8]]


def settled(model: DynamicModel, starts: FloatArray, seconds: float, step: float, inputs: int) -> FloatArray:
    """Displacement after a free run without input.

    Parameters
    ----------
    model : DynamicModel
        Any; one that `SimulatesMany` takes them all at once.
    starts : FloatArray, shape (n, 2)
        Displacement [m or rad] and its rate of each run.
    seconds, step : float
        Length of the runs and sample interval [s].
    inputs : int
        Number of the model's inputs.

    Returns
    -------
    FloatArray, shape (n,)
        NaN where the run diverged.

    Notes
    -----
    Cost: one free run a cell, 0.2 ms for 2.5 s of the hybrid joint.
    """
    t = np.arange(0.0, seconds, step)
    v = np.zeros((len(t), inputs))
    if isinstance(model, SimulatesMany):
        return model.simulate_many(t, v, starts)[:, -1]
    return np.array([model.simulate(t, v, float(q), float(rate)).q[-1] for q, rate in starts])


def visited_range(data: RunData, side: int | None = None) -> tuple[float, float]:
    """The range of q that holds all but the outermost training samples, or those at which an input is on."""
    q = np.concatenate([log.motion.q for log in data.role("train")])
    if side is not None:
        v = np.abs(np.concatenate([log.motion.v[:, side] for log in data.role("train")]))
        on = (v > ON * v.max()) & np.isfinite(q)
        q = q[on] if on.any() else q
    low, high = np.nanquantile(q, [VISITED, 1.0 - VISITED])
    return float(low), float(high)


def unforced(data: RunData, log: LogData) -> tuple[FloatArray, FloatArray]:
    """Displacement and velocity of a log, NaN where an input acts: basins do not describe such a motion."""
    largest = np.max([data.device.peaks(other.motion.v) for other in data.logs], axis=0)
    free = np.all(np.abs(log.motion.v) <= UNFORCED * largest, axis=1)
    return np.where(free, log.motion.q, np.nan), np.where(free, log.motion.qdot, np.nan)


def basin_map(data: RunData, model: DynamicModel, saddle: float) -> tuple[FloatArray, FloatArray, Classes]:
    """Grid of the measured places (n,) and speeds (m,), and the outcome from each point (m, n), a number of `OUTCOMES`.

    The model is released at each of them without input and simulated for `BASIN_TIME` s; `saddle` separates the wells.
    """
    places = _span(data, "q", BASIN_COLUMNS)
    speeds = _span(data, "qdot", BASIN_ROWS)
    starts = np.stack(np.meshgrid(places, speeds), axis=-1).reshape(-1, 2)
    ends = settled(model, starts, BASIN_TIME, BASIN_STEP, len(data.device.inputs)).reshape(BASIN_ROWS, BASIN_COLUMNS)
    return places, speeds, np.where(np.isnan(ends), 2, ends > saddle).astype(np.int8)


def _span(data: RunData, name: str, count: int) -> FloatArray:
    """Grid lines over all that was measured of a signal, and a little more."""
    values = np.concatenate([getattr(log.motion, name) for log in data.logs])
    margin = MARGIN * np.ptp(values[np.isfinite(values)])
    return np.linspace(np.nanmin(values) - margin, np.nanmax(values) + margin, count)
