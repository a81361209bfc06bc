"""From a model to the form that is exported."""

import importlib

from pipeline.errors import InputError
from pipeline.export.realisation import Realisation
from pipeline.model_list import ENTRIES
from pipeline.models.base import Model
from pipeline.models.store import kind


def realise(model: Model, interval: float, unit: str = "m") -> Realisation:
    """States, constants and kernels of a model.

    Parameters
    ----------
    model : Model
        Identified model or baseline.
    interval : float
        Sample interval [s] of its run; it decides the step.
    unit : str
        Unit of q, m or rad.

    Raises
    ------
    InputError
        A model of this kind has no equations to write down elsewhere.
    """
    equations = kind(model.name).equations
    if not equations:
        others = ", ".join(one.name for one in ENTRIES if kind(one.name).equations)
        raise InputError(f"the model {model.name} has no export; choose one of {others} with --model")
    module, _, function = equations.partition(":")
    made: Realisation = getattr(importlib.import_module(module), function)(model, interval, unit)
    return made
