"""The reduced joint (eqs. 24 to 26): one coordinate, two Maxwell strains, friction; reduction and simulation.

The beam's shape follows the static path q_m(q). The paper fits one polynomial in q to each Ritz coordinate. Where the
beam is nearly free to snap with its tip held (q = 0, strong pre-strain) the path is steep and a global polynomial
converges slowly: with `table1` degree 15 misses q2 l² by 13 of 74 mm. Here the polynomials are piecewise cubics on
0.125 mm with continuous second derivatives.

The equations are those of `pipeline.equations.full_joint`; friction is Dahl's, exact (`pipeline.equations.elements`).
"""

# mypy: disable-error-code="no-untyped-def"

import time
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...codegen.numba_writer import formula, kernel
from ...device.parameters import JointParameters
from ...generated.analytical_joint import dynamics
from ...generated.terms import CUBICS, DAHL_MOVE, REDUCED_MOTION
from ...numerics.arrays import FloatArray, IntArray, sample_interval
from ...numerics.compiled import compiled
from ...numerics.fixed_step import Methods, integrator, run_status, workspace
from ...numerics.linear_filters import first_order_lag
from ...numerics.metrics import nrmse
from ...numerics.stiff import RITZ
from ..base import FreeRun
from .full_order import FullOrderMotion, dissipative_matrices, rest_state, simulate
from .statics import FULL_VOLTAGE, equilibria, static_path

CURVES = ("m_q", "d", "f", "lambda3_1", "lambda3_2", "C_1", "C_2")
"""Order of the curves: m_q [kg], d [N·s/m], f [N], λ_{3,i} [1], C_i [F]."""

REACH = 0.03
PLACES = 91
"""Largest q [m] of the curves; places along the beam at which its shape is given."""


@dataclass(frozen=True)
class ReducedJoint:
    """Characteristic curves of eq. 26 over q.

    Attributes
    ----------
    parameters : JointParameters
        The joint that was reduced.
    q : FloatArray, shape (N,)
        Uniform breakpoints [m].
    coefficients : FloatArray, shape (N − 1, 4, 7)
        Ascending powers of q − q_i on [q_i, q_{i+1}], of every one of `CURVES`.
    """

    parameters: JointParameters
    q: FloatArray
    coefficients: FloatArray

    def evaluate(self, q: FloatArray) -> FloatArray:
        """All curves at `q` (M,), and their derivatives: shape (2, M, 7)."""
        cell = np.clip(((q - self.q[0]) / (self.q[1] - self.q[0])).astype(int), 0, self.q.size - 2)
        cubics = CUBICS.evaluate(pieces=self.coefficients[cell].reshape(len(cell), -1), s=(q - self.q[cell])[:, None])
        return np.stack([cubics["curves"], cubics["slopes"]])


@lru_cache(maxsize=16)
def reduce_joint(parameters: JointParameters) -> ReducedJoint:
    """The full-order equations projected on the shapes of the static path over ±`REACH` (eq. 24).

    It is kept for the next caller. Cost: 5 ms.
    """
    from scipy.interpolate import CubicSpline

    path = static_path(parameters, np.linspace(-REACH, REACH, 1 + 2 * round(REACH / 1.25e-4)), np.zeros(2))
    p = parameters.vector()
    moving = np.empty((path.q.size, 2))
    mass = np.empty((RITZ, RITZ))
    nothing = np.zeros(RITZ)
    for i, (qm, tangent) in enumerate(zip(path.qm, path.tangent, strict=True)):
        dynamics(qm, nothing, nothing[:3], nothing[:2], nothing[:1], p, mass, np.empty(RITZ), np.empty(3))
        damping, _ = dissipative_matrices(qm, p)
        moving[i] = tangent @ mass @ tangent, tangent @ damping @ tangent
    # Along the path ∂U/∂q_m = F ∂q/∂q_m, so f(q) = ∂U/∂q_m · dq_m/dq is the holding force itself.
    curves = np.column_stack([moving, path.force, path.stretch**-0.5, path.capacitance])
    pieces = np.ascontiguousarray(CubicSpline(path.q, curves).c[::-1].transpose(1, 0, 2))
    return ReducedJoint(parameters, path.q, pieces)


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
    energy = values**2
    row, column = np.unravel_index(np.argmax(np.abs(w)), w.shape)
    return BeamModes(
        x=x,
        shapes=right[:3] / peaks,
        amplitudes=left[:, :3] * values[:3] * peaks[:, 0],
        widest=w[row] / w[row, column],
        energy_share=energy[:3] / energy.sum(),
    )


_motion = kernel(REDUCED_MOTION)
_dahl_move = formula(DAHL_MOVE)


TOLERANCE = 1e-5
"""Tolerance of the full-order model that the reduced one is compared with."""


class ReducedSystem(NamedTuple):
    """A reduced joint in a run; its state is q, q̇, e1, e2.

    Attributes
    ----------
    inputs : FloatArray, shape (N, 3)
        Voltages [V] and external force [N] at the samples.
    parts : int
        Half steps in an interval.
    sample : IntArray, shape (1,)
        Sample before the step; filled.
    origin, spacing : float
        First breakpoint of the curves and distance of the breakpoints [m].
    pieces : FloatArray, shape (cells, 4, 7)
        Cubics of the curves.
    gain, rate : FloatArray, shape (2,)
        Of the Maxwell elements: k̄_i = V_DE Y_MW k_i [J], with k_i = dλ_{3,i}/dq, and Y_MW/η_MW [1/s].
    friction : FloatArray, shape (2,)
        Force [N] and length [m].
    slip : FloatArray, shape (2,)
        q at the start of the step, and Dahl's state there.
    s, load, squares, rates : FloatArray, shapes (1,), (1,), (2,), (3,)
        Room for what acts.
    """

    inputs: FloatArray
    parts: int
    sample: IntArray
    origin: float
    spacing: float
    pieces: FloatArray
    gain: FloatArray
    rate: FloatArray
    friction: FloatArray
    slip: FloatArray
    s: FloatArray
    load: FloatArray
    squares: FloatArray
    rates: FloatArray


def _begin(system, x, node):
    system.sample[0], system.slip[0] = node // system.parts, x[0]


def _rates(system, x, node, dx, acceleration):
    cell = min(max(int((x[0] - system.origin) / system.spacing), 0), system.pieces.shape[0] - 1)
    system.s[0] = x[0] - (system.origin + cell * system.spacing)
    n = system.sample[0]
    share = (node - n * system.parts) / system.parts
    now = system.inputs[n]
    then = system.inputs[min(n + 1, len(system.inputs) - 1)]
    for side in range(2):
        system.squares[side] = (now[side] + share * (then[side] - now[side])) ** 2
    system.load[0] = now[2] + share * (then[2] - now[2])
    if system.friction[0] > 0.0:
        system.load[0] -= system.friction[0] * _slid(x[0], system.slip[0], system.slip[1], system.friction[1])
    acting = (system.squares, system.load, system.gain, system.rate)
    _motion((system.pieces[cell], system.s, x[1:2], x[2:], *acting, system.rates))
    dx[0], dx[1], dx[2], dx[3] = x[1], system.rates[0], system.rates[1], system.rates[2]
    acceleration[0] = dx[1]


def _finish(system, x):
    if system.friction[0] > 0.0:
        system.slip[1] = _slid(x[0], system.slip[0], system.slip[1], system.friction[1])


_integrate = integrator(ReducedSystem, lambda kind: Methods(_begin, _rates, _finish))


@compiled(forceinline=True)
def _slid(q: float, before: float, zeta: float, length: float) -> float:
    """Dahl's state after a monotonous displacement from q `before`: exact, so that no step is too long for it."""
    return float(_dahl_move((zeta, q - before, length))[0])


LONGEST_STEP = 1e-3
"""Longest step [s]: it resolves the joint's 2.8 Hz, and 9 Hz ring-downs, to 1e-7."""


def simulate_reduced(
    reduced: ReducedJoint,
    t: FloatArray,
    v: FloatArray,
    q0: float,
    qdot0: float,
    *,
    force: FloatArray | None = None,
) -> FreeRun:
    """Free run of the reduced joint, voltages and force linear between samples.

    It diverges where q leaves the range of the curves.

    Parameters
    ----------
    reduced : ReducedJoint
        Curves from `pipeline.models.analytical.reduced_order`.
    t, v : FloatArray, shapes (N,) and (N, 2)
        Sample times [s], uniform, and voltages [V].
    q0, qdot0 : float
        Initial displacement [m] and velocity [m/s]; the Maxwell elements have relaxed.
    force : FloatArray, shape (N,), optional
        External force [N].
    """
    parameters = reduced.parameters
    sides = (parameters.left, parameters.right)
    interval = sample_interval(t) if t.size > 1 else LONGEST_STEP
    steps = max(1, int(np.ceil(interval / LONGEST_STEP - 1e-9)))
    out = np.full((t.size, 3, 1), np.nan)
    system = ReducedSystem(
        inputs=np.column_stack([v, np.zeros(t.size) if force is None else force]),
        parts=2 * steps,
        sample=np.zeros(1, dtype=np.int64),
        origin=reduced.q[0],
        spacing=reduced.q[1] - reduced.q[0],
        pieces=reduced.coefficients,
        gain=np.array([side.volume * side.Y_MW for side in sides]),
        rate=np.array([side.relaxation for side in sides]),
        friction=np.array([parameters.F_c, parameters.s_c]),
        slip=np.array([q0, 0.0]),
        s=np.zeros(1),
        load=np.zeros(1),
        squares=np.zeros(2),
        rates=np.zeros(3),
    )
    x = np.array([q0, qdot0, 0.0, 0.0])
    valid = _integrate(system, x, out, workspace(x), steps, interval / steps, reduced.q[0], reduced.q[-1])
    return FreeRun(t, out[:, 0, 0], out[:, 1, 0], out[:, 2, 0], *run_status(t, valid))


def maxwell_strains(thickness: FloatArray, dt: float, rate: FloatArray) -> FloatArray:
    """e_i along a measured motion: ``ė = λ̇3 − rate·e``, which is λ3 without what a first-order lag follows.

    λ3 is linear between samples, and at rest before the first.

    Parameters
    ----------
    thickness : FloatArray, shape (N, 2)
        λ_{3,i}.
    dt : float
        Sample interval [s].
    rate : FloatArray, shape (2,)
        Y_MW/η_MW [1/s].
    """
    lagged = [
        first_order_lag(np.ascontiguousarray(column), dt, 1.0 / max(float(r), np.finfo(np.float64).tiny))[0]
        for column, r in zip(thickness.T, rate, strict=True)
    ]
    return thickness - np.column_stack(lagged)


@compiled
def friction_state(q: FloatArray, s_c: float) -> FloatArray:
    """ζ (N,) of Dahl's friction along a measured motion, monotone between samples, relaxed at the first."""
    zeta = np.zeros(q.size)
    for n in range(1, q.size):
        zeta[n] = _slid(q[n], q[n - 1], zeta[n - 1], s_c)
    return zeta


def pulse_sequence(
    voltage: float = FULL_VOLTAGE, *, pulse: float = 0.5, pause: float = 1.0, count: int = 4, dt: float = 1e-3
) -> tuple[FloatArray, FloatArray]:
    """Times [s] and voltages (N, 2) [V]: left, right, left … pulses of `pulse` [s] with pauses, as in figure 7.

    Parameters
    ----------
    voltage : float
        Of a pulse [V].
    pulse, pause : float
        Durations [s].
    count : int
        Pulses.
    dt : float
        Sample interval [s].
    """
    period = pulse + pause
    t: FloatArray = dt * np.arange(round(count * period / dt) + 1, dtype=np.float64)
    v = np.zeros((t.size, 2))
    number = np.minimum((t / period).astype(int), count - 1)
    on = (t - number * period >= 0.5 * pause) & (t - number * period < 0.5 * pause + pulse)
    v[on, number[on] % 2] = voltage
    return t, v


@dataclass(frozen=True)
class Motions:
    """The same motion by the full and the reduced model, with the processor time [s] of each."""

    v: FloatArray
    full: FullOrderMotion
    reduced: FreeRun
    full_seconds: float
    reduced_seconds: float

    @property
    def nrmse(self) -> dict[str, float | None]:
        """NRMSE (eq. 41) of the reduced against the full model; None where one of them diverged."""
        pairs = {
            "q": (self.full.q, self.reduced.q),
            "qdot": (self.full.qdot, self.reduced.qdot),
            "qddot": (self.full.qddot, self.reduced.qddot),
        }
        whole = self.full.status == self.reduced.status == "ok"
        return {name: nrmse(full, reduced) if whole else None for name, (full, reduced) in pairs.items()}


def simulate_both(parameters: JointParameters, t: FloatArray, v: FloatArray, *, q0: float | None = None) -> Motions:
    """Free run of the full-order and the reduced model from rest at q0 [m], or in the left well.

    Parameters
    ----------
    parameters : JointParameters
        The joint.
    t : FloatArray, shape (N,)
        Uniform times [s].
    v : FloatArray, shape (N, 2)
        Voltages [V].
    q0 : float, optional
        First displacement [m]; that of the left well if left out.
    """
    start = q0 if q0 is not None else next(e.q for e in equilibria(parameters, v[0]) if e.stable)
    state = rest_state(parameters, start, 0.0, v[0])
    reduced = reduce_joint(parameters)
    # The first calls load compiled code; the times are those of the simulations.
    simulate(parameters, t[:2], v[:2], state)
    simulate_reduced(reduced, t[:2], v[:2], start, 0.0)
    begin = time.process_time()
    full = simulate(parameters, t, v, state, tolerance=TOLERANCE)
    between = time.process_time()
    short = simulate_reduced(reduced, t, v, start, 0.0)
    return Motions(v, full, short, between - begin, time.process_time() - between)
