"""Cross-validation on request: models fitted anew without each fold, and run freely over it."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ...device.device import device
from ...device.parameters import JointParameters, parameter_set, parameter_values
from ...diagnostics.characteristics import believed_wells, stable_rests
from ...errors import DataRefusedError, DebistError, InputError
from ...models.model_type import model_type
from ...numerics.arrays import BoolArray
from ...scoring.cross_validation import (
    NRMSE_COLUMNS,
    block_folds,
    fold_score,
    kept_segments,
    log_folds,
    mean_over_folds,
    not_above_lowest,
    signal_ranges,
)
from ...scoring.wells import NoWells, Wells, wells_of
from ...settings.prototype import FILM, Prototype
from ...signals.log import Log
from ...store import layout, schemas
from ...store.atomic import run_lock
from ...store.manifest import TIMES
from ...store.run_folder import RunFolder, Written
from ...store.tables import Table
from ...system.worker_pool import in_processes
from .. import stage_identify as identify
from ..engine import Observer, Task, bring_up_to_date
from ..logs import load_logs, sources
from ..prior_knowledge import known_inputs, prior_knowledge_of
from ..run_models import identified_models
from ..steps.identify import PriorKnowledge, training
from .study import StudyResult, study_result

ALGORITHM = "5"

By = Literal["blocks", "logs"]


@dataclass(frozen=True)
class Folds:
    """Parts of the logs that are held out in turn.

    Attributes
    ----------
    by : {"blocks", "logs"}
        Blocks of time of every log, or whole logs.
    count : int
        Number of folds.
    """

    by: By
    count: int


def run_folds(
    root: Path, observer: Observer, *, by: By = "blocks", folds: int | None = None, models: Sequence[str], jobs: int = 1
) -> StudyResult:
    """Cross-validate models of a run over all its logs; a model that is up to date is not fitted again.

    Writes ``studies/folds/MODEL.parquet`` for each, and all of them as ``studies/folds.parquet`` with the figure
    ``studies/folds.svg``.

    Parameters
    ----------
    root : Path
        Run folder with kinematics.
    observer : Observer
        Receives what is done.
    by : {"blocks", "logs"}
        Parts that are held out.
    folds : int, optional
        5 for blocks, every log once for logs, if left out.
    models : sequence of str
        Those to judge; all models of the run if empty.
    jobs : int
        Processes at a time, one fold each.

    Raises
    ------
    InputError
        Fewer than two folds, more folds than logs, or a model that the run does not have.
    """
    with run_lock(root):
        run = RunFolder.open(root)
        prototype = run.prototype
        parameters = parameter_set(prototype, Path(run.manifest.prototype_file))
        split = _split(prototype, by, folds)
        chosen = _chosen(run, prototype, models)
        tasks = [_task(prototype, parameters, split, model, jobs) for model in chosen]
        bring_up_to_date(run, [*tasks, _joined(prototype, split, chosen)], observer)
        return study_result(run, prototype, "folds", chosen)


def _split(prototype: Prototype, by: By, folds: int | None) -> Folds:
    logs = len(layout.logs(prototype))
    count = folds if folds is not None else (logs if by == "logs" else 5)
    if count < 2:
        raise InputError(f"{count} fold leaves nothing to fit; give --folds 2 or more, or more logs")
    if by == "logs" and count > logs:
        raise InputError(f"there are {logs} logs for {count} folds; lower --folds or use --by blocks")
    return Folds(by, count)


def _chosen(run: RunFolder, prototype: Prototype, models: Sequence[str]) -> tuple[str, ...]:
    fitted = (*identified_models(run, prototype), *prototype.baselines)
    for model in models:
        if model not in fitted:
            raise InputError(f"the run has no model {model!r}; it has {', '.join(fitted)}")
    return tuple(dict.fromkeys(models)) or fitted


def _task(prototype: Prototype, parameters: JointParameters | None, split: Folds, model: str, jobs: int) -> Task:
    settings = {
        "folds": vars(split),
        "model": model,
        "identify": {"algorithm": identify.ALGORITHM, **prototype.identify.model_dump(mode="json", exclude={"models"})},
        "compare": {
            "algorithm": identify.BASELINE_ALGORITHM,
            **prototype.compare.model_dump(mode="json", exclude={"models", "curves"}),
        },
        "plant": prototype.plant.model_dump(mode="json", exclude=FILM),
        "parameters": parameter_values(parameters),
    }
    return Task(
        stage="study",
        title=f"{split.count} folds over {split.by}, {model}",
        algorithm=ALGORITHM,
        settings=settings,
        inputs=(*sources(prototype), *known_inputs(prototype)),
        outputs=(layout.folds(model),),
        work=partial(_work, prototype=prototype, parameters=parameters, split=split, model=model, jobs=jobs),
    )


def _work(
    run: RunFolder, prototype: Prototype, parameters: JointParameters | None, split: Folds, model: str, jobs: int
) -> Mapping[str, Written]:
    logs = load_logs(run, prototype)
    deal = block_folds if split.by == "blocks" else log_folds
    folds_of_rows = deal([log.segment for log in logs], split.count)
    judge = _Judge(
        prototype=prototype,
        parameters=parameters,
        model=model,
        ranges=signal_ranges(_segments(logs)),
        wells=wells_of(logs, plant=device(prototype)),
        prior_knowledge=prior_knowledge_of(run, prototype, parameters),
    )
    dealt = list(zip(logs, folds_of_rows, strict=True))
    cuts = [
        ([_cut(log, rows != fold) for log, rows in dealt], [_cut(log, rows == fold) for log, rows in dealt])
        for fold in range(split.count)
    ]
    results = list(in_processes(judge, cuts, jobs))
    if all(why for _, why, _ in results):
        raise DataRefusedError(f"none of {split.count} folds can be judged: {results[0][1]}; give fewer (--folds)")
    rows = [{"model": model, "fold": k, **row} for k, (row, _, _) in enumerate(results)]
    schema = schemas.schema_of(schemas.STUDIES["folds"], device(prototype))
    columns = {column.key: [row[column.key] for row in rows] for column in schema.columns}
    warnings = [f"fold {k} was refused: {why}" for k, (_, why, _) in enumerate(results) if why]
    notes = {"warnings": warnings, TIMES: {"fit_s": sum(seconds for _, _, seconds in results)}}
    return {layout.folds(model): run.write_table(layout.folds(model), schema, columns, notes)}


def _cut(log: Log, keep: BoolArray) -> Log:
    """The log with all other rows masked."""
    return replace(log, valid=kept_segments(log.segment, keep) >= 0)


@dataclass(frozen=True)
class _Judge:
    """Worker that fits a model to one part of the logs and scores it on the other."""

    prototype: Prototype
    parameters: JointParameters | None
    model: str
    ranges: Mapping[str, float]
    wells: Wells | NoWells
    prior_knowledge: PriorKnowledge

    def __call__(self, cut: tuple[list[Log], list[Log]]) -> tuple[dict[str, Any], str, float]:
        """Row of the table, why the fold was refused (empty if it was not), processor time of the fit [s].

        Parameters
        ----------
        cut : (list of Log, list of Log)
            The logs without the fold, and the fold alone.
        """
        logs = [log for log in cut[0] if np.any(log.valid)]
        held_out = _segments(cut[1])
        samples = sum(len(x.t) for x in held_out)
        began = time.process_time()
        row: dict[str, Any] = dict.fromkeys((*NRMSE_COLUMNS, "well_agreement")) | {"samples": samples}
        if not samples:
            return row | {"status": "empty"}, "it holds no valid sample", 0.0
        try:
            fitted = model_type(self.model).fit(training(logs, self.prototype, self.parameters, self.prior_knowledge))
        except DebistError as error:
            return row | {"status": "refused"}, str(error), time.process_time() - began
        seconds = time.process_time() - began
        rests = stable_rests(fitted, [log.q for log in logs])
        wells = believed_wells(self.wells, self.model, rests, plant=device(self.prototype))
        score = fold_score(fitted, held_out, self.ranges, wells)
        row |= {
            **{key: score.nrmse[signal] for key, signal in NRMSE_COLUMNS.items()},
            "well_agreement": score.well_agreement,
            "status": "diverged" if score.diverged else "ok",
        }
        return row, "", seconds


def _segments(logs: Sequence[Log]) -> list[Log]:
    return [segment for log in logs for segment in log.segments()]


def _joined(prototype: Prototype, split: Folds, models: Sequence[str]) -> Task:
    """All models in one table, with a summary of the folds of each."""
    name = layout.study("folds")

    def work(run: RunFolder) -> Mapping[str, Written]:
        """Join what the models' own tasks wrote."""
        tables = [run.read_table(layout.folds(model)) for model in models]
        columns = {key: [value for table in tables for value in table[key]] for key in tables[0]}
        notes = {**vars(split), "summary": _summary(dict(zip(models, tables, strict=True)))}
        return {
            name: run.write_table(name, schemas.schema_of(schemas.STUDIES["folds"], device(prototype)), columns, notes)
        }

    settings = {"folds": vars(split), "models": list(models)}
    return Task(
        stage="study",
        title="all folds",
        algorithm=ALGORITHM,
        settings=settings,
        inputs=tuple(map(layout.folds, models)),
        outputs=(name,),
        work=work,
    )


def _summary(tables: Mapping[str, Table]) -> list[dict[str, Any]]:
    """Per model the mean over folds of each error with its interval, and whether it is among the lowest."""
    whole = {model: table for model, table in tables.items() if np.isfinite(table["nrmse"]).all()}
    rows = []
    for model in tables:
        row: dict[str, Any] = {"model": model}
        for key in NRMSE_COLUMNS:
            front = not_above_lowest({name: table[key] for name, table in whole.items()})
            mean, band = mean_over_folds(whole[model][key]) if model in whole else (None, None)
            row[key] = mean
            row[f"{key}_low"], row[f"{key}_high"] = (max(0.0, band.low), min(1.0, band.high)) if band else (None, None)
            row[f"{key}_rank"] = ("lowest" if len(front) == 1 else "tied") if model in front and len(whole) > 1 else ""
        agreement = tables[model]["well_agreement"].astype(np.float64)
        row["well_agreement"] = float(agreement.mean()) if np.isfinite(agreement).all() else None
        row["folds"] = [None if np.isnan(value) else float(value) for value in tables[model]["nrmse"]]
        row["diverged"] = int(np.sum(tables[model]["status"] == "diverged"))
        rows.append(row)
    return rows
