"""Whole or not at all: a file is written beside its place, synced, and moved there in one step."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pipeline.errors import InputError

TEMPORARY_MARK = ".debist-tmp"


@contextmanager
def atomic_path(target: Path) -> Iterator[Path]:
    """A temporary path to write to; moved onto `target` when the block ends well, removed when it does not.

    Raises
    ------
    InputError
        The disk is full, the folder is read-only, or `target` is a symbolic link.
    """
    if target.is_symlink():
        raise InputError(f"{target}: is a symbolic link; debist writes to no link, remove it and run again")
    temporary = target.with_name(f".{target.name}.{os.getpid()}{TEMPORARY_MARK}")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        yield temporary
        _sync(temporary)
        temporary.replace(target)
        _sync(target.parent)
    except OSError as error:
        raise InputError(
            f"{target}: cannot be written: {error.strerror or error}; free space or permit writing, run again"
        ) from error
    finally:
        with suppress(OSError):  # a folder that became read-only keeps its leftover; `sweep` removes it later
            temporary.unlink(missing_ok=True)


def write_text(target: Path, text: str) -> None:
    """Write a text file atomically, UTF-8, line feeds."""
    with atomic_path(target) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def write_bytes(target: Path, content: bytes) -> None:
    """Write a binary file atomically."""
    with atomic_path(target) as temporary:
        temporary.write_bytes(content)


def sweep(folder: Path) -> int:
    """Remove what a killed process left behind; returns the number of files."""
    leftovers = list(folder.rglob(f".*{TEMPORARY_MARK}"))
    for leftover in leftovers:
        leftover.unlink(missing_ok=True)
    return len(leftovers)


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
