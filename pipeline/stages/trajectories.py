"""Kinematics tables as the gap-free trajectories that identification works on."""

import numpy as np

from pipeline.artifacts.tables import Table
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.identification.record import Record
from pipeline.numerics.identification.trajectory import Trajectory

# Shorter stretches carry no dynamics worth a row in the fit.
_SHORTEST = 5


def voltages(table: Table) -> FloatArray:
    """The inputs of a table, shape (N, 1) or (N, 2)."""
    return np.column_stack([table[name] for name in ("v1", "v2") if name in table])


def trajectories(table: Table) -> list[Trajectory]:
    """The gap-free stretches of a kinematics table; masked rows and stretches under five samples are left out."""
    v, segment = voltages(table), table["segment"]
    stretches = []
    for number in np.unique(segment[segment >= 0]):
        rows = np.flatnonzero(segment == number)
        if len(rows) >= _SHORTEST:
            t, q, qdot, qddot = (table[name][rows] for name in ("t", "q", "qdot", "qddot"))
            stretches.append(Trajectory(t, q, qdot, qddot, v[rows]))
    return stretches


def record(table: Table) -> Record:
    """A whole kinematics table with its mask; rows before the first valid sample are left out."""
    rows = slice(int(np.argmax(table["segment"] >= 0)), None)
    valid = table["segment"][rows] >= 0
    q, qdot, qddot = (np.where(valid, table[name][rows], 0.0) for name in ("q", "qdot", "qddot"))
    return Record(table["t"][rows], q, qdot, qddot, voltages(table)[rows], valid)
