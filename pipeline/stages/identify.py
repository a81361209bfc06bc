"""Identify: models from the kinematics of the training logs."""

import json
import time
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from pipeline.loading.device import Device, device
from pipeline.loading.joint_parameters import recorded
from pipeline.loading.trajectories import load_motion, record, sources, trajectories, voltages
from pipeline.runs import layout
from pipeline.runs.engine import TIMES, Task
from pipeline.runs.run_folder import RunFolder, Written
from pipeline.runs.tables import Table
from pipeline.settings import Identify, Prototype, TrainingGate
from pipeline.stages.quality_gate import accepted_settings, judge

if TYPE_CHECKING:
    from pipeline.identification.known_curves import KnownCurves
    from pipeline.joint.parameters import JointParameters
    from pipeline.models.choose_rbf import Rbf
    from pipeline.models.rbf import RbfModel
    from pipeline.models.rbf_candidates import RbfChoice
    from pipeline.signals.quality_gates import Finding
    from pipeline.signals.record import Record
    from pipeline.signals.trajectory import Trajectory

ALGORITHM = "7"
PRIOR_GATES: tuple[TrainingGate, ...] = ("one-well", "visits", "rank")
"""What training data need not show where the joint's equations stand in."""


def tasks(prototype: Prototype, parameters: "JointParameters | None") -> list[Task]:
    """One task for all identified models: they share `model.h5`."""
    settings = {
        "identify": prototype.identify.model_dump(mode="json"),
        "plant": prototype.plant.model_dump(mode="json"),
        "parameters": recorded(parameters),
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
            work=lambda run: _identify(run, prototype, parameters, settings),
        )
    ]


def training_tables(run: RunFolder, prototype: Prototype) -> list[Table]:
    """The kinematics of all training logs, with their fine voltages."""
    return [load_motion(run, role, log) for role, log, _ in layout.logs(prototype) if role == "train"]


def training_trajectories(run: RunFolder, prototype: Prototype) -> "list[Trajectory]":
    """The gap-free stretches of all training logs."""
    return [stretch for table in training_tables(run, prototype) for stretch in trajectories(table)]


def _identify(
    run: RunFolder, prototype: Prototype, parameters: "JointParameters | None", settings: Mapping[str, Any]
) -> dict[str, Written]:
    data, plant = training_tables(run, prototype), device(prototype)
    # The hybrid rbf has the joint's equations where data say nothing; the other models would make the curves up.
    prior = PRIOR_GATES if parameters is not None and "rbf" in prototype.identify.models else ()
    accepted = judge("training logs", _findings(data, prototype), prototype.quality, prior)
    tree: dict[str, Any] = {
        "units": {"q": plant.displacement.symbol, "v": plant.inputs[0].symbol, "t": "s"},
        "settings_json": json.dumps(settings, sort_keys=True),
    }
    notes: dict[str, Any] = {"warnings": accepted, "accepted": accepted}
    for name in prototype.identify.models:
        began = time.process_time()
        model = fit(name, data, prototype, parameters, known_table(run, prototype))
        tree[name] = model.to_tree()
        notes[name] = {**model.describe(), TIMES: {"fit_s": time.process_time() - began}}
    return {layout.MODELS: run.write_tree(layout.MODELS, tree, notes)}


def _findings(data: list[Table], prototype: Prototype) -> "list[Finding]":
    """What speaks against the training logs, taken together."""
    from pipeline.identification.excitation_gates import excitation_findings

    first = np.cumsum([0, *(table["segment"].max() + 1 for table in data[:-1])])
    segments = [np.where(t["segment"] < 0, -1, t["segment"] + k) for t, k in zip(data, first, strict=True)]
    return excitation_findings(
        np.concatenate([table["q"] for table in data]),
        np.concatenate([voltages(table) for table in data]),
        np.concatenate(segments),
        prototype.ingest.sample_interval,
        inputs=prototype.plant.inputs,
        basis_functions=prototype.identify.basis_functions,
        smoothing=prototype.identify.smoothing,
        bistable=prototype.plant.parameters is not None,
    )


def known_inputs(prototype: Prototype) -> tuple[str, ...]:
    """The artifact of the curves that the fit keeps, if the settings name them."""
    return () if prototype.plant.curves is None else (layout.KNOWN_CURVES,)


def known_table(run: RunFolder, prototype: Prototype) -> Table | None:
    """The curves that the fit keeps."""
    return next((run.read_table(name) for name in known_inputs(prototype)), None)


def fit(
    name: str,
    data: list[Table],
    prototype: Prototype,
    parameters: "JointParameters | None",
    known: Table | None = None,
) -> Any:
    """Identify the model `name` from kinematics tables and, where they were measured, `known` curves."""
    if name == "rbf":
        return _rbf(data, prototype, parameters, known)
    return _rbf_paper(data, prototype.identify, device(prototype))


def _rbf(data: list[Table], prototype: Prototype, parameters: "JointParameters | None", known: Table | None) -> "Rbf":
    from pipeline.models.identify_rbf import identify_rbf

    plant, records = device(prototype), [record(table) for table in data]
    data_driven = partial(
        identify_rbf,
        mass=plant.mass,
        inputs=plant.action,
        angle=plant.displacement.symbol == "rad",
        choice=_choice(prototype.identify),
        known=None if known is None else _known_curves(known, len(plant.inputs)),
    )
    if parameters is None:
        return data_driven(records)

    def alone(given: Sequence["Record"]) -> "RbfModel":
        # Without the joint's equations the data must show everything themselves.
        judge("training logs", _findings(data, prototype), prototype.quality)
        return data_driven(given)

    from pipeline.models.choose_rbf import choose_rbf
    from pipeline.models.identify_rbf_hybrid import identify_rbf_hybrid

    return choose_rbf(records, partial(identify_rbf_hybrid, parameters=parameters, mass=plant.known_mass), alone)


def _known_curves(table: Table, inputs: int) -> "KnownCurves":
    from pipeline.identification.known_curves import KnownCurves

    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))


def _choice(settings: Identify) -> "RbfChoice":
    from pipeline.models.rbf_candidates import RbfChoice

    return RbfChoice(
        friction=None if settings.friction == "auto" else settings.friction,
        basis_functions=None if settings.rbf_basis_functions == "auto" else settings.rbf_basis_functions,
        smoothing=None if settings.rbf_smoothing == "auto" else settings.rbf_smoothing,
    )


def _rbf_paper(data: list[Table], settings: Identify, plant: Device) -> Any:
    from pipeline.models.rbf_paper import identify_rbf_paper

    return identify_rbf_paper(
        [stretch for table in data for stretch in trajectories(table)],
        basis_functions=settings.basis_functions,
        smoothing=settings.smoothing,
        mass=plant.mass,
        inputs=plant.action,
    )
