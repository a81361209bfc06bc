"""Whole or not at all: a file is written beside its place, synced, and moved there in one step."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pipeline.runs.confined import folder_within, is_link, linked, new_file, not_written, refuse_link, remove_within

TEMPORARY_MARK = ".debist-tmp"


@contextmanager
def atomic_path(target: Path, *, within: Path | None = None) -> Iterator[Path]:
    """A temporary path to write to; moved onto `target` when the block ends well, removed when it does not.

    Parameters
    ----------
    target : Path
        The file; missing folders on the way are made.
    within : Path, optional
        The folder from which on no link is followed, and whose content may come from anybody.

    Raises
    ------
    InputError
        The disk is full, the folder is read-only, or `target` or a folder between `within` and it is a symbolic link.
    """
    if within is None:
        refuse_link(target)
    temporary = f".{target.name}.{os.getpid()}{TEMPORARY_MARK}"
    try:
        with folder_within(within or target.parent, target.parent) as folder:
            if is_link(folder, target.name):
                raise linked(target)
            file = new_file(folder, temporary)
            try:
                yield Path(f"/dev/fd/{file}")
                os.fsync(file)
                os.replace(temporary, target.name, src_dir_fd=folder, dst_dir_fd=folder)
                os.fsync(folder)
            finally:
                os.close(file)
                with suppress(OSError):  # a folder that became read-only keeps its leftover; `sweep` removes it later
                    os.unlink(temporary, dir_fd=folder)
    except OSError as error:
        raise not_written(target, error) from error


def write_text(target: Path, text: str, *, within: Path | None = None) -> None:
    """Write a text file atomically, UTF-8, line feeds; `within` as for `atomic_path`."""
    write_bytes(target, text.encode(), within=within)


def write_bytes(target: Path, content: bytes, *, within: Path | None = None) -> None:
    """Write a binary file atomically; `within` as for `atomic_path`."""
    with atomic_path(target, within=within) as temporary, temporary.open("wb") as stream:
        stream.write(content)


def sweep(folder: Path) -> int:
    """Remove what a killed process left behind; returns the number of files."""
    return remove_within(folder, TEMPORARY_MARK)


def move(source: Path, target: Path, *, within: Path) -> None:
    """Move a file onto `target` in the same folder, in one step; `within` as for `atomic_path`.

    Raises
    ------
    InputError
        The file system does not let it.
    """
    try:
        with folder_within(within, target.parent) as folder:
            os.replace(source.name, target.name, src_dir_fd=folder, dst_dir_fd=folder)
    except OSError as error:
        raise not_written(target, error) from error


def move_folder(source: Path, target: Path) -> None:
    """Give a folder another name beside its own.

    Raises
    ------
    InputError
        The file system does not let it.
    """
    try:
        source.rename(target)
    except OSError as error:
        raise not_written(target, error) from error


def sync(folder: Path, *, within: Path) -> None:
    """Wait until the names in a folder are on the disk.

    Raises
    ------
    InputError
        They could not be written.
    """
    try:
        with folder_within(within, folder) as held:
            os.fsync(held)
    except OSError as error:
        raise not_written(folder, error) from error
