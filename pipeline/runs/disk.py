"""What a failing disk says: one line with the path, and never that a file is damaged which could only not be read."""

from collections.abc import Iterator
from contextlib import contextmanager
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
        place = error.filename if isinstance(error.filename, str) else path
        raise _not_read(place, error.strerror or str(error)) from error


def refuse_link(path: Path) -> None:
    """Refuse to write through a symbolic link.

    Raises
    ------
    InputError
        `path` is one, or that cannot be found out.
    """
    with reading(path):
        linked = path.is_symlink()
    if linked:
        raise InputError(f"{path}: is a symbolic link; debist writes to no link, remove it and run again")


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
    return InputError(f"{path}: cannot be written: {error.strerror or error}; free space or permit writing, run again")


def _not_read(path: str | Path, reason: str) -> InputError:
    return InputError(f"{path}: cannot be read: {reason}; see to disk and permission or move it away, run again")
