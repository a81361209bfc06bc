"""How far a batch is: what its run folders show while its processes, here or elsewhere, go on."""

import os
import stat
from collections import Counter
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

from ..errors import DebistError, InputError
from ..store import layout
from ..store.atomic import reading
from ..store.lock import HOLDER, LOCK, is_held
from ..store.manifest import MANIFEST, load_manifest
from .failures import failed_names, failure

State = Literal["done", "running", "failed", "stopped"]
STATES: dict[State, str] = {
    "done": "has its scores",
    "running": "a process holds its run",
    "failed": "its process ended with a reason",
    "stopped": "begun, and no process holds it; the same command goes on",
}


@dataclass(frozen=True)
class Member:
    """One prototype of a batch: its state, why it failed, and when that was."""

    name: str
    state: State
    reason: str = ""
    since: datetime | None = None


@dataclass(frozen=True)
class FleetProgress:
    """How far a batch is; the members in the order of the names."""

    members: tuple[Member, ...]

    @property
    def counts(self) -> dict[str, int]:
        """Prototypes by state."""
        counted = Counter(member.state for member in self.members)
        return {state: counted[state] for state in STATES}


def is_fleet(folder: Path) -> bool:
    """Whether a folder is no run but holds runs, or failures of a batch."""
    if not folder.is_dir() or (folder / MANIFEST).exists():
        return False
    return bool(_runs(folder) or failed_names(folder))


def fleet_progress(output: Path) -> FleetProgress:
    """The state of each run in a folder; artifacts are neither read nor hashed.

    Raises
    ------
    InputError
        The folder cannot be read, or holds no runs.
    """
    names = sorted({*_runs(output), *failed_names(output)})
    if not names:
        raise InputError(f"{output}: holds no runs; name the DIR of `debist batch`")
    return FleetProgress(tuple(_member(output, name) for name in names))


def _runs(output: Path) -> list[str]:
    """Names of the run folders; links are none."""
    with reading(output):
        entries = [entry for entry in os.scandir(output) if entry.is_dir(follow_symlinks=False)]
    return [entry.name for entry in entries if any(map(_is_file, (Path(entry) / MANIFEST, Path(entry) / LOCK)))]


def _is_file(path: Path) -> bool:
    """Whether a regular file lies there, and no link, FIFO or folder."""
    try:
        return stat.S_ISREG(path.lstat().st_mode)
    except OSError:
        return False


def _member(output: Path, name: str) -> Member:
    run = output / name
    if _is_file(run / HOLDER) and is_held(run):  # the lock itself is tried only where a note names its holder
        return Member(name, "running", since=_time(run / HOLDER))
    if (failed := failure(output, name)) is not None:
        return Member(name, "failed", failed.reason, datetime.fromtimestamp(failed.time, UTC))
    if not _is_file(run / MANIFEST):
        return Member(name, "stopped")
    try:
        state: State = "done" if layout.SCORES in load_manifest(run).artifacts else "stopped"
    except DebistError as error:
        return Member(name, "failed", str(error))
    return Member(name, state, since=_time(run / MANIFEST))


def _time(path: Path) -> datetime | None:
    """When a file was written."""
    try:
        return datetime.fromtimestamp(path.stat().st_mtime, UTC)
    except OSError:
        return None
