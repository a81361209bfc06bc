"""Identified models to and from trees of arrays, one branch per model name."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from pipeline.artifacts.trees import read_tree
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.analytical import AnalyticalModel
from pipeline.models.base import Model
from pipeline.models.gru import GruModel
from pipeline.models.narx import NarxModel
from pipeline.models.rbf import RbfModel
from pipeline.models.rbf_paper import RbfPaperModel
from pipeline.models.sindy import SindyModel


def _rbf_from_tree(tree: dict[str, Any]) -> Model:
    """The default model: on the body of the analytical joint where a parameter set was given, else from data alone."""
    if tree.get("kind") == "hybrid":
        from pipeline.models.rbf_hybrid import RbfHybridModel

        return RbfHybridModel.from_tree(tree)
    return RbfModel.from_tree(tree)


_FROM_TREE: dict[str, Callable[[dict[str, Any]], Model]] = {
    "analytical": AnalyticalModel.from_tree,
    "analytical-calibrated": AnalyticalModel.from_tree,
    "gru": GruModel.from_tree,
    "narx": NarxModel.from_tree,
    "rbf": _rbf_from_tree,
    "rbf-paper": RbfPaperModel.from_tree,
    "sindy": SindyModel.from_tree,
    "sindy-default": SindyModel.from_tree,
}


def model_from_tree(name: str, tree: Mapping[str, Any]) -> Model:
    """The model called `name` from its tree.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        A tree that lacks what the model needs.
    """
    try:
        read = _FROM_TREE[name]
    except KeyError:
        known = ", ".join(sorted(_FROM_TREE))
        raise InputError(f"there is no model {name!r}; known are {known}") from None
    try:
        return read(dict(tree))
    except (TypeError, ValueError) as error:
        raise CorruptArtifactError(f"the model {name} cannot be read ({error}); run `debist identify`") from None


def load_model(path: Path | str, name: str = "rbf") -> Model:
    """A model from a run's ``model.h5`` or ``rivals/NAME.h5``, for notebooks and scripts.

    >>> load_model("runs/P1/model.h5", "rbf").simulate(t, v, q0, qdot0)  # doctest: +SKIP

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        The file is damaged or holds no such model.
    """
    return model_from_tree(name, read_tree(Path(path), name))
