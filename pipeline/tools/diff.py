"""Diff: runs side by side: settings, versions, raw logs, scores, facts of the device and artifacts."""

import json
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.loading.device import device
from pipeline.loading.held_models import identified_models
from pipeline.loading.run_models import load_run_model
from pipeline.loading.trajectories import training_tables
from pipeline.models.base import HasCurves
from pipeline.names import log_title
from pipeline.numerics.arrays import FloatArray
from pipeline.reporting.several_runs import CURVES, DiffTable, DrawnRun, diff_page
from pipeline.runs import layout
from pipeline.runs.atomic import write_text
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


CURVE_PLACES = 201
"""Places along q at which curves are drawn."""


def write_diff_page(roots: Sequence[Path], names: Sequence[str], tables: Sequence[DiffTable], target: Path) -> None:
    """Write the page of some runs with what differs, their curves and their free runs.

    Raises
    ------
    DebistError
        What is drawn cannot be read, or the page not be written.
    """
    drawn = [in_snapshot(root, partial(_drawn, name)) for root, name in zip(roots, names, strict=True)]
    write_text(target, diff_page(names, tables, drawn))


def _drawn(name: str, run: RunFolder) -> DrawnRun:
    prototype = run.prototype
    plant, q, curves = device(prototype), np.zeros(0), dict[str, FloatArray]()
    headline = identified_models(run, prototype)[0]
    if layout.MODELS in run.manifest.artifacts:
        model, tables = load_run_model(run, prototype), training_tables(run, prototype)
        displacements = np.concatenate([table["q"] for table in tables])
        q = np.linspace(np.nanmin(displacements), np.nanmax(displacements), CURVE_PLACES)
        if isinstance(model, HasCurves):
            curves = {key: curve for key, curve in model.curves(q).items() if key in CURVES}
    units = {key: plant.curve_units["dC" if key.startswith("dC") else key] for key in curves}
    logs = {}
    for role, log, _ in layout.logs(prototype):
        simulated = layout.predictions(role, log, headline)
        if simulated in run.manifest.artifacts:
            source = ", ".join(run.record(layout.record(role, log)).recipe.inputs.values())
            motion, free = run.read_table(layout.kinematics(role, log)), run.read_table(simulated)
            logs[log_title(role, log), source] = motion["t"], motion["q"], free["q"]
    return DrawnRun(name, plant.displacement.symbol, q, curves, units, logs)
