"""A raw log: its channels, each on its own time base.

The guarded child writes their columns into a temporary file, which is mapped as arrays or read slice by slice.
"""

import difflib
import mmap
import os
import re
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, TypeVar

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import FloatArray, Samples

_MOST_LISTED = 30
_NUMBERED = re.compile(r"column \d+")
"""Names of columns without a header."""

Column = TypeVar("Column", bound=Samples)


@dataclass(frozen=True)
class Channel(Generic[Column]):
    """One channel of a raw log, in the numbers of the log; its columns are arrays, or samples on disk.

    Attributes
    ----------
    name : str
        Name in the log.
    unit : str
        Unit as the log writes it, "" where it says nothing; information only, the settings decide.
    time : FloatArray or Samples, N of them, or None
        The channel's own time base [s]; None where the format has none (a column of a table).
    samples : FloatArray or Samples, N of them
        Samples, converted to float64, read-only.
    dtype : str
        Type of the numbers in the log, such as ``float32``.
    """

    name: str
    unit: str
    time: Column | None
    samples: Column
    dtype: str


@dataclass(frozen=True)
class Recording(Generic[Column]):
    """A raw log, or the part of it that was asked for.

    Attributes
    ----------
    path : Path
        The file.
    format : str
        Its format in words, such as ``MAT v5, ControlDesk``.
    channels : tuple of Channel
        The channels that were asked for, under the names by which they were asked for.
    listed : tuple of str
        Names of all numeric channels of the log.
    notes : tuple of str
        What a reader should know, such as the dialect that was found in a CSV file.
    rates : mapping of str to float
        Sample rates [Hz] that single numbers beside the channels state, by their names; information only.
    """

    path: Path
    format: str
    channels: tuple[Channel[Column], ...]
    listed: tuple[str, ...]
    notes: tuple[str, ...] = ()
    rates: Mapping[str, float] = field(default_factory=dict)

    def channel(self, name: str) -> Channel[Column]:
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


def missing_channel(path: Path, name: str, listed: tuple[str, ...]) -> str:
    """One line that says what is there instead of the channel `name`."""
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
    """What to do where a channel of other logs is called otherwise here, or has no name; "" where neither is seen."""
    alias = for_any_variable(name)
    if alias and [for_any_variable(other) for other in listed].count(alias) == 1:
        return f"save all logs under the same variable name, or write {alias!r} in [channels]"
    if listed and all(map(_NUMBERED.fullmatch, listed)) and not _NUMBERED.fullmatch(name):
        return "it has no header: give it that of the other logs, or make a settings file for each"
    return ""


Places = list[tuple[int, int]]
"""Offset [bytes] and number of samples of each part of a column, in order."""

_CHUNK = 1 << 16
_HELD = 4


def mapped_columns(fd: int) -> Callable[[Places], FloatArray]:
    """Columns as read-only arrays; a column of one part is a view on the mapped file.

    The callable raises ValueError for places that are not in the file.
    """
    size = os.fstat(fd).st_size
    mapped = mmap.mmap(fd, size, access=mmap.ACCESS_READ) if size else b""

    def column(places: Places) -> FloatArray:
        """The samples at these places, as a view of the file where they are in one piece."""
        _check(places, size)
        parts = [np.frombuffer(mapped, dtype="<f8", count=count, offset=offset) for offset, count in places]
        whole = parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])
        whole.flags.writeable = False
        return whole

    return column


def spooled_columns(fd: int) -> Callable[[Places], "SpooledColumn"]:
    """Columns that stay in the file, which must be kept open; ValueError as for `mapped_columns`."""
    size = os.fstat(fd).st_size

    def column(places: Places) -> SpooledColumn:
        _check(places, size)
        return SpooledColumn(fd, places)

    return column


def _check(places: Places, size: int) -> None:
    if any(offset < 0 or count < 0 or offset + 8 * count > size for offset, count in places):
        raise ValueError


class SpooledColumn:
    """A column on disk, of which a few chunks are held ready, since most slices are near each other.

    Parameters
    ----------
    fd : int
        Descriptor of the open file.
    places : list of (int, int)
        Where its parts lie.
    """

    def __init__(self, fd: int, places: Places) -> None:
        self._fd = fd
        self._offsets = np.array([offset for offset, _ in places], dtype=np.int64)
        self._starts = np.concatenate(([0], np.cumsum([count for _, count in places]))).astype(np.int64)
        self._held: OrderedDict[int, FloatArray] = OrderedDict()

    @property
    def size(self) -> int:
        """Number of samples."""
        return int(self._starts[-1])

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows."""
        start, stop, _ = rows.indices(self.size)
        if stop - start >= _CHUNK:
            return self._read(start, stop)
        parts = []
        while start < stop:
            number, first = divmod(start, _CHUNK)
            last = min(stop - number * _CHUNK, _CHUNK)
            parts.append(self._chunk(number)[first:last])
            start += last - first
        return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0), *parts])

    def _chunk(self, number: int) -> FloatArray:
        held = self._held.get(number)
        if held is None:
            held = self._held[number] = self._read(number * _CHUNK, min((number + 1) * _CHUNK, self.size))
            if len(self._held) > _HELD:
                self._held.popitem(last=False)
        else:
            self._held.move_to_end(number)
        return held

    def _read(self, start: int, stop: int) -> FloatArray:
        values = np.empty(stop - start, dtype="<f8")
        part = int(np.searchsorted(self._starts, start, side="right")) - 1
        filled = 0
        while start < stop:
            end = min(stop, int(self._starts[part + 1]))
            if end > start:
                content = values[filled : filled + end - start].data.cast("B")
                _read_fully(self._fd, content, int(self._offsets[part]) + 8 * (start - int(self._starts[part])))
                filled, start = filled + end - start, end
            part += 1
        values.flags.writeable = False
        return values


def _read_fully(fd: int, content: memoryview, offset: int) -> None:
    while content:
        count = os.preadv(fd, [content], offset)
        if not count:
            raise OSError("the temporary file of a log's samples is shorter than it was")
        content, offset = content[count:], offset + count
