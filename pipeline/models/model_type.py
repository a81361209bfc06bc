"""Types of models: how each is fitted, read from trees and files, and exported; and the data that a fit takes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Protocol, cast

import numpy as np

from ..device.device import Device
from ..device.parameters import JointParameters
from ..errors import CorruptArtifactError, InputError
from ..fitting.population import NormalPopulation
from ..numerics.arrays import FloatArray
from ..settings.models import ENTRIES, entry
from ..settings.prototype import Compare, Identify
from ..signals.log import Log
from ..store.trees import read_tree
from ..system.package import object_at
from ..system.worker_pool import OnProgress, silent
from .base import DynamicModel
from .model_file import read_part

FITTED_SHARE = 0.75
"""Share of each training log that candidates are fitted to when they are judged on the rest."""
LEAST_POINTS = 4
"""Points that a measured curve needs within the range of the training data."""
MAIN_MODEL = "headline"
"""Entry of ``model.h5`` that names the model which the settings put first, or held-out data chose."""


def fitted_samples(samples: int) -> int:
    """Number of fitted samples of a log."""
    return round(FITTED_SHARE * samples)


@dataclass(frozen=True)
class KnownCurves:
    """Measured curves of a joint.

    Attributes
    ----------
    q : FloatArray, shape (n,)
        Displacement [m] or [rad].
    force : FloatArray, shape (n,), optional
        Restoring force F [N] at rest without inputs, positive where it pulls to smaller q; NaN where not measured.
    gains : sequence of FloatArray, shape (n,), or None, one per input
        g_k [N/V²] (half the slope of a capacitance) or [N/V]; NaN where not measured, None for all of them.
    """

    q: FloatArray
    force: FloatArray | None
    gains: tuple[FloatArray | None, ...]

    @property
    def reach(self) -> tuple[float, float]:
        """Smallest and largest q at which something was measured."""
        curves = [curve for curve in (self.force, *self.gains) if curve is not None]
        measured = self.q[np.any(np.isfinite(curves), axis=0)]
        return float(measured.min()), float(measured.max())

    @property
    def signs(self) -> dict[int, int]:
        """Sign of each measured gain by the number of its input; 0 where it changes along q."""
        signs = {k: np.unique(np.sign(gain[gain != 0.0])) for k, gain in enumerate(self.gains) if gain is not None}
        return {k: int(sign[0]) if np.count_nonzero(np.isfinite(sign)) == 1 else 0 for k, sign in signs.items()}

    def check(self, low: float, high: float) -> None:
        """Refuse curves that hardly overlap with data from `low` to `high`.

        Raises
        ------
        InputError
            A curve has fewer than four points there.
        """
        inside = (self.q >= low) & (self.q <= high)
        named = {"F": self.force} | {f"input {k}": gain for k, gain in enumerate(self.gains, start=1)}
        for name, curve in named.items():
            if curve is not None and (points := np.count_nonzero(np.isfinite(curve) & inside)) < LEAST_POINTS:
                raise InputError(
                    f"the measured curve of {name} has {points} points where the training data are ({low:.4g} to "
                    f"{high:.4g}), at least {LEAST_POINTS} are needed; check q and its unit in the file of plant.curves"
                )

    def per_unit_mass(self, mass: float) -> "KnownCurves":
        """Forces over the moving mass [kg]."""
        force, *gains = (None if curve is None else curve / mass for curve in (self.force, *self.gains))
        return KnownCurves(self.q, force, tuple(gains))


@dataclass(frozen=True)
class Training:
    """The training logs, and what is known of the device.

    Attributes
    ----------
    segments : tuple of Log
        Their gap-free segments.
    records : tuple of Log
        The whole logs with gaps masked, and with the voltages between the samples.
    device : Device
        Its units, the action of its inputs, and its mass.
    parameters : JointParameters or None
        Parameter set of the analytical joint, if one is given.
    rotation : FloatArray, shape (K, 2), or None
        q [m] and φ [rad] at rest, by which the measured angle of the joint was made its displacement.
    known_curves : KnownCurves or None
        Measured characteristic curves that a fit keeps.
    identify, compare : Identify, Compare
        The settings.
    inputs_before : {"auto", "first", "zero"}
        Inputs before a log.
    siblings : NormalPopulation or None
        Prior of the deviations of `hybrid` from joints of the same drawing.
    on_progress : callable
        Called with the step of a fit, and the share of its time limit that is spent.
    """

    segments: tuple[Log, ...]
    records: tuple[Log, ...]
    device: Device
    parameters: JointParameters | None
    known_curves: KnownCurves | None
    identify: Identify
    compare: Compare = field(default_factory=Compare)
    inputs_before: Literal["auto", "first", "zero"] = "auto"
    siblings: NormalPopulation | None = None
    rotation: FloatArray | None = None
    on_progress: OnProgress = silent

    @property
    def fitted_segments(self) -> list[Log]:
        """The gap-free segments of `records`, which leave out what is poorly known at the beginning of a log."""
        return [segment for record in self.records for segment in record.segments()]


class StoredModel(DynamicModel, Protocol):
    """A model that can be filed."""

    def to_tree(self) -> dict[str, Any]:
        """The model as a dictionary of arrays, numbers and texts, which its type reads back."""


@dataclass(frozen=True)
class ModelType:
    """Functions that make a model.

    Attributes
    ----------
    fit : callable
        Training data → model.
    file : type
        Class of the model, which declares its tree (`pipeline.models.model_file`).
    equations : str
        ``module:function`` that writes its equations for C, MATLAB and FMU; empty if it cannot be exported.
    """

    fit: Callable[[Training], StoredModel]
    file: type[StoredModel]
    equations: str = ""


def model_type(name: str) -> ModelType:
    """The type of the model called `name`; its module is imported here.

    Raises
    ------
    InputError
        A name that no model carries.
    """
    listed = entry(name)
    if listed is None:
        raise InputError(
            f"there is no model {name!r}; choose one of {', '.join(sorted(model.name for model in ENTRIES))}"
        )
    return cast(ModelType, object_at(listed.model_type))


def equations_of(name: str) -> Callable[..., Any]:
    """The function that writes the equations of a model for other tools.

    Raises
    ------
    InputError
        A model that has none.
    """
    equations = model_type(name).equations
    if not equations:
        others = ", ".join(entry.name for entry in ENTRIES if model_type(entry.name).equations)
        raise InputError(f"the model {name} has no export; choose one of {others} with --model")
    return cast(Callable[..., Any], object_at(equations))


def model_from_tree(name: str, tree: Mapping[str, Any]) -> DynamicModel:
    """The model called `name` from its tree.

    Raises
    ------
    InputError
        A name that no model carries.
    CorruptArtifactError
        A tree that lacks what the model needs.
    """
    family = model_type(name)
    if name == "rbf" and tree.get("kind") == "hybrid":
        raise CorruptArtifactError(
            "an older debist made this run and called the joint's equations with corrections `rbf`; they are now "
            "`hybrid`: run `debist run PROTOTYPE.toml -o RUN` again"
        )
    try:
        return read_part(family.file, tree, name, next(listed.part for listed in ENTRIES if listed.name == name))
    except (TypeError, ValueError, ArithmeticError, InputError) as error:
        raise CorruptArtifactError(f"the model {name} cannot be read ({error}); run `debist run` again") from None


def load_model(path: Path | str) -> DynamicModel:
    """A model from a run's ``model.h5`` or ``baselines/NAME.h5``, for notebooks and scripts.

    Parameters
    ----------
    path : Path or str
        The file; of the models in ``model.h5`` it is the main model.

    Raises
    ------
    CorruptArtifactError
        The file is damaged or holds no model.

    Examples
    --------
    >>> load_model("runs/P1/model.h5").simulate(t, v, q0, qdot0)  # doctest: +SKIP
    """
    tree = read_tree(Path(path))
    held = [model.name for model in ENTRIES if model.name in tree]
    if not held:
        raise CorruptArtifactError(f"{path}: holds no model; run `debist run` again")
    main_model = str(tree.get(MAIN_MODEL, held[0]))
    if main_model not in held:
        raise CorruptArtifactError(f"{path}: holds no model {main_model!r}, which it names; run `debist run` again")
    return model_from_tree(main_model, tree[main_model])
