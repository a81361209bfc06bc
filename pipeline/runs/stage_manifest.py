"""Stage manifests: for each stage a small file with the content hashes of what it made.

A workflow engine passes these files between its rules: they change exactly when the content changes, and they are
small enough to be hashed by any engine, which the artifacts are not. None ever contradicts the run's manifest: before
other content becomes valid, the stage manifest that says otherwise is removed.
"""

import json
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from pipeline.plain_files import read_plain
from pipeline.runs.atomic import write_text
from pipeline.runs.confined import folder_within, not_written, reading

FOLDER = "stages"
_LARGEST = 1 << 24


def stage_manifest(root: Path, stage: str) -> Path:
    """Where the manifest of a stage lies."""
    return root / FOLDER / f"{stage}.json"


def write_stage_manifest(root: Path, stage: str, content: Mapping[str, str]) -> None:
    """Write the manifest of a stage whose artifacts are up to date; one that says the same already is left alone.

    Parameters
    ----------
    root : Path
        The run folder.
    stage : str
        Name of the stage.
    content : mapping of str to str
        Content hash of each of its artifacts; none for a stage that has nothing to do.
    """
    text = json.dumps({"stage": stage, "content": dict(sorted(content.items()))}, indent=1) + "\n"
    path = stage_manifest(root, stage)
    with reading(path):
        said = read_plain(path, _LARGEST) if path.is_file() else b""
    if said != text.encode():
        write_text(path, text, within=root)


def said_content(path: Path) -> dict[str, str] | None:
    """The content hashes that a stage manifest states; None where it is damaged."""
    try:
        said = json.loads(read_plain(path, _LARGEST))["content"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return said if isinstance(said, dict) else None


def withdraw(root: Path, stage: str, content: Mapping[str, str]) -> None:
    """Remove the manifest of a stage if it says otherwise than the content that is about to become valid.

    Raises
    ------
    InputError
        The disk does not let it.
    """
    path = stage_manifest(root, stage)
    with reading(path):
        if not path.is_file() or path.is_symlink():
            return
    said = said_content(path)
    if said is not None and all(said.get(name, digest) == digest for name, digest in content.items()):
        return
    try:
        with folder_within(root, path.parent) as folder, suppress(FileNotFoundError):
            os.unlink(path.name, dir_fd=folder)
            os.fsync(folder)
    except OSError as error:
        raise not_written(path, error) from error
