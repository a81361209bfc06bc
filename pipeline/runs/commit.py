"""Several artifacts and the manifest change together, or not at all.

A task writes each artifact under a staging name beside its place. The commit then (1) writes the new manifest beside
the old one, whole and synced; (2) moves the artifacts to their places; (3) moves the manifest to its own. A process
killed before (1) has changed nothing; after it, the new manifest counts, and an artifact that was not moved yet is
found under its staging name. So at every moment the folder holds the old state or the new one, and nothing between.
"""

from collections.abc import Iterable
from pathlib import Path

from pipeline.runs.atomic import move, sync
from pipeline.runs.confined import remove_within
from pipeline.runs.disk import reading
from pipeline.runs.hashing import file_sha256
from pipeline.runs.manifest import MANIFEST, NEXT_MANIFEST, Manifest, load_manifest

STAGED_MARK = ".debist-staged"


def staging_place(path: Path) -> Path:
    """Where an artifact lies until its commit."""
    return path.with_name(f".{path.name}{STAGED_MARK}")


def commit(root: Path, manifest: Manifest, paths: Iterable[Path]) -> None:
    """Make a manifest and the staged artifacts that it describes valid.

    Raises
    ------
    InputError
        The disk is full or not writable. Nothing has changed then, or the next run completes what was begun.
    """
    manifest.save(root, NEXT_MANIFEST)
    _move_all(root, paths)


def settle(root: Path) -> None:
    """Complete a commit that was interrupted, and remove what was staged for none. Call it as the only writer."""
    with reading(root):
        if (root / NEXT_MANIFEST).exists():
            manifest = load_manifest(root)
            paths = (root / name for name in manifest.artifacts)
            _move_all(root, [path for path in paths if is_staged(path, manifest.artifacts[_name(root, path)].sha256)])
    remove_within(root, STAGED_MARK)


def is_staged(path: Path, sha256: str) -> bool:
    """Whether the bytes that belong at `path` are still at its staging place."""
    staged = staging_place(path)
    return staged.is_file() and file_sha256(staged) == sha256


def _move_all(root: Path, paths: Iterable[Path]) -> None:
    folders = set()
    for path in paths:
        move(staging_place(path), path, within=root)
        folders.add(path.parent)
    for folder in folders:
        sync(folder, within=root)
    move(root / NEXT_MANIFEST, root / MANIFEST, within=root)
    sync(root, within=root)


def _name(root: Path, path: Path) -> str:
    return path.relative_to(root).as_posix()
