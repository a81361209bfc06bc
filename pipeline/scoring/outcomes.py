"""Wells of a free run against the measured ones: agreement, outcomes of pulses, and how sure the model is of them."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.scoring.wells import Wells, end_of_rest, places_of_rest

SURE = 0.9
"""Probability of a well beyond which an outcome counts as decided."""


def in_same_well(measured: FloatArray, calculated: FloatArray, wells: Wells) -> FloatArray:
    """1 where both are on the same side of the barrier, 0 where not, NaN where nothing is measured, shape (N,).

    A calculated NaN (after divergence) agrees with nothing. The mean over the rows measured is the well agreement.
    """
    same = (wells.side(measured) == wells.side(calculated)) & np.isfinite(calculated)
    return np.where(np.isfinite(measured), same.astype(np.float64), np.nan)


@dataclass(frozen=True)
class SwitchAccuracy:
    """How many pulses ended in the measured well.

    Attributes
    ----------
    pulses : int
        Pulses after which the measurement rests in one well.
    correct : int
        Those after which the simulation rests in the same well.
    """

    pulses: int
    correct: int

    @property
    def share(self) -> float | None:
        """`correct` over `pulses`; None without a pulse."""
        return self.correct / self.pulses if self.pulses else None


def switch_accuracy(
    measured: FloatArray, calculated: FloatArray, v: FloatArray, interval: float, wells: Wells, *, joint: bool
) -> SwitchAccuracy:
    """Compare the wells in which both rest after each voltage pulse.

    A pulse counts if it is followed by at least 0.3 s without voltage at whose end (up to 0.4 s) the measurement stays
    on one side of the barrier; the simulation is correct if it stays on that side too. Pauses inside a chirp are
    shorter, so a chirp counts as one pulse. After a divergence everything is wrong.

    Parameters
    ----------
    measured, calculated : FloatArray, shape (N,)
        q, NaN where masked, and q of the free run, NaN after divergence.
    v : FloatArray, shape (N, K)
        Inputs.
    interval : float
        Sample interval [s].
    wells : Wells
        The wells of the device.
    joint : bool
        Whether it can be the bistable joint, see `places_of_rest`.
    """
    pulses = correct = 0
    for rest in places_of_rest(measured, v, interval, joint=joint):
        rows = end_of_rest(rest, interval)
        finite = np.isfinite(measured[rows])
        if rest.start == 0 or not finite.any():
            continue
        side = wells.side(measured[rows])[finite]
        if side.any() != side.all():
            continue
        pulses += 1
        simulated = calculated[rows][finite]
        correct += bool(np.all(np.isfinite(simulated)) and np.all(wells.side(simulated) == side[0]))
    return SwitchAccuracy(pulses, correct)


@dataclass(frozen=True)
class PulseOutcomes:
    """Outcome of every rest after a pulse.

    Attributes
    ----------
    probability_right : FloatArray, shape (R,)
        Probability of the right-hand well (Laplace's rule, so never exactly 0 or 1).
    ambiguous : BoolArray, shape (R,)
        True where neither well has the probability `SURE`: the outcome hinges on less than the model knows.
    """

    probability_right: FloatArray
    ambiguous: BoolArray


def pulse_outcomes(ensemble: FloatArray, rests: list[slice], wells: Wells) -> PulseOutcomes:
    """How sure a model is of the well after each pulse: the share of an ensemble of its own free runs.

    Near the separatrix an arbitrarily small error decides the well, so a single simulation says less than it seems to.
    Each member of the ensemble is a draw from the posterior of the parameters.

    Parameters
    ----------
    ensemble : FloatArray, shape (count, N)
        q of each member; NaN after divergence, which counts for neither well.
    rests : list of slice
        Rests without voltage, as `rests` finds them.
    wells : Wells
        The two wells.
    """
    right_hand = np.empty(len(rests))
    for i, rest in enumerate(rests):
        end = ensemble[:, rest.stop - 1]
        finite = np.isfinite(end)
        right_hand[i] = (np.count_nonzero(wells.side(end[finite])) + 1.0) / (np.count_nonzero(finite) + 2.0)
    return PulseOutcomes(right_hand, np.maximum(right_hand, 1.0 - right_hand) < SURE)
