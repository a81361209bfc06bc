"""How sure a model is of the well after each pulse: probabilities from an ensemble of its own free runs.

Near the separatrix an arbitrarily small error decides the well, so a single simulation says less than it seems to.
Each member of the ensemble is a draw from the posterior of the parameters; the share that ends on the right is the
probability that the model itself gives to that outcome.
"""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.scoring.wells import Rest, Wells

SURE = 0.9
"""Probability beyond which an outcome counts as decided."""


@dataclass(frozen=True)
class PulseOutcomes:
    """Outcome of every rest after a pulse.

    Attributes
    ----------
    right : FloatArray, shape (R,)
        Probability of the right well (Laplace's rule, so never exactly 0 or 1).
    ambiguous : BoolArray, shape (R,)
        True where neither well has the probability `SURE`: the outcome hinges on less than the model knows.
    """

    right: FloatArray
    ambiguous: BoolArray

    def brier_score(self, went_right: BoolArray) -> float:
        """Mean squared error of the probabilities against what happened; 0.25 is a coin, 0 certainty that came true."""
        return float(np.mean((self.right - went_right) ** 2))


def pulse_outcomes(ensemble: FloatArray, rests: list[Rest], wells: Wells) -> PulseOutcomes:
    """Probabilities from an ensemble of free runs.

    Parameters
    ----------
    ensemble : FloatArray, shape (count, N)
        q of each member; NaN after divergence, which counts for neither well.
    rests : list of Rest
        Rests without voltage, as `pipeline.scoring.wells.rests` finds them.
    wells : Wells
        The two wells.
    """
    right = np.empty(len(rests))
    for i, rest in enumerate(rests):
        end = ensemble[:, rest.stop - 1]
        finite = np.isfinite(end)
        right[i] = (np.count_nonzero(wells.side(end[finite])) + 1.0) / (np.count_nonzero(finite) + 2.0)
    return PulseOutcomes(right, np.maximum(right, 1.0 - right) < SURE)
