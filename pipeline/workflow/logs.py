"""Logs of a run as fits and free runs take them: kinematics with the inputs between their samples."""

from collections.abc import Sequence

import numpy as np

from ..device.device import device
from ..device.parameters import JointParameters
from ..models.model_type import KnownCurves, Training
from ..numerics.arrays import FloatArray, sample_interval
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.inputs import UNKNOWN
from ..signals.log import EDGE, Log, log_of, voltages
from ..store import layout
from ..store.run_folder import RunFolder
from ..store.tables import Table
from ..system.progress import OnProgress, silent
from .prior_knowledge import PriorKnowledge

_LEAST_PART = 5 * EDGE
"""Valid samples of a part of a log that is no more than its beginning."""


def training(
    logs: Sequence[Log],
    prototype: Prototype,
    parameters: JointParameters | None,
    prior_knowledge: PriorKnowledge | None = None,
    on_progress: OnProgress = silent,
) -> Training:
    """The training data of a prototype.

    Parameters
    ----------
    logs : sequence of Log
        The training logs.
    prototype : Prototype
        Settings.
    parameters : JointParameters or None
        Parameter set of the analytical joint.
    prior_knowledge : PriorKnowledge, optional
        What is known beside the logs.
    on_progress : callable
        Receives what a fit is doing.
    """
    plant = device(prototype)
    beside = prior_knowledge or PriorKnowledge()
    parts = [part for log in logs for part in log.parts()]
    return Training(
        segments=tuple(segment for log in logs for segment in log.segments()),
        records=tuple(part.to_fit() for part in _long_enough(parts)),
        units=(plant.displacement.symbol, plant.inputs[0].symbol),
        inputs=plant.action,
        known_mass=plant.known_mass,
        parameters=parameters,
        known_curves=None if beside.curves is None else _known_curves(beside.curves, len(plant.inputs)),
        siblings=beside.siblings,
        identify=prototype.identify,
        compare=prototype.compare,
        log_units=(plant.displacement.factor, plant.inputs[0].factor),
        inputs_before=prototype.plant.inputs_before,
        on_progress=on_progress,
    )


def _long_enough(parts: Sequence[Log]) -> list[Log]:
    """The parts of logs that hold more than their beginning, or else the longest of them."""
    long_enough = [part for part in parts if np.count_nonzero(part.valid) > _LEAST_PART]
    return long_enough or [max(parts, key=lambda part: len(part.t))]


def fitted_parts(log: Log) -> list[Log]:
    """The parts of a log as fits take them."""
    return [part.to_fit() for part in _long_enough(log.parts())]


def _known_curves(table: Table, inputs: int) -> KnownCurves:
    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))


def sources(prototype: Prototype, *roles: Role) -> tuple[str, ...]:
    """The artifacts that `load_motion` reads, of the logs in these roles, or in all."""
    logs = [(role, log) for role, log, _ in layout.logs(prototype) if not roles or role in roles]
    return tuple(artifact(role, log) for role, log in logs for artifact in (layout.kinematics, layout.record))


def load_motion(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Log:
    """A log of a run, with its derivatives.

    Parameters
    ----------
    run : RunFolder
        The run.
    prototype : Prototype
        Its settings.
    role : {"train", "validation"}
        Role of the log.
    log : str
        Its name in the run.
    """
    kinematics, fine = (run.read_table(artifact(role, log)) for artifact in (layout.kinematics, layout.record))
    unknown = run.record(layout.record(role, log)).notes.get(UNKNOWN, ())
    return motion(kinematics, fine, prototype, unknown)


def load_logs(run: RunFolder, prototype: Prototype, *roles: Role) -> list[Log]:
    """The logs of a run in these roles, or all."""
    names = [(role, log) for role, log, _ in layout.logs(prototype) if not roles or role in roles]
    return [load_motion(run, prototype, role, log) for role, log in names]


def motion(kinematics: Table, fine: Table | None, prototype: Prototype, unknown: Sequence[Sequence[float]] = ()) -> Log:
    """A log from its tables.

    Parameters
    ----------
    kinematics : Table
        Columns t, q, qdot, qddot, v1, v2, segment, and perhaps velocity, at the sample interval.
    fine : Table or None
        The uniform record with the inputs between those samples.
    prototype : Prototype
        Its settings state what the inputs were before the log: where they were zero, they begin at zero.
    unknown : sequence of (float, float)
        Spans [s] in which the inputs were not recorded.
    """
    log = log_of(kinematics, None if fine is None else between(kinematics["t"], fine), unknown)
    if prototype.plant.inputs_before == "zero":
        first = int(np.argmax(log.valid))
        log.v[first] = 0.0
        if log.fine is not None:
            log.fine[first, 0] = 0.0
    return log


def between(t: FloatArray, fine: Table) -> FloatArray | None:
    """The inputs of the fine record in each interval of t, shape (N, r, K); None where it is not finer."""
    grid = fine["t"]
    refined = round(sample_interval(t) / sample_interval(grid))
    if refined == 1:
        return None
    # The record ends with the last sample or within the interval behind it, where nothing is simulated.
    first = int(np.searchsorted(grid, t[0] - 1e-9))
    v = voltages(fine)
    places = np.minimum(first + np.arange(len(t) * refined), len(v) - 1)
    between: FloatArray = v[places].reshape(len(t), refined, -1)
    return between
