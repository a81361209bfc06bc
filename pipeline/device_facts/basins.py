"""Basins of attraction: where a model comes to rest from a grid of states, simulated only where outcomes differ."""

from collections.abc import Callable
from typing import Any

import numpy as np

from pipeline.joint.condensed_runs import run_joints
from pipeline.models.base import Model
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray

BLOCK = 8  # cells between the first look's grid lines

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
    index = np.full((speeds.size, places.size), -1, dtype=np.int8)
    rows, columns = (np.arange(0, grid.size - 1, BLOCK) for grid in (speeds, places))
    blocks = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1).reshape(-1, 2)
    side = BLOCK
    while len(blocks) and side:
        corners = blocks[:, None, :] + side * np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
        _look(index, corners.reshape(-1, 2), outcomes, places, speeds)
        found = index[corners[..., 0], corners[..., 1]]
        alike = (found == found[:, :1]).all(axis=1)
        for (i, j), value in zip(blocks[alike], found[alike, 0], strict=True):
            part = index[i : i + side + 1, j : j + side + 1]
            part[part < 0] = value
        side //= 2
        blocks = (blocks[~alike, None, :] + side * np.array([[0, 0], [0, 1], [1, 0], [1, 1]])).reshape(-1, 2)
    return index


def _look(
    index: Classes,
    cells: "np.ndarray[tuple[int, int], np.dtype[np.int64]]",
    outcomes: Callable[[FloatArray], Classes],
    places: FloatArray,
    speeds: FloatArray,
) -> None:
    """Find out the class of every cell that is not known yet."""
    missing = np.unique(cells[index[cells[:, 0], cells[:, 1]] < 0], axis=0)
    if len(missing):
        states = np.column_stack((places[missing[:, 1]], speeds[missing[:, 0]]))
        index[missing[:, 0], missing[:, 1]] = outcomes(states)


def settled(model: Model, starts: FloatArray, seconds: float, step: float, inputs: int) -> FloatArray:
    """Displacement after a free run without input.

    Parameters
    ----------
    model : Model
        Any; of the hybrid joint eight runs go at once.
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
    Cost of the hybrid joint: 0.2 ms for a run of 2.5 s; of other models as many free runs.
    """
    t = np.arange(0.0, seconds, step)
    if isinstance(model, HybridModel):
        return _settled_joint(model, starts, len(t), step)
    v = np.zeros((len(t), inputs))
    runs = (model.simulate(t, v, float(q), float(rate)) for q, rate in starts)
    return np.array([run.q[-1] if run.status == "ok" else np.nan for run in runs])


def _settled_joint(model: HybridModel, starts: FloatArray, samples: int, step: float) -> FloatArray:
    condensed, seen = model.joint, model.joint.instruments(model.theta)
    constants, count = condensed.constants(model.theta), len(starts)
    steps = condensed.substeps(model.theta, step)
    # Probes have an offset, so that no measured voltage is not no voltage.
    u = np.tile(np.asarray(seen.probe, dtype=np.float64) ** 2, (1, 2 * steps * (samples - 1) + 1, 1))
    runs = run_joints(
        np.tile(constants, (count, 1)),
        np.tile(condensed.weights(model.theta), (count, 1, 1)),
        condensed.basis,
        u,
        np.zeros(count, dtype=np.int64),
        np.tile([seen.gain, seen.offset], (count, 1)),
        starts,
        np.zeros(0),
        np.zeros(samples),
        step,
        steps,
        condensed.q_stop,
        condensed.lead,
    )
    return np.asarray(runs[:, -1, 0])
