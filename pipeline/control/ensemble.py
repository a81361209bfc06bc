"""Many runs of an identified joint, its estimate and draws from its posterior, under commanded voltages.

From them the switching map: the probability that a plain pulse switches the joint, over its voltage and its duration.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from pipeline.joint.condensed_runs import run_joints
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray

INTERVAL = 4e-3
"""Sample interval of the runs [s]."""
COMMAND = 1e-3
"""Interval of the commands [s]."""
DATA_SHEET, MARGIN = (0.36, 0.003), (0.5, 0.01)
"""Standard deviations of a converter's lag (of its logarithm) and of its voltage (relative) over the draws: of the
instruments (lags of 2 to 7 ms about 4 ms, a probe's accuracy), for probabilities; wider ones, for robust pulses."""
_SEED = 1911
_FINE = 4  # voltages behind the lag in an interval of the commands


@dataclass(frozen=True)
class Ensemble:
    """One joint as B parameter vectors; the first is the estimate.

    Attributes
    ----------
    constants, weights, basis : FloatArray
        See `run_joints`.
    seen : FloatArray, shape (B, 2)
        Gain and offset [m] of each laser.
    delays : FloatArray, shape (B,)
        By which voltages act later [s].
    lags, gains : FloatArray, shape (B,)
        Time constants of the converters [s], and voltages that act over those commanded: a log of measured voltages
        tells neither, so the draws spread them.
    highest : float
        Largest trained voltage [V].
    steps : int
        Runge-Kutta steps in `INTERVAL`.
    wall, lead : float
        See `run_joints`.
    """

    constants: FloatArray
    weights: FloatArray
    basis: FloatArray
    seen: FloatArray
    delays: FloatArray
    lags: FloatArray
    gains: FloatArray
    highest: float
    steps: int
    wall: float
    lead: float

    def some(self, count: int) -> "Ensemble":
        """The first `count` vectors."""
        return self.chosen(slice(0, count))

    def chosen(self, which: slice) -> "Ensemble":
        """Some of the vectors."""
        own = ("constants", "weights", "seen", "delays", "lags", "gains")
        return replace(self, **{name: getattr(self, name)[which] for name in own})

    def run(self, commands: FloatArray, start: float) -> FloatArray:
        """Readings of the laser [m] every `INTERVAL`, shape (P, B, N), from rest at the reading `start` [m].

        Parameters
        ----------
        commands : FloatArray, shape (P, M, 2)
            Commanded voltages [V] of P runs, one every `COMMAND`, held in between.
        start : float
            Where they begin [m].

        Notes
        -----
        Cost: 60 µs for a run of 2 s.
        """
        plays, count = len(commands), len(self.constants)
        # An interval without voltage first: a run begins at rest under its first voltages.
        commands = np.pad(commands, ((0, 0), (round(INTERVAL / COMMAND), 0), (0, 0)))
        samples = round(commands.shape[1] * COMMAND / INTERVAL) + 1
        half = 2 * self.steps * (samples - 1) + 1
        width = INTERVAL / (2 * self.steps)
        squares = [
            gain**2 * _mean_squares(_lagged(commands, lag), half, width, delay)
            for gain, lag, delay in zip(self.gains, self.lags, self.delays, strict=True)
        ]
        u = np.stack(squares, axis=1).reshape(plays * count, half, 2)
        runs = run_joints(
            np.tile(self.constants, (plays, 1)), np.tile(self.weights, (plays, 1, 1)), self.basis, u,
            np.arange(plays * count), np.tile(self.seen, (plays, 1)), np.array([start, 0.0]), np.zeros(0),
            np.zeros(samples), INTERVAL, self.steps, self.wall, self.lead,
        )  # fmt: skip
        return np.ascontiguousarray(runs[:, 1:, 0].reshape(plays, count, samples - 1))


def ensemble_of(model: HybridModel, draws: int, lag: float, instruments: tuple[float, float] = DATA_SHEET) -> Ensemble:
    """The estimate of an identified joint and `draws` draws from its posterior; the converters lag by `lag` [s]."""
    condensed, rng = model.joint, np.random.default_rng(_SEED)
    thetas = np.concatenate([model.theta[None], model.draws(draws)]) if draws else model.theta[None]
    seen = [condensed.instruments(theta) for theta in thetas]
    constants = np.array([condensed.constants(theta) for theta in thetas])
    weights = np.array([condensed.weights(theta) for theta in thetas])
    return Ensemble(
        constants=constants,
        weights=weights,
        basis=condensed.basis,
        seen=np.array([[one.gain, one.offset] for one in seen]),
        delays=np.array([one.delay for one in seen]),
        lags=lag * np.concatenate([[1.0], np.exp(instruments[0] * rng.standard_normal(draws))]),
        gains=np.concatenate([[1.0], 1.0 + instruments[1] * rng.standard_normal(draws)]),
        highest=condensed.largest_voltage,
        steps=condensed.substeps(model.theta, INTERVAL),
        wall=condensed.q_stop,
        lead=condensed.lead,
    )


def _lagged(commands: FloatArray, lag: float) -> FloatArray:
    """Voltages behind the converters' lag, `_FINE` in each interval of the commands, shape (P, _FINE M, 2) [V]."""
    from scipy.signal import lfilter

    fine = np.repeat(commands, _FINE, axis=1)
    if lag <= 0.0:
        return fine
    kept = float(np.exp(-COMMAND / _FINE / lag))
    return np.asarray(lfilter([1.0 - kept], [1.0, -kept], fine, axis=1))


def _mean_squares(fine: FloatArray, count: int, width: float, delay: float) -> FloatArray:
    """Means of v² [V²] in windows of `width` [s] about the half steps, `delay` [s] earlier, shape (P, count, 2)."""
    total = np.concatenate([np.zeros((len(fine), 1, 2)), np.cumsum(fine**2, axis=1)], axis=1)
    step = COMMAND / _FINE
    edges = np.clip(((np.arange(count + 1) - 0.5) * width - delay) / step, 0.0, fine.shape[1])
    lower = np.minimum(edges.astype(np.int64), fine.shape[1] - 1)
    share = (edges - lower)[None, :, None]
    at = (1.0 - share) * total[:, lower] + share * total[:, lower + 1]
    length = np.maximum(np.diff(edges), 1e-9)[None, :, None]
    means: FloatArray = np.diff(at, axis=1) / length
    return np.where(np.diff(edges)[None, :, None] > 1e-9, means, 0.0)


Well = Literal["left", "right"]
REST = 1.6
"""Time [s] after the pulse's end at which the well counts."""
VOLTAGES, DURATIONS = 33, 41
REACH = 3
"""Cells about the estimate's boundary in which the draws are run."""
_AT_ONCE = 256
LEAST_VOLTAGE, SHORTEST, LONGEST = 0.3, 0.02, 1.0
"""Of the map: lowest voltage as a share of the largest, shortest and longest pulse [s]."""
BAND = 1.645
"""Standard deviations of the central 90 %."""


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


def switching_map(joint: Ensemble, wells: tuple[float, float, float], to: Well) -> SwitchingMap:
    """The map of a pulse on the side that pulls towards the well `to`, from rest in the other one.

    Parameters
    ----------
    joint : Ensemble
        Estimate and draws from the posterior. The estimate is run in every cell, the draws in the cells within
        `REACH` of one where the estimate's outcome changes: narrow tongues in which a long pulse brings the joint back
        are not missed.
    wells : (float, float, float)
        Readings [m] of left well, saddle and right well.
    to : {"left", "right"}
        Where the pulse is to bring it.

    Notes
    -----
    Cost: 1353 runs of 1.7 to 2.6 s for the estimate and some 500 for each draw, 2 s.
    """
    voltages = np.linspace(LEAST_VOLTAGE, 1.0, VOLTAGES) * joint.highest
    durations = np.geomspace(SHORTEST, LONGEST, DURATIONS)
    left, saddle, right = wells
    start, side = (left, 0) if to == "right" else (right, 1)
    count = len(joint.constants)
    everywhere = np.argwhere(np.ones((VOLTAGES, DURATIONS), dtype=bool))

    def switched(cells: "np.ndarray[tuple[int, int], np.dtype[np.int64]]", which: int) -> FloatArray:
        """Whether one member of the ensemble ends in the other well, for each pulse (cells,)."""
        runs = joint.chosen(slice(which, which + 1))
        found = np.empty(len(cells))
        for part in range(0, len(cells), _AT_ONCE):
            some = cells[part : part + _AT_ONCE]
            ends = runs.run(pulses(voltages[some[:, 0]], durations[some[:, 1]], side), start)[:, 0, -1]
            found[part : part + _AT_ONCE] = (ends > saddle) == (to == "right")
        return found

    estimate = switched(everywhere, 0).reshape(VOLTAGES, DURATIONS)
    open_cells = np.argwhere(_near_boundary(estimate))
    total = count * estimate
    for which in range(1, count):
        rows, columns = open_cells.T
        total[rows, columns] += switched(open_cells, which) - estimate[rows, columns]
    share = total / count
    middle = (share + BAND**2 / (2 * count)) / (1 + BAND**2 / count)
    half = BAND / (1 + BAND**2 / count) * np.sqrt(share * (1 - share) / count + BAND**2 / (4 * count**2))
    return SwitchingMap(to, voltages, durations, share, np.maximum(middle - half, 0.0), np.minimum(middle + half, 1.0))


def _near_boundary(outcome: FloatArray) -> "np.ndarray[tuple[int, int], np.dtype[np.bool_]]":
    """Cells within `REACH` of both outcomes."""
    from scipy.ndimage import maximum_filter, minimum_filter

    size = 2 * REACH + 1
    return np.asarray(maximum_filter(outcome, size) != minimum_filter(outcome, size))


def pulses(voltages: FloatArray, durations: FloatArray, side: int) -> FloatArray:
    """Commands (P, M, 2) [V] of pulses with these voltages [V] and durations [s], each of shape (P,), and the rest."""
    length = round((float(durations.max()) + REST) / COMMAND)
    t = np.arange(length) * COMMAND
    made = np.zeros((len(voltages), length, 2))
    # The last millisecond of a pulse carries what is left of its duration, as a share of the square.
    share = np.clip((durations[:, None] - t) / COMMAND, 0.0, 1.0)
    made[:, :, side] = voltages[:, None] * np.sqrt(share)
    return made
