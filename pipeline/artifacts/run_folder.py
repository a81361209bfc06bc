"""A run folder: artifacts by name, checked against the manifest whenever they are read."""

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from pipeline import __version__
from pipeline.artifacts import tables, trees
from pipeline.artifacts.atomic import write_bytes, write_text
from pipeline.artifacts.hashing import file_sha256, json_sha256
from pipeline.artifacts.manifest import MANIFEST, ArtifactRecord, Manifest, Recipe, load_manifest, plain
from pipeline.artifacts.schemas import Schema
from pipeline.errors import CorruptArtifactError, InputError

# Versions that can move a digit of a result.
_RECORDED = ("numpy", "scipy", "numba", "pyarrow", "h5py", "pysindy")


# Beginnings of names that a folder without a run may hold: the lock, and what a workflow engine lays out beforehand.
_NO_RUN_YET = (".lock", "stages")


@dataclass(frozen=True)
class Written:
    """An artifact that a stage has just written."""

    content_hash: str
    notes: Mapping[str, Any]


class RunFolder:
    """One run on disk.

    Parameters
    ----------
    root : Path
    manifest : Manifest
    """

    def __init__(self, root: Path, manifest: Manifest) -> None:
        self.root = root
        self.manifest = manifest

    @classmethod
    def open(cls, root: Path) -> "RunFolder":
        """Open an existing run."""
        return cls(root, load_manifest(root))

    @classmethod
    def create(cls, root: Path, prototype: dict[str, Any], prototype_file: Path) -> "RunFolder":
        """Open the run for these settings, keeping what it already holds; changed settings are stored at once."""
        known: dict[str, ArtifactRecord] = {}
        if (root / MANIFEST).exists():
            stored = load_manifest(root)
            known = stored.artifacts
            if (stored.prototype, stored.prototype_file) != (prototype, str(prototype_file.resolve())):
                Manifest(prototype, str(prototype_file.resolve()), stored.versions, known).save(root)
        elif root.is_dir() and any(not entry.name.startswith(_NO_RUN_YET) for entry in root.iterdir()):
            raise InputError(f"{root}: holds files but no run; choose an empty or a new folder")
        return cls(root, Manifest(prototype, str(prototype_file.resolve()), _versions(), known))

    def path(self, name: str) -> Path:
        """Where the artifact `name` lies.

        Raises
        ------
        InputError
            A folder on the way is a symbolic link, or the name leaves the run.
        """
        target = self.root / name
        relative = Path(name)
        if relative.is_absolute() or ".." in relative.parts:
            raise InputError(f"{name!r} leaves the run folder {self.root}")
        for folder in list(relative.parents)[:-1]:
            if (self.root / folder).is_symlink():
                raise InputError(f"{self.root / folder}: is a symbolic link; debist writes to no link, remove it")
        return target

    def record(self, name: str) -> ArtifactRecord:
        """What the manifest says of an artifact.

        Raises
        ------
        InputError
            It was not made yet.
        """
        if name not in self.manifest.artifacts:
            raise InputError(f"{self.root}: has no {name} yet; `debist run` makes what is missing")
        return self.manifest.artifacts[name]

    def problem(self, name: str) -> str | None:
        """What is wrong with the file of a recorded artifact, or None."""
        record, path = self.record(name), self.path(name)
        if not path.is_file():
            return "is missing"
        if path.stat().st_size != record.bytes:
            return f"has {path.stat().st_size} bytes, {record.bytes} were written"
        if file_sha256(path) != record.sha256:
            return "does not have the bytes that were written"
        return None

    def checked(self, name: str) -> Path:
        """The path of an intact artifact.

        Raises
        ------
        CorruptArtifactError
            Its bytes are not those that were written.
        """
        problem = self.problem(name)
        if problem:
            stage = self.record(name).recipe.stage
            raise CorruptArtifactError(
                f"{self.path(name)}: {problem}; `debist run` sets it aside and redoes stage {stage}"
            )
        return self.path(name)

    def read_table(self, name: str, columns: list[str] | None = None) -> tables.Table:
        """Read a Parquet artifact after checking its bytes."""
        return tables.read_table(self.checked(name), columns)

    def read_tree(self, name: str, group: str = "/") -> trees.Tree:
        """Read an HDF5 artifact, or a branch of it, after checking its bytes."""
        return trees.read_tree(self.checked(name), group)

    def write_table(self, name: str, schema: Schema, columns: Mapping[str, Any], notes: Mapping[str, Any]) -> Written:
        """Write a Parquet artifact."""
        return Written(tables.write_table(self.path(name), schema, columns), notes)

    def write_pieces(
        self, name: str, schema: Schema, pieces: Iterable[Mapping[str, Any]], notes: Mapping[str, Any]
    ) -> Written:
        """Write a Parquet artifact that comes in pieces, in the memory of a row group."""
        return Written(tables.write_pieces(self.path(name), schema, pieces), notes)

    def write_tree(self, name: str, tree: Mapping[str, Any], notes: Mapping[str, Any]) -> Written:
        """Write an HDF5 artifact."""
        return Written(trees.write_tree(self.path(name), tree), notes)

    def write_text(self, name: str, text: str, notes: Mapping[str, Any]) -> Written:
        """Write a text artifact."""
        write_text(self.path(name), text)
        return Written(json_sha256(text), notes)

    def write_bytes(self, name: str, content: bytes, notes: Mapping[str, Any]) -> Written:
        """Write a binary artifact."""
        write_bytes(self.path(name), content)
        return Written(hashlib.sha256(content).hexdigest(), notes)

    def commit(self, recipe: Recipe, written: Mapping[str, Written]) -> None:
        """Enter artifacts that one task has written into the manifest, all at once."""
        for name, artifact in written.items():
            path = self.path(name)
            self.manifest.artifacts[name] = ArtifactRecord(
                recipe, file_sha256(path), artifact.content_hash, path.stat().st_size, plain(artifact.notes)
            )
        self.manifest.versions = _versions()
        self.manifest.save(self.root)

    def set_aside(self, name: str) -> Path:
        """Move a damaged artifact out of the way, never deleting it; returns its new path."""
        path = self.path(name)
        stamp = datetime.now(UTC).strftime("%Y%m%dT%H%M%S%f")
        aside = path.with_name(f"{path.name}.corrupt-{stamp}")
        path.rename(aside)
        return aside


def _versions() -> dict[str, str]:
    return {"debist": __version__, **{package: version(package) for package in _RECORDED}}
