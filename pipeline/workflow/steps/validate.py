"""Validate: a free run over a log, and what it leaves open: errors by horizon, doubtful pulses, unseen states."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from ...device.device import Device
from ...models.base import DynamicModel, FreeRun, HasTubes, predictor
from ...models.free_runs import DRAWS, Tubes, drawn_runs, free_run, tubes_of
from ...numerics.arrays import FloatArray
from ...scoring.scores import SHORTEST_HORIZON, HorizonError, MeasuredPath, Predict, horizon_errors
from ...scoring.wells import NoWells, Wells, places_of_rest, pulse_outcomes
from ...signals.log import Log
from ...store.manifest import TIMES
from ...units.units import HORIZONS

_RESTARTS = 60


def validated(
    log: Log, model: DynamicModel, wells: Wells | NoWells, trained: Sequence[Log], plant: Device
) -> tuple[FreeRun, Tubes | None, dict[str, Any]]:
    """The free run of a model over a log, its tubes, and notes on it.

    Parameters
    ----------
    log : Log
        The log.
    model : DynamicModel
        The model.
    wells : Wells or NoWells
        The wells of the device, as far as the model has them too.
    trained : sequence of Log
        The training logs.
    plant : Device
        How its inputs act, and whether it is the joint.
    """
    began = time.process_time()
    result = free_run(log, model)
    notes: dict[str, Any] = {TIMES: {"simulate_s": time.process_time() - began}}
    ahead = {name: seconds for name, (seconds, _) in HORIZONS.items()}
    notes["horizons"] = _horizons(log, model, ahead, plant)
    notes["basis_functions"] = model.describe().get("basis_functions")
    ensemble = drawn_runs(log, model) if isinstance(model, HasTubes) or isinstance(wells, Wells) else None
    notes |= trust_notes(log, wells, trained, ensemble, plant)
    tubes = tubes_of(result.q, ensemble, model)
    notes["in_tube"] = None if tubes is None else tubes.coverage(log.q)
    return result, tubes, notes


def measured_path(log: Log, model: DynamicModel) -> tuple[MeasuredPath, Predict]:
    """A log as the predictions of a model are compared with it, and what predicts."""
    v = log.drive_of(fine=model.fine_voltages).copy()
    v[~log.recorded] = np.nan
    return MeasuredPath(log.t, v, log.q, log.qdot), predictor(model)


def _horizons(log: Log, model: DynamicModel, horizons: Mapping[str, float], plant: Device) -> dict[str, Any]:
    """NRMSE of q after fixed times, from restarts along the log; none after times that its samples do not have."""
    shortest = SHORTEST_HORIZON * log.interval
    longest = log.duration
    possible = {name: h for name, h in horizons.items() if h == 0.0 or shortest * (1.0 - 1e-9) <= h <= longest}

    path, predict = measured_path(log, model)
    horizon_scores = horizon_errors(predict, path, list(possible.values()), plant=plant, most_starts=_RESTARTS)
    errors = dict(zip(possible, horizon_scores, strict=True))
    return {name: asdict(errors.get(name, HorizonError(h, None, None, 0, 0))) for name, h in horizons.items()}


def trust_notes(
    log: Log, wells: Wells | NoWells, trained: Sequence[Log], ensemble: FloatArray | None, plant: Device
) -> dict[str, Any]:
    """What is noted beside the free run of a model over a log.

    Parameters
    ----------
    log : Log
        The log.
    wells : Wells or NoWells
        The wells of the device.
    trained : sequence of Log
        The training logs.
    ensemble : FloatArray, shape (draws, N), or None
        Free runs of the draws, from `pipeline.models.free_runs.drawn_runs`.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    dict
        ``outside_training``, share of the log's samples in states (q, q̇) that no training sample was near, and
        ``outcomes``: for each rest after a pulse its end ``at_s``, the probability ``right`` of the well at larger q,
        and whether it is ``ambiguous``; None for a model without an ensemble or a device without two wells.
    """
    from ...fitting.information import share_outside

    return {
        "outside_training": share_outside(*_valid([log]), *_valid(trained)),
        "outcomes": _outcomes(log, wells, ensemble, plant=plant),
    }


def _valid(logs: Sequence[Log]) -> tuple[FloatArray, FloatArray]:
    return np.concatenate([log.known_q for log in logs]), np.concatenate([log.qdot[log.valid] for log in logs])


def _outcomes(log: Log, wells: Wells | NoWells, ensemble: FloatArray | None, plant: Device) -> dict[str, Any] | None:
    places = log.part_rows()
    rests = places_of_rest(log.q, log.v, log.interval, plant=plant)
    after = [rest for rest in rests if any(rows.start < rest.start and rest.stop <= rows.stop for rows in places)]
    if ensemble is None or not isinstance(wells, Wells) or not after:
        return None
    outcomes = pulse_outcomes(ensemble, after, wells)
    ends = [float(log.t[rest.stop - 1]) for rest in after]
    return {
        "draws": DRAWS,
        "at_s": ends,
        "right": outcomes.probability_right.tolist(),
        "ambiguous": outcomes.ambiguous.tolist(),
    }
