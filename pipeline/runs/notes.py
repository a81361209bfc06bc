"""Notes of artifacts: the kind of every value that is read from them, whoever wrote them."""

from collections.abc import Mapping
from typing import Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from pipeline.errors import CorruptArtifactError

ADVICE = "restore it, or move the folder away and run again"
Number = float | None
"""JSON knows no number that is not finite: null stands for it."""


class _Shape(BaseModel):
    """Values are not converted; what is not named may be there."""

    model_config = ConfigDict(strict=True, extra="allow")


class _Interval(_Shape):
    low: Number = None
    high: Number = None


class _Horizon(_Shape):
    horizon_s: float = 0.0
    nrmse: Number = None
    interval: _Interval | None = None


class _Outcomes(_Shape):
    ambiguous: list[bool] = []


class _Choice(_Shape):
    chosen: str = ""
    reason: str = ""
    held_out_error: dict[str, Number] = {}
    excess_of_the_other: _Interval | None = None


class _Stretch(_Shape):
    alpha: Number = None
    noise_std: Number = None
    converged: bool = True


class _Notes(_Shape):
    """Those of all stages; each artifact has some of them, and those of an older debist may lack what is new."""

    warnings: list[str] = []
    accepted: list[str] = []
    gaps: int = 0
    raw_rows: int = 0
    raw_step: float = 0.0
    method: str = ""
    of: str = ""
    order: int = 0
    interval_s: float = 0.0
    unit_si: float = 1.0
    stretches: list[_Stretch] = []
    identified: list[str] = Field(["one"], min_length=1)
    choice: _Choice | None = None
    status: Literal["ok", "diverged"] = "ok"
    diverged_at_s: Number = None
    basis_functions: int | None = None
    outside_training: Number = None
    processor_time: dict[str, Number] = {}
    horizons: dict[str, _Horizon] = {}
    outcomes: _Outcomes | None = None

    @model_validator(mode="after")
    def _says_when(self) -> Self:
        if self.status == "diverged" and self.diverged_at_s is None:
            raise ValueError("diverged, but diverged_at_s is null")
        return self


class Notes(dict[str, Any]):
    """Notes of an artifact, or a part of them, which must have what is asked of them.

    Parameters
    ----------
    entries : mapping
    where : str
        File and key, for who misses something.
    """

    def __init__(self, entries: Mapping[str, Any], where: str) -> None:
        self._where = where
        super().__init__({key: Notes(e, f"{where}.{key}") if isinstance(e, dict) else e for key, e in entries.items()})

    def __missing__(self, key: str) -> Any:
        raise CorruptArtifactError(f"{self._where}: {key} is missing; move the folder away and run again")


def checked_notes(notes: Mapping[str, Any], where: str) -> Notes:
    """The notes, if every value is of the kind that is read from it; `where` is file and key.

    Raises
    ------
    CorruptArtifactError
        One is not; the text names it.
    """
    try:
        _Notes.model_validate(notes)
    except ValidationError as error:
        raise CorruptArtifactError(f"{where}.{first_mistake(error)}") from None
    return Notes(notes, where)


def first_mistake(error: ValidationError) -> str:
    """The first key whose value is not what it must be, and why."""
    first = error.errors(include_url=False, include_input=False)[0]
    place, reason = ".".join(map(str, first["loc"])), f"{first['msg'][0].lower()}{first['msg'][1:]}"
    return f"{place}: {reason}; {ADVICE}" if place else f"damaged ({reason}); {ADVICE}"
