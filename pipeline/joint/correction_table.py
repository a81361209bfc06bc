"""The RBF corrections as tables of quintics: the same curves at a cost that does not depend on their number of centres.

Between nodes an eighth of σ apart every curve is the quintic with its values, slopes and curvatures at both ends,
which misses a Gaussian by 1e-9 of its height. Curves are twice continuously differentiable, and their slopes are those
of the quintics, so forces stay gradients. 6.5 σ beyond the outermost centres every Gaussian is below 1e-9 and is taken
as zero.
"""

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.terms import BELL_SHAPE
from pipeline.joint.condensed_kernels import VALUES
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.inner_loops import FAST, quintics

NODES_PER_WIDTH = 8
REACH = 6.5
"""Width σ beyond the outermost centres that a table spans."""
CURVES = 9
"""Rows of the corrections' weights."""
CURVED = slice(4, 8)
"""The rows whose slope along q acts too: moment, stiffness and both electrostatic moments."""
COLUMNS = 16
"""Width of a table's rows: `VALUES` and zeros up to whole vectors."""

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


def table_span(basis: FloatArray, centres: int, density: int = NODES_PER_WIDTH) -> FloatArray:
    """First node [m] and nodes per metre of the tables of a basis, shape (2,); see `tabulate`."""
    per_metre = density / basis[2] if centres else 0.0
    return np.array([basis[0] - REACH * basis[2] - 1.0 / per_metre, per_metre]) if centres else np.zeros(2)


def tabulate(basis: FloatArray, weights: FloatArray, density: int = NODES_PER_WIDTH) -> FloatArray:
    """Tables of the corrections of B joints.

    Parameters
    ----------
    basis : FloatArray, shape (3,)
        First centre, distance of the centres, width σ [m].
    weights : FloatArray, shape (B, CURVES, M)
        Weights of each joint.
    density : int
        Nodes in a width σ; two miss a Gaussian by 5e-6 of its height.

    Returns
    -------
    FloatArray, shape (B, cells, 6, 16)
        Coefficients of the polynomial of each of `VALUES` in each cell; the first and the last hold zeros, for all that
        lies beyond; no cell without centres. Cost: 2 M flops for each number.
    """
    joints, rows, count = weights.shape
    if count == 0:
        return np.zeros((joints, 0, 6, COLUMNS))
    first, per_metre = table_span(basis, count, density)
    cells = int(np.ceil(((count - 1) * basis[1] + 2.0 * REACH * basis[2]) * per_metre))
    nodes = first + np.arange(1, cells + 2) / per_metre
    places = nodes[:, None, None] - (basis[0] + basis[1] * np.arange(count))[:, None]
    one = np.array([0.0, basis[1], basis[2]]) * per_metre  # lengths in cells, not metres
    ends = BELL_SHAPE.evaluate(q=places * per_metre, basis=one)["shape"]
    bell = np.swapaxes(np.concatenate([ends[:-1], ends[1:]], axis=2) @ _QUINTIC.T, 1, 2)
    tables = np.zeros((joints, cells + 2, 6, COLUMNS))
    tables[:, 1:-1, :, :rows] = np.matmul(bell[None], np.swapaxes(weights, 1, 2)[:, None])
    powers = np.arange(1.0, 6.0)[:, None]
    tables[..., :5, rows:VALUES] = per_metre * powers * tables[..., 1:, CURVED]
    return tables


@compiled(forceinline=True, fastmath=FAST)
def look_up(q: float, span: FloatArray, table: FloatArray, out: FloatArray, first: int, stride: int) -> None:
    """The corrections at q by one joint's table, written to `out[first + i stride]`, i < `VALUES`.

    Without a branch, around which the compiler would count references. Cost: 13 quintics in vector registers, 10 ns.
    """
    place = min(max((q - span[0]) * span[1], 0.0), table.shape[0] - 1.0)
    cell = int(place)
    quintics(table, cell, place - cell, out, first, stride, VALUES)
