"""Logs of a run as fits and free runs take them: kinematics with the inputs between their samples."""

from collections.abc import Sequence

import numpy as np

from ..numerics.arrays import FloatArray, sample_interval
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.log import UNKNOWN, Log, log_of, voltages
from ..store import layout
from ..store.run_folder import RunFolder
from ..store.tables import Table


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
