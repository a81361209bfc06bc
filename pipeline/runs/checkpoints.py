"""Finished parts of a long task, kept on the disk until its artifacts are committed: a killed task goes on from there.

A part is a JSON value, with arrays of floats in it to the last bit, under a name. It counts only for the recipe that it
was made for (settings, inputs and version of the algorithm), and only whole: it is written atomically, with the digest
of the recipe and one of recipe, name and content. A part that has not both is made anew.
"""

import base64
import hashlib
import json
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.numerics.progress import StoredResult
from pipeline.plain_files import read_plain
from pipeline.runs.atomic import write_bytes
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
        self._recipe = json_sha256({**vars(recipe), "settings": dict(recipe.settings), "inputs": dict(recipe.inputs)})

    def get(self, name: str) -> Any | None:
        """The value of a part that is finished, None otherwise."""
        try:
            head, _, text = read_plain(self._place(name), _LARGEST).partition(b"\n")
            return json.loads(text, object_hook=_array) if head == self._head(name, text) else None
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def put(self, name: str, value: Any) -> None:
        """Keep a finished part; `value` is what JSON can hold and arrays of floats, None excepted.

        Raises
        ------
        InputError
            The disk does not let it.
        """
        text = json.dumps(value, default=_described).encode()
        write_bytes(self._place(name), self._head(name, text) + b"\n" + text, within=self._root)

    def keep(self, name: str, make: Callable[[], StoredResult]) -> StoredResult:
        """The parts of a piece of work under a name: as they were kept, or made now and kept."""
        parts: StoredResult | None = self.get(name)
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
        return self._root / FOLDER / self._recipe[:32] / f"{json_sha256(name)[:32]}.json"

    def _head(self, name: str, text: bytes) -> bytes:
        """The first line of a part: the recipe's digest and its own."""
        own = hashlib.sha256(json.dumps([self._recipe, name]).encode() + text).hexdigest()
        return f"{self._recipe} {own}".encode()


def _described(array: np.ndarray[Any, Any]) -> dict[str, Any]:
    content = np.ascontiguousarray(array, dtype="<f8").tobytes()
    return {"shape": array.shape, _BYTES: base64.b64encode(content).decode()}


def _array(document: dict[str, Any]) -> Any:
    if _BYTES not in document:
        return document
    return np.frombuffer(bytearray(base64.b64decode(document[_BYTES])), dtype="<f8").reshape(document["shape"])


def clear_checkpoints(root: Path) -> None:
    """Remove all parts: those of a task that is committed, and those of recipes that no task has any more."""
    if not (root / FOLDER).is_symlink():
        shutil.rmtree(root / FOLDER, ignore_errors=True)
