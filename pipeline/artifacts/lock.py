"""One writer per run: a lock that the system releases when its holder dies."""

import json
import os
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import InputError, RunLockedError

LOCK = ".lock"
_HOLDER = ".lock-holder.json"


@contextmanager
def run_lock(root: Path) -> Iterator[None]:
    """Hold the run folder `root`, without waiting.

    The lock is the kernel's (`flock`), so a holder that was killed holds nothing; the note beside it only says who.

    Raises
    ------
    RunLockedError
        Another process holds it; the text says who and since when.
    """
    from filelock import FileLock, Timeout

    try:
        root.mkdir(parents=True, exist_ok=True)
        lock = FileLock(root / LOCK)
        lock.acquire(timeout=0)
    except Timeout:
        raise RunLockedError(
            f"{root}: in use by {_holder(root)}; wait for it to finish or use another folder"
        ) from None
    except (OSError, NotImplementedError) as error:
        raise InputError(f"{root}: cannot be locked for writing: {error}") from error
    try:
        note = {
            "pid": os.getpid(),
            "host": socket.gethostname(),
            "since": datetime.now(UTC).isoformat(timespec="seconds"),
        }
        (root / _HOLDER).write_text(json.dumps(note), encoding="utf-8")
        yield
    finally:
        (root / _HOLDER).unlink(missing_ok=True)
        lock.release()


def _holder(root: Path) -> str:
    try:
        note = json.loads((root / _HOLDER).read_text(encoding="utf-8"))
        return f"process {int(note['pid'])} on {note['host']} since {note['since']}"
    except (OSError, ValueError, KeyError, TypeError):
        return "another process"
