"""Logs of a run as fits take them, with the inputs between their samples, and the corrections that settings state."""

from collections.abc import Sequence

import numpy as np

from ..device.device import device
from ..errors import InputError
from ..numerics.arrays import FloatArray, sample_interval
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.columns import scaled
from ..signals.log import UNKNOWN, Corrections, Log, RawLog, log_of, voltages
from ..store import layout
from ..store.run_folder import RunFolder
from ..store.tables import Table
from ..units.units import TIME, parse_quantity


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
    return motion(kinematics, fine, prototype, run.record(layout.record(role, log)).notes.get(UNKNOWN, ()))


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
    return np.asarray(v[places].reshape(len(t), refined, -1))


def corrections(prototype: Prototype) -> dict[tuple[Role, str], Corrections]:
    """Corrections stated in [logs], by each log's role and its name in the run.

    Raises
    ------
    InputError
        A zero in another unit than that of q, or a gain of an input that the device has not.
    """
    plant = device(prototype)
    stated = dict[tuple[Role, str], Corrections]()
    for role, log, part in layout.log_parts(prototype):
        where = f"{prototype.name}: logs.{role}: {part.file}"
        if len(plant.inputs) == 1 and part.gain.v2 != 1.0:
            raise InputError(f"{where}: gain.v2 is stated, but [channels] has no v2; leave it out")
        stated[role, log] = Corrections(
            gains=(part.gain.v1, part.gain.v2)[: len(plant.inputs)],
            zero=parse_quantity(part.zero, (plant.displacement.symbol,), f"{where}: zero"),
            gain_q=part.gain.q,
            delay=parse_quantity(part.delay, TIME, f"{where}: delay"),
            clock=part.clock,
        )
    return stated


def corrected_log(log: RawLog, by: Corrections) -> RawLog:
    """A raw log whose readings are corrected; a measured velocity is left as its own sensor read it."""
    made: dict[tuple[int, float], FloatArray] = {}

    def base(time: FloatArray, delay: float = 0.0) -> FloatArray:
        """A corrected time base, made once, so that signals that shared one do so still."""
        return made.setdefault((id(time), delay), scaled(time, by.clock, delay))

    inputs = [
        (base(time, by.delay), scaled(samples, gain, 0.0))
        for (time, samples), gain in zip(log.inputs, by.gains, strict=True)
    ]
    q = base(log.q[0]), scaled(log.q[1], by.gain_q, by.zero)
    velocity = None if log.velocity is None else (base(log.velocity[0]), log.velocity[1])
    return RawLog(q, tuple(inputs), velocity, log.notes)
