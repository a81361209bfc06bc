"""Identify: models from the kinematics of the training logs."""

import json
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from pipeline.artifacts.run_folder import RunFolder, Written
from pipeline.numerics.trajectory import Trajectory
from pipeline.settings import Prototype
from pipeline.stages import layout
from pipeline.stages.device import Device, device
from pipeline.stages.engine import Task
from pipeline.stages.joint_parameters import recorded
from pipeline.stages.trajectories import trajectories

if TYPE_CHECKING:
    from pipeline.physics.parameters import JointParameters

ALGORITHM = "1"


def tasks(prototype: Prototype, parameters: "JointParameters | None") -> list[Task]:
    """One task for all identified models: they share `model.h5`."""
    settings = {
        "identify": prototype.identify.model_dump(mode="json"),
        "plant": prototype.plant.model_dump(mode="json"),
        "parameters": recorded(parameters),
    }
    return [
        Task(
            stage="identify",
            title=", ".join(prototype.identify.models),
            algorithm=ALGORITHM,
            settings=settings,
            inputs=tuple(layout.kinematics(role, log) for role, log, _ in layout.logs(prototype) if role == "train"),
            outputs=(layout.MODELS,),
            work=lambda run: _identify(run, prototype, parameters, settings),
        )
    ]


def training_trajectories(run: RunFolder, prototype: Prototype) -> list[Trajectory]:
    """The gap-free stretches of all training logs."""
    return [
        trajectory
        for role, log, _ in layout.logs(prototype)
        if role == "train"
        for trajectory in trajectories(run.read_table(layout.kinematics(role, log)))
    ]


def _identify(
    run: RunFolder, prototype: Prototype, parameters: "JointParameters | None", settings: Mapping[str, Any]
) -> dict[str, Written]:
    data, plant = training_trajectories(run, prototype), device(prototype)
    tree: dict[str, Any] = {
        "units": {"q": plant.displacement.symbol, "v": plant.inputs[0].symbol, "t": "s"},
        "settings_json": json.dumps(settings, sort_keys=True),
    }
    notes: dict[str, Any] = {}
    for name in prototype.identify.models:
        model = _RECIPES[name](data, prototype, plant)
        tree[name] = model.to_tree()
        notes[name] = model.describe()
    return {layout.MODELS: run.write_tree(layout.MODELS, tree, notes)}


def _rbf_paper(data: list[Trajectory], prototype: Prototype, plant: Device) -> Any:
    from pipeline.models.rbf_paper import identify_rbf_paper

    return identify_rbf_paper(
        data,
        basis_functions=prototype.identify.basis_functions,
        smoothing=prototype.identify.smoothing,
        mass=plant.mass,
        inputs=plant.action,
    )


_RECIPES: dict[str, Callable[[list[Trajectory], Prototype, Device], Any]] = {"rbf-paper": _rbf_paper}
