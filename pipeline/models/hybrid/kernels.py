"""Compiled kernels of the condensed joint, and the tables of its RBF corrections.

The kernels are the graphs of `pipeline.generated.condensed_joint`. State, constants and corrections are those of
`pipeline.equations.condensed_joint`. Kernels take *prepared* constants: `prepare` computes once what depends on the
constants alone.

A table replaces the sum over Gaussians at a cost that does not depend on their number. Between nodes an eighth of σ
apart every curve is the quintic with its values, slopes and curvatures at both ends, which misses a Gaussian by 1e-9 of
its height. Curves are twice continuously differentiable, and their slopes are those of the quintics, so forces stay
gradients. 6.5 σ beyond the outermost centres every Gaussian is below 1e-9 and is taken as zero.
"""

import numpy as np

from ...codegen.numba_writer import formula, kernel
from ...generated.condensed_joint import CONSTANTS, CORRECTIONS, INERTIA, PREPARE, RATES, REST_FORCES
from ...generated.terms import BELL_SHAPE, FIRST_BELL, NEXT_BELL
from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled
from ...numerics.inner_loops import FAST, quintics

INDEX = {name: position for position, name in enumerate(CONSTANTS)}
"""Place of each constant."""
VALUES = len(CORRECTIONS)
"""Corrections: the curves, then the slopes of some."""
WIDTHS = 30.0
"""Widths of a Gaussian beyond the first centre at which corrections end: there bells are zero to rounding."""
PREPARED = PREPARE.outputs["p"]
"""Length of the prepared constants."""

_prepare = kernel(PREPARE)
_rates = kernel(RATES)
_rest_forces = kernel(REST_FORCES)
_inertia = kernel(INERTIA)
_first_bell = formula(FIRST_BELL)
_next_bell = formula(NEXT_BELL)


@compiled
def prepare(k: FloatArray) -> FloatArray:
    """Prepared constants (B, PREPARED) of joints with constants k (B, len(CONSTANTS)). Cost: 0.3 µs each."""
    prepared = np.empty((len(k), PREPARED))
    for i in range(len(k)):
        _prepare((k[i], prepared[i]))
    return prepared


@compiled(inline="always")
def joint_rates(
    x: FloatArray, u: FloatArray, c: FloatArray, z: FloatArray, start: FloatArray, p: FloatArray, dx: FloatArray
) -> None:
    """Rates dx (STATES,) of the state.

    Parameters
    ----------
    x : FloatArray, shape (STATES,)
        State.
    u : FloatArray, shape (2,)
        Squares of the voltages [V²].
    c : FloatArray, shape (VALUES,)
        Corrections at q (`corrections_at`).
    z, start : FloatArray, shapes (STOPS,) and (3,)
        Stop operators, as a share of their capacity in [−1, 1], where (q, τ, β) was `start`; what they are at x follows
        from the play since, so that they need no differential equation.
    p : FloatArray, shape (PREPARED,)
        Prepared constants.
    dx : FloatArray, shape (STATES,)
        Filled. Cost: 900 operations.
    """
    _rates((x, u, c, z, start, p, dx))


@compiled(inline="always")
def rest_forces(
    x: FloatArray, u: FloatArray, c: FloatArray, p: FloatArray, forces: FloatArray, by_shape: FloatArray
) -> None:
    """Forces on (q, τ, β) at rest [N, N·m, J], (3,), and their derivatives by τ and β, (3, 2) row by row; both filled.

    Strains have relaxed, creep has caught up, and there is no friction: of x only q, τ, β and the softening are read.
    """
    _rest_forces((x, u, c, p, forces, by_shape))


@compiled(inline="always")
def mass_matrix(x: FloatArray, p: FloatArray, mass: FloatArray) -> None:
    """M_qq [kg], M_qτ [kg·m], M_ττ [kg·m²], M_qβ [kg·m], M_τβ, M_ββ [kg·m²] at x, filled into `mass` (6,)."""
    _inertia((x, p, mass))


@compiled
def corrections_at(q: float, basis: FloatArray, weights: FloatArray, out: FloatArray) -> None:
    """The corrections at q (eq. 38), filled into `out` (VALUES,): nine curves, then the slopes of four.

    `basis` holds the first centre, the distance of the centres and the width σ [m]; `weights` is (9, M). The
    bells follow from three exponentials (`pipeline.equations.basis_functions`). Cost: 26 operations for each centre;
    `pipeline.models.hybrid.kernels` has them at a cost that does not depend on M.
    """
    out[:] = 0.0
    if weights.shape[1] == 0 or not abs(q - basis[0]) < WIDTHS * basis[2]:
        return
    first = basis[0]
    distance = basis[1]
    width = basis[2]
    r, value, ratio, shrink = _first_bell((q, first, distance, width))
    for i in range(weights.shape[1]):
        slope, r_next, next_value, ratio, shrink = _next_bell((r, value, ratio, shrink, first, distance, width))
        for row in range(9):
            out[row] += weights[row, i] * value
        for row in range(4):
            out[9 + row] += weights[4 + row, i] * slope
        r = r_next
        value = next_value


NODES_PER_WIDTH = 8
TABLE_WIDTHS = 6.5
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
    return np.array([basis[0] - TABLE_WIDTHS * basis[2] - 1.0 / per_metre, per_metre]) if centres else np.zeros(2)


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
    cells = int(np.ceil(((count - 1) * basis[1] + 2.0 * TABLE_WIDTHS * basis[2]) * per_metre))
    nodes = first + np.arange(1, cells + 2) / per_metre
    places = nodes[:, None, None] - (basis[0] + basis[1] * np.arange(count))[:, None]
    cell_basis = np.array([0.0, basis[1], basis[2]]) * per_metre  # lengths in cells, not metres
    ends = BELL_SHAPE.evaluate(q=places * per_metre, basis=cell_basis)["shape"]
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
