"""Differences between two runs, and how far apart two artifacts are."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from pipeline.runs.hashing import rounded_digest, rounding_unit

DIGITS = 6
"""Decimal digits, of the largest magnitude of a column, to which results are compared."""

State = Literal["equal", "rounded", "close", "differs", "drawn", "missing"]
STATES: dict[State, str] = {
    "equal": "same content hash",
    "rounded": f"same hash when rounded to {DIGITS} digits of the largest magnitude of each column",
    "close": f"within one unit of the digit number {DIGITS} of the largest magnitude, on two sides of a rounding edge",
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


@dataclass(frozen=True)
class Change:
    """What stands under one key in each run; None where a run has no such key."""

    key: str
    values: tuple[Any, ...]


@dataclass(frozen=True)
class RunDifferences:
    """Any number of runs side by side.

    Attributes
    ----------
    names : tuple of str
        What the runs are called here: folder names, or paths where some of those are equal.
    settings, versions, sources, scores, facts : tuple of Change
        Keys of the settings, packages, raw logs (SHA-256), NRMSE of free runs (fractions; log, model and signal), and
        facts of the device (SI) that differ, the last two by more than rounding.
    artifacts : tuple of tuple of Comparison
        Every artifact of each run after the first, beside the first; equal ones too.
    """

    names: tuple[str, ...]
    settings: tuple[Change, ...]
    versions: tuple[Change, ...]
    sources: tuple[Change, ...]
    scores: tuple[Change, ...]
    facts: tuple[Change, ...]
    artifacts: tuple[tuple[Comparison, ...], ...]

    @property
    def equal(self) -> bool:
        """Whether nothing differs by more than rounding but the page and the figures of numbers that do not."""
        changed = self.settings or self.versions or self.sources
        states = {comparison.state for of_run in self.artifacts for comparison in of_run}
        return not changed and states <= {"equal", "rounded", "close", "drawn"}


def changes(runs: Sequence[Mapping[str, Any]]) -> tuple[Change, ...]:
    """The keys whose values are not equal in all runs; numbers are equal up to `DIGITS` digits."""
    rows = [
        Change(key, tuple(run.get(key) for run in runs)) for key in dict.fromkeys(key for run in runs for key in run)
    ]
    return tuple(row for row in rows if any(not _same(row.values[0], value) for value in row.values[1:]))


def _same(first: Any, other: Any) -> bool:
    if isinstance(first, float) and isinstance(other, float):
        return math.isclose(first, other, rel_tol=10.0 ** (1 - DIGITS))
    return bool(first == other)


def plain_numbers(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Columns with nulls as floats, where they hold numbers."""
    if values.dtype.kind != "O":
        return values
    if all(value is None or isinstance(value, int | float) for value in values.reshape(-1)):
        return np.array([np.nan if value is None else value for value in values.reshape(-1)], dtype=np.float64)
    return values.astype(str)


def compared_columns(
    name: str, first: Mapping[str, np.ndarray[Any, Any]], second: Mapping[str, np.ndarray[Any, Any]]
) -> Comparison:
    """Compare the content of an artifact in two runs, by column or path."""
    if first.keys() != second.keys() or any(first[c].shape != second[c].shape for c in first):
        return Comparison(name, "differs")
    deviations = {column: _deviation(first[column], second[column]) for column in first}
    worst = max(deviations, key=lambda column: deviations[column])
    if all(rounded_digest(first[c], DIGITS) == rounded_digest(second[c], DIGITS) for c in first):
        return Comparison(name, "rounded", deviations[worst], worst)
    state: State = "close" if all(_within_a_unit(first[c], second[c]) for c in first) else "differs"
    return Comparison(name, state, deviations[worst] if np.isfinite(deviations[worst]) else None, worst)


def _deviation(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> float:
    """Largest difference over the largest magnitude; infinite where what is no number differs."""
    apart, largest = _apart(first, second)
    return apart / largest if largest else (np.inf if apart else 0.0)


def _within_a_unit(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> bool:
    """Whether two columns differ by no more than rounding to `DIGITS` may move a number."""
    apart, largest = _apart(first, second)
    return apart <= rounding_unit(max(largest, _apart(second, first)[1]), DIGITS)


def _apart(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> tuple[float, float]:
    """Largest difference, infinite where what is no number differs, and largest magnitude."""
    if first.dtype.kind not in "fiub" or second.dtype.kind not in "fiub":
        return (0.0 if np.array_equal(first, second) else np.inf), 0.0
    a, b = first.astype(np.float64), second.astype(np.float64)
    if not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return np.inf, 0.0
    finite = np.isfinite(a)
    largest = float(np.max(np.abs(a[finite]), initial=0.0))
    return float(np.max(np.abs(a[finite] - b[finite]), initial=0.0)), largest
