"""Contents of the artifacts of a run: the columns of each table, and JSON objects whose keys are all there."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from typing import Any

import numpy as np
from pydantic import ValidationError

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
    """The schema for a device: its units filled in; second input, φ, measured velocity, tubes left out if absent.

    Parameters
    ----------
    schema : Schema
        Columns with marks for units.
    device : Device
        Its units and inputs.
    phi : bool
        With the tip rotation.
    tubes : bool
        With the limits of the tubes.
    """
    inputs = device.input_symbols
    absent = {"v2": len(inputs) < 2, "phi": not phi, "velocity": device.velocity is None}
    absent |= dict.fromkeys((column.key for column in TUBE_COLUMNS), not tubes)
    columns = (
        replace(column, unit=column.unit.format(q=device.displacement.symbol, v=inputs[0], v2=inputs[-1]))
        for column in schema.columns
        if not absent.get(column.key)
    )
    return Schema(schema.kind, tuple(columns))


_KINDS = {"float64": "f", "int32": "i", "int64": "iO", "string": "O", "bool": "O"}
"""Kinds of the arrays in which a column is read: of numbers, or of objects where values are texts or may be null."""
_ENTRIES: dict[str, tuple[type, ...]] = {"string": (str,), "bool": (bool,), "int64": (int,)}
_OPTIONAL = ("v2", "phi", "velocity", *(column.key for column in TUBE_COLUMNS))
_EARLIER = {
    "rise_error_s",
    "rise_error_low_s",
    "rise_error_high_s",
    "settling_error_s",
    "settling_error_low_s",
    "settling_error_high_s",
}
"""Columns of scores that runs of 0.3.0 and before have."""
_OF_FILES = (
    ("*/*/record.parquet", RECORD),
    ("*/*/signals.parquet", SIGNALS),
    ("*/*/kinematics.parquet", KINEMATICS),
    ("*/*/predictions/*.parquet", PREDICTIONS),
    ("scores.parquet", SCORES),
    ("instruments.parquet", INSTRUMENTS),
    *((f"studies/{study}.parquet", schema) for study, schema in STUDIES.items()),
)
_NUMBERS_ALONE = ("curves.parquet", "known-curves.parquet")
"""Tables of measured curves. Those of `study folds`, which is gone, have no schema and are only compared."""


def misfit(name: str, table: Mapping[str, np.ndarray[Any, Any]]) -> str | None:
    """Difference between a table that was read from the artifact `name` and its schema, in words; None if none."""
    schema = next((schema for pattern, schema in _OF_FILES if fnmatchcase(name, pattern)), None)
    if name in _NUMBERS_ALONE:
        return next(
            (f"{column} does not hold numbers" for column, x in table.items() if x.dtype.kind not in "biuf"), None
        )
    if schema is None:
        return None
    columns = {column.key: column for column in schema.columns}
    if unknown := sorted(table.keys() - columns.keys() - _EARLIER):
        return f"holds a column {unknown[0]!r} that no {schema.kind} has"
    for column in columns.values():
        if column.key not in table and column.key not in _OPTIONAL:
            return f"lacks the column {column.key}"
        if column.key in table and not _fits(table[column.key], column.dtype):
            return f"{column.key} does not hold {column.dtype}"
    if "t" in table and schema is not STUDIES["online"]:
        time = table["t"]
        if len(time) < 2 or not np.all(np.isfinite(time)) or not np.all(np.diff(time) > 0.0):
            return "t does not rise from sample to sample"
    return None


def _fits(values: np.ndarray[Any, Any], dtype: Dtype) -> bool:
    kind = values.dtype.kind
    return kind in _KINDS[dtype] and (kind != "O" or all(x is None or type(x) in _ENTRIES[dtype] for x in values))


ADVICE = "restore it, or move the folder away and run again"


class Document(dict[str, Any]):
    """JSON object of a run, or a part of one; a missing key is an error.

    Parameters
    ----------
    entries : mapping
    where : str
        File and key, for whoever misses something.
    remedy : str
        Advice for the user.
    """

    def __init__(
        self, entries: Mapping[str, Any], where: str, remedy: str = "move the folder away and run again"
    ) -> None:
        self._missing = f"is missing; {remedy}"
        self._where = where

        def within(entry: Any, place: str) -> Any:
            """The entry, its objects being documents."""
            if isinstance(entry, list) and entry and isinstance(entry[0], dict):
                return [within(each, f"{place}.{k}") for k, each in enumerate(entry)]
            return Document(entry, place, remedy) if isinstance(entry, dict) else entry

        super().__init__({key: within(entry, f"{where}.{key}") for key, entry in entries.items()})

    def __missing__(self, key: str) -> Any:
        raise CorruptArtifactError(f"{self._where}: {key} {self._missing}")


def first_mistake(error: ValidationError) -> str:
    """The first key whose value is not what it must be, and why."""
    first = error.errors(include_url=False, include_input=False)[0]
    place = ".".join(map(str, first["loc"]))
    reason = f"{first['msg'][0].lower()}{first['msg'][1:]}"
    return f"{place}: {reason}; {ADVICE}" if place else f"damaged ({reason}); {ADVICE}"
