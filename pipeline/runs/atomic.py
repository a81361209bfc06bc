"""Whole or not at all: a file is written beside its place, synced, and moved there in one step."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pipeline.runs.disk import not_written, reading, refuse_link

TEMPORARY_MARK = ".debist-tmp"


@contextmanager
def atomic_path(target: Path) -> Iterator[Path]:
    """A temporary path to write to; moved onto `target` when the block ends well, removed when it does not.

    Raises
    ------
    InputError
        The disk is full, the folder is read-only, or `target` is a symbolic link.
    """
    refuse_link(target)
    temporary = target.with_name(f".{target.name}.{os.getpid()}{TEMPORARY_MARK}")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        yield temporary
        sync(temporary)
        temporary.replace(target)
        sync(target.parent)
    except OSError as error:
        raise not_written(target, error) from error
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
    with reading(folder):
        leftovers = list(folder.rglob(f".*{TEMPORARY_MARK}"))
        for leftover in leftovers:
            leftover.unlink(missing_ok=True)
    return len(leftovers)


def move(source: Path, target: Path) -> None:
    """Move a file onto `target` in one step.

    Raises
    ------
    InputError
        The file system does not let it.
    """
    try:
        source.replace(target)
    except OSError as error:
        raise not_written(target, error) from error


def sync(path: Path) -> None:
    """Wait until a file, or the names in a folder, are on the disk.

    Raises
    ------
    InputError
        They could not be written.
    """
    try:
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as error:
        raise not_written(path, error) from error
