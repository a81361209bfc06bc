"""From a model to the form that is exported."""

from pipeline.errors import InputError
from pipeline.export.realisation import Realisation
from pipeline.models.base import Model
from pipeline.models.rbf import RbfModel
from pipeline.models.rbf_hybrid import RbfHybridModel
from pipeline.models.rbf_paper import RbfPaperModel
from pipeline.models.sindy import SindyModel


def realise(model: Model, interval: float) -> Realisation:
    """States, constants and kernels of a model.

    Parameters
    ----------
    model : Model
        Identified model or rival.
    interval : float
        Sample interval [s] of its run; it decides the step.

    Raises
    ------
    InputError
        A model of this kind has no equations to write down elsewhere.
    """
    match model:
        case RbfHybridModel():
            from pipeline.export.equations.hybrid import realise as made
        case RbfModel():
            from pipeline.export.equations.relaxing import realise as made  # type: ignore[assignment]
        case RbfPaperModel():
            from pipeline.export.equations.lagged import realise as made  # type: ignore[assignment]
        case SindyModel():
            from pipeline.export.equations.polynomial import realise as made  # type: ignore[assignment]
        case _:
            raise InputError(f"the model {model.name} has no export; choose rbf, rbf-paper or sindy with --model")
    return made(model, interval)  # type: ignore[arg-type]
