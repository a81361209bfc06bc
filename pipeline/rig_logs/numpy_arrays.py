"""Arrays of NumPy, alone (NPY) or in an archive (NPZ): vectors by name, columns of matrices as name[:,j]."""

import zipfile
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .attributes import rates_among, scales_among
from .source import (
    MOST_COLUMNS,
    Entry,
    Source,
    UnreadableLogError,
    left_out,
    not_listed,
    ranges,
)


class NumpySource(Source):
    """NPY or NPZ; pickled objects in it are never loaded."""

    def __init__(self, path: Path, *_: object) -> None:
        super().__init__()
        self._vectors: dict[str, NDArray[Any]] = {}
        self._not_listed: dict[str, tuple[int, ...]] = {}
        try:
            loaded = np.load(path, allow_pickle=False, mmap_mode="r")
            single = isinstance(loaded, np.ndarray)
            self.format = "NPY" if single else "NPZ"
            for name in ["array"] if single else loaded.files:
                self._list(name, loaded if single else self._member(loaded, name))
        except (ValueError, EOFError, OSError, KeyError, zlib.error, zipfile.BadZipFile) as error:
            pickled = "; save its arrays by numpy.savez" if "Python objects" in f"{error}" else ""
            raise UnreadableLogError(f"NumPy cannot open it: {error}{pickled}") from error
        self.notes += [*left_out(self.texts), *not_listed(self._not_listed)]

    def _member(self, archive: Any, name: str) -> NDArray[Any]:
        """An array of the archive; of objects an empty one, which is named."""
        try:
            return np.asarray(archive[name])
        except ValueError as error:
            if "allow_pickle" not in str(error):
                raise
            self.texts[name] = "Python objects"
            return np.empty(0)

    def _list(self, name: str, array: NDArray[Any]) -> None:
        if array.dtype.names:
            for field in array.dtype.names:
                self._list(f"{name}.{field}", array[field])
        elif array.size > 1 and array.dtype.kind not in "fiubmM":
            self.texts[name] = "complex: save its real part" if array.dtype.kind == "c" else f"{array.dtype}"
        elif array.size > 1 and array.size == max(array.shape):
            self._vectors[name] = array.reshape(-1)
        elif array.ndim == 2 and 1 < min(array.shape) <= MOST_COLUMNS:
            tall = array.shape[1] <= array.shape[0]
            for j, column in enumerate(array.T if tall else array):
                self._vectors[f"{name}[:,{j}]" if tall else f"{name}[{j},:]"] = column
        elif array.size > 1:
            self._not_listed[name] = array.shape
        elif array.size and array.dtype.kind in "fiu":
            stated = {name: float(array.reshape(-1)[0])}
            self.note_rates(rates_among(stated, ""))
            self.notes += scales_among(stated)

    def entries(self) -> list[Entry]:
        """Every vector of real numbers."""
        return [
            Entry(name, "s" if vector.dtype.kind in "mM" else "", vector.dtype.name, vector.size)
            for name, vector in self._vectors.items()
        ]

    def parts(self, names: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
        """The samples of some channels."""
        for name in names:
            for first, last in ranges(self._vectors[name].size):
                yield name, self.counted(name, np.asarray(self._vectors[name][first:last]))


open_log = NumpySource
