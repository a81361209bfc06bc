"""Identified models to and from trees of arrays, one branch per model name."""

import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.models.base import Model
from pipeline.runs.trees import read_tree

# Imported when a model is read: each brings kernels and libraries of its own.
_CLASSES = {
    "analytical": ("analytical", "AnalyticalModel"),
    "analytical-calibrated": ("analytical", "AnalyticalModel"),
    "gru": ("gru", "GruModel"),
    "narx": ("narx", "NarxModel"),
    "rbf": ("rbf", "RbfModel"),
    "rbf/hybrid": ("rbf_hybrid", "RbfHybridModel"),
    "rbf-paper": ("rbf_paper", "RbfPaperModel"),
    "sindy": ("sindy", "SindyModel"),
    "sindy-default": ("sindy", "SindyModel"),
}


def model_from_tree(name: str, tree: Mapping[str, Any]) -> Model:
    """The model called `name` from its tree.

    A tree may say its ``kind``: the default model `rbf` stands on the body of the analytical joint ("hybrid") where a
    parameter set was given, and on data alone where none was.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        A tree that lacks what the model needs.
    """
    known = _CLASSES.get(f"{name}/{tree.get('kind')}", _CLASSES.get(name))
    if known is None:
        names = ", ".join(sorted(each for each in _CLASSES if "/" not in each))
        raise InputError(f"there is no model {name!r}; known are {names}")
    module, reader = known
    model_class = getattr(importlib.import_module(f"pipeline.models.{module}"), reader)
    try:
        return cast(Model, model_class.from_tree(dict(tree)))
    except (KeyError, TypeError, ValueError) as error:
        raise CorruptArtifactError(f"the model {name} cannot be read ({error}); run `debist run` again") from None


def load_model(path: Path | str, name: str = "rbf") -> Model:
    """A model from a run's ``model.h5`` or ``rivals/NAME.h5``, for notebooks and scripts.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        The file is damaged or holds no such model.

    Examples
    --------
    >>> load_model("runs/P1/model.h5", "rbf").simulate(t, v, q0, qdot0)  # doctest: +SKIP
    """
    return model_from_tree(name, read_tree(Path(path), name))
