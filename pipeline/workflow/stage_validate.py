"""Validate: free runs of the identified models on every log, from its first valid sample under the measured voltages.

Beside each run stands what it leaves open: errors by horizon, pulses whose well is not sure, states never trained on.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from ..device.device import Device, device
from ..device.parameter_sets import parameter_values
from ..device.parameters import JointParameters
from ..diagnostics.facts.characteristics import believed_wells, stable_rests
from ..models.analytical.statics import RotationMap, rotation_map
from ..models.base import DynamicModel, FreeRun
from ..models.free_runs import Tubes, free_run, tube_columns
from ..models.model_type import model_from_tree
from ..scoring.wells import wells_of
from ..settings.prototype import Prototype
from ..signals.log import Log
from ..store import layout, schemas
from ..store.run_folder import RunFolder, Written
from .engine import Task
from .logs import load_motion, sources
from .steps.validate import validated

ALGORITHM = "29"


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
    wells = believed_wells(wells_of(list(logs.values()), plant=plant), name, seen, plant=plant)
    for (role, log_name), log in logs.items():
        if not written:
            _compile(model, log)
        result, tubes, notes = validated(log, model, wells, trained, plant)
        artifact = layout.predictions(role, log_name, name)
        written[artifact] = _write(run, artifact, plant, rotation, result, tubes, {"stable_rests": seen} | notes)
    return written


def _compile(model: DynamicModel, log: Log) -> None:
    """Have the model's kernels compiled, which is done once per machine and is no part of the time of a run."""
    free_run(log.parts()[0].part(0, 3), model)


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
