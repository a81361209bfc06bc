"""The inputs of a device, as tables of signals hold them."""

from collections.abc import Mapping, Sequence

import numpy as np

from pipeline.numerics.arrays import BoolArray, FloatArray

LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Of a record's notes: spans [s] in which the inputs were not recorded for longer."""


def voltages(table: Mapping[str, FloatArray]) -> FloatArray:
    """The inputs v1, v2 of a table, shape (N, 1) or (N, 2)."""
    return np.column_stack([table[name] for name in ("v1", "v2") if name in table])


def peaks(v: FloatArray, *, joint: bool) -> FloatArray:
    """Largest magnitude of each input, shape (K,), against which its steps and rests are seen.

    Of the joint, whose voltages are of one kind, the larger one of both; of another device each input's own, but not
    less than a twentieth of the largest, so that the noise of an unused one is none.
    """
    own: FloatArray = np.max(np.abs(v), axis=0, initial=0.0)
    largest = float(np.max(own, initial=0.0))
    return np.full_like(own, largest) if joint else np.maximum(own, 0.05 * largest)


def unknown_rows(t: FloatArray, spans: Sequence[Sequence[float]]) -> BoolArray:
    """Rows strictly inside `spans` [s] without inputs, shape (N,)."""
    inside = np.zeros(len(t), dtype=np.bool_)
    for start, stop in spans:
        inside[np.searchsorted(t, start, side="right") : np.searchsorted(t, stop)] = True
    return inside
