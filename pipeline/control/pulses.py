"""Feedforward snaps: push, brake, catch, optimised on the identified joint and robust over its posterior."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.optimize import differential_evolution

from ..errors import InputError
from ..numerics.arrays import FloatArray
from ..numerics.metrics import BAND, settling_index
from ..system.names import Goal
from ..system.worker_pool import OnProgress, silent
from .ensemble import INTERVAL, SEED, Ensemble
from .estimator import PERIOD

LENGTH = 1.2
"""Length [s] of the runs by which a pulse is judged; its goals beside time permit half of it for settling."""
BANDS = (0.6, 1.0)
"""Shares of the settling band over which the optimisation takes the mean. A narrow one alone is out of reach for a
joint that creeps (1 s where 0.18 s is possible); a wide one alone leaves no margin for draws that differ."""
SEGMENTS = ("push", "brake", "catch")
LONGEST = LENGTH / len(SEGMENTS)
"""Longest segment of a pulse [s]."""
_BOUNDS = np.array([(0.0, LONGEST), (0.0, 1.0), (0.0, LONGEST), (-1.0, 0.0), (0.0, LONGEST), (-1.0, 1.0)])
"""Durations [s] and efforts of push, brake and catch between which the optimisation looks."""
JUDGES = 6
"""Vectors of the ensemble that judge a pulse: the estimate and some draws."""
_SEARCHES = 3
_ROUNDS = 60
_POPULATION = 48
_RUNS = _SEARCHES * _ROUNDS + (_ROUNDS // 2) * JUDGES
"""Runs of each pulse in all rounds."""


@dataclass(frozen=True)
class Pulse:
    """A feedforward snap and the model's prediction of it.

    Attributes
    ----------
    t, v : FloatArray, shapes (M,), (M, 2)
        Times [s] every millisecond and commands [V].
    segments : FloatArray, shape (3, 2)
        Duration [s] and effort (share of the largest squared voltage; positive pushes towards the target).
    settling_s, overshoot_m : float
        Of the estimate.
    settling_low_s, settling_high_s : float
        Central 90 % over the draws; infinite where a draw does not settle.
    probability : float
        Share of the draws that end in the wanted well.
    q : FloatArray, shape (B, N)
        Predicted readings [m] of estimate and draws every 4 ms.
    """

    t: FloatArray
    v: FloatArray
    segments: FloatArray
    settling_s: float
    overshoot_m: float
    settling_low_s: float
    settling_high_s: float
    probability: float
    q: FloatArray


@dataclass
class _Search:
    """Differential evolution over the segments of a pulse; parameters as in `design_pulse`."""

    joint: Ensemble
    start: float
    target: float
    distance: float
    highest: float
    goal: Goal
    on_progress: OnProgress
    rng: np.random.Generator = field(default_factory=lambda: np.random.default_rng(SEED))
    runs: int = 0
    """Runs of each pulse so far."""

    @property
    def side(self) -> int:
        """The side that pushes: 0 left, 1 right."""
        return 0 if self.target > self.start else 1

    def best(self) -> FloatArray:
        """Durations [s] and efforts of the segments, shape (6,)."""
        alone = self.joint.subset(slice(0, 1))
        judges = self.joint.subset(slice(0, JUDGES))
        searches = []
        for _ in range(_SEARCHES):
            pulses = self.rng.uniform(_BOUNDS[:, 0], _BOUNDS[:, 1], (_POPULATION, len(_BOUNDS)))
            pulses[::2, [1, 3]] = 1.0, -1.0
            searches.append(self._evolved(alone, pulses, _ROUNDS))
        costs = self._cost(np.array([each.x for each in searches]).T, judges)
        return np.asarray(self._evolved(judges, searches[int(np.argmin(costs))].population, _ROUNDS // 2).x)

    def _cost(self, values: FloatArray, by: Ensemble, /) -> Any:
        """Mean cost over the ensemble of each pulse, `values` (6, P)."""
        self.on_progress("optimising", min(1.0, self.runs / _RUNS))
        self.runs += len(by.gains)
        runs = by.run(commands(values.T, self.side, self.highest), self.start)
        lag = float(self.joint.lags.mean())
        return judged(runs, self.start, self.target, self.distance, values.T, self.goal, lag).mean(axis=1)

    def _evolved(self, by: Ensemble, pulses: FloatArray, rounds: int) -> Any:
        """The pulses after some rounds."""
        return differential_evolution(
            self._cost,
            _BOUNDS.tolist(),
            (by,),
            init=pulses,
            maxiter=rounds,
            vectorized=True,
            polish=False,
            updating="deferred",
            tol=0.0,
            mutation=(0.4, 0.9),
            recombination=0.8,
            rng=self.rng,
        )


def design_pulse(
    joint: Ensemble,
    start: float,
    target: float,
    distance: float,
    highest: float,
    goal: Goal = "time",
    on_progress: OnProgress = silent,
) -> Pulse:
    """The pulse that brings the joint from rest at `start` to rest at `target` (readings, m).

    Differential evolution varies the durations and efforts of three segments. It runs several times on the estimate,
    from drawn starts, half of which push and brake fully. The best run goes on with the mean over the estimate and some
    draws.

    Parameters
    ----------
    joint : Ensemble
        Estimate and draws.
    start, target : float
        Readings [m] of the wells.
    distance : float
        Of the wells [m].
    highest : float
        Largest voltage [V].
    goal : {"time", "energy", "voltage"}
        Quantity to minimise: settling time, charge energy, or peak voltage.
    on_progress : callable
        Called before each round of the search.

    Raises
    ------
    InputError
        No pulse within the voltage limit switches the model.

    Notes
    -----
    Cost: 4 s.
    """
    search = _Search(joint, start, target, distance, highest, goal, on_progress)
    segments = search.best()
    v = commands(segments[None], search.side, highest)
    q = joint.run(v, start)[0]
    settling = settling_times(q, target, distance)
    overshoot = np.maximum((q - target) * np.sign(target - start), 0.0)
    right = np.abs(q[:, -1] - target) < np.abs(q[:, -1] - start)
    if not right[0]:
        raise InputError(
            f"no push of at most {LONGEST:g} s with {highest:.0f} V, brake and catch bring the model over its "
            f"barrier and to rest within {LENGTH:g} s; allow a larger voltage, or take a controller (control design "
            "--max-voltage), which swings it up"
        )
    low, high = (
        float(np.quantile(settling[1:] if len(q) > 1 else settling, share, method=outwards))  # type: ignore[call-overload]
        for share, outwards in ((0.05, "lower"), (0.95, "higher"))
    )
    last = int(np.flatnonzero(v[0].any(axis=1))[-1]) + 2
    t = np.linspace(0.0, PERIOD * (v.shape[1] - 1), v.shape[1])
    return Pulse(
        t=t[:last],
        v=v[0, :last],
        segments=segments.reshape(-1, 2),
        settling_s=float(settling[0]),
        overshoot_m=float(overshoot[0].max()),
        settling_low_s=low,
        settling_high_s=high,
        probability=float(right[1:].mean()) if len(q) > 1 else float(right[0]),
        q=q,
    )


def commands(values: FloatArray, side: int, highest: float) -> FloatArray:
    """Commands (P, M, 2) [V] of pulses with values (P, 6): duration [s] and effort of push, brake, catch."""
    t = np.arange(round(LENGTH / PERIOD)) * PERIOD
    begin = np.zeros((len(values), 1))
    share = np.zeros((len(values), t.size))
    for segment in range(len(SEGMENTS)):
        end = begin + values[:, [2 * segment]]
        inside = np.clip((end - t) / PERIOD, 0.0, 1.0) - np.clip((begin - t) / PERIOD, 0.0, 1.0)
        share += values[:, [2 * segment + 1]] * inside
        begin = end
    voltages = np.zeros((*share.shape, 2))
    voltages[:, :, side] = highest * np.sqrt(np.clip(share, 0.0, 1.0))
    voltages[:, :, 1 - side] = highest * np.sqrt(np.clip(-share, 0.0, 1.0))
    return voltages


def judged(
    q: FloatArray, start: float, target: float, distance: float, values: FloatArray, goal: Goal, lag: float
) -> FloatArray:
    """Cost of the runs of pulses, shape (P, B): the measure of the goal, more than any such without settling.

    Parameters
    ----------
    q : FloatArray, shape (P, B, N)
        Readings [m].
    start, target, distance : float
        Readings [m] of the wells and their distance.
    values : FloatArray, shape (P, 6)
        Durations [s] and efforts of the segments.
    goal : {"time", "energy", "voltage"}
        Quantity to minimise.
    lag : float
        Time constant of the converters [s]: a shorter segment charges its membrane in part.
    """
    times = [settling_times(q, target, share * distance) for share in BANDS]
    settling = np.mean(np.minimum(times, LENGTH), axis=0)
    over = np.maximum(((q - target) * np.sign(target - start)).max(axis=2), 0.0) / distance
    away = np.abs(q[..., q.shape[-1] // 2 :] - target).mean(axis=2) / distance
    size = np.abs(values[:, 1::2])
    spent = (size * np.minimum(values[:, 0::2] / lag, 1.0)).mean(axis=1)
    cost = {"time": settling, "energy": spent[:, None], "voltage": size.max(axis=1)[:, None]}[goal]
    late_s = 0.0 if goal == "time" else np.maximum(settling - 0.5 * LENGTH, 0.0)
    return np.asarray(np.where(np.isfinite(times[-1]), cost + over + 2.0 * late_s / LENGTH, 3.0 + away))


def settling_times(q: FloatArray, target: float, distance: float) -> FloatArray:
    """Time [s] after which q (…, N) stays within the band about the target; infinite if outside at the end."""
    settled = settling_index(q - target, BAND * distance)
    # Between samples on a line, so that the cost is no staircase.
    index = np.clip(settled, 1, q.shape[-1] - 1)
    after = np.take_along_axis(np.abs(q - target), index[..., None], -1)[..., 0]
    before = np.take_along_axis(np.abs(q - target), index[..., None] - 1, -1)[..., 0]
    share = np.clip((before - BAND * distance) / np.maximum(before - after, 1e-12), 0.0, 1.0)
    times = np.where(settled > 0, settled * INTERVAL - INTERVAL * (1.0 - share), 0.0)
    return np.asarray(np.where(settled == q.shape[-1], np.inf, times))
