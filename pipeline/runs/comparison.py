"""What may differ between two runs, and how far apart two artifacts are."""

from collections.abc import Mapping
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
    """What stands under one key in the two runs; None where a run has no such key."""

    key: str
    one: Any
    other: Any


@dataclass(frozen=True)
class ScorePair:
    """The NRMSE (fractions) of one model on one log for one signal; None where it is undefined or not there."""

    role: str
    log: str
    model: str
    signal: str
    one: float | None
    other: float | None

    @property
    def ratio(self) -> float | None:
        """The other's error over the one's."""
        return None if self.one is None or self.other is None or self.one == 0.0 else self.other / self.one


@dataclass(frozen=True)
class RunDifference:
    """Two runs side by side.

    Attributes
    ----------
    names : (str, str)
        What the runs are called here: folder names, or paths where those are equal.
    settings, versions, sources : tuple of Change
        Keys of the settings, packages and raw logs (SHA-256) that differ.
    artifacts : tuple of Comparison
        Every artifact; equal ones too.
    scores : tuple of ScorePair
        Every score of the models that both runs have, on the logs that both have.
    only : (tuple of str, tuple of str)
        Models that only the one run has, and only the other.
    """

    names: tuple[str, str]
    settings: tuple[Change, ...]
    versions: tuple[Change, ...]
    sources: tuple[Change, ...]
    artifacts: tuple[Comparison, ...]
    scores: tuple[ScorePair, ...]
    only: tuple[tuple[str, ...], tuple[str, ...]]

    @property
    def equal(self) -> bool:
        """Whether nothing differs by more than rounding but the page and the figures of numbers that do not."""
        changed = self.settings or self.versions or self.sources
        return not changed and all(c.state in ("equal", "rounded", "close", "drawn") for c in self.artifacts)


def plain_numbers(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Columns with nulls as floats, where they hold numbers."""
    if values.dtype.kind != "O":
        return values
    if all(value is None or isinstance(value, int | float) for value in values.reshape(-1)):
        return np.array([np.nan if value is None else value for value in values.reshape(-1)], dtype=np.float64)
    return values.astype(str)


def compared_columns(
    name: str, one: Mapping[str, np.ndarray[Any, Any]], two: Mapping[str, np.ndarray[Any, Any]]
) -> Comparison:
    """Compare the content of an artifact in two runs, by column or path."""
    if one.keys() != two.keys() or any(one[c].shape != two[c].shape for c in one):
        return Comparison(name, "differs")
    deviations = {column: _deviation(one[column], two[column]) for column in one}
    worst = max(deviations, key=lambda column: deviations[column])
    if all(rounded_digest(one[c], DIGITS) == rounded_digest(two[c], DIGITS) for c in one):
        return Comparison(name, "rounded", deviations[worst], worst)
    state: State = "close" if all(_within_a_unit(one[c], two[c]) for c in one) else "differs"
    return Comparison(name, state, deviations[worst] if np.isfinite(deviations[worst]) else None, worst)


def _deviation(one: np.ndarray[Any, Any], two: np.ndarray[Any, Any]) -> float:
    """Largest difference over the largest magnitude; infinite where what is no number differs."""
    apart, largest = _apart(one, two)
    return apart / largest if largest else (np.inf if apart else 0.0)


def _within_a_unit(one: np.ndarray[Any, Any], two: np.ndarray[Any, Any]) -> bool:
    """Whether two columns differ by no more than rounding to `DIGITS` may move a number."""
    apart, largest = _apart(one, two)
    return apart <= rounding_unit(max(largest, _apart(two, one)[1]), DIGITS)


def _apart(one: np.ndarray[Any, Any], two: np.ndarray[Any, Any]) -> tuple[float, float]:
    """Largest difference, infinite where what is no number differs, and largest magnitude."""
    if one.dtype.kind not in "fiub" or two.dtype.kind not in "fiub":
        return (0.0 if np.array_equal(one, two) else np.inf), 0.0
    a, b = one.astype(np.float64), two.astype(np.float64)
    if not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return np.inf, 0.0
    finite = np.isfinite(a)
    largest = float(np.max(np.abs(a[finite]), initial=0.0))
    return float(np.max(np.abs(a[finite] - b[finite]), initial=0.0)), largest
