"""Parts of the condensed joint: its states, constants and corrections, its beam, and its frame.

State x: q [m], q̇ [m/s], τ [1], τ̇ [1/s], β [1], β̇ [1/s]; e1, e2 [1] of each Maxwell branch; `ELEMENT_STATES`: one creep
displacement [m] per creep element, the softening [1] of the membranes, and the states of further elements on q
(`pipeline.equations.tip_elements`).

The beam has an energy of its shape (Q, τ, β) and a shortening. Both have terms which no slender beam of uniform section
has: a printed beam is uneven, its clamps give way, and a chain of links is no beam at all. The frame has an angle, and
the inertia of frame and beam.
"""

import math
from dataclasses import dataclass
from itertools import combinations_with_replacement

import casadi as ca

from .beam import Expression, Powers, bending_density, shapes
from .tip_elements import tip_elements

SLIPS = 4
LAYERS = 2
CREEPS = 2
BRANCHES = 3
"""Elements of friction; layers of the beam that yield; creep elements on q; Maxwell elements of each membrane: the
paper's, a slow one and a fast one."""
_GAUSS = ((0.5 - math.sqrt(0.15), 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + math.sqrt(0.15), 5.0 / 18.0))
"""Places ξ along the beam and their weights, by Gauss's rule with three points."""
STOP_ELEMENTS = (*range(SLIPS), *(SLIPS + layer for _ in _GAUSS for layer in range(LAYERS)))
"""Element of each stop operator: the slips of friction, then the layers at each place."""
STOP_SHARES = (*(1.0 for _ in range(SLIPS)), *(weight for _, weight in _GAUSS for _ in range(LAYERS)))
"""Share of its element's force."""
STOP_DIRECTIONS = (
    *((1.0, 1.0, 0.0, 0.0) for _ in range(SLIPS)),
    *(
        (1.0 - 2.0 * xi, 0.0, xi - 1.0 / 3.0, 1.0 / 3.0 - 2.0 * xi * (1.0 - xi))
        for xi, _ in _GAUSS
        for _ in range(LAYERS)
    ),
)
"""Its coordinate [m] is a q + (b friction_arm + c l) τ + d l β with these numbers. Friction acts on q and a part of the
frame's turn. A layer follows the curvature of the beam where it is: its coordinate is l² w''(ξ)/6."""
STOPS = len(STOP_ELEMENTS)
"""Stop operators."""
ELEMENT_STATES = (
    *((f"creep_{i}", "m") for i in range(CREEPS)),
    ("softening", "1"),
    *((state.name, state.unit) for element in tip_elements() for state in element.states),
)
"""Name and unit of the states from `FIRST_ELEMENT` on."""
AT_REST = (
    *(1.0 for _ in range(CREEPS)),
    0.0,
    *(state.at_rest for element in tip_elements() for state in element.states),
)
"""Their values over q at rest."""
FIRST_STRAIN = 6
SHAPE, SHAPE_RATES = range(0, FIRST_STRAIN, 2), range(1, FIRST_STRAIN, 2)
"""Places of the coordinates (q, τ, β) of the beam's shape in the state, and of their rates."""
FIRST_ELEMENT = FIRST_STRAIN + 2 * BRANCHES
STATES = FIRST_ELEMENT + len(ELEMENT_STATES)
SOFTENING = FIRST_ELEMENT + CREEPS
"""Place of the softening in the state."""

TIP_CONSTANTS = tuple((c.name, c.typical, c.prior_std, c.unit) for element in tip_elements() for c in element.constants)
"""Name, typical value [SI], prior width of the logarithm and unit of the constants of elements on q."""
DRY_LEVELS = tuple(element.level for element in tip_elements() if element.level)
"""Constants that are levels of dry friction."""
_SIDE = ("a", "c", "e_z", "e_x", "l0", "elastic", "hardening", "hardening_slope", "electric", "electric_slope",
         "maxwell_0", "maxwell_1", "maxwell_2", "viscous")  # fmt: skip
QUARTICS = tuple("".join(powers) for powers in combinations_with_replacement("qtb", 4))
"""Quartic terms of the beam's energy in Q, τ and β, beside those of eq. 9."""
SEXTICS = tuple("".join(powers) + "bbb" for powers in combinations_with_replacement("qtb", 3))
"""Sextic terms: those with β³, as β carries most of the bending. They predict as well as all 28 do."""
SHORTENINGS = tuple(powers for powers in QUARTICS if powers.count("b") < 2)
"""Quartic terms of the shortening. With the other six joints are predicted no better."""
CONSTANTS = (
    "l", "bending", "bending_loss", "steepening", "stiffening", "curvature",
    "slope_by_q", "slope_by_tau", "slope_by_beta", "rotation",
    *(f"quartic_{powers}" for powers in QUARTICS),
    *(f"sextic_{powers}" for powers in SEXTICS),
    *(f"shortening_{powers}" for powers in SHORTENINGS),
    "mass", "cross", "inertia", "gyration", "interior_inertia",
    "rise_qq", "rise_qt", "rise_tt", "rise_qb", "rise_tb", "rise_bb", "weight", "offset", "side_force",
    "relaxation_0", "relaxation_1", "relaxation_2", "strain_slope",
    "viscosity", *(name for name, *_ in TIP_CONSTANTS), "friction_arm",
    *(f"left_{name}" for name in _SIDE),
    *(f"right_{name}" for name in _SIDE),
    *(f"stop_force_{i}" for i in range(SLIPS + LAYERS)),
    *(f"stop_travel_{i}" for i in range(SLIPS + LAYERS)),
    *(f"creep_stiffness_{i}" for i in range(CREEPS)),
    *(f"creep_rate_{i}" for i in range(CREEPS)),
    "softening", "softening_rate",
    "slope_ratio",
)  # fmt: skip
"""Constants, all SI; `pipeline.models.hybrid.parameters` says how each is made."""

CORRECTIONS = (
    "force", "damping", "left", "right", "moment", "stiffness", "left_moment", "right_moment", "loss",
    "moment_q", "stiffness_q", "left_moment_q", "right_moment_q",
)  # fmt: skip
"""Values of the correction curves at q [N, N·s/m, N/V², N/V², N·m, N·m, N·m/V², N·m/V², N·m·s], then the slopes along q
of four of them [per m]."""


@dataclass(frozen=True)
class CondensedSymbols:
    """Independent variables: state, stop operators at the start of a step, (q, τ, β) there, squared voltages [V²],
    constants, corrections.
    """

    x: Expression
    z: Expression
    start: Expression
    u: Expression
    k: Expression
    c: Expression

    def constant(self, name: str) -> Expression:
        """The symbol of one constant."""
        return self.k[CONSTANTS.index(name)]

    def correction(self, name: str) -> Expression:
        """The symbol of one correction."""
        return self.c[CORRECTIONS.index(name)]

    @property
    def shape(self) -> Expression:
        """The coordinates (q, τ, β) of the beam's shape, (3,)."""
        return ca.vertcat(*(self.x[i] for i in SHAPE))

    @property
    def speeds(self) -> Expression:
        """Their rates, (3,)."""
        return ca.vertcat(*(self.x[i] for i in SHAPE_RATES))


def symbols() -> CondensedSymbols:
    """Fresh symbols."""
    sizes = {"x": STATES, "z": STOPS, "start": 3, "u": 2, "k": len(CONSTANTS), "c": len(CORRECTIONS)}
    return CondensedSymbols(**{name: ca.SX.sym(name, size) for name, size in sizes.items()})


_ORDER = "qtb"
"""Letters of Q, τ and β in the names of constants."""
_FAR = (0.35, 0.6, 1.6)
"""Tip displacement over length, tip slope and interior shape up to which added terms grow; joints reach 0.28, 0.5 and
1.2. From there on they level off, and are constant from one and a half times that on."""


def beam_gradient(s: CondensedSymbols) -> list[Expression]:
    """∂U_s/∂(Q, τ, β) [J] of eq. 9 (as corrected) and of the added terms.

    The beam's own slope is slope_by_q Q + slope_by_tau τ + slope_by_beta β, because clamps and a printed beam of uneven
    section make another stiffness than 12, −6, 4 and 0.8; its shortening is another, too (`raised`).
    """
    k = s.constant
    shape = [s.x[0] / k("l"), s.x[2], s.x[4]]
    slope = k("slope_by_q") * shape[0] + k("slope_by_tau") * shape[1] + k("slope_by_beta") * shape[2]
    moving = [shape[0], slope, shape[2]]
    constant = [k(name) for name in ("curvature", "steepening", "stiffening")]
    energy = _slender_energy()
    by_q, by_slope, by_b = (energy.derivative(i).at(moving, constant) for i in range(3))
    slender = (by_q + k("slope_by_q") * by_slope, k("slope_by_tau") * by_slope, by_b + k("slope_by_beta") * by_slope)
    return [
        k("bending") * (force + more) for force, more in zip(slender, _hardening_gradient(s, _near(s)), strict=True)
    ]


def shortening(s: CondensedSymbols) -> tuple[Expression, Expression]:
    """u_y [m] of eq. 2 and ∂u_y/∂(q, τ, β) [1, m, m], shape (3,).

    Beyond second order (`raised`) it is −l Σ shortening Q^i τ^j β^k, i + j + k = 4 and k < 2.
    """
    l = s.constant("l")
    near = _near(s)
    up = raised(s)
    bows = _quartic_gradient(s, near, "shortening")
    bowed = 0.25 * sum(value * by for value, by in zip(near.values.values(), bows, strict=True))  # Euler's theorem
    slopes = [by * slope for by, slope in zip(bows, near.slopes, strict=True)]
    return 0.5 * ca.dot(s.shape, up) - l * bowed, up - ca.vertcat(slopes[0], l * slopes[1], l * slopes[2])


def raised(s: CondensedSymbols) -> Expression:
    """Slopes of the height −½ (q, τ, β) R (q, τ, β)ᵀ [m] by which a beam that bends lifts its tip, (3,) [1, m, m]."""
    return ca.mtimes(-bends(s), s.shape)


def bends(s: CondensedSymbols) -> Expression:
    """The matrix R, (3, 3)."""
    names = [["".join(sorted(row + column, key=_ORDER.index)) for column in _ORDER] for row in _ORDER]
    return ca.vertcat(*(ca.horzcat(*(s.constant(f"rise_{name}") for name in row)) for row in names))


def _slender_energy() -> Powers:
    """Energy over EI/l by Q, own slope, β, then curvature and coefficients."""
    q, end, b, curvature, steepening, stiffening = Powers.variables(6)
    energy = q * 0.0
    for slopes, bent, weight in zip(*shapes(), strict=True):
        slope = q * slopes[0] + end * slopes[1] + b * slopes[2]
        bend = q * bent[0] + end * bent[1] + b * bent[2] + curvature * -1.0
        energy += bending_density(slope, bend, steepening) * (0.5 * weight)
        energy += bend * bend * bend * bend * stiffening * (0.25 * weight)
    return energy


_Products = dict[tuple[str, ...], Expression]


@dataclass(frozen=True)
class _Near:
    """Q, τ and β as far as added terms grow, their slopes along Q, τ and β, and products of two and three of them."""

    values: dict[str, Expression]
    slopes: list[Expression]
    pairs: _Products
    triples: _Products


def _near(s: CondensedSymbols) -> _Near:
    """Coordinates that level off smoothly beyond `_FAR`: no sign of a term then lets the energy fall for ever."""
    values = {}
    slopes = []
    for letter, x, far in zip(_ORDER, (s.x[0] / s.constant("l"), s.x[2], s.x[4]), _FAR, strict=True):
        limited = ca.fmin(1.5 * far, ca.fmax(-1.5 * far, x))
        above = ca.fmax(0.0, limited - far)
        below = ca.fmax(0.0, -far - limited)
        values[letter] = limited - (above * above - below * below) / far
        slopes.append(1.0 - (above + below) * (2.0 / far))
    pairs: _Products = {two: values[two[0]] * values[two[1]] for two in combinations_with_replacement(_ORDER, 2)}
    threes = combinations_with_replacement(_ORDER, 3)
    return _Near(values, slopes, pairs, {three: pairs[three[:2]] * values[three[2]] for three in threes})


def _hardening_gradient(s: CondensedSymbols, near: _Near) -> list[Expression]:
    """∂/∂(Q, τ, β) of Σ quartic Q^i τ^j β^k + β³ Σ sextic Q^i τ^j β^k, i + j + k = 4 and 3."""
    cube = near.triples["b", "b", "b"]
    sextic = sum(s.constant(f"sextic_{''.join(three)}bbb") * at for three, at in near.triples.items())
    gradient = []
    for letter, slope, quartic in zip(_ORDER, near.slopes, _quartic_gradient(s, near, "quartic"), strict=True):
        by = sum(_coefficient(s, letter, two, "bbb", "sextic") * at for two, at in near.pairs.items()) * cube + quartic
        if letter == "b":
            by += 3.0 * near.pairs["b", "b"] * sextic
        gradient.append(by * slope)
    return gradient


def _quartic_gradient(s: CondensedSymbols, near: _Near, name: str) -> list[Expression]:
    """Slopes of Σ name Q^i τ^j β^k along the values of `near`."""
    return [
        sum(_coefficient(s, letter, three, "", name) * at for three, at in near.triples.items()) for letter in _ORDER
    ]


def _coefficient(s: CondensedSymbols, letter: str, others: tuple[str, ...], factor: str, name: str) -> Expression:
    """Coefficient in the slope along `letter` of the term that is `letter` times `others` times `factor`."""
    powers = "".join(sorted((*others, letter), key=_ORDER.index))
    if name == "shortening" and powers not in SHORTENINGS:
        return 0.0
    return powers.count(letter) * s.constant(f"{name}_{powers}{factor}")


@dataclass(frozen=True)
class FrameAngle:
    """The frame's angle φ by sin φ = τ / √(1 + rotation τ²), arctan τ (eq. 1) for a rotation of 1.

    For 0 it is arcsin τ, the slope along the arc. Held are its sine and cosine, ∂φ/∂τ and ∂²φ/∂τ² over ∂φ/∂τ.
    """

    sin: Expression
    cos: Expression
    turn: Expression
    bend: Expression


def frame_angle(s: CondensedSymbols) -> FrameAngle:
    """The angle at the slope τ of the state."""
    tau = s.x[2]
    rotation = s.constant("rotation")
    root = ca.sqrt(1.0 + rotation * tau * tau)
    rest = ca.sqrt(1.0 + (rotation - 1.0) * tau * tau)
    over = 1.0 / (root * rest)
    of_root, of_rest = rest * over, root * over  # 1/√…
    bend = -tau * (2.0 * rotation * of_root * of_root + (rotation - 1.0) * of_rest * of_rest)
    return FrameAngle(tau * of_root, rest * of_root, of_root * over, bend)


def frame_inertia(s: CondensedSymbols) -> tuple[Expression, Expression]:
    """Mass matrix (3, 3) of (q, τ, β) [kg, kg·m, kg·m²], and centrifugal forces of the velocities, (3,) [N, N·m, J].

    They follow from T = ½ mass (ẋ² + ẏ²) + ½ gyration φ̇² + cross q̇ τ̇ + ½ inertia τ̇² + ½ interior_inertia β̇².
    x = q + offset sin φ and y = −½ (q, τ, β) R (q, τ, β)ᵀ + offset (cos φ − 1) are where the frame's centre of mass is:
    the beam shortens where it bends, and the frame tilts. `cross` and `inertia` are the beam's, `gyration` the frame's.
    """
    k = s.constant
    phi = frame_angle(s)
    speeds = s.speeds
    # ∂x and ∂y along (q, τ, β), and what ẍ and ÿ are without accelerations
    out = phi.cos * phi.turn
    down = phi.sin * phi.turn
    turning = phi.turn * s.x[3] * s.x[3]
    across = ca.vertcat(1.0, k("offset") * out, 0.0)
    up = raised(s) - ca.vertcat(0.0, k("offset") * down, 0.0)
    across_more = k("offset") * turning * (phi.cos * phi.bend - down)
    up_more = -ca.mtimes(speeds.T, ca.mtimes(bends(s), speeds)) - k("offset") * turning * (phi.sin * phi.bend + out)
    tilting = k("gyration") * phi.turn
    own = ca.vertcat(ca.horzcat(0.0, k("cross")), ca.horzcat(k("cross"), k("inertia") + tilting * phi.turn))
    mass = ca.diagcat(own, k("interior_inertia"))
    mass += k("mass") * (ca.mtimes(across, across.T) + ca.mtimes(up, up.T))
    push = k("mass") * (across * across_more + up * up_more)
    push[1] += tilting * phi.bend * turning
    return mass, -push
