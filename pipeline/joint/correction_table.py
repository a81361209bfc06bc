"""The RBF corrections as tables of quintics: the same curves at a cost that does not depend on their number of centres.

Between nodes an eighth of σ apart every curve is the quintic with its values, slopes and curvatures at both ends,
which misses a Gaussian by 1e-9 of its height. Curves are twice continuously differentiable, and their slopes are those
of the quintics, so forces stay gradients. 6.5 σ beyond the outermost centres every Gaussian is below 1e-9 and is taken
as zero.
"""

import numba
import numpy as np

from pipeline.joint.body import CORRECTIONS, CURVED
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.vector_math import FAST

NODES_PER_WIDTH = 8
REACH = 6.5
"""Width σ beyond the outermost centres that a table spans."""
VALUES = CORRECTIONS + CURVED.stop - CURVED.start
"""Numbers that `pipeline.joint.body.corrections` returns."""
_FIRST, _LAST = CURVED.start, CURVED.stop

_QUINTIC = np.array(
    [
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.5, 0.0, 0.0, 0.0],
        [-10.0, -6.0, -1.5, 10.0, -4.0, 0.5],
        [15.0, 8.0, 1.5, -15.0, 7.0, -1.0],
        [-6.0, -3.0, -0.5, 6.0, -3.0, 0.5],
    ]
)
"""Coefficients of 1, x, …, x⁵ on [0, 1] from value, slope and curvature at 0 and at 1."""


def table_span(basis: FloatArray, centres: int) -> FloatArray:
    """First node [m] and nodes per metre of the tables of a basis, shape (2,); see `tabulate`."""
    return np.array([basis[0] - REACH * basis[2], NODES_PER_WIDTH / basis[2]]) if centres else np.zeros(2)


def tabulate(basis: FloatArray, weights: FloatArray) -> FloatArray:
    """Tables of the corrections of B joints.

    Parameters
    ----------
    basis : FloatArray, shape (3,)
        First centre, distance of the centres, width σ [m].
    weights : FloatArray, shape (B, CORRECTIONS, M)
        Weights of each joint.

    Returns
    -------
    FloatArray, shape (B, cells, CORRECTIONS, 6)
        Coefficients of the quintic in each cell; no cell without centres. Cost: 2 M flops for each number.
    """
    joints, rows, count = weights.shape
    if count == 0:
        return np.zeros((joints, 0, rows, 6))
    first, per_metre = table_span(basis, count)
    cells = int(np.ceil(((count - 1) * basis[1] + 2.0 * REACH * basis[2]) * per_metre))
    nodes = first + np.arange(cells + 1) / per_metre
    r = (nodes[:, None] - (basis[0] + basis[1] * np.arange(count))) / basis[2]
    bells, pace = np.exp(-0.5 * r * r), 1.0 / NODES_PER_WIDTH
    ends = np.stack([bells, -pace * r * bells, pace**2 * (r * r - 1.0) * bells], axis=2)  # by cells, not metres
    bell = np.concatenate([ends[:-1], ends[1:]], axis=2) @ _QUINTIC.T
    tables: FloatArray = np.matmul(weights[:, None], bell[None])
    return tables


@numba.njit(cache=True, forceinline=True, error_model="numpy", fastmath=FAST)
def look_up(q: float, span: FloatArray, table: FloatArray, out: FloatArray, first: int, stride: int) -> None:
    """The corrections at q, written to `out[first + i stride]` in the order of `pipeline.joint.body.corrections`.

    Cost: 9 quintics and 4 slopes, about 30 ns.
    """
    place = (q - span[0]) * span[1]
    if not 0.0 <= place < table.shape[0]:
        for i in range(VALUES):
            out[first + i * stride] = 0.0
        return
    cell = int(place)
    x = place - cell
    for i in range(CORRECTIONS):
        c0, c1, c2 = table[cell, i, 0], table[cell, i, 1], table[cell, i, 2]
        c3, c4, c5 = table[cell, i, 3], table[cell, i, 4], table[cell, i, 5]
        out[first + i * stride] = c0 + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * c5))))
    for i in range(_FIRST, _LAST):
        c1, c2 = table[cell, i, 1], table[cell, i, 2]
        c3, c4, c5 = table[cell, i, 3], table[cell, i, 4], table[cell, i, 5]
        slope = c1 + x * (2.0 * c2 + x * (3.0 * c3 + x * (4.0 * c4 + x * 5.0 * c5)))
        out[first + (CORRECTIONS + i - _FIRST) * stride] = span[1] * slope
