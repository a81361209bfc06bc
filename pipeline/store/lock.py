"""One writer per run: a lock file that the system releases when its holder dies (`filelock`)."""

import errno
import json
import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

from filelock import FileLock, Timeout

from ..errors import InputError, RunLockedError
from ..system.plain_files import read_plain
from .atomic import refuse_link, write_text

LOCK = ".lock"
_NOTE = "-holder.json"
HOLDER = LOCK + _NOTE
_NO_LOCKS = (errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP)
_LONGEST_NOTE = 4096
_LONGEST_HOST = 100


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
        _leave_note(note)
        yield
    finally:
        with suppress(OSError):
            note.unlink(missing_ok=True)
        with suppress(OSError):
            lock.release()


def is_held(root: Path) -> bool:
    """Whether a process is writing into a run."""
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
    if isinstance(error, FileExistsError | NotADirectoryError):
        return InputError(f"{root}: is no folder, and a run is one; choose another with -o")
    return InputError(
        f"{root}: cannot be locked for writing: {error.strerror or error}; permit writing or use another folder"
    )


def _leave_note(path: Path) -> None:
    """The holder of the lock, for the message to a second process; the lock works without it."""
    note = {"pid": os.getpid(), "host": socket.gethostname(), "since": datetime.now(UTC).isoformat(timespec="seconds")}
    with suppress(InputError):
        write_text(path, json.dumps(note), within=path.parent)


def _holder(path: Path) -> str:
    try:
        note = json.loads(read_plain(path, _LONGEST_NOTE))
        host, since = (str(note[key])[:_LONGEST_HOST] for key in ("host", "since"))
        return f"process {int(note['pid'])} on {host} since {since}"
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return "another process"
