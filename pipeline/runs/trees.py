"""HDF5 files as nested mappings of arrays, numbers and texts."""

from collections.abc import Callable, Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.errors import CorruptArtifactError, memory_failure
from pipeline.plain_files import open_plain
from pipeline.runs.atomic import write_bytes
from pipeline.runs.confined import reading
from pipeline.runs.hashing import flatten, tree_hash

Tree = dict[str, Any]
Columns = Callable[[str], tuple[str, str]]
"""Unit and meaning of a leaf by its path."""
_UNREADABLE = (OSError, KeyError, RuntimeError, ValueError)


def write_tree(
    target: Path, tree: Mapping[str, Any], columns: Columns | None = None, *, within: Path | None = None
) -> str:
    """Write a tree and return its content hash; `within` as for `atomic_path`.

    Every leaf becomes a dataset: arrays chunked with Fletcher-32 checksums, numbers and texts as scalars.
    What `columns` says of it become its attributes ``unit`` and ``meaning``, which do not count in the hash.

    The file is laid out in memory and written as bytes: HDF5 does not survive a disk that fails under it. What it was
    refused memory for while it closes a dataset it tells nobody, so the bytes are read back first, which takes as long.
    """
    digest = tree_hash(tree)
    try:
        content = _laid_out(tree, columns)
        whole = tree_hash(parse_tree(content, target)) == digest
    except (OSError, RuntimeError, ValueError, KeyError, CorruptArtifactError) as error:
        if isinstance(error, ValueError | KeyError) and "Unable to synchronously" not in str(error):
            raise
        raise MemoryError from error  # HDF5 has words of its own for that, and in memory nothing else fails
    if not whole:
        raise MemoryError
    write_bytes(target, content, within=within)
    return digest


def _laid_out(tree: Mapping[str, Any], columns: Columns | None) -> bytes:
    """The bytes of the file."""
    import h5py

    with h5py.File("tree", "w", driver="core", backing_store=False, libver="v110") as file:
        for path, value in flatten(tree):
            array = np.asarray(value)
            if array.dtype.kind in "US":
                made = file.create_dataset(path, data=array.astype(object), dtype=h5py.string_dtype())
            elif array.size and array.ndim:
                made = file.create_dataset(path, data=array, compression="gzip", shuffle=True, fletcher32=True)
            else:
                made = file.create_dataset(path, data=array)
            if columns is not None:
                made.attrs["unit"], made.attrs["meaning"] = columns(path)
        file.flush()
        content: bytes = file.id.get_file_image()
    return content


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
        try:
            return _parsed(content, group)
        except _UNREADABLE:  # of memory that HDF5 was refused it may say only that it cannot read
            return _parsed(content, group)
    except _UNREADABLE as error:
        if memory_failure(error):
            raise MemoryError from error
        reason = " ".join(str(error).split())
        raise CorruptArtifactError(
            f"{path}: damaged or incomplete ({reason}); `debist run` sets it aside and rebuilds it"
        ) from error


def _parsed(content: bytes, group: str) -> Tree:
    import h5py

    with h5py.File(BytesIO(content), "r") as file:
        return _read_group(file[group].id)


def _read_group(group: Any) -> Tree:
    """What lies below a group, by HDF5's own functions, which take half the time of the objects over them."""
    import h5py

    tree: Tree = {}
    for name in group:
        if group.links.get_info(name).type != h5py.h5l.TYPE_HARD:
            raise ValueError(f"{name.decode()!r} is a link")
        item = h5py.h5o.open(group, name)
        within = isinstance(item, h5py.h5g.GroupID)
        tree[name.decode()] = _read_group(item) if within else _read_dataset(h5py.Dataset(item))
    return tree


def _read_dataset(dataset: Any) -> Any:
    import h5py

    if h5py.check_string_dtype(dataset.dtype) is not None:
        text = dataset.asstr()[()]
        return text if isinstance(text, str) else np.asarray(text, dtype=str)
    value = dataset[()]
    return value.item() if np.ndim(value) == 0 else value
