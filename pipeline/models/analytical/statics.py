"""Statics of the joint (eq. 15): all equilibria with their stability, and the static path.

The static path is the shape that the joint takes when its tip is held at q, and the force that holds it. It is one
solution of eq. 15 for every q, stable or not, with F as the unknown. It carries F(q) (figure 4), C_i(q) (figure 5),
φ(q), the reduction of § 3.4 and the initial state of a simulation of which only q and q̇ are given.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from ...device.parameters import NOMINAL, VECTOR_NAMES, JointParameters
from ...errors import InputError
from ...generated.analytical_joint import CAPACITANCE, STATICS, TIP, capacitance, statics, tip
from ...numerics.arrays import BoolArray, FloatArray
from ...numerics.compiled import compiled, factorise, inner, solve_factorised
from ...numerics.stiff import RITZ

STEEPEST = np.pi / 4
"""Tip rotation [rad] up to which the beam equations (moderate slopes) are believed."""
TYPICAL_SHAPE = np.array([0.1, 0.1, 0.1, 1e-3])
"""Typical contributions of q2, q3, q4 and u0 [m]: the three large ones cancel to some mm at the tip."""
FULL_VOLTAGE = 3000.0
"""Voltage of the supply [V]."""
REACH = 0.03
"""Largest deflection [m] of the shapes that Newton's method starts from."""
TIP_VALUES = TIP.outputs["values"]
"""q [m], φ [rad], u_y [m] and both stretches."""
_HELD = RITZ + 1
"""Unknowns of a joint whose tip is held: its shape and the force."""
_MOST_STEPS = 60
_LONGEST = 5e-2
_LOST = 1e3
_CONVERGED = 1e-9
"""Newton's method: most steps, and in metres of a coordinate's tip contribution the longest one, one from which it
does not come back, and one after which rounding alone is left."""


@dataclass(frozen=True)
class JointEquilibrium:
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
        True if the Hessian of that potential is positive definite.
    """

    qm: FloatArray
    q: float
    phi: float
    u_y: float
    energy: float
    stable: bool


def tip_values(qm: FloatArray, p: FloatArray) -> FloatArray:
    """Tip of the beam: q [m], φ [rad], u_y [m], λ1, λ2 at the Ritz coordinates, shape (5,)."""
    values = np.empty(TIP_VALUES)
    tip(qm, p, values, np.empty((TIP_VALUES, RITZ)))
    return values


def length_scales(length: float) -> FloatArray:
    """Ritz coordinates [1/m, 1/m², 1/m³, m] that each move the tip by 1 m, shape (4,)."""
    return np.array([length**-2, length**-3, length**-4, 1.0])


@inner
def _shortened(size: float) -> float:
    """Share of a Newton step of this size [m] that is taken."""
    return min(1.0, _LONGEST / size) if size > 0.0 else 1.0


@inner
def newton_equilibrium(qm: FloatArray, v_squared: FloatArray, force: float, p: FloatArray) -> bool:
    """Newton on ∂U/∂q_m = F ∂q/∂q_m from `qm`, in place; True if it converged.

    Converges to saddles as well as to minima. A step that moves a coordinate's tip contribution by more than
    50 mm (they cancel to some mm) is shortened, so that a start converges to what is near.
    Cost: one `statics` (0.5 µs) an iteration.

    Parameters
    ----------
    qm : FloatArray, shape (4,)
        Start; the solution (output).
    v_squared : FloatArray, shape (2,)
        Squared voltages [V²].
    force : float
        External force along q [N].
    p : FloatArray, shape (41,)
        Parameter vector.
    """
    gradient = np.empty(RITZ)
    hessian = np.empty((RITZ, RITZ))
    pivots = np.empty(RITZ, np.int64)
    scale = np.array([p[0] ** -2, p[0] ** -3, p[0] ** -4, 1.0])
    for _ in range(_MOST_STEPS):
        statics(qm, v_squared, p, gradient, hessian)
        for i in range(3):
            gradient[i] -= force / scale[i]
        if not factorise(hessian, pivots):
            return False
        solve_factorised(hessian, pivots, gradient)
        size = np.max(np.abs(gradient / scale))
        if not size < _LOST:
            return False
        qm -= gradient * _shortened(size)
        if size < _CONVERGED:
            # Quadratic convergence: this step has reached rounding error, which is near 1e-13 m.
            return True
    return False


@compiled
def _converge_all(starts: FloatArray, v_squared: FloatArray, force: float, p: FloatArray) -> FloatArray:
    """The solution of Newton's method from each start (n, 4); rows that do not converge are NaN."""
    shapes = starts.copy()
    for i in range(starts.shape[0]):
        if not newton_equilibrium(shapes[i], v_squared, force, p):
            shapes[i] = np.nan
    return shapes


def _starts(scale: FloatArray) -> FloatArray:
    """Beam shapes on a grid of tip deflection q, tip slope l w'(l) and of the bow that leaves both as they are."""
    grid = np.linspace(-1.0, 1.0, 21), np.linspace(-2.0, 2.0, 7), np.linspace(-7.0, 7.0, 7)
    q, slope, bow = (REACH * axis.ravel() for axis in np.meshgrid(*grid, indexing="ij"))
    # Cubic Hermite from the clamp to (q, slope), plus bow · s²(1 − s)².
    shapes = [3.0 * q - slope + bow, slope - 2.0 * q - 2.0 * bow, bow, np.zeros_like(q)]
    return np.asarray(np.stack(shapes, axis=1) * scale)


def equilibria(parameters: JointParameters, v: FloatArray, force: float = 0.0) -> list[JointEquilibrium]:
    """All equilibria, in ascending q.

    Newton runs from 1029 beam shapes, with tip deflections up to `REACH` and with S-shapes. So branches that are not
    connected to the straight beam are found too; strongly pre-strained beams have them.

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


def find_equilibria(p: FloatArray, v: FloatArray, force: float) -> list[JointEquilibrium]:
    """`equilibria` of the parameter vector `p` (41,)."""
    scale = length_scales(float(p[0]))
    shapes = _converge_all(_starts(scale), v**2, force, p)
    hessian = np.empty((RITZ, RITZ))
    distinct: list[JointEquilibrium] = []
    for qm in shapes[np.isfinite(shapes).all(axis=1)]:
        if all(np.max(np.abs(qm - other.qm) / scale) > 1e-8 for other in distinct):
            energy = statics(qm, v**2, p, np.empty(RITZ), hessian)
            q, phi, u_y = tip_values(qm, p)[:3].tolist()
            stable = bool(np.linalg.eigvalsh(hessian * np.outer(scale, scale))[0] > 0.0)
            distinct.append(JointEquilibrium(qm, q, phi, u_y, float(energy - force * q), stable))
    return sorted((e for e in distinct if abs(e.phi) < STEEPEST), key=lambda e: e.q)


@dataclass(frozen=True)
class StaticPath:
    """The joint held at each q under constant voltages.

    Attributes
    ----------
    q : FloatArray, shape (N,)
        Tip displacement [m].
    qm, tangent : FloatArray, shape (N, 4)
        Ritz coordinates and dq_m/dq.
    force : FloatArray, shape (N,)
        External force that holds the tip [N]: F(q) of figure 4.
    stiffness : FloatArray, shape (N,)
        dF/dq [N/m]; negative where the free joint is unstable.
    energy : FloatArray, shape (N,)
        U − ½ΣC_i v_i² [J].
    phi : FloatArray, shape (N,)
        Tip rotation [rad].
    stretch, capacitance, capacitance_slope : FloatArray, shape (N, 2)
        λ_{1,i}, C_i [F] and dC_i/dq [F/m] along the path, left and right.
    stable : BoolArray, shape (N,)
        True if the free joint, loaded by `force`, would stay.
    held : BoolArray, shape (N,)
        True if the beam keeps its shape while the tip is held.
    """

    q: FloatArray
    qm: FloatArray
    tangent: FloatArray
    force: FloatArray
    stiffness: FloatArray
    energy: FloatArray
    phi: FloatArray
    stretch: FloatArray
    capacitance: FloatArray
    capacitance_slope: FloatArray
    stable: BoolArray
    held: BoolArray


@compiled
def hold_tip(
    q: float, qm: FloatArray, v_squared: FloatArray, p: FloatArray, tangent: FloatArray
) -> tuple[float, float, float]:
    """Solve ``∂U/∂q_m = F ∂q/∂q_m, w(l) = q`` by Newton from `qm`, in place.

    Parameters
    ----------
    q : float
        Displacement of the tip [m].
    qm : FloatArray, shape (4,)
        Start; the shape (output).
    v_squared : FloatArray, shape (2,)
        Squared voltages [V²].
    p : FloatArray, shape (41,)
        Parameter vector.
    tangent : FloatArray, shape (4,)
        dq_m/dq (output).

    Returns
    -------
    force, stiffness, energy : float
        F [N], dF/dq [N/m] and U − ½ΣC_i v_i² [J]; `tangent` (4,) becomes dq_m/dq. All NaN if Newton fails.

    Notes
    -----
    Cost: an iteration evaluates `statics` and factorises 5×5, 0.7 µs; four to six iterations from a neighbour.
    """
    scale = np.array([p[0] ** -2, p[0] ** -3, p[0] ** -4, 1.0])
    gradient = np.empty(RITZ)
    hessian = np.empty((RITZ, RITZ))
    system = np.empty((_HELD, _HELD))
    right = np.empty(_HELD)
    pivots = np.empty(_HELD, np.int64)
    energy = np.nan
    last = False
    for _ in range(_MOST_STEPS):
        energy = statics(qm, v_squared, p, gradient, hessian)
        # Bordered system in coordinates of tip displacement: the unknowns are the step and the force.
        for i in range(RITZ):
            for j in range(RITZ):
                system[i, j] = hessian[i, j] * scale[i] * scale[j]
            system[RITZ, i] = 1.0 if i < 3 else 0.0
            system[i, RITZ] = -system[RITZ, i]
            right[i] = -gradient[i] * scale[i]
        system[RITZ, RITZ] = 0.0
        right[RITZ] = q - (qm[0] / scale[0] + qm[1] / scale[1] + qm[2] / scale[2])
        if not factorise(system, pivots):
            break
        if last:
            solve_factorised(system, pivots, right)
            force = right[RITZ]
            for i in range(_HELD):
                right[i] = 1.0 if i == RITZ else 0.0
            solve_factorised(system, pivots, right)
            for i in range(RITZ):
                tangent[i] = right[i] * scale[i]
            return force, right[RITZ], energy
        solve_factorised(system, pivots, right)
        size = 0.0
        for i in range(RITZ):
            size = max(size, abs(right[i])) if right[i] == right[i] else np.inf
        if not size < _LOST:
            break
        for i in range(RITZ):
            qm[i] += right[i] * scale[i] * _shortened(size)
        last = size < _CONVERGED
    return np.nan, np.nan, np.nan


def static_path(parameters: JointParameters, q: FloatArray, v: FloatArray) -> StaticPath:
    """Trace the static path outwards from the middle of the grid.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    q : FloatArray, shape (N,)
        Ascending tip displacements [m], steps of at most about 0.5 mm.
    v : FloatArray, shape (2,)
        Voltages [V].

    Raises
    ------
    InputError
        The shape has no continuous static path over the grid (it snaps although the tip is held).
    """
    p = parameters.vector()
    qm = np.empty((q.size, RITZ))
    scalars = np.empty((q.size, 3))
    middle = int(np.argmin(np.abs(q)))
    lead = np.linspace(0.0, q[middle], 2 + int(abs(q[middle]) / 2.5e-4))
    start = _trace(lead, np.zeros(RITZ), v**2, p)[0][-1]
    for part in (slice(middle, None), slice(middle, None, -1)):
        qm[part], scalars[part] = _trace(q[part], start, v**2, p)
    path = describe_path(parameters, qm, v)
    missing = ~np.isfinite(scalars).all(axis=1) | ~path.held
    if missing.any():
        nearest = q[missing][np.argmin(np.abs(q[missing]))]
        raise InputError(
            f"the beam snaps although its tip is held, at q = {1e3 * nearest:.1f} mm: "
            "there is no map from q to its shape; check the parameters (b, E, Y, e_z)"
        )
    return path


def _trace(q: FloatArray, start: FloatArray, v_squared: FloatArray, p: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Hold the tip at every q in turn, each from its neighbour's solution and tangent: shapes, and `hold_tip`'s."""
    shapes = np.empty((q.size, RITZ))
    scalars = np.empty((q.size, 3))
    guess = start.copy()
    slope = np.zeros(RITZ)
    for i, step in enumerate(np.diff(q, prepend=q[0])):
        guess += slope * step
        scalars[i] = hold_tip(q[i], guess, v_squared, p, slope)
        shapes[i] = guess
    return shapes, scalars


def describe_path(parameters: JointParameters, qm: FloatArray, v: FloatArray) -> StaticPath:
    """The static path of the shapes `qm` (N, 4) under voltages `v` (2,), in their order.

    Each shape satisfies eq. 15 for some force, which is found here too. Forces and tangent belong to the equilibrium
    that `hold_tip` finds from the shape at its tip displacement, all else to the shape as it is given.
    """
    p = parameters.vector()
    count = len(qm)
    tips = np.empty((count, TIP_VALUES))
    tangent = np.empty((count, RITZ))
    scalars = np.empty((count, 3))
    farads = np.empty((count, 2))
    slopes = np.empty((count, 2))
    hessians = np.empty((count, RITZ, RITZ))
    farad_jacobian = np.empty((2, RITZ))
    for i, shape in enumerate(qm):
        tip(shape, p, tips[i], np.empty((TIP_VALUES, RITZ)))
        scalars[i] = hold_tip(tips[i, 0], shape.copy(), v**2, p, tangent[i])
        capacitance(shape, p, farads[i], farad_jacobian)
        slopes[i] = (farad_jacobian * tangent[i]).sum(axis=1)
        statics(shape, v**2, p, np.empty(RITZ), hessians[i])
    scale = length_scales(parameters.l)
    finite = np.isfinite(qm).all(axis=1)
    negative = np.full(count, RITZ)
    negative[finite] = (np.linalg.eigvalsh(hessians[finite] * np.outer(scale, scale)) < 0.0).sum(axis=1)
    return StaticPath(
        q=tips[:, 0],
        qm=qm,
        tangent=tangent,
        force=scalars[:, 0],
        stiffness=scalars[:, 1],
        energy=scalars[:, 2],
        phi=tips[:, 1],
        stretch=tips[:, 3:],
        capacitance=farads,
        capacitance_slope=slopes,
        stable=negative == 0,
        # Inertia is additive over the held shape and the tip's own stiffness (Haynsworth 1968).
        held=negative == (scalars[:, 1] < 0.0),
    )


def unactuated_path(parameters: JointParameters, reach: float = 0.03, count: int = 241) -> StaticPath:
    """The static path without voltage over ±reach [m], kept for the next caller and for all joints of equal statics."""
    return _kept_path(_without_dynamics(parameters), reach, count)


_READ = {
    operation.place[1]
    for graph in (STATICS, TIP, CAPACITANCE)
    for operation in graph.operations
    if operation.place[0] == "p"
}
"""Places of the parameters that the static kernels read."""


@lru_cache(maxsize=64)
def _without_dynamics(parameters: JointParameters) -> JointParameters:
    """The joint of equal statics, with nominal viscosities, inertia and friction, which no static kernel reads."""
    return parameters.with_values({n: NOMINAL.value(n) for i, n in enumerate(VECTOR_NAMES) if i not in _READ})


@lru_cache(maxsize=64)
def _kept_path(parameters: JointParameters, reach: float, count: int) -> StaticPath:
    return static_path(parameters, np.linspace(-reach, reach, count), np.zeros(2))


def rotation_map(parameters: JointParameters | None) -> Callable[[FloatArray], FloatArray] | None:
    """φ of q on the static path, NaN where q is NaN; None for a device without a parameter set."""
    return None if parameters is None else partial(static_rotation, parameters=parameters)


def static_rotation(q: FloatArray, parameters: JointParameters) -> FloatArray:
    """φ [rad] on the static path without voltage, for q [m] of any shape; linear beyond ±30 mm.

    Cubic Hermite interpolation of 241 nodes with the exact slopes dφ/dq; its error is below 1e-8 rad.
    """
    path = unactuated_path(parameters)
    return _interpolated(q, path.q, path.phi, _rotation_slopes(parameters))[0]


def displacement_of_rotation(phi: FloatArray, parameters: JointParameters) -> tuple[FloatArray, FloatArray]:
    """Q [m] and dq/dφ [m/rad] at φ [rad] of any shape: the inverse of `static_rotation`.

    Raises
    ------
    InputError
        The tip of this joint does not turn further with every further displacement.
    """
    path = unactuated_path(parameters)
    slopes = _rotation_slopes(parameters)
    if not np.all(slopes > 0.0):
        raise InputError("the parameter set has one rotation of the tip at several displacements; correct it")
    return _interpolated(phi, path.phi, path.q, 1.0 / slopes)


def rotation_nodes(parameters: JointParameters) -> FloatArray:
    """Q [m] and φ [rad] on the static path without voltage, of rising q up to ±30 mm, shape (241, 2)."""
    path = unactuated_path(parameters)
    return np.column_stack([path.q, path.phi])


def _rotation_slopes(parameters: JointParameters) -> FloatArray:
    """dφ/dq [rad/m] at the nodes of the unactuated path."""
    path = unactuated_path(parameters)
    jacobian = np.empty((TIP_VALUES, RITZ))
    slopes = np.empty(path.q.size)
    for i in range(path.q.size):
        tip(path.qm[i], parameters.vector(), np.empty(TIP_VALUES), jacobian)
        slopes[i] = jacobian[1] @ path.tangent[i]
    return slopes


def _interpolated(at: FloatArray, x: FloatArray, y: FloatArray, slopes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The cubic Hermite interpolant of nodes with slopes, linear beyond them, and its derivative."""
    from scipy.interpolate import CubicHermiteSpline

    inside = np.clip(at, x[0], x[-1])
    beyond = np.asarray(at) - inside
    edge = np.where(beyond > 0.0, slopes[-1], slopes[0])
    spline = CubicHermiteSpline(x, y, slopes)
    return np.asarray(spline(inside) + edge * beyond), np.asarray(spline(inside, 1))
