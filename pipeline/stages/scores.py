"""Scores: every free run against its log, one row per log, model and signal."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.artifacts import schemas
from pipeline.artifacts.run_folder import RunFolder, Written
from pipeline.artifacts.tables import Table
from pipeline.settings import Prototype, Role
from pipeline.stages import layout
from pipeline.stages.device import device
from pipeline.stages.engine import Task
from pipeline.stages.pitch import pitch_map
from pipeline.stages.trajectories import voltages

ALGORITHM = "1"

SIGNALS = ("q", "phi", "qdot", "qddot")


def task(prototype: Prototype, models: Sequence[str]) -> Task:
    """Score these models on every log."""
    logs = [(role, log) for role, log, _ in layout.logs(prototype)]
    return Task(
        stage="scores",
        title="NRMSE table",
        algorithm=ALGORITHM,
        settings={"models": list(models), "parameters": prototype.plant.parameters},
        inputs=tuple(
            name
            for role, log in logs
            for name in (layout.kinematics(role, log), *(layout.predictions(role, log, model) for model in models))
        ),
        outputs=(layout.SCORES,),
        work=lambda run: _score(run, prototype, models),
    )


def scored_models(run: RunFolder, prototype: Prototype) -> tuple[str, ...]:
    """The identified models, and those rivals whose free runs belong to the kinematics of today."""
    rivals = [
        model
        for model in prototype.compare.models
        if all(_fresh(run, role, log, model) for role, log, _ in layout.logs(prototype))
    ]
    return (*prototype.identify.models, *rivals)


def _fresh(run: RunFolder, role: Role, log: str, model: str) -> bool:
    made = run.manifest.artifacts.get(layout.predictions(role, log, model))
    source = layout.kinematics(role, log)
    return made is not None and made.recipe.inputs.get(source) == run.record(source).content_hash
