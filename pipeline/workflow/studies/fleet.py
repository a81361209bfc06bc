"""Several runs: a prior from joints of one drawing, and how one device changes from run to run."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

from ...device.device import Device, device
from ...diagnostics.instruments import InstrumentTest, ObservedModel
from ...diagnostics.series import Series, common_stroke, facts_of, facts_over_time, instrument_facts
from ...errors import DataRefusedError, DebistError, InputError
from ...models.base import DynamicModel
from ...models.hybrid.model import HybridModel
from ...models.hybrid.siblings import Learnt, column, learn, to_tree
from ...numerics.arrays import FloatArray
from ...signals.log import Log
from ...store import layout
from ...store.manifest import MANIFEST
from ...store.run_folder import RunFolder, in_snapshot
from ...store.trees import write_tree
from ...system.names import shell_word
from ..prior_knowledge import read_siblings
from ..run_contents import load_logs, load_run_model, model_artifact
from ..steps.identify import fitted_parts


@dataclass(frozen=True)
class LearntFile:
    """A file with the prior of other joints.

    Attributes
    ----------
    path : Path
    siblings : tuple of str
        Their names.
    left_out : dict of str to str
        Runs that were left out, and why.
    learnt : Learnt
    """

    path: Path
    siblings: tuple[str, ...]
    left_out: dict[str, str]
    learnt: Learnt


def learn_siblings(roots: Sequence[Path], output: Path) -> LearntFile:
    """Learn from the `hybrid` of each run, and write the file.

    Parameters
    ----------
    roots : sequence of Path
        Run folders, and folders of batches, which stand for all runs in them.
    output : Path
        The file; one of a prior is replaced, another one is not.

    Raises
    ------
    InputError
        `output` is another file, two runs have one name, or the joints have not one parameter set.
    DataRefusedError
        Too few runs can be learnt from.
    """
    if output.exists():
        read_siblings(output)
    models: dict[str, HybridModel] = {}
    origins: dict[str, str] = {}
    left_out: dict[str, str] = {}
    for root in _runs(roots):
        try:
            name, origin, model = in_snapshot(root, _sibling)
        except DebistError as error:
            left_out[str(root)] = str(error)
            continue
        if name in models:
            raise InputError(f"{root}: a second run of {name!r}; a joint enters once, name one of its runs")
        models[name], origins[name] = model, origin
    try:
        learnt = learn(models)
    except DataRefusedError as error:
        reasons = "".join(f"; left out: {reason}" for reason in left_out.values())
        raise DataRefusedError(f"{error}{reasons}") from None
    write_tree(output, to_tree(learnt, next(iter(models.values())).joint.parameters, origins), column)
    return LearntFile(output, tuple(models), left_out, learnt)


def _runs(roots: Sequence[Path]) -> Iterator[Path]:
    for root in roots:
        inside = [] if (root / MANIFEST).exists() else sorted(path.parent for path in root.glob(f"*/{MANIFEST}"))
        yield from inside or [root]


def _sibling(run: RunFolder) -> tuple[str, str, HybridModel]:
    """Name of the prototype, content hash of its models, and the hybrid one."""
    prototype = run.prototype
    if prototype.plant.siblings is not None:
        raise InputError(f"{run.root}: was identified with a prior of other joints, which would enter twice; omit it")
    model = load_run_model(run, prototype, "hybrid")
    if not isinstance(model, HybridModel):
        raise InputError(f"{run.root}: its hybrid is not a hybrid model")
    return prototype.name, run.record(model_artifact(run, prototype, "hybrid")[1]).content_hash, model


def series_of(roots: Sequence[Path], at: str | None) -> Series:
    """Changes of the facts of one device from run to run.

    Parameters
    ----------
    roots : sequence of Path
        Runs with a datasheet.
    at : str or None
        A date (``2026-03-01``) or a number of days for each run, comma-separated; None: runs are in order.

    Raises
    ------
    InputError
        Fewer than two runs, other than one time for each, two equal times, a run without a datasheet, facts from
        different models, or a run that is there twice.
    """
    if len(roots) < 2:
        raise InputError("a series has at least two runs; name more run folders")
    times = np.arange(1.0, len(roots) + 1.0) if at is None else _times(at, len(roots))
    order = np.argsort(times, kind="stable")
    runs = [in_snapshot(roots[i], _read) for i in order]
    sources = {run.sheet["facts_from"]: roots[i] for run, i in zip(runs, order, strict=True)}
    if len(sources) > 1:
        several = ", ".join(f"{source} ({root})" for source, root in sources.items())
        raise InputError(f"facts come from different models: {several}; name one in [identify] models, and run again")
    for i, run in enumerate(runs):
        if run.sheet["facts"] in [other.sheet["facts"] for other in runs[:i]]:
            raise InputError(f"{roots[order[i]]}: has the facts of another run here; name each recording once")
    ascending = times[order].tolist()
    between = common_stroke([run.sheet for run in runs])
    of_runs = [list(facts_of(r.sheet, r.model, between, r.plant.curve_units["dC"])) for r in runs]
    first = runs[0]
    if isinstance(first.model, ObservedModel):
        instruments = InstrumentTest(first.model, first.training)
        for run, own in zip(runs[1:], of_runs[1:], strict=True):
            parts = [part for of_log in run.training for part in of_log]
            own += instrument_facts(instruments, parts, run.plant.displacement.symbol)
    names = tuple(roots[i].name for i in order)
    return Series(names, tuple(ascending), "run" if at is None else "day", facts_over_time(ascending, of_runs))


@dataclass(frozen=True)
class _Run:
    """Datasheet of a run, the model of its facts, the device, and the parts of its training logs."""

    sheet: dict[str, Any]
    model: DynamicModel
    plant: Device
    training: list[list[Log]]


def _times(text: str, count: int) -> FloatArray:
    entries = [entry.strip() for entry in text.split(",")]
    try:
        times = np.array([float(entry) for entry in entries])
    except ValueError:
        try:
            days = [date.fromisoformat(entry).toordinal() for entry in entries]
        except ValueError:
            raise InputError(f"--at {text}: give dates as 2026-03-01, or numbers of days, comma-separated") from None
        times = np.array(days, dtype=np.float64) - min(days)
    if len(times) != count or len(set(times.tolist())) < count or not np.isfinite(times).all():
        raise InputError(f"--at {text}: {count} runs need {count} different times")
    return times


def _read(run: RunFolder) -> _Run:
    if layout.DATASHEET not in run.manifest.artifacts:
        raise InputError(f"{run.root}: has no datasheet; `debist report {shell_word(run.root)}` makes one")
    sheet = run.read_document(layout.DATASHEET)
    prototype = run.prototype
    if sheet["facts_from"] is None:
        raise InputError(f"{run.root}: no model has curves, so there are no facts to follow; identify hybrid or rbf")
    return _Run(
        sheet=sheet,
        model=load_run_model(run, prototype, sheet["facts_from"]),
        plant=device(prototype),
        training=[fitted_parts(log) for log in load_logs(run, prototype, "train")],
    )
