"""Diff: two runs side by side: settings, versions, raw logs, artifacts, scores and curves."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pipeline.runs import layout
from pipeline.runs.comparison import (
    Change,
    Comparison,
    RunDifference,
    ScorePair,
    compared_columns,
    plain_numbers,
)
from pipeline.runs.hashing import flatten
from pipeline.runs.run_folder import RunFolder, in_snapshot

if TYPE_CHECKING:
    from pipeline.device_facts.run_data import RunData

ScoreKey = tuple[str, str, str, str]
"""Role, log, model and signal."""


def compare_runs(root: Path, other: Path) -> list[Comparison]:
    """Compare the content of every artifact of two runs.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    return in_snapshot(root, lambda one: in_snapshot(other, lambda two: _comparisons(one, two)))


def _comparisons(one: RunFolder, two: RunFolder) -> list[Comparison]:
    names = sorted(one.manifest.artifacts.keys() | two.manifest.artifacts.keys())
    return [_compare(one, two, name) for name in names]


def _compare(one: RunFolder, two: RunFolder, name: str) -> Comparison:
    if not all(name in run.manifest.artifacts for run in (one, two)):
        return Comparison(name, "missing")
    if one.record(name).content_hash == two.record(name).content_hash:
        for run in (one, two):
            run.checked(name)
        return Comparison(name, "equal", 0.0)
    columns = [_columns(run, name) for run in (one, two)]
    if columns[0] is None or columns[1] is None:
        return Comparison(name, "drawn")
    return compared_columns(name, columns[0], columns[1])


def _columns(run: RunFolder, name: str) -> Mapping[str, np.ndarray[Any, Any]] | None:
    """The numbers and texts of an artifact by column or path; None for pages and figures."""
    if name.endswith(".parquet"):
        return {column: plain_numbers(values) for column, values in run.read_table(name).items()}
    if name.endswith(".h5"):
        return {path: np.atleast_1d(np.asarray(value)) for path, value in flatten(run.read_tree(name))}
    if name.endswith(".json"):
        return {
            path: np.atleast_1d(plain_numbers(np.asarray(value)))
            for path, value in flatten(json.loads(run.read_bytes(name)))
        }
    return None


def diff_runs(root: Path, other: Path) -> RunDifference:
    """Compare two runs, each as it is at one time.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    names = (root.name, other.name) if root.name != other.name else (str(root), str(other))
    return in_snapshot(root, lambda one: in_snapshot(other, lambda two: _difference(one, two, names)))


def _difference(first: RunFolder, second: RunFolder, names: tuple[str, str]) -> RunDifference:
    one, two = _facts(first), _facts(second)
    return RunDifference(
        names,
        _changes(one["settings"], two["settings"]),
        _changes(one["versions"], two["versions"]),
        _changes(one["sources"], two["sources"]),
        tuple(_comparisons(first, second)),
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
        "settings": dict(flatten(prototype.model_dump(mode="json"), separator=".")),
        "versions": dict(manifest.versions),
        "sources": {log: ", ".join(inputs.values()) for log, inputs in known.items()},
        "scores": {(r["role"], r["log"], r["model"], r["signal"]): r["nrmse"] for r in rows},
    }


def _data(run: RunFolder) -> "RunData":
    from pipeline.loading.report_data import read_run
    from pipeline.stages.scores import scored_models

    prototype = run.prototype
    return read_run(run, prototype, scored_models(run, prototype))


def _changes(one: Mapping[str, Any], other: Mapping[str, Any]) -> tuple[Change, ...]:
    keys = dict.fromkeys((*one, *other))
    return tuple(Change(key, one.get(key), other.get(key)) for key in keys if one.get(key) != other.get(key))


def _pairs(one: Mapping[ScoreKey, float | None], other: Mapping[ScoreKey, float | None]) -> tuple[ScorePair, ...]:
    return tuple(ScorePair(*key, one[key], other[key]) for key in one if key in other)


def _beyond(one: Mapping[ScoreKey, Any], other: Mapping[ScoreKey, Any]) -> tuple[str, ...]:
    """Models that only the one has."""
    known = {model for _, _, model, _ in other}
    return tuple(dict.fromkeys(model for _, _, model, _ in one if model not in known))
