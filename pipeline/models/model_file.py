"""Contents of a model's file: the schema that a reader checks, and the unit and meaning of each entry.

A file is checked in this order: sizes, then shapes that fit each other, then ranges of finite numbers. Compiled code
reads no array that was not checked here. HDF5 keeps unit and meaning as attributes of each array, number and text.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    PlainValidator,
    ValidationError,
    model_validator,
)

from pipeline.device_parameters import NOMINAL, QUANTITIES, VECTOR_NAMES
from pipeline.errors import CorruptArtifactError
from pipeline.numerics.arrays import FloatArray, IntArray

LARGEST = 1e30
"""Largest magnitude of any number; products of a few of them are still finite."""
MOST_INPUTS = 2
_MOST_FACTS, _LONGEST_TEXT, _DEEPEST = 1000, 10_000, 4

Sizes = Mapping[str, tuple[int, int]]
Positive = Annotated[float, Field(ge=1.0 / LARGEST, le=LARGEST)]
Real = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
SHORTEST_LAG, LONGEST_LAG = 1e-4, 10.0
Lag = Annotated[float, Field(ge=SHORTEST_LAG, le=LONGEST_LAG)]
"""Time constant [s] of a lag; the steps of a simulation must follow it."""


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
        Whether they are integers.
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


MOST_FACTORS, _HIGHEST_POWER = 4000, 12
"""Most factors of all terms of a polynomial; an export writes each of them."""
Exponents = Annotated[IntArray, Table("P X", 0, _HIGHEST_POWER, whole=True), AfterValidator(_short)]
"""Powers of X variables in P terms."""
PositiveRow = Annotated[FloatArray, Table("X", 1.0 / LARGEST)]
Rising = Annotated[FloatArray, Table("M"), AfterValidator(_rising)]
Span = Annotated[FloatArray, Table("2"), AfterValidator(_rising)]


def _of_joint(values: dict[str, float]) -> dict[str, float]:
    """Parameters of a joint that are all there and of no absurd size; their signs are checked where a set is made."""
    if values.keys() != set(VECTOR_NAMES):
        raise ValueError("does not hold the parameters of this version")
    for name, value in values.items():
        usual = abs(NOMINAL.value(name)) or 1.0
        low = usual / ABSURD if QUANTITIES[name].sign == "positive" else -usual * ABSURD
        if not low <= value <= usual * ABSURD:
            raise ValueError(f"{name} = {value:g} is no size of a joint")
    return values


ABSURD = 1e4
"""Factor between a parameter of the set `nominal` and one that no joint has."""
JointValues = Annotated[dict[str, Real], AfterValidator(_of_joint)]


def _facts(value: Any, levels: int = _DEEPEST) -> Any:
    """Report of a fit, for people: a dictionary of texts, numbers, arrays of them, and such dictionaries."""
    if isinstance(value, Mapping):
        if not levels or len(value) > _MOST_FACTS:
            raise ValueError("is nested too deeply or has too many entries")
        return {str(key): _facts(entry, levels - 1) for key, entry in value.items()}
    if isinstance(value, str | bool | int | float):
        if isinstance(value, str) and len(value) > _LONGEST_TEXT:
            raise ValueError("holds a text that is too long")
        return value
    if not isinstance(value, np.ndarray | np.generic | list | tuple) or np.asarray(value).dtype.kind not in "biufU":
        raise ValueError("holds something else than texts and numbers")
    return value


Facts = Annotated[dict[str, Any], BeforeValidator(_facts)]


class FilePart(BaseModel):
    """Entries of a file; a subclass names them, and in `sizes` the least and largest length of each axis."""

    model_config = ConfigDict(
        strict=True, frozen=True, extra="forbid", arbitrary_types_allowed=True, allow_inf_nan=False
    )
    sizes: ClassVar[Sizes] = {}

    @model_validator(mode="after")
    def _fit(self) -> Self:
        """Axes of one letter are equally long and within their sizes."""
        lengths: dict[str, tuple[int, str]] = {}
        for name, field in type(self).model_fields.items():
            for table in (annotation for annotation in field.metadata if isinstance(annotation, Table)):
                for axis, length in zip(table.shape.split(), getattr(self, name).shape, strict=True):
                    expected, where = (
                        (int(axis), "") if axis.isdigit() else lengths.setdefault(axis, (length, f" as {name}"))
                    )
                    if length != expected:
                        raise ValueError(f"{name} has {length} entries along an axis instead of {expected}{where}")
                    least, most = self.sizes.get(axis, (length, length))
                    if not least <= length <= most:
                        raise ValueError(f"{name} has {length} entries along an axis, beyond {least} to {most}")
        return self


class ModelFile(FilePart):
    """The tree of a model."""

    diagnostics: Facts = {}

    @classmethod
    def read(cls, tree: Mapping[str, Any], name: str, command: str) -> Self:
        """The tree of the model `name`, checked; `command` writes it anew.

        Raises
        ------
        CorruptArtifactError
            An entry is missing, unknown, of another kind or shape, or beyond its range.
        """
        try:
            return cls.model_validate(dict(tree))
        except ValidationError as error:
            first = error.errors(include_url=False, include_input=False, include_context=False)[0]
            place = ".".join(map(str, first["loc"]))
            reason = f"{place}{': ' if place else ''}{first['msg'].removeprefix('Value error, ')}"
        raise CorruptArtifactError(f"the model {name} cannot be read ({reason}); run `debist {command}` again")

    def to_tree(self) -> dict[str, Any]:
        """The contents as a dictionary of arrays, numbers and texts."""
        return {entry: getattr(self, entry) for entry in type(self).model_fields}


TEXT = "text"
"""Stands where a unit would, for texts and for decisions."""

# {q}, {v}: SI units of displacement and inputs; {F}, {c}, {d}, {g}: of force, stiffness, damping, gain; {m}: of mass.
_SPREAD = "factor S, a row for each entry of theta, of the covariance S Sᵀ of theta"
_COLUMNS = (
    ("settings_json", TEXT, "settings of the fit, as JSON"),
    ("choice_json", TEXT, "how held-out training data chose, with intervals and the ablation, as JSON"),
    ("headline", TEXT, "name of the model that the settings put first, or that held-out training data chose"),
    ("units/?", TEXT, "SI unit of displacement q, inputs v, time t"),
    ("hybrid/basis", "{q}", "first centre, distance of the centres and width σ of the Gaussians of the corrections"),
    ("hybrid/centres", "1", "number of Gaussians of each correction"),
    ("hybrid/largest_voltage_V", "V", "largest voltage of the training logs; held above twice that"),
    ("hybrid/slope_ratio", "1", "slope of the beam at rest over q/l, from which the search for a rest starts"),
    ("hybrid/similarity/origin", "m", "reading of the laser that corresponds to q = 0 of the parameter set"),
    ("*/tube/factor", "1", "half width of the tubes over the spread of the draws"),
    ("*/tube/floor", "{q}", "least spread: the error on the training data"),
    ("*/tube/apart", "{q}", "distance from which on a draw is in another well"),
    ("hybrid/similarity/*", "1", "size of the device over that of the parameter set"),
    ("hybrid/constants", TEXT, "names of the constants of the equations, in order"),
    ("hybrid/deviations", TEXT, "names of the first entries of theta: deviations from the set; weights follow"),
    ("hybrid/prior_std", "SI", "standard deviations of the deviations' priors, in which theta counts"),
    ("hybrid/theta", "1", "fitted parameters in widths of their priors"),
    ("rbf/theta", "1", "fitted parameters in units of the scales"),
    ("*/curve_spread", "1", f"{_SPREAD}, for the bands of the curves; with corrections that are left open"),
    ("*/band_spread", "1", f"{_SPREAD}, as the training data show it"),
    ("rbf-paper/spread", "{c}, {d}, {g}", "factor S of the covariance S Sᵀ of the weights, row by row of weights"),
    ("*/spread", "1", f"{_SPREAD}, from which outcomes are drawn"),
    ("rbf-paper/centres", "{q}", "centres ξ of the basis functions"),
    ("rbf-paper/width", "{q}", "width σ of the basis functions"),
    ("rbf-paper/smoothing", "1", "smoothing factor σ_n: the width over the distance of the centres"),
    ("rbf-paper/weights", "{c}, {d}, {g}", "weights by row: stiffness c, damping d, gain g of each input"),
    ("rbf-paper/basis", TEXT, "basis function"),
    ("*/lag_s", "s", "time constant T_z of the friction state"),
    ("*/mass_kg", "{m}", "moving mass or inertia; 1 if it is unknown, and curves are then per unit mass"),
    ("*/inputs", TEXT, "whether inputs act squared or linear"),
    ("rbf/parameters/scales/volts", "{v}", "largest input of the training logs"),
    ("rbf/parameters/scales/stiffness", "1/s²", "RMS acceleration over half the range of q"),
    ("rbf/parameters/scales/speed", "1/s", "RMS velocity over half the range of q"),
    ("rbf/parameters/scales/*", "{q}", "middle and half of the range of q"),
    ("rbf/parameters/signs", "1", "direction in which each input pushes; 0 if it may change"),
    ("rbf/parameters/law", TEXT, "whether inputs act squared or linear"),
    ("rbf/parameters/structure/rates", "1", "relaxation rates to start from, over the frequency scale"),
    ("rbf/parameters/structure/basis_functions", "1", "Gaussians of each curve"),
    ("rbf/parameters/structure/smoothing", "1", "smoothing factor σ_n: the width over the distance of the centres"),
    ("rbf/parameters/structure/shape_elements", "1", "hidden shapes"),
    ("rbf/parameters/structure/slips", "1", "states of Dahl friction"),
    ("rbf/parameters/structure/*", TEXT, "an element of the structure, see pipeline.models.rbf.structure"),
    ("sindy*/coefficients", "{q}/s, {q}/s²", "coefficients of the monomials of scaled variables: rows of q̇ and q̈"),
    ("sindy*/lag_s", "s", "times of the lag states"),
    ("sindy*/lag_source", "1", "column of the exponents whose variable each lag state follows"),
    ("narx/coefficients", "{q}", "weights of the terms in the next increment of q"),
    ("*/exponents", "1", "powers of the scaled variables, a row for each monomial"),
    ("*/scales", "SI", "scale of each variable: displacement, velocities, inputs"),
    ("*/bounds", "{q}", "smallest and largest displacement, beyond which a run counts as diverged"),
    ("*/units", TEXT, "SI units of displacement and inputs"),
    ("*/name", TEXT, "name of the model"),
    ("narx/structure", "1", "degree, increments, lags of the inputs, number of inputs"),
    ("*/interval_s", "s", "sample interval of the equation"),
    ("*/tolerance", "1", "local error of the integrator, relative to the usual size of each state"),
)
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


def column_of(path: str, units: Mapping[str, str]) -> tuple[str, str]:
    """Unit and meaning of one entry of a model file.

    Parameters
    ----------
    path : str
        Where it lies in the file, such as ``rbf-paper/weights``.
    units : dict of str
        SI units: of the displacement (``q``), the inputs (``v``), the mass (``m``), a stiffness (``c``), and those of
        the curves (``F``, ``d``, ``g``; `pipeline.units.curve_units`).
    """
    group, _, name = path.partition("/")[2].partition("/")
    if group == "parameters" and name in QUANTITIES:
        return QUANTITIES[name].unit, QUANTITIES[name].meaning
    if group == "diagnostics":
        matches = ((pattern, *column) for pattern, column in _DIAGNOSTICS.items() if fnmatchcase(name, pattern))
    else:
        matches = (column for column in _COLUMNS if fnmatchcase(path, column[0]))
    _, unit, meaning = next(matches, ("", TEXT, name.replace("_", " ")))
    return unit.format_map(units), meaning
