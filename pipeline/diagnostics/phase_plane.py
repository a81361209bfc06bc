"""The plane of q and q̇: where the device moved without voltage, and from where a model comes to rest in which well."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..models.base import DynamicModel, SimulatesMany
from ..numerics.arrays import FloatArray, runs_of
from .run_data import LogData, RunData

BASIN_COLUMNS = 81
BASIN_ROWS = 57
BASIN_TIME, BASIN_STEP = 2.5, 0.01  # s; seven periods decide the well, and the step of the signals
UNFORCED = 0.05  # of the largest input: its square is a quarter of a per cent, within what probes read at rest
LEAST_UNFORCED = 10  # samples in a row: fewer, or an input that moves on, are the zero crossings of a steady signal
LEAST_SHARE = 0.01  # of all samples: less is what is left of a steady signal
LEAST_MOTION = 0.02  # of the range of q: what moves less without input is a dot in the plane
ON = 0.3  # of an input's largest value: there it acts on the motion
VISITED = 0.01  # share of the training samples at either end that count as not visited for the frame
MARGIN = 0.04
"""Margin on either side of the map of the basins, as a share of the measured range."""

OUTCOMES = ("ends in the left well", "ends in the right well", "diverges")
"""Outcome of a cell, by its class in `basin_map`."""
BLOCK = 8  # cells along a side of the first blocks
UNKNOWN = -1

Classes = np.ndarray[Any, np.dtype[np.int8]]


def basins(outcomes: Callable[[FloatArray], Classes], places: FloatArray, speeds: FloatArray) -> Classes:
    """Class of the outcome from every ``(places[j], speeds[i])``.

    Blocks whose four corners end alike are filled, others are halved until they hold single cells. A tongue thinner
    than a block may be missed.

    Parameters
    ----------
    outcomes : callable
        From states, shape (n, 2), to their classes, small integers not below 0, shape (n,).
    places, speeds : FloatArray
        Grid lines; a multiple of `BLOCK` plus one of each.

    Returns
    -------
    array of int8, shape (speeds.size, places.size)

    Notes
    -----
    Cost: about a fifth of the grid's simulations for one smooth boundary, in four calls.
    """
    classes = np.full((speeds.size, places.size), UNKNOWN, dtype=np.int8)
    rows, columns = (np.arange(0, grid.size - 1, BLOCK) for grid in (speeds, places))
    blocks = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1).reshape(-1, 2)
    side = BLOCK
    unit = np.array([[0, 0], [0, 1], [1, 0], [1, 1]])  # corners of a block, and the first cells of its quarters
    while len(blocks) and side:
        corners = blocks[:, None, :] + side * unit
        unknown = np.unique(corners[classes[corners[..., 0], corners[..., 1]] == UNKNOWN], axis=0)
        if len(unknown):
            row, column = unknown.T
            classes[row, column] = outcomes(np.column_stack((places[column], speeds[row])))
        ended = classes[corners[..., 0], corners[..., 1]]
        alike = (ended == ended[:, :1]).all(axis=1)
        for (i, j), value in zip(blocks[alike], ended[alike, 0], strict=True):
            block = classes[i : i + side + 1, j : j + side + 1]
            block[block == UNKNOWN] = value
        side //= 2
        blocks = (blocks[~alike, None, :] + side * unit).reshape(-1, 2)
    return classes


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
    runs = (model.simulate(t, v, float(q), float(rate)) for q, rate in starts)
    return np.array([run.q[-1] if run.status == "ok" else np.nan for run in runs])


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
    """Displacement and velocity of a log, NaN where an input acts: basins do not describe such a motion.

    The pulses of the joint have rests. For another device they are NaN also where an input only crosses zero.
    """
    largest = np.max([data.device.peaks(other.motion.v) for other in data.logs], axis=0)
    free = np.all(np.abs(log.motion.v) <= UNFORCED * largest, axis=1)
    for rows in () if data.device.joint else runs_of(free):
        still = np.all(np.ptp(log.motion.v[rows], axis=0) <= UNFORCED * largest)
        free[rows] = still and rows.stop - rows.start >= LEAST_UNFORCED
    return np.where(free, log.motion.q, np.nan), np.where(free, log.motion.qdot, np.nan)


def moves_unforced(data: RunData) -> bool:
    """True if the logs show a motion without input that is visible in the plane."""
    places = [q[np.isfinite(q)] for q, _ in (unforced(data, log) for log in data.logs)]
    low, high = _ends(data, "q")
    enough = sum(q.size for q in places) >= LEAST_SHARE * sum(len(log.motion.q) for log in data.logs)
    return enough and any(q.size > 0 and np.ptp(q) > LEAST_MOTION * (high - low) for q in places)


def basin_map(data: RunData, model: DynamicModel, saddle: float) -> tuple[FloatArray, FloatArray, Classes]:
    """Places (n,) and speeds (m,) over all that was measured, and what becomes of each (m, n), as `OUTCOMES` counts.

    The model is released at each of them without input and simulated for `BASIN_TIME` s; `saddle` separates the wells.
    """

    def outcomes(states: FloatArray) -> Classes:
        """Class of each state: 0 and 1 for rest left and right of the saddle, 2 for none."""
        ends = settled(model, states, BASIN_TIME, BASIN_STEP, len(data.device.inputs))
        return np.where(np.isnan(ends), 2, ends > saddle).astype(np.int8)

    places = _span(data, "q", BASIN_COLUMNS)
    speeds = _span(data, "qdot", BASIN_ROWS)
    return places, speeds, basins(outcomes, places, speeds)


def _span(data: RunData, name: str, count: int) -> FloatArray:
    """Grid lines over all that was measured of a signal, and a little more."""
    low, high = _ends(data, name)
    return np.asarray(np.linspace(low - MARGIN * (high - low), high + MARGIN * (high - low), count))


def _ends(data: RunData, name: str) -> tuple[float, float]:
    """Least and largest value of a signal in all logs."""
    values = np.concatenate([getattr(log.motion, name) for log in data.logs])
    return float(np.nanmin(values)), float(np.nanmax(values))
