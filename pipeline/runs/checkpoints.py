"""Finished parts of a long task, kept on the disk until its artifacts are committed: a killed task goes on from there.

A part is a JSON value, with arrays of floats in it to the last bit, under a name. It counts only for the recipe that it
was made for (settings, inputs and version of the algorithm), and only whole: it is written atomically, with its hash.
"""

import base64
import hashlib
import json
import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.numerics.kept import Parts
from pipeline.plain_files import read_plain
from pipeline.runs.atomic import write_bytes
from pipeline.runs.confined import folder_within
from pipeline.runs.hashing import json_sha256
from pipeline.runs.manifest import Recipe

FOLDER = ".checkpoints"
_LARGEST = 1 << 26
_BYTES = "float64"


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
            digest, _, text = read_plain(self._place(name), _LARGEST).partition(b"\n")
            return json.loads(text, object_hook=_array) if digest == _digest(text) else None
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def put(self, name: str, value: Any) -> None:
        """Keep a finished part; `value` is what JSON knows and arrays of floats, None excepted.

        Raises
        ------
        InputError
            The disk does not let it.
        """
        text = json.dumps(value, default=_described).encode()
        write_bytes(self._place(name), _digest(text) + b"\n" + text, within=self._root)

    def keep(self, name: str, make: Callable[[], Parts]) -> Parts:
        """The parts of a piece of work under a name: as they were kept, or made now and kept."""
        parts: Parts | None = self.get(name)
        if parts is None:
            parts = make()
            self.put(name, parts)
        return parts

    def each(self, names: Iterable[str], work: Callable[[list[str]], Iterable[Any]]) -> list[Any]:
        """The values of all parts in order; `work` gets the names of those that are missing and makes them in turn."""
        wanted = list(names)
        missing = [name for name in wanted if self.get(name) is None]
        for name, value in zip(missing, work(missing), strict=True):
            self.put(name, value)
        return [self.get(name) for name in wanted]

    def _place(self, name: str) -> Path:
        return self._folder / f"{json_sha256(name)[:32]}.json"


def _digest(text: bytes) -> bytes:
    return hashlib.sha256(text).hexdigest().encode()


def _described(array: np.ndarray[Any, Any]) -> dict[str, Any]:
    content = np.ascontiguousarray(array, dtype="<f8").tobytes()
    return {"shape": array.shape, _BYTES: base64.b64encode(content).decode()}


def _array(found: dict[str, Any]) -> Any:
    if _BYTES not in found:
        return found
    return np.frombuffer(bytearray(base64.b64decode(found[_BYTES])), dtype="<f8").reshape(found["shape"])


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
