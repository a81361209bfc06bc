"""Which `rbf` a device with a parameter set gets: the joint's equations with corrections, or a model of the data alone.

A parameter set may be of another joint than the one on the rig. Then the hybrid joint does not follow its own training
logs, and both kinds of model must prove themselves on what they have not seen.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.models.rbf import RbfModel
from pipeline.models.rbf_hybrid import RbfHybridModel
from pipeline.signals.record import Record

FOLLOWS = 0.01
"""Share of the operating range: a hybrid joint that leaves a smaller free-run error on its training logs is taken."""

INNER = 0.75
"""Share of each training log on which both are fitted when they are compared on the rest."""

Rbf = RbfHybridModel | RbfModel


def choose_rbf(
    records: Sequence[Record],
    hybrid: Callable[[Sequence[Record]], RbfHybridModel],
    alone: Callable[[Sequence[Record]], RbfModel],
) -> Rbf:
    """The hybrid joint where it follows the training logs, else whichever predicts their last quarters better.

    Parameters
    ----------
    records : sequence of Record
        Training logs.
    hybrid, alone : callable
        Identify the hybrid joint, and the data-driven one, from records.

    Returns
    -------
    RbfHybridModel or RbfModel
        Its diagnostics hold the held-out errors ``inner_hybrid`` and ``inner_data_alone`` (shares of the operating
        range) if they were compared. Cost: one identification; four if the hybrid joint does not follow.
    """
    try:
        model = hybrid(records)
    except DataRefusedError:
        return alone(records)
    if _free_run_error(model, records, 0.0) < FOLLOWS:
        return model
    judged = {"inner_hybrid": _judged(hybrid, records), "inner_data_alone": _judged(alone, records)}
    best: Rbf = model if judged["inner_hybrid"] <= judged["inner_data_alone"] else alone(records)
    return replace(best, diagnostics={**best.diagnostics, **judged})


def _judged(identify: Callable[[Sequence[Record]], Rbf], records: Sequence[Record]) -> float:
    """Error over the last quarters of a model identified before them; infinite if none could be identified."""
    try:
        model = identify([record.part(0, round(INNER * len(record.t))) for record in records])
    except DataRefusedError:
        return float("inf")
    return _free_run_error(model, records, INNER)


def _free_run_error(model: Rbf, records: Sequence[Record], after: float) -> float:
    """RMS error of q in free runs from the start, over what lies after a share of each log, over its range."""
    errors, low, high = [], np.inf, -np.inf
    for record in records:
        kept = record.valid & (np.arange(len(record.t)) >= round(after * len(record.t)))
        v = record.drive if model.fine_voltages else record.v
        run = model.simulate(record.t, v, float(record.q[0]), float(record.qdot[0]))
        errors.append(run.q[kept] - record.q[kept])
        low, high = min(low, record.q[record.valid].min()), max(high, record.q[record.valid].max())
    error = float(np.sqrt(np.mean(np.concatenate(errors) ** 2)) / (high - low))
    return error if np.isfinite(error) else float("inf")
