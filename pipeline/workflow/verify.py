"""Verify: everything in a run against what was written."""

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import InputError, SupersededError
from ..store.atomic import HOLDER, LOCK, TEMPORARY_MARK, is_held
from ..store.hashing import file_sha256
from ..store.manifest import MANIFEST, NEXT_MANIFEST, STAGED_MARK, STAGES, load_manifest, stage_file
from ..store.outputs import EXTRA_FOLDERS, WRITTEN, written_files
from ..store.run_folder import RunFolder, in_snapshot


@dataclass(frozen=True)
class Verified:
    """Result of the check of a whole run folder.

    Attributes
    ----------
    checked : int
        Number of artifacts.
    problems : list of dict
        ``artifact``, ``stage``, ``problem`` for each file that is not as it was written.
    unknown : list of str
        Files and links that do not belong to the run, by their paths in the folder.
    leftover : list of str
        Files that an interrupted run leaves, by their paths in the folder.
    """

    checked: int
    problems: list[dict[str, str]] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)
    leftover: list[str] = field(default_factory=list)

    @property
    def intact(self) -> bool:
        """True if every file is as it was written, and there are no others."""
        return not (self.problems or self.unknown or self.leftover)


def verified(run: RunFolder) -> Verified:
    """Check the files of a run: all of them belong there and have the bytes that were written.

    Raises
    ------
    SupersededError
        Another process went on writing into it.
    """
    names = sorted(run.manifest.artifacts)
    problems = [
        {"artifact": name, "stage": stage, "problem": problem}
        for name, stage, problem in (*_artifacts(run, names), *_stage_manifests(run), *_written_files(run.root))
    ]
    others = sorted(_others(run))
    leftover = [path for path in others if _is_leftover(path)]
    if leftover and is_held(run.root):
        leftover = []  # they are of the process that writes now
    unknown = [path for path in others if not _is_leftover(path)]
    if unknown and load_manifest(run.root) != run.manifest:
        raise SupersededError(f"{run.root}: another run writes into it; do it again")
    if (run.root / NEXT_MANIFEST).exists():  # a commit that is not complete has stage manifests to remove
        unknown = [path for path in unknown if not path.startswith(f"{STAGES}/")]
    unknown, leftover = ([path for path in some if os.path.lexists(run.root / path)] for some in (unknown, leftover))
    return Verified(len(names), problems, unknown, leftover)


def _artifacts(run: RunFolder, names: Iterable[str]) -> Iterator[tuple[str, str, str]]:
    """Name, stage and problem of each artifact that is not as written."""
    for name in names:
        try:
            problem = run.problem(name)
        except InputError as error:  # the disk refuses to read it; the others shall be checked nevertheless
            problem = str(error)
        if problem:
            yield name, run.manifest.artifacts[name].recipe.stage, problem


def _stage_manifests(run: RunFolder) -> Iterator[tuple[str, str, str]]:
    """File, stage and problem of each stage manifest that is not as written; workflow engines trust these."""
    for stage in sorted(run.manifest.stages):
        if problem := run.stage_problem(stage):
            yield stage_file(stage), stage, f"{problem}; `debist run` writes it anew"


def _written_files(root: Path) -> Iterator[tuple[str, str, str]]:
    """File, command and what is wrong, for what was written beside the artifacts (`pipeline.store.outputs`)."""
    for folder in EXTRA_FOLDERS:
        for name, entry in sorted(written_files(root / folder).items()):
            try:
                same = file_sha256(root / folder / name) in (entry.get("sha256"), entry.get("replaces"))
                problem = "" if same else "does not have the bytes that were written"
            except FileNotFoundError:
                problem = "is missing"
            except OSError as error:
                problem = f"cannot be read: {error.strerror}"
            if problem:
                yield f"{folder}/{name}", str(entry.get("command", folder)), f"{problem}; write it anew"


def _others(run: RunFolder) -> Iterator[str]:
    """Files that nothing in the run's lists names, and all links."""
    lists = {f"{folder}/{name}" for folder in EXTRA_FOLDERS for name in (WRITTEN, *written_files(run.root / folder))}
    stages = map(stage_file, run.manifest.stages)
    own = {MANIFEST, NEXT_MANIFEST, LOCK, *lists, *stages, *run.manifest.artifacts, *run.manifest.set_aside}
    for place, folders, files in os.walk(run.root):
        for name in (*files, *folders):
            entry = Path(place) / name
            path = entry.relative_to(run.root).as_posix()
            if entry.is_symlink() or (name in files and path not in own):
                yield path


def _is_leftover(path: str) -> bool:
    marks = (TEMPORARY_MARK, STAGED_MARK)
    return path == HOLDER or any(name.startswith(".") and name.endswith(marks) for name in path.split("/"))


def verify_everything(root: Path) -> Verified:
    """Check the files of a run, in one state of it though another process may go on writing.

    Raises
    ------
    InputError
        No run there.
    CorruptArtifactError
        Its manifest is damaged.
    """
    return in_snapshot(root, verified)
