"""The probability that a plain pulse switches an identified joint, over its voltage and its duration."""

from dataclasses import dataclass

import numpy as np

from pipeline.choices import Well
from pipeline.control.ensemble import Ensemble
from pipeline.control.estimator import PERIOD
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import NORMAL_90
from pipeline.numerics.progress import OnProgress, silent

REST = 1.6
"""Time [s] after the pulse's end at which the well counts."""
VOLTAGES, DURATIONS = 33, 41
REACH = 3
"""Cells about the estimate's boundary in which the draws are run."""
_AT_ONCE = 256
LEAST_VOLTAGE, SHORTEST, LONGEST = 0.3, 0.02, 1.0
"""Of the map: lowest voltage as a share of the largest, shortest and longest pulse [s]."""


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
        Estimate and draws from the posterior, or an estimate alone. The estimate is run in every cell, the draws in the
        cells within `REACH` of one where the estimate's outcome changes: narrow tongues in which a long pulse brings
        the joint back are not missed.
    wells : (float, float, float)
        Readings [m] of left well, saddle and right well.
    to : {"left", "right"}
        Where the pulse is to bring it.
    on_progress : callable
        Told the share that is done.

    Notes
    -----
    Cost: 1353 runs of 1.7 to 2.6 s for the estimate and some 500 for each draw, 10 s.
    """
    voltages = np.linspace(LEAST_VOLTAGE, 1.0, VOLTAGES) * joint.highest
    durations = np.geomspace(SHORTEST, LONGEST, DURATIONS)
    left, saddle, right = wells
    start, side = (left, 0) if to == "right" else (right, 1)
    members = range(1, len(joint.constants)) or range(1)
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
    count = len(members)
    total = count * estimate
    for which in members:
        on_progress(f"to the {to}", which / (count + 1))
        rows, columns = open_cells.T
        total[rows, columns] += switched(open_cells, which) - estimate[rows, columns]
    share = total / count
    middle = (share + NORMAL_90**2 / (2 * count)) / (1 + NORMAL_90**2 / count)
    half = NORMAL_90 / (1 + NORMAL_90**2 / count) * np.sqrt(share * (1 - share) / count + NORMAL_90**2 / (4 * count**2))
    return SwitchingMap(to, voltages, durations, share, np.maximum(middle - half, 0.0), np.minimum(middle + half, 1.0))


def _near_boundary(outcome: FloatArray) -> "np.ndarray[tuple[int, int], np.dtype[np.bool_]]":
    """Cells within `REACH` of both outcomes."""
    from scipy.ndimage import maximum_filter, minimum_filter

    size = 2 * REACH + 1
    return np.asarray(maximum_filter(outcome, size) != minimum_filter(outcome, size))


def pulses(voltages: FloatArray, durations: FloatArray, side: int) -> FloatArray:
    """Commands (P, M, 2) [V] of pulses with these voltages [V] and durations [s], each of shape (P,), and the rest."""
    length = round((float(durations.max()) + REST) / PERIOD)
    t = np.arange(length) * PERIOD
    made = np.zeros((len(voltages), length, 2))
    # The last millisecond of a pulse carries what is left of its duration, as a share of the square.
    share = np.clip((durations[:, None] - t) / PERIOD, 0.0, 1.0)
    made[:, :, side] = voltages[:, None] * np.sqrt(share)
    return made
