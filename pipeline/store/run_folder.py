"""A run folder: artifacts by name, checked against the manifest whenever they are read."""

import hashlib
import json
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, TypeVar

from ..errors import CorruptArtifactError, InputError, SupersededError, warn_user
from ..settings.file import translated
from ..settings.prototype import Prototype, parse_prototype
from ..system.names import shell_word
from . import layout, tables, trees
from .atomic import TEMPORARY_MARK, move, reading, refuse_link, sweep, write_bytes, write_text
from .hashing import file_sha256, json_sha256
from .manifest import (
    MANIFEST,
    NEXT_MANIFEST,
    STAGES,
    ArtifactRecord,
    Manifest,
    Recipe,
    commit,
    load_manifest,
    recorded_versions,
    recover,
    stage_file,
    stage_text,
    staging_place,
    to_json,
)
from .schemas import Document, Schema, misfit
from .tables import read_buffer

# Beginnings of names that a folder without a run may hold: the lock, and what a workflow engine lays out beforehand.
_NO_RUN_YET = (".lock", STAGES)
CORRUPT_MARK = ".corrupt-"
_TRIES = 50
_PAUSE = 0.02

T = TypeVar("T")
_Read = Callable[[Path], tuple[T, str]]
"""Gives what is wanted of a file, and the SHA-256 of the bytes that it is from."""


def _look(path: Path, size: int, sha256: str, read: _Read[T]) -> tuple[T | None, str | None]:
    try:
        present = path.stat().st_size
        if not path.is_file():
            return None, "is no regular file"
        if present != size:
            return None, f"has {present} bytes, {size} were written"
        content, digest = read(path)
    except FileNotFoundError:
        return None, "is missing"
    return (content, None) if digest == sha256 else (None, "does not have the bytes that were written")


def _hashed(path: Path) -> tuple[Path, str]:
    """The path itself."""
    return path, file_sha256(path)


def _buffered(path: Path) -> tuple[Any, str]:
    """All bytes in memory of Arrow's own."""
    content = read_buffer(path)
    return content, hashlib.sha256(memoryview(content)).hexdigest()


@dataclass(frozen=True)
class Written:
    """An artifact that a stage has just written."""

    content_hash: str
    notes: Mapping[str, Any]


class RunFolder:
    """One run on disk. Whoever writes into it holds its lock.

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
        """Open the run for these settings, keeping what it already holds; changed settings are stored at once.

        What a killed process left behind is completed or removed first.
        """
        manifest = Manifest(prototype, str(prototype_file.resolve()), recorded_versions(), {})
        if not manifest.prototype_file.isprintable() and any(
            0xD800 <= ord(c) < 0xE000 for c in manifest.prototype_file
        ):
            raise InputError(f"{prototype_file}: its path is not UTF-8, so no manifest can state it; rename the folder")
        if not holds_run(root):
            sweep(root)
            manifest.save(root)  # first of all, so that whatever a killed process leaves here is known as a run
            return cls(root, manifest)
        recover(root)
        sweep(root)
        stored = load_manifest(root)
        kept = replace(stored, prototype=prototype, prototype_file=manifest.prototype_file)
        if kept != stored:
            kept.save(root)
        return cls(root, kept)

    @property
    def prototype(self) -> Prototype:
        """The settings that the run was made from.

        Raises
        ------
        CorruptArtifactError
            They are none.
        """
        try:
            return parse_prototype(translated(self.manifest.prototype), f"{self.root}/{MANIFEST}: prototype")
        except InputError as error:
            raise CorruptArtifactError(f"{error}; run again from the settings file") from None

    def path(self, name: str) -> Path:
        """Path of the artifact `name`.

        Raises
        ------
        InputError
            A folder on the way is a symbolic link, or the name leaves the run on some system.
        """
        if not layout.inside(name):
            raise InputError(f"{name!r} leaves the run folder {self.root}")
        target = self.root / name
        refuse_link(target.parent, within=self.root)
        return target

    def record(self, name: str) -> ArtifactRecord:
        """The record of an artifact in the manifest.

        Raises
        ------
        InputError
            It was not made yet.
        """
        if name not in self.manifest.artifacts:
            raise InputError(f"{self.root}: has no {name} yet; `debist run` makes what is missing")
        return self.manifest.artifacts[name]

    def problem(self, name: str) -> str | None:
        """Problem with the file of a recorded artifact, or None.

        Raises
        ------
        SupersededError
            Another process has replaced it since this run was opened.
        """
        return self._examine(name, _hashed)[1]

    def checked(self, name: str) -> Path:
        """The path of an intact artifact; errors as for `read_bytes`."""
        return self._intact(name, _hashed)

    def read_bytes(self, name: str) -> bytes:
        """The bytes of an artifact, which are those that were written.

        Raises
        ------
        CorruptArtifactError
            They are not.
        SupersededError
            Another process has replaced them since this run was opened.

        Warns
        -----
        UserWarning
            They were made from what was made anew since.
        """
        return bytes(memoryview(self._intact(name, _buffered)))

    def read_table(self, name: str) -> tables.Table:
        """Read a Parquet artifact from bytes that were checked; errors as for `read_bytes`."""
        table = tables.parse_table(self._intact(name, _buffered), self.path(name))
        if wrong := misfit(name, table):
            raise CorruptArtifactError(f"{self.path(name)}: {wrong}; `debist run` rebuilds it in an empty folder")
        return table

    def read_records(self, name: str) -> list[dict[str, Any]]:
        """The rows of a Parquet artifact, None where there is no finite number; errors as for `read_bytes`."""
        table = self.read_table(name)
        return [dict(zip(table, map(to_json, row), strict=True)) for row in zip(*table.values(), strict=True)]

    def read_document(self, name: str) -> Document:
        """Read a JSON artifact; errors as for `read_bytes`, also where a key is asked for that is not there."""
        remedy = layout.remade(name) or "`debist run` makes it anew"
        return Document(json.loads(self.read_bytes(name)), str(self.path(name)), remedy)

    def read_tree(self, name: str, group: str = "/") -> trees.Tree:
        """Read an HDF5 artifact, or a branch of it, from bytes that were checked; errors as for `read_bytes`."""
        return trees.parse_tree(self.read_bytes(name), self.path(name), group)

    def _intact(self, name: str, read: _Read[T]) -> T:
        content, problem = self._examine(name, read)
        if problem is not None or content is None:
            remedy = layout.remade(name) or f"redoes stage {self.record(name).recipe.stage}"
            raise CorruptArtifactError(f"{self.path(name)}: {problem}; `debist run` sets it aside and {remedy}")
        if newer := self._newer(name):
            warn_user(
                f"{self.root}: some results are older than {newer}; `debist run {shell_word(self.root)}` renews them"
            )
        return content

    def _newer(self, name: str) -> str | None:
        """Name of an input that was made anew since the artifact was made from it; None where there is none."""
        recipe = self.record(name).recipe
        made_from = {} if recipe.stage == "ingest" else recipe.inputs  # raw files, which may have names of artifacts
        for each, content in made_from.items():
            record = self.manifest.artifacts.get(each)
            if record and (newer := each if record.content_hash != content else self._newer(each)):
                return newer
        return None

    def _examine(self, name: str, read: _Read[T]) -> tuple[T | None, str | None]:
        """Result of `read` for the artifact's file, or the problem with the file."""
        record = self.record(name)
        return self._look_up(
            self.path(name), record.bytes, record.sha256, read, lambda manifest: manifest.artifacts.get(name)
        )

    def stage_problem(self, stage: str) -> str | None:
        """Problem with the manifest of a stage, or None; errors as for `problem`."""
        text = stage_text(stage, self.manifest.stages[stage]).encode()
        sha256 = hashlib.sha256(text).hexdigest()
        path = self.path(stage_file(stage))
        return self._look_up(path, len(text), sha256, _hashed, lambda manifest: manifest.stages.get(stage))[1]

    def _look_up(
        self, path: Path, size: int, sha256: str, read: _Read[T], stated: Callable[[Manifest], object]
    ) -> tuple[T | None, str | None]:
        """Result of `read` for a file with a record `stated` in the manifest, or the problem with the file.

        While a commit awaits its completion the file is at its staging place, from which it may just be moved.

        Raises
        ------
        InputError
            The system does not let it be read.
        SupersededError
            Another process has replaced it since this run was opened.
        """
        with reading(path):
            content, problem = _look(path, size, sha256, read)
            if problem is not None and (self.root / NEXT_MANIFEST).exists():
                content, elsewhere = _look(staging_place(path), size, sha256, read)
                problem = elsewhere and problem
            if problem is not None:
                content, problem = _look(path, size, sha256, read)
        if problem is not None and stated(load_manifest(self.root)) != stated(self.manifest):
            raise SupersededError(f"{path}: was replaced by another run while it was read; do it again")
        return content, problem

    def write_table(self, name: str, schema: Schema, columns: Mapping[str, Any], notes: Mapping[str, Any]) -> Written:
        """Write a Parquet artifact; like all that is written, it counts from its commit on.

        Parameters
        ----------
        name : str
            Name of the artifact.
        schema : Schema
            Resolved for the device.
        columns : mapping of str to array-like, each of length N
            Its columns.
        notes : mapping
            Notes on the result.
        """
        return self.write_pieces(name, schema, [columns], notes)

    def write_pieces(
        self, name: str, schema: Schema, pieces: Iterable[Mapping[str, Any]], notes: Mapping[str, Any]
    ) -> Written:
        """Write a Parquet artifact that comes in pieces, in the memory of a row group.

        Parameters
        ----------
        name : str
            Name of the artifact.
        schema : Schema
            Resolved for the device.
        pieces : iterable of mapping
            Consecutive rows of all columns.
        notes : mapping
            Notes on the result.
        """
        return Written(tables.write_pieces(self._staged(name), schema, pieces, within=self.root), notes)

    def write_tree(
        self, name: str, tree: Mapping[str, Any], notes: Mapping[str, Any], columns: trees.Columns | None = None
    ) -> Written:
        """Write an HDF5 artifact with the units and meanings of `columns`.

        Parameters
        ----------
        name : str
            Name of the artifact.
        tree : mapping
            Nested arrays, numbers and texts.
        notes : mapping
            Notes on the result.
        columns : callable, optional
            Unit and meaning of an entry by its path.
        """
        return Written(trees.write_tree(self._staged(name), tree, columns, within=self.root), notes)

    def write_text(self, name: str, text: str, notes: Mapping[str, Any]) -> Written:
        """Write a text artifact."""
        write_text(self._staged(name), text, within=self.root)
        return Written(json_sha256(text), notes)

    def write_json(self, name: str, document: Any, notes: Mapping[str, Any]) -> Written:
        """Write a JSON artifact."""
        return self.write_text(name, json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n", notes)

    def write_bytes(self, name: str, content: bytes, notes: Mapping[str, Any]) -> Written:
        """Write a binary artifact."""
        write_bytes(self._staged(name), content, within=self.root)
        return Written(hashlib.sha256(content).hexdigest(), notes)

    def _staged(self, name: str) -> Path:
        path = self.path(name)
        refuse_link(path)
        return staging_place(path)

    def commit(self, recipe: Recipe, written: Mapping[str, Written]) -> None:
        """Make the artifacts of one task valid, all at once; a stage manifest of other content is removed."""
        for name, artifact in written.items():
            staged = staging_place(self.path(name))
            with reading(staged):
                self.manifest.artifacts[name] = ArtifactRecord(
                    recipe=recipe,
                    sha256=file_sha256(staged),
                    content_hash=artifact.content_hash,
                    bytes=staged.stat().st_size,
                    notes=to_json(artifact.notes),
                )
        self.manifest.versions = recorded_versions()
        stated = self.manifest.stages.get(recipe.stage, {})
        if any(stated.get(name, artifact.content_hash) != artifact.content_hash for name, artifact in written.items()):
            del self.manifest.stages[recipe.stage]
        commit(self.root, self.manifest, written)

    def state(self, stages: Mapping[str, Mapping[str, str]]) -> None:
        """Write the manifests of stages that are up to date: content hash by artifact, by stage.

        What is there already is left alone.
        """
        stored = self.manifest.stages
        changed = [
            stage for stage, content in stages.items() if stored.get(stage) != content or self.stage_problem(stage)
        ]
        for stage in changed:
            stored[stage] = dict(stages[stage])
            write_text(self._staged(stage_file(stage)), stage_text(stage, stages[stage]), within=self.root)
        if changed:
            commit(self.root, self.manifest, map(stage_file, changed))

    def set_aside(self, name: str) -> None:
        """Move a damaged artifact out of the way, never deleting it."""
        path = self.path(name)
        aside = f"{name}{CORRUPT_MARK}{datetime.now(UTC).strftime('%Y%m%dT%H%M%S%f')}"
        self.manifest.set_aside.append(aside)
        commit(self.root, self.manifest, [])
        move(path, self.root / aside, within=self.root)

    def strike(self, name: str) -> str:
        """Strike an artifact off the manifest if it is damaged or lost, setting its file aside; what is wrong with it.

        Empty if it is intact.
        """
        if (problem := self.problem(name)) is None:
            return ""
        if problem != "is missing":
            self.set_aside(name)
        del self.manifest.artifacts[name]
        commit(self.root, self.manifest, [])
        return problem


def in_snapshot(root: Path, work: Callable[[RunFolder], T]) -> T:
    """Do some reading in one state of a run, though another process may go on writing into it.

    All that is read is checked against one manifest; if that was replaced meanwhile, the work starts again.

    Parameters
    ----------
    root : Path
        Run folder.
    work : callable
        Reads, and changes nothing.
    """
    for _ in range(_TRIES):
        with suppress(SupersededError):
            return work(RunFolder.open(root))
        time.sleep(_PAUSE)
    return work(RunFolder.open(root))


def holds_run(root: Path) -> bool:
    """True if a run is there; else it may begin there.

    Raises
    ------
    InputError
        Other files are there, or a file where the folder would be.
    """
    with reading(root):
        if not next(each for each in (root, *root.parents) if each.exists() or each.is_symlink()).is_dir():
            raise InputError(f"{root}: is no folder, and a run is one; choose another with -o")
        holds = any((root / name).exists() for name in (MANIFEST, NEXT_MANIFEST))
        files = (place.name for place in root.iterdir()) if root.is_dir() else ()
        if not holds and not all(name.startswith(_NO_RUN_YET) or name.endswith(TEMPORARY_MARK) for name in files):
            raise InputError(f"{root}: holds files but no run; choose an empty or a new folder")
    return holds
