"""Files read only if they have the size and the SHA-256 that were recorded."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from pipeline.plain_files import open_plain
from pipeline.runs.atomic import reading
from pipeline.runs.hashing import file_sha256
from pipeline.runs.manifest import NEXT_MANIFEST, staging_place
from pipeline.runs.tables import read_buffer

T = TypeVar("T")
Read = Callable[[Path], tuple[T, str]]
"""Gives what is wanted of a file, and the SHA-256 of the bytes that it is from."""


def look_up(root: Path, path: Path, size: int, sha256: str, read: Read[T]) -> tuple[T | None, str | None]:
    """What `read` gives of a file of the run `root`, or what is wrong with it.

    While a commit awaits its completion the file is at its staging place, from which it may just be moved.

    Raises
    ------
    InputError
        The system does not let it be read.
    """
    with reading(path):
        content, problem = _look(path, size, sha256, read)
        if problem is not None and (root / NEXT_MANIFEST).exists():
            content, elsewhere = _look(staging_place(path), size, sha256, read)
            problem = elsewhere and problem
        if problem is not None:
            content, problem = _look(path, size, sha256, read)
    return content, problem


def _look(path: Path, size: int, sha256: str, read: Read[T]) -> tuple[T | None, str | None]:
    try:
        present = path.stat().st_size
        if not path.is_file():
            return None, "is no regular file"
        if present != size:
            return None, f"has {present} bytes, {size} were written"
        content, digest = read(path)
    except FileNotFoundError:
        return None, "is missing"
    return (content, None) if digest == sha256 else (None, "does not have the bytes that were written")


def hashed(path: Path) -> tuple[Path, str]:
    """The path itself."""
    return path, file_sha256(path)


def whole(path: Path) -> tuple[bytes, str]:
    """All bytes."""
    with open_plain(path) as stream:
        content = stream.read()
    return content, hashlib.sha256(content).hexdigest()


def buffered(path: Path) -> tuple[Any, str]:
    """All bytes in memory of Arrow's own."""
    content = read_buffer(path)
    return content, hashlib.sha256(memoryview(content)).hexdigest()
