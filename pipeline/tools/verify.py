"""Verify, repair: everything in a run, or in all runs of a folder, against what was written."""

from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import CorruptArtifactError, DebistError, InputError
from pipeline.runs.atomic import move
from pipeline.runs.engine import Observer, TaskStatus
from pipeline.runs.lock import run_lock
from pipeline.runs.manifest import MANIFEST, load_manifest
from pipeline.runs.outputs import written_files
from pipeline.runs.run_folder import CORRUPT_MARK, in_snapshot
from pipeline.runs.verification import Chosen, Verified, every, file_problems, verified
from pipeline.stages.run import rebuild_run, run_prototype

_DEEPEST = 3


@dataclass(frozen=True)
class VerifiedRun:
    """One run of a folder: the result of its check, or why it could not be checked."""

    root: Path
    result: Verified
    failure: str = ""

    @property
    def intact(self) -> bool:
        """Nothing is wrong with it."""
        return not self.failure and self.result.intact


def verify_everything(root: Path, chosen: Chosen = every) -> Verified:
    """Check the files of a run, in one state of it though another process may go on writing.

    Raises
    ------
    InputError
        No run there.
    CorruptArtifactError
        Its manifest is damaged.
    """
    return in_snapshot(root, lambda run: verified(run, chosen))


def verify_all(folder: Path, chosen: Chosen = every) -> list[VerifiedRun]:
    """Check every run in a folder, and the tables of a fleet there.

    Raises
    ------
    InputError
        No run there.
    """
    roots = sorted({path.parent for depth in range(_DEEPEST + 1) for path in folder.glob("*/" * depth + MANIFEST)})
    if not roots:
        raise InputError(f"{folder}: holds no runs")
    tables = _fleet_tables(folder)
    return [*(_verified_run(root, chosen) for root in roots), *([tables] if tables is not None else [])]


def _verified_run(root: Path, chosen: Chosen) -> VerifiedRun:
    try:
        return VerifiedRun(root, verify_everything(root, chosen))
    except DebistError as error:
        return VerifiedRun(root, Verified(0), str(error))


def _fleet_tables(folder: Path) -> VerifiedRun | None:
    listed = [name for name, entry in written_files(folder).items() if entry.get("command") == "batch"]
    problems = [
        {"artifact": name, "stage": "batch", "problem": f"{problem}; `debist batch --collect` writes it anew"}
        for name, command, problem in file_problems(folder)
        if command == "batch"
    ]
    return VerifiedRun(folder, Verified(len(listed), problems)) if listed else None


def repair_run(root: Path, observer: Observer, prototype_file: Path | None = None) -> tuple[list[TaskStatus], Verified]:
    """Set aside what is damaged and make it anew, by the settings that the run holds.

    A run whose manifest is damaged is set aside as a whole and made anew from its settings file.

    Returns
    -------
    list of TaskStatus
        What was done and what was not.
    Verified
        How the run is now.

    Raises
    ------
    InputError
        No run there; the manifest is damaged and no settings file is given.
    """
    try:
        load_manifest(root)
    except CorruptArtifactError as error:
        if prototype_file is None:
            raise InputError(f"{error}; or give its settings file: `debist repair {root} PROTOTYPE.toml`") from error
        stamp = datetime.now(UTC).strftime("%Y%m%dT%H%M%S%f")
        with run_lock(root):
            pass  # nobody writes; Windows moves no folder with an open file such as the lock
        move(root, root.with_name(f"{root.name}{CORRUPT_MARK}{stamp}"), within=root.parent)
        done = run_prototype(prototype_file, root, observer)
    else:
        done = rebuild_run(root, observer)
    return done, verify_everything(root)
