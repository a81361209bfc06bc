"""Free runs of models over logs: where a model starts, and tubes in which the measurement lies.

A measured displacement lies in a tube with nine tenths of probability. Its half width is

    w(t) = κ √(s(t)² + s₀²)

s(t) being the standard deviation of runs drawn from the posterior of the parameters, s₀ the error on the training data.
The draws give the shape: errors grow where the motion is sensitive, and fade where it settles. They include noise, and
not what the equations lack. So κ comes from the training data. It is the quantile of |error|/√(s² + s₀²) there, times a
factor of the model type, because a fit bends to its own data.

Split conformal prediction (Lei et al. 2018, doi:10.1080/01621459.2017.1307116) would take the quantile from a held-out
quarter of the log. A quarter has a few snaps only. On fifty simulated joints its quantile had a correlation of 0.3 with
that of another log, the quantile of the training data one of 0.7.

Draws that end in another well are no part of s. Where they are more than `OPEN` of all, they have a tube of their own.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..signals.log import EDGE, MOST_SAMPLES, Log, operating_range, within
from ..store.columns import TUBE_COLUMNS
from .base import DynamicModel, FreeRun, HasDraws, HasTubes, TubeScale

COVERAGE = 0.9
"""Probability with which a sample of another log lies in the tubes."""

APART = 0.25
"""Share of the operating range: a draw that is farther from the free run is in another well, or on its way there."""

OPEN = 0.05
"""Share of the draws in another well from which on they have a tube of their own."""


DRAWS = 32
"""Free runs that show what the training data leave open."""


@dataclass(frozen=True)
class Tubes:
    """The tube about a free run, and that of the other well; all of shape (N,), NaN where there is none."""

    low: FloatArray
    high: FloatArray
    other_low: FloatArray
    other_high: FloatArray

    def coverage(self, q: FloatArray) -> float | None:
        """Share of the measured samples that lie in the tubes; None where nothing can be compared."""
        compared = np.isfinite(q) & np.isfinite(self.low)
        inside = (q >= self.low) & (q <= self.high) | (q >= self.other_low) & (q <= self.other_high)
        return float(np.mean(inside[compared])) if compared.any() else None


def tube_scale(
    free: FloatArray, ensemble: FloatArray, measured: FloatArray, floor: float, margin: float, span: float
) -> TubeScale:
    """The scale that the training data ask for.

    Parameters
    ----------
    free, measured : FloatArray, shape (N,)
        Free run and measurement [m or rad] over the training data; NaN where masked.
    ensemble : FloatArray, shape (draws, N)
        The draws there.
    floor : float
        s₀ [m or rad].
    margin : float
        Errors on another log over those on the training data.
    span : float
        Operating range [m or rad].
    """
    apart = APART * span
    ratio = np.abs(free - measured) / _spread(free, ensemble, floor, apart)
    ratio = ratio[np.isfinite(ratio)]
    return TubeScale(margin * (float(np.quantile(ratio, COVERAGE)) if ratio.size else 1.0), floor, apart)


def tubes(free: FloatArray, ensemble: FloatArray, scale: TubeScale) -> Tubes:
    """The tubes of a free run.

    Parameters
    ----------
    free : FloatArray, shape (N,)
        The free run [m or rad].
    ensemble : FloatArray, shape (draws, N)
        Free runs of the draws.
    scale : TubeScale
        From `tube_scale`. Cost: a dozen flops for each sample of each draw.
    """
    width = scale.factor * _spread(free, ensemble, scale.floor, scale.apart)
    away = np.abs(ensemble - free) > scale.apart
    several = np.mean(away, axis=0) > OPEN
    others = np.where(away & several, ensemble, np.nan)
    lowest, highest = (np.full(free.shape, np.nan) for _ in range(2))
    lowest[several] = np.nanmin(others[:, several], axis=0)
    highest[several] = np.nanmax(others[:, several], axis=0)
    return Tubes(free - width, free + width, lowest - width, highest + width)


def _spread(free: FloatArray, ensemble: FloatArray, floor: float, apart: float) -> FloatArray:
    """√(s² + s₀²), shape (N,)."""
    distance = ensemble - free
    near = np.abs(distance) <= apart
    squares = np.sum(np.where(near, distance, 0.0) ** 2, axis=0)
    return np.asarray(np.sqrt(squares / np.maximum(np.count_nonzero(near, axis=0), 1) + floor**2))


def free_run(log: Log, model: DynamicModel) -> FreeRun:
    """Simulate a model over the parts of a log; rows before and between them, and after a divergence, are NaN.

    Parameters
    ----------
    log : Log
        With the inputs between its samples if the model takes them.
    model : DynamicModel
        Model to simulate.
    """
    q, qdot, qddot = motion = np.full((3, len(log.t)), np.nan)
    for rows, part in zip(log.part_rows(), log.parts(), strict=True):
        made = model.simulate(*start_of(part, model))
        motion[:, rows] = made.q, made.qdot, made.qddot
        if made.status != "ok":
            return FreeRun(log.t, q, qdot, qddot, made.status, made.diverged_at_s)
    return FreeRun(log.t, q, qdot, qddot, "ok")


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
    return dict(zip((column.key for column in TUBE_COLUMNS), vars(tubes).values(), strict=True))


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


def start_of(part: Log, model: DynamicModel) -> tuple[FloatArray, FloatArray, float, float]:
    """Input of a free run over a part of a log: times [s], voltages [V] as fine as the model takes them, q and q̇ there.

    At rest the velocity is the measured one or the derivative. Where the part begins in motion, the derivative at the
    edge is poor. Then it is the velocity with which the model follows the first samples best.
    """
    v = part.drive_of(fine=model.fine_voltages)
    qdot0 = followed_velocity(part, v, model) if part.begins_in_motion else float(part.qdot[0])
    return part.t, v, float(part.q[0]), qdot0


def followed_velocity(log: Log, v: FloatArray, model: DynamicModel) -> float:
    """The velocity with which a model follows the first samples best, by two Gauss-Newton steps from the derivative.

    The derivative stays where nothing lowers the error.
    """
    part = slice(0, EDGE + 1)
    q = log.q[part]
    seen = np.isfinite(q)
    nudge = 1e-3 * float(np.nanstd(log.qdot))

    def error(velocity: float) -> FloatArray:
        """Error of q at the first samples of a run that begins with this velocity."""
        return (model.simulate(log.t[part], v[part], float(q[0]), velocity).q - q)[seen]

    best = float(log.qdot[0])
    least = error(best)
    for _ in range(2):
        slope = (error(best + nudge) - least) / nudge
        steep = float(slope @ slope)
        if not steep > 0.0:  # the run at these samples does not depend on the velocity
            break
        trial = best - float(slope @ least) / steep
        moved = error(trial) if np.isfinite(trial) else np.full_like(least, np.inf)
        if not moved @ moved < least @ least:
            break
        best = trial
        least = moved
    return best


def scale_on(records: Sequence[Log], model: HasDraws, floor: float, margin: float, least: float = 0.0) -> TubeScale:
    """Scale of the tubes, from the errors on the training logs. Cost: 33 runs of each log.

    Parameters
    ----------
    records : sequence of Log
        The training logs.
    model : HasDraws
        Model fitted to them.
    floor : float
        RMS error of q [m or rad] on the training data.
    margin : float
        Errors on another log over those on the training data.
    least : float
        Smallest κ.
    """
    parts = []
    for record in within(records, MOST_SAMPLES):
        given = record.t, record.drive_of(fine=model.fine_voltages), float(record.q[0]), float(record.qdot[0])
        ensemble, _ = model.simulate_draws(*given)
        parts.append((model.simulate(*given).q, ensemble, np.where(record.valid, record.q, np.nan)))
    free, drawn_q, q = (np.concatenate(each, axis=-1) for each in zip(*parts, strict=True))
    scale = tube_scale(free, drawn_q, q, floor, margin, float(np.ptp(operating_range(records))))
    return replace(scale, factor=max(scale.factor, least))
