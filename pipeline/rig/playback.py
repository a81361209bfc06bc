"""Voltage sequences as files that a rig can play, CSV and MAT, with what they were made for beside them."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.log import LAYOUTS

TIME, INPUTS = "time", ("v1", "v2")
"""Names of the channels in the files: time [s], and the commands to the left and right converter [V]."""
ENDINGS = (".csv", ".mat")


@dataclass(frozen=True)
class Sequence:
    """Commands to the two converters: times (N,) [s] from 0 on, uniform, and voltages (N, 2) [V]."""

    t: FloatArray
    u: FloatArray

    @property
    def duration(self) -> float:
        """Length [s], the last sample held as long as the others."""
        return float(self.t[-1] - self.t[0]) * self.t.size / (self.t.size - 1)

    def at(self, t: FloatArray) -> FloatArray:
        """Commands at sorted times `t` (M,) [s], each held until the next: shape (M, 2) [V]."""
        rows = np.searchsorted(self.t, t + 1e-9 * self.duration, side="right") - 1
        held: FloatArray = self.u[np.clip(rows, 0, self.t.size - 1)]
        return held


def save_sequence(path: Path, sequence: Sequence, about: Mapping[str, Any]) -> tuple[Path, ...]:
    """Write a sequence as `path` (.csv or .mat) and what is known `about` it as JSON beside it.

    A MAT file (v5) holds ``time``, ``v1``, ``v2`` as columns, ``excitation`` as the structure with time that
    Simulink's *From Workspace* block plays, and `about` as JSON text.

    Raises
    ------
    InputError
        Another ending.
    """
    document = json.dumps(about, indent=1, default=_plain) + "\n"
    if path.suffix.lower() == ".csv":
        columns = {name: (sequence.u[:, i], "V") for i, name in enumerate(INPUTS)}
        LAYOUTS["csv"].write(path, sequence.t, columns)
    elif path.suffix.lower() == ".mat":
        from scipy.io import savemat

        signals = {"values": sequence.u, "dimensions": 2.0, "label": "v1, v2 [V]"}
        columns_mat = {name: sequence.u[:, [i]] for i, name in enumerate(INPUTS)}
        structure = {"time": sequence.t[:, None], "signals": signals}
        savemat(path, {TIME: sequence.t[:, None], **columns_mat, "excitation": structure, "about": document})
    else:
        raise InputError(f"{path}: a sequence is written as {' or '.join(ENDINGS)}; name the file so")
    beside = path.with_suffix(".json")
    beside.write_text(document, encoding="utf-8")
    return path, beside


def load_sequence(path: Path) -> Sequence:
    """Read a sequence back, as the virtual rig's player does.

    Raises
    ------
    InputError
        The file cannot be read, lacks a channel, or its times do not advance.
    """
    from pipeline.rig_logs import read_recording

    recording = read_recording(path, channels=[TIME, *INPUTS])
    t, *inputs = (recording.channel(name).samples for name in (TIME, *INPUTS))
    if t.size < 2 or not np.all(np.diff(t) > 0.0) or not all(np.isfinite(each).all() for each in inputs):
        raise InputError(f"{path}: a sequence needs times that advance and voltages that are finite")
    return Sequence(t - t[0], np.column_stack(inputs))


def _plain(value: Any) -> Any:
    return value.tolist()
