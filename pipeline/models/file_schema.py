"""What the file of a model must hold: sizes first, then shapes that fit each other, then ranges of finite numbers.

Whoever wrote the file, compiled code reads no array that was not checked here.
"""

from collections.abc import Mapping
from dataclasses import dataclass
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

from pipeline.errors import CorruptArtifactError
from pipeline.joint.parameters import NOMINAL, QUANTITIES, VECTOR_NAMES
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
            raise ValueError(f"holds numbers outside {self.least:g} to {self.most:g}, or that are none")
        return np.ascontiguousarray(array, dtype=np.int64 if self.whole else np.float64)


def _lag(value: float) -> float:
    if 0.0 < value < SHORTEST_LAG:
        raise ValueError(f"is shorter than {SHORTEST_LAG:g} s")
    return value


def _short(exponents: IntArray) -> IntArray:
    if exponents.sum() > MOST_FACTORS:
        raise ValueError(f"has more than {MOST_FACTORS} factors")
    return exponents


def _rising(values: FloatArray) -> FloatArray:
    if not np.all(np.diff(values) > 0.0):
        raise ValueError("does not rise")
    return values


MOST_FACTORS, _HIGHEST_POWER = 4000, 12
"""Of all terms of a polynomial together; an export writes each of them."""
Exponents = Annotated[IntArray, Table("P X", 0, _HIGHEST_POWER, whole=True), AfterValidator(_short)]
"""Powers of X variables in P terms."""
PositiveRow = Annotated[FloatArray, Table("X", 1.0 / LARGEST)]
LagIfAny = Annotated[float, Field(ge=0.0, le=LONGEST_LAG), AfterValidator(_lag)]
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
    """How a fit went, for people: a dictionary of texts, numbers, arrays of them, and such dictionaries."""
    if isinstance(value, Mapping):
        if not levels or len(value) > _MOST_FACTS:
            raise ValueError("is nested too deeply or has too many entries")
        return {str(key): _facts(each, levels - 1) for key, each in value.items()}
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
            for table in (each for each in field.metadata if isinstance(each, Table)):
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
