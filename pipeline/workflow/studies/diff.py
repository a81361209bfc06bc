"""Runs side by side: settings, versions, raw logs, scores, facts of the device and artifacts."""

import itertools
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ...store import layout
from ...store.hashing import flatten
from ...store.run_folder import RunFolder, in_snapshot
from ...system.names import log_title

DIGITS = 6
"""Decimal digits, of the largest magnitude of a column, to which results are compared."""

State = Literal["equal", "close", "differs", "drawn", "missing"]


@dataclass(frozen=True)
class Comparison:
    """One artifact in two runs.

    Attributes
    ----------
    artifact : str
        Its name.
    state : {"equal", "close", "differs", "drawn", "missing"}
        Of one content hash; within one unit of the last of `DIGITS` digits of the largest magnitude of each column;
        further apart, or of another shape; a page or a figure of numbers that are compared elsewhere; in one run only.
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
    """Values of one key in each run; None where a run has no such key."""

    key: str
    values: tuple[Any, ...]


@dataclass(frozen=True)
class RunDifferences:
    """Any number of runs side by side.

    Attributes
    ----------
    names : tuple of str
        Names of the runs here: folder names, or paths where some of those are equal.
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
        """True if nothing differs by more than rounding, the page and figures of equal numbers apart."""
        states = {comparison.state for of_run in self.artifacts for comparison in of_run}
        return not (self.settings or self.versions or self.sources) and states <= {"equal", "close", "drawn"}


Pairs = Mapping[tuple[str, str], str]
"""Name of the log of another run beside each log of one run, by role and name."""


def _log_contents(run: RunFolder) -> dict[tuple[str, str], str]:
    """Hash of each raw log of a run, by role and name; empty where nothing was read."""
    records = {
        (role, name): run.manifest.artifacts.get(layout.record(role, name))
        for role, name, _ in layout.logs(run.prototype)
    }
    return {log: ", ".join(record.recipe.inputs.values()) if record else "" for log, record in records.items()}


def paired_logs(
    first: Mapping[tuple[str, str], str], second: Mapping[tuple[str, str], str]
) -> dict[tuple[str, str], str]:
    """The logs of a second run beside those of the first: of one role and content, then of one name, then in order."""
    pairs: dict[tuple[str, str], str] = {}
    left = dict(first)
    rules: tuple[Callable[[tuple[str, str], tuple[str, str]], bool], ...] = (
        lambda log, other: bool(second[log]) and second[log] == first[other],
        lambda log, other: log == other,
        lambda log, other: True,
    )
    for fits, log in itertools.product(rules, second):
        if log not in pairs:
            partner = next((other for other in left if other[0] == log[0] and fits(log, other)), None)
            if partner is not None:
                pairs[log] = partner[1]
                del left[partner]
    return pairs


def _called(name: str, pairs: Pairs) -> str:
    """An artifact of the second run by the name that it has in the first."""
    role, _, rest = name.partition("/")
    log, slash, file = rest.partition("/")
    return f"{role}/{pairs[role, log]}/{file}" if slash and (role, log) in pairs else name


def _comparisons(first: RunFolder, second: RunFolder) -> tuple[Comparison, ...]:
    """Compare the content of every artifact of two runs."""
    pairs = paired_logs(_log_contents(first), _log_contents(second))
    others = {_called(name, pairs): name for name in second.manifest.artifacts}
    names = sorted(first.manifest.artifacts.keys() | others.keys())
    return tuple(_compare(first, second, name, others.get(name), pairs) for name in names)


def _compare(first: RunFolder, second: RunFolder, name: str, other: str | None, pairs: Pairs) -> Comparison:
    if other is None or name not in first.manifest.artifacts:
        return Comparison(name, "missing")
    if first.record(name).content_hash == second.record(other).content_hash:
        first.checked(name)
        second.checked(other)
        return Comparison(name, "equal", 0.0)
    columns = _columns(first, name)
    beside = _columns(second, other)
    if columns is None or beside is None:
        return Comparison(name, "drawn")
    if name == layout.SCORES:
        logs = zip(beside["role"], beside["log"], strict=True)
        beside = {**beside, "log": np.array([pairs.get((str(role), str(log)), log) for role, log in logs])}
    return compared_columns(name, columns, beside)


def _columns(run: RunFolder, name: str) -> Mapping[str, np.ndarray[Any, Any]] | None:
    """The numbers and texts of an artifact by column or path; None for pages and figures."""
    if name.endswith(".parquet"):
        return {column: _plain_numbers(values) for column, values in run.read_table(name).items()}
    if name.endswith(".h5"):
        return {path: np.atleast_1d(np.asarray(value)) for path, value in flatten(run.read_tree(name))}
    if name.endswith(".json"):
        return {
            path: np.atleast_1d(_plain_numbers(np.asarray(value)))
            for path, value in flatten(json.loads(run.read_bytes(name)))
        }
    return None


def diff_runs(roots: Sequence[Path]) -> RunDifferences:
    """Compare runs, each as it is at one time, with the first of them.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    alone = len({root.name for root in roots}) == len(roots)
    contents = [in_snapshot(root, _log_contents) for root in roots]
    pairs = [paired_logs(contents[0], of_run) for of_run in contents]  # names of each run's logs in the first run
    facts = [in_snapshot(root, partial(_facts, pairs=of_run)) for root, of_run in zip(roots, pairs, strict=True)]
    different = {part: changes([run[part] for run in facts]) for part in facts[0]}
    return RunDifferences(
        names=tuple(root.name if alone else str(root) for root in roots),
        artifacts=in_snapshot(
            roots[0], lambda run: tuple(in_snapshot(root, partial(_comparisons, run)) for root in roots[1:])
        ),
        **different,
    )


def _facts(run: RunFolder, *, pairs: Pairs) -> dict[str, dict[str, Any]]:
    """Compared facts of a run, by the attributes of `RunDifferences`."""
    manifest = run.manifest

    def title(role: str, log: str) -> str:
        """Title of the log beside the first run."""
        return log_title(role, pairs.get((role, log), log))

    rows = run.read_records(layout.SCORES) if layout.SCORES in manifest.artifacts else []
    sheet = json.loads(run.read_bytes(layout.DATASHEET)) if layout.DATASHEET in manifest.artifacts else {"facts": []}
    return {
        "settings": dict(flatten(run.prototype.model_dump(mode="json"), separator=".")),
        "versions": dict(manifest.versions),
        "sources": {title(*log): content for log, content in _log_contents(run).items() if content},
        "scores": {f"{title(r['role'], r['log'])} · {r['model']} · {r['signal']}": r["nrmse"] for r in rows},
        "facts": {f"{fact['key']} [{fact['unit'].replace('%', '1')}]": fact["value"] for fact in sheet["facts"]},
    }


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


def _plain_numbers(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
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
    state: State = "close" if all(_within_a_unit(first[c], second[c]) for c in first) else "differs"
    return Comparison(name, state, deviations[worst] if np.isfinite(deviations[worst]) else None, worst)


def _deviation(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> float:
    """Largest difference over the largest magnitude; infinite where what is no number differs."""
    apart, largest = _apart(first, second)
    return apart / largest if largest else (np.inf if apart else 0.0)


def _within_a_unit(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> bool:
    """True if two columns differ by no more than rounding to `DIGITS` may move a number."""
    apart, largest = _apart(first, second)
    largest = max(largest, _apart(second, first)[1])
    return apart <= (10.0 ** (np.floor(np.log10(largest)) + 1 - DIGITS) if largest else 0.0)


def _apart(first: np.ndarray[Any, Any], second: np.ndarray[Any, Any]) -> tuple[float, float]:
    """Largest difference, infinite where what is no number differs, and largest magnitude."""
    if first.dtype.kind not in "fiub" or second.dtype.kind not in "fiub":
        return (0.0 if np.array_equal(first, second) else np.inf), 0.0
    a = first.astype(np.float64)
    b = second.astype(np.float64)
    if not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return np.inf, 0.0
    finite = np.isfinite(a)
    largest = float(np.max(np.abs(a[finite]), initial=0.0))
    return float(np.max(np.abs(a[finite] - b[finite]), initial=0.0)), largest
