"""The channels of a MAT file: recordings of ControlDesk and Simulink, tables, plain vectors, matrices and structs.

ControlDesk writes one struct (of any name) with two struct arrays. ``X`` has the time axes (Name, Type, Data, Unit,
Raster), and ``Y`` the channels (the same and Path, XIndex: which axis).

Scopes and "To Workspace" blocks write one struct (of any name) with ``time`` and a struct array ``signals`` (values,
dimensions, label, …). ``values`` has a row for each time; signals of several elements have columns, and what is 1×1×N
is a vector.
"""

import math
import warnings
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from ..units.units import SECONDS, time_unit
from .attributes import is_unit, rates_among, scales_among, starts_among, stated_rate
from .channel_roles import is_called
from .hdf5 import NUMBERS, open_hdf5, walk
from .source import (
    MOST_COLUMNS,
    PART,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    not_listed,
    ranges,
    unique_names,
)

Reader = Callable[[int, int], NDArray[Any]]
"""First and end sample → samples."""
TABLES = ("table", "timetable")
_MOST_ELEMENTS = 1000
_WAYS_OUT = {
    "iddata": "save its vectors (NAME.u, NAME.y) and its sample time (NAME.Ts)",
    "timeseries": "save its vectors (NAME.Time, NAME.Data)",
    "complex array": "save its real part, real(NAME)",
    "sparse array": "save full(NAME)",
    "cell": "save what it holds as variables of their own, as NAME1 = NAME{1}",
}
"""Advice for variables that are not read, by their class."""


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

    def column(self, j: int) -> "MatArray":
        """Column j (from 0) of a matrix."""
        rows = self.dims[0]
        return MatArray((rows,), self.dtype, lambda first, last: self.read(j * rows + first, j * rows + last))

    def row(self, j: int) -> "MatArray":
        """Row j (from 0) of a matrix: every part of that is read for each row."""
        rows, columns = self.dims
        return MatArray((columns,), self.dtype, lambda first, last: self.read(first * rows, last * rows)[j::rows])


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


MatChannel = tuple[Entry, MatArray]
"""A channel as a layout finds it, with its samples."""


def _channel(
    name: str, data: MatArray, unit: str = "", time: str | None = None, aliases: tuple[str, ...] = ()
) -> MatChannel:
    """The channel of that name, a vector."""
    return Entry(name, unit, data.dtype, data.size, time, aliases), data


def _columns_of(name: str, matrix: MatArray, time: str | None = None) -> list[MatChannel]:
    """The columns of a matrix as name(:,j)."""
    return [_channel(f"{name}(:,{j + 1})", matrix.column(j), time=time) for j in range(matrix.dims[1])]


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
    matches = [
        sum(
            index is not None and 0 <= index - base < len(axes) and axes[int(index) - base][1] == size
            for index, size in zip(indices, sizes, strict=True)
        )
        for base in (0, 1)
    ]
    first = 0 if matches[0] > matches[1] else 1  # of XIndex: in MATLAB's way, unless fewer lengths match
    for i, name, path, index, size in zip(rows, unique_names(names), paths, indices, sizes, strict=True):
        data = arrays[i]
        position = 0 if index is None else int(index) - first
        axis = axes[position] if 0 <= position < len(axes) else None
        if axis is None or axis[1] != size:
            notes.append(f"channel {name!r} has {size} samples and no time axis of that length")
        time = axis[0] if axis is not None and axis[1] == size else None
        unit = text_of(channels.get(i, "Unit")).strip()
        aliases = (path,) if path != name and paths.count(path) == 1 and path else ()
        recorded.append(_channel(name, data, unit, time, aliases))
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
            factor = SECONDS.get(time_unit(unit))
            lengths.append((name, data.size if isinstance(data, MatArray) and factor is not None else 0))
            if not isinstance(data, MatArray) or not data.size:
                continue
            if factor is None:
                notes.append(f"the axis {name!r} is in {unit} and no time: its channels need a [channels] time")
                channels.append(_channel(name, data, unit))
            else:
                notes += [] if factor == 1.0 else [f"the time axis {name!r} counts in {unit} and is read in s"]
                channels.append(_channel(name, data if factor == 1.0 else _scaled(data, factor), "s"))
    return lengths, channels


def _scaled(data: MatArray, factor: float) -> MatArray:
    return replace(data, read=lambda first, last: data.read(first, last) * factor)


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
        channels.append(_channel(clock, time, "s"))
    else:
        notes.append(f"{variable} is a Simulink structure without time; set [ingest] sample_rate")
    if not isinstance(signals, MatStruct):
        return channels
    places = [f"{variable}.signals({i + 1}).values" for i in range(signals.count)]
    labels = [bare(text_of(signals.get(i, "label"))) or place for i, place in enumerate(places)]
    for i, (name, place) in enumerate(zip(unique_names(labels), places, strict=True)):
        values = signals.get(i, "values")
        if not isinstance(values, MatArray) or not (values.is_vector or len(values.dims) == 2):
            notes.append(f"{place} ({name!r}) is left out: it holds no real vector or matrix")
            continue
        time_of = clock if rows in (values.dims[0], values.size) else None
        if values.is_vector:
            channels.append(_channel(name, values, time=time_of, aliases=() if name == place else (place,)))
        else:
            channels += _columns_of(name, values, time_of)
    return channels


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
    channels = [] if time is None else [_column(time, frame.index.to_numpy(), "s", None)]
    texts = []
    for i, (column, values) in enumerate(columns.items()):
        if values.dtype.kind not in NUMBERS:
            texts.append(f"{name}.{column}")
            continue
        unit = "s" if values.dtype.kind in "mM" else units[i] if i < len(units) else ""
        channels.append(_column(f"{name}.{column}", values.to_numpy(), unit, time))
    return channels, texts


def _column(name: str, values: Any, unit: str, time: str | None) -> MatChannel:
    samples = values / np.timedelta64(1, "s") if values.dtype.kind == "m" else values
    data = MatArray(samples.shape, samples.dtype.name, lambda first, last: samples[first:last])
    return _channel(name, data, unit, time)


class MatSource(Source):
    """The numeric channels among the variables of a MAT file."""

    def __init__(self, version: str, variables: dict[str, MatValue], path: Path) -> None:
        super().__init__()
        self._channels: dict[str, MatChannel] = {}
        self._not_listed: dict[str, tuple[int, ...]] = {}
        recordings = [name for name, value in variables.items() if is_recorder(value) or is_simulink_log(value)]
        makers = {"ControlDesk" if is_recorder(variables[name]) else "Simulink" for name in recordings}
        self.format = ", ".join([f"MAT {version}", *sorted(makers)])
        if len(recordings) > 1:
            self.notes.append(f"{len(recordings)} recordings in one file; channels are named recording/channel")
        for name, value in variables.items():
            prefix = f"{name}/" if len(recordings) > 1 else ""
            if is_recorder(value):
                self._add(recorder_channels(value, self.notes), prefix)
            elif is_simulink_log(value):
                self._add(simulink_channels(name, value, self.notes), prefix)
            elif isinstance(value, MatObject) and value.kind in TABLES:
                self._add_table(path, name, value.kind)
            else:
                self._add(self._plain(name, value))
        self.notes += [*left_out(self.texts), *not_listed(self._not_listed)]

    def entries(self) -> list[Entry]:
        """Every numeric channel."""
        return [entry for entry, _ in self._channels.values()]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels."""
        for name in names:
            entry, data = self._channels[name]
            for first, last in ranges(entry.count, data.step):
                yield name, self.counted(name, data.read(first, last))

    def _add(self, channels: Sequence[MatChannel], prefix: str = "") -> None:
        for entry, data in channels:
            time = None if entry.time is None else prefix + entry.time
            self._channels[prefix + entry.name] = replace(entry, name=prefix + entry.name, time=time), data

    def _add_table(self, path: Path, name: str, kind: str) -> None:
        try:
            channels, texts = table_channels(path, name, kind)
        except UnreadableLogError as error:
            self.texts[name] = f"{error}"
            return
        self._add(channels)
        self.texts |= dict.fromkeys(texts, "text")

    def _plain(self, name: str, value: MatValue, second: float = 1.0) -> list[MatChannel]:
        """Vectors by their name, signals of matrices, fields of structs as name.field or name(k).field."""
        if isinstance(value, MatObject):
            advice = _WAYS_OUT.get(value.kind, "save its vectors as variables of their own").replace("NAME", name)
            self.texts[name] = f"a MATLAB {value.kind}: {advice}"
        elif isinstance(value, str) and value:
            self.texts[name] = f"the text {value[:40]!r}"
            self.note_rates(rates_among({name: value}, ""))
            self.heading = "; ".join(filter(None, (self.heading, value)))
        elif isinstance(value, MatArray):
            self._note_scalar(name, value, second)
            if value.is_vector:
                return [_channel(name, value)]
            if len(value.dims) == 2 and 1 < min(value.dims) <= MOST_COLUMNS:
                rows, columns = value.dims
                if columns <= rows:
                    return _columns_of(name, value)
                return [_channel(f"{name}({j + 1},:)", value.row(j)) for j in range(rows)]  # as targets write samples
            if value.size > 1:
                self._not_listed[name] = value.dims
        elif isinstance(value, MatStruct) and value.count <= _MOST_ELEMENTS:
            places = [name] if value.count == 1 else [f"{name}({i + 1})" for i in range(value.count)]
            return [each for i, place in enumerate(places) for each in self._fields(place, value, i)]
        return []

    def _fields(self, place: str, value: MatStruct, index: int) -> list[MatChannel]:
        """The channels of one element of a struct, in the units that it states: for all of them, or by their names."""
        members = {field: value.get(index, field) for field in value.fields}
        units = next((members[field] for field in members if is_unit(field)), None)
        second = SECONDS.get(time_unit(text_of(members.get("TimeUnit"))), 1.0)
        several = sum(isinstance(each, MatArray) for each in members.values()) > 1
        channels = []
        for field, member in members.items():
            if is_unit(field):
                continue
            info = members.get(f"{field}Info")  # as of a timeseries that was saved as a struct
            of_all = members.get("TimeUnit") if several and is_called("time", field) else units
            by_name = units.get(0, field) if isinstance(units, MatStruct) else of_all
            unit = text_of(info.get(0, "Units") if isinstance(info, MatStruct) else by_name)
            plain_channels = self._plain(f"{place}.{field}", member, second)
            channels += [(replace(entry, unit=entry.unit or unit.strip()), data) for entry, data in plain_channels]
        return channels

    def _note_scalar(self, name: str, value: MatArray, second: float) -> None:
        """Note a number that may be the sample rate, the interval in units of so many seconds, or a scale."""
        number = scalar_of(value)
        if number is None:
            return
        is_interval = (stated_rate(name, 2.0) or 0.0) < (stated_rate(name, 1.0) or 0.0)
        rates = rates_among({name: number}, "")
        self.note_rates({key: (number, rate / second if is_interval else rate) for key, (_, rate) in rates.items()})
        self.stated_starts |= starts_among({name: number}, "")
        self.notes += scales_among({name: number})
