"""State of a batch: what its run folders show while its processes, here or elsewhere, go on, and why runs failed.

For a prototype that failed there is a text file with what its process printed, until it does well.
"""

import os
import re
import stat
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal, NamedTuple

from ..errors import DebistError, InputError
from ..store import layout
from ..store.atomic import HOLDER, LOCK, is_held, reading, write_text
from ..store.manifest import MANIFEST, load_manifest
from ..system.plain_files import read_plain
from .members import FAILED

_HEAD = re.compile(r"exit code (-?\d{1,10}): ([^\n]*)")
State = Literal["done", "running", "failed", "stopped"]
STATES: dict[State, str] = {
    "done": "has its scores",
    "running": "a process holds its run",
    "failed": "its process ended with a reason",
    "stopped": "begun, and no process holds it; the same command goes on",
}


@dataclass(frozen=True)
class MemberState:
    """One prototype of a batch: its state, why it failed, and when that was."""

    name: str
    state: State
    reason: str = ""
    since: datetime | None = None


def is_fleet(folder: Path) -> bool:
    """True if a folder is no run but holds runs, or failures of a batch."""
    return folder.is_dir() and not (folder / MANIFEST).exists() and bool(_runs(folder) or failed_names(folder))


def fleet_progress(output: Path) -> list[MemberState]:
    """The state of each run in a folder; artifacts are neither read nor hashed.

    Raises
    ------
    InputError
        The folder cannot be read, or holds no runs.
    """
    if not (names := sorted({*_runs(output), *failed_names(output)})):
        raise InputError(f"{output}: holds no runs; name the DIR of `debist batch`")
    return [_member(output, name) for name in names]


def _runs(output: Path) -> list[str]:
    """Names of the run folders; links are none."""
    with reading(output):
        entries = [entry for entry in os.scandir(output) if entry.is_dir(follow_symlinks=False)]
    return [entry.name for entry in entries if any(map(_is_file, (Path(entry) / MANIFEST, Path(entry) / LOCK)))]


def _is_file(path: Path) -> bool:
    """True if the path is a regular file, and no link, FIFO or folder."""
    try:
        return stat.S_ISREG(path.lstat().st_mode)
    except OSError:
        return False


def _member(output: Path, name: str) -> MemberState:
    run = output / name
    if _is_file(run / HOLDER) and is_held(run):  # the lock itself is tried only where a note names its holder
        return MemberState(name, "running", since=_time(run / HOLDER))
    if (failed := failure(output, name)) is not None:
        return MemberState(name, "failed", failed.reason, failed.time)
    if not _is_file(run / MANIFEST):
        return MemberState(name, "stopped")
    try:
        state: State = "done" if layout.SCORES in load_manifest(run).artifacts else "stopped"
    except DebistError as error:
        return MemberState(name, "failed", str(error))
    return MemberState(name, state, since=_time(run / MANIFEST))


def _time(path: Path) -> datetime | None:
    """Time at which a file was written; None where it cannot be read."""
    try:
        return datetime.fromtimestamp(path.stat().st_mtime, UTC)
    except OSError:
        return None


class Failure(NamedTuple):
    """Failure of a prototype: exit code, reason in one line, and time."""

    exit_code: int
    reason: str
    time: datetime


def failure_file(output: Path, name: str) -> Path:
    """Path of the file with a prototype's failure."""
    return output / FAILED / f"{name}.txt"


def keep_failure(output: Path, name: str, exit_code: int, reason: str, printed: str) -> None:
    """Write down how a prototype failed, with what its process printed.

    Parameters
    ----------
    output : Path
        Folder of the batch.
    name : str
        Name of the prototype.
    exit_code : int
        Exit code of its process.
    reason : str
        Cause in one line.
    printed : str
        Standard error of the process.
    """
    text = f"exit code {exit_code}: {' '.join(reason.split())}\n\n{printed}"
    write_text(failure_file(output, name), text, within=output)


def forget_failure(output: Path, name: str) -> None:
    """Remove it: the prototype is run again, or is up to date."""
    with suppress(OSError):
        failure_file(output, name).unlink(missing_ok=True)


def failure(output: Path, name: str) -> Failure | None:
    """The last failure of a prototype.

    None where there is none, or where something was written into its run since.
    """
    path = failure_file(output, name)
    changed = _time(output / name / MANIFEST)
    time = _time(path)
    try:
        head = _HEAD.match(read_plain(path).decode("utf-8", "replace"))
    except OSError:
        return None
    if head is None or time is None or (changed is not None and changed > time):
        return None
    return Failure(int(head[1]), head[2], time)


def failed_names(output: Path) -> list[str]:
    """The prototypes whose failure is kept."""
    return sorted(path.stem for path in (output / FAILED).glob("*.txt"))
