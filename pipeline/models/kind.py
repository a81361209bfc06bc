"""What the program must know of a model beside its name: how it is fitted, read from a tree, and exported."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol

from pipeline.identification.regressor import InputLaw
from pipeline.models.base import Model
from pipeline.numerics.kept import Keep, make_anew
from pipeline.settings import Compare, Identify
from pipeline.signals.record import Record
from pipeline.signals.trajectory import Trajectory

if TYPE_CHECKING:
    from pipeline.identification.known_curves import KnownCurves
    from pipeline.joint.parameters import JointParameters


FITTED_SHARE = 0.75
"""Share of each training log that candidates are fitted to when they are judged on the rest."""

OnProgress = Callable[[str, float], None]
"""Told what is going on, and how much of it is done."""


@dataclass(frozen=True)
class Training:
    """The training logs, and what is known of the device.

    Attributes
    ----------
    stretches : tuple of Trajectory
        Their gap-free stretches.
    records : tuple of Record
        The whole logs with gaps masked, and with the voltages between the samples.
    units : (str, str)
        SI symbols of q (m or rad) and of the inputs.
    inputs : {"squared", "linear"}
        How the inputs act.
    known_mass : float or None
        Moving mass [kg] or inertia [kg·m²], if it is known.
    parameters : JointParameters or None
        Parameter set of the analytical joint, if one is given.
    known_curves : KnownCurves or None
        Measured characteristic curves that a fit keeps.
    identify, compare : Identify, Compare
        The settings.
    log_units : (float, float)
        Units of the log for q and the inputs, in SI.
    inputs_before : {"auto", "first", "zero"}
        What the inputs were before a log.
    on_progress : callable
        Told what a fit is doing, and which share of its time limit is spent.
    keep : callable
        Keeps what a fit has finished, so that one that is killed goes on from there.
    """

    stretches: tuple[Trajectory, ...]
    records: tuple[Record, ...]
    units: tuple[str, str]
    inputs: InputLaw
    known_mass: float | None
    parameters: "JointParameters | None"
    known_curves: "KnownCurves | None"
    identify: Identify
    compare: Compare
    log_units: tuple[float, float] = (1e-3, 1e3)
    inputs_before: Literal["auto", "first", "zero"] = "auto"
    on_progress: OnProgress = lambda what, share: None
    keep: Keep = make_anew

    @property
    def mass(self) -> float:
        """The mass, 1 if it is unknown: curves are then per unit mass."""
        return 1.0 if self.known_mass is None else self.known_mass


class StoredModel(Model, Protocol):
    """A model that can be filed."""

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts, which its kind reads back."""


@dataclass(frozen=True)
class Kind:
    """How a model is made.

    Attributes
    ----------
    fit : callable
        Training data → model.
    read : callable
        Tree of arrays (`StoredModel.to_tree`) → model.
    equations : str
        ``module:function`` that writes its equations for C, MATLAB and FMU; empty if it cannot be exported.
    """

    fit: Callable[[Training], StoredModel]
    read: Callable[[dict[str, Any]], Model]
    equations: str = ""
