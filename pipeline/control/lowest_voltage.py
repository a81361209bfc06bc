"""The lowest voltage at which a plain pulse switches an identified joint, with the band of what is known of it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.choices import Well
from pipeline.control.ensemble import Converters, Ensemble, ensemble_at
from pipeline.control.switching_map import pulses
from pipeline.models.hybrid.model import HybridModel
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import NORMAL_90

DURATIONS = (0.1, 0.2, 0.5)
"""Of the pulses whose lowest voltages are told [s]."""
TYPICAL = 0.2
"""Duration of the pulse by which the draws of a map are judged [s]."""
LEAST, COARSE = 0.1, 155
"""Lowest voltage at which a joint is tried, as a share of the largest, and how many from there: in steps of 1.5 %."""
STEP, REACH, HALVINGS = 1e-3, 0.01, 24
"""Length [widths, or logarithm of a lag] of the differences, and the bisection that finds what the voltage becomes: its
logarithm is right to 1e-9. The parameters move along columns of their covariance's factor. Those that are moved singly
leave the valley in which the data hold them, where the voltage is curved: the deviation of one joint was 1.25 % so."""


@dataclass(frozen=True)
class LowestVoltage:
    """Of pulses of one duration to one well.

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
    """The lowest voltage at which a pulse of `duration` [s] brings the joint to the well `to`, from rest in the other.

    Its logarithm's standard deviation is that of parameters of the covariance E Eᵀ that the training data show
    (`HybridModel.band_spread`), to first order; with the converters' lags and the probe.

    Parameters
    ----------
    model : HybridModel
        The identified joint.
    converters : Converters
        What is known of them.
    wells : (float, float, float)
        Readings [m] of left well, saddle and right well.
    to : {"left", "right"}
        Where the pulse is to bring it.
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
    found, until = first
    lengths = np.linalg.norm(model.band_spread, axis=0)
    columns = model.band_spread[:, lengths > 0.0].T / lengths[lengths > 0.0, None]
    sides = np.concatenate([np.zeros((len(columns), 2)), np.eye(2)])
    steps = STEP * np.concatenate([columns, np.zeros((2, len(model.theta)))])
    thetas, lags = (
        np.concatenate([model.theta + steps, model.theta - steps]),
        lags * np.exp(STEP * np.concatenate([sides, -sides])),
    )
    logs = _logarithms(ensemble_at(model, thetas, lags, np.ones(len(thetas))), wells, to, duration, found)
    slopes = np.subtract(*np.split(logs, 2)) / (2.0 * STEP)
    of_parameters = float(np.linalg.norm(slopes[:-2] * lengths[lengths > 0.0]))
    of_lags = float(converters.spread * np.linalg.norm(slopes[-2:]))
    half = NORMAL_90 * float(np.linalg.norm([of_parameters, of_lags, converters.probe]))
    low, high = found * np.exp([-half, half])
    return LowestVoltage(duration, found, float(low), float(high), until, of_parameters, of_lags, converters.probe)


def uncertain(joint: Ensemble, lowest: Sequence[LowestVoltage | None]) -> Ensemble:
    """The same joint with draws whose voltages err as its lowest voltage may: for pulses near it.

    What the parameters do acts as a voltage that is too high or too low: on four joints its deviations at 0.1 s and at
    0.8 s were 0.72 to 1.36 times that at `TYPICAL`, and correlated with it by 0.83 to 1.00. So all pulses are scaled
    alike, by the first of `lowest` that lasts as long.
    """
    known = [each for each in lowest if each is not None]
    if not known:
        return joint
    one = next((each for each in known if each.duration >= TYPICAL), known[-1])
    return joint.erring(float(np.hypot(one.of_parameters, one.of_probe)))


def _switched(
    joint: Ensemble, squares: FloatArray, wells: tuple[float, float, float], to: Well
) -> "np.ndarray[tuple[int, int], np.dtype[np.bool_]]":
    """Whether runs under squared voltages [V²] end in the well `to`, shape (P, B)."""
    left, saddle, right = wells
    ends = joint.play(squares, left if to == "right" else right)[:, :, -1]
    return np.asarray((ends > saddle) == (to == "right"))


def _unit(joint: Ensemble, to: Well, duration: float) -> FloatArray:
    """Squared voltages of a pulse of one volt, shape (1, B, H, 2) [V²]."""
    return joint.squares(pulses(np.ones(1), np.array([duration]), 0 if to == "right" else 1))


def _first(
    joint: Ensemble, wells: tuple[float, float, float], to: Well, duration: float
) -> tuple[float, float | None] | None:
    """The first voltage [V] from below that switches the one joint, to 1e-9, and the next of those tried that does not.

    None where none switches it.
    """
    unit, volts = _unit(joint, to, duration), joint.highest * np.geomspace(LEAST, 1.0, COARSE)
    over = _switched(joint, volts[:, None, None, None] ** 2 * unit, wells, to)[:, 0]
    if over[0] or not over.any():
        return None
    at = int(np.argmax(over))
    middle = float(np.sqrt(volts[at - 1] * volts[at]))
    beyond = volts[at:][~over[at:]]
    first = float(np.exp(_logarithms(joint, wells, to, duration, middle)[0]))
    return first, float(beyond[0]) if beyond.size else None


def _logarithms(
    joint: Ensemble, wells: tuple[float, float, float], to: Well, duration: float, about: float
) -> FloatArray:
    """Logarithms of the lowest voltages [V] of the joints, shape (B,), within `REACH` about one that is known."""
    unit = _unit(joint, to, duration)
    low, high = np.log(about) + REACH * np.array([[-1.0], [1.0]]) * np.ones(len(joint.gains))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        over = _switched(joint, np.exp(2.0 * middle)[None, :, None, None] * unit, wells, to)[0]
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    found: FloatArray = 0.5 * (low + high)
    return found
