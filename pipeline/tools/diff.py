"""Diff: two runs side by side: settings, versions, raw logs, artifacts, scores and curves."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pipeline.runs import layout
from pipeline.runs.run_folder import RunFolder, in_snapshot
from pipeline.tools.artifact_comparison import Comparison, compare_runs

if TYPE_CHECKING:
    from pipeline.device_facts.run_data import RunData

ScoreKey = tuple[str, str, str, str]
"""Role, log, model and signal."""


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
