"""The array types that the numerics exchange."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


class Samples(Protocol):
    """A column that need not fit into memory: its size is known, and a slice of it is an array. Arrays are samples."""

    @property
    def size(self) -> int:
        """Number of samples."""

    def __getitem__(self, rows: slice, /) -> FloatArray:
        """The samples of a range of rows (step 1, bounds not negative), read-only."""
