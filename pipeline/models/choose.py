"""Choice of the model for a device, the joint's equations or the RBF network, and of the main model of a run.

The joint's equations are a candidate for every device with two squared inputs and two wells. They are fitted to the
first three quarters of the training logs and judged in free run over the rest. Where they predict that as no network
does, none is fitted. Else a network is judged on the same data. It replaces the equations where it is surely nearer to
the rest and no farther from what both were fitted to, and finally no farther from all of the logs.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ..errors import DataRefusedError
from ..numerics.arrays import FloatArray
from ..scoring.cross_validation import free_run_error
from ..scoring.intervals import SEED, Interval, block_of, rms_difference_interval, rms_interval
from ..scoring.scores import SHORTEST_HORIZON, HorizonError, MeasuredPath, horizon_errors
from ..signals.log import Log, operating_range
from ..units.units import HORIZONS
from .base import from_first, predictor
from .model_type import StoredModel, Training, fitted_samples

NETWORK_ERROR = 0.006
"""Share of the operating range: equations whose held-out error is surely smaller are taken without a comparison.
Networks from data alone left 0.003 to 0.15 on 107 validation logs of 29 simulated joints, on 105 of them more than
`hybrid`, which is nearer on each joint."""

UNKNOWN_BOUND = 2.0
"""Upper end of the error's interval over the error itself where less is held out than a bootstrap needs."""

JUDGED_TIME = 2.5
"""Processor time [s] of a network that is judged beside the equations, at most."""

POORER = 2.0
"""Times the error of the equations on what both were fitted to, beyond which a network does not replace them: a single
slow passage of the last quarter may go wrong with equations that follow all others within 0.01 %."""

Fit = Callable[[Training], StoredModel]
LOST = 0.15
"""Error of a free run over the range of its log beyond which a model has lost it; the least that counts as diverged."""
STARTS = 60
"""Restarts along a log from which errors by horizon are taken."""


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
    interval : Interval or None
        95 % interval of the error of the equations there.
    other : StoredModel or None
        The candidate that was fitted to all of the logs but not chosen; on a hybrid joint a controller is designed.
    """

    model: StoredModel
    reason: str
    held_out: dict[str, float]
    excess: Interval | None = None
    interval: Interval | None = None
    other: StoredModel | None = None

    def to_json(self) -> dict[str, Any]:
        """Log of the choice.

        ``ablation`` holds errors in free run over the last quarters of the training logs, shares of the operating
        range, as far as they were needed.
        """
        return {
            "chosen": self.model.name,
            "reason": self.reason,
            "held_out_error": self.held_out,
            "excess_of_the_other": None if self.excess is None else asdict(self.excess),
            "interval_of_hybrid": None if self.interval is None else asdict(self.interval),
            "basis_functions": self.model.describe().get("basis_functions"),
            "ablation": dict.fromkeys(("equations_alone", "equations_with_rbf", "rbf_alone"))
            | getattr(self.model, "diagnostics", {}).get("ablation", {})
            | ({"rbf_alone": self.held_out["rbf"]} if "rbf" in self.held_out else {}),
        }


def choose(training: Training, hybrid: Fit, rbf: Fit) -> Choice:
    """The hybrid joint, unless the network from data alone predicts the last quarters of the logs surely better.

    Parameters
    ----------
    training : Training
        Training logs.
    hybrid, rbf : callable
        Identify the candidates. What `hybrid` gives may know itself `early`, as fitted to the first three quarters.

    Returns
    -------
    Choice
        Cost: one identification; two or three where the hybrid joint does not predict well. A network takes at most
        `JUDGED_TIME` then, and one that replaces the equations what its time limit leaves.

    Raises
    ------
    DataRefusedError
        Neither can be identified.
    """
    try:
        model = hybrid(training)
    except DataRefusedError as refused:
        return Choice(rbf(training), f"hybrid is no candidate: {refused}", {})
    errors = _errors(getattr(model, "early", None) or model, training.records)
    held_out = {"hybrid": _rms(errors)}
    interval = rms_interval(errors, _block(training, errors), np.random.default_rng(SEED))
    if (UNKNOWN_BOUND * held_out["hybrid"] if interval is None else interval.high) < NETWORK_ERROR:
        reason = f"the joint's equations predict held-out training data to {_percent(held_out['hybrid'])} of the range"
        return Choice(model, reason, held_out, None, interval)
    return _compared(training, model, rbf, errors, held_out, interval)


def _compared(
    training: Training,
    model: StoredModel,
    rbf: Fit,
    hybrid_errors: FloatArray,
    held_out: dict[str, float],
    interval: Interval | None,
) -> Choice:
    """The hybrid joint or the network, after that has been judged on the same."""
    try:
        network = rbf(_within(replace(training, records=_first_parts(training)), JUDGED_TIME))
    except DataRefusedError as refused:
        return Choice(model, f"rbf is no candidate: {refused}", held_out, None, interval)
    errors = _errors(network, training.records)
    held_out["rbf"] = _rms(errors)
    excess = rms_difference_interval(
        errors, hybrid_errors, _block(training, errors, hybrid_errors), np.random.default_rng(SEED)
    )
    if held_out["hybrid"] <= held_out["rbf"]:
        return Choice(model, "smaller error on held-out training data", held_out, excess, interval)
    if not (UNKNOWN_BOUND * held_out["rbf"] < held_out["hybrid"] if excess is None else excess.high < 0.0):
        return Choice(model, "rbf is not surely nearer to held-out training data", held_out, excess, interval)
    early = getattr(model, "early", None) or model
    network_fitted, fitted = (_rms(_errors(m, _first_parts(training), held_out=False)) for m in (network, early))
    if network_fitted > POORER * fitted:
        return Choice(model, "rbf follows the data that both were fitted to less well", held_out, excess, interval)
    best = rbf(_within(training, max(training.identify.time_limit - JUDGED_TIME, JUDGED_TIME)))
    if _rms(_errors(best, training.records, held_out=False)) > POORER * _rms(
        _errors(model, training.records, held_out=False)
    ):
        return Choice(model, "rbf of all training data follows them less well", held_out, excess, interval, best)
    excess = None if excess is None else Interval(-excess.high, -excess.low, excess.level)
    return Choice(best, "surely smaller error on held-out training data", held_out, excess, interval, model)


def _first_parts(training: Training) -> tuple[Log, ...]:
    """First part of each log: candidates are fitted to it and judged on the rest."""
    return tuple(record.part(0, fitted_samples(len(record.t))) for record in training.records)


def _block(training: Training, *errors: FloatArray) -> int:
    """Samples over which errors are correlated."""
    return block_of(errors, training.records[0].interval, training.device)


def _within(training: Training, limit: float) -> Training:
    """The training data with a time limit [s] of at most this length."""
    update = {"time_limit": min(training.identify.time_limit, limit)}
    return replace(training, identify=training.identify.model_copy(update=update))


def _rms(errors: FloatArray) -> float:
    return float(np.sqrt(np.nanmean(errors**2)))


def _errors(model: StoredModel, records: Sequence[Log], *, held_out: bool = True) -> FloatArray:
    """Errors of q in free runs from the start, over the operating range, at the samples behind the fitted ones.

    NaN where masked; at most 1, as where the run diverged.
    """
    span = float(np.ptp(operating_range(records)))
    errors = [np.nan_to_num(np.abs(from_first(model, record).q - record.q), nan=np.inf) / span for record in records]
    return np.concatenate(
        [
            np.where(r.valid, np.minimum(error, 1.0), np.nan)[fitted_samples(len(r.t)) if held_out else 0 :]
            for r, error in zip(records, errors, strict=True)
        ]
    )


def main_model(models: Mapping[str, StoredModel], training: Training) -> tuple[str, str]:
    """The first of the models, unless another holds a training log that it loses, or is surely better by horizon.

    Parameters
    ----------
    models : mapping of name to StoredModel
        The first is the one that was chosen beforehand.
    training : Training
        Training data of all of them.

    Returns
    -------
    str
        Name of the main model.
    str
        Reason why it is not the first; empty where it is. Cost: a free run of each model over each log, and for a
        network the restarts of two models.
    """
    first = next(iter(models))
    lost = {
        name: max((_lost(model, record) for record in training.records), default=0.0) for name, model in models.items()
    }
    best = min(lost, key=lambda name: lost[name])
    if lost[first] > LOST >= lost[best]:
        return (
            best,
            f"{first} errs by {_percent(lost[first])} on its own training logs, {best} by {_percent(lost[best])}",
        )
    if first == "rbf":
        own = _by_horizon(models[first], training)
        chaotic = models[first].describe().get("chaotic")
        for name, model in models.items():
            if name != first and (chaotic or lost[name] < lost[first]) and _surely(_by_horizon(model, training), own):
                after = " and ".join(f"{horizon:g} s" for horizon in sorted({round(e.horizon_s, 3) for e in own}))
                return name, f"{name} predicts the training logs surely better than {first} after {after}"
    return first, ""


def _percent(error: float) -> str:
    return f"{100.0 * error:.2g} %" if error < 1.0 else "100 % or more"


def _lost(model: StoredModel, record: Log) -> float:
    """Error of a free run over the range of q in its log, at most 1: that of one that diverged."""
    return free_run_error(
        np.where(record.valid, record.q, np.nan), from_first(model, record).q, float(np.ptp(record.known_q))
    )


def _by_horizon(model: StoredModel, training: Training) -> list[HorizonError]:
    """Errors after the horizons of scores that the samples have, log by log."""
    errors: list[HorizonError] = []
    for record in training.records:
        half = float(record.t[-1] - record.t[0]) / 2.0
        times = [time for time, _ in HORIZONS.values() if SHORTEST_HORIZON * record.interval <= time <= half]
        q, speed = (np.where(record.valid, signal, np.nan) for signal in (record.q, record.qdot))
        errors += horizon_errors(
            predictor(model),
            MeasuredPath(record.t, record.drive_of(fine=model.fine_voltages), q, speed),
            times,
            plant=None,
            most_starts=STARTS,
        )
    return errors


def _surely(errors: list[HorizonError], others: list[HorizonError]) -> bool:
    """True if errors are surely smaller than others somewhere, and surely larger nowhere."""
    pairs = [(a, b) for a, b in zip(errors, others, strict=True) if a.interval and b.interval]
    smaller = any(a.interval.high < b.interval.low for a, b in pairs if a.interval and b.interval)
    larger = any(a.interval.low > b.interval.high for a, b in pairs if a.interval and b.interval)
    return smaller and not larger and all(a.diverged <= b.diverged for a, b in zip(errors, others, strict=True))
