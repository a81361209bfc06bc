"""Rise and settling times of the switches between the wells, measured and simulated."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray, IntArray, samples_of
from ..numerics.metrics import settling_index
from .intervals import Interval, median_interval
from .wells import LONGEST_WINDOW, Wells

STEP = 0.2  # of the largest voltage: a change by more between two looks 20 ms apart is a step, a chirp's slope is not
STEP_WINDOW = 0.02  # s
SHORTEST_RESPONSE = 0.8  # s; two ring periods, less shows no settling
SETTLED = 0.1  # of the step in q


@dataclass(frozen=True)
class StepResponse:
    """How one switch went.

    Attributes
    ----------
    rise_s : float or None
        From 10 to 90 % of the way to the final value [s]; None if the way is not completed.
    settling_s : float or None
        From the voltage step until q stays within ±10 % of the step [s]; None if it does not for the last 0.4 s.
    """

    rise_s: float | None
    settling_s: float | None


@dataclass(frozen=True)
class ResponseErrors:
    """Median absolute errors of the simulated times over the switches of a record.

    Attributes
    ----------
    switches : int
        Switches of the measurement whose response is long enough to be judged.
    followed : int
        Those in which the simulation switched too.
    rise_s, settling_s : float or None
        Median of |simulated − measured| [s] over the switches followed where both times exist; None if there is none.
    rise_interval, settling_interval : Interval or None
        95 % bootstrap intervals of these medians over the switches; None with fewer than four.
    """

    switches: int
    followed: int
    rise_s: float | None
    settling_s: float | None
    rise_interval: Interval | None
    settling_interval: Interval | None


def voltage_steps(v: FloatArray, interval: float, plant: Device) -> IntArray:
    """The last rows before an input jumps by more than `STEP` of its `peaks`, one per jump, shape (n,)."""
    lag = samples_of(STEP_WINDOW, interval)
    jump = np.zeros(len(v), dtype=bool)
    jump[lag:] = np.any(np.abs(v[lag:] - v[:-lag]) > STEP * plant.peaks(v), axis=1)
    rises = np.flatnonzero(jump & ~np.concatenate([[False], jump[:-1]]))
    return np.asarray(rises - 1, dtype=np.int64)


def step_response(q: FloatArray, interval: float) -> StepResponse:
    """Rise and settling time of q from the first row, a voltage step, to the last, just before the next.

    The final value is the mean of the last 0.4 s, one period of the ring-down.

    Parameters
    ----------
    q : FloatArray, shape (N,)
        Displacement, finite.
    interval : float
        Sample interval [s].
    """
    window = samples_of(LONGEST_WINDOW, interval)
    final = float(np.mean(q[-window:]))
    step = final - q[0]
    if step == 0.0:
        return StepResponse(None, None)
    way = (q - q[0]) / step
    ten, ninety = (np.flatnonzero(way >= share) for share in (0.1, 0.9))
    rise = float(ninety[0] - ten[0]) * interval if ninety.size else None
    settled = int(settling_index(way - 1.0, SETTLED))
    return StepResponse(rise, settled * interval if settled <= q.size - window else None)


def response_errors(
    measured: FloatArray,
    calculated: FloatArray,
    v: FloatArray,
    interval: float,
    wells: Wells,
    rng: np.random.Generator,
    *,
    plant: Device,
) -> ResponseErrors:
    """Compare the times of all switches.

    A switch is a segment between two voltage steps, at least 0.8 s long and without masked rows, that starts on one
    side of the barrier and ends on the other.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        q [m]; NaN where masked, NaN after divergence.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Sample interval [s].
    wells : Wells
        The wells of the device.
    rng : numpy.random.Generator
        For the bootstrap.
    plant : Device
        Its inputs, and whether it is the joint.
    """
    pairs: list[tuple[StepResponse, StepResponse]] = []
    switches = 0
    for rows in _stretches(voltage_steps(v, interval, plant=plant), len(v), samples_of(SHORTEST_RESPONSE, interval)):
        if not np.all(np.isfinite(measured[rows])) or not _switches(measured[rows], wells, interval):
            continue
        switches += 1
        if np.all(np.isfinite(calculated[rows])) and _switches(calculated[rows], wells, interval):
            pairs.append((step_response(measured[rows], interval), step_response(calculated[rows], interval)))
    rise = _errors([(a.rise_s, b.rise_s) for a, b in pairs])
    settling = _errors([(a.settling_s, b.settling_s) for a, b in pairs])
    bands = median_interval(rise, rng), median_interval(settling, rng)
    return ResponseErrors(switches, len(pairs), _median(rise), _median(settling), *bands)


def _median(errors: Sequence[float]) -> float | None:
    return float(np.median(errors)) if errors else None


def _stretches(steps: IntArray, samples: int, shortest: int) -> list[slice]:
    edges = [*(int(s) for s in steps), samples]
    return [slice(a, b) for a, b in itertools.pairwise(edges) if b - a >= shortest]


def _switches(q: FloatArray, wells: Wells, interval: float) -> bool:
    last = wells.side(q[-samples_of(LONGEST_WINDOW, interval) :])
    return bool(last.all() == last.any() and last[0] != wells.side(q[:1])[0])


def _errors(pairs: Sequence[tuple[float | None, float | None]]) -> list[float]:
    return [abs(b - a) for a, b in pairs if a is not None and b is not None]
