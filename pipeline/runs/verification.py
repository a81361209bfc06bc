"""Everything in a run folder against what was written: artifacts, stage manifests, exports; the rest is named."""

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from pipeline.errors import InputError
from pipeline.runs.atomic import TEMPORARY_MARK
from pipeline.runs.checkpoints import FOLDER as CHECKPOINTS
from pipeline.runs.hashing import file_sha256
from pipeline.runs.lock import HOLDER, LOCK
from pipeline.runs.manifest import MANIFEST, NEXT_MANIFEST, STAGED_MARK
from pipeline.runs.outputs import EXTRA_FOLDERS, WRITTEN, written_files
from pipeline.runs.run_folder import CORRUPT_MARK, RunFolder
from pipeline.runs.signature import SIGNATURE
from pipeline.runs.stage_manifest import FOLDER as STAGES
from pipeline.runs.stage_manifest import said_content

_OWN = frozenset({MANIFEST, NEXT_MANIFEST, LOCK, HOLDER, SIGNATURE})


@dataclass(frozen=True)
class Verified:
    """What a look at everything in a run folder found.

    Attributes
    ----------
    checked : int
        Number of artifacts.
    problems : list of dict
        ``artifact``, ``stage``, ``problem`` for each file that is not as it was written.
    unknown : list of str
        Files that debist did not write there, by their paths in the folder; links among them.
    """

    checked: int
    problems: list[dict[str, str]] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)


def verified(run: RunFolder) -> Verified:
    """Check every file of a run.

    Raises
    ------
    SupersededError
        Another process went on writing into it.
    """
    problems = [
        {"artifact": name, "stage": stage, "problem": problem}
        for name, stage, problem in (*_artifacts(run), *_stage_manifests(run), *_extra_files(run.root))
    ]
    return Verified(len(run.manifest.artifacts), problems, sorted(_unknown(run)))


def _artifacts(run: RunFolder) -> Iterator[tuple[str, str, str]]:
    for name, record in sorted(run.manifest.artifacts.items()):
        try:
            problem = run.problem(name)
        except InputError as error:  # the disk refuses to read it; the others shall be checked nevertheless
            problem = str(error)
        if problem:
            yield name, record.recipe.stage, problem


def _stage_manifests(run: RunFolder) -> Iterator[tuple[str, str, str]]:
    """Workflow engines trust them."""
    for path in sorted((run.root / STAGES).glob("*.json")):
        said = said_content(path)
        known = {
            name: run.manifest.artifacts[name].content_hash for name in said or () if name in run.manifest.artifacts
        }
        if said is None or said != known:
            yield f"{STAGES}/{path.name}", path.stem, "does not say what the manifest says; `debist run` writes it anew"


def _extra_files(root: Path) -> Iterator[tuple[str, str, str]]:
    for folder in EXTRA_FOLDERS:
        for name, entry in sorted(written_files(root / folder).items()):
            path = root / folder / name
            try:
                if path.is_file() and file_sha256(path) != entry.get("sha256"):
                    yield (
                        f"{folder}/{name}",
                        entry.get("command", folder),
                        "was changed after it was written; write it anew",
                    )
            except OSError as error:
                yield f"{folder}/{name}", folder, f"cannot be read: {error.strerror}"


def _unknown(run: RunFolder) -> Iterator[str]:
    artifacts = run.manifest.artifacts
    extra = {f"{folder}/{name}" for folder in EXTRA_FOLDERS for name in (WRITTEN, *written_files(run.root / folder))}
    for place, folders, files in os.walk(run.root):
        links = [name for name in folders if (Path(place) / name).is_symlink()]
        for name in (*files, *links):
            path = (Path(place) / name).relative_to(run.root).as_posix()
            of_a_kill = name.startswith(".") and name.endswith((TEMPORARY_MARK, STAGED_MARK))
            of_a_stage = path.startswith(f"{STAGES}/") and path.endswith(".json")
            set_aside = path.partition(CORRUPT_MARK)[0] in artifacts
            finished = path.startswith(f"{CHECKPOINTS}/")
            known = (
                finished or path in artifacts or path in _OWN or path in extra or of_a_kill or of_a_stage or set_aside
            )
            if not known or (Path(place) / name).is_symlink():
                yield path
