"""Pulses between the wells of an identified joint: optimised snaps, and plain ones.

A snap is a push, a brake and a catch, robust over the posterior. Plain pulses have a map of the probability that they
switch, and a lowest voltage that is sufficient.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import differential_evolution

from ..errors import InputError
from ..models.hybrid.model import HybridModel
from ..numerics.arrays import FloatArray
from ..numerics.metrics import BAND, NORMAL_90, settling_index
from ..system.names import Goal, Well
from ..system.worker_pool import OnProgress, silent
from .ensemble import INTERVAL, SEED, Converters, Ensemble, ensemble_at
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
    """A feedforward snap and what the model predicts of it.

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

    Differential evolution over the durations and efforts of three segments on the estimate, several times, from drawn
    starts of which half push and brake fully; from the best on, judged by the mean over the estimate and some draws.

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
    side = 0 if target > start else 1
    alone = joint.subset(slice(0, 1))
    judges = joint.subset(slice(0, JUDGES))
    rng = np.random.default_rng(SEED)
    done = 0

    def cost(values: FloatArray, by: Ensemble) -> Any:
        """Mean over the ensemble of what each pulse costs."""
        nonlocal done
        on_progress("optimising", min(1.0, done / _RUNS))
        done += len(by.gains)
        runs = by.run(commands(values.T, side, highest), start)
        return judged(runs, start, target, distance, values.T, goal, float(joint.lags.mean())).mean(axis=1)

    def search(by: Ensemble, pulses: FloatArray, rounds: int) -> Any:
        """The pulses after some rounds."""
        return differential_evolution(
            cost,
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
            rng=rng,
        )

    searches = []
    for _ in range(_SEARCHES):
        pulses = rng.uniform(_BOUNDS[:, 0], _BOUNDS[:, 1], (_POPULATION, len(_BOUNDS)))
        pulses[::2, [1, 3]] = 1.0, -1.0
        searches.append(search(alone, pulses, _ROUNDS))
    costs = cost(np.array([each.x for each in searches]).T, judges)
    best = search(judges, searches[int(np.argmin(costs))].population, _ROUNDS // 2).x
    v = commands(best[None], side, highest)
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
        segments=best.reshape(-1, 2),
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


REST = 1.6
"""Time [s] after the pulse's end at which the well counts."""
CELLS = 25
"""Voltages and durations of the map."""
LEAST_VOLTAGE = 0.2
DURATIONS = (0.02, 1.0)
"""Lowest voltage that is tried, as a share of the largest; shortest and longest pulse of the map [s]."""


@dataclass(frozen=True)
class SwitchingMap:
    """P(switch) to one well.

    Attributes
    ----------
    to : {"left", "right"}
        The other well than the one in which the joint rests.
    voltages : FloatArray, shape (V,)
        Of the pulse [V].
    durations : FloatArray, shape (D,)
        [s].
    probability, low, high : FloatArray, shape (V, D)
        Share of the posterior draws that switch, with the 90 % band of that share (Wilson's interval: of few draws).
    """

    to: Well
    voltages: FloatArray
    durations: FloatArray
    probability: FloatArray
    low: FloatArray
    high: FloatArray


def switching_map(
    joint: Ensemble, wells: tuple[float, float, float], to: Well, on_progress: OnProgress = silent
) -> SwitchingMap:
    """The map of a pulse on the side that pulls towards the well `to`, from rest in the other one.

    Parameters
    ----------
    joint : Ensemble
        Estimate and draws from the posterior, which count alone, or an estimate alone.
    wells : (float, float, float)
        Readings [m] of left well, saddle and right well.
    to : {"left", "right"}
        Target well of the pulse.
    on_progress : callable
        Receives the share that is done.

    Notes
    -----
    Cost: 625 runs of 1.7 to 2.6 s for each draw, 12 s.
    """
    voltages = np.linspace(LEAST_VOLTAGE, 1.0, CELLS) * joint.highest
    durations = np.geomspace(*DURATIONS, CELLS)
    draws = joint.subset(slice(1, None)) if len(joint.gains) > 1 else joint
    count = len(draws.gains)
    total = np.empty((CELLS, CELLS))
    for i, duration in enumerate(durations):
        on_progress(f"to the {to}", i / CELLS)
        squares = draws.squares(pulses(voltages, np.full(CELLS, duration), 0 if to == "right" else 1))
        total[:, i] = np.count_nonzero(_switched(draws, squares, wells, to), axis=1)
    share = total / count
    middle = (share + NORMAL_90**2 / (2 * count)) / (1 + NORMAL_90**2 / count)
    half = NORMAL_90 / (1 + NORMAL_90**2 / count) * np.sqrt(share * (1 - share) / count + NORMAL_90**2 / (4 * count**2))
    return SwitchingMap(to, voltages, durations, share, np.maximum(middle - half, 0.0), np.minimum(middle + half, 1.0))


def pulses(voltages: FloatArray, durations: FloatArray, side: int) -> FloatArray:
    """Commands (P, M, 2) [V] of pulses with these voltages [V] and durations [s], each of shape (P,), and the rest."""
    length = round((float(durations.max()) + REST) / PERIOD)
    t = np.arange(length) * PERIOD
    commands = np.zeros((len(voltages), length, 2))
    # The last millisecond of a pulse carries what is left of its duration, as a share of the square.
    commands[:, :, side] = voltages[:, None] * np.sqrt(np.clip((durations[:, None] - t) / PERIOD, 0.0, 1.0))
    return commands


PULSES = (0.1, 0.2, 0.5)
"""Durations [s] of the pulses whose lowest voltages are computed."""
TYPICAL = PULSES[1]
"""Duration of the pulse by which the draws of a map are judged [s]."""
RESOLUTION = 0.015
TOLERANCE = 1e-9
"""Relative step of the voltages at which a joint is tried first, and relative error of the lowest voltage.

It is differentiated by differences of `TOLERANCE`^⅓. The parameters move along columns of their covariance's factor.
Those that are moved singly leave the valley of the posterior, where the voltage is curved: one joint's deviation was
1.25 % so."""


@dataclass(frozen=True)
class LowestVoltage:
    """Switching of pulses of one duration to one well.

    Attributes
    ----------
    duration : float
        [s].
    voltage, low, high : float
        Of the estimate and the ends of its central 90 % [V].
    until : float or None
        Next higher voltage [V] of those tried that does not switch the estimate, as the joint swings back; None if all
        do.
    of_parameters, of_lags, of_probe : float
        Standard deviations of its logarithm: what the identified parameters, the converters' lags and the probe that
        measured the training logs may err by.
    """

    duration: float
    voltage: float
    low: float
    high: float
    until: float | None
    of_parameters: float
    of_lags: float
    of_probe: float


def lowest_voltage(
    model: HybridModel, converters: Converters, wells: tuple[float, float, float], to: Well, duration: float
) -> LowestVoltage | None:
    """The lowest voltage at which a pulse brings the joint to a well, from rest in the other.

    Its logarithm's standard deviation is that of parameters of the covariance E Eᵀ that the training data show
    (`HybridModel.band_spread`), to first order; with the converters' lags and the probe.

    Parameters
    ----------
    model : HybridModel
        The identified joint.
    converters : Converters
        Knowledge of the converters.
    wells : (float, float, float)
        Readings [m] of left well, saddle and right well.
    to : {"left", "right"}
        Target well of the pulse.
    duration : float
        Of the pulse [s].

    Returns
    -------
    LowestVoltage or None
        None where the largest voltage, trained and allowed, does not switch the model.

    Notes
    -----
    Cost: 5500 runs of 1.7 to 2.1 s, 0.9 s.
    """
    lags = np.array([converters.lags])
    estimate = ensemble_at(model, model.theta[None], lags, np.ones(1), converters.highest)
    first = _first(estimate, wells, to, duration)
    if first is None:
        return None
    lowest, until = first
    lengths = np.linalg.norm(model.band_spread, axis=0)
    columns = model.band_spread[:, lengths > 0.0].T / lengths[lengths > 0.0, None]
    sides = np.concatenate([np.zeros((len(columns), 2)), np.eye(2)])
    step = TOLERANCE ** (1.0 / 3.0)
    steps = step * np.concatenate([columns, np.zeros((2, len(model.theta)))])
    thetas = np.concatenate([model.theta + steps, model.theta - steps])
    lags = lags * np.exp(step * np.concatenate([sides, -sides]))
    logs = _logarithms(ensemble_at(model, thetas, lags, np.ones(len(thetas))), wells, to, duration, lowest)
    slopes = np.subtract(*np.split(logs, 2)) / (2.0 * step)
    of_parameters = float(np.linalg.norm(slopes[:-2] * lengths[lengths > 0.0]))
    of_lags = float(converters.spread * np.linalg.norm(slopes[-2:]))
    half = NORMAL_90 * float(np.linalg.norm([of_parameters, of_lags, converters.probe]))
    low, high = lowest * np.exp([-half, half])
    return LowestVoltage(
        duration=duration,
        voltage=lowest,
        low=float(low),
        high=float(high),
        until=until,
        of_parameters=of_parameters,
        of_lags=of_lags,
        of_probe=converters.probe,
    )


def with_voltage_error(joint: Ensemble, lowest: Sequence[LowestVoltage | None]) -> Ensemble:
    """The same joint with draws whose voltages err as its lowest voltage may: for pulses near it.

    What the parameters do acts as a voltage that is too high or too low: on four joints its deviations at 0.1 s and at
    0.8 s were 0.72 to 1.36 times that at `TYPICAL`, and correlated with it by 0.83 to 1.00. So all pulses are scaled
    alike, by the deviation of the first of `lowest` that lasts as long.
    """
    switching = [pulse for pulse in lowest if pulse is not None]
    if not switching:
        return joint
    typical = next((pulse for pulse in switching if pulse.duration >= TYPICAL), switching[-1])
    return joint.with_gain_error(float(np.hypot(typical.of_parameters, typical.of_probe)))


def _switched(
    joint: Ensemble, squares: FloatArray, wells: tuple[float, float, float], to: Well
) -> "np.ndarray[tuple[int, int], np.dtype[np.bool_]]":
    """Mask of the runs under squared voltages [V²] that end in the well `to`, shape (P, B)."""
    left, saddle, right = wells
    ends = joint.simulate(squares, left if to == "right" else right)[:, :, -1]
    return np.asarray((ends > saddle) == (to == "right"))


def _unit(joint: Ensemble, to: Well, duration: float) -> FloatArray:
    """Squared voltages of a pulse of one volt, shape (1, B, H, 2) [V²]."""
    return joint.squares(pulses(np.ones(1), np.array([duration]), 0 if to == "right" else 1))


def _first(
    joint: Ensemble, wells: tuple[float, float, float], to: Well, duration: float
) -> tuple[float, float | None] | None:
    """The first voltage [V] from below that switches the one joint, and the next of those tried that does not.

    None where none switches it.
    """
    volts = joint.highest * np.exp(np.arange(np.log(LEAST_VOLTAGE), RESOLUTION / 2.0, RESOLUTION))
    over = _switched(joint, volts[:, None, None, None] ** 2 * _unit(joint, to, duration), wells, to)[:, 0]
    if over[0] or not over.any():
        return None
    at = int(np.argmax(over))
    beyond = volts[at:][~over[at:]]
    first = np.exp(_logarithms(joint, wells, to, duration, float(np.sqrt(volts[at - 1] * volts[at])))[0])
    return float(first), float(beyond[0]) if beyond.size else None


def _logarithms(
    joint: Ensemble, wells: tuple[float, float, float], to: Well, duration: float, about: float
) -> FloatArray:
    """Logarithms of the lowest voltages [V] of the joints, shape (B,), within `RESOLUTION` about one that is known."""
    unit = _unit(joint, to, duration)
    low, high = np.log(about) + RESOLUTION * np.array([[-1.0], [1.0]]) * np.ones(len(joint.gains))
    for _ in range(math.ceil(math.log2(2.0 * RESOLUTION / TOLERANCE))):
        middle = 0.5 * (low + high)
        over = _switched(joint, np.exp(2.0 * middle)[None, :, None, None] * unit, wells, to)[0]
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    return np.asarray(0.5 * (low + high))
