"""Reduction to one coordinate (eqs. 24 to 26): the beam's shape follows the static path q_m(q).

The paper fits one polynomial in q to each Ritz coordinate. Where the beam is nearly free to snap with its tip held
(q = 0, strong pre-strain) the path is steep and a global polynomial converges slowly: with `table1` degree 15
misses q2 l² by 13 of 74 mm. Here the polynomials are piecewise cubics on 0.125 mm with continuous second derivatives.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from pipeline.generated.analytical_joint import dissipation, dynamics
from pipeline.generated.terms import CUBICS
from pipeline.joint.parameters import JointParameters
from pipeline.joint.static_path import StaticPath, static_path
from pipeline.numerics.arrays import FloatArray

CURVES = ("m_q", "d", "f", "lambda3_1", "lambda3_2", "C_1", "C_2")
"""Order of the curves: m_q [kg], d [N·s/m], f [N], λ_{3,i} [1], C_i [F]."""

REACH, PLACES = 0.03, 91
"""Largest q [m] of the curves; places along the beam at which its shape is told."""


@dataclass(frozen=True)
class ReducedJoint:
    """Characteristic curves of eq. 26 over q.

    Attributes
    ----------
    parameters : JointParameters
        The joint that was reduced.
    q : FloatArray, shape (N,)
        Uniform breakpoints [m].
    curves : FloatArray, shape (N, 7)
        Values of `CURVES` at the breakpoints.
    coefficients : FloatArray, shape (N − 1, 4, 7)
        Ascending powers of q − q_i on [q_i, q_{i+1}], of every curve.
    creep_gain : FloatArray, shape (2,)
        V_DE Y_MW of left and right membrane [J]: k̄_i = V_DE Y_MW k_i, with k_i = dλ_{3,i}/dq.
    creep_rate : FloatArray, shape (2,)
        Y_MW/η_MW [1/s].
    path : StaticPath
        The shapes q_m(q) that were substituted (eq. 24).
    """

    parameters: JointParameters
    q: FloatArray
    curves: FloatArray
    coefficients: FloatArray
    creep_gain: FloatArray
    creep_rate: FloatArray
    path: StaticPath

    def evaluate(self, q: FloatArray) -> FloatArray:
        """All curves at `q` (M,), and their derivatives: shape (2, M, 7)."""
        cell = np.clip(((q - self.q[0]) / (self.q[1] - self.q[0])).astype(int), 0, self.q.size - 2)
        found = CUBICS.evaluate(pieces=self.coefficients[cell].reshape(-1, 28), s=(q - self.q[cell])[:, None])
        return np.stack([found["curves"], found["slopes"]])


def reduce_path(parameters: JointParameters, path: StaticPath) -> ReducedJoint:
    """Project the full-order equations on the shapes of a static path (uniform q)."""
    from scipy.interpolate import CubicSpline

    p, count = parameters.vector(), path.q.size
    curves = np.empty((count, len(CURVES)))
    mass, tau, z_dot = np.empty((4, 4)), np.empty(4), np.empty(3)
    damping, coupling, thickness = np.empty((4, 4)), np.empty((4, 3)), np.empty((2, 4))
    nothing = np.zeros(4)
    for i, (qm, tangent) in enumerate(zip(path.qm, path.tangent, strict=True)):
        dynamics(qm, nothing, nothing[:3], nothing[:2], nothing[:1], p, mass, tau, z_dot)
        dissipation(qm, p, damping, coupling, thickness)
        curves[i, :2] = tangent @ mass @ tangent, tangent @ damping @ tangent
    # Along the path ∂U/∂q_m = F ∂q/∂q_m, so f(q) = ∂U/∂q_m · dq_m/dq is the holding force itself.
    curves[:, 2] = path.force
    curves[:, 3:5] = path.stretch**-0.5
    curves[:, 5:] = path.capacitance
    spline = CubicSpline(path.q, curves)
    sides = (parameters.left, parameters.right)
    return ReducedJoint(
        parameters,
        path.q,
        curves,
        np.ascontiguousarray(spline.c[::-1].transpose(1, 0, 2)),
        np.array([s.volume * s.Y_MW for s in sides]),
        np.array([s.relaxation for s in sides]),
        path,
    )


def polynomial_shapes(path: StaticPath, degree: int) -> FloatArray:
    """One polynomial in q for each Ritz coordinate, as the paper fits them (figure 6b), shape (4, degree + 1).

    Least squares over the path; ascending powers of q over the path's largest displacement.
    """
    x = path.q / np.max(np.abs(path.q))
    return np.stack([np.polynomial.polynomial.polyfit(x, path.qm[:, i], degree) for i in range(4)])


@lru_cache(maxsize=16)
def reduce_joint(parameters: JointParameters) -> ReducedJoint:
    """The reduced joint over ±`REACH`, kept for the next caller. Cost: 5 ms."""
    grid = np.linspace(-REACH, REACH, 1 + 2 * round(REACH / 1.25e-4))
    return reduce_path(parameters, static_path(parameters, grid, np.zeros(2)))


@dataclass(frozen=True)
class BeamModes:
    """Modes of w(x, t), most energetic first; three at most, because the Ritz shape has three coordinates.

    Attributes
    ----------
    x : FloatArray, shape (K,)
        Positions along the beam [m].
    shapes : FloatArray, shape (3, K)
        Mode shapes, 1 at their largest deflection.
    amplitudes : FloatArray, shape (N, 3)
        Deflection [m] that each mode contributes where its shape is 1.
    widest : FloatArray, shape (K,)
        The beam's shape at its largest deflection, scaled to 1 there: the model response beside mode 1.
    energy_share : FloatArray, shape (3,)
        Share of Σ w² that each mode carries.
    """

    x: FloatArray
    shapes: FloatArray
    amplitudes: FloatArray
    widest: FloatArray
    energy_share: FloatArray


def beam_shapes(qm: FloatArray, length: float) -> tuple[FloatArray, FloatArray]:
    """Positions x (`PLACES`,) [m] and deflections w(x) (N, `PLACES`) [m] of Ritz coordinates (N, 4) (eq. 13)."""
    x = np.linspace(0.0, length, PLACES)
    return x, qm[:, :3] @ np.stack([x**2, x**3, x**4])


def beam_modes(qm: FloatArray, length: float) -> BeamModes:
    """Decompose the shapes of a motion.

    Parameters
    ----------
    qm : FloatArray, shape (N, 4)
        Ritz coordinates over time.
    length : float
        Length of the beam [m].

    Notes
    -----
    The mean shape is not removed: the modes are those of w itself, as in figure 6a. Cost: an SVD of N × `PLACES`.
    """
    x, w = beam_shapes(qm, length)
    left, values, right = np.linalg.svd(w, full_matrices=False)
    peaks = np.take_along_axis(right[:3], np.argmax(np.abs(right[:3]), axis=1)[:, None], axis=1)
    shapes = right[:3] / peaks
    amplitudes = left[:, :3] * values[:3] * peaks[:, 0]
    energy = values**2
    row, column = np.unravel_index(np.argmax(np.abs(w)), w.shape)
    return BeamModes(x, shapes, amplitudes, w[row] / w[row, column], energy[:3] / energy.sum())
