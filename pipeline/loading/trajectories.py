"""Kinematics tables as the trajectories and records that identification works on, and the voltages that drive them.

A log has parts between which its inputs were not recorded, so that nobody knows what the device did there. A short hole
is bridged by a straight line; behind a longer one fits and free runs start anew, as at the beginning of a log.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pipeline.device_parameters import JointParameters
from pipeline.loading.device import device
from pipeline.loading.prior_knowledge import PriorKnowledge
from pipeline.models.kind import KnownCurves, Training
from pipeline.numerics.arrays import BoolArray, FloatArray, runs_of, sample_interval
from pipeline.numerics.progress import OnProgress, silent
from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.tables import Table
from pipeline.settings import Prototype
from pipeline.settings_logs import Role
from pipeline.signals.trajectory import SHORTEST, UNKNOWN, Record, Trajectory, unknown_rows, voltages

_FINE, _PART = "v_fine", "recorded"
"""Columns in memory: voltages between the samples, and whether the inputs of a row are known."""

EDGE = 10
"""Samples at the ends of a log at which a derivative of q knows one side only."""

_LEAST_PART = 5 * EDGE
"""Valid samples of a part of a log that is no more than its beginning."""

_MOVING = 0.02
"""Share of the range of q by which it must change over that many samples to be in motion."""

_FARTHER = 0.1
"""Share of the range of q that nothing but a log's first samples shows, from which they are kept."""


def training(
    tables: Sequence[Table],
    prototype: Prototype,
    parameters: JointParameters | None,
    prior_knowledge: PriorKnowledge | None = None,
    on_progress: OnProgress = silent,
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
    prior_knowledge : PriorKnowledge, optional
        What is known beside the logs.
    on_progress : callable
        Told what a fit is doing.
    """
    plant, beside = device(prototype), prior_knowledge or PriorKnowledge()
    return Training(
        stretches=tuple(stretch for table in tables for stretch in trajectories(table)),
        records=tuple(record(part) for part in _long_enough([part for table in tables for part in parts(table)])),
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


def _known_curves(table: Table, inputs: int) -> KnownCurves:
    slopes = [table.get(f"dC{k}_dq") for k in range(1, inputs + 1)]
    return KnownCurves(table["q"], table.get("F"), tuple(None if slope is None else 0.5 * slope for slope in slopes))


def sources(prototype: Prototype, *roles: Role) -> tuple[str, ...]:
    """The artifacts that `load_motion` reads, of the logs in these roles, or in all."""
    logs = [(role, log) for role, log, _ in layout.logs(prototype) if not roles or role in roles]
    return tuple(artifact(role, log) for role, log in logs for artifact in (layout.kinematics, layout.record))


def load_motion(run: RunFolder, prototype: Prototype, role: Role, log: str) -> Table:
    """The `motion` of a log of a run."""
    kinematics, fine = (run.read_table(artifact(role, log)) for artifact in (layout.kinematics, layout.record))
    return motion(kinematics, fine, prototype, run.record(layout.record(role, log)).notes)


def motion(kinematics: Table, fine: Table, prototype: Prototype, notes: Mapping[str, Any]) -> Table:
    """What models are fitted to and simulated over: kinematics with the voltages between the samples (see `drive`),
    which begin at zero where the settings say that they were zero before the log, and with its parts, as the `notes` of
    the record tell them.
    """
    return with_parts(_rested(with_fine_voltages(kinematics, fine), prototype), notes.get(UNKNOWN, ()))


def with_parts(table: Table, unknown: Sequence[Sequence[float]]) -> Table:
    """The table with its rows marked that lie in the `unknown` spans [s], if there are any."""
    return {**table, _PART: ~unknown_rows(table["t"], unknown)} if unknown else table


def recorded(table: Table) -> BoolArray:
    """Rows whose inputs are known, shape (N,)."""
    marked: BoolArray = table.get(_PART, np.ones(len(table["t"]), dtype=np.bool_))
    return marked


def part_rows(table: Table) -> list[slice]:
    """The rows of each part of a table, from its first valid sample on; parts of less than `SHORTEST` are left out.

    Where all are so short, the rows are those of the table from its first valid sample on.
    """
    valid = table["segment"] >= 0
    with_samples = [rows for rows in runs_of(recorded(table)) if valid[rows].any()]
    from_valid = [slice(rows.start + int(np.argmax(valid[rows])), rows.stop) for rows in with_samples]
    long_enough = [rows for rows in from_valid if rows.stop - rows.start >= SHORTEST]
    return long_enough or [slice(int(np.argmax(valid)), len(valid))]


def parts(table: Table) -> list[Table]:
    """The parts of a table, each beginning with a valid sample."""
    return [part(table, rows) for rows in part_rows(table)]


def part(table: Table, rows: slice) -> Table:
    """The rows of one part."""
    return {name: values[rows] for name, values in table.items() if name != _PART}


def longest_rows(table: Table) -> slice:
    """The rows of the longest part."""
    return max(part_rows(table), key=lambda rows: rows.stop - rows.start)


def with_fine_voltages(table: Table, fine: Table) -> Table:
    """Kinematics with the voltages of the `fine` record between their samples, where it is finer."""
    t, grid, rows = table["t"], fine["t"], len(table["t"])
    refined = round(sample_interval(t) / sample_interval(grid))
    if refined == 1:
        return table
    # The record ends with the last sample or within the interval behind it, where nothing is simulated.
    first, v = int(np.searchsorted(grid, t[0] - 1e-9)), voltages(fine)
    places = np.minimum(first + np.arange(rows * refined), len(v) - 1)
    return {**table, _FINE: v[places].reshape(rows, refined, -1)}


def _rested(table: Table, prototype: Prototype) -> Table:
    if prototype.plant.inputs_before != "zero":
        return table
    first, begun = int(np.argmax(table["segment"] >= 0)), dict(table)
    for name, at in (("v1", first), ("v2", first), (_FINE, (first, 0))):
        if name in table:
            begun[name] = table[name].copy()
            begun[name][at] = 0.0
    return begun


def drive(table: Table, *, fine: bool) -> FloatArray:
    """The voltages [V] of a table: at its samples, shape (N, K), or as `fine` as they are known, shape (N, r, K)."""
    return table[_FINE] if fine and _FINE in table else voltages(table)


def trajectories(table: Table, *, fine: bool = False) -> list[Trajectory]:
    """The gap-free stretches of a kinematics table; masked rows and stretches under five samples are left out."""
    v, segment = drive(table, fine=fine), table["segment"]
    stretches = []
    for number in np.unique(segment[segment >= 0]):
        rows = np.flatnonzero(segment == number)
        if len(rows) >= SHORTEST:
            t, q, qdot, qddot = (table[name][rows] for name in ("t", "q", "qdot", "qddot"))
            stretches.append(Trajectory(t, q, qdot, qddot, v[rows]))
    return stretches


def _long_enough(tables: Sequence[Table]) -> list[Table]:
    """The parts of logs that hold more than their beginning, or else the longest of them."""
    long_enough = [part for part in tables if np.count_nonzero(part["segment"] >= 0) > _LEAST_PART]
    return long_enough or [max(tables, key=lambda part: len(part["t"]))]


def begins_in_motion(table: Table) -> bool:
    """Whether q moves at the beginning of a table and its velocity is a derivative, which is poor there."""
    first = int(np.argmax(table["segment"] >= 0))
    q = table["q"]
    change = np.nanmax(q[first : first + EDGE + 1]) - np.nanmin(q[first : first + EDGE + 1])
    return "velocity" not in table and bool(change > _MOVING * (np.nanmax(q) - np.nanmin(q)))


def record(table: Table) -> Record:
    """A whole kinematics table with its mask, from the first valid sample whose velocity is known on.

    That is the first valid one, or `EDGE` samples later for a log that begins in motion: its inputs from before are
    kept as the record's past. A log whose first samples go where no others do is taken from the first one on all the
    same: a model that has never been there would lose a run that starts there.
    """
    rows = slice(int(np.argmax(table["segment"] >= 0)), None)
    valid = table["segment"][rows] >= 0
    q, qdot, qddot = (np.where(valid, table[name][rows], 0.0) for name in ("q", "qdot", "qddot"))
    fine = table[_FINE][rows] if _FINE in table else None
    velocity = np.where(valid, table["velocity"][rows], 0.0) if "velocity" in table else None
    whole = Record(table["t"][rows], q, qdot, qddot, voltages(table)[rows], valid, fine, velocity=velocity)
    if not begins_in_motion(table) or len(valid) < 10 * EDGE or not valid[EDGE:].any():
        return whole
    begin = EDGE + int(np.argmax(valid[EDGE:]))
    later = whole.part(begin, len(valid))
    return whole if _farther(whole, later) else later


def _farther(whole: Record, later: Record) -> bool:
    """Whether a record goes farther than its later part by more than `_FARTHER` of its range."""
    low, high = whole.known_q.min(), whole.known_q.max()
    return bool(max(later.known_q.min() - low, high - later.known_q.max()) > _FARTHER * (high - low))


def training_tables(run: RunFolder, prototype: Prototype) -> list[Table]:
    """The kinematics of all training logs, with their fine voltages."""
    logs = [log for role, log, _ in layout.logs(prototype) if role == "train"]
    return [load_motion(run, prototype, "train", log) for log in logs]


def records(table: Table) -> list[Record]:
    """The parts of a log, each a whole record; parts that hold little more than their beginning are left out."""
    return [record(each) for each in _long_enough(parts(table))]


def training_trajectories(run: RunFolder, prototype: Prototype) -> list[Trajectory]:
    """The gap-free stretches of all training logs."""
    return [stretch for table in training_tables(run, prototype) for stretch in trajectories(table)]
