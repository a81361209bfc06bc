"""Compiled kernels of the condensed joint, and tables of its RBF corrections for controllers.

The kernels are the graphs of `pipeline.generated.condensed_joint`. State, constants and corrections are those of
`pipeline.equations.condensed_joint`. Kernels take *prepared* constants: `prepare` computes once what depends on the
constants alone. A column is a derivative of the state; `pipeline.models.hybrid.variational` moves them.

A table serves a controller, whose cost may not depend on the number of Gaussians. Between nodes every curve is the
quintic with its values, slopes and curvatures at both ends.
"""

from functools import partial, reduce

import numpy as np
from scipy.interpolate import BPoly, PPoly

from ...codegen.graph import Builder, Graph, Operation, reachable, text_of
from ...codegen.numba_writer import formula, kernel
from ...generated.condensed_joint import (
    CONSTANTS,
    CORRECTIONS,
    INERTIA,
    PREPARE,
    RATES,
    REST_FORCES,
    STATES,
    STOP_DIRECTIONS,
    STOPS,
)
from ...generated.condensed_joint_jacobian import JACOBIAN
from ...generated.terms import BELL_SHAPE, FIRST_BELL, NEXT_BELL
from ...numerics.arrays import FloatArray
from ...numerics.compiled import compiled
from ...numerics.fixed_step import AHEAD, ALL_SHARES, SHARES

INDEX = {name: position for position, name in enumerate(CONSTANTS)}
"""Place of each constant."""
VALUES = len(CORRECTIONS)
"""Corrections: the curves, then the slopes of some."""
CURVES = CORRECTIONS.index("moment_q")
"""The curves: rows of the corrections' weights."""
CURVED = slice(CORRECTIONS.index("moment"), CORRECTIONS.index("loss"))
"""The rows whose slope along q acts too: moment, stiffness and both electrostatic moments."""
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
TABLE_WIDTHS = 6.5
"""Width σ beyond the outermost centres that a table spans: there a Gaussian is below 1e-9 of its height."""
COLUMNS = 16
"""Columns side by side."""
STEP_STAGES = len(SHARES)
"""Stages of a step."""
STAGES = 2 * STEP_STAGES
"""Stages side by side: those of two steps."""
STEP_SLOTS = STEP_STAGES + 1
"""The stages of a step, and its end."""
SLOTS = 2 * STEP_SLOTS
ENTRIES = STATES + STOPS
"""Entries of a column."""
PLAY_WEIGHTS = 3 + 2 * STOPS * STEP_SLOTS


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
        Stop operators, as a share of their capacity in [−1, 1], where (q, τ, β) was `start`. Their values at x follow
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

    Parameters
    ----------
    x : FloatArray, shape (STATES,)
        State.
    u : FloatArray, shape (2,)
        Squared voltages [V²].
    c : FloatArray, shape (VALUES,)
        Corrections at q.
    p : FloatArray, shape (PREPARED,)
        Prepared constants.
    forces, by_shape : FloatArray, shapes (3,) and (6,)
        Filled.
    """
    _rest_forces((x, u, c, p, forces, by_shape))


@compiled(inline="always")
def mass_matrix(x: FloatArray, p: FloatArray, mass: FloatArray) -> None:
    """M_qq [kg], M_qτ [kg·m], M_ττ [kg·m²], M_qβ [kg·m], M_τβ, M_ββ [kg·m²] at x, filled into `mass` (6,)."""
    _inertia((x, p, mass))


@compiled
def corrections_at(q: float, basis: FloatArray, weights: FloatArray, out: FloatArray) -> None:
    """The corrections at q (eq. 38), filled into `out` (VALUES,): nine curves, then the slopes of four.

    The bells follow from three exponentials (`pipeline.equations.elements`). Cost: 26 operations for each
    centre.

    Parameters
    ----------
    q : float
        Displacement [m].
    basis : FloatArray, shape (3,)
        First centre, distance of the centres, width σ [m].
    weights : FloatArray, shape (CURVES, M)
        Weights [SI]; none where M is 0.
    out : FloatArray, shape (VALUES,)
        Filled.
    """
    out[:] = 0.0
    if weights.shape[1] == 0 or not abs(q - basis[0]) < WIDTHS * basis[2]:
        return
    r, value, ratio, shrink = _first_bell((q, basis[0], basis[1], basis[2]))
    for i in range(weights.shape[1]):
        slope, r_next, next_value, ratio, shrink = _next_bell((r, value, ratio, shrink, basis[0], basis[1], basis[2]))
        for row in range(CURVES):
            out[row] += weights[row, i] * value
        for row in range(VALUES - CURVES):
            out[CURVES + row] += weights[CURVED.start + row, i] * slope
        r = r_next
        value = next_value


def tabulate(basis: FloatArray, weights: FloatArray, density: int) -> tuple[float, float, FloatArray]:
    """The corrections of one joint as tables.

    Parameters
    ----------
    basis : FloatArray, shape (3,)
        First centre, distance of the centres, width σ [m].
    weights : FloatArray, shape (CURVES, M)
        Weights of the joint.
    density : int
        Nodes in a width σ; two miss a Gaussian by 5e-6 of its height.

    Returns
    -------
    first, per_metre : float
        First node [m], and nodes per metre.
    coefficients : FloatArray, shape (cells, 6, CURVES)
        Ascending powers of the place within each cell, in cells. The first and the last cell hold zeros, for all that
        lies beyond; without centres there is one cell.
    """
    count = weights.shape[1]
    if count == 0:
        return 0.0, 0.0, np.zeros((1, 6, CURVES))
    per_metre = density / basis[2]
    first = basis[0] - TABLE_WIDTHS * basis[2]
    cells = int(np.ceil(((count - 1) * basis[1] + 2.0 * TABLE_WIDTHS * basis[2]) * per_metre))
    nodes = np.arange(cells + 1)
    places = first + nodes[:, None, None] / per_metre - (basis[0] + basis[1] * np.arange(count))[:, None]
    # Lengths in cells, not metres
    shapes = BELL_SHAPE.evaluate(q=places * per_metre, basis=np.array([0.0, basis[1], basis[2]]) * per_metre)["shape"]
    quintics = BPoly.from_derivatives(nodes, np.swapaxes(shapes, 1, 2) @ weights.T)
    coefficients = np.zeros((cells + 2, 6, CURVES))
    coefficients[1:-1] = np.swapaxes(PPoly.from_bernstein_basis(quintics).c[::-1], 0, 1)
    return first - 1.0 / per_metre, per_metre, coefficients


def _column_step() -> Graph:
    """A Runge-Kutta step of one column: its state `x` and stop operators `z` move to `x_found` and `z_found`.

    `a` are ∂f/∂(x, z) of all entries in `STAGES` stages; the first four count. `b` acts on the column itself, row by
    row in `SLOTS` slots; the first four and the end count. `w` are the friction's arm, the step [s], the beam's length,
    and for each of these five which stop operators follow the play, and by how much.
    """
    build = Builder()
    add = build.add
    acting = {
        operation.place[1]
        for operation in JACOBIAN.operations
        if operation.name == "store" and operation.place[0] == "a"
    }
    acting |= {0, 2, 2 * ENTRIES, 2 * ENTRIES + 2}  # an observer pulls at q and τ, by what is read of them
    x = [build.input("x", i) for i in range(STATES)]
    h = build.input("w", 1)
    y = x
    total = x
    for stage in range(len(SHARES)):
        z = _slipped(build, x, y, stage)
        slopes = list[int]()
        for i in range(STATES):
            row = [j for j in range(ENTRIES) if ENTRIES * i + j in acting]
            terms = [add("mul", build.input("a", STAGES * (ENTRIES * i + j) + stage), [*y, *z][j]) for j in row]
            slopes.append(reduce(partial(add, "add"), [build.input("b", SLOTS * i + stage), *terms]))
        share, ahead = (add("mul", h, build.constant(x)) for x in (SHARES[stage] / ALL_SHARES, AHEAD[stage]))
        total = [add("add", total[i], add("mul", share, slopes[i])) for i in range(STATES)]
        y = [add("add", x[i], add("mul", ahead, slopes[i])) for i in range(STATES)]
    outputs = {"x_found": total, "z_found": _slipped(build, x, total, 4)}
    stores = [
        Operation("store", (operation,), (name, i))
        for name, many in outputs.items()
        for i, operation in enumerate(many)
    ]
    sizes = {"a": ENTRIES * ENTRIES * STAGES, "w": PLAY_WEIGHTS, "x": STATES, "z": STOPS, "b": ENTRIES * SLOTS}
    return Graph(
        sizes, {name: len(many) for name, many in outputs.items()}, text_of(reachable(build.operations, stores))
    )


def _slipped(build: Builder, x: list[int], y: list[int], slot: int) -> list[int]:
    """The stop operators at y: those that follow have moved with the play since x."""
    add = build.add
    moved, turned, bowed = (add("sub", y[i], x[i]) for i in (0, 2, 4))
    slipped = []
    plays = dict[tuple[float, ...], int]()
    for i, direction in enumerate(STOP_DIRECTIONS):
        if direction not in plays:
            q, _, tau, beta = map(build.constant, direction)
            arm = build.input("w", 0)
            length = build.input("w", 2)
            lever = arm if direction[1] else add("mul", length, tau)
            play = add("add", add("mul", q, moved), add("mul", lever, turned))
            plays[direction] = add("add", play, add("mul", add("mul", length, beta), bowed)) if direction[3] else play
        at = 3 + 2 * STOPS * slot + i
        unmoved = add("add", build.input("z", i), build.input("b", SLOTS * (STATES + i) + slot))
        follows = add("mul", build.input("w", at + STOPS), plays[direction])
        slipped.append(add("add", add("mul", build.input("w", at), unmoved), follows))
    return slipped


move_columns = kernel(_column_step(), COLUMNS, common=("a", "w"), single=True)
