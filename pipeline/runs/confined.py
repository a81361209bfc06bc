"""Folders and files inside a run, reached step by step from the run folder's descriptor and through no link.

A run folder may come from anybody: a symbolic link in it could lead a write to any file of the user. The run folder
itself may be named through links; from there on every step is one name, opened without following any. A disk that
fails is told in one line with the path, and never as damage of a file that could only not be read.
"""

import errno
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from pipeline.errors import InputError


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Within, `path` and what lies in it is read or looked up.

    Raises
    ------
    InputError
        The system does not let it.
    """
    try:
        yield
    except OSError as error:
        named = error.filename  # a bare name where a folder was held by its descriptor
        place = named if isinstance(named, str) and Path(named).is_relative_to(path) else path
        raise _not_read(place, error.strerror or str(error)) from error


def refuse_link(path: Path) -> None:
    """Refuse to write through a symbolic link.

    Raises
    ------
    InputError
        `path` is one, or that cannot be found out.
    """
    with reading(path):
        is_one = path.is_symlink()
    if is_one:
        raise linked(path)


def make_folder(path: Path) -> None:
    """Make a folder and those on the way to it.

    Raises
    ------
    InputError
        A file has its name, or the system does not let it.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise not_written(path, error) from error


def not_written(path: Path, error: OSError) -> InputError:
    """That a file could not be written, and why."""
    if isinstance(error, FileExistsError | NotADirectoryError):
        return InputError(f"{path}: cannot be written: a file is in the way of a folder; name another place")
    return InputError(f"{path}: cannot be written: {error.strerror or error}; free space or permit writing, run again")


def _not_read(path: str | Path, reason: str) -> InputError:
    return InputError(f"{path}: cannot be read: {reason}; see to disk and permission or move it away, run again")


_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC
_NEW = os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
_LINK = (errno.ELOOP, errno.ENOTDIR, errno.EMLINK)


@contextmanager
def folder_within(root: Path, folder: Path) -> Iterator[int]:
    """The descriptor of `folder`, which is `root` or lies below it; missing folders are made, `root` included.

    Raises
    ------
    InputError
        One of them is a symbolic link.
    OSError
        The system does not let it.
    """
    root.mkdir(parents=True, exist_ok=True)
    held = os.open(root, _FOLDER)
    try:
        for name in folder.relative_to(root).parts:
            inner = _step(held, name, root)
            os.close(held)
            held = inner
        yield held
    finally:
        os.close(held)


def _step(folder: int, name: str, root: Path) -> int:
    with suppress(FileExistsError):
        os.mkdir(name, dir_fd=folder)
        os.fsync(folder)  # or a power failure could leave artifacts without the folder that they lie in
    try:
        return os.open(name, _FOLDER | os.O_NOFOLLOW, dir_fd=folder)
    except OSError as error:
        if error.errno in _LINK and is_link(folder, name):
            raise linked(root / name) from None
        raise


def is_link(folder: int, name: str) -> bool:
    """Whether a name in an open folder is a symbolic link."""
    try:
        return stat.S_ISLNK(os.stat(name, dir_fd=folder, follow_symlinks=False).st_mode)
    except FileNotFoundError:
        return False


def linked(path: Path) -> InputError:
    """That something is a link where there must be none."""
    return InputError(f"{path}: is a symbolic link; debist writes to no link, remove it and run again")


def new_file(folder: int, name: str) -> int:
    """A new file in an open folder; whatever had that name is removed, be it a link to a file of somebody else."""
    with suppress(FileNotFoundError):
        os.unlink(name, dir_fd=folder)
    return os.open(name, _NEW, 0o666, dir_fd=folder)


def remove_within(root: Path, ending: str) -> int:
    """Remove all files below `root` whose names start with a dot and end so; links are not followed.

    Raises
    ------
    InputError
        The system does not let it.
    """
    count = 0
    with reading(root):
        if not root.exists():
            return 0
        for _, _, files, folder in os.fwalk(root, onerror=_raise):
            for name in files:
                if name.startswith(".") and name.endswith(ending):
                    os.unlink(name, dir_fd=folder)
                    count += 1
    return count


def _raise(error: OSError) -> None:
    raise error
