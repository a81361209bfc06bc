"""The headline of a run that chooses by itself, among all that it identified.

A choice before the final fits (`pipeline.models.choose`) does not show that a fit loses its own training logs. Nor does
it show that another model predicts a chaotic device better, whose free runs mean nothing, from a measured state.
"""

from collections.abc import Mapping

import numpy as np

from pipeline.models.base import predictor
from pipeline.models.kind import StoredModel, Training
from pipeline.numerics.metrics import rms
from pipeline.scoring.horizons import SHORTEST_HORIZON, HorizonError, MeasuredPath, horizon_errors
from pipeline.signals.trajectory import Record
from pipeline.units import HORIZONS

LOST = 0.15
"""Error of a free run over the range of its log beyond which a model has lost it; the least that counts as diverged."""

STARTS = 60
"""Restarts along a log from which errors by horizon are taken."""


def headline(models: Mapping[str, StoredModel], training: Training) -> tuple[str, str]:
    """The first of the models, unless another holds a training log that it loses, or is surely better by horizon.

    Parameters
    ----------
    models : mapping of name to StoredModel
        The first is the one that was chosen beforehand.
    training : Training
        What all of them were fitted to.

    Returns
    -------
    str
        Name of the headline.
    str
        Why it is not the first; empty where it is. Cost: a free run of each model over each log, and for a network the
        restarts of two models.
    """
    first = next(iter(models))
    lost = {
        name: max((_lost(model, record) for record in training.records), default=0.0) for name, model in models.items()
    }
    chaotic = bool(models[first].describe().get("chaotic"))
    best = min(lost, key=lambda name: lost[name])
    if lost[first] > LOST >= lost[best]:
        return (
            best,
            f"{first} errs by {_percent(lost[first])} on its own training logs, {best} by {_percent(lost[best])}",
        )
    if first == "rbf":
        own = _by_horizon(models[first], training)
        for name, model in models.items():
            if name != first and (chaotic or lost[name] < lost[first]) and _surely(_by_horizon(model, training), own):
                return name, f"{name} predicts the training logs surely better than {first} after {_times(own)}"
    return first, ""


def _percent(error: float) -> str:
    return f"{100.0 * error:.2g} %" if error < 1.0 else "100 % or more"


def _times(errors: list[HorizonError]) -> str:
    return " and ".join(f"{horizon:g} s" for horizon in sorted({round(error.horizon_s, 3) for error in errors}))


def _lost(model: StoredModel, record: Record) -> float:
    """Error of a free run over the range of q in its log, at most 1: that of one that diverged."""
    v = record.drive if model.fine_voltages else record.v
    run = model.simulate(record.t, v, float(record.q[0]), float(record.qdot[0]))
    error = (run.q - record.q)[record.valid]
    return min(rms(error) / float(np.ptp(record.q[record.valid])), 1.0) if np.isfinite(error).all() else 1.0


def _by_horizon(model: StoredModel, training: Training) -> list[HorizonError]:
    """Errors after the horizons of scores that the samples have, log by log."""
    errors: list[HorizonError] = []
    for record in training.records:
        interval, length = record.interval, float(record.t[-1] - record.t[0])
        times = [time for time, _ in HORIZONS.values() if SHORTEST_HORIZON * interval <= time <= length / 2.0]
        v = record.drive if model.fine_voltages else record.v
        q, speed = (np.where(record.valid, each, np.nan) for each in (record.q, record.qdot))
        path = MeasuredPath(record.t, v, q, speed)
        shared = not model.fine_voltages
        errors += horizon_errors(predictor(model), path, times, joint=False, most_starts=STARTS, shared=shared)
    return errors


def _surely(errors: list[HorizonError], others: list[HorizonError]) -> bool:
    """Whether errors are surely smaller than others somewhere, and surely larger nowhere."""
    pairs = [(a, b) for a, b in zip(errors, others, strict=True) if a.interval and b.interval]
    smaller = any(a.interval.high < b.interval.low for a, b in pairs if a.interval and b.interval)
    larger = any(a.interval.low > b.interval.high for a, b in pairs if a.interval and b.interval)
    return smaller and not larger and all(a.diverged <= b.diverged for a, b in zip(errors, others, strict=True))
