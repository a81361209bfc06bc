"""The array types that the numerics exchange."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
SingleArray = NDArray[np.float32]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


def sample_interval(t: FloatArray) -> float:
    """Mean step of a uniform time base of at least two samples."""
    return float((t[-1] - t[0]) / (len(t) - 1))


def samples_of(duration: float, interval: float) -> int:
    """Samples in a duration, one at least; both in the same unit."""
    return max(1, round(duration / interval))


def runs_of(marked: BoolArray) -> list[slice]:
    """The rows of each run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], marked.astype(np.int8), [0]))))
    return [slice(int(a), int(b)) for a, b in edges.reshape(-1, 2)]


def bridged(values: FloatArray, keep: BoolArray) -> FloatArray:
    """`values` with a line across the samples that are not kept."""
    samples = np.arange(len(values))
    return np.interp(samples, samples[keep], values[keep])
