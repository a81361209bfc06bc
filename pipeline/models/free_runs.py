"""Free runs of models over logs: from which rows, under which voltages and with which velocity a model starts."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..signals.log import EDGE, MOST_SAMPLES, Log, operating_range, within
from ..store.columns import TUBE_COLUMNS
from .base import DrawnModel, DynamicModel, FreeRun, HasDraws, HasTubes
from .tubes import Tubes, TubeScale, tube_scale, tubes

DRAWS = 32
"""Free runs that show what the training data leave open."""


class Start(NamedTuple):
    """What a free run over a part of a log is made with: times [s], voltages [V] as fine as the model takes them, and
    the state [m, m/s] ([rad, rad/s] for an angle) at the first of these rows.
    """

    t: FloatArray
    v: FloatArray
    q0: float
    qdot0: float


def free_run(log: Log, model: DynamicModel) -> FreeRun:
    """Simulate a model over the parts of a log; rows before and between them, and after a divergence, are NaN.

    Parameters
    ----------
    log : Log
        With the inputs between its samples if the model takes them.
    model : DynamicModel
        What is simulated.
    """
    q, qdot, qddot = (np.full(len(log.t), np.nan) for _ in range(3))
    for rows, part in zip(log.part_rows(), log.parts(), strict=True):
        made = model.simulate(*start_of(part, model))
        q[rows], qdot[rows], qddot[rows] = made.q, made.qdot, made.qddot
        if made.status != "ok":
            return FreeRun(log.t, q, qdot, qddot, made.status, made.diverged_at_s)
    return FreeRun(log.t, q, qdot, qddot, "ok", None)


def drawn_runs(log: Log, model: DynamicModel) -> FloatArray | None:
    """Free runs over the parts of a log drawn from the posterior of a model's parameters, q of shape (`DRAWS`, N).

    NaN before, between and behind the parts; None for a model without draws.
    """
    if not isinstance(model, HasDraws):
        return None
    ensemble = np.full((DRAWS, len(log.t)), np.nan)
    for rows, part in zip(log.part_rows(), log.parts(), strict=True):
        ensemble[:, rows], _ = model.simulate_draws(*start_of(part, model), count=DRAWS)
    return ensemble


def tube_columns(tubes: Tubes) -> dict[str, FloatArray]:
    """Tubes by the columns of the predictions."""
    ends = (tubes.low, tubes.high, tubes.other_low, tubes.other_high)
    return dict(zip((column.key for column in TUBE_COLUMNS), ends, strict=True))


def tubes_of(q: FloatArray, ensemble: FloatArray | None, model: DynamicModel) -> Tubes | None:
    """The tubes about a free run with these draws; None for a model that has none."""
    if not isinstance(model, HasTubes) or ensemble is None or model.tube.factor == 0.0:
        return None
    return tubes(q, ensemble, model.tube)


def wanted_tubes(q: FloatArray, ensemble: FloatArray | None, model: DynamicModel) -> dict[str, FloatArray]:
    """The columns of the tubes about a free run with these draws.

    Raises
    ------
    InputError
        The model has no tubes.
    """
    around = tubes_of(q, ensemble, model)
    if around is None:
        raise InputError(f"{model.name} has no tubes; hybrid and rbf have them, identified by this version")
    return tube_columns(around)


def start_of(part: Log, model: DynamicModel) -> Start:
    """Where a free run of a model over a part of a log starts, whatever is simulated from there.

    At rest the velocity is the measured one or the derivative. Where it begins in motion a derivative at its edge is
    poor, and a free run carries its error on: then it is the velocity with which the model follows the first samples.
    """
    v = part.drive_of(fine=model.fine_voltages)
    qdot0 = followed_velocity(part, v, model) if part.begins_in_motion else float(part.qdot[0])
    return Start(part.t, v, float(part.q[0]), qdot0)


def followed_velocity(log: Log, v: FloatArray, model: DynamicModel) -> float:
    """The velocity with which a model follows the first samples best, by two Gauss-Newton steps from the derivative.

    The derivative stays where nothing lowers the error.
    """
    part = slice(0, EDGE + 1)
    q = log.q[part]
    start = float(log.qdot[0])
    seen = np.isfinite(q)
    nudge = 1e-3 * float(np.nanstd(log.qdot))

    def error(velocity: float) -> FloatArray:
        """Error of q at the first samples of a run that begins with this velocity."""
        return (model.simulate(log.t[part], v[part], float(q[0]), velocity).q - q)[seen]

    best = start
    least = error(start)
    for _ in range(2):
        slope = (error(best + nudge) - least) / nudge
        steep = float(slope @ slope)
        if not steep > 0.0:  # a model whose start does not depend on the velocity, or samples that say nothing of it
            break
        trial = best - float(slope @ least) / steep
        moved = error(trial) if np.isfinite(trial) else np.full_like(least, np.inf)
        if not moved @ moved < least @ least:
            break
        best = trial
        least = moved
    return best


def scale_on(records: Sequence[Log], model: DrawnModel, floor: float, margin: float, least: float = 0.0) -> TubeScale:
    """Scale of the tubes, from the errors on the training logs. Cost: 33 runs of each log.

    Parameters
    ----------
    records : sequence of Log
        The training logs.
    model : DrawnModel
        What was fitted to them.
    floor : float
        RMS error of q [m or rad] on the training data.
    margin : float
        Errors on another log over those on the training data.
    least : float
        Smallest κ.
    """
    parts = []
    for record in within(records, MOST_SAMPLES):
        v = record.drive if model.fine_voltages else record.v
        given = record.t, v, float(record.q[0]), float(record.qdot[0])
        ensemble, _ = model.simulate_draws(*given)
        parts.append((model.simulate(*given).q, ensemble, np.where(record.valid, record.q, np.nan)))
    free, drawn_q, q = (np.concatenate(each, axis=-1) for each in zip(*parts, strict=True))
    low, high = operating_range(records)
    scale = tube_scale(free, drawn_q, q, floor, margin, high - low)
    return replace(scale, factor=max(scale.factor, least))
