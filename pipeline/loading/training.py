"""Kinematics tables and settings as what a model is fitted to."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pipeline.identification.known_curves import KnownCurves
from pipeline.loading.device import device
from pipeline.loading.trajectories import record, trajectories
from pipeline.models.kind import OnProgress, Training
from pipeline.numerics.kept import Keep, make_anew
from pipeline.runs.tables import Table
from pipeline.settings import Prototype

if TYPE_CHECKING:
    from pipeline.joint.parameters import JointParameters


def training(
    tables: Sequence[Table],
    prototype: Prototype,
    parameters: "JointParameters | None",
    known: Table | None = None,
    on_progress: OnProgress = lambda what, share: None,
    keep: Keep = make_anew,
) -> Training:
    """The training data of a prototype.

    Parameters
    ----------
    tables : sequence of Table
        Kinematics of the training logs, with the voltages between the samples.
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of the analytical joint.
    known : Table, optional
        Measured characteristic curves.
    on_progress : callable
        Told what a fit is doing.
    keep : callable
        Keeps what a fit has finished.
    """
    plant = device(prototype)
    return Training(
        stretches=tuple(stretch for table in tables for stretch in trajectories(table)),
        records=tuple(record(table) for table in tables),
        units=(plant.displacement.symbol, plant.inputs[0].symbol),
        inputs=plant.action,
        known_mass=plant.known_mass,
        parameters=parameters,
        known_curves=None if known is None else _known_curves(known, len(plant.inputs)),
        identify=prototype.identify,
        compare=prototype.compare,
        log_units=(plant.displacement.factor, plant.inputs[0].factor),
        inputs_before=prototype.plant.inputs_before,
        on_progress=on_progress,
        keep=keep,
    )


def _known_curves(table: Table, inputs: int) -> KnownCurves:
    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))
