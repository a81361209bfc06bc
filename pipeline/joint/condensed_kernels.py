"""Compiled kernels of the condensed joint, from the graphs of `pipeline.generated.condensed_joint`.

State, constants and corrections are those of `pipeline.equations.condensed_joint`; kernels take *prepared* constants,
what depends on the constants alone, computed once by `prepare`.
"""

import numpy as np

from pipeline.codegen.numba_writer import formula, kernel
from pipeline.compiled import compiled
from pipeline.generated.condensed_joint import CONSTANTS, CORRECTIONS, INERTIA, PREPARE, RATES, REST_FORCES
from pipeline.generated.terms import FIRST_BELL, NEXT_BELL
from pipeline.numerics.arrays import FloatArray

INDEX = {name: position for position, name in enumerate(CONSTANTS)}
"""Place of each constant."""
VALUES = len(CORRECTIONS)
"""Corrections: the curves, then the slopes of some."""
REACH = 30.0
"""Widths of a Gaussian beyond the first centre at which corrections end: there bells are zero to rounding."""
PREPARED = PREPARE.outputs["p"]
"""Length of the prepared constants."""

_prepare, _rates, _rest_forces, _inertia = kernel(PREPARE), kernel(RATES), kernel(REST_FORCES), kernel(INERTIA)
_first_bell, _next_bell = formula(FIRST_BELL), formula(NEXT_BELL)


@compiled
def prepare(k: FloatArray) -> FloatArray:
    """Prepared constants (B, PREPARED) of joints with constants k (B, len(CONSTANTS)). Cost: 0.3 µs each."""
    found = np.empty((len(k), PREPARED))
    for i in range(len(k)):
        _prepare((k[i], found[i]))
    return found


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
    z, start : FloatArray, shapes (STOPS,) and (2,)
        Stop operators, as a share of their capacity in [−1, 1], where (q, τ) was `start`; what they are at x follows
        from the play since, so that they need no differential equation.
    p : FloatArray, shape (PREPARED,)
        Prepared constants.
    dx : FloatArray, shape (STATES,)
        Filled. Cost: 813 operations.
    """
    _rates((x, u, c, z, start, p, dx))


@compiled(inline="always")
def rest_forces(
    x: FloatArray, u: FloatArray, c: FloatArray, p: FloatArray, forces: FloatArray, by_shape: FloatArray
) -> None:
    """Forces on (q, τ, β) at rest [N, N·m, J], (3,), and their derivatives by τ and β, (3, 2) row by row; both filled.

    Strains have relaxed, creep has caught up, and there is no friction: of x only q, τ and β are read.
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
    bells follow from three exponentials (`pipeline.equations.gaussian`). Cost: 26 operations for each centre;
    `pipeline.joint.correction_table` has them at a cost that does not depend on M.
    """
    out[:] = 0.0
    if weights.shape[1] == 0 or not abs(q - basis[0]) < REACH * basis[2]:
        return
    first, distance, width = basis[0], basis[1], basis[2]
    r, value, ratio, shrink = _first_bell((q, first, distance, width))
    for i in range(weights.shape[1]):
        slope, r_next, next_value, ratio, shrink = _next_bell((r, value, ratio, shrink, first, distance, width))
        for row in range(9):
            out[row] += weights[row, i] * value
        for row in range(4):
            out[9 + row] += weights[4 + row, i] * slope
        r, value = r_next, next_value
