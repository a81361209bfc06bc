"""Validate: free runs of the identified models on every log, from its first valid sample under the measured voltages.

Beside each run stands what it leaves open: errors by horizon, pulses whose well is not sure, states never trained on.
"""

import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from ..device.device import Device, device
from ..device.parameter_sets import parameter_values
from ..device.parameters import JointParameters
from ..diagnostics.facts.characteristics import believed_wells, stable_rests
from ..models.analytical.statics import RotationMap, rotation_map
from ..models.base import DynamicModel, FreeRun, HasTubes, predictor
from ..models.free_runs import DRAWS, drawn_runs, free_run, tube_columns, tubes_of
from ..models.model_type import model_from_tree
from ..models.tubes import Tubes
from ..numerics.arrays import FloatArray
from ..scoring.horizons import SHORTEST_HORIZON, HorizonError, MeasuredPath, Predict, horizon_errors
from ..scoring.wells import NoWells, Wells, places_of_rest, pulse_outcomes, wells_of
from ..settings.prototype import Prototype
from ..signals.log import Log
from ..store import layout, schemas
from ..store.run_folder import RunFolder, Written
from ..units.units import HORIZONS
from .engine import TIMES, Task
from .logs import load_motion, sources

ALGORITHM = "29"

_RESTARTS = 60


def tasks(prototype: Prototype, parameters: JointParameters | None, models: Sequence[str]) -> list[Task]:
    """One task per identified model."""
    return [task(prototype, parameters, "validate", name, layout.MODELS) for name in models]


def task(prototype: Prototype, parameters: JointParameters | None, stage: str, model: str, source: str) -> Task:
    """The free runs of `model`, which the artifact `source` holds.

    Parameters
    ----------
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of a joint, for φ.
    stage : str
        Stage that the free runs belong to.
    model : str
        Name of the model.
    source : str
        Artifact that holds it.
    """
    logs = [(role, log) for role, log, _ in layout.logs(prototype)]
    return Task(
        stage=stage,
        title=f"free run of {model}",
        algorithm=ALGORITHM,
        settings={
            "model": model,
            "parameters": parameter_values(parameters),
            "inputs_before": prototype.plant.inputs_before,
        },
        inputs=(source, *sources(prototype)),
        outputs=tuple(layout.predictions(role, log, model) for role, log in logs),
        work=partial(_predict, prototype=prototype, parameters=parameters, name=model, source=source),
    )


def _predict(
    run: RunFolder, prototype: Prototype, parameters: JointParameters | None, name: str, source: str
) -> Mapping[str, Written]:
    plant = device(prototype)
    model = model_from_tree(name, run.read_tree(source, name))
    rotation = rotation_map(parameters)
    written: dict[str, Written] = {}
    logs = {(role, name): load_motion(run, prototype, role, name) for role, name, _ in layout.logs(prototype)}
    trained = [log for (role, _), log in logs.items() if role == "train"]
    seen = stable_rests(model, [log.q for log in trained])
    wells = believed_wells(wells_of(list(logs.values()), joint=plant.joint), name, seen, joint=plant.joint)
    for (role, log_name), log in logs.items():
        if not written:
            _compile(model, log)
        began = time.process_time()
        result = free_run(log, model)
        notes: dict[str, Any] = {TIMES: {"simulate_s": time.process_time() - began}}
        ahead = {name: seconds for name, (seconds, _) in HORIZONS.items()}
        notes["horizons"] = _horizons(log, model, ahead, joint=plant.joint)
        notes["basis_functions"] = model.describe().get("basis_functions")
        ensemble = drawn_runs(log, model) if isinstance(model, HasTubes) or isinstance(wells, Wells) else None
        notes |= {"stable_rests": seen} | trust_notes(log, wells, trained, ensemble, joint=plant.joint)
        tubes = tubes_of(result.q, ensemble, model)
        notes["in_tube"] = None if tubes is None else tubes.coverage(log.q)
        artifact = layout.predictions(role, log_name, name)
        written[artifact] = _write(run, artifact, plant, rotation, result, tubes, notes)
    return written


def _compile(model: DynamicModel, log: Log) -> None:
    """Have the model's kernels compiled, which is done once per machine and is no part of the time of a run."""
    free_run(log.parts()[0].part(0, 3), model)


def measured_path(log: Log, model: DynamicModel) -> tuple[MeasuredPath, Predict]:
    """A log as the predictions of a model are compared with it, and what predicts."""
    v = log.drive_of(fine=model.fine_voltages).copy()
    v[~log.recorded] = np.nan
    return MeasuredPath(log.t, v, log.q, log.qdot), predictor(model)


def _horizons(log: Log, model: DynamicModel, horizons: Mapping[str, float], *, joint: bool) -> dict[str, Any]:
    """NRMSE of q after fixed times, from restarts along the log; none after times that its samples do not have."""
    shortest = SHORTEST_HORIZON * log.interval
    longest = log.duration
    possible = {name: h for name, h in horizons.items() if h == 0.0 or shortest * (1.0 - 1e-9) <= h <= longest}

    path, predict = measured_path(log, model)
    horizon_scores = horizon_errors(predict, path, list(possible.values()), joint=joint, most_starts=_RESTARTS)
    errors = dict(zip(possible, horizon_scores, strict=True))
    return {name: asdict(errors.get(name, HorizonError(h, None, None, 0, 0))) for name, h in horizons.items()}


def _write(
    run: RunFolder,
    artifact: str,
    plant: Device,
    rotation: RotationMap | None,
    result: FreeRun,
    tubes: Tubes | None,
    notes: Mapping[str, Any],
) -> Written:
    columns = {"t": result.t, "q": result.q, "qdot": result.qdot, "qddot": result.qddot}
    if tubes is not None:
        columns |= tube_columns(tubes)
    if rotation is not None:
        columns["phi"] = rotation(result.q)
    outcome = {"status": result.status, "diverged_at_s": result.diverged_at_s}
    schema = schemas.schema_of(schemas.PREDICTIONS, plant, phi=rotation is not None, tubes=tubes is not None)
    return run.write_table(artifact, schema, columns, {**outcome, **notes})


def trust_notes(
    log: Log, wells: Wells | NoWells, trained: Sequence[Log], ensemble: FloatArray | None, *, joint: bool
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
    joint : bool
        Whether the device can be the bistable joint.

    Returns
    -------
    dict
        ``outside_training``, share of the log's samples in states (q, q̇) that no training sample was near, and
        ``outcomes``: for each rest after a pulse its end ``at_s``, the probability ``right`` of the well at larger q,
        and whether it is ``ambiguous``; None for a model without an ensemble or a device without two wells.
    """
    from ..fitting.coverage import share_outside

    return {
        "outside_training": share_outside(*_valid([log]), *_valid(trained)),
        "outcomes": _outcomes(log, wells, ensemble, joint=joint),
    }


def _valid(logs: Sequence[Log]) -> tuple[FloatArray, FloatArray]:
    return np.concatenate([log.known_q for log in logs]), np.concatenate([log.qdot[log.valid] for log in logs])


def _outcomes(log: Log, wells: Wells | NoWells, ensemble: FloatArray | None, *, joint: bool) -> dict[str, Any] | None:
    places = log.part_rows()
    rests = places_of_rest(log.q, log.v, log.interval, joint=joint)
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
