"""A raw log: its channels, each on its own time base.

The guarded child writes their columns into a temporary file, which is mapped as arrays.
"""

import difflib
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..signals.columns import column

_MOST_LISTED = 30
NOT_APPLIED = "not applied here"
"""Words in a note on a number that looks like a calibration."""
_NUMBERED = re.compile(r"column \d+")
"""Names of columns without a header."""


@dataclass(frozen=True)
class RecordedChannel:
    """One channel of a raw log, in the numbers of the log.

    Attributes
    ----------
    name : str
        Name in the log.
    unit : str
        Unit as the log writes it, "" where it has none; information only, the settings decide.
    time : FloatArray, shape (N,), or None
        The channel's own time base [s]; None where the format has none (a column of a table).
    samples : FloatArray, shape (N,)
        Samples, converted to float64, read-only.
    dtype : str
        Type of the numbers in the log, such as ``float32``.
    """

    name: str
    unit: str
    time: FloatArray | None
    samples: FloatArray
    dtype: str


@dataclass(frozen=True)
class Recording:
    """A raw log, or the part of it that was asked for.

    Attributes
    ----------
    path : Path
        The file.
    format : str
        Its format in words, such as ``MAT v5, ControlDesk``.
    channels : tuple of RecordedChannel
        The channels that were asked for, under the names by which they were asked for.
    listed : tuple of str
        Names of all numeric channels of the log.
    notes : tuple of str
        Remarks for the user, such as the detected dialect of a CSV file.
    warnings : tuple of str
        Samples that were left out or changed.
    rates : mapping of str to float
        Sample rates [Hz] that single numbers beside the channels state, by their names; information only.
    frequencies : mapping of str to float
        Frequencies [Hz] of which nothing says whether they are those of the samples or of a motion, by their names.
    descriptions : mapping of str to str
        Text of the log beside a channel, by its name.
    heading : str
        Text of the log above or beside all of them.
    """

    path: Path
    format: str
    channels: tuple[RecordedChannel, ...]
    listed: tuple[str, ...]
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    rates: Mapping[str, float] = field(default_factory=dict)
    frequencies: Mapping[str, float] = field(default_factory=dict)
    descriptions: Mapping[str, str] = field(default_factory=dict)
    heading: str = ""

    def channel(self, name: str) -> RecordedChannel:
        """The channel of that name.

        Raises
        ------
        InputError
            It was not read, or the log has none of that name.
        """
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise InputError(missing_channel(self.path, name, self.listed))

    def unapplied(self, name: str) -> list[str]:
        """The notes on numbers beside a channel that look like its calibration."""
        group = name.rpartition(".")[0]
        notes = [note for note in self.notes if NOT_APPLIED in note]
        return [note for note in notes if repr(name) in note or (group and note.startswith(f"{group}."))]


def missing_channel(path: Path, name: str, listed: tuple[str, ...]) -> str:
    """One line that states what is there instead of the channel `name`."""
    if not listed:
        return f"{path}: no channel {name!r}; the log holds no numeric channel at all"
    folded = {entry.casefold(): entry for entry in listed}
    close = [folded[match] for match in difflib.get_close_matches(name.casefold(), list(folded), n=3, cutoff=0.5)]
    hint = f"did you mean {' or '.join(map(repr, close))}? " if close else ""
    shown = ", ".join(map(repr, listed[:_MOST_LISTED])) + (", …" if len(listed) > _MOST_LISTED else "")
    way_out = as_other_logs(name, listed)
    return f"{path}: no channel {name!r}; {hint}it has {shown}" + (f"; {way_out}" if way_out else "")


def for_any_variable(name: str) -> str:
    """``*.y`` for the channel ``run1.y``, by which it may be asked for in whatever variable it is; "" without a dot."""
    variable, dot, rest = name.partition(".")
    return f"*.{rest}" if variable and dot and rest else ""


def as_other_logs(name: str, listed: Sequence[str]) -> str:
    """Advice where a channel of other logs has another name here, or none; "" where neither is seen."""
    alias = for_any_variable(name)
    if alias and [for_any_variable(other) for other in listed].count(alias) == 1:
        return f"save all logs under the same variable name, or write {alias!r} in [channels]"
    if listed and all(map(_NUMBERED.fullmatch, listed)) and not _NUMBERED.fullmatch(name):
        return "it has no header: give it that of the other logs, or make a settings file for each"
    return ""


Places = list[tuple[int, int]]
"""Offset [bytes] and number of samples of each part of a column, in order."""


def mapped_columns(file: IO[bytes]) -> Callable[[Places], FloatArray]:
    """Columns as read-only views of the mapped file; one of several parts is put together in a file of its own.

    The callable raises ValueError for places that are not in the file.
    """
    size = os.fstat(file.fileno()).st_size // 8
    mapped = np.asarray(np.memmap(file, "<f8", "r", shape=(size,))) if size else np.empty(0)

    def samples(places: Places) -> FloatArray:
        """The samples at these places."""
        if any(offset < 0 or offset % 8 or count < 0 or offset // 8 + count > size for offset, count in places):
            raise ValueError
        parts = [mapped[offset // 8 : offset // 8 + count] for offset, count in places]
        whole = parts[0] if len(parts) == 1 else column(sum(part.size for part in parts), parts, np.float64)
        whole.flags.writeable = False
        return whole

    return samples
