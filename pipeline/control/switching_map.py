"""Map of plain pulses that switch an identified joint: their probability, and the lowest sufficient voltage."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..models.hybrid.model import HybridModel
from ..numerics.arrays import FloatArray
from ..numerics.metrics import NORMAL_90
from ..system.names import Well
from ..system.worker_pool import OnProgress, silent
from .ensemble import Converters, Ensemble, ensemble_at
from .estimator import PERIOD

REST = 1.6
"""Time [s] after the pulse's end at which the well counts."""
CELLS = 25
"""Voltages and durations of the map."""
LEAST_VOLTAGE = 0.2
DURATIONS = (0.02, 1.0)
"""Lowest voltage that is tried, as a share of the largest; shortest and longest pulse of the map [s]."""
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
    """The joint with draws whose voltages err as its lowest voltage may, for pulses near that voltage.

    Errors of the parameters act as a voltage that is too high or too low. On four joints its deviations at 0.1 s and at
    0.8 s were 0.72 to 1.36 times that at `TYPICAL`, with correlations of 0.83 to 1.00. So all pulses are scaled alike,
    by the deviation of the first of `lowest` that lasts as long.
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
    """The lowest voltage [V] that switches the one joint, and the next higher one tried that does not.

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
