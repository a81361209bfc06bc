"""Validate: free runs of models on every log, from its first valid sample on, and their scores.

The notes of each run hold its errors by horizon, the pulses whose well is not sure, and the share of samples in states
that were never trained.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ..device.device import Device, device
from ..device.parameters import JointParameters, parameter_values
from ..diagnostics.characteristics import believed_wells, stable_rests
from ..models.free_runs import free_run, tube_columns
from ..models.model_type import model_from_tree
from ..numerics.arrays import FloatArray
from ..reporting.tables import NrmseTable, behaviour_table, nrmse_table
from ..scoring.wells import NoWells, Wells, wells_of
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.log import Log, log_of
from ..store import layout, schemas
from ..store.manifest import TIMES
from ..store.run_folder import RunFolder, Written, in_snapshot
from ..store.tables import Table
from ..system.names import with_true_names
from ..units.units import SIGNALS
from .engine import Task
from .run_contents import identified_models, load_motion, sources
from .steps.score import ComparedRun, rows_of_log, validated

ALGORITHM = "29"
SCORES_ALGORITHM = "12"


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
    from ..models.analytical.statics import rotation_map

    plant = device(prototype)
    model = model_from_tree(name, run.read_tree(source, name))
    rotation = rotation_map(parameters)
    written: dict[str, Written] = {}
    logs = {
        (role, log_name): load_motion(run, prototype, role, log_name) for role, log_name, _ in layout.logs(prototype)
    }
    trained = [log for (role, _), log in logs.items() if role == "train"]
    seen = stable_rests(model, [log.q for log in trained])
    wells = believed_wells(wells_of(list(logs.values()), plant=plant), name, seen, plant=plant)
    for (role, log_name), log in logs.items():
        if not written:  # have the kernels compiled, once per machine: that is no part of the time of a run
            free_run(log.parts()[0].part(0, 3), model)
        result, tubes, notes = validated(log, model, wells, trained, plant)
        artifact = layout.predictions(role, log_name, name)
        columns = {
            "t": result.t,
            "q": result.q,
            "qdot": result.qdot,
            "qddot": result.qddot,
            **({} if tubes is None else tube_columns(tubes)),
            **({} if rotation is None else {"phi": rotation(result.q)}),
        }
        notes |= {"status": result.status, "diverged_at_s": result.diverged_at_s, "stable_rests": seen}
        schema = schemas.schema_of(schemas.PREDICTIONS, plant, phi=rotation is not None, tubes=tubes is not None)
        written[artifact] = run.write_table(artifact, schema, columns, notes)
    return written


def scores_task(prototype: Prototype, parameters: JointParameters | None, models: Sequence[str]) -> Task:
    """Score these models, the main model first, on every log."""
    return Task(
        stage="scores",
        title="NRMSE table",
        algorithm=SCORES_ALGORITHM,
        settings={"models": list(models), "parameters": parameter_values(parameters)},
        inputs=tuple(
            name
            for role, log, _ in layout.logs(prototype)
            for name in (layout.kinematics(role, log), *(layout.predictions(role, log, model) for model in models))
        ),
        outputs=(layout.SCORES,),
        work=partial(_score, prototype=prototype, parameters=parameters, models=models),
    )


def scored_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """The identified models, and those baselines whose free runs belong to the kinematics of today."""
    logs = layout.logs(prototype)
    baselines = (m for m in prototype.baselines if all(_fresh(run, role, log, m) for role, log, _ in logs))
    return (*identified_models(run, prototype), *baselines)


def _fresh(run: RunFolder, role: Role, log: str, model: str) -> bool:
    record = run.manifest.artifacts.get(layout.predictions(role, log, model))
    source = layout.kinematics(role, log)
    return record is not None and record.recipe.inputs.get(source) == run.record(source).content_hash


def _score(
    run: RunFolder, prototype: Prototype, parameters: JointParameters | None, models: Sequence[str]
) -> Mapping[str, Written]:
    from ..models.analytical.statics import rotation_map

    rotation = rotation_map(parameters)
    logs = [
        (role, log, log_of(run.read_table(layout.kinematics(role, log)))) for role, log, _ in layout.logs(prototype)
    ]
    plant = device(prototype)
    rows = []
    wells = _wells(run, [measured for _, _, measured in logs], plant, layout.logs(prototype)[0][:2], models)
    for role, log, measured in logs:
        predictions = {model: layout.predictions(role, log, model) for model in models}
        runs = {
            model: ComparedRun(_pairs(measured, run.read_table(name), rotation), run.record(name).notes)
            for model, name in predictions.items()
        }
        rows += [
            {"log": log, "role": role, "headline": row["model"] == models[0]} | row
            for row in rows_of_log(plant, measured, runs, wells)
        ]
    columns = {column.key: [row.get(column.key) for row in rows] for column in schemas.SCORES.columns}
    return {layout.SCORES: run.write_table(layout.SCORES, schemas.SCORES, columns, {"wells": asdict(wells)})}


def _wells(
    run: RunFolder, logs: Sequence[Log], plant: Device, log: tuple[Role, str], models: Sequence[str]
) -> Wells | NoWells:
    """The wells in the data, unless the first of these models with curves has no two wells, as its notes state."""
    rests = {model: run.record(layout.predictions(*log, model)).notes.get("stable_rests") for model in models}
    judge = next((model for model in models if rests[model] is not None), models[0])
    return believed_wells(wells_of(logs, plant=plant), judge, rests[judge], plant=plant)


def _pairs(
    measured: Log, calculated: Table, rotation: Callable[[FloatArray], FloatArray] | None
) -> Mapping[str, tuple[FloatArray, FloatArray]]:
    pairs = {name: (getattr(measured, name), calculated[name]) for name in ("q", "qdot", "qddot")}
    if rotation is not None:
        pairs["phi"] = (np.asarray(rotation(measured.q)), calculated["phi"])
    return {name: pairs[name] for name in SIGNALS if name in pairs}


def score_tables(root: Path) -> tuple[NrmseTable, ...]:
    """Errors with fitting and simulation times, and behaviour of all models on all logs."""
    shown, times = in_snapshot(root, lambda run: (_shown(run), _times(run)))
    return tuple(table for table in (nrmse_table(shown, times), behaviour_table(shown)) if table.rows)


def shown_scores(root: Path) -> list[dict[str, Any]]:
    """The score rows of a run for readers: the logs by their true names."""
    return in_snapshot(root, _shown)


def _shown(run: RunFolder) -> list[dict[str, Any]]:
    sources = [(role, log) for role, _, log in layout.logs(run.prototype)]
    return with_true_names(run.read_records(layout.SCORES), sources)


def _times(run: RunFolder) -> dict[str, dict[str, float | None]]:
    """Processor time [s] of each model's fit and of its longest free run, as noted when they were made."""
    times: dict[str, dict[str, float | None]] = {}
    for score in run.read_records(layout.SCORES):
        model = score["model"]
        fitted = run.manifest.artifacts.get(layout.baseline(model))
        notes = fitted.notes if fitted else run.record(layout.MODELS).notes.get(model, {})
        seconds = (
            run.record(layout.predictions(score["role"], score["log"], model)).notes.get(TIMES, {}).get("simulate_s")
        )
        longest = max(filter(None, (seconds, times.get(model, {}).get("simulate_s"))), default=None)
        times[model] = {"fit_s": notes.get(TIMES, {}).get("fit_s"), "simulate_s": longest}
    return times
