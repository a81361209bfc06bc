"""The condensed joint: the analytical model in slow coordinates, without its stiff axial and inertial shape modes.

The full model (eq. 19) has ten states and eigenvalues up to 5e4 1/s, because the beam's higher shapes have almost
no inertia and a large viscosity. Here the beam is w(x) = l W(x/l) with

    W = Q h1 + τ h2 + β h3,   h1 = 3ξ² − 2ξ³,   h2 = ξ³ − ξ²,   h3 = ξ²(1 − ξ)²,

the polynomials of eq. 13 in other coordinates: Q = q/l is the tip's displacement, τ = w'(l) its slope and β an interior
shape mode that moves neither. All three have inertia: τ a frame's (which Table 1 does not give: without any, τ would be
stiff and a least value stands in), and β lifts and lowers the whole frame, as it shortens the beam; of its own it has a
least value. The axial strain u0 (10 µm) is a constant. What stays is passive by construction without voltage: every
force comes from a potential, a damper, a Maxwell element or a stop operator.

What a real joint has and the paper's analytical model lacks is added: two sides of their own, generalised
Maxwell slip on q as stop operators, linear creep elements on q, and RBF corrections (eq. 38): of restoring
force, damping and both electrostatic forces in q, and to second order in the deviation s = τ − ratio Q from the
quasi-static slope, because while it snaps the beam is not where a function of q alone would put it: the potential
−m(q) s + ½ b(q) s² − (h_left(q) u_1 + h_right(q) u_2) s and the loss c(q) ṡ². They are gradients and dampers, so the
joint stays passive; c never takes more than half of the slope's own loss.

State x: q [m], q̇ [m/s], τ [1], τ̇ [1/s], β [1], β̇ [1/s]; e1, e2 [1] of each Maxwell branch; `ELEMENT_STATES`: one creep
displacement [m] per creep element, and the states of further elements on q (`pipeline.equations.tip_elements`).
"""

from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import Any

import casadi as ca

from pipeline.equations import beam, elements, membrane
from pipeline.equations.beam import STIFFNESS_BB, STIFFNESS_QQ, STIFFNESS_QT, STIFFNESS_TT, Expression
from pipeline.equations.tip_elements import TipElement, tip_elements

STOPS, CREEPS, BRANCHES = 4, 2, 3
"""Stop operators; creep elements on q; Maxwell elements of each membrane: the paper's, a slow one and a fast one."""
ELEMENT_STATES = (
    *((f"creep_{i}", "m") for i in range(CREEPS)),
    *((state.name, state.unit) for element in tip_elements() for state in element.states),
)
"""Name and unit of the states from `FIRST_ELEMENT` on."""
AT_REST = (
    *(1.0 for _ in range(CREEPS)),
    *(state.at_rest for element in tip_elements() for state in element.states),
)
"""Their values over q at rest."""
FIRST_STRAIN = 6
FIRST_ELEMENT = FIRST_STRAIN + 2 * BRANCHES
STATES = FIRST_ELEMENT + len(ELEMENT_STATES)

TIP_CONSTANTS = tuple((c.name, c.typical, c.width) for element in tip_elements() for c in element.constants)
"""Name, typical value [SI] and prior width of the logarithm of the constants of elements on q."""
TIP_DIMENSIONS = {c.name: c.dimension for element in tip_elements() for c in element.constants}
"""Their powers of kg, m, s and V."""
DRY_LEVELS = tuple(element.level for element in tip_elements() if element.level)
"""Those which are levels of dry friction."""
_SIDE = ("a", "c", "e_z", "e_x", "l0", "elastic", "hardening", "hardening_slope", "electric", "electric_slope",
         "maxwell_0", "maxwell_1", "maxwell_2", "viscous")  # fmt: skip
QUARTICS = tuple("".join(powers) for powers in combinations_with_replacement("qtb", 4))
"""Quartic terms of the beam's energy in Q, τ and β, beside those of eq. 9."""
SEXTICS = tuple("".join(powers) + "bbb" for powers in combinations_with_replacement("qtb", 3))
"""Sextic terms: those with β³, as β carries most of the bending. They predict as well as all 28 do."""
CONSTANTS = (
    "l", "bending", "bending_loss", "steepening", "stiffening", "curvature",
    "slope_by_q", "slope_by_tau", "slope_by_beta", "rotation",
    *(f"quartic_{powers}" for powers in QUARTICS),
    *(f"sextic_{powers}" for powers in SEXTICS),
    *(f"shortening_{powers}" for powers in QUARTICS),
    "mass", "cross", "inertia", "gyration", "interior_inertia",
    "rise_qq", "rise_qt", "rise_tt", "rise_qb", "rise_tb", "rise_bb", "weight", "offset", "side_force",
    "relaxation_0", "relaxation_1", "relaxation_2", "strain_slope",
    "viscosity", *(name for name, _, _ in TIP_CONSTANTS), "friction_arm",
    *(f"left_{name}" for name in _SIDE),
    *(f"right_{name}" for name in _SIDE),
    *(f"stop_force_{i}" for i in range(STOPS)),
    *(f"stop_travel_{i}" for i in range(STOPS)),
    *(f"creep_stiffness_{i}" for i in range(CREEPS)),
    *(f"creep_rate_{i}" for i in range(CREEPS)),
    "slope_ratio",
)  # fmt: skip
"""Constants, all SI; `pipeline.joint.condensed_parameters` says how each is made."""

CORRECTIONS = (
    "force", "damping", "left", "right", "moment", "stiffness", "left_moment", "right_moment", "loss",
    "moment_q", "stiffness_q", "left_moment_q", "right_moment_q",
)  # fmt: skip
"""Values of the correction curves at q [N, N·s/m, N/V², N/V², N·m, N·m, N·m/V², N·m/V², N·m·s], then the slopes along q
of four of them [per m]."""

_STRETCH_REFERENCE = 1.4
"""Stretch about which deviations from neo-Hooke and from C = C0 λ are counted: the pre-strain of figure 1."""
_FAR_STRETCH = 0.3
"""Difference from it beyond which the hardening is constant; joints reach 0.2."""
_FAR = (0.35, 0.6, 1.6)
"""Tip displacement over length, tip slope and interior shape beyond which these terms are constant; joints reach
0.28, 0.5 and 1.2."""


@dataclass(frozen=True)
class Symbols:
    """Independent variables: state, stop operators at the start of a step, (q, τ) there, squared voltages [V²],
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


def symbols() -> Symbols:
    """Fresh symbols."""
    sizes = {"x": STATES, "z": STOPS, "start": 2, "u": 2, "k": len(CONSTANTS), "c": len(CORRECTIONS)}
    return Symbols(**{name: ca.SX.sym(name, size) for name, size in sizes.items()})


@dataclass(frozen=True)
class Forces:
    """What acts on q [N], τ [N·m] and β [J] apart from inertia, and λ̇3 [1/s] of both membranes."""

    force: Expression
    moment: Expression
    interior: Expression
    thinning: list[Expression]


def beam_gradient(s: Symbols) -> tuple[list[Expression], Expression, list[Expression]]:
    """∂U_s/∂(Q, τ, β) [J] of eq. 9 (as corrected), u_y [m] of eq. 2 and ∂u_y/∂(Q, τ, β) [m].

    The beam's own slope is slope_by_q Q + slope_by_tau τ + slope_by_beta β, because clamps and a printed beam of uneven
    section make another stiffness than 12, −6, 4 and 0.8; its shortening is another, too (`raised`).
    """
    k, l = s.constant, s.constant("l")
    shape = [s.x[0] / l, s.x[2], s.x[4]]
    slope = k("slope_by_q") * shape[0] + k("slope_by_tau") * shape[1] + k("slope_by_beta") * shape[2]
    moving, energy = [shape[0], slope, shape[2]], _beam_energy()
    constant = [k(name) for name in ("curvature", "steepening", "stiffening")]
    gradient = [energy.derivative(i).at(moving, constant) for i in range(3)]
    gradient[0] = gradient[0] + k("slope_by_q") * gradient[1]
    gradient[2] = gradient[2] + k("slope_by_beta") * gradient[1]
    gradient[1] = k("slope_by_tau") * gradient[1]
    gradient = [k("bending") * value for value in gradient]
    near = _near(shape)
    for i, added in enumerate(_hardening_gradient(s, near)):
        gradient[i] = gradient[i] + added
    bows = _form_gradient(s, near, "shortening")
    bowed = 0.25 * sum(near.values[one] * by for one, by in zip("qtb", bows, strict=True))
    bows = [by * near.slopes[one] for one, by in zip("qtb", bows, strict=True)]
    up = raised(s)
    u_y = 0.5 * ca.dot(ca.vertcat(s.x[0], s.x[2], s.x[4]), up) - l * bowed
    return gradient, u_y, [l * up[0] - l * bows[0], up[1] - l * bows[1], up[2] - l * bows[2]]


def raised(s: Symbols) -> Expression:
    """Slopes of the height −½ (q, τ, β) R (q, τ, β)ᵀ [m] by which a beam that bends lifts its tip, (3,) [1, m, m]."""
    return -ca.mtimes(_bends(s), ca.vertcat(s.x[0], s.x[2], s.x[4]))


def _bends(s: Symbols) -> Expression:
    """The matrix R, (3, 3)."""
    names = [["".join(sorted(one + two, key="qtb".index)) for two in "qtb"] for one in "qtb"]
    return ca.vertcat(*(ca.horzcat(*(s.constant(f"rise_{name}") for name in row)) for row in names))


def _beam_energy() -> beam.Powers:
    """Energy over EI/l by Q, own slope, β, then curvature and coefficients."""
    q, end, b, curvature, steepening, stiffening = beam.Powers.variables(6)
    energy = q * 0.0
    for slopes, bends, weight in zip(*beam.shapes(), strict=True):
        slope = q * slopes[0] + end * slopes[1] + b * slopes[2]
        bend = q * bends[0] + end * bends[1] + b * bends[2] + curvature * -1.0
        energy += beam.bending_density(slope, bend, steepening) * (0.5 * weight)
        energy += bend * bend * bend * bend * stiffening * (0.25 * weight)
    return energy


@dataclass(frozen=True)
class Near:
    """Q, τ and β within `_FAR`, what they change by with theirs, and products of three of them."""

    values: dict[str, Expression]
    slopes: dict[str, Expression]
    pairs: dict[tuple[str, ...], Expression]
    triples: dict[tuple[str, ...], Expression]


def _near(shape: list[Any]) -> Near:
    near, slopes = {}, {}
    for one, x, far in zip("qtb", shape, _FAR, strict=True):
        beyond = ca.fmin(0.5 * far, ca.fmax(0.0, ca.fabs(x) - far))
        near[one] = ca.fmin(1.5 * far, ca.fmax(-1.5 * far, x)) - ca.sign(x) * beyond * beyond / far
        slopes[one] = 1.0 - beyond * (2.0 / far)
    pairs = {two: near[two[0]] * near[two[1]] for two in combinations_with_replacement("qtb", 2)}
    triples = {three: pairs[three[:2]] * near[three[2]] for three in combinations_with_replacement("qtb", 3)}
    return Near(near, slopes, pairs, triples)


def _form_gradient(s: Symbols, near: Near, name: str) -> list[Expression]:
    return [sum(_slope(one, three, "", name, s.constant) * at for three, at in near.triples.items()) for one in "qtb"]


def _hardening_gradient(s: Symbols, near: Near) -> list[Expression]:
    """∂/∂(Q, τ, β) [J] of bending (Σ quartic Q^i τ^j β^k + β³ Σ sextic Q^i τ^j β^k), i + j + k = 4 and 3.

    They are what no slender beam of uniform section has. The arguments stop at `_FAR`, so that no sign of them lets the
    energy fall for ever.
    """
    k = s.constant
    square, cube = near.pairs["b", "b"], near.triples["b", "b", "b"]
    sextic = sum(k(f"sextic_{''.join(three)}bbb") * at for three, at in near.triples.items())
    found = []
    for one, quartic in zip("qtb", _form_gradient(s, near, "quartic"), strict=True):
        slope = sum(_slope(one, two, "bbb", "sextic", k) * at for two, at in near.pairs.items()) * cube
        slope += quartic
        if one == "b":
            slope += 3.0 * square * sextic
        found.append(k("bending") * slope * near.slopes[one])
    return found


def _slope(one: str, others: tuple[str, ...], factor: str, degree: str, k: Any) -> Expression:
    """Coefficient in the slope along `one` of the term that is `one` times `others` times `factor`."""
    powers = "".join(sorted((*others, one), key="qtb".index))
    return powers.count(one) * k(f"{degree}_{powers}{factor}")


@dataclass(frozen=True)
class FrameAngle:
    """The frame's angle φ by sin φ = τ / √(1 + rotation τ²), arctan τ (eq. 1) for a rotation of 1.

    For 0 it is arcsin τ, the slope along the arc. Held are its sine and cosine, ∂φ/∂τ and ∂²φ/∂τ² over ∂φ/∂τ.
    """

    sin: Expression
    cos: Expression
    turn: Expression
    bend: Expression


def frame_angle(s: Symbols) -> FrameAngle:
    """The angle at the slope τ of the state."""
    tau, rotation = s.x[2], s.constant("rotation")
    root, rest = ca.sqrt(1.0 + rotation * tau * tau), ca.sqrt(1.0 + (rotation - 1.0) * tau * tau)
    over = 1.0 / (root * rest)
    of_root, of_rest = rest * over, root * over  # 1/√…
    bend = -tau * (2.0 * rotation * of_root * of_root + (rotation - 1.0) * of_rest * of_rest)
    return FrameAngle(tau * of_root, rest * of_root, of_root * over, bend)


@dataclass(frozen=True)
class Inertia:
    """Mass matrix (3, 3) of (q, τ, β) [kg, kg·m, kg·m²], and what velocities push with beyond it, (3,) [N, N·m, J]."""

    mass: Expression
    centrifugal: Expression


def frame_inertia(s: Symbols) -> Inertia:
    """Inertia of T = ½ mass (ẋ² + ẏ²) + ½ gyration φ̇² + cross q̇ τ̇ + ½ inertia τ̇² + ½ interior_inertia β̇².

    x = q + offset sin φ and y = −½ (q, τ, β) R (q, τ, β)ᵀ + offset (cos φ − 1) are where the frame's centre of mass is:
    the beam shortens where it bends, and the frame tilts. `cross` and `inertia` are the beam's, `gyration` the frame's.
    """
    k, phi, speeds = s.constant, frame_angle(s), ca.vertcat(s.x[1], s.x[3], s.x[5])
    # ∂x and ∂y along (q, τ, β), and what ẍ and ÿ are without accelerations
    out, down, turning = phi.cos * phi.turn, phi.sin * phi.turn, phi.turn * s.x[3] * s.x[3]
    across = ca.vertcat(1.0, k("offset") * out, 0.0)
    up = raised(s) - ca.vertcat(0.0, k("offset") * down, 0.0)
    across_more = k("offset") * turning * (phi.cos * phi.bend - down)
    up_more = -ca.mtimes(speeds.T, ca.mtimes(_bends(s), speeds)) - k("offset") * turning * (phi.sin * phi.bend + out)
    tilting = k("gyration") * phi.turn
    own = ca.vertcat(ca.horzcat(0.0, k("cross")), ca.horzcat(k("cross"), k("inertia") + tilting * phi.turn))
    mass = ca.diagcat(own, k("interior_inertia"))
    mass += k("mass") * (ca.mtimes(across, across.T) + ca.mtimes(up, up.T))
    push = k("mass") * (across * across_more + up * up_more)
    push[1] += tilting * phi.bend * turning
    return Inertia(mass, -push)


def _membrane(
    s: Symbols, side: int, phi: FrameAngle, u_y: Any, speeds: tuple[Any, Any, Any]
) -> tuple[Expression, tuple[Expression, Expression, Expression], Expression]:
    """Tension [N]; ∂L/∂q [1], ∂L/∂τ [m] and ∂L/∂u_y [1]; λ̇3 [1/s] of one membrane (eqs. 4 to 6, 11, 12)."""
    name, sign = ("left", "right")[side], (-1.0, 1.0)[side]

    def k(entry: str) -> Expression:
        return s.constant(f"{name}_{entry}")

    a, c, l0 = k("a"), k("c"), k("l0")
    length, x, y = membrane.length(sign, a, c, k("e_z"), k("e_x"), s.constant("l"), s.x[0], phi.sin, phi.cos, u_y)
    stretch = length / l0
    thickness = membrane.thickness_stretch(stretch)
    inverse = thickness * thickness  # 1/λ
    excess = stretch - _STRETCH_REFERENCE
    # The strain of the losses: λ3 as in the paper, or any other power of λ, such as Hencky's
    by_length = membrane.thickness_slope(thickness) / l0
    by_length *= membrane.power(s.constant("strain_slope"), excess, _STRETCH_REFERENCE)
    near = ca.fmin(_FAR_STRETCH, ca.fmax(-_FAR_STRETCH, excess))
    harder = 1.0 + (k("hardening") + k("hardening_slope") * near) * near
    tension = k("elastic") * membrane.neo_hooke_slope(stretch, inverse) * harder
    tension -= k("electric") * s.u[side] * membrane.power(k("electric_slope"), excess, _STRETCH_REFERENCE)
    strain = sum(k(f"maxwell_{i}") * s.x[FIRST_STRAIN + 2 * i + side] for i in range(BRANCHES))
    over = inverse / l0  # 1/length
    by_phi = (x * (sign * a * phi.sin + c * phi.cos) + y * (sign * a * phi.cos - c * phi.sin)) * over
    along = (-x * over, by_phi * phi.turn, -y * over)
    rate = sum(by * speed for by, speed in zip(along, speeds, strict=True))
    tension = tension / l0 + strain * by_length + k("viscous") * by_length * by_length * rate
    return tension, along, by_length * rate


def _corrections(s: Symbols) -> tuple[Expression, Expression]:
    """Force [N] on q and moment [N·m] on τ of the RBF corrections and of viscous friction."""
    k, c, u, q, p = s.constant, s.correction, s.u, s.x[0], s.x[1]
    ratio = k("slope_ratio") / k("l")
    deviation, deviation_dot = s.x[2] - ratio * q, s.x[3] - ratio * p
    moment = c("moment") - c("stiffness") * deviation + c("left_moment") * u[0] + c("right_moment") * u[1]
    moment -= ca.fmax(c("loss"), -0.5 * STIFFNESS_TT * k("bending_loss")) * deviation_dot
    along = c("moment_q") - 0.5 * c("stiffness_q") * deviation + c("left_moment_q") * u[0] + c("right_moment_q") * u[1]
    force = c("force") + c("left") * u[0] + c("right") * u[1] + deviation * along - ratio * moment
    return force - ca.fmax(k("viscosity") + c("damping"), 0.0) * p, moment


def forces(s: Symbols, friction: Expression) -> Forces:
    """All forces but inertia; `friction` [N] acts on q + friction_arm τ."""
    k, x = s.constant, s.x
    q, p, turning = x[0], x[1], x[3]
    l, loss = k("l"), k("bending_loss")
    (g_q, g_t, g_b), u_y, (u_q, u_t, u_b) = beam_gradient(s)
    phi = frame_angle(s)
    speed = p / l
    u_dot = u_q * speed + u_t * turning + u_b * x[5]
    sides = [_membrane(s, side, phi, u_y, (p, turning, u_dot)) for side in range(2)]
    axial = k("weight") + sum(tension * along[2] for tension, along, _ in sides)
    end_dot = k("slope_by_q") * speed + k("slope_by_tau") * turning + k("slope_by_beta") * x[5]
    end_loss = loss * (STIFFNESS_QT * speed + STIFFNESS_TT * end_dot)
    beam_loss = loss * (STIFFNESS_QQ * speed + STIFFNESS_QT * end_dot) + k("slope_by_q") * end_loss
    force, moment = _corrections(s)
    force -= (g_q + axial * u_q + beam_loss) / l + sum(tension * along[0] for tension, along, _ in sides)
    moment -= g_t + axial * u_t + k("slope_by_tau") * end_loss + sum(tension * along[1] for tension, along, _ in sides)
    moment += k("weight") * k("offset") * phi.sin * phi.turn
    force += k("side_force") - friction - sum(element.resistance(*_tip(s, element)) for element in tip_elements())
    moment -= k("friction_arm") * friction
    force -= sum(k(f"creep_stiffness_{i}") * (q - x[FIRST_ELEMENT + i]) for i in range(CREEPS))
    interior_loss = loss * STIFFNESS_BB * x[5] + k("slope_by_beta") * end_loss
    return Forces(force, moment, -(g_b + axial * u_b + interior_loss), [thinning for _, _, thinning in sides])


def rates(s: Symbols, friction: Expression) -> Expression:
    """Rates of the state, shape (STATES,)."""
    k, x = s.constant, s.x
    acting = forces(s, friction)
    speeds = ca.vertcat(x[1], x[3], x[5])
    inertia = frame_inertia(s)
    pushed = ca.vertcat(acting.force, acting.moment, acting.interior) + inertia.centrifugal
    accelerations = ca.mtimes(ca.inv_minor(inertia.mass), pushed)
    found = [each for i in range(3) for each in (speeds[i], accelerations[i])]
    for i in range(BRANCHES):
        for side in range(2):
            found.append(
                elements.maxwell_rate(acting.thinning[side], k(f"relaxation_{i}"), x[FIRST_STRAIN + 2 * i + side])
            )
    for i in range(CREEPS):
        found.append(elements.creep_rate(k(f"creep_rate_{i}"), x[0], x[FIRST_ELEMENT + i]))
    for element in tip_elements():
        found += [state.rate(*_tip(s, element)) for state in element.states]
    return ca.vertcat(*found)


def _tip(s: Symbols, element: TipElement) -> tuple[Expression, Expression, list[Expression], dict[str, Expression]]:
    """What the laws of an element on q take."""
    names = [name for name, _ in ELEMENT_STATES]
    states = [s.x[FIRST_ELEMENT + names.index(state.name)] for state in element.states]
    return s.x[0], s.x[1], states, {c.name: s.constant(c.name) for c in element.constants}


def friction_of(s: Symbols, states: list[Expression]) -> Expression:
    """Friction [N] of stop operators in these states."""
    return sum(s.constant(f"stop_force_{i}") * states[i] for i in range(STOPS))


def moved_stops(s: Symbols) -> list[Expression]:
    """Stop operators at x, by the play since the start of the step: they need no differential equation."""
    play = s.x[0] - s.start[0] + s.constant("friction_arm") * (s.x[2] - s.start[1])
    return [elements.stop_operator(s.z[i], play, s.constant(f"stop_travel_{i}")) for i in range(STOPS)]


def stop_rates(s: Symbols) -> list[Expression]:
    """Rates [1/s] of the stop operators where they are states."""
    speed = s.x[1] + s.constant("friction_arm") * s.x[3]
    return [elements.stop_rate(s.z[i], speed, s.constant(f"stop_travel_{i}")) for i in range(STOPS)]


def linearised(s: Symbols) -> dict[str, Expression]:
    """Rates of (x, z) and their exact derivatives.

    `f` (STATES + STOPS,); `a` by (x, z), with the corrections' slopes along q, the input `c_q`; `b` by the squared
    voltages; `by_c` by the corrections; `by_k` by the constants. Where friction
    turns or sticks, that of the side on which the motion goes on.
    """
    slopes = ca.SX.sym("c_q", len(CORRECTIONS))
    f = ca.vertcat(rates(s, friction_of(s, [s.z[i] for i in range(STOPS)])), *stop_rates(s))
    by_c = ca.jacobian(f, s.c)
    a = ca.jacobian(f, ca.vertcat(s.x, s.z))
    a[:, 0] = a[:, 0] + ca.mtimes(by_c, slopes)
    return {"c_q": slopes, "f": f, "a": a, "b": ca.jacobian(f, s.u), "by_c": by_c, "by_k": ca.jacobian(f, s.k)}


def shape(s: Symbols) -> Expression:
    """Forces [N, N·m, J] on (q, τ, β) at rest, shape (3,): no friction, strains relaxed, creep caught up."""
    acting = forces(s, ca.SX(0))
    still = {i: ca.SX(0) for i in range(STATES)} | {i: s.x[i] for i in (0, 2, 4)}
    still |= {FIRST_ELEMENT + i: at_rest * s.x[0] for i, at_rest in enumerate(AT_REST)}
    at_rest = ca.vertcat(*(still[i] for i in range(STATES)))
    return ca.substitute(ca.vertcat(acting.force, acting.moment, acting.interior), s.x, at_rest)
