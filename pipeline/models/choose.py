"""Which model a device gets: the joint's equations with corrections, or the RBF network from data alone.

A parameter set may be of another joint than the one on the rig. Then the hybrid joint does not follow its own training
logs, and both kinds of model must prove themselves on what they have not seen.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.models.kind import StoredModel, Training
from pipeline.signals.record import Record

FOLLOWS = 0.01
"""Share of the operating range: a hybrid joint that leaves a smaller free-run error on its training logs is taken."""

INNER = 0.75
"""Share of each training log on which both are fitted when they are compared on the rest."""

Fit = Callable[[Training], StoredModel]


@dataclass(frozen=True)
class Choice:
    """The chosen model, and why.

    Attributes
    ----------
    model : StoredModel
    reason : str
        One line.
    held_out : dict of str to float
        Error on held-out training data by candidate, a share of the operating range; empty if none was judged.
    """

    model: StoredModel
    reason: str
    held_out: dict[str, float]

    def to_json(self) -> dict[str, Any]:
        """What is recorded of the choice."""
        return {"chosen": self.model.name, "reason": self.reason, "held_out_error": self.held_out}


def choose(training: Training, hybrid: Fit, rbf: Fit) -> Choice:
    """The hybrid joint where it follows the training logs, else whichever predicts their last quarters better.

    Parameters
    ----------
    training : Training
        Training logs.
    hybrid, rbf : callable
        Identify the candidates.

    Returns
    -------
    Choice
        Cost: one identification; four if the hybrid joint does not follow.
    """
    try:
        model = hybrid(training)
    except DataRefusedError:
        return Choice(rbf(training), "no simulation of the joint's equations follows the training logs", {})
    error = _free_run_error(model, training.records, 0.0)
    if error < FOLLOWS:
        return Choice(model, f"follows the training logs within {100.0 * error:.2f} % of the range", {})
    held_out = {"hybrid": _judged(hybrid, training), "rbf": _judged(rbf, training)}
    best = model if held_out["hybrid"] <= held_out["rbf"] else rbf(training)
    return Choice(best, "smaller error on the held-out last quarters of the training logs", held_out)


def _judged(identify: Fit, training: Training) -> float:
    """Error over the last quarters of a model identified before them; infinite if none could be identified."""
    early = tuple(record.part(0, round(INNER * len(record.t))) for record in training.records)
    try:
        model = identify(replace(training, records=early))
    except DataRefusedError:
        return float("inf")
    return _free_run_error(model, training.records, INNER)


def _free_run_error(model: StoredModel, records: Sequence[Record], after: float) -> float:
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
