"""Which model a device gets: the joint's equations with corrections, or the RBF network from data alone.

The joint's equations are a candidate for every device with two squared inputs and two wells. Where they follow the
training logs closely no network from data alone does as well, and none is fitted; else both are fitted to the first
three quarters of the training logs and judged in free run over the rest.
"""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.models.kind import StoredModel, Training
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.kept import kept_under
from pipeline.scoring.intervals import BLOCK, Interval
from pipeline.scoring.ranking import excess_over_lowest
from pipeline.signals.record import Record

CLEAR = 0.003
"""Share of the operating range: a hybrid joint with a smaller free-run error on its training logs is taken. Networks
from data alone leave 0.006 to 0.013 there."""

FAR = 0.01
"""The same: beyond it the network has all of its time when it is judged."""

JUDGED_TIME = 6.0
"""Processor time [s] of a network judged beside a hybrid joint nearer than `FAR`; a winner is fitted in full."""

INNER = 0.75
"""Share of each training log on which both are fitted when they are compared on the rest."""

LOST = 1.0
"""Error that a sample counts at most, a share of the operating range."""

SEED = 0  # of the bootstrap

ABLATION = ("equations_alone", "equations_with_rbf", "rbf_alone")

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
        RMS error on held-out training data by candidate, a share of the operating range; empty if none was judged.
    excess : Interval or None
        95 % interval of how much higher the error of the other candidate is there (paired moving-block bootstrap).
    """

    model: StoredModel
    reason: str
    held_out: dict[str, float]
    excess: Interval | None = None

    def to_json(self) -> dict[str, Any]:
        """What is recorded of the choice.

        ``ablation`` holds errors in free run over the last quarters of the training logs, shares of the operating
        range, as far as they were needed.
        """
        return {
            "chosen": self.model.name,
            "reason": self.reason,
            "held_out_error": self.held_out,
            "excess_of_the_other": None if self.excess is None else asdict(self.excess),
            "basis_functions": self.model.describe().get("basis_functions"),
            "ablation": {**dict.fromkeys(ABLATION), **self._ablation()},
        }

    def _ablation(self) -> dict[str, float]:
        alone = {"rbf_alone": self.held_out["rbf"]} if "rbf" in self.held_out else {}
        return {**getattr(self.model, "diagnostics", {}).get("ablation", {}), **alone}


def choose(training: Training, hybrid: Fit, rbf: Fit) -> Choice:
    """The hybrid joint where it follows the training logs closely, else whichever predicts their last quarters better.

    Parameters
    ----------
    training : Training
        Training logs.
    hybrid, rbf : callable
        Identify the candidates.

    Returns
    -------
    Choice
        Cost: one identification; three or four where the hybrid joint does not follow closely.

    Raises
    ------
    DataRefusedError
        Neither can be identified.
    """
    try:
        model = hybrid(training)
    except DataRefusedError as refused:
        return Choice(rbf(training), f"hybrid is no candidate: {refused}", {})
    error = _rms(_errors(model, training.records, 0.0))
    said = f"{100.0 * error:.2f} % of the range"
    if error < CLEAR:
        return Choice(model, f"the joint's equations follow the training logs within {said}", {})
    limit = training.identify.time_limit if error > FAR else min(training.identify.time_limit, JUDGED_TIME)
    early = replace(
        training,
        records=tuple(record.part(0, round(INNER * len(record.t))) for record in training.records),
        identify=training.identify.model_copy(update={"time_limit": limit}),
    )
    errors: dict[str, FloatArray] = {}
    for name, fit in (("hybrid", hybrid), ("rbf", rbf)):
        judged = replace(early, keep=kept_under(training.keep, f"judged {name}"))
        try:
            errors[name] = _errors(fit(judged), training.records, INNER)
        except DataRefusedError as refused:
            if name == "rbf":
                return Choice(model, f"rbf is no candidate: {refused}", {})
            errors[name] = np.full(1, LOST)
    held_out = {name: _rms(found) for name, found in errors.items()}
    best = model if held_out["hybrid"] <= held_out["rbf"] else rbf(training)
    excess = None
    if len(errors["hybrid"]) == len(errors["rbf"]):
        block = max(1, round(BLOCK / training.records[0].interval))
        excess = next(iter(excess_over_lowest(errors, block, SEED).values()))
    return Choice(best, "smaller error on the held-out last quarters of the training logs", held_out, excess)


def _rms(errors: FloatArray) -> float:
    return float(np.sqrt(np.nanmean(errors**2)))


def _errors(model: StoredModel, records: Sequence[Record], after: float) -> FloatArray:
    """Errors of q in free runs from the start, over what lies after a share of each log, over its range.

    NaN where masked; at most `LOST`, as where the run diverged.
    """
    valid = [record.q[record.valid] for record in records]
    span = max(float(q.max()) for q in valid) - min(float(q.min()) for q in valid)
    errors = []
    for record in records:
        v = record.drive if model.fine_voltages else record.v
        run = model.simulate(record.t, v, float(record.q[0]), float(record.qdot[0]))
        error = np.minimum(np.nan_to_num(np.abs(run.q - record.q), nan=np.inf) / span, LOST)
        errors.append(np.where(record.valid, error, np.nan)[round(after * len(record.t)) :])
    return np.concatenate(errors)
