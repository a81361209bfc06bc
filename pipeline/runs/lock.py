"""One writer per run: a lock that the system releases when its holder dies.

The lock is the kernel's (`flock`), on the run folder itself: nobody can delete it, and a copy of the folder has another
one. Not every file system locks folders (NFS does not), so a file in it is locked as well.
"""

import errno
import fcntl
import json
import os
import socket
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import InputError, RunLockedError
from pipeline.plain_files import read_plain
from pipeline.runs.confined import folder_within, is_link, linked, new_file

LOCK = ".lock"
HOLDER = ".lock-holder.json"
_NO_LOCKS = (errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP)
_LOCK_FILE = os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
_LONGEST_NOTE, _LONGEST_HOST = 4096, 100
_TRIES = 5


class _BusyError(Exception):
    """Another process holds the lock."""


@dataclass(frozen=True)
class _Held:
    """A lock of this process: descriptors of the folder and of the file in it, and whether the folder is locked."""

    folder: int
    file: int
    folder_locked: bool


_held: dict[Path, _Held] = {}


@contextmanager
def run_lock(root: Path) -> Iterator[None]:
    """Hold the run folder `root`, without waiting.

    A holder that was killed holds nothing; the note beside the lock only says who.

    Raises
    ------
    RunLockedError
        Another process holds it; the text says who and since when.
    InputError
        The folder cannot be written, its file system offers no locks, or the lock is a symbolic link.
    """
    held = _acquired(root)
    try:
        _leave_note(held.folder)
        _held[root] = held
        yield
    finally:
        _held.pop(root, None)
        with suppress(OSError):
            os.unlink(HOLDER, dir_fd=held.folder)
        for descriptor in (held.file, held.folder):
            with suppress(OSError):
                fcntl.flock(descriptor, fcntl.LOCK_UN)  # also for what was forked and still has it open
            os.close(descriptor)


def check_held(root: Path) -> None:
    """Make sure that a lock which this process took on `root` still keeps others out.

    Raises
    ------
    RunLockedError
        The folder was moved or replaced, or its lock was removed where only that kept others out.
    InputError
        The folder cannot be looked at.
    """
    held = _held.get(root)
    if held is None:
        return
    try:
        same = os.path.samestat(root.stat(), os.fstat(held.folder))
    except (FileNotFoundError, NotADirectoryError):
        same = False
    except OSError as error:
        raise InputError(f"{root}: cannot be looked at: {error.strerror}; see to the disk or the permission") from error
    if not same:
        raise RunLockedError(f"{root}: was moved or replaced while it was worked on; run again")
    if not held.folder_locked and not _is_in_place(held.folder, held.file):
        raise RunLockedError(f"{root}: its {LOCK} was removed while it was worked on; run again")


def _acquired(root: Path) -> _Held:
    try:
        with folder_within(root, root) as reached:
            folder = os.dup(reached)
    except OSError as error:
        raise _not_locked(root, error) from error
    try:
        return _locked(root, folder)
    except BaseException as error:
        os.close(folder)
        if isinstance(error, _BusyError):
            holder = _holder(root)
            raise RunLockedError(f"{root}: in use by {holder}; wait for it to finish or use another folder") from None
        if isinstance(error, OSError):
            raise _not_locked(root, error) from error
        raise


def _locked(root: Path, folder: int) -> _Held:
    try:
        _flock(folder)
        folder_locked = True
    except OSError as error:
        if error.errno in _NO_LOCKS:
            raise
        folder_locked = False  # NFS locks no folders: its locks need a descriptor that can be written
    for _ in range(_TRIES):
        file = _open_lock(root, folder)
        try:
            if folder_locked and os.fstat(file).st_nlink > 1:  # a copy by hard links: the lock of another run
                own = new_file(folder, LOCK)
                os.close(file)
                file = own
            _flock(file)
            if _is_in_place(folder, file):
                return _Held(folder, file, folder_locked)
        except BaseException:
            os.close(file)
            raise
        os.close(file)
    raise _BusyError


def _open_lock(root: Path, folder: int) -> int:
    try:
        file = os.open(LOCK, _LOCK_FILE | os.O_CREAT, 0o666, dir_fd=folder)
    except OSError:
        if is_link(folder, LOCK):
            raise linked(root / LOCK) from None
        raise
    if not stat.S_ISREG(os.fstat(file).st_mode):
        os.close(file)
        raise OSError(errno.EINVAL, f"{LOCK} is no regular file")
    return file


def _flock(descriptor: int) -> None:
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise _BusyError from None


def _is_in_place(folder: int, file: int) -> bool:
    """Whether the name still leads to the file that is open: it may have been deleted between opening and locking."""
    try:
        return os.path.samestat(os.stat(LOCK, dir_fd=folder, follow_symlinks=False), os.fstat(file))
    except FileNotFoundError:
        return False


def _not_locked(root: Path, error: OSError) -> InputError:
    if error.errno in _NO_LOCKS:
        return InputError(
            f"{root}: this file system offers no file locks ({error.strerror}), so two runs could mix; put the run "
            "on a local disk (network mounts need their lock service)"
        )
    if error.errno in (errno.EEXIST, errno.ENOTDIR):
        return InputError(f"{root}: is no folder, and a run is one; choose another with -o")
    return InputError(
        f"{root}: cannot be locked for writing: {error.strerror or error}; permit writing or use another folder"
    )


def _leave_note(folder: int) -> None:
    """Who holds the lock, for whoever comes second; a courtesy, without which the lock holds as well."""
    note = {
        "pid": os.getpid(),
        "host": socket.gethostname(),
        "since": datetime.now(UTC).isoformat(timespec="seconds"),
    }
    with suppress(OSError), os.fdopen(new_file(folder, HOLDER), "w", encoding="utf-8") as stream:
        json.dump(note, stream)


def _holder(root: Path) -> str:
    try:
        note = json.loads(read_plain(root / HOLDER, _LONGEST_NOTE))
        host, since = (str(note[key])[:_LONGEST_HOST] for key in ("host", "since"))
        return f"process {int(note['pid'])} on {host} since {since}"
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return "another process"
