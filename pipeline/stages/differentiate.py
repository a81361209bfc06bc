"""Differentiate: velocity and acceleration of every log, stretch by stretch."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from pipeline.artifacts import schemas
from pipeline.artifacts.run_folder import RunFolder, Written
from pipeline.artifacts.tables import Table
from pipeline.numerics.arrays import FloatArray
from pipeline.settings import Prototype, Role
from pipeline.stages import layout
from pipeline.stages.device import device
from pipeline.stages.engine import Task

ALGORITHM = "1"

# alpha and epsilon are set for q in mm or in degrees.
_ALPHA_UNIT = {"m": 1e-3, "rad": np.pi / 180.0}


def tasks(prototype: Prototype) -> list[Task]:
    """One task per log."""
    return [_task(prototype, role, log) for role, log, _ in layout.logs(prototype)]


def _task(prototype: Prototype, role: Role, log: str) -> Task:
    return Task(
        stage="differentiate",
        title=f"{role}/{log}",
        algorithm=ALGORITHM,
        settings={"differentiate": prototype.differentiate.model_dump(mode="json")},
        inputs=(layout.record(role, log), layout.signals(role, log)),
        outputs=(layout.kinematics(role, log),),
        work=lambda run: _differentiate(run, prototype, role, log),
    )


def _differentiate(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Mapping[str, Written]:
    signals = run.read_table(layout.signals(role, log))
    fine = run.read_table(layout.record(role, log)) if prototype.differentiate.rate == "record" else signals
    plant = device(prototype)
    qdot, qddot, notes = derivatives(fine, signals["t"], prototype, _ALPHA_UNIT[plant.displacement.symbol])
    masked = signals["segment"] < 0
    columns = signals | {"qdot": np.where(masked, np.nan, qdot), "qddot": np.where(masked, np.nan, qddot)}
    name = layout.kinematics(role, log)
    return {name: run.write_table(name, plant.schema(schemas.KINEMATICS), columns, notes)}
