"""Compare: baselines fitted to the training logs; stage `validate` runs them as it runs the identified models."""

import json
import time
from collections.abc import Mapping
from functools import partial
from typing import Any

from ..device.device import device
from ..device.parameter_sets import parameter_values
from ..device.parameters import JointParameters
from ..models.model_file import columns_of
from ..models.model_type import model_type
from ..settings.models import ENTRIES
from ..settings.prototype import FILM, Prototype
from ..store import layout
from ..store.manifest import TIMES
from ..store.run_folder import RunFolder, Written
from .engine import Task
from .logs import load_logs, sources
from .steps.training import training

ALGORITHM = "15"


def task(prototype: Prototype, parameters: JointParameters | None, name: str) -> Task:
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
        algorithm=ALGORITHM,
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
    columns = columns_of(device(prototype), {name: type(model)})
    return {layout.baseline(name): run.write_tree(layout.baseline(name), tree, notes, columns)}
