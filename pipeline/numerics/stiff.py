"""Linearly implicit Runge-Kutta steps for the full-order joint: the one integrator of what is stiff.

A step of length h from x solves, stage by stage,

    (1/(γ h) − J) y_i = right_i + Σ_j (c_ij / h) y_j,    right_i at x_i = start_i x + Σ_j a_ij y_j,

and what is integrated says what `right` and J are at a stage. The joint's spectrum (−5e4, −1366 ± 7955i … −0.7 ± 20.7i)
rules explicit methods out; these need no Newton iteration and restart for free after a voltage step. Two methods:

- `RODAS4`, order 4(3), for the motion (E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed.,
  Springer 1996, § IV.7, doi:10.1007/978-3-642-05221-7): y_i is an increment, J that of the step's start, the last stage
  completes the solution and is its error;
- `SDIRK3`, order 3 (R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006, doi:10.1137/0714068), for linear equations, as
  of the sensitivities: y_i is the solution at a stage, where J is known, and the last one is the new solution.

Both are L-stable. A state [q_m, q̇_m, z] has P columns, the motion one, the sensitivities one for each parameter; they
stand flat, entry i of column c at i P + c, so that loops over them become vector instructions. The stage system is
reduced to the velocities before it is factorised, 4×4 for all columns together: q_m enters as the integral of q̇_m and ż
is diagonal in z.
"""

from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from .arrays import FloatArray, IntArray
from .compiled import compiled, factorise, inner, part, solve_factorised

RITZ = 4
INTERNAL = 3
"""Ritz coordinates q_m; internal states z: Maxwell strains of both membranes, friction."""
FIRST_Z = 2 * RITZ
STATES = FIRST_Z + INTERNAL
"""q_m, q̇_m, z, and where z begins."""
_BLOCKS = (RITZ * RITZ, RITZ * RITZ, RITZ * INTERNAL, INTERNAL * RITZ, INTERNAL * RITZ, INTERNAL, RITZ * 2)
R_Q, R_V, R_Z, Z_Q, Z_V, Z_Z, R_S, SLOPES = accumulate(_BLOCKS, initial=0)
"""Offsets of the blocks of `motion_slopes`: r_q, r_v (4, 4), r_z (4, 3), z_q, z_v (3, 4), z_z (3,), r_s (4, 2)."""


class Method(NamedTuple):
    """Coefficients of a method of s stages.

    Attributes
    ----------
    gamma : float
        γ.
    start : FloatArray, shape (s,)
        Share of the step's first state in the state at each stage.
    a, c : FloatArray, shape (s, s − 1), or (s, 0) where the method has none
        Weights of the stages before.
    nodes : FloatArray, shape (s,)
        Places of the stages, as shares of the step.
    by_time : FloatArray, shape (s,)
        Share of h ∂f/∂t in the right-hand side of each stage.
    """

    gamma: float
    start: FloatArray
    a: FloatArray
    c: FloatArray
    nodes: FloatArray
    by_time: FloatArray


def _rosenbrock(gamma: float, a: FloatArray, c: FloatArray) -> Method:
    """A Rosenbrock method: with Γ = (1/γ − C)⁻¹ its nodes are the row sums of A Γ, its shares of ∂f/∂t those of Γ.

    C is lower triangular, so each row follows from those before it. LAPACK would take its workspace while this module
    is imported, and end the program where memory is short.
    """
    stages = len(a)
    by_time = np.zeros(stages)
    for i in range(stages):
        by_time[i] = gamma * (1.0 + c[i, :i] @ by_time[:i])
    return Method(gamma=gamma, start=np.ones(stages), a=a, c=c, nodes=a @ by_time[:-1], by_time=by_time)


RODAS4 = _rosenbrock(
    0.25,
    np.array(
        [
            [0.0, 0.0, 0.0, 0.0, 0.0],
            [1.544, 0.0, 0.0, 0.0, 0.0],
            [0.9466785280815826, 0.2557011698983284, 0.0, 0.0, 0.0],
            [3.314825187068521, 2.896124015972201, 0.9986419139977817, 0.0, 0.0],
            [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 0.0],
            [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0],
        ]
    ),
    np.array(
        [
            [0.0, 0.0, 0.0, 0.0, 0.0],
            [-5.6688, 0.0, 0.0, 0.0, 0.0],
            [-2.430093356833875, -0.2063599157091915, 0.0, 0.0, 0.0],
            [-0.1073529058151375, -9.594562251023355, -20.47028614809616, 0.0, 0.0],
            [7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160, 0.0],
            [8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054],
        ]
    ),
)


def _alexander() -> Method:
    """Alexander's tableau b for solutions y at the stages: x_i = x + Σ b_ij (y_j − x_j) / γ, solved for the y_j."""
    gamma = 0.4358665215084590
    middle = 0.5 * (1.0 + gamma)
    first = -0.25 * (6.0 * gamma**2 - 16.0 * gamma + 1.0)
    second = 0.25 * (6.0 * gamma**2 - 20.0 * gamma + 5.0)
    b = np.array([[0.0, 0.0, 0.0], [middle - gamma, 0.0, 0.0], [first, second, 0.0]]) / gamma
    a = np.zeros((3, 3))
    for i in range(3):
        a[i] = b[i] - b[i, :i] @ a[:i]
    return Method(
        gamma=gamma,
        start=1.0 - a.sum(axis=1),
        a=a,
        c=np.zeros((3, 0)),
        nodes=np.array([gamma, middle, 1.0]),
        by_time=np.zeros(3),
    )


SDIRK3 = _alexander()


class Work(NamedTuple):
    """Workspace of a step of s stages in P columns.

    Attributes
    ----------
    y : FloatArray, shape (s, STATES · P)
        Unknowns of the stages.
    at, right : FloatArray, shape (STATES · P,)
        State at a stage, and its right-hand side.
    forces : FloatArray, shape (4 P,)
        Part of the velocities' right-hand side that is already multiplied by the mass matrix.
    mass, slopes : FloatArray, shapes (4, 4) and (SLOPES,)
        The stage's matrices, as `motion` and `motion_slopes` of `pipeline.generated.analytical_joint` give them.
    factors, pivots : shapes (4, 4) and (4,)
        Those of `factorise_stages`.
    """

    y: FloatArray
    at: FloatArray
    right: FloatArray
    forces: FloatArray
    mass: FloatArray
    slopes: FloatArray
    factors: FloatArray
    pivots: IntArray


def working(stages: int, columns: int) -> Work:
    """Room for the steps of a run."""
    return Work(
        y=np.empty((stages, STATES * columns)),
        at=np.empty(STATES * columns),
        right=np.empty(STATES * columns),
        forces=np.zeros(RITZ * columns),
        mass=np.empty((RITZ, RITZ)),
        slopes=np.empty(SLOPES),
        factors=np.empty((RITZ, RITZ)),
        pivots=np.empty(RITZ, np.int64),
    )


@compiled(inline="always")
def advance(method: Method, stage_of: Any, system: Any, x: FloatArray, h: float, work: Work) -> bool:
    """The stages of a step of length `h` from x (STATES · P,), into `work.y`; False where the system fails.

    ``stage_of(system, i, h, work)`` fills `work.right` for the state `work.at` of stage i, and `work.forces`; where
    mass, slopes or h are new it calls `factorise_stages`. It returns whether it could.

    Parameters
    ----------
    method : Method
        `RODAS4` or `SDIRK3`.
    stage_of : callable
        Fills the right-hand side of a stage, see above.
    system : NamedTuple
        The system.
    x : FloatArray, shape (STATES · P,)
        State at the start of the step.
    h : float
        Length of the step [s].
    work : Work
        Room; `work.y` takes the stages.
    """
    shift = 1.0 / (method.gamma * h)
    for stage in range(len(method.nodes)):
        for i in range(len(x)):
            work.at[i] = method.start[stage] * x[i]
        _add(method.a, stage, 1.0, work.y, work.at)
        if not stage_of(system, stage, h, work):
            return False
        if method.c.shape[1] > 0:
            _add(method.c, stage, h, work.y, work.right)
        solve_stages(shift, work, work.y[stage])
    return True


@part
def _add(weights: FloatArray, stage: int, over: float, y: FloatArray, total: FloatArray) -> None:
    """Add the stages before `stage` by their weights / `over`."""
    for j in range(stage):
        weight = weights[stage, j] / over
        for i in range(len(total)):
            total[i] += weight * y[j, i]


@inner
def factorise_stages(shift: float, work: Work) -> bool:
    """Factorise the velocity block of ``shift·I − J``, multiplied by M: q_m and z are eliminated."""
    slopes = work.slopes
    factors = work.factors
    inverse = 1.0 / shift
    for i in range(RITZ):
        for j in range(RITZ):
            place = RITZ * i + j
            factors[i, j] = shift * work.mass[i, j] + slopes[R_V + place] + inverse * slopes[R_Q + place]
    for k in range(3):
        relaxed = 1.0 / (shift - slopes[Z_Z + k])
        for j in range(RITZ):
            place = RITZ * k + j
            coupled = relaxed * (slopes[Z_V + place] + inverse * slopes[Z_Q + place])
            for i in range(RITZ):
                factors[i, j] += slopes[R_Z + 3 * i + k] * coupled
    return bool(factorise(factors, work.pivots))


@compiled(inline="always")
def solve_stages(shift: float, work: Work, out: FloatArray) -> None:
    """Solve ``(shift·I − J) out = right``, with M⁻¹ `forces` for the velocities beside, in all columns at once.

    Parameters
    ----------
    shift : float
        1/(γ h) [1/s].
    work : Work
        Factors, mass, slopes and right-hand side.
    out : FloatArray, shape (STATES · P,)
        Solution (output).
    """
    mass = work.mass
    slopes = work.slopes
    right = work.right
    inverse = 1.0 / shift
    p = len(work.forces) // RITZ
    velocity = out[RITZ * p : FIRST_Z * p]
    internal = out[FIRST_Z * p :]
    below = right[RITZ * p :]
    for k in range(3):
        relaxed = shift - slopes[Z_Z + k]
        q0, q1, q2, q3 = _row(inverse, slopes, Z_Q + RITZ * k)
        for c in range(p):
            driven = q0 * right[c] + q1 * right[p + c] + q2 * right[2 * p + c] + q3 * right[3 * p + c]
            internal[k * p + c] = (right[(FIRST_Z + k) * p + c] + driven) / relaxed
    for i in range(RITZ):
        m0, m1, m2, m3 = _row(1.0, mass[i], 0)
        q0, q1, q2, q3 = _row(inverse, slopes, R_Q + RITZ * i)
        z0, z1, z2, _ = _row(1.0, slopes, R_Z + 3 * i)
        for c in range(p):
            value = work.forces[i * p + c] - z0 * internal[c] - z1 * internal[p + c] - z2 * internal[2 * p + c]
            value += m0 * below[c] + m1 * below[p + c] + m2 * below[2 * p + c] + m3 * below[3 * p + c]
            velocity[i * p + c] = value - (
                q0 * right[c] + q1 * right[p + c] + q2 * right[2 * p + c] + q3 * right[3 * p + c]
            )
    solve_factorised(work.factors, work.pivots, velocity)
    for i in range(RITZ * p):
        out[i] = inverse * (right[i] + velocity[i])
    for k in range(3):
        relaxed = 1.0 / (shift - slopes[Z_Z + k])
        q0, q1, q2, q3 = _row(inverse, slopes, Z_Q + RITZ * k)
        v0, v1, v2, v3 = _row(1.0, slopes, Z_V + RITZ * k)
        f0 = relaxed * (q0 + v0)
        f1 = relaxed * (q1 + v1)
        f2 = relaxed * (q2 + v2)
        f3 = relaxed * (q3 + v3)
        for c in range(p):
            follows = f0 * velocity[c] + f1 * velocity[p + c] + f2 * velocity[2 * p + c] + f3 * velocity[3 * p + c]
            internal[k * p + c] += follows


@part
def _row(scale: float, of: FloatArray, begin: int) -> tuple[float, float, float, float]:
    """Four entries of a matrix, read before a loop: it need not ask whether it writes to them."""
    return scale * of[begin], scale * of[begin + 1], scale * of[begin + 2], scale * of[begin + 3]
