"""The file of a model, declared once: a class names its entries, with kind, shape, limits, unit and a line of help.

The class reads, writes and checks the file. A file is checked in this order: sizes, then shapes that fit each other,
then ranges of finite numbers. Compiled code reads no array that was not checked here. HDF5 keeps unit and meaning as
attributes of each array, number and text.
"""

from collections.abc import Mapping
from dataclasses import dataclass, is_dataclass
from fnmatch import fnmatchcase
from functools import partial
from typing import Annotated, Any, ClassVar, Self, TypeVar

import numpy as np
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    PlainValidator,
    TypeAdapter,
    ValidationError,
    model_validator,
)

from ..device.device import Device
from ..device.parameters import NOMINAL, QUANTITIES, VECTOR_NAMES, JointParameters
from ..errors import CorruptArtifactError, InputError
from ..numerics.arrays import FloatArray, IntArray
from ..store.trees import Columns
from ..units.units import DISPLACEMENT, INPUT, MASS

LARGEST = 1e30
"""Largest magnitude of any number; products of a few of them are still finite."""
MOST_INPUTS = 2
_MOST_FACTS = 1000
_LONGEST_TEXT = 10_000
_DEEPEST = 4

Sizes = Mapping[str, tuple[int, int]]
Positive = Annotated[float, Field(ge=1.0 / LARGEST, le=LARGEST)]
Real = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
SHORTEST_LAG = 1e-4
LONGEST_LAG = 10.0
Lag = Annotated[float, Field(ge=SHORTEST_LAG, le=LONGEST_LAG)]
"""Time constant [s] of a lag; the steps of a simulation must follow it."""
MOST_FACTORS = 4000
_HIGHEST_POWER = 12
"""Most factors of all terms of a polynomial; an export writes each of them."""
ABSURD = 1e4
"""Factor between a parameter of the set `nominal` and one that no joint has."""
TEXT = "text"
"""Stands where a unit would, for texts and for decisions."""
_BESIDE = {
    "settings_json": "settings of the fit, as JSON",
    "choice_json": "how held-out training data chose, with intervals and the ablation, as JSON",
    "headline": "name of the model that the settings put first, or that held-out training data chose",
    "units": "SI unit of displacement q, inputs v, time t",
}
"""Entries beside the models."""


@dataclass(frozen=True)
class Unit:
    """Unit of the numbers of a field, as an annotation of it: {q}, {v} stand for those of displacement and inputs; {F},
    {c}, {d}, {g} for those of force, stiffness, damping, gain; {m} for that of the mass.
    """

    symbol: str


@dataclass(frozen=True)
class Table:
    """An array of real numbers, as the annotation of a field.

    Attributes
    ----------
    shape : str
        A letter for each axis, or its length: ``"R M"``. Axes of one letter are equally long.
    least, most : float
        Range of the entries.
    whole : bool
        True if they are integers.
    """

    shape: str
    least: float = -LARGEST
    most: float = LARGEST
    whole: bool = False

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> Any:
        return PlainValidator(self._checked).__get_pydantic_core_schema__(source, handler)

    def _checked(self, value: Any) -> Any:
        """The array with contiguous rows, as float64 or int64."""
        if not isinstance(value, np.ndarray | list | tuple):
            raise ValueError(f"is no table but {type(value).__name__}")
        array = np.asarray(value)
        if array.dtype.kind not in ("iu" if self.whole else "iuf"):
            raise ValueError(f"holds {array.dtype} instead of {'whole' if self.whole else 'real'} numbers")
        if array.ndim != len(self.shape.split()):
            raise ValueError(f"has {array.ndim} axes instead of {len(self.shape.split())}")
        if array.size and not (array.min() >= self.least and array.max() <= self.most):  # so is a NaN refused
            raise ValueError(f"holds numbers outside {self.least:g} to {self.most:g}, or values that are not numbers")
        return np.ascontiguousarray(array, dtype=np.int64 if self.whole else np.float64)


def _short(exponents: IntArray) -> IntArray:
    if exponents.sum() > MOST_FACTORS:
        raise ValueError(f"has more than {MOST_FACTORS} factors")
    return exponents


def _rising(values: FloatArray) -> FloatArray:
    if not np.all(np.diff(values) > 0.0):
        raise ValueError("does not rise")
    return values


Exponents = Annotated[IntArray, Table("P X", 0, _HIGHEST_POWER, whole=True), AfterValidator(_short)]
"""Powers of X variables in P terms."""
PositiveRow = Annotated[FloatArray, Table("X", 1.0 / LARGEST)]
Rising = Annotated[FloatArray, Table("M"), AfterValidator(_rising)]
Span = Annotated[FloatArray, Table("2"), AfterValidator(_rising)]


_VALUES: TypeAdapter[dict[str, float]] = TypeAdapter(dict[str, Real])


def _set_of(values: Any) -> Any:
    """The parameter set of its values by name, which are all there and of no absurd size."""
    if isinstance(values, JointParameters):
        return values
    numbers = _VALUES.validate_python(values, strict=True)
    if numbers.keys() != set(VECTOR_NAMES):
        raise ValueError("does not hold the parameters of this version")
    for name, value in numbers.items():
        usual = abs(NOMINAL.value(name)) or 1.0
        low = usual / ABSURD if QUANTITIES[name].sign == "positive" else -usual * ABSURD
        if not low <= value <= usual * ABSURD:
            raise ValueError(f"{name} = {value:g} is no size of a joint")
    try:
        return NOMINAL.with_values(numbers)
    except InputError as error:
        raise ValueError(str(error)) from error


JointSet = Annotated[JointParameters, BeforeValidator(_set_of)]
"""Parameters of a joint, in the file their values by name."""


def _si_units(values: Any) -> tuple[str, str]:
    length, voltage = (str(unit) for unit in values)
    if length not in DISPLACEMENT or voltage not in INPUT:
        raise ValueError("are no SI units of a displacement and an input")
    return length, voltage


Units = Annotated[tuple[str, str], BeforeValidator(_si_units)]
"""SI units of displacement and inputs."""


def listed(values: Any) -> Any:
    """An array as a list, for a field that holds a tuple."""
    return values.tolist() if isinstance(values, np.ndarray) else values


def _facts(value: Any, levels: int = _DEEPEST) -> Any:
    """Report of a fit, for readers: a dictionary of texts, numbers, arrays of them, and such dictionaries."""
    if isinstance(value, Mapping):
        if not levels or len(value) > _MOST_FACTS:
            raise ValueError("is nested too deeply or has too many entries")
        return {str(key): _facts(entry, levels - 1) for key, entry in value.items()}
    if isinstance(value, str) and len(value) > _LONGEST_TEXT:
        raise ValueError("holds a text that is too long")
    known = isinstance(value, str | bool | int | float | np.ndarray | np.generic | list | tuple)
    if not known or np.asarray(value).dtype.kind not in "biufU":
        raise ValueError("holds something else than texts and numbers")
    return value


Facts = Annotated[dict[str, Any], BeforeValidator(_facts)]


STORED = ConfigDict(extra="forbid", arbitrary_types_allowed=True, allow_inf_nan=False, use_attribute_docstrings=True)
"""Configuration of a class that declares a part of a file."""
PartT = TypeVar("PartT")


def fitting(part: PartT) -> PartT:
    """The part, axes of one letter being equally long and within the `sizes` of its class.

    Raises
    ------
    ValueError
        An axis has another length.
    """
    kind: Any = type(part)
    sizes: Sizes = getattr(kind, "sizes", {})
    lengths: dict[str, tuple[int, str]] = {}
    for name, field in kind.__pydantic_fields__.items():
        for table in (annotation for annotation in field.metadata if isinstance(annotation, Table)):
            for axis, length in zip(table.shape.split(), getattr(part, name).shape, strict=True):
                expected, where = (
                    (int(axis), "") if axis.isdigit() else lengths.setdefault(axis, (length, f" as {name}"))
                )
                if length != expected:
                    raise ValueError(f"{name} has {length} entries along an axis instead of {expected}{where}")
                least, most = sizes.get(axis, (length, length))
                if not least <= length <= most:
                    raise ValueError(f"{name} has {length} entries along an axis, beyond {least} to {most}")
    return part


def read_part(part: type[PartT], tree: Mapping[str, Any], name: str, command: str) -> PartT:
    """A declared part from its tree, checked.

    Parameters
    ----------
    part : type
        A `ModelFile`, or a dataclass of pydantic with `STORED`.
    tree : mapping
        Contents of the file.
    name : str
        Name of the model.
    command : str
        Command that writes it anew.

    Raises
    ------
    CorruptArtifactError
        An entry is missing, unknown, of another type or shape, or beyond its range.
    """
    try:
        return fitting(TypeAdapter(part).validate_python(dict(tree)))
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False, include_context=False)[0]
        place = ".".join(map(str, first["loc"]))
        reason = f"{place}{': ' if place else ''}{first['msg'].removeprefix('Value error, ')}"
    except ValueError as error:
        reason = str(error)
    raise CorruptArtifactError(f"the model {name} cannot be read ({reason}); run `debist {command}` again")


def tree_of(part: Any) -> dict[str, Any]:
    """Dictionary of arrays, numbers and texts, from which `read_part` restores the part."""
    if isinstance(part, JointParameters):
        return {name: part.value(name) for name in VECTOR_NAMES}
    entries = ((n, getattr(part, n)) for n, field in type(part).__pydantic_fields__.items() if not field.exclude)
    return {name: tree_of(entry) if is_dataclass(entry) else entry for name, entry in entries}


class ModelFile(BaseModel):
    """Entries of a model's file; a subclass names them, and in `sizes` the least and largest length of each axis.

    The text below a field is its line of help; without one that of the class is.
    """

    model_config = ConfigDict(strict=True, frozen=True, **STORED)
    sizes: ClassVar[Sizes] = {}
    diagnostics: Facts = {}

    @model_validator(mode="after")
    def _fit(self) -> Self:
        return fitting(self)

    def to_tree(self) -> dict[str, Any]:
        """The contents as a dictionary of arrays, numbers and texts."""
        return tree_of(self)


_DIAGNOSTICS = {
    "ablation/*": ("1", "RMS error of free runs over the last quarter of each training log, over the range of q"),
    "acceleration_residual": ("1", "RMS of what the equation leaves of the acceleration, over its RMS"),
    "at_bound": (TEXT, "parameters that ended at a bound"),
    "candidate_rms_m": ("{q}", "RMS error of each candidate, on held-out data or coupled to the log"),
    "candidates": (TEXT, "structures that were tried"),
    "candidates_tried": ("1", "number of structures that were tried"),
    "chaotic": (TEXT, "whether neighbouring free runs part exponentially"),
    "chosen": (TEXT, "the structure that was taken"),
    "condition": ("1", "condition number of the regression"),
    "converged": (TEXT, "whether the fit met its tolerance"),
    "corrected": (TEXT, "whether the equations are corrected by basis functions"),
    "correlation": ("1", "correlations of the fitted parameters"),
    "integrated_correlation_time": ("1", "samples over which the residual is correlated"),
    "lag_one": ("1", "correlation of neighbouring residuals"),
    "driven_visits_per_centre": ("1", "training samples around each centre while each input acts"),
    "effort_s": ("s", "processor time of the fit by the cost model"),
    "elements/*": ("{F}", "RMS force of each element along the training logs; 0 where the structure has none"),
    "evaluations": ("1", "simulations of the training logs"),
    "test_function_half_width_s": ("s", "half width of the weak form's test functions"),
    "fitted": (TEXT, "names and units of the fitted parameters"),
    "held_share": (
        "1",
        "share of the training samples near which runs were held, because they would lose the log there",
    ),
    "inner_validation_nrmse": ("1", "free-run NRMSE of q on held-out training data"),
    "inner_validation_nrmse_interval": ("1", "95 % interval of its mean over the folds"),
    "inner_validation_nrmse_of_folds": ("1", "the same of each fold"),
    "lag_converged": (TEXT, "whether the search for T_z met its tolerance"),
    "lag_iterations": ("1", "iterations of the search for T_z"),
    "lag_search/condition": ("1", "condition number of the regression at each accepted T_z"),
    "lag_search/cost": ("{F}²", "half the mean squared residual at each accepted T_z"),
    "lag_search/lag_s": ("s", "T_z of each accepted step of the search"),
    "lag_search/rank": ("1", "rank of the regression at each accepted T_z"),
    "levels/converged": (TEXT, "whether the fit at each observer gain met its tolerance"),
    "levels/gain": ("1", "observer gain of each fit, over the frequency scale; 0 in free run"),
    "levels/iterations": ("1", "iterations of each fit"),
    "levels/observer_pole_1_per_s": ("1/s", "pole of the observer of each fit; 0 in free run"),
    "levels/rms": ("1", "RMS error of each fit over half the range of q"),
    "levels/rms_m": ("{q}", "RMS error of each fit"),
    "library": (TEXT, "the terms that were offered"),
    "library_terms": ("1", "number of terms that were offered"),
    "optimizer": (TEXT, "optimiser of the sparse regression"),
    "parameters": ("1", "number of weights"),
    "rank": ("1", "rank of the regression"),
    "reached_free_run": (TEXT, "whether the last fit was in free run"),
    "residual_correlation_samples": ("1", "samples over which the residual is correlated"),
    "residual_lag_one": ("1", "correlation of neighbouring residuals"),
    "residual_rms": ("{F}", "RMS of the force that the regression leaves"),
    "rmse_windows_m": ("{q}", "RMS error over the windows of the calibration"),
    "samples": ("1", "training samples"),
    "search_complete": (TEXT, "whether the search over structures ended within the time limit"),
    "search_status": (TEXT, "whether the search was completed"),
    "standard_errors": ("SI", "standard errors of the fitted parameters"),
    "terms_kept": ("1", "number of terms of the equation"),
    "threshold_of_rms_acceleration": ("1", "threshold of the sparse regression, over the RMS acceleration"),
    "training_rms_m": ("{q}", "RMS error over the training logs"),
    "values": ("SI", "fitted values"),
    "visits_per_centre": ("1", "training samples around each centre"),
}
"""Entries on the course of a fit, for every model."""


def columns_of(device: Device, files: Mapping[str, type[Any]]) -> Columns:
    """Unit and meaning of each entry of a file of models by its path there.

    Parameters
    ----------
    device : Device
        Its units.
    files : mapping of str to type
        The declaration of each group of the file.
    """
    units = {
        "q": device.displacement.symbol,
        "v": device.inputs[0].symbol,
        "m": MASS[device.displacement.symbol] if device.known_mass is not None else "1",
        "c": {"N": "N/m", "N·m": "N·m/rad"}.get(device.curve_units["F"], "1/s²"),
    }
    return partial(column_of, units=units | device.curve_units, files=files)


def column_of(path: str, units: Mapping[str, str], files: Mapping[str, type[Any]]) -> tuple[str, str]:
    """Unit and meaning of one entry of a model file.

    Parameters
    ----------
    path : str
        Path in the file, such as ``rbf-paper/weights``.
    units : dict of str
        SI units: of the displacement (``q``), the inputs (``v``), the mass (``m``), a stiffness (``c``), and those of
        the curves (``F``, ``d``, ``g``; `pipeline.device.device.Device.curve_units`).
    files : mapping of str to type
        The declaration of each group of the file.
    """
    group, *places = path.split("/")
    if group in _BESIDE:
        return TEXT, _BESIDE[group]
    if places[0] == "diagnostics":
        name = "/".join(places[1:])
        columns = (column for pattern, column in _DIAGNOSTICS.items() if fnmatchcase(name, pattern))
        unit, meaning = next(columns, (TEXT, name.replace("_", " ")))
        return unit.format_map(units), meaning
    part: Any = files[group]
    for place in places:
        if place in QUANTITIES:  # of a joint's parameters
            return QUANTITIES[place].unit, QUANTITIES[place].meaning
        field = part.__pydantic_fields__[place]
        help_of_part = part.__doc__ or ""
        part = field.annotation
    stated = next((mark.symbol for mark in field.metadata if isinstance(mark, Unit)), None)
    unit = stated or ("1" if part in (int, float, FloatArray, IntArray) else TEXT)
    return unit.format_map(units), " ".join((field.description or help_of_part).split()).rstrip(".")
