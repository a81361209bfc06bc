"""One writer per run: a lock that the system releases when its holder dies."""

import errno
import json
import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import InputError, RunLockedError

LOCK = ".lock"
_HOLDER = ".lock-holder.json"
_NO_LOCKS = (errno.ENOSYS, errno.ENOLCK, errno.EOPNOTSUPP)


@contextmanager
def run_lock(root: Path) -> Iterator[None]:
    """Hold the run folder `root`, without waiting.

    The lock is the kernel's (`flock`), so a holder that was killed holds nothing; the note beside it only says who.

    Raises
    ------
    RunLockedError
        Another process holds it; the text says who and since when.
    InputError
        The folder cannot be written, or its file system offers no locks.
    """
    from filelock import FileLock, Timeout

    try:
        root.mkdir(parents=True, exist_ok=True)
        lock = FileLock(root / LOCK, fallback_to_soft=False)  # a lock that outlives its holder would be worse than none
        lock.acquire(timeout=0)
    except Timeout:
        raise RunLockedError(
            f"{root}: in use by {_holder(root)}; wait for it to finish or use another folder"
        ) from None
    except OSError as error:
        if error.errno in _NO_LOCKS:
            raise InputError(
                f"{root}: this file system offers no file locks ({error.strerror}), so two runs could mix; put the run "
                "on a local disk (network mounts need their lock service)"
            ) from error
        raise InputError(
            f"{root}: cannot be locked for writing: {error.strerror or error}; permit writing or use another folder"
        ) from error
    try:
        _leave_note(root)
        yield
    finally:
        with suppress(OSError):
            (root / _HOLDER).unlink(missing_ok=True)
        lock.release()


def _leave_note(root: Path) -> None:
    """Who holds the lock, for whoever comes second; a courtesy, without which the lock holds as well."""
    note = {
        "pid": os.getpid(),
        "host": socket.gethostname(),
        "since": datetime.now(UTC).isoformat(timespec="seconds"),
    }
    with suppress(OSError):
        (root / _HOLDER).write_text(json.dumps(note), encoding="utf-8")


def _holder(root: Path) -> str:
    try:
        note = json.loads((root / _HOLDER).read_text(encoding="utf-8"))
        return f"process {int(note['pid'])} on {note['host']} since {note['since']}"
    except (OSError, ValueError, KeyError, TypeError):
        return "another process"
