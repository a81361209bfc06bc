"""Finished parts of a long task, kept on the disk until its artifacts are committed: a killed task goes on from there.

A part is a JSON value under a name. It counts only for the recipe that it was made for (settings, inputs and version of
the algorithm), and only whole: it is written atomically, with its hash.
"""

import json
import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from pipeline.plain_files import read_plain
from pipeline.runs.atomic import write_text
from pipeline.runs.confined import folder_within
from pipeline.runs.hashing import json_sha256
from pipeline.runs.manifest import Recipe

FOLDER = ".checkpoints"
_LARGEST = 1 << 26


class Checkpoints:
    """The parts of one task.

    Parameters
    ----------
    root : Path
        Run folder.
    recipe : Recipe
        What decides the task's result.
    """

    def __init__(self, root: Path, recipe: Recipe) -> None:
        self._root = root
        key = json_sha256({**vars(recipe), "settings": dict(recipe.settings), "inputs": dict(recipe.inputs)})
        self._folder = root / FOLDER / key[:32]

    def get(self, name: str) -> Any | None:
        """The value of a part that is finished, None otherwise."""
        try:
            document = json.loads(read_plain(self._place(name), _LARGEST))
            return document["value"] if document["sha256"] == json_sha256(document["value"]) else None
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def put(self, name: str, value: Any) -> None:
        """Keep a finished part; `value` is what JSON knows, None excepted, numbers finite.

        Raises
        ------
        InputError
            The disk does not let it.
        """
        document = {"value": value, "sha256": json_sha256(value)}
        write_text(self._place(name), json.dumps(document), within=self._root)

    def each(self, names: Iterable[str], work: Callable[[list[str]], Iterable[Any]]) -> list[Any]:
        """The values of all parts in order; `work` gets the names of those that are missing and makes them in turn."""
        wanted = list(names)
        missing = [name for name in wanted if self.get(name) is None]
        for name, value in zip(missing, work(missing), strict=True):
            self.put(name, value)
        return [self.get(name) for name in wanted]

    def _place(self, name: str) -> Path:
        return self._folder / f"{json_sha256(name)[:32]}.json"


def clear_checkpoints(root: Path) -> None:
    """Remove all parts: those of a task that is committed, and those of recipes that nobody asks for any more."""
    with suppress(OSError):
        if (root / FOLDER).is_symlink() or not (root / FOLDER).is_dir():
            return
        with folder_within(root, root / FOLDER) as held:
            for _, folders, files, folder in os.fwalk(".", topdown=False, dir_fd=held):
                for name in files:
                    os.unlink(name, dir_fd=folder)
                for name in folders:
                    os.rmdir(name, dir_fd=folder)
        (root / FOLDER).rmdir()
