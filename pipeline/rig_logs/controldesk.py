"""Channels of a MAT file: ControlDesk's recorder layout, and plain vectors, matrices and structs.

ControlDesk writes one struct (of any name) with a struct array ``X`` of time axes (Name, Type, Data, Unit,
Raster), a struct array ``Y`` of channels (the same and Path, XIndex: which axis), and ``Description``; other
versions add ``Capture``, whose SamplingPeriod × Downsampling is the time step where ``X`` holds no data.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeGuard

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.source import PART, Entry, UnreadableLogError, ranges, unique_names


@dataclass(frozen=True)
class MatArray:
    """A real numeric array whose samples are still in the file.

    `read(start, stop)` gives a range of them in column-major order; `step` says how many at a time cost least.
    """

    dims: tuple[int, ...]
    dtype: str
    read: Callable[[int, int], NDArray[Any]]
    step: int = PART

    @property
    def size(self) -> int:
        """Number of elements."""
        size = 1
        for dim in self.dims:
            size *= dim
        return size


class MatStruct(Protocol):
    """A struct array."""

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of the fields."""

    @property
    def count(self) -> int:
        """Number of elements."""

    def get(self, index: int, name: str) -> "MatValue":
        """Field `name` of element `index`; None where there is no such field."""


MatValue = MatArray | MatStruct | str | None
"""None stands for what is no data here: cells, objects, function handles, complex or sparse arrays."""


def text_of(value: MatValue) -> str:
    """A text, or "" for anything else."""
    return value if isinstance(value, str) else ""


def scalar_of(value: MatValue) -> float | None:
    """The one number of a 1×1 array, or None."""
    return float(value.read(0, 1)[0]) if isinstance(value, MatArray) and value.size == 1 else None


_DEEPEST = 8
_MOST_COLUMNS = 1000

Reader = Callable[[int, int], NDArray[Any]]


class MatSource:
    """The numeric channels among the variables of a MAT file."""

    def __init__(self, version: str, variables: dict[str, MatValue]) -> None:
        self.notes: list[str] = []
        self.texts: dict[str, str] = {}
        self._entries: list[Entry] = []
        self._readers: dict[str, tuple[Reader, int, int]] = {}
        recorders = [name for name, value in variables.items() if _is_recorder(value)]
        self.format = f"MAT {version}, ControlDesk" if recorders else f"MAT {version}"
        if len(recorders) > 1:
            self.notes.append(f"{len(recorders)} recordings in one file; channels are named recording/channel")
        for name, value in variables.items():
            if name in recorders:
                self._add_recorder(value, f"{name}/" if len(recorders) > 1 else "")  # type: ignore[arg-type]
            else:
                self._add_plain(name, value, _DEEPEST)

    def entries(self) -> list[Entry]:
        """Every numeric channel."""
        return self._entries

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels."""
        for name in names:
            read, count, step = self._readers[name]
            for first, last in ranges(count, step):
                yield name, read(first, last)

    def _add(self, entry: Entry, read: Reader, step: int = PART) -> None:
        self._entries.append(entry)
        self._readers[entry.name] = (read, entry.count, step)

    def _add_recorder(self, record: MatStruct, prefix: str) -> None:
        axes = self._add_time_axes(record, prefix)
        channels = record.get(0, "Y")
        if not _is_struct(channels):
            raise UnreadableLogError("the ControlDesk struct has no channels Y")
        arrays = {i: data for i in range(channels.count) if isinstance(data := channels.get(i, "Data"), MatArray)}
        rows = list(arrays)
        names = [_bare(text_of(channels.get(i, "Name"))) or f"Y({i + 1})" for i in rows]
        paths = [_bare(text_of(channels.get(i, "Path"))) for i in rows]
        indices = [scalar_of(channels.get(i, "XIndex")) for i in rows]
        sizes = [data.size for data in arrays.values()]
        first = _index_base(indices, sizes, [size for _, size in axes])
        for i, name, path, index, size in zip(rows, unique_names(names), paths, indices, sizes, strict=True):
            data = arrays[i]
            position = 0 if index is None else int(index) - first
            axis = axes[position] if 0 <= position < len(axes) else None
            if axis is None or axis[1] != size:
                self.notes.append(f"channel {name!r} has {size} samples and no time axis of that length")
            time = axis[0] if axis is not None and axis[1] == size else None
            unit = text_of(channels.get(i, "Unit")).strip()
            aliases = (path,) if path != name and paths.count(path) == 1 and path else ()
            self._add(Entry(prefix + name, unit, data.dtype, size, time, aliases), data.read, data.step)

    def _add_time_axes(self, record: MatStruct, prefix: str) -> list[tuple[str, int]]:
        """Enter the time axes; their names and lengths in the order that XIndex counts."""
        axes = record.get(0, "X")
        found: list[tuple[str, int]] = []
        if _is_struct(axes):
            names = []
            for i in range(axes.count):
                raster = text_of(axes.get(i, "Raster")) or str(i + 1)
                names.append(text_of(axes.get(i, "Name")) or ("time" if axes.count == 1 else f"time ({raster})"))
            for i, name in enumerate(unique_names(names)):
                data = axes.get(i, "Data")
                if isinstance(data, MatArray) and data.size:
                    unit = text_of(axes.get(i, "Unit")).strip()
                    self._add(Entry(prefix + name, unit or "s", data.dtype, data.size), data.read, data.step)
                    found.append((prefix + name, data.size))
                else:
                    found.append((prefix + name, 0))
        if any(size for _, size in found):
            return found
        return self._time_from_capture(record, prefix)

    def _time_from_capture(self, record: MatStruct, prefix: str) -> list[tuple[str, int]]:
        capture, channels = record.get(0, "Capture"), record.get(0, "Y")
        if not (_is_struct(capture) and _is_struct(channels)):
            return []
        period = scalar_of(capture.get(0, "SamplingPeriod"))
        data = channels.get(0, "Data")
        if period is None or not isinstance(data, MatArray):
            return []
        step = period * (scalar_of(capture.get(0, "Downsampling")) or 1.0)
        count = data.size
        self.notes.append(f"time from SamplingPeriod × Downsampling = {step:g} s; the log has no time axis")
        self._add(Entry(prefix + "time", "s", "float64", count), lambda first, last: step * np.arange(first, last))
        return [(prefix + "time", count)]

    def _add_plain(self, name: str, value: MatValue, depth: int) -> None:
        """Vectors by their name, columns of matrices as name(:,j), fields of structs as name.field."""
        if isinstance(value, MatArray):
            if value.size == max(value.dims, default=0) and value.size > 1:
                self._add(Entry(name, "", value.dtype, value.size), value.read, value.step)
            elif len(value.dims) == 2 and 1 < value.dims[1] <= _MOST_COLUMNS and value.dims[0] > 1:
                rows, columns = value.dims
                for j in range(columns):
                    self._add(
                        Entry(f"{name}(:,{j + 1})", "", value.dtype, rows),
                        lambda first, last, j=j: value.read(j * rows + first, j * rows + last),  # type: ignore[misc]
                    )
        elif _is_struct(value) and value.count == 1 and depth:
            for field in value.fields:
                self._add_plain(f"{name}.{field}", value.get(0, field), depth - 1)


def _is_struct(value: MatValue) -> TypeGuard[MatStruct]:
    return value is not None and not isinstance(value, str | MatArray)


def _is_recorder(value: MatValue) -> bool:
    return _is_struct(value) and value.count == 1 and {"X", "Y"} <= set(value.fields)


def _bare(name: str) -> str:
    """A name without the quotes around it or around the parts of a model path."""
    return "/".join(part.strip('"') for part in name.strip().split("/")) if '"' in name else name.strip()


def _index_base(indices: list[float | None], sizes: list[int], lengths: list[int]) -> int:
    """Whether XIndex counts from 1 (MATLAB's way, the default) or from 0: as the lengths match."""

    def matches(first: int) -> int:
        """How many signals have the length of their axis if indices count from `first`."""
        positions = [None if index is None else int(index) - first for index in indices]
        return sum(
            p is not None and 0 <= p < len(lengths) and lengths[p] == size
            for p, size in zip(positions, sizes, strict=True)
        )

    return 0 if matches(0) > matches(1) else 1
