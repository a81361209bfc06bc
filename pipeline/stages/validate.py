"""Validate: free runs of the identified models on every log."""

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from pipeline.runs import layout
from pipeline.runs.engine import Task
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import Prototype
from pipeline.stages import predict

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters
    from pipeline.models.base import Model


def tasks(prototype: Prototype, parameters: "JointParameters | None", models: Sequence[str]) -> list[Task]:
    """One task per identified model."""
    return [
        predict.task(prototype, parameters, "validate", name, layout.MODELS, partial(_load, name=name))
        for name in models
    ]


def _load(run: RunFolder, name: str) -> "Model":
    from pipeline.models.store import model_from_tree

    return model_from_tree(name, run.read_tree(layout.MODELS, name))
