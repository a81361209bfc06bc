"""Units and meanings that the files of models give for their entries."""

from collections.abc import Callable
from functools import partial
from typing import Any

from pipeline.models.model_file import TEXT, column_of
from pipeline.store.hashing import flatten

UNITS = {"q": "m", "v": "V", "m": "kg", "c": "N/m", "F": "N", "d": "N·s/m", "g": "N/V²"}


def columns(model: Any) -> Callable[[str], tuple[str, str]]:
    """Of a device with known mass."""
    return partial(column_of, units=UNITS, files={model.name: type(model)})


def unknown_entries(model: Any) -> list[str]:
    """Entries of a model's file of which nothing better is told than their name."""
    paths = [path for path, _ in flatten({model.name: model.to_tree()})]
    assert paths
    return [path for path in paths if columns(model)(path) == (TEXT, path.rpartition("/")[2].replace("_", " "))]
