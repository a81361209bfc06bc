"""Inputs of a log: where they are known, and against what their steps are seen."""

import numpy as np

from ..numerics.arrays import FloatArray

MOST_SAMPLES = 12_000
"""Samples of all logs together that a fit of the joint's equations takes: beyond, every log is cut after as large a
share. It bounds the work, whatever is given: at 10 ms these are 120 s of motion, three logs as the paper's."""

LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Key of a record's notes for spans [s] in which the inputs were not recorded for longer."""


def peaks(v: FloatArray, *, joint: bool) -> FloatArray:
    """Largest magnitude of each input, shape (K,), against which its steps and rests are seen.

    Of the joint, whose voltages are of one kind, the larger one of both; of another device each input's own, but not
    less than a twentieth of the largest, so that the noise of an unused one is no step.
    """
    own: FloatArray = np.max(np.abs(v), axis=0, initial=0.0)
    largest = float(np.max(own, initial=0.0))
    return np.full_like(own, largest) if joint else np.maximum(own, 0.05 * largest)
