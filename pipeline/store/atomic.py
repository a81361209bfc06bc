"""Files of a run: one writer at a time, written whole or not at all, and through no link.

A file is written beside its place, synced, and moved there in one step. A run folder may come from anybody, so nothing
between it and a file that is written may be a link. What the system refuses is one line with the path.
"""

import errno
import json
import os
import shutil
import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

from filelock import FileLock, Timeout

from ..errors import InputError, RunLockedError
from ..system.plain_files import read_plain

TEMPORARY_MARK = ".debist-tmp"
_PAUSES = (0.05, 0.1, 0.2, 0.4)
"""Seconds between tries to move a file; Windows refuses while another program, such as a virus scanner, has it open."""
_LONGEST_PATH = 259
_ADDED = 40
"""Characters of a path on Windows, and those that a temporary name adds."""
_NO_FOLDER_SYNC = (errno.EINVAL, errno.ENOTSUP, errno.EBADF)
LOCK = ".lock"
_NOTE = "-holder.json"
HOLDER = LOCK + _NOTE
_NO_LOCKS = (errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP)  # of file systems without locks
_LONGEST_HOST = 100  # characters of a holder's note that messages repeat


@contextmanager
def reading(path: Path) -> Iterator[None]:
    """Context in which `path` and its contents are read or looked up.

    Raises
    ------
    InputError
        The system does not let it.
    """
    try:
        yield
    except OSError as error:
        named = error.filename
        place = named if isinstance(named, str) and Path(named).is_relative_to(path) else path
        raise InputError(
            f"{place}: cannot be read: {error.strerror or error}; see to disk and permission or move it away, run again"
        ) from error


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Context in which `path` or its contents are written.

    Raises
    ------
    InputError
        The system does not let it.
    """
    try:
        yield
    except OSError as error:
        raise not_written(path, error) from error


def refuse_link(path: Path, *, within: Path | None = None) -> None:
    """Refuse to write through a link.

    Parameters
    ----------
    path : Path
        Path to be written.
    within : Path, optional
        A folder above it; no step from there on may be a link. Only `path` itself if left out.

    Raises
    ------
    InputError
        There is one, or that cannot be looked up.
    """
    steps = [path, *path.parents][: len(path.relative_to(within).parts) if within else 1]
    is_junction = getattr(os.path, "isjunction", lambda _: False)  # Windows, Python 3.12
    with reading(path):
        for step in reversed(steps):
            if step.is_symlink() or is_junction(step):
                raise InputError(f"{step}: is a symbolic link; debist writes to no link, remove it and run again")


def not_written(path: Path, error: OSError) -> InputError:
    """Error of a file that could not be written, with the reason."""
    if isinstance(error, FileExistsError | NotADirectoryError):
        return InputError(f"{path}: cannot be written: a file is in the way of a folder; name another place")
    if isinstance(error, FileNotFoundError) and not error.filename:  # that of the current folder is looked for
        return InputError("the current folder was deleted; change into another one")
    length = len(str(path.absolute())) + _ADDED
    if error.errno == errno.ENAMETOOLONG or (isinstance(error, FileNotFoundError) and length > _LONGEST_PATH):
        return InputError(f"{path}: cannot be written: the path is too long for this system; use a shorter folder")
    remedy = "close the program that has it open, or" if isinstance(error, PermissionError) else "free space or"
    return InputError(f"{path}: cannot be written: {error.strerror or error}; {remedy} permit writing, run again")


@contextmanager
def atomic_path(target: Path, *, within: Path | None = None) -> Iterator[Path]:
    """A temporary path to write to; moved onto `target` when the block ends well, removed when it does not.

    Parameters
    ----------
    target : Path
        The file; missing folders on the way are made.
    within : Path, optional
        The folder from which on nothing may be a link, and whose content may come from anybody.

    Raises
    ------
    InputError
        The disk is full, the folder is read-only, `target` is a folder, or it or a folder between `within` and it is a
        link.
    """
    refuse_link(target, within=within)
    if target.is_dir():
        raise InputError(f"{target}: cannot be written: it is a folder; name a file, or move the folder away")
    temporary = target.with_name(f".{target.name}.{os.getpid()}{TEMPORARY_MARK}")
    with writing(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary.unlink(missing_ok=True)  # it may be a link to a file of somebody else
        try:
            yield temporary
            with temporary.open("r+b") as stream:
                os.fsync(stream.fileno())
            replace(temporary, target)
        finally:
            with suppress(OSError):  # a folder that became read-only keeps its leftover; `sweep` removes it later
                temporary.unlink(missing_ok=True)
        _sync(target.parent)


def write_text(target: Path, text: str, *, within: Path | None = None) -> None:
    """Write a text file atomically, UTF-8, line feeds; `within` as for `atomic_path`."""
    write_bytes(target, text.encode(), within=within)


def write_bytes(target: Path, content: bytes, *, within: Path | None = None) -> None:
    """Write a binary file atomically; `within` as for `atomic_path`."""
    with atomic_path(target, within=within) as temporary:
        temporary.write_bytes(content)


def replace(source: Path, target: Path) -> None:
    """Move a file onto `target` in one step, waiting a little for a program that has it open; OSError as `os.replace`.

    Paths of one file system; `target` may be there or not.
    """
    for pause in _PAUSES:
        try:
            source.replace(target)
            return
        except PermissionError:
            time.sleep(pause)
    source.replace(target)


def move(source: Path, target: Path, *, within: Path) -> None:
    """Move a file of a run onto `target` in the same folder, in one step, and wait until the disk has it.

    Raises
    ------
    InputError
        The file system does not let it, or a folder between `within` and it is a link.
    """
    refuse_link(source.parent, within=within)
    with writing(target):
        replace(source, target)
        _sync(target.parent)


def _sync(folder: Path) -> None:
    """Wait until the names in a folder are on the disk; Windows has no such call."""
    if os.name == "nt":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in _NO_FOLDER_SYNC:
            raise
    finally:
        os.close(descriptor)


def sweep(folder: Path, mark: str = TEMPORARY_MARK) -> None:
    """Remove what a killed process left behind: what lies below `folder`, starts with a dot and ends with `mark`.

    Raises
    ------
    InputError
        The system does not let it.
    """
    with reading(folder):
        for place, folders, files in os.walk(folder):  # links to folders are not followed
            for name in (*folders, *files):
                if name.startswith(".") and name.endswith(mark):
                    path = Path(place) / name
                    shutil.rmtree(path) if name in folders and not path.is_symlink() else path.unlink()


@contextmanager
def run_lock(root: Path, name: str = LOCK) -> Iterator[None]:
    """Hold the run folder `root` by its lock `name`, without waiting; missing folders are made.

    A holder that was killed holds nothing; the note beside the lock only names it.

    Raises
    ------
    RunLockedError
        Another process holds it; the text names it and the time.
    InputError
        The folder cannot be written, its file system offers no locks, or the lock is a symbolic link.
    """
    refuse_link(root / name)
    lock = FileLock(root / name, timeout=0, fallback_to_soft=False)
    note = root / (name + _NOTE)
    try:
        root.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except Timeout:
        raise RunLockedError(
            f"{root}: in use by {_holder(note)}; wait for it to finish or use another folder"
        ) from None
    except OSError as error:
        raise _not_locked(root, error) from error
    try:
        with suppress(InputError):  # for the message to a second process; the lock works without it
            since = datetime.now(UTC).isoformat(timespec="seconds")
            write_text(
                note, json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since}), within=root
            )
        yield
    finally:
        with suppress(OSError):
            note.unlink(missing_ok=True)
        with suppress(OSError):
            lock.release()


def is_held(root: Path) -> bool:
    """True if a process is writing into a run."""
    if not (root / LOCK).is_file() or (root / LOCK).is_symlink():
        return False
    try:
        with FileLock(root / LOCK, timeout=0, fallback_to_soft=False):
            return False
    except Timeout:
        return True
    except OSError:  # a disk that cannot be written has no writer
        return False


def _not_locked(root: Path, error: OSError) -> InputError:
    if error.errno in _NO_LOCKS:
        return InputError(
            f"{root}: this file system offers no file locks ({error.strerror}), so two runs could mix; put the run "
            "on a local disk (network mounts need their lock service)"
        )
    return InputError(
        f"{root}: cannot be locked for writing: {error.strerror or error}; permit writing or use another folder"
    )


def _holder(path: Path) -> str:
    try:
        note = json.loads(read_plain(path))
        host, since = (str(note[key])[:_LONGEST_HOST] for key in ("host", "since"))
        return f"process {int(note['pid'])} on {host} since {since}"
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return "another process"
