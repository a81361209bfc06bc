"""Diff: runs side by side: settings, versions, raw logs, scores, facts of the device and artifacts."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.names import log_title
from pipeline.runs import layout
from pipeline.runs.comparison import Comparison, RunDifferences, changes, compared_columns, plain_numbers
from pipeline.runs.hashing import flatten
from pipeline.runs.run_folder import RunFolder, in_snapshot


def compare_runs(root: Path, other: Path) -> list[Comparison]:
    """Compare the content of every artifact of two runs.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    return in_snapshot(root, lambda first: in_snapshot(other, lambda second: _comparisons(first, second)))


def _comparisons(first: RunFolder, second: RunFolder) -> list[Comparison]:
    names = sorted(first.manifest.artifacts.keys() | second.manifest.artifacts.keys())
    return [_compare(first, second, name) for name in names]


def _compare(first: RunFolder, second: RunFolder, name: str) -> Comparison:
    if not all(name in run.manifest.artifacts for run in (first, second)):
        return Comparison(name, "missing")
    if first.record(name).content_hash == second.record(name).content_hash:
        for run in (first, second):
            run.checked(name)
        return Comparison(name, "equal", 0.0)
    columns = [_columns(run, name) for run in (first, second)]
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


def diff_runs(roots: Sequence[Path]) -> RunDifferences:
    """Compare runs, each as it is at one time, with the first of them.

    Raises
    ------
    DebistError
        One of the folders holds no run, or an artifact that must be read is damaged.
    """
    alone = len({root.name for root in roots}) == len(roots)
    facts = [in_snapshot(root, _facts) for root in roots]
    different = {part: changes([run[part] for run in facts]) for part in facts[0]}
    artifacts = tuple(tuple(compare_runs(roots[0], root)) for root in roots[1:])
    return RunDifferences(tuple(root.name if alone else str(root) for root in roots), **different, artifacts=artifacts)


def _facts(run: RunFolder) -> dict[str, dict[str, Any]]:
    """What is compared of a run, by the attributes of `RunDifferences`."""
    manifest, prototype = run.manifest, run.prototype
    logs = {log_title(role, name): layout.record(role, name) for role, name, _ in layout.logs(prototype)}
    there = {log: manifest.artifacts[name].recipe.inputs for log, name in logs.items() if name in manifest.artifacts}
    rows = run.read_records(layout.SCORES) if layout.SCORES in manifest.artifacts else []
    sheet = json.loads(run.read_bytes(layout.DATASHEET)) if layout.DATASHEET in manifest.artifacts else {"facts": []}
    return {
        "settings": dict(flatten(prototype.model_dump(mode="json"), separator=".")),
        "versions": dict(manifest.versions),
        "sources": {log: ", ".join(inputs.values()) for log, inputs in there.items()},
        "scores": {f"{log_title(r['role'], r['log'])} · {r['model']} · {r['signal']}": r["nrmse"] for r in rows},
        "facts": {f"{fact['key']} [{fact['unit']}]": fact["value"] for fact in sheet["facts"]},
    }
