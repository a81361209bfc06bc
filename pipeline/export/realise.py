"""From a model to the form that is exported."""

from pipeline.errors import InputError
from pipeline.export.equations import hybrid, lagged, polynomial, relaxing
from pipeline.export.realisation import Realisation
from pipeline.models.base import Model
from pipeline.models.rbf import RbfModel
from pipeline.models.rbf_hybrid import RbfHybridModel
from pipeline.models.rbf_paper import RbfPaperModel
from pipeline.models.sindy import SindyModel


def realise(model: Model, interval: float, unit: str = "m") -> Realisation:
    """States, constants and kernels of a model.

    Parameters
    ----------
    model : Model
        Identified model or rival.
    interval : float
        Sample interval [s] of its run; it decides the step.
    unit : str
        Unit of q, m or rad.

    Raises
    ------
    InputError
        A model of this kind has no equations to write down elsewhere.
    """
    match model:
        case RbfHybridModel():
            return hybrid.realise(model, interval)
        case RbfModel():
            return relaxing.realise(model, interval)
        case RbfPaperModel():
            return lagged.realise(model, interval, unit)
        case SindyModel():
            return polynomial.realise(model, interval, unit)
    raise InputError(f"the model {model.name} has no export; choose rbf, rbf-paper or sindy with --model")
