"""The plane of q and q̇: where the device was, where it moved without voltage, and where it comes to rest from."""

import numpy as np

from pipeline.device_facts.basins import Classes, basins, settled
from pipeline.device_facts.run_data import LogData, RunData, inputs_of
from pipeline.models.base import Model
from pipeline.numerics.arrays import FloatArray

BASIN_COLUMNS, BASIN_ROWS = 81, 57
BASIN_TIME, BASIN_STEP = 2.5, 0.01  # s; seven periods decide the well, and the step of the signals
UNFORCED = 0.05  # of the largest input: its square is a quarter of a per cent, within what probes read at rest
ON = 0.3  # of an input's largest value: there it acts on the motion
VISITED = 0.01  # share of the training samples at either end that count as not visited for the frame
MARGIN = 0.04
"""Of the range of what was measured, on either side of the map of the basins."""

OUTCOMES = ("ends in the left well", "ends in the right well", "diverges")
"""What becomes of a cell, by its class in `basin_map`."""


def visited_range(data: RunData, voltage: str | None = None) -> tuple[float, float]:
    """The range of q that holds all but the outermost training samples, or those at which an input is on."""
    q = np.concatenate([log.kinematics["q"] for log in data.role("train")])
    if voltage is not None:
        v = np.abs(np.concatenate([log.kinematics[voltage] for log in data.role("train")]))
        on = (v > ON * v.max()) & np.isfinite(q)
        q = q[on] if on.any() else q
    low, high = np.nanquantile(q, [VISITED, 1.0 - VISITED])
    return float(low), float(high)


def unforced(data: RunData, log: LogData) -> tuple[FloatArray, FloatArray]:
    """Q and q̇ of a log, NaN where an input acts on the motion: basins say nothing of it there."""
    largest = max(float(np.nanmax(np.abs(inputs_of(each.kinematics)))) for each in data.logs)
    free = np.all(np.abs(inputs_of(log.kinematics)) <= UNFORCED * largest, axis=1)
    return np.where(free, log.kinematics["q"], np.nan), np.where(free, log.kinematics["qdot"], np.nan)


def basin_map(data: RunData, model: Model, saddle: float) -> tuple[FloatArray, FloatArray, Classes]:
    """Places (n,) and speeds (m,) over all that was measured, and what becomes of each (m, n), as `OUTCOMES` counts.

    The model is let go at each of them without input and simulated for `BASIN_TIME` s; `saddle` parts the wells.
    """

    def outcomes(states: FloatArray) -> Classes:
        ends = settled(model, states, BASIN_TIME, BASIN_STEP, len(data.inputs))
        return np.where(np.isnan(ends), 2, ends > saddle).astype(np.int8)

    places, speeds = _span(data, "q", BASIN_COLUMNS), _span(data, "qdot", BASIN_ROWS)
    return places, speeds, basins(outcomes, places, speeds)


def _span(data: RunData, name: str, count: int) -> FloatArray:
    """Grid lines over all that was measured of a signal, and a little more."""
    values = np.concatenate([log.kinematics[name] for log in data.logs])
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    grid: FloatArray = np.linspace(low - MARGIN * (high - low), high + MARGIN * (high - low), count)
    return grid
