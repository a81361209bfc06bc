"""The manifest of a run: for every artifact its stage, settings, inputs and hashes; and how both change together.

For each stage there is a small file with the content hashes of what it made. A workflow engine passes these stage
manifests between its rules: they change exactly when the content changes. The manifest holds what stands in them.

A task writes each artifact under a staging name beside its place. The commit then (1) writes the new manifest beside
the old one, whole and synced; (2) moves the artifacts to their places; (3) moves the manifest to its own. A process
killed before (1) has changed nothing; after it, the new manifest counts, and an artifact that was not moved yet is
found under its staging name. So at every moment the folder holds the old state or the new one, and nothing between.
"""

import hashlib
import json
import math
import platform
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter, ValidationError

from ..errors import CorruptArtifactError, InputError
from ..settings.file import translated
from ..system.names import shell_word
from ..system.package import program_version
from ..system.plain_files import read_plain
from .atomic import move, reading, refuse_link, sweep, write_text, writing
from .hashing import file_sha256, flatten, json_sha256
from .schemas import ADVICE, Document, first_mistake

MANIFEST = "manifest.json"
NEXT_MANIFEST = ".manifest.next.json"
"""A manifest whose commit was interrupted: where it is there, it is the valid one."""
FORMAT: Literal["debist-run/1"] = "debist-run/1"
STAGES = "stages"
STAGED_MARK = ".debist-staged"
_LARGEST = 256 << 20
_INTACT: set[bytes] = set()
"""SHA-256 of manifests that this process checked; its digest costs three times as much as all else."""
_Digest = Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
_Stage = Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
_Path = Annotated[str, Field(pattern=r"^\.*[A-Za-z0-9_-][A-Za-z0-9._-]*(/\.*[A-Za-z0-9_-][A-Za-z0-9._-]*)*$")]
"""Inside the run on every system: slashes, no step up, no drive, no backslash."""
TIMES = "processor_time"
"""Notes under this key differ from run to run; they enter no artifact."""


_RECORDED = (
    "asammdf", "h5py", "llvmlite", "numba", "numpy", "pandas", "pint", "pyarrow", "pydantic", "pysindy",
    "scikit-learn", "scipy",
)  # fmt: skip


@cache
def recorded_versions() -> dict[str, str]:
    """Versions of debist, of Python with its platform, and of the packages that read data or can move a digit."""
    python = f"{platform.python_version()} on {platform.platform()}"
    return {"debist": program_version(), "python": python, **{package: version(package) for package in _RECORDED}}


@dataclass(frozen=True)
class Recipe:
    """Inputs that decide an artifact's content; its digest is the cache key.

    Attributes
    ----------
    stage : str
        Name of the stage.
    algorithm : str
        Version of the stage's algorithm, raised when equal inputs would give another result.
    settings : mapping
        The settings that the stage uses, JSON values only.
    inputs : mapping of str to str
        Content hash of every input by its name.
    """

    stage: str
    algorithm: str
    settings: Mapping[str, Any]
    inputs: Mapping[str, str]

    def differences(self, other: "Recipe") -> list[str]:
        """Reasons why `self`, wanted now, is not `other`, made before; one per change."""
        reasons = []
        if self.algorithm != other.algorithm:
            reasons.append(f"algorithm {other.algorithm} became {self.algorithm}")
        reasons += changes(self.settings, other.settings)
        for name in sorted(self.inputs.keys() | other.inputs.keys()):
            if self.inputs.get(name) != other.inputs.get(name):
                how = "is new" if name not in other.inputs else "changed" if name in self.inputs else "is gone"
                reasons.append(f"input {name} {how}")
        return reasons


@dataclass(frozen=True)
class ArtifactRecord:
    """One artifact as it was written.

    Attributes
    ----------
    recipe : Recipe
    sha256 : str
        Of the file's bytes.
    content_hash : str
        Of the content, independent of the file format's details.
    bytes : int
    notes : mapping
        Notes of the stage on the result: counts, convergence, chosen parameters.
    """

    recipe: Recipe
    sha256: _Digest
    content_hash: _Digest
    bytes: Annotated[int, Field(ge=0)]
    notes: Mapping[str, Any] = field(default_factory=dict)


@dataclass
class Manifest:
    """The whole manifest; `save` writes it atomically.

    Attributes
    ----------
    prototype : dict
        The settings.
    prototype_file : str
        Path of the file that they were read from.
    versions : dict of str to str
        Of debist, Python and the packages that can move a digit, when an artifact was written last.
    artifacts : dict of str to ArtifactRecord
        By path in the run, with slashes.
    stages : dict of str to dict
        Content of the stage manifests: content hash by artifact, by stage.
    set_aside : list of str
        Damaged files that were moved out of the way, by path in the run.
    """

    prototype: dict[str, Any]
    prototype_file: str
    versions: dict[str, str]
    artifacts: dict[_Path, ArtifactRecord]
    stages: dict[_Stage, dict[str, str]] = field(default_factory=dict)
    set_aside: list[str] = field(default_factory=list)
    format: Literal["debist-run/1"] = FORMAT

    def save(self, root: Path, name: str = MANIFEST) -> None:
        """Write the manifest into the run folder `root`."""
        # `asdict` would copy every note and setting, half of the time that this takes
        artifacts = {path: {**vars(record), "recipe": vars(record.recipe)} for path, record in self.artifacts.items()}
        document = {"format": self.format, **vars(self), "artifacts": artifacts}
        # in the order in which it was made, so that a run which was opened anew reads the same as one that goes on
        text = json.dumps({**document, "digest": json_sha256(document)}, indent=1, ensure_ascii=False) + "\n"
        write_text(root / name, text, within=root)


_SHAPE = TypeAdapter(Manifest)


def _read(root: Path) -> tuple[Path, bytes]:
    """The valid manifest and its text: the next one if a commit was cut short."""
    path = root / NEXT_MANIFEST
    try:
        try:
            raw = read_plain(path, _LARGEST)
        except FileNotFoundError:
            path = root / MANIFEST
            raw = read_plain(path, _LARGEST)
    except FileNotFoundError:
        within = sorted(place.parent for place in root.glob(f"*/{MANIFEST}"))
        hint = f"name one of those in it, such as {within[0]}" if within else ""
        hint = hint or f"`debist run PROTOTYPE.toml -o {shell_word(root)}` makes one"
        raise InputError(f"{root}: no run here (no {MANIFEST}); {hint}") from None
    except NotADirectoryError:
        raise InputError(f"{root}: is a file; name the folder of a run") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}; see to the disk or the permission") from error
    return path, raw


def load_manifest(root: Path) -> Manifest:
    """Read the manifest of a run folder.

    Raises
    ------
    InputError
        The folder holds no run.
    CorruptArtifactError
        The manifest is damaged or was edited.
    """
    path, raw = _read(root)
    try:
        manifest = _SHAPE.validate_json(raw, strict=True)
        digest = hashlib.sha256(raw).digest()
        intact = digest in _INTACT or (document := json.loads(raw)).pop("digest", None) == json_sha256(document)
    except ValidationError as error:
        mistake = first_mistake(error)
        if FORMAT.encode() not in raw[:64] and not mistake.startswith("damaged"):
            mistake = f"is no {FORMAT} manifest; {ADVICE}"
        raise CorruptArtifactError(f"{path}: {mistake}") from None
    except (ValueError, TypeError, RecursionError) as error:
        raise CorruptArtifactError(f"{path}: damaged ({type(error).__name__}); {ADVICE}") from error
    if not intact:
        raise CorruptArtifactError(f"{path}: was changed after it was written; {ADVICE}")
    for name, record in manifest.artifacts.items():
        notes = Document(record.notes, f"{path}: artifacts.{name}.notes")
        recipe = replace(record.recipe, settings=translated(record.recipe.settings, used=True))
        manifest.artifacts[name] = replace(record, recipe=recipe, notes=notes)
    _INTACT.add(digest)
    return manifest


def to_json(value: Any) -> Any:
    """The value for JSON: arrays as lists, keys as text, a number that is not finite as null."""
    if isinstance(value, Mapping):
        return {str(key): to_json(entry) for key, entry in value.items()}
    if hasattr(value, "tolist"):
        return to_json(value.tolist())
    if isinstance(value, list | tuple):
        return [to_json(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def changes(settings: Mapping[str, Any], before: Mapping[str, Any]) -> list[str]:
    """Differences between settings and those of before, one sentence for each key."""
    mine = dict(flatten(settings, separator="."))
    theirs = dict(flatten(before, separator="."))
    return [
        f"setting {key} changed from {theirs.get(key)} to {mine.get(key)}"
        for key in sorted(mine.keys() | theirs.keys())
        if mine.get(key) != theirs.get(key)
    ]


def stage_file(stage: str) -> str:
    """Path of the manifest of a stage in a run."""
    return f"{STAGES}/{stage}.json"


def stage_text(stage: str, content: Mapping[str, str]) -> str:
    """The manifest of a stage; no content for a stage that has nothing to do."""
    return json.dumps({"stage": stage, "content": dict(sorted(content.items()))}, indent=1) + "\n"


def staging_place(path: Path) -> Path:
    """Path of a file of a run until its commit."""
    return path.with_name(f".{path.name}{STAGED_MARK}")


def commit(root: Path, manifest: Manifest, names: Iterable[str]) -> None:
    """Make a manifest and the staged files that it describes valid, and remove stage manifests that it does not hold.

    Raises
    ------
    InputError
        The disk is full, not writable or not readable. Nothing has changed then, or the next run completes what was
        begun.
    """
    manifest.save(root, NEXT_MANIFEST)
    _complete(root, manifest, names)


def recover(root: Path) -> None:
    """Complete a commit that was interrupted, and remove what was staged for none. Call it as the only writer."""
    with reading(root):
        if (root / NEXT_MANIFEST).exists():
            manifest = load_manifest(root)
            written = {name: record.sha256 for name, record in manifest.artifacts.items()}
            written |= {
                stage_file(stage): hashlib.sha256(stage_text(stage, content).encode()).hexdigest()
                for stage, content in manifest.stages.items()
            }
            staged = {name: staging_place(root / name) for name in written}
            waiting = [name for name, path in staged.items() if path.is_file() and file_sha256(path) == written[name]]
            _complete(root, manifest, waiting)
    sweep(root, STAGED_MARK)


def _complete(root: Path, manifest: Manifest, names: Iterable[str]) -> None:
    refuse_link(root / STAGES, within=root)
    with reading(root):
        lost = [path for path in (root / STAGES).glob("*.json") if path.stem not in manifest.stages]
    for path in lost:
        with writing(path):
            path.unlink()
    for name in names:
        move(staging_place(root / name), root / name, within=root)
    move(root / NEXT_MANIFEST, root / MANIFEST, within=root)
