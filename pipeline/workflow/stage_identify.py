"""Fits to the training logs: identify the models of `model.h5`, and the baselines of compare."""

import json
import time
from collections.abc import Mapping
from functools import partial
from typing import Any, get_args

from ..device.device import device
from ..device.parameters import JointParameters, parameter_values
from ..diagnostics.sentences import accepted_settings
from ..models.model_file import columns_of
from ..models.model_type import MAIN_MODEL, model_type
from ..settings.models import ENTRIES
from ..settings.prototype import FILM, Prototype, TrainingGate
from ..store import layout
from ..store.manifest import TIMES
from ..store.run_folder import RunFolder, Written
from ..system.worker_pool import OnProgress
from .engine import Task
from .prior_knowledge import known_inputs, prior_knowledge_of
from .run_contents import load_logs, sources
from .steps.identify import CHOICE, IDENTIFIED, identified, training

ALGORITHM = "67"
BASELINE_ALGORITHM = "16"


def tasks(prototype: Prototype, parameters: JointParameters | None, jobs: int) -> list[Task]:
    """One task for all identified models, which share `model.h5`; with several `jobs` two are fitted at once."""
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
            work=partial(_identify, prototype=prototype, parameters=parameters, settings=settings, jobs=jobs),
            reports=True,
        )
    ]


def _identify(
    run: RunFolder,
    on_progress: OnProgress,
    prototype: Prototype,
    parameters: JointParameters | None,
    settings: Mapping[str, Any],
    jobs: int,
) -> dict[str, Written]:
    plant = device(prototype)
    models, notes = identified(
        load_logs(run, prototype, "train"),
        prototype,
        parameters,
        prior_knowledge_of(run, prototype, parameters),
        on_progress,
        jobs,
    )
    tree: dict[str, Any] = {
        "units": {"q": plant.displacement.symbol, "v": plant.inputs[0].symbol, "t": "s"},
        "settings_json": json.dumps(settings, sort_keys=True),
        **{name: model.to_tree() for name, model in models.items()},
        MAIN_MODEL: notes[IDENTIFIED][0],
        **({"choice_json": json.dumps(notes[CHOICE], sort_keys=True)} if CHOICE in notes else {}),
    }
    columns = columns_of(plant, {name: type(model) for name, model in models.items()})
    return {layout.MODELS: run.write_tree(layout.MODELS, tree, notes, columns)}


def baseline_task(prototype: Prototype, parameters: JointParameters | None, name: str) -> Task:
    """The fit of one baseline."""
    listed = next(model for model in ENTRIES if model.name == name)
    unread = FILM | {"curves", "siblings"} | (set() if listed.takes_mass else {"mass"})
    settings = {
        "model": name,
        "compare": prototype.compare.model_dump(mode="json", exclude={"models", "curves"}),
        "plant": prototype.plant.model_dump(mode="json", exclude=unread),
        "parameters": parameter_values(parameters) if listed.needs_parameters else None,
    }
    return Task(
        stage="compare",
        title=f"fit of {name}",
        algorithm=BASELINE_ALGORITHM,
        settings=settings,
        inputs=sources(prototype, "train"),
        outputs=(layout.baseline(name),),
        work=partial(_write_fit, prototype=prototype, parameters=parameters, name=name, settings=settings),
    )


def _write_fit(
    run: RunFolder, prototype: Prototype, parameters: JointParameters | None, name: str, settings: Mapping[str, Any]
) -> Mapping[str, Written]:
    began = time.process_time()
    model = model_type(name).fit(training(load_logs(run, prototype, "train"), prototype, parameters))
    notes = {**model.describe(), TIMES: {"fit_s": time.process_time() - began}}
    tree = {name: model.to_tree(), "settings_json": json.dumps(settings, sort_keys=True)}
    artifact = layout.baseline(name)
    return {artifact: run.write_tree(artifact, tree, notes, columns_of(device(prototype), {name: type(model)}))}
