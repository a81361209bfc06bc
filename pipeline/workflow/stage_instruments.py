"""Instruments: gains, zeros, delays and clocks of every log, measured by the identified models."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import partial
from typing import Any

import numpy as np

from ..models.base import DynamicModel
from ..models.model_type import model_from_tree
from ..settings.logs import Role
from ..settings.prototype import Prototype
from ..signals.log import Corrections, Log
from ..store import layout, schemas
from ..store.run_folder import RunFolder, Written
from .engine import Task
from .run_contents import corrections, load_motion, sources
from .steps.identify import fitted_parts

ALGORITHM = "10"

Logs = Mapping[tuple[Role, str], Log]
"""Logs by role and name."""


def task(prototype: Prototype, identified: Sequence[str]) -> Task:
    """One task for all logs: the training logs are the reference of each."""
    models = list(dict.fromkeys((identified[0], *(name for name in identified if name == "rbf"))))
    return Task(
        stage="instruments",
        title=", ".join(models),
        algorithm=ALGORITHM,
        settings={
            "models": models,
            "inputs_before": prototype.plant.inputs_before,
            "corrections": {
                f"{role}/{log}": asdict(by) for (role, log), by in corrections(prototype).items() if by.act
            },
        },
        inputs=(layout.MODELS, *sources(prototype)),
        outputs=(layout.INSTRUMENTS,),
        work=partial(_measure, prototype=prototype, models=models),
    )


def _measure(run: RunFolder, prototype: Prototype, models: Sequence[str]) -> Mapping[str, Written]:
    logs = {(role, log): load_motion(run, prototype, role, log) for role, log, _ in layout.logs(prototype)}
    held = [model_from_tree(name, run.read_tree(layout.MODELS, name)) for name in models]
    rows = [row for model in held for row in instrument_rows(model, logs, corrections(prototype))]
    columns = {column.key: [row[column.key] for row in rows] for column in schemas.INSTRUMENTS.columns}
    return {layout.INSTRUMENTS: run.write_table(layout.INSTRUMENTS, schemas.INSTRUMENTS, columns, {})}


def instrument_rows(
    model: DynamicModel, logs: Logs, stated: Mapping[tuple[Role, str], Corrections]
) -> list[dict[str, Any]]:
    """Rows of ``instruments.parquet``: each quantity of each log that can be compared with training logs.

    Parameters
    ----------
    model : DynamicModel
        A fitted model; one that no observer can couple to a log measures nothing.
    logs : mapping of (role, name) to Log
        All logs.
    stated : mapping of (role, name) to Corrections
        Corrections already stated for each of them.
    """
    from ..diagnostics.instruments import SIGNIFICANCE, InstrumentTest, ObservedModel

    if not isinstance(model, ObservedModel):
        return []
    parts = {name: fitted_parts(log) for name, log in logs.items()}
    trained = [log for log in logs if log[0] == "train"]
    instruments = InstrumentTest(model, [parts[log] for log in trained])
    rows = []
    for log in logs:
        if log in trained and len(trained) == 1:
            continue
        reading = instruments.of_training[trained.index(log)] if log in trained else instruments.of(parts[log])
        by = stated[log].then(reading.corrections)
        values = [*by.gains, by.zero, by.gain_q, by.delay, by.clock]  # in the order of the quantities
        measures = zip(instruments.quantities.items(), reading.estimate, reading.standard_error, values, strict=True)
        for (quantity, limit), estimate, error, value in measures:
            measured = bool(np.isfinite(estimate))
            rows.append(
                {
                    "log": log[1],
                    "role": log[0],
                    "model": model.name,
                    "quantity": quantity,
                    "estimate": float(estimate) if measured else None,
                    "standard_error": float(error) if measured else None,
                    "correction": value if measured else None,
                    "limit": limit,
                    "beyond": measured and abs(estimate) > max(SIGNIFICANCE * error, limit),
                    "residual_ratio": reading.residual_ratio if measured else None,
                    "exchanged": reading.exchange,
                    "status": reading.status,
                }
            )
    if len(trained) == 2:  # both measure one difference: an error is beyond its limit only by both
        own = [[row for row in rows if (row["role"], row["log"]) == log] for log in trained]
        for first, second in zip(*own, strict=True):
            first["beyond"] = second["beyond"] = first["beyond"] and second["beyond"]
    return rows
