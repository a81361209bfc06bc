"""Every column of every table a run holds: name, type, unit, meaning. Defined here and nowhere else.

`data/README.md` publishes these tables; a test keeps the two in step.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from typing import Any, Literal

import numpy as np

from pipeline.units import HORIZONS

SCHEMA_VERSION = "1"

Dtype = Literal["float64", "int32", "int64", "string", "bool"]


@dataclass(frozen=True)
class Column:
    """One column of an artifact."""

    name: str
    dtype: Dtype
    unit: str
    meaning: str


@dataclass(frozen=True)
class Schema:
    """The columns of one kind of table, in order."""

    kind: str
    columns: tuple[Column, ...]

    def __getitem__(self, name: str) -> Column:
        return next(column for column in self.columns if column.name == name)


# "{q}" and "{v}" stand for the SI units of displacement and inputs: m or rad, V or whatever the device takes.
_T = Column("t", "float64", "s", "time, on the log's own time base")
_Q = Column("q", "float64", "{q}", "displacement of the joint, positive to the right; NaN where masked")
_V1 = Column("v1", "float64", "{v}", "first input: measured voltage of the left membrane")
_V2 = Column("v2", "float64", "{v2}", "second input: measured voltage of the right membrane")
_VELOCITY = Column("velocity", "float64", "{q}/s", "measured velocity, where there is such a channel")
_SEGMENT = Column("segment", "int32", "1", "number of the gap-free stretch; -1 where the row is masked")
_QDOT = Column("qdot", "float64", "{q}/s", "velocity")
_QDDOT = Column("qddot", "float64", "{q}/s²", "acceleration")
_PHI = Column("phi", "float64", "rad", "tip rotation, from q by kinematics: the static map of the analytical model")

RECORD = Schema("record", (_T, _Q, _V1, _V2, _VELOCITY, _SEGMENT))
SIGNALS = Schema("signals", (_T, _Q, _V1, _V2, _VELOCITY, _SEGMENT))
KINEMATICS = Schema("kinematics", (_T, _Q, _V1, _V2, _VELOCITY, _SEGMENT, _QDOT, _QDDOT))
PREDICTIONS = Schema("predictions", (_T, _Q, _QDOT, _QDDOT, _PHI))


def _horizons() -> Iterator[Column]:
    for name, (_, words) in HORIZONS.items():
        yield Column(f"nrmse_{name}", "float64", "1", f"NRMSE {words} ahead of the measured state (q only)")
        yield from _band(f"nrmse_{name}", "1", "moving-block bootstrap of the restarts")


def _band(of: str, unit: str, how: str) -> tuple[Column, Column]:
    """The columns of an interval, after the number that it belongs to."""
    end = "_s" if unit == "s" else ""
    return (
        Column(f"{of}_low{end}", "float64", unit, f"lower end of its 95 % interval: {how}"),
        Column(f"{of}_high{end}", "float64", unit, "upper end of that interval"),
    )


SCORES = Schema(
    "scores",
    (
        Column("log", "string", "1", "name of the log"),
        Column("role", "string", "1", "train or validation"),
        Column("model", "string", "1", "name of the model"),
        Column("headline", "bool", "1", "whether it is the model that the run is judged by"),
        Column("signal", "string", "1", "q, phi, qdot or qddot"),
        Column(
            "nrmse",
            "float64",
            "1",
            "root mean square error over the measured range (eq. 41); null if undefined",
        ),
        *_band("nrmse", "1", "moving-block bootstrap"),
        Column(
            "above_lowest_low",
            "float64",
            "1",
            "lower end of the 95 % paired bootstrap interval of nrmse less the lowest of that log and signal; "
            "null for the lowest",
        ),
        Column("above_lowest_high", "float64", "1", "upper end of that interval"),
        Column("rmse", "float64", "SI", "root mean square error, in `unit`"),
        Column("unit", "string", "1", "SI unit of the signal"),
        Column("n", "int64", "1", "number of samples compared"),
        Column("status", "string", "1", "ok or diverged"),
        Column("diverged_at_s", "float64", "s", "time at which the free run diverged; null if it did not"),
        Column("well_agreement", "float64", "1", "share of samples with both in the same well (q only)"),
        *_band("well_agreement", "1", "moving-block bootstrap"),
        Column("switch_accuracy", "float64", "1", "share of pulses after which both rest in one well (q only)"),
        *_band("switch_accuracy", "1", "Bayesian bootstrap of the pulses"),
        *_horizons(),
        Column("rise_error_s", "float64", "s", "median error of the rise time of switches (q only)"),
        *_band("rise_error", "s", "bootstrap of the switches"),
        Column("settling_error_s", "float64", "s", "median error of the settling time of switches (q only)"),
        *_band("settling_error", "s", "bootstrap of the switches"),
        Column(
            "outside_training",
            "float64",
            "1",
            "share of samples in states (q, q̇) that no training sample was near (q only)",
        ),
        Column(
            "basis_functions",
            "int64",
            "1",
            "Gaussian basis functions that act in each curve of the model; null for a model without any (q only)",
        ),
        Column("outcomes", "int64", "1", "rests after a pulse that were given a probability for their well (q only)"),
        Column("ambiguous_outcomes", "int64", "1", "those in which neither well has nine tenths of it (q only)"),
    ),
)

FLEET = Schema(
    "fleet",
    (
        Column("prototype", "string", "1", "name of the prototype"),
        Column("exit_code", "int64", "1", "exit code of its run; negative if a signal ended it"),
        Column("reason", "string", "1", "why it failed; empty if it did not"),
        *SCORES.columns,
    ),
)

Sweep = Literal["alpha", "basis", "data", "online"]
"""A study that repeats the fit with something else."""
StudyName = Literal[Sweep, "folds"]
_STUDIES: dict[StudyName, tuple[tuple[str, Dtype, str, str], ...]] = {
    "alpha": (
        ("alpha", "float64", "{q}·s^order", "regularisation parameter"),
        ("misfit", "float64", "{q}", "RMS of record less regularised signal: above the noise, the signal suffers"),
        ("roughness", "float64", "{q}/s²", "mean change of the acceleration from sample to sample"),
    ),
    "basis": (
        ("basis_functions", "float64", "1", "number M of Gaussians per curve"),
        ("smoothing", "float64", "1", "width over distance of the centres, sigma_n"),
        ("mse", "float64", "({q}/s²)²", "mean squared error of the acceleration on the training logs"),
        ("condition", "float64", "1", "condition number of the regressor"),
        ("nrmse", "float64", "1", "free-run NRMSE of q on the other logs, at most 1"),
    ),
    "data": (
        ("samples", "float64", "1", "training samples"),
        ("noise", "float64", "{q}", "standard deviation of the noise added to q"),
        ("nrmse", "float64", "1", "median free-run NRMSE of q on the other logs, at most 1"),
        ("nrmse_low", "float64", "1", "smallest of the repeats"),
        ("nrmse_high", "float64", "1", "largest of the repeats"),
    ),
    "online": (
        ("forgetting", "float64", "1", "forgetting factor λ of the recursive least squares"),
        ("drift", "float64", "1", "share by which the restoring force grows over the log"),
        ("t", "float64", "s", "length of the stream so far"),
        ("curve_error", "float64", "1", "RMS error of the restoring force over its range"),
        ("prediction_error", "float64", "1", "error of the acceleration before each sample, over its RMS"),
    ),
    "folds": (
        ("model", "string", "1", "name of the model"),
        ("fold", "int64", "1", "number of the fold that was left out"),
        ("samples", "int64", "1", "samples of the fold"),
        ("status", "string", "1", "ok, diverged, refused (no fit without the fold) or empty"),
        ("nrmse", "float64", "1", "free-run NRMSE of q on the fold, over the range in all data, at most 1"),
        ("nrmse_qdot", "float64", "1", "that of the velocity"),
        ("nrmse_qddot", "float64", "1", "that of the acceleration"),
        ("well_agreement", "float64", "1", "share of the fold's samples in the right well"),
    ),
}
STUDIES = {
    study: Schema(f"study-{study}", tuple(Column(*column) for column in columns)) for study, columns in _STUDIES.items()
}
"""The tables of the studies."""


def resolve(
    schema: Schema, *, displacement: str, inputs: tuple[str, ...], phi: bool = False, velocity: bool = False
) -> Schema:
    """The schema for a device: its units filled in; second input, φ and measured velocity left out if it has none."""
    absent = {"v2": len(inputs) < 2, "phi": not phi, "velocity": not velocity}
    units = {"{q}": displacement, "{v}": inputs[0], "{v2}": inputs[-1]}
    columns = []
    for column in schema.columns:
        if absent.get(column.name):
            continue
        unit = column.unit
        for mark, symbol in units.items():
            unit = unit.replace(mark, symbol)
        columns.append(replace(column, unit=unit))
    return Schema(schema.kind, tuple(columns))


_KINDS = {"float64": "f", "int32": "i", "int64": "iO", "string": "O", "bool": "O"}
"""Kinds of the arrays in which a column is read: of numbers, or of objects where values are texts or may be null."""
_ENTRIES: dict[str, tuple[type, ...]] = {"string": (str,), "bool": (bool,), "int64": (int,)}
_OPTIONAL = ("v2", "phi", "velocity")
_OF_FILES = (
    ("*/*/record.parquet", RECORD),
    ("*/*/signals.parquet", SIGNALS),
    ("*/*/kinematics.parquet", KINEMATICS),
    ("*/*/predictions/*.parquet", PREDICTIONS),
    ("scores.parquet", SCORES),
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
    columns = {column.name: column for column in schema.columns}
    if unknown := sorted(table.keys() - columns.keys()):
        return f"holds a column {unknown[0]!r} that no {schema.kind} has"
    for column in columns.values():
        if column.name not in table:
            if column.name not in _OPTIONAL:
                return f"lacks the column {column.name}"
            continue
        if not _fits(table[column.name], column.dtype):
            return f"{column.name} does not hold {column.dtype}"
    if "t" in table and schema is not STUDIES["online"]:
        time = table["t"]
        if len(time) < 2 or not np.all(np.isfinite(time)) or not np.all(np.diff(time) > 0.0):
            return "t does not rise from sample to sample"
    return None


def _fits(values: np.ndarray[Any, Any], dtype: Dtype) -> bool:
    if values.dtype.kind not in _KINDS[dtype]:
        return False
    return values.dtype.kind != "O" or all(x is None or type(x) in _ENTRIES[dtype] for x in values)
