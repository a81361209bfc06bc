"""Contents of a MAT file, and layouts of recorders: ControlDesk's, Simulink's "Structure With Time", and tables.

ControlDesk writes one struct (of any name) with two struct arrays. ``X`` has the time axes (Name, Type, Data, Unit,
Raster), and ``Y`` the channels (the same and Path, XIndex: which axis).

Scopes and "To Workspace" blocks write one struct (of any name) with ``time`` and a struct array ``signals`` (values,
dimensions, label, …). ``values`` has a row for each time; signals of several elements have columns, and what is 1×1×N
is a vector.
"""

import math
import warnings
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .hdf5 import NUMBERS, open_hdf5, walk
from .source import PART, Entry, UnreadableLogError, unique_names

Reader = Callable[[int, int], NDArray[Any]]
"""First and end sample → samples."""


@dataclass(frozen=True)
class MatArray:
    """A real numeric array whose samples are still in the file.

    `read(start, stop)` gives a range of them in column-major order; `step` is how many at a time cost least.
    """

    dims: tuple[int, ...]
    dtype: str
    read: Reader
    step: int = PART

    @property
    def size(self) -> int:
        """Number of elements."""
        return math.prod(self.dims)

    @property
    def is_vector(self) -> bool:
        """True if the array is long in one direction only."""
        return self.size == max(self.dims, default=0) and self.size > 1

    def column(self, j: int) -> Reader:
        """Samples of column j (from 0) of a matrix."""
        rows = self.dims[0]
        return lambda first, last: self.read(j * rows + first, j * rows + last)

    def row(self, j: int) -> Reader:
        """Samples of row j (from 0) of a matrix: every part of it is read for each row."""
        rows = self.dims[0]
        return lambda first, last: self.read(first * rows, last * rows)[j::rows]


@dataclass(frozen=True)
class MatObject:
    """An object of a MATLAB class (table, timeseries, iddata, …), or another value that is not read, such as a cell."""

    kind: str


@dataclass(frozen=True)
class MatStruct(ABC):
    """A struct array: the names of its fields, and the number of its elements."""

    fields: tuple[str, ...]
    count: int

    @abstractmethod
    def get(self, index: int, name: str) -> "MatValue":
        """Field `name` of element `index`; None where there is no such field."""


MatValue = MatArray | MatStruct | MatObject | str | None
"""None stands for what is empty or damaged."""


@dataclass(frozen=True)
class MatChannel:
    """A channel as a layout finds it, and how its samples are read."""

    entry: Entry
    read: Reader
    step: int = PART


def text_of(value: MatValue) -> str:
    """A text, or "" for anything else."""
    return value if isinstance(value, str) else ""


def scalar_of(value: MatValue) -> float | None:
    """The one number of a 1×1 array, or None."""
    return float(value.read(0, 1)[0]) if isinstance(value, MatArray) and value.size == 1 else None


def bare(name: str) -> str:
    """A name without the quotes around it or around the parts of a model path."""
    return "/".join(part.strip('"') for part in name.strip().split("/")) if '"' in name else name.strip()


def is_recorder(value: MatValue) -> TypeGuard[MatStruct]:
    """True if a variable is a recording."""
    return isinstance(value, MatStruct) and value.count == 1 and {"X", "Y"} <= set(value.fields)


def recorder_channels(record: MatStruct, notes: list[str]) -> list[MatChannel]:
    """Time axes, then channels; what is odd is added to `notes`.

    Raises
    ------
    UnreadableLogError
        No channels Y.
    """
    axes, recorded = _time_axes(record, notes)
    channels = record.get(0, "Y")
    if not isinstance(channels, MatStruct):
        raise UnreadableLogError("the ControlDesk struct has no channels Y")
    arrays = {i: data for i in range(channels.count) if isinstance(data := channels.get(i, "Data"), MatArray)}
    others = [text_of(channels.get(i, "Name")) or f"Y({i + 1})" for i in range(channels.count) if i not in arrays]
    notes += [f"no real numbers, and left out: {', '.join(others)}"] if others else []
    rows = list(arrays)
    names = [bare(text_of(channels.get(i, "Name"))) or f"Y({i + 1})" for i in rows]
    paths = [bare(text_of(channels.get(i, "Path"))) for i in rows]
    indices = [scalar_of(channels.get(i, "XIndex")) for i in rows]
    sizes = [data.size for data in arrays.values()]
    first = _index_base(indices, sizes, [size for _, size in axes])
    for i, name, path, index, size in zip(rows, unique_names(names), paths, indices, sizes, strict=True):
        data = arrays[i]
        position = 0 if index is None else int(index) - first
        axis = axes[position] if 0 <= position < len(axes) else None
        if axis is None or axis[1] != size:
            notes.append(f"channel {name!r} has {size} samples and no time axis of that length")
        time = axis[0] if axis is not None and axis[1] == size else None
        unit = text_of(channels.get(i, "Unit")).strip()
        aliases = (path,) if path != name and paths.count(path) == 1 and path else ()
        recorded.append(MatChannel(Entry(name, unit, data.dtype, size, time, aliases), data.read, data.step))
    return recorded


def _time_axes(record: MatStruct, notes: list[str]) -> tuple[list[tuple[str, int]], list[MatChannel]]:
    """Names and lengths of the time axes in the order that XIndex counts, and those that hold samples."""
    axes = record.get(0, "X")
    lengths: list[tuple[str, int]] = []
    channels = []
    if isinstance(axes, MatStruct):
        rasters = [text_of(axes.get(i, "Raster")) or f"{i + 1}" for i in range(axes.count)]
        names = [
            text_of(axes.get(i, "Name")) or ("time" if axes.count == 1 else f"time ({raster})")
            for i, raster in enumerate(rasters)
        ]
        for i, name in enumerate(unique_names(names)):
            data = axes.get(i, "Data")
            unit = text_of(axes.get(i, "Unit")).strip() or "s"
            if not isinstance(data, MatArray) or not data.size:
                lengths.append((name, 0))
                continue
            factor = SECONDS.get(time_unit(unit))
            if factor is None:
                notes.append(f"the axis {name!r} is in {unit} and no time: its channels need a [channels] time")
                channels.append(MatChannel(Entry(name, unit, data.dtype, data.size), data.read, data.step))
            else:
                notes += [] if factor == 1.0 else [f"the time axis {name!r} counts in {unit} and is read in s"]
                read = _scaled(data.read, factor)
                channels.append(MatChannel(Entry(name, "s", data.dtype, data.size), read, data.step))
            lengths.append((name, 0 if factor is None else data.size))
    return lengths, channels


def _scaled(read: Reader, factor: float) -> Reader:
    return read if factor == 1.0 else lambda first, last: read(first, last) * factor


def _index_base(indices: list[float | None], sizes: list[int], lengths: list[int]) -> int:
    """First index of XIndex, 1 (MATLAB's way, the default) or 0: as the lengths match."""

    def matches(first: int) -> int:
        """Number of signals that have the length of their axis if indices count from `first`."""
        return sum(
            index is not None and 0 <= index - first < len(lengths) and lengths[int(index) - first] == size
            for index, size in zip(indices, sizes, strict=True)
        )

    return 0 if matches(0) > matches(1) else 1


def is_simulink_log(value: MatValue) -> TypeGuard[MatStruct]:
    """True if a variable is a structure with time and signals."""
    return isinstance(value, MatStruct) and value.count == 1 and {"time", "signals"} <= set(value.fields)


def simulink_channels(variable: str, log: MatStruct, notes: list[str]) -> list[MatChannel]:
    """Time, called ``variable.time``, and the signals by their labels; what is left out is added to `notes`."""
    channels = []
    time = log.get(0, "time")
    signals = log.get(0, "signals")
    clock = f"{variable}.time"
    rows = 0
    if isinstance(time, MatArray) and time.size > 1:
        rows = time.size
        channels.append(MatChannel(Entry(clock, "s", time.dtype, rows), time.read, time.step))
    else:
        notes.append(f"{variable} is a Simulink structure without time; set [ingest] sample_rate")
    if not isinstance(signals, MatStruct):
        return channels
    places = [f"{variable}.signals({i + 1}).values" for i in range(signals.count)]
    labels = [bare(text_of(signals.get(i, "label"))) or place for i, place in enumerate(places)]
    for i, (name, place) in enumerate(zip(unique_names(labels), places, strict=True)):
        values = signals.get(i, "values")
        if isinstance(values, MatArray):
            channels += _signal(name, place, values, clock if values.dims[0] == rows or values.size == rows else None)
        if not isinstance(values, MatArray) or not (values.is_vector or len(values.dims) == 2):
            notes.append(f"{place} ({name!r}) is left out: it holds no real vector or matrix")
    return channels


def _signal(name: str, place: str, values: MatArray, clock: str | None) -> list[MatChannel]:
    """The channels of one signal: itself, or its columns."""
    if values.is_vector:
        aliases = () if name == place else (place,)
        return [MatChannel(Entry(name, "", values.dtype, values.size, clock, aliases), values.read, values.step)]
    if len(values.dims) != 2:
        return []
    rows, columns = values.dims
    entries = [Entry(f"{name}(:,{j + 1})", "", values.dtype, rows, clock) for j in range(columns)]
    return [MatChannel(entry, values.column(j)) for j, entry in enumerate(entries)]


TABLES = ("table", "timetable")
_TIMES = "mM"


def table_channels(path: Path, name: str, kind: str) -> tuple[list[MatChannel], list[str]]:
    """The columns of the table `name` in a MAT file, and the names of those that hold no numbers.

    Raises
    ------
    UnreadableLogError
        mat-io is not installed or does not read this table, or the file leads to others.
    """
    with path.open("rb") as file:
        if file.read(8) == b"MATLAB 7" or b"\x89HDF" in file.read(512):
            for _ in walk(open_hdf5(path)):  # refuses what lies in other files
                pass
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a deprecated option of pandas, and formats in which MATLAB shows times
            from matio import load_from_mat  # not installed on Linux aarch64, for which it has no wheel

            frame = load_from_mat(str(path), variable_names=[name], add_table_attrs=True)[name]
        columns = {str(column): frame[column] for column in frame.columns}
    except Exception as error:  # whatever is damaged or newer than mat-io
        raise UnreadableLogError(
            f"a MATLAB {kind} that mat-io cannot read ({type(error).__name__}: {error}): save its columns as arrays"
        ) from error
    units = [str(unit) for unit in next((frame.attrs[key] for key in frame.attrs if key.endswith("Units")), ())]
    time = f"{name}.{frame.index.name or 'Time'}" if kind == "timetable" else None
    channels = [] if time is None else [_channel(time, frame.index.to_numpy(), "s", None)]
    texts = []
    for i, (column, values) in enumerate(columns.items()):
        if values.dtype.kind not in NUMBERS:
            texts.append(f"{name}.{column}")
            continue
        unit = "s" if values.dtype.kind in _TIMES else units[i] if i < len(units) else ""
        channels.append(_channel(f"{name}.{column}", values.to_numpy(), unit, time))
    return channels, texts


def _channel(name: str, values: Any, unit: str, time: str | None) -> MatChannel:
    samples = values / np.timedelta64(1, "s") if values.dtype.kind == "m" else values
    return MatChannel(
        Entry(name, unit, samples.dtype.name, samples.size, time), lambda first, last: samples[first:last]
    )
