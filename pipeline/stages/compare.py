"""Compare: rivals fitted to the same training logs, simulated and scored by the same code."""

import json
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from pipeline.loading.device import Device, device
from pipeline.loading.joint_parameters import recorded
from pipeline.runs import layout
from pipeline.runs.engine import TIMES, Task
from pipeline.runs.run_folder import RunFolder, Written
from pipeline.settings import ANALYTICAL_RIVALS, Compare, Prototype
from pipeline.stages import predict
from pipeline.stages.identify import training_trajectories

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters
    from pipeline.models.base import Model
    from pipeline.signals.trajectory import Trajectory

ALGORITHM = "5"


def tasks(prototype: Prototype, parameters: "JointParameters | None") -> list[Task]:
    """Two tasks per rival: its fit and its free runs."""
    return [
        task
        for name in prototype.rivals
        for task in (_fit(prototype, parameters, name), _free_runs(prototype, parameters, name))
    ]


def _fit(prototype: Prototype, parameters: "JointParameters | None", name: str) -> Task:
    settings = {
        "model": name,
        "compare": prototype.compare.model_dump(mode="json", exclude={"models", "curves"}),
        "plant": prototype.plant.model_dump(mode="json"),
        "parameters": recorded(parameters) if name in ANALYTICAL_RIVALS else None,
    }
    return Task(
        stage="compare",
        title=f"fit of {name}",
        algorithm=ALGORITHM,
        settings=settings,
        inputs=tuple(layout.kinematics(role, log) for role, log, _ in layout.logs(prototype) if role == "train"),
        outputs=(layout.rival(name),),
        work=lambda run: _write_fit(run, prototype, parameters, name, settings),
    )


def _free_runs(prototype: Prototype, parameters: "JointParameters | None", name: str) -> Task:
    return predict.task(prototype, parameters, "compare", name, layout.rival(name), partial(_load, name=name))


def _load(run: RunFolder, name: str) -> "Model":
    from pipeline.models.store import model_from_tree

    return model_from_tree(name, run.read_tree(layout.rival(name), name))


def _write_fit(
    run: RunFolder, prototype: Prototype, parameters: "JointParameters | None", name: str, settings: Mapping[str, Any]
) -> Mapping[str, Written]:
    began = time.process_time()
    model = fit(name, training_trajectories(run, prototype), prototype, parameters)
    notes = {**model.describe(), TIMES: {"fit_s": time.process_time() - began}}
    tree = {name: model.to_tree(), "settings_json": json.dumps(settings, sort_keys=True)}
    return {layout.rival(name): run.write_tree(layout.rival(name), tree, notes)}


def fit(name: str, data: "list[Trajectory]", prototype: Prototype, parameters: "JointParameters | None") -> Any:
    """Fit the rival `name` to gap-free stretches."""
    return _FITS[name](data, prototype.compare, device(prototype), parameters)


def _sindy(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.sindy import identify_sindy

    return identify_sindy(
        data,
        inputs=plant.action,
        mass=plant.mass,
        units=_units(plant),
        time_limit=settings.time_limit,
    )


def _sindy_default(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.sindy import identify_default_sindy

    return identify_default_sindy(data, inputs=plant.action, mass=plant.mass, units=_units(plant))


def _units(plant: Device) -> tuple[str, str]:
    return plant.displacement.symbol, plant.inputs[0].symbol


def _narx(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.narx import identify_narx

    return identify_narx(data, inputs=plant.action, time_limit=settings.time_limit)


def _gru(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.gru import identify_gru

    return identify_gru(data, inputs=plant.action, time_limit=settings.time_limit)


def _analytical(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.analytical import AnalyticalModel

    return AnalyticalModel(parameters)


def _calibrated(data: "list[Trajectory]", settings: Compare, plant: Device, parameters: Any) -> Any:
    from pipeline.models.analytical import calibrate_analytical

    return calibrate_analytical(data, parameters)


_FITS: dict[str, Callable[["list[Trajectory]", Compare, Device, Any], Any]] = {
    "sindy": _sindy,
    "sindy-default": _sindy_default,
    "narx": _narx,
    "gru": _gru,
    "analytical": _analytical,
    "analytical-calibrated": _calibrated,
}
