"""Verify, repair, sign: everything in a run, or in all runs of a folder, against what was written."""

from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import CorruptArtifactError, DebistError, InputError
from pipeline.runs.atomic import move_folder
from pipeline.runs.engine import Observer, TaskStatus
from pipeline.runs.hashing import file_sha256
from pipeline.runs.lock import run_lock
from pipeline.runs.manifest import MANIFEST, load_manifest
from pipeline.runs.outputs import written_files
from pipeline.runs.run_folder import CORRUPT_MARK, RunFolder, in_snapshot
from pipeline.runs.verification import Verified, check_signature, load_key, sign, verified
from pipeline.stages.run import rebuild_run, run_prototype

_DEEPEST = 3


@dataclass(frozen=True)
class VerifiedRun:
    """One run of a folder: what a look at it found, or why that could not be told."""

    root: Path
    found: Verified
    failure: str = ""

    @property
    def intact(self) -> bool:
        """Nothing is wrong with it."""
        return not self.failure and not self.found.problems


def verify_everything(root: Path, key: Path | None = None) -> tuple[Verified, str]:
    """Check every file of a run, in one state of it though another process may go on writing.

    Returns
    -------
    Verified
    str
        When it was signed, if a file with a key is given.

    Raises
    ------
    InputError
        No run there, or no key.
    CorruptArtifactError
        Its manifest is damaged, or the run is not in the state that was signed.
    """
    secret = None if key is None else load_key(key)
    return in_snapshot(root, lambda run: (verified(run), "" if secret is None else check_signature(run, secret)))


def verify_all(folder: Path) -> list[VerifiedRun]:
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
    return [*(_verified_run(root) for root in roots), *([tables] if tables is not None else [])]


def _verified_run(root: Path) -> VerifiedRun:
    try:
        return VerifiedRun(root, verify_everything(root)[0])
    except DebistError as error:
        return VerifiedRun(root, Verified(0), str(error))


def _fleet_tables(folder: Path) -> VerifiedRun | None:
    listed = {name: entry for name, entry in written_files(folder).items() if entry.get("command") == "batch"}
    problems = []
    for name, entry in sorted(listed.items()):
        try:
            same = file_sha256(folder / name) == entry.get("sha256")
            problem = (
                "" if same else "does not have the bytes that were written; `debist batch --collect` writes it anew"
            )
        except OSError as error:
            problem = f"cannot be read: {error.strerror}; `debist batch --collect` writes it anew"
        if problem:
            problems.append({"artifact": name, "stage": "batch", "problem": problem})
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
            move_folder(root, root.with_name(f"{root.name}{CORRUPT_MARK}{stamp}"))
        done = run_prototype(prototype_file, root, observer)
    else:
        done = rebuild_run(root, observer)
    return done, verify_everything(root)[0]


def sign_run(root: Path, key: Path) -> Path:
    """Sign a run that is intact; returns the signature's file.

    Raises
    ------
    CorruptArtifactError
        Something in it is not as it was written.
    """
    secret = load_key(key)
    load_manifest(root)  # a folder without a run is refused before a lock is laid into it
    with run_lock(root):
        run = RunFolder.open(root)
        problems = verified(run).problems
        if problems:
            first = problems[0]
            raise CorruptArtifactError(
                f"{root}: {first['artifact']} {first['problem']}; `debist repair {root}`, then sign"
            )
        return sign(run, secret)
