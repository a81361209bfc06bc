"""Stage manifests: for each stage a small file with the content hashes of what it made.

A workflow engine passes these files between its rules: they change exactly when the content changes, and they are
small enough to be hashed by any engine, which the artifacts are not.
"""

import json
from collections.abc import Iterable
from pathlib import Path

from pipeline.runs.atomic import write_text
from pipeline.runs.disk import reading
from pipeline.runs.run_folder import RunFolder

FOLDER = "stages"


def stage_manifest(root: Path, stage: str) -> Path:
    """Where the manifest of a stage lies."""
    return root / FOLDER / f"{stage}.json"


def write_stage_manifest(run: RunFolder, stage: str, names: Iterable[str]) -> None:
    """Write the manifest of a stage whose artifacts are up to date; one that says the same already is left alone.

    Parameters
    ----------
    run : RunFolder
        Whose artifacts they are.
    stage : str
        Name of the stage.
    names : iterable of str
        Its artifacts; none for a stage that has nothing to do.
    """
    hashes = {name: run.record(name).content_hash for name in sorted(names)}
    text = json.dumps({"stage": stage, "content": hashes}, indent=1) + "\n"
    path = stage_manifest(run.root, stage)
    with reading(path):
        said = path.read_bytes() if path.is_file() else b""
    if said != text.encode():
        write_text(path, text, within=run.root)
