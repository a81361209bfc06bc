"""Every model of the program: one line each. Settings, stages, folds, export and the store read this list."""

from dataclasses import dataclass
from typing import Literal

AUTO = "auto"
"""Entry of `[identify] models`: whichever of `hybrid` and `rbf` predicts held-out training data better."""


@dataclass(frozen=True)
class ModelEntry:
    """One model.

    Attributes
    ----------
    name : str
        Under which predictions and scores are filed.
    model_type : str
        Place of its `pipeline.models.model_type.ModelType`: ``module:attribute``, imported when the model is used.
    part : {"identify", "compare"}
        The settings table that names it, and the stage that fits it.
    needs_parameters : bool
        True if it needs a parameter set of the analytical joint.
    takes_mass : bool
        True if the mass in the settings enters its fit.
    stands_in : tuple of str
        Gates of the training data (`TrainingGate`) that need not hold for it: what the data do not show, its
        equations or its priors decide.
    """

    name: str
    model_type: str
    part: Literal["identify", "compare"] = "compare"
    needs_parameters: bool = False
    takes_mass: bool = True
    stands_in: tuple[str, ...] = ()


ENTRIES = (
    ModelEntry("hybrid", "models.hybrid.identify:HYBRID", "identify", stands_in=("one-well", "visits", "rank")),
    ModelEntry("rbf", "models.rbf.identify:RBF", "identify", stands_in=("visits", "rank")),
    ModelEntry("rbf-paper", "models.paper.model:RBF_PAPER", "identify"),
    ModelEntry("sindy", "models.sindy.model:SINDY"),
    ModelEntry("sindy-default", "models.sindy.model:SINDY_DEFAULT"),
    ModelEntry("narx", "models.narx:NARX", takes_mass=False),
    ModelEntry("analytical", "models.analytical.model:ANALYTICAL", needs_parameters=True, takes_mass=False),
    ModelEntry(
        "analytical-calibrated",
        "models.analytical.model:ANALYTICAL_CALIBRATED",
        needs_parameters=True,
        takes_mass=False,
    ),
)

CENTRES = 10
SMOOTHING = 0.5
"""M and σ_n of the paper (section 5.2)."""

LAG_START = 0.02
"""Time constant T_z [s] of the friction state (eq. 37) from which the search for it starts."""

RBF_TIME_LIMIT = 20.0
"""Processor time [s] of an identification of `rbf` by its cost model."""


def entry(name: str) -> ModelEntry | None:
    """The model of that name, if there is one."""
    return next((model for model in ENTRIES if model.name == name), None)


def names(part: Literal["identify", "compare"]) -> tuple[str, ...]:
    """The models that a stage can fit, in order."""
    return tuple(model.name for model in ENTRIES if model.part == part)
