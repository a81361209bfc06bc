"""Equilibria of the joint under given voltages and force (eq. 15): all of them, with their stability."""

from dataclasses import dataclass

import numpy as np

from pipeline.compiled import compiled
from pipeline.generated.analytical_joint import statics, tip
from pipeline.joint.parameters import JointParameters
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.inner_loops import factorise, solve_factorised

STEEPEST = np.pi / 4
"""Tip rotation [rad] up to which the beam equations (moderate slopes) are believed."""
REACH = 0.03
"""Largest deflection [m] of the shapes that Newton's method starts from."""


@dataclass(frozen=True)
class Equilibrium:
    """One state of rest.

    Attributes
    ----------
    qm : FloatArray, shape (4,)
        Ritz coordinates [1/m, 1/m², 1/m³, m].
    q, phi, u_y : float
        Displacement [m], tip rotation [rad], axial displacement [m] of the tip.
    energy : float
        Total potential U − ½ΣC_i v_i² − F q [J].
    stable : bool
        Whether the Hessian of that potential is positive definite.
    """

    qm: FloatArray
    q: float
    phi: float
    u_y: float
    energy: float
    stable: bool


def tip_values(qm: FloatArray, p: FloatArray) -> FloatArray:
    """Tip of the beam: q [m], φ [rad], u_y [m], λ1, λ2 at the Ritz coordinates, shape (5,)."""
    values, jacobian = np.empty(5), np.empty((5, 4))
    tip(qm, p, values, jacobian)
    return values


def length_scales(length: float) -> FloatArray:
    """Ritz coordinates [1/m, 1/m², 1/m³, m] that each move the tip by 1 m, shape (4,)."""
    return np.array([length**-2, length**-3, length**-4, 1.0])


@compiled
def newton_equilibrium(qm: FloatArray, v_squared: FloatArray, force: float, p: FloatArray, iterations: int) -> bool:
    """Newton on ∂U/∂q_m = F ∂q/∂q_m from `qm`, in place; True if it converged.

    Converges to saddles as well as to minima. A step that moves a coordinate's tip contribution by more than
    50 mm (they cancel to some mm) is shortened, so that a start converges to what is near.
    Cost: one `statics` (0.5 µs) an iteration.
    """
    gradient, hessian, pivots = np.empty(4), np.empty((4, 4)), np.empty(4, np.int64)
    scale = np.array([p[0] ** -2, p[0] ** -3, p[0] ** -4, 1.0])
    for _ in range(iterations):
        statics(qm, v_squared, p, gradient, hessian)
        for i in range(3):
            gradient[i] -= force / scale[i]
        if not factorise(hessian, pivots):
            return False
        solve_factorised(hessian, pivots, gradient)
        size = np.max(np.abs(gradient / scale))
        if not size < 1e3:
            return False
        qm -= gradient * min(1.0, 5e-2 / max(size, 1e-300))
        if size < 1e-9:
            # Quadratic convergence: this step has reached rounding error, which is near 1e-13 m.
            return True
    return False


@compiled
def _converge_all(starts: FloatArray, v_squared: FloatArray, force: float, p: FloatArray) -> FloatArray:
    """Where Newton leads from each start (n, 4); rows that do not converge are NaN."""
    found = starts.copy()
    for i in range(starts.shape[0]):
        if not newton_equilibrium(found[i], v_squared, force, p, 60):
            found[i] = np.nan
    return found


def _starts(length: float) -> FloatArray:
    """Beam shapes on a grid of tip deflection q, tip slope l w'(l) and of the bow that leaves both as they are."""
    grid = np.linspace(-1.0, 1.0, 21), np.linspace(-2.0, 2.0, 7), np.linspace(-7.0, 7.0, 7)
    q, slope, bow = (REACH * axis.ravel() for axis in np.meshgrid(*grid, indexing="ij"))
    # Cubic Hermite from the clamp to (q, slope), plus bow · s²(1 − s)².
    coefficients = np.stack([3.0 * q - slope + bow, slope - 2.0 * q - 2.0 * bow, bow, np.zeros_like(q)], axis=1)
    return np.asarray(coefficients * length_scales(length))


def equilibrium_at(p: FloatArray, qm: FloatArray, v: FloatArray, force: float = 0.0) -> Equilibrium:
    """Describe the equilibrium at Ritz coordinates that satisfy eq. 15, for the parameter vector `p` (41,)."""
    gradient, hessian = np.empty(4), np.empty((4, 4))
    energy = statics(qm, v**2, p, gradient, hessian)
    q, phi, u_y = tip_values(qm, p)[:3]
    scale = length_scales(float(p[0]))
    stable = bool(np.linalg.eigvalsh(hessian * np.outer(scale, scale))[0] > 0.0)
    return Equilibrium(qm, float(q), float(phi), float(u_y), float(energy - force * q), stable)


def equilibria(parameters: JointParameters, v: FloatArray, force: float = 0.0) -> list[Equilibrium]:
    """All equilibria, in ascending q.

    Newton runs from 1029 beam shapes, with tip deflections up to `REACH` and with S-shapes, so that branches
    which are not connected to the straight beam are found too (strongly pre-strained beams have them).

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    v : FloatArray, shape (2,)
        Voltages of the left and right membrane [V].
    force : float
        External force along q [N].

    Notes
    -----
    Solutions with |φ| above 45° are left out: eq. 2 and eq. 9 hold for moderate slopes, and beyond them the
    equations have solutions that no beam has (φ = 65°, u_y = −70 mm). Cost: 10 ms.
    """
    return find_equilibria(parameters.vector(), v, force)


def find_equilibria(p: FloatArray, v: FloatArray, force: float) -> list[Equilibrium]:
    """`equilibria` of the parameter vector `p` (41,)."""
    length = float(p[0])
    scale = length_scales(length)
    found = _converge_all(_starts(length), v**2, force, p)
    distinct: list[FloatArray] = []
    for qm in found[np.isfinite(found).all(axis=1)]:
        if all(np.max(np.abs(qm - other) / scale) > 1e-8 for other in distinct):
            distinct.append(qm)
    described = (equilibrium_at(p, qm, v, force) for qm in distinct)
    return sorted((e for e in described if abs(e.phi) < STEEPEST), key=lambda e: e.q)
