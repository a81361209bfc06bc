"""Artifact comparison: whether two runs hold the same, and where they do not, how far apart they are."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from pipeline.runs.hashing import flatten, rounded_digest
from pipeline.runs.run_folder import RunFolder

DIGITS = 6
"""Decimal digits, of the largest magnitude of a column, to which results are compared."""

State = Literal["equal", "rounded", "close", "differs", "drawn", "missing"]
STATES: dict[State, str] = {
    "equal": "same content hash",
    "rounded": f"same hash when rounded to {DIGITS} digits of the largest magnitude of each column",
    "close": f"within 10^-{DIGITS} of the largest magnitude, on two sides of a rounding edge",
    "differs": f"further apart than {DIGITS} digits, or of another shape",
    "drawn": "a page or a figure of numbers that are compared elsewhere",
    "missing": "in one of the runs only",
}


@dataclass(frozen=True)
class Comparison:
    """One artifact in two runs.

    Attributes
    ----------
    artifact : str
        Its name.
    state : str
        One of `STATES`.
    deviation : float or None
        Largest difference in a column over the largest magnitude in it; None where no numbers are compared.
    column : str
        The column (or path in a tree) with that deviation.
    """

    artifact: str
    state: State
    deviation: float | None = None
    column: str = ""


def compare_runs(root: Path, other: Path) -> list[Comparison]:
    """Compare the content of every artifact of two runs.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    one, two = RunFolder.open(root), RunFolder.open(other)
    names = sorted(one.manifest.artifacts.keys() | two.manifest.artifacts.keys())
    return [_compare(one, two, name) for name in names]


def _compare(one: RunFolder, two: RunFolder, name: str) -> Comparison:
    if not all(name in run.manifest.artifacts for run in (one, two)):
        return Comparison(name, "missing")
    if one.record(name).content_hash == two.record(name).content_hash:
        return Comparison(name, "equal", 0.0)
    columns = [_columns(run, name) for run in (one, two)]
    if columns[0] is None or columns[1] is None:
        return Comparison(name, "drawn")
    return _compare_columns(name, columns[0], columns[1])


def _columns(run: RunFolder, name: str) -> Mapping[str, np.ndarray[Any, Any]] | None:
    """The numbers and texts of an artifact by column or path; None for pages and figures."""
    if name.endswith(".parquet"):
        return {column: _numbers(values) for column, values in run.read_table(name).items()}
    if name.endswith(".h5"):
        return {path: np.atleast_1d(np.asarray(value)) for path, value in flatten(run.read_tree(name))}
    if name.endswith(".json"):
        return {
            path: np.atleast_1d(_numbers(np.asarray(value)))
            for path, value in flatten(json.loads(run.read_bytes(name)))
        }
    return None


def _numbers(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Columns with nulls as floats, where they hold numbers."""
    if values.dtype.kind != "O":
        return values
    if all(value is None or isinstance(value, int | float) for value in values.reshape(-1)):
        return np.array([np.nan if value is None else value for value in values.reshape(-1)], dtype=np.float64)
    return values.astype(str)


def _compare_columns(
    name: str, one: Mapping[str, np.ndarray[Any, Any]], two: Mapping[str, np.ndarray[Any, Any]]
) -> Comparison:
    if one.keys() != two.keys() or any(one[c].shape != two[c].shape for c in one):
        return Comparison(name, "differs")
    deviations = {column: _deviation(one[column], two[column]) for column in one}
    worst = max(deviations, key=lambda column: deviations[column])
    if all(rounded_digest(one[c], DIGITS) == rounded_digest(two[c], DIGITS) for c in one):
        return Comparison(name, "rounded", deviations[worst], worst)
    state: State = "close" if deviations[worst] <= 10.0**-DIGITS else "differs"
    return Comparison(name, state, deviations[worst] if np.isfinite(deviations[worst]) else None, worst)


def _deviation(one: np.ndarray[Any, Any], two: np.ndarray[Any, Any]) -> float:
    """Largest difference over the largest magnitude; infinite where what is no number differs."""
    if one.dtype.kind not in "fiub" or two.dtype.kind not in "fiub":
        return 0.0 if np.array_equal(one, two) else np.inf
    a, b = one.astype(np.float64), two.astype(np.float64)
    if not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return np.inf
    finite = np.isfinite(a)
    largest = float(np.max(np.abs(a[finite]), initial=0.0))
    apart = float(np.max(np.abs(a[finite] - b[finite]), initial=0.0))
    return apart / largest if largest else (np.inf if apart else 0.0)
