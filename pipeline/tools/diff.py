"""Diff: two runs side by side: settings, versions, raw logs, artifacts, scores and curves."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from pipeline.runs import layout
from pipeline.runs.hashing import flatten, rounded_digest
from pipeline.runs.run_folder import RunFolder, in_snapshot

if TYPE_CHECKING:
    from pipeline.device_facts.run_data import RunData

ScoreKey = tuple[str, str, str, str]
"""Role, log, model and signal."""
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
        """Whether nothing differs but the page and the figures of equal numbers."""
        changed = self.settings or self.versions or self.sources
        return not changed and all(c.state in ("equal", "rounded", "drawn") for c in self.artifacts)


def diff_runs(root: Path, other: Path) -> RunDifference:
    """Compare two runs.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    one, two = (in_snapshot(each, _facts) for each in (root, other))
    names = (root.name, other.name) if root.name != other.name else (str(root), str(other))
    return RunDifference(
        names,
        _changes(one["settings"], two["settings"]),
        _changes(one["versions"], two["versions"]),
        _changes(one["sources"], two["sources"]),
        tuple(compare_runs(root, other)),
        _pairs(one["scores"], two["scores"]),
        (_beyond(one["scores"], two["scores"]), _beyond(two["scores"], one["scores"])),
    )


def write_diff_page(found: RunDifference, root: Path, other: Path, target: Path, *, force: bool = False) -> Path:
    """The comparison as one self-contained page with curves and free runs of both headline models.

    Raises
    ------
    InputError
        A file of others stands there, and no `force`.
    """
    from pipeline.reporting.diff_page import diff_page
    from pipeline.runs.atomic import write_text
    from pipeline.runs.outputs import new_outputs

    page = diff_page(found, in_snapshot(root, _data), in_snapshot(other, _data))
    with new_outputs(target.parent, "diff", force=force, names=(target.name,)) as staged:
        write_text(staged / target.name, page)
    return target


def _facts(run: RunFolder) -> dict[str, Any]:
    manifest = run.manifest
    prototype = run.prototype
    logs = {f"{role}/{name}": layout.record(role, name) for role, name, _ in layout.logs(prototype)}
    known = {log: manifest.artifacts[name].recipe.inputs for log, name in logs.items() if name in manifest.artifacts}
    rows = run.read_records(layout.SCORES) if layout.SCORES in manifest.artifacts else []
    return {
        "settings": _flat(prototype.model_dump(mode="json")),
        "versions": dict(manifest.versions),
        "sources": {log: ", ".join(inputs.values()) for log, inputs in known.items()},
        "scores": {(r["role"], r["log"], r["model"], r["signal"]): r["nrmse"] for r in rows},
    }


def _data(run: RunFolder) -> "RunData":
    from pipeline.loading.report_data import read_run
    from pipeline.stages.scores import scored_models

    prototype = run.prototype
    return read_run(run, prototype, scored_models(run, prototype))


def _flat(tree: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Settings by their path, such as ``ingest.sample_interval``."""
    found: dict[str, Any] = {}
    for key, value in tree.items():
        found |= _flat(value, f"{prefix}{key}.") if isinstance(value, Mapping) else {f"{prefix}{key}": value}
    return found


def _changes(one: Mapping[str, Any], other: Mapping[str, Any]) -> tuple[Change, ...]:
    keys = dict.fromkeys((*one, *other))
    return tuple(Change(key, one.get(key), other.get(key)) for key in keys if one.get(key) != other.get(key))


def _pairs(one: Mapping[ScoreKey, float | None], other: Mapping[ScoreKey, float | None]) -> tuple[ScorePair, ...]:
    return tuple(ScorePair(*key, one[key], other[key]) for key in one if key in other)


def _beyond(one: Mapping[ScoreKey, Any], other: Mapping[ScoreKey, Any]) -> tuple[str, ...]:
    """Models that only the one has."""
    known = {model for _, _, model, _ in other}
    return tuple(dict.fromkeys(model for _, _, model, _ in one if model not in known))
