"""HDF5 logs: vectors by their path, columns of matrices as path[:,j]; units from the usual attributes."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pipeline.rig_logs.hdf5_safety import flat, open_hdf5, rows_at_a_time, walk
from pipeline.rig_logs.limits import Limits
from pipeline.rig_logs.source import CsvOptions, Entry, Source, ranges

_UNIT_ATTRIBUTES = ("unit", "units", "Unit", "Units", "UNIT")
_MOST_COLUMNS = 1000


class Hdf5Source:
    """A plain HDF5 file; it declares no time base, the settings name the time channel."""

    format = "HDF5"

    def __init__(self, path: Path) -> None:
        self.notes: list[str] = []
        self.texts: dict[str, str] = {}
        self._places: dict[str, tuple[Any, int | str | None]] = {}
        self._entries: list[Entry] = []
        self._file = open_hdf5(path)
        for name, dataset in walk(self._file):
            self._list(name, dataset)

    def entries(self) -> list[Entry]:
        """Every vector of real numbers."""
        return self._entries

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels, in slices along the stored chunks."""
        for name in names:
            dataset, column = self._places[name]
            axis = int(np.argmax(dataset.shape)) if column is None else 0
            for first, last in ranges(dataset.shape[axis], rows_at_a_time(dataset, axis)):
                if column is None:
                    yield name, flat(dataset, first, last)
                elif isinstance(column, str):
                    yield name, np.asarray(dataset.fields(column)[first:last])
                else:
                    yield name, np.asarray(dataset[first:last, column])

    def _list(self, name: str, dataset: Any) -> None:
        unit = _unit(dataset)
        shape: tuple[int, ...] = dataset.shape or ()
        if dataset.dtype.names and len(shape) == 1:  # a table of named columns
            for field in dataset.dtype.names:
                if dataset.dtype[field].kind in "fiu" and not dataset.dtype[field].shape:
                    self._add(f"{name}.{field}", "", dataset.dtype[field], shape[0], dataset, field)
        elif dataset.dtype.kind in "fiu" and dataset.size and dataset.size == max(shape, default=0) > 1:
            self._add(name, unit, dataset.dtype, dataset.size, dataset, None)
        elif dataset.dtype.kind in "fiu" and len(shape) == 2 and shape[0] > 1 and 1 < shape[1] <= _MOST_COLUMNS:
            for j in range(shape[1]):
                self._add(f"{name}[:,{j}]", unit, dataset.dtype, shape[0], dataset, j)

    def _add(
        self, name: str, unit: str, dtype: np.dtype[Any], count: int, dataset: Any, column: int | str | None
    ) -> None:
        self._places[name] = (dataset, column)
        self._entries.append(Entry(name, unit, dtype.name, int(count)))


def _unit(dataset: Any) -> str:
    for attribute in _UNIT_ATTRIBUTES:
        value = dataset.attrs.get(attribute)
        if isinstance(value, bytes):
            return value.decode("utf-8", "replace")
        if isinstance(value, str):
            return value
    return ""


def open_log(path: Path, csv: CsvOptions, limits: Limits) -> Source:
    """The log as `pipeline.rig_logs.formats` opens it."""
    return Hdf5Source(path)
