"""The full-order joint: its rests, its stored energy, its motion."""

from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from ..numerics.arrays import FloatArray
from .elements import elastic, rubber_energy, stretch, tip
from .midpoint import Load, State, at_rest, march
from .parameters import RITZ, RigParameters, coordinates

_SETTLING, _SETTLING_STEP = 6.0, 2e-3  # s
_TILTING_VOLTAGE = 3000.0  # V
_CALMING = 4  # times the joint's own losses, while it settles
_TILT = 0.16  # rad, of the tip in the first guess


@dataclass(frozen=True)
class Motion:
    """Motion of the joint at every sample of the voltages.

    Attributes
    ----------
    q, qdot : FloatArray, shape (N,)
        Tip displacement [m] and velocity [m/s].
    phi : FloatArray, shape (N,)
        Tip rotation [rad].
    """

    q: FloatArray
    qdot: FloatArray
    phi: FloatArray


def simulate(p: RigParameters, v: FloatArray, dt: float, *, stride: int = 15, x0: FloatArray | None = None) -> Motion:
    """Simulate from rest under the voltages `v`, shape (N, 2) [V], sampled every `dt` [s].

    Parameters
    ----------
    p : RigParameters
        The joint.
    v : FloatArray, shape (N, 2)
        Membrane voltages (left, right) [V].
    dt : float
        Interval of the samples [s].
    stride : int
        Samples per time step. Steps of 0.5 ms leave an error of a few micrometres.
    x0 : FloatArray, optional
        Coordinates at rest; by default :func:`rest` on the left.

    Raises
    ------
    InputError
        If Newton's method fails, as it does when a membrane is stretched beyond its rubber law.

    Notes
    -----
    Cost: N/stride steps of about 5 µs (see :func:`pipeline.rig.midpoint.march`); samples in between are cubic
    Hermite, O(N).
    """
    # A step feels the trapezoidal mean of the squares; the last is held.
    squares = np.pad(v**2, ((0, 1 + -len(v) % stride), (0, 0)), mode="edge")
    charge = (0.5 * (squares[:-1] + squares[1:])).reshape(-1, stride, 2).mean(axis=1)
    poses, rates, _ = moved(p, rest(p, side=-1) if x0 is None else x0, charge, stride * dt)
    q, qdot = _hermite(poses[:, 0], rates[:, 0], v.shape[0], stride, stride * dt)
    phi, _ = _hermite(poses[:, 2], rates[:, 2], v.shape[0], stride, stride * dt)
    return Motion(q, qdot, phi)


def moved(p: RigParameters, start: FloatArray, charge: FloatArray, h: float) -> tuple[FloatArray, FloatArray, State]:
    """Move a joint from rest.

    Parameters
    ----------
    p : RigParameters
        The joint.
    start : FloatArray, shape (n,)
        Coordinates at rest.
    charge : FloatArray, shape (N, 2)
        Squared voltages, mean over each step [V²].
    h : float
        Length of a step [s].

    Returns
    -------
    poses, rates : FloatArray, shape (N + 1, 3)
        (q, u_y, φ) of the tip and their rates at the start of each step, and after the last.
    state : State
        After the last step.

    Raises
    ------
    InputError
        Newton's method fails.
    """
    state, work = at_rest(p, start)
    poses = np.empty((len(charge) + 1, 3))
    rates = np.empty_like(poses)
    none = np.zeros(len(charge))
    if not march(p, state, work, Load(charge, none, none), h, 0, poses, rates) or not np.isfinite(state.x).all():
        raise InputError("the virtual joint cannot follow: a membrane is stretched beyond its rubber law")
    return poses, rates, state


def rest(p: RigParameters, *, side: int) -> FloatArray:
    """Coordinates of the relaxed equilibrium without voltage on `side` (−1 left, +1 right), shape (n,).

    Dynamic relaxation: the joint is held at the side by voltage, released, and settles without friction and creep.
    A joint with one well ends there for either side.
    """
    still = p._replace(
        branch_modulus=np.zeros_like(p.branch_modulus),
        slip_stiffness=np.zeros_like(p.slip_stiffness),
        plastic_share=np.zeros_like(p.plastic_share),
        softening=0.0,
        friction_shape=np.array([0.0, 1.0, 0.0, 0.0]),  # the laws divide by the second
        **{name: _CALMING * getattr(p, name) for name in ("bending_loss", "hinge_loss", "kelvin_voigt")},
    )
    n = coordinates(p)
    shape = np.array([0.75, -1 / 6, 0.0, 0.0]) if p.beam == RITZ else (np.arange(n) + 1.0) / n
    steps = round(_SETTLING / _SETTLING_STEP)
    charge = np.zeros((steps, 2))
    charge[: steps // 3, (1 - side) // 2] = _TILTING_VOLTAGE**2
    return moved(still, side * _TILT * shape, charge, _SETTLING_STEP)[2].x


def wells(p: RigParameters) -> tuple[float, float]:
    """Tip displacement [m] of the relaxed equilibria on the left and on the right, without voltage."""
    return tip_displacement(p, rest(p, side=-1)), tip_displacement(p, rest(p, side=1))


def saddle(p: RigParameters) -> FloatArray:
    """Coordinates of the relaxed unstable equilibrium between the wells, without voltage, shape (n,).

    Newton's method on the gradient of the potential, by central differences, starts from mixtures of the shapes in both
    wells. The first point from which the potential falls in exactly one direction is the saddle.

    Raises
    ------
    InputError
        No start leads to such a point.
    """
    from scipy.optimize import root

    step = 1e-5
    none = np.zeros(2)
    left = rest(p, side=-1)
    right = rest(p, side=1)
    scale = abs(potential(p, np.zeros(left.size), none) - potential(p, right, none))

    def gradient(x: FloatArray) -> FloatArray:
        """Slope of the potential by central differences, over the scale."""
        falls = [potential(p, x + d, none) - potential(p, x - d, none) for d in step * np.eye(x.size)]
        return np.array(falls) / (2 * step * scale)

    for share in (0.5, 0.4, 0.6, 0.3, 0.7):
        solution = root(gradient, (1.0 - share) * left + share * right, tol=1e-12)
        bends = np.array([gradient(solution.x + d) - gradient(solution.x - d) for d in 10.0 * step * np.eye(left.size)])
        if np.abs(solution.fun).max() < 1e-3 and np.sum(np.linalg.eigvalsh(0.5 * (bends + bends.T)) < 0.0) == 1:
            return np.asarray(solution.x)
    raise InputError("the virtual joint has no unstable equilibrium between its wells")


def barrier(p: RigParameters) -> float:
    """Energy [J] from the wells, on average, to the unstable equilibrium between them, without voltage."""
    none = np.zeros(2)
    return float(potential(p, saddle(p), none) - np.mean([potential(p, rest(p, side=side), none) for side in (-1, 1)]))


def tip_displacement(p: RigParameters, x: FloatArray) -> float:
    """Tip displacement q [m] at the coordinates `x`."""
    return float(_pose(p, x)[0])


def _pose(p: RigParameters, x: FloatArray) -> FloatArray:
    """(q, u_y, φ) of the tip."""
    pose = np.empty(3)
    tip(x, p, pose, np.empty((3, x.size)))
    return pose


def potential(p: RigParameters, x: FloatArray, v: FloatArray) -> float:
    """Energy [J] stored at the coordinates `x`, shape (n,), with relaxed branches, at voltages `v`, shape (2,) [V].

    Beam, weight, rubber, and ``−½ C v²`` of the membranes held at their voltages: the force is minus its gradient.
    """
    pose = _pose(p, x)
    energy = elastic(x, np.zeros(x.size), p, np.empty(x.size)) + p.mass * p.gravity * pose[1]
    for side in (0, 1):
        energy += p.volume[side] * rubber_energy(stretch(side, pose, p, np.empty(3)), side, p)
    return float(energy - 0.5 * membrane_capacitances(p, x) @ v**2)


def membrane_capacitances(p: RigParameters, x: FloatArray) -> FloatArray:
    """Capacitance [F] of each membrane at the coordinates `x`, shape (2,)."""
    stretches = np.array([stretch(side, _pose(p, x), p, np.empty(3)) for side in (0, 1)])
    return np.asarray(np.asarray(p.capacitance) * stretches**p.capacitance_exponent)


def _hermite(y: FloatArray, rate: FloatArray, n: int, stride: int, h: float) -> tuple[FloatArray, FloatArray]:
    """Cubic Hermite interpolant of `y`, `rate` and its slope at `n` samples, `stride` of them per step `h` [s]."""
    k, part = np.divmod(np.arange(n), stride)
    s = part / stride
    rise = np.diff(y)[k]
    a = h * rate[k]
    b = h * rate[k + 1]
    square = 3 * rise - 2 * a - b
    cube = a + b - 2 * rise
    return y[k] + s * (a + s * (square + s * cube)), (a + s * (2 * square + 3 * s * cube)) / h
