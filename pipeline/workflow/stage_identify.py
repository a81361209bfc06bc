"""Identify: models from the kinematics of the training logs."""

import json
from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, get_args

from ..device.device import device
from ..device.parameter_sets import parameter_values
from ..device.parameters import JointParameters
from ..diagnostics.gates import accepted_settings
from ..models.model_file import columns_of
from ..models.model_type import MAIN_MODEL
from ..settings.prototype import FILM, Prototype, TrainingGate
from ..store import layout
from ..store.run_folder import RunFolder, Written
from ..system.progress import OnProgress
from .engine import Task
from .logs import load_logs, sources
from .prior_knowledge import known_inputs, prior_knowledge_of
from .steps.identify import CHOICE, IDENTIFIED, identified

if TYPE_CHECKING:
    pass

ALGORITHM = "59"


def tasks(prototype: Prototype, parameters: JointParameters | None) -> list[Task]:
    """One task for all identified models: they share `model.h5`."""
    settings = {
        "identify": prototype.identify.model_dump(mode="json"),
        "plant": prototype.plant.model_dump(mode="json", exclude=FILM | {"siblings"}),
        "parameters": parameter_values(parameters),
        **accepted_settings(prototype.quality, get_args(TrainingGate)),
    }
    return [
        Task(
            stage="identify",
            title=", ".join(prototype.identify.models),
            algorithm=ALGORITHM,
            settings=settings,
            inputs=(
                *sources(prototype, "train"),
                *known_inputs(prototype),
            ),
            outputs=(layout.MODELS,),
            work=partial(_identify, prototype=prototype, parameters=parameters, settings=settings),
            reports=True,
        )
    ]


def _identify(
    run: RunFolder,
    on_progress: OnProgress,
    prototype: Prototype,
    parameters: JointParameters | None,
    settings: Mapping[str, Any],
) -> dict[str, Written]:
    plant = device(prototype)
    data = load_logs(run, prototype, "train")
    prior = prior_knowledge_of(run, prototype, parameters)
    models, notes = identified(data, prototype, parameters, prior, on_progress)
    tree: dict[str, Any] = {
        "units": {"q": plant.displacement.symbol, "v": plant.inputs[0].symbol, "t": "s"},
        "settings_json": json.dumps(settings, sort_keys=True),
        **{name: model.to_tree() for name, model in models.items()},
        MAIN_MODEL: notes[IDENTIFIED][0],
    }
    if CHOICE in notes:
        tree["choice_json"] = json.dumps(notes[CHOICE], sort_keys=True)
    columns = columns_of(plant, {name: type(model) for name, model in models.items()})
    return {layout.MODELS: run.write_tree(layout.MODELS, tree, notes, columns)}
