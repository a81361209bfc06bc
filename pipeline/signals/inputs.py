"""The inputs of a device, as tables of signals hold them."""

from collections.abc import Mapping

import numpy as np

from pipeline.numerics.arrays import FloatArray


def voltages(table: Mapping[str, FloatArray]) -> FloatArray:
    """The inputs v1, v2 of a table, shape (N, 1) or (N, 2)."""
    return np.column_stack([table[name] for name in ("v1", "v2") if name in table])
