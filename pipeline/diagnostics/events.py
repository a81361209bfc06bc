"""Events of a log without any model: switched voltages, their lag, and the rests between with their ring-downs."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..device.device import Device
from ..numerics.arrays import FloatArray, runs_of, sample_interval, samples_of
from ..numerics.metrics import rms, robust_std
from ..scoring.wells import NoWells, Wells, end_of_rest, places_of_rest, rests
from ..signals.noise import REACH, aliased, noise_std

SWITCHED = 0.5  # of an input's largest value: crossing it is a switch
STEP, LEVEL_MOVES = 0.1, 0.02  # of an input's range: least height of a step, and what moves between two levels
STEP_SAMPLES, LEVEL_SAMPLES = 3, 5  # within which a step is over, and for which a level lasts at least
MOST_STEPS = 60  # of one log: more lines than that hide the signals
QUIET = 0.1  # s without a switch before one counts as an event of its own
RING_DOWN = 1.5  # s after a switch-off in which the oscillation is looked at
MOST_RING_DOWNS = 100  # of one log that are looked at
LEAST_SAMPLES = 20
MOST_UNEXPLAINED = 0.3  # RMS of the rest over that of the oscillation, beyond which no frequency is stated
BESIDE_MONOTONE = 0.5  # what a ring-down leaves unexplained, as a share of what the best monotone course leaves
LEAST_DAMPING = 1e-4  # damping ratio below which an oscillation is not a device's own: it is driven, or hum
MAINS_WIDTH = 0.5  # Hz to either side of a line of the mains, where it appears in the samples
FARTHEST = 30.0  # of the logarithms of decay and frequency [1/s], which stay finite
RESTS = {"_left": "well_left", "_right": "well_right", "": "rest"}
"""Key of the places of rest by the suffix of the other facts there, as of ``stiffness_left``."""
BLOCK = 2e-3
"""Window [s] in which a voltage step is sought."""
STILL = 6
SETTLED = 24
"""Blocks without a change that make a plateau, and those of its beginning that are looked at."""
CHANGE = 0.02
"""Share of the largest voltage by which a plateau's blocks may differ."""
HIGH = 0.8
"""Share that is left of a step, from which on its decay is looked at, until noise reaches it."""
LEAST_IN_DECAY = 4
LEAST_STEPS = 3
CROOKED = 0.02
"""RMS share of a step that its exponential may miss; a ramp has 0.05 and more."""


@dataclass(frozen=True)
class RingDown:
    """A damped sinusoid: frequency [Hz] and damping ratio."""

    frequency: float
    damping: float


def ring_down(t: FloatArray, q: FloatArray) -> RingDown | None:
    """Fit ``q = a + b t + e^(−ζω₀t) (c cos ωt + s sin ωt)``; None where there is no such oscillation.

    The four linear numbers are eliminated (Golub & Pereyra 1973, doi:10.1137/0710036), so that decay and frequency are
    left to a search by Levenberg and Marquardt. It starts at the highest line of the spectrum.

    Parameters
    ----------
    t : FloatArray, shape (n,)
        Uniform time [s].
    q : FloatArray, shape (n,)
        Displacement, finite.
    """
    from scipy.optimize import isotonic_regression, leastsq

    if q.size < LEAST_SAMPLES:
        return None
    time = t - t[0]
    span = float(t[-1] - t[0])
    trend = np.column_stack((np.ones_like(time), time / span))
    oscillation = q - trend @ np.linalg.lstsq(trend, q, rcond=None)[0]
    size = float(np.linalg.norm(oscillation))
    if size == 0.0:
        return None
    padded = 8 * q.size
    line = np.argmax(np.abs(np.fft.rfft(oscillation, padded)))
    omega = 2.0 * np.pi * line / (padded * span / (q.size - 1))
    if omega * span < 2.0 * np.pi:
        return None
    columns = np.empty((4, q.size))
    columns[:2] = trend.T

    def rest(logs: FloatArray) -> FloatArray:
        """Part that decay and frequency [1/s], as logarithms, leave unexplained, over the size of the oscillation."""
        decay, angular = np.exp(np.clip(logs, -FARTHEST, FARTHEST))
        swing = np.exp(complex(-decay, angular) * time)
        columns[2], columns[3] = swing.real, swing.imag
        weights = np.linalg.lstsq(columns @ columns.T, columns @ q, rcond=None)[0]
        return np.asarray((q - weights @ columns) / size)

    best, _, outcome, _, _ = leastsq(rest, np.log([2.0 / span, omega]), full_output=True)
    decay, angular = np.exp(np.clip(best, -FARTHEST, FARTHEST))
    unexplained = float(np.linalg.norm(outcome["fvec"]))
    if unexplained > MOST_UNEXPLAINED or angular * span < 2.0 * np.pi:
        return None
    # An overdamped device creeps back and does not ring: what the best monotone courses leave.
    monotone = [np.linalg.norm(q - isotonic_regression(q, increasing=rises).x) for rises in (True, False)]
    if unexplained * size > BESIDE_MONOTONE * min(monotone):
        return None
    return RingDown(float(angular / (2.0 * np.pi)), float(decay / np.hypot(decay, angular)))


def voltage_switches(t: FloatArray, v: FloatArray) -> FloatArray:
    """Times [s] at which an input is switched on or off; of a burst (a chirp) only the first, shape (n,)."""
    on = np.abs(v) > SWITCHED * np.max(np.abs(v), axis=0, initial=0.0)
    ordered = np.sort(np.concatenate([t[1:][switched] for switched in (on[1:] != on[:-1]).T]))
    return np.asarray(ordered[np.diff(ordered, prepend=-np.inf) > QUIET])


def input_steps(t: FloatArray, v: FloatArray) -> FloatArray:
    """Times [s] at which an input jumps from level to level, shape (n,); none if there are more than `MOST_STEPS`.

    A jump is over within `STEP_SAMPLES` samples. Before and after it the input stays for `LEVEL_SAMPLES`, or to the end
    of the log. An input that changes all the time, as a sine or a ramp, has none.
    """
    times = []
    for column in v.T:
        size = float(np.ptp(column))
        moving = runs_of(np.abs(np.diff(column)) > LEVEL_MOVES * size)
        begins, ends = np.array([(rows.start, rows.stop) for rows in moving], dtype=np.int64).reshape(-1, 2).T
        stays = np.concatenate(([LEVEL_SAMPLES], begins[1:] - ends[:-1], [LEVEL_SAMPLES])) >= LEVEL_SAMPLES
        sudden = (ends - begins <= STEP_SAMPLES) & (np.abs(column[ends] - column[begins]) >= STEP * size)
        times.append(t[begins[sudden & stays[:-1] & stays[1:]] + 1])
    apart = np.unique(np.concatenate(times))
    return apart if apart.size <= MOST_STEPS else np.empty(0)


def rest_events(
    records: list[tuple[FloatArray, FloatArray, FloatArray]],
    wells: Wells | NoWells,
    hum: Collection[float] = (),
    *,
    plant: Device,
) -> dict[str, FloatArray]:
    """Places of rest without input, and ring-downs after switch-offs, without any model.

    Parameters
    ----------
    records : list of (t, q, v)
        Uniform records: time [s], displacement with NaN where masked, inputs (N, K).
    wells : Wells or NoWells
        Without wells all rests are one place.
    hum : collection of float
        Mains lines in the displacement [Hz]; what oscillates there, or where it is aliased to, is no ring-down.
    plant : Device
        Its inputs, and whether it is the joint.

    Returns
    -------
    dict of str to FloatArray, shape (n,)
        ``well_left``, ``frequency_left`` [Hz] and ``damping_left`` of each event, the same of the right, or ``rest``,
        ``frequency`` and ``damping`` without wells; only what there is.

    Notes
    -----
    Cost: 1 ms a ring-down in samples of 10 ms, 3 ms in samples of 1 ms. At most `MOST_RING_DOWNS` in a log are looked
    at, evenly over it.
    """
    events = defaultdict[str, list[float]](list)
    for t, q, v in records:
        interval = sample_interval(t)
        quiet = rests(v, interval, plant=plant)
        standing = [rest.start for rest in places_of_rest(q, v, interval, plant=plant)]
        step = -(-len(quiet) // MOST_RING_DOWNS)
        for number, rest in enumerate(quiet):
            end = q[end_of_rest(rest, interval)]
            if not np.isfinite(end).all():
                continue
            place = float(np.median(end))
            side = "" if isinstance(wells, NoWells) else "_right" if place > wells.barrier else "_left"
            if rest.start in standing:
                events[RESTS[side]].append(place)
            ring = _ring_down(t, q, rest, interval, wells) if number % step == 0 else None
            # What does not decay is driven, and so is a line of the mains.
            if (
                ring is not None
                and ring.damping >= LEAST_DAMPING
                and all(abs(ring.frequency - aliased(line, interval)) >= MAINS_WIDTH for line in hum)
            ):
                events[f"frequency{side}"].append(ring.frequency)
                events[f"damping{side}"].append(ring.damping)
    return {key: np.array(values) for key, values in events.items()}


def _ring_down(t: FloatArray, q: FloatArray, rest: slice, interval: float, wells: Wells | NoWells) -> RingDown | None:
    stop = min(rest.stop, rest.start + round(RING_DOWN / interval))
    part = q[rest.start : stop]
    if rest.start == 0 or not np.isfinite(part).all():
        return None
    first = rest.start
    if isinstance(wells, Wells):
        side = wells.side(part)
        crossings = np.flatnonzero(side[1:] != side[:-1])
        first += int(crossings[-1]) + 1 if crossings.size else 0
    return ring_down(t[first:stop], q[first:stop])


@dataclass(frozen=True)
class ConverterLag:
    """Time constant of one converter.

    Attributes
    ----------
    lag : float
        Median over the steps [s].
    scatter : float
        Robust standard deviation of its logarithm over the steps.
    steps : int
        Their number.
    """

    lag: float
    scatter: float
    steps: int


def converter_lag(records: Sequence[tuple[FloatArray, FloatArray]]) -> ConverterLag | None:
    """The lag of one converter from the steps of some logs; None where they have fewer than `LEAST_STEPS`.

    Parameters
    ----------
    records : sequence of (t, v)
        Uniform records: time [s] and measured voltage [V], both of shape (N,).

    Notes
    -----
    In records of 1 ms a lag of 2 to 10 ms is found to 2 %, and one of 1 ms 13 % too long. One of 14 or 20 ms is found 4
    or 10 % too short, as the decay goes on in the plateau. A step with a shorter lag is over before it is seen.
    """
    lags = np.concatenate([step_lags(t, v) for t, v in records])
    if lags.size < LEAST_STEPS:
        return None
    logs = np.log(lags)
    middle = float(np.median(logs))
    return ConverterLag(float(np.exp(middle)), robust_std(logs - middle), lags.size)


def step_lags(t: FloatArray, v: FloatArray) -> FloatArray:
    """The time constant [s] of every step of a measured voltage, shape (n,).

    A converter responds to a commanded step with ``v = b + (a − b) e^(−t/lag)`` from the plateau a to the plateau b.
    The logarithm of the share that is left of a step falls on a line, whose slope is −1/lag; no command need be known.

    Parameters
    ----------
    t, v : FloatArray, shape (N,)
        Uniform time [s], voltage [V]; a log with NaN in it has steps between them.

    Notes
    -----
    Cost: O(N), most of it the estimate of the noise.
    """
    interval = sample_interval(t)
    size = samples_of(BLOCK, interval)
    blocks = v[: v.size // size * size].reshape(-1, size)
    largest = float(np.nanmax(np.abs(v), initial=0.0))
    if len(blocks) < 2 * STILL or largest == 0.0:
        return np.empty(0)
    reached = REACH * noise_std(v[np.isfinite(v)])
    means = blocks.mean(axis=1)
    calm = runs_of(np.append(False, np.abs(np.diff(means)) < CHANGE * largest))
    plateaus = [run for run in calm if run.stop - run.start >= STILL]
    lags = []
    for before, after in pairwise(plateaus):
        count = min(after.stop - after.start, SETTLED)
        end = slice(after.start + count // 2, after.start + count)  # where a decay is over
        first = float(means[before.stop - STILL // 2 : before.stop - 1].mean())
        last = float(means[end].mean())
        low = reached / abs(last - first)
        if low < HIGH:
            share = (v[(before.stop - 1) * size : end.stop * size] - last) / (first - last)
            lags.append(_decay(share, interval, low))
    return np.array([lag for lag in lags if lag is not None])


def _decay(share: FloatArray, interval: float, low: float) -> float | None:
    """Time constant [s] of a step's rest until `low`: a line through its logarithm, weighted by its square.

    None where it is shorter than the sample interval: then the first sample alone shows whether an edge is a decay.
    """
    gone = np.flatnonzero(~(share > low))
    started = np.flatnonzero(share < HIGH)
    if not (gone.size and started.size) or gone[0] - started[0] < LEAST_IN_DECAY:
        return None
    part = share[started[0] : gone[0]]
    weights = part**2
    time = interval * np.arange(part.size)
    time = time - np.average(time, weights=weights)
    line = np.log(part)
    middle = np.average(line, weights=weights)
    slope = float(np.average(time * line, weights=weights) / np.average(time**2, weights=weights))
    straight = rms(np.exp(middle + slope * time) - part) < CROOKED
    return -1.0 / slope if straight and -1.0 / interval < slope < 0.0 else None
