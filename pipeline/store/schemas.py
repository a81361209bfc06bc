"""What the artifacts of a run hold: the columns of each table, and the kinds of the values in their notes."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from types import GenericAlias
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model

from ..device.device import Device
from ..errors import CorruptArtifactError
from .columns import (
    FLEET_COLUMNS,
    FLEET_FACT_COLUMNS,
    INSTRUMENT_COLUMNS,
    PHI_COLUMN,
    RATE_COLUMNS,
    RECORD_COLUMNS,
    SCORE_COLUMNS,
    STUDY_COLUMNS,
    TUBE_COLUMNS,
    Column,
    Dtype,
)


@dataclass(frozen=True)
class Schema:
    """The columns of one kind of table, in order."""

    kind: str
    columns: tuple[Column, ...]

    def __getitem__(self, key: str) -> Column:
        return next(column for column in self.columns if column.key == key)


RECORD = Schema("record", RECORD_COLUMNS)
SIGNALS = Schema("signals", RECORD_COLUMNS)
KINEMATICS = Schema("kinematics", (*RECORD_COLUMNS, *RATE_COLUMNS))
PREDICTIONS = Schema("predictions", (*RECORD_COLUMNS[:2], *RATE_COLUMNS, *TUBE_COLUMNS, PHI_COLUMN))
SCORES = Schema("scores", SCORE_COLUMNS)
INSTRUMENTS = Schema("instruments", INSTRUMENT_COLUMNS)
FLEET = Schema("fleet", FLEET_COLUMNS)
FLEET_FACTS = Schema("fleet-facts", FLEET_FACT_COLUMNS)
STUDIES = {study: Schema(f"study-{study}", columns) for study, columns in STUDY_COLUMNS.items()}
"""The tables of the studies."""


def schema_of(schema: Schema, device: Device, *, phi: bool = False, tubes: bool = False) -> Schema:
    """The schema with a device's units and inputs, see `resolve`."""
    inputs = tuple(unit.symbol for unit in device.inputs)
    velocity = device.velocity is not None
    return resolve(
        schema, displacement=device.displacement.symbol, inputs=inputs, phi=phi, velocity=velocity, tubes=tubes
    )


def resolve(
    schema: Schema, *, displacement: str, inputs: tuple[str, ...], phi: bool = False, velocity: bool = False,
    tubes: bool = False,
) -> Schema:  # fmt: skip
    """The schema for a device: its units filled in; second input, φ, measured velocity, tubes left out if absent."""
    absent = {"v2": len(inputs) < 2, "phi": not phi, "velocity": not velocity}
    absent |= dict.fromkeys((column.key for column in TUBE_COLUMNS), not tubes)
    units = {"{q}": displacement, "{v}": inputs[0], "{v2}": inputs[-1]}
    columns = []
    for column in schema.columns:
        if absent.get(column.key):
            continue
        unit = column.unit
        for mark, symbol in units.items():
            unit = unit.replace(mark, symbol)
        columns.append(replace(column, unit=unit))
    return Schema(schema.kind, tuple(columns))


_KINDS = {"float64": "f", "int32": "i", "int64": "iO", "string": "O", "bool": "O"}
"""Kinds of the arrays in which a column is read: of numbers, or of objects where values are texts or may be null."""
_ENTRIES: dict[str, tuple[type, ...]] = {"string": (str,), "bool": (bool,), "int64": (int,)}
_OPTIONAL = ("v2", "phi", "velocity", *(column.key for column in TUBE_COLUMNS))
_OF_FILES = (
    ("*/*/record.parquet", RECORD),
    ("*/*/signals.parquet", SIGNALS),
    ("*/*/kinematics.parquet", KINEMATICS),
    ("*/*/predictions/*.parquet", PREDICTIONS),
    ("scores.parquet", SCORES),
    ("instruments.parquet", INSTRUMENTS),
    ("studies/folds/*.parquet", STUDIES["folds"]),
    *((f"studies/{study}.parquet", schema) for study, schema in STUDIES.items()),
)


def misfit(name: str, table: Mapping[str, np.ndarray[Any, Any]]) -> str | None:
    """What a table that was read from the artifact `name` holds or lacks otherwise than its schema; None if nothing."""
    schema = next((schema for pattern, schema in _OF_FILES if fnmatchcase(name, pattern)), None)
    if schema is None:
        return next(
            (f"{column} does not hold numbers" for column, x in table.items() if x.dtype.kind not in "biuf"), None
        )
    columns = {column.key: column for column in schema.columns}
    if unknown := sorted(table.keys() - columns.keys()):
        return f"holds a column {unknown[0]!r} that no {schema.kind} has"
    for column in columns.values():
        if column.key not in table:
            if column.key not in _OPTIONAL:
                return f"lacks the column {column.key}"
            continue
        if not _fits(table[column.key], column.dtype):
            return f"{column.key} does not hold {column.dtype}"
    if "t" in table and schema is not STUDIES["online"]:
        time = table["t"]
        if len(time) < 2 or not np.all(np.isfinite(time)) or not np.all(np.diff(time) > 0.0):
            return "t does not rise from sample to sample"
    return None


def _fits(values: np.ndarray[Any, Any], dtype: Dtype) -> bool:
    if values.dtype.kind not in _KINDS[dtype]:
        return False
    return values.dtype.kind != "O" or all(x is None or type(x) in _ENTRIES[dtype] for x in values)


ADVICE = "restore it, or move the folder away and run again"
Number = float | None
"""JSON has no number that is not finite: null stands for it."""


_AS_WRITTEN = ConfigDict(strict=True, extra="allow", allow_inf_nan=False)
"""Values are not converted; what is not named may be there, as in documents of other versions."""


def kind(**entries: Any) -> Any:
    """The kind of a mapping with these entries; one that is a kind with a default may be missing."""
    fields = {name: entry if isinstance(entry, tuple) else (entry, ...) for name, entry in entries.items()}
    return create_model("Document", __config__=_AS_WRITTEN, **fields)  # type: ignore[call-overload]


def list_of(entry: Any) -> Any:
    """The kind of a list whose entries are of one kind."""
    return GenericAlias(list, entry)


_INTERVAL = kind(low=(Number, None), high=(Number, None))
_HORIZON = kind(horizon_s=(float, 0.0), nrmse=(Number, None), interval=(_INTERVAL | None, None))
_CHOICE = kind(
    chosen=(str, ""), reason=(str, ""), held_out_error=(dict[str, Number], {}),
    excess_of_the_other=(_INTERVAL | None, None),
)  # fmt: skip
_STRETCH = kind(alpha=(Number, None), noise_std=(Number, None), converged=(bool, True))
_NOTES: type[BaseModel] = kind(
    warnings=(list[str], []), accepted=(list[str], []), gaps=(int, 0), raw_rows=(int, 0), raw_step=(float, 0.0),
    method=(str, ""), of=(str, ""), order=(int, 0), interval_s=(float, 0.0), unit_si=(float, 1.0),
    stretches=(list_of(_STRETCH), []), identified=(Annotated[list[str], Field(min_length=1)], ["one"]),
    choice=(_CHOICE | None, None), status=(Literal["ok", "diverged"], "ok"), diverged_at_s=(Number, None),
    basis_functions=(int | None, None), outside_training=(Number, None), processor_time=(dict[str, Number], {}),
    horizons=(GenericAlias(dict, (str, _HORIZON)), {}), outcomes=(kind(ambiguous=(list[bool], [])) | None, None),
)  # fmt: skip
"""Notes of all stages; each artifact has some of them, and those of an older debist may lack what is new."""


class Notes(dict[str, Any]):
    """Notes of an artifact, or a part of them; a missing key is an error.

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
        _NOTES.model_validate(notes)
    except ValidationError as error:
        raise CorruptArtifactError(f"{where}.{first_mistake(error)}") from None
    if notes.get("status") == "diverged" and notes.get("diverged_at_s") is None:
        raise CorruptArtifactError(f"{where}: diverged, but diverged_at_s is null; {ADVICE}")
    return Notes(notes, where)


def first_mistake(error: ValidationError) -> str:
    """The first key whose value is not what it must be, and why."""
    first = error.errors(include_url=False, include_input=False)[0]
    place = ".".join(map(str, first["loc"]))
    reason = f"{first['msg'][0].lower()}{first['msg'][1:]}"
    return f"{place}: {reason}; {ADVICE}" if place else f"damaged ({reason}); {ADVICE}"
