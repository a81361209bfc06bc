"""Models by name: how each is made (`kind`), and identified models from trees of arrays and files."""

import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.model_list import ENTRIES, entry
from pipeline.models.base import Model
from pipeline.models.kind import Kind
from pipeline.runs.trees import read_tree

HEADLINE = "headline"
"""Entry of ``model.h5`` that names the model which the settings put first, or held-out data chose."""


def kind(name: str) -> Kind:
    """How the model called `name` is made; its module is imported here.

    Raises
    ------
    InputError
        A name that no model carries.
    """
    known = entry(name)
    if known is None:
        raise InputError(f"there is no model {name!r}; known are {', '.join(sorted(one.name for one in ENTRIES))}")
    module, _, attribute = known.kind.partition(":")
    found: Kind = getattr(importlib.import_module(module), attribute)
    return found


def model_from_tree(name: str, tree: Mapping[str, Any]) -> Model:
    """The model called `name` from its tree.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        A tree that lacks what the model needs.
    """
    made = kind(name)
    if name == "rbf" and tree.get("kind") == "hybrid":
        raise CorruptArtifactError(
            "an older debist made this run and called the joint's equations with corrections `rbf`; they are now "
            "`hybrid`: run `debist run PROTOTYPE.toml -o RUN` again"
        )
    try:
        return made.read(dict(tree))
    except (KeyError, TypeError, ValueError) as error:
        raise CorruptArtifactError(f"the model {name} cannot be read ({error}); run `debist run` again") from None


def load_model(path: Path | str, name: str | None = None) -> Model:
    """A model from a run's ``model.h5`` or ``baselines/NAME.h5``, for notebooks and scripts.

    Parameters
    ----------
    path : Path or str
        The file.
    name : str, optional
        Which model; the headline of ``model.h5``, or the only one of another file, if left out.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        The file is damaged or holds no such model.

    Examples
    --------
    >>> load_model("runs/P1/model.h5").simulate(t, v, q0, qdot0)  # doctest: +SKIP
    """
    if name is not None:
        return model_from_tree(name, read_tree(Path(path), name))
    tree = read_tree(Path(path))
    held = [one.name for one in ENTRIES if one.name in tree]
    if not held:
        raise CorruptArtifactError(f"{path}: holds no model; run `debist run` again")
    headline = str(tree.get(HEADLINE, held[0]))
    return model_from_tree(headline, tree[headline])
