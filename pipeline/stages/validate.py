"""Validate: free runs of the identified models on every log."""

from functools import partial
from typing import TYPE_CHECKING

from pipeline.artifacts.run_folder import RunFolder
from pipeline.settings import Prototype
from pipeline.stages import layout, predict
from pipeline.stages.engine import Task

if TYPE_CHECKING:
    from pipeline.models.base import Model
    from pipeline.physics.parameters import JointParameters


def tasks(prototype: Prototype, parameters: "JointParameters | None") -> list[Task]:
    """One task per identified model."""
    return [
        predict.task(prototype, parameters, "validate", name, layout.MODELS, partial(_load, name=name))
        for name in prototype.identify.models
    ]


def _load(run: RunFolder, name: str) -> "Model":
    from pipeline.models.store import model_from_tree

    return model_from_tree(name, run.read_tree(layout.MODELS, name))
