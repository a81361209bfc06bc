"""HDF5 files as nested mappings of arrays, numbers and texts.

A file may come from anybody, so its declared shapes are compared with its size before it is read. It has only numbers
and texts of its own, in the form in which `write_tree` lays them out, and never more than its bytes can hold.
"""

import math
from collections.abc import Callable, Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from ..errors import CorruptArtifactError, memory_failure
from ..system.plain_files import open_plain
from .atomic import reading, write_bytes
from .hashing import flatten, tree_hash

Tree = dict[str, Any]
Columns = Callable[[str], tuple[str, str]]
"""Unit and meaning of a leaf by its path."""
_UNREADABLE = (OSError, KeyError, RuntimeError, ValueError, TypeError)
_FILTERS = {1, 2, 3}
"""HDF5's numbers of gzip, byte shuffling and Fletcher-32."""
_MOST_FROM_GZIP = 1100
"""Bytes from one byte; deflate cannot give more than 1032."""
_SMALL = 1 << 12
LARGEST_RATIO = 200
_LEAST_ENTRY = 16
"""Bytes that need no look, bytes declared in a file for each of its own, and bytes that an entry takes at least."""
SMALL_FILE = 256 << 20


def write_tree(
    target: Path, tree: Mapping[str, Any], columns: Columns | None = None, *, within: Path | None = None
) -> str:
    """Write a tree and return its content hash; `within` as for `atomic_path`.

    Every leaf becomes a dataset: arrays chunked with Fletcher-32 checksums, numbers and texts as scalars.
    Its entry in `columns` gives its attributes ``unit`` and ``meaning``, which do not count in the hash.

    The file is laid out in memory and written as bytes: HDF5 does not survive a disk that fails under it. Where it
    gets no memory while it closes a dataset, it reports nothing. So the bytes are read back first, which takes as long.

    Parameters
    ----------
    target : Path
        Path of the file.
    tree : mapping
        Nested arrays, numbers and texts.
    columns : callable, optional
        Unit and meaning of an entry by its path.
    within : Path, optional
        As for `atomic_path`.
    """
    digest = tree_hash(tree)
    stream = BytesIO()  # HDF5's own image of a file is damaged in versions before 2.0
    with h5py.File(stream, "w", libver="v110") as file:
        for path, value in flatten(tree):
            array = np.asarray(value)
            if array.dtype.kind in "US":
                dataset = file.create_dataset(path, data=array.astype(object), dtype=h5py.string_dtype())
            elif array.size and array.ndim:
                dataset = file.create_dataset(path, data=array, compression="gzip", shuffle=True, fletcher32=True)
            else:
                dataset = file.create_dataset(path, data=array)
            if columns is not None:
                dataset.attrs["unit"], dataset.attrs["meaning"] = columns(path)
    content = stream.getvalue()
    if tree_hash(parse_tree(content, target)) != digest:
        raise MemoryError
    write_bytes(target, content, within=within)
    return digest


def read_tree(path: Path, group: str = "/") -> Tree:
    """Read a tree, or one of its branches.

    Raises
    ------
    InputError
        The system does not let it.
    CorruptArtifactError
        The file is damaged, or the branch is missing.
    """
    with reading(path), open_plain(path) as stream:
        content = stream.read()
    return parse_tree(content, path, group)


def parse_tree(content: bytes, path: Path, group: str = "/") -> Tree:
    """The tree, or the branch of it, in bytes that were read from `path`.

    Raises
    ------
    CorruptArtifactError
        It is damaged, or the branch is missing.
    """
    try:
        with h5py.File(BytesIO(content), "r") as file:
            return _Reader(len(content)).group(file[group].id)
    except _UNREADABLE as error:
        if memory_failure(error):
            raise MemoryError from error
        raise CorruptArtifactError(
            f"{path}: damaged or incomplete ({' '.join(str(error).split())}); `debist run` sets it aside and "
            "rebuilds it"
        ) from error


class _Reader:
    """Reads what is declared within the bounds of a file of `size` bytes; ValueError for anything else.

    By HDF5's own functions, which take half the time of the objects over them.
    """

    def __init__(self, size: int) -> None:
        self._entries = size // _LEAST_ENTRY
        self._bytes = max(SMALL_FILE, LARGEST_RATIO * size)
        self._letters = size

    def group(self, group: Any) -> Tree:
        """Tree below a group."""
        tree: Tree = {}
        for name in group:
            self._entries -= 1
            if self._entries < 0:
                raise ValueError("more entries than the file can hold")
            if group.links.get_info(name).type != h5py.h5l.TYPE_HARD:
                raise ValueError(f"{name.decode()!r} is a link")
            item = h5py.h5o.open(group, name)
            within = isinstance(item, h5py.h5g.GroupID)
            tree[name.decode()] = self.group(item) if within else self._dataset(h5py.Dataset(item), name.decode())
        return tree

    def _dataset(self, dataset: Any, name: str) -> Any:
        self._check(dataset, name)
        if h5py.check_string_dtype(dataset.dtype) is not None:
            return self._texts(dataset, name)
        value = dataset[()]
        return value.item() if np.ndim(value) == 0 else value

    def _check(self, dataset: Any, name: str) -> None:
        """Make sure that the samples are in this file, and as many as it declares."""
        layout = dataset.id.get_create_plist()
        if layout.get_layout() == h5py.h5d.VIRTUAL or layout.get_external_count():
            raise ValueError(f"{name!r} lies in other files")
        filters = [layout.get_filter(i)[0] for i in range(layout.get_nfilters())]
        if len(set(filters)) < len(filters) or not _FILTERS.issuperset(filters):
            raise ValueError(f"{name!r} is packed as debist packs nothing")
        if dataset.dtype.kind not in "biufO" or (dataset.dtype.kind == "O" and filters):
            raise ValueError(f"{name!r} is of type {dataset.dtype}")
        declared = (dataset.size or 0) * dataset.dtype.itemsize
        stored = dataset.id.get_storage_size()
        self._bytes -= max(declared, dataset.dtype.itemsize * math.prod(dataset.chunks or (1,)))
        if self._bytes < 0 or (declared > _SMALL and declared > stored * (_MOST_FROM_GZIP if filters else 1)):
            raise ValueError(f"{name!r} declares {declared / 1e6:.3g} MB and stores {stored / 1e6:.3g}")

    def _texts(self, dataset: Any, name: str) -> Any:
        """A text or an array of texts, one by one: many may lead to one place in the file."""
        texts = np.empty(dataset.shape, dtype=object)
        for place in np.ndindex(dataset.shape):
            texts[place] = dataset.asstr()[place]
            self._letters -= len(texts[place])
            if self._letters < 0:
                raise ValueError(f"{name!r} has more letters than the file")
        return texts.item() if texts.ndim == 0 else np.asarray(texts, dtype=str)
