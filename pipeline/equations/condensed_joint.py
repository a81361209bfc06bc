"""The condensed joint: the analytical model in slow coordinates, without its stiff axial and inertial shape modes.

The full model (eq. 19) has ten states and eigenvalues up to 5e4 1/s, because the beam's higher shapes have almost
no inertia and a large viscosity. Here the beam is w(x) = l W(x/l) with

    W = Q h1 + τ h2 + β h3,   h1 = 3ξ² − 2ξ³,   h2 = ξ³ − ξ²,   h3 = ξ²(1 − ξ)²,

the polynomials of eq. 13 in other coordinates: Q = q/l is the tip's displacement, τ = w'(l) its slope and β an interior
shape mode that moves neither. All three have inertia: τ a frame's (which Table 1 does not give: without any, τ would be
stiff and a least value stands in), and β lifts and lowers the whole frame, as it shortens the beam; of its own it has a
least value. The axial strain u0 (10 µm) is a constant. What stays is passive by construction without voltage: every
force comes from a potential, a damper, a Maxwell element or a stop operator.

What a real joint has and the paper's analytical model lacks is added: two sides of their own, generalised Maxwell slip
as stop operators, layers of the beam that yield (stop operators on its curvature), linear creep elements on q,
membranes that soften while a log lasts, and RBF
corrections (eq. 38): of restoring force, damping and both electrostatic forces in q, and to second order in the
deviation s = τ − ratio Q from the quasi-static slope, because while it snaps the beam is
not where a function of q alone would put it: the potential −m(q) s + ½ b(q) s² − (h_left(q) u_1 + h_right(q) u_2) s
and the loss c(q) ṡ². They are gradients and dampers, so the joint stays passive; c never takes more than half of the
beam's own loss, in whatever direction. Softening takes energy; with the other sign of its constant it gives some, once.

States and constants: `pipeline.equations.condensed_parts`.
"""

from typing import Any

import casadi as ca

from . import elements
from .beam import STIFFNESS_BB, STIFFNESS_QQ, STIFFNESS_QT, STIFFNESS_TT, Expression
from .condensed_parts import (
    AT_REST,
    BRANCHES,
    CORRECTIONS,
    CREEPS,
    ELEMENT_STATES,
    FIRST_ELEMENT,
    FIRST_STRAIN,
    SHAPE,
    SOFTENING,
    STATES,
    STOP_DIRECTIONS,
    STOP_ELEMENTS,
    STOP_SHARES,
    STOPS,
    CondensedSymbols,
    FrameAngle,
    beam_gradient,
    frame_angle,
    frame_inertia,
    shortening,
)
from .tip_elements import TipElement, tip_elements

_STRETCH_REFERENCE = 1.4
"""Stretch about which deviations from neo-Hooke and from C = C0 λ are counted: the pre-strain of figure 1."""
_FAR_STRETCH = 0.3
"""Difference from it beyond which the hardening is constant; joints reach 0.2."""


_Side = tuple[Expression, tuple[Expression, Expression, Expression], Expression]


def _membrane(s: CondensedSymbols, side: int, phi: FrameAngle, u_y: Any, speeds: tuple[Any, Any, Any]) -> _Side:
    """Tension [N]; ∂L/∂q [1], ∂L/∂τ [m] and ∂L/∂u_y [1]; λ̇3 [1/s] of one membrane (eqs. 4 to 6, 11, 12)."""
    name = ("left", "right")[side]
    sign = (-1.0, 1.0)[side]

    def k(entry: str) -> Expression:
        """A constant of this side."""
        return s.constant(f"{name}_{entry}")

    a = k("a")
    c = k("c")
    l0 = k("l0")
    tip = (s.x[0], phi.sin, phi.cos, u_y)
    length, x, y = elements.length(sign, (a, c, k("e_z"), k("e_x")), s.constant("l"), tip)
    stretch = length / l0
    thickness = elements.thickness_stretch(stretch)
    inverse = thickness * thickness  # 1/λ
    excess = stretch - _STRETCH_REFERENCE
    # The strain of the losses: λ3 as in the paper, or any other power of λ, such as Hencky's
    by_length = elements.thickness_slope(thickness) / l0
    by_length *= elements.power(s.constant("strain_slope"), excess, _STRETCH_REFERENCE)
    near = ca.fmin(_FAR_STRETCH, ca.fmax(-_FAR_STRETCH, excess))
    harder = 1.0 + (k("hardening") + k("hardening_slope") * near) * near
    softer = 1.0 - s.constant("softening") * s.x[SOFTENING]
    tension = k("elastic") * elements.neo_hooke_slope(stretch, inverse) * harder * softer
    tension -= k("electric") * s.u[side] * elements.power(k("electric_slope"), excess, _STRETCH_REFERENCE)
    strain = sum(k(f"maxwell_{i}") * s.x[FIRST_STRAIN + 2 * i + side] for i in range(BRANCHES))
    over = inverse / l0  # 1/length
    by_phi = (x * (sign * a * phi.sin + c * phi.cos) + y * (sign * a * phi.cos - c * phi.sin)) * over
    along = (-x * over, by_phi * phi.turn, -y * over)
    rate = sum(by * speed for by, speed in zip(along, speeds, strict=True))
    tension = tension / l0 + strain * by_length + k("viscous") * by_length * by_length * rate
    return tension, along, by_length * rate


def _least_loss(s: CondensedSymbols) -> Expression:
    """Least c [N·m·s] that leaves half of the beam's loss in every direction of the speeds.

    With the beam's loss D on (q̇/l, τ̇, β̇) and ṡ = aᵀ(q̇/l, τ̇, β̇) it is −½/(aᵀ D⁻¹ a). D is that of Q̇, the end's slope and
    β̇, which is inverted, seen from other coordinates.
    """
    k = s.constant
    end = k("slope_by_tau")
    across = -(k("slope_by_q") + end * k("slope_ratio"))
    apart = STIFFNESS_QQ * STIFFNESS_TT - STIFFNESS_QT**2
    given = (STIFFNESS_TT * across**2 - 2.0 * STIFFNESS_QT * across + STIFFNESS_QQ) / apart
    given += k("slope_by_beta") ** 2 / STIFFNESS_BB
    return -0.5 * k("bending_loss") * end**2 / given


def _corrections(s: CondensedSymbols) -> tuple[Expression, Expression]:
    """Force [N] on q and moment [N·m] on τ of the RBF corrections and of viscous friction."""
    k = s.constant
    c = s.correction
    u = s.u
    p = s.x[1]
    ratio = k("slope_ratio") / k("l")
    deviation = s.x[2] - ratio * s.x[0]
    deviation_dot = s.x[3] - ratio * p
    moment = c("moment") - c("stiffness") * deviation + c("left_moment") * u[0] + c("right_moment") * u[1]
    moment -= ca.fmax(c("loss"), _least_loss(s)) * deviation_dot
    along = c("moment_q") - 0.5 * c("stiffness_q") * deviation + c("left_moment_q") * u[0] + c("right_moment_q") * u[1]
    force = c("force") + c("left") * u[0] + c("right") * u[1] + deviation * along - ratio * moment
    return force - ca.fmax(k("viscosity") + c("damping"), 0.0) * p, moment


def forces(s: CondensedSymbols, friction: Expression) -> tuple[Expression, list[Expression]]:
    """All forces on q [N], τ [N·m] and β [J] but inertia, (3,), and λ̇3 [1/s] of both membranes.

    `friction` are the forces of the stop operators, (3,).
    """
    k = s.constant
    x = s.x
    q = x[0]
    p = x[1]
    l = k("l")
    loss = k("bending_loss")
    g_q, g_t, g_b = beam_gradient(s)
    u_y, along_u = shortening(s)
    phi = frame_angle(s)
    speed = p / l
    u_dot = ca.dot(along_u, s.speeds)
    sides = [_membrane(s, side, phi, u_y, (p, x[3], u_dot)) for side in range(2)]
    axial = _axial(s, sides)
    end_dot = k("slope_by_q") * speed + k("slope_by_tau") * x[3] + k("slope_by_beta") * x[5]
    end_loss = loss * (STIFFNESS_QT * speed + STIFFNESS_TT * end_dot)
    beam_loss = loss * (STIFFNESS_QQ * speed + STIFFNESS_QT * end_dot) + k("slope_by_q") * end_loss
    force, moment = _corrections(s)
    force -= (g_q + beam_loss) / l + axial * along_u[0] + sum(tension * along[0] for tension, along, _ in sides)
    moment -= (
        g_t + axial * along_u[1] + k("slope_by_tau") * end_loss + sum(tension * along[1] for tension, along, _ in sides)
    )
    moment += k("weight") * k("offset") * phi.sin * phi.turn
    force += k("side_force") - friction[0] - sum(element.resistance(*_tip(s, element)) for element in tip_elements())
    moment -= friction[1]
    force -= sum(k(f"creep_stiffness_{i}") * (q - x[FIRST_ELEMENT + i]) for i in range(CREEPS))
    interior_loss = loss * STIFFNESS_BB * x[5] + k("slope_by_beta") * end_loss
    interior = -(g_b + axial * along_u[2] + interior_loss) - friction[2]
    return ca.vertcat(force, moment, interior), [thinning for _, _, thinning in sides]


def _axial(s: CondensedSymbols, sides: list[_Side]) -> Expression:
    """Load [N] on the beam's axis, of the frame's weight and the membranes."""
    return s.constant("weight") + sum(tension * along[2] for tension, along, _ in sides)


def upright_load(s: CondensedSymbols) -> Expression:
    """The load [N] on the axis of the beam that stands upright at rest, without voltage."""
    sides = [_membrane(s, side, frame_angle(s), 0.0, (0.0, 0.0, 0.0)) for side in range(2)]
    return ca.substitute(_axial(s, sides), ca.vertcat(s.x, s.u), ca.DM.zeros(STATES + 2))


def rates(s: CondensedSymbols, friction: Expression) -> Expression:
    """Rates of the state, shape (STATES,)."""
    k = s.constant
    x = s.x
    acting, thinning = forces(s, friction)
    mass, centrifugal = frame_inertia(s)
    accelerations = ca.mtimes(ca.inv_minor(mass), acting + centrifugal)
    derivatives = [each for i in range(3) for each in (s.speeds[i], accelerations[i])]
    derivatives += [
        elements.maxwell_rate(thinning[side], k(f"relaxation_{i}"), x[FIRST_STRAIN + 2 * i + side])
        for i in range(BRANCHES)
        for side in range(2)
    ]
    derivatives += [elements.creep_rate(k(f"creep_rate_{i}"), x[0], x[FIRST_ELEMENT + i]) for i in range(CREEPS)]
    derivatives.append(elements.softening_rate(k("softening_rate"), x[SOFTENING]))
    derivatives += [state.rate(*_tip(s, element)) for element in tip_elements() for state in element.states]
    return ca.vertcat(*derivatives)


def _tip(
    s: CondensedSymbols, element: TipElement
) -> tuple[Expression, Expression, list[Expression], dict[str, Expression]]:
    """Arguments of the terms of an element on q."""
    names = [name for name, _ in ELEMENT_STATES]
    states = [s.x[FIRST_ELEMENT + names.index(state.name)] for state in element.states]
    return s.x[0], s.x[1], states, {c.name: s.constant(c.name) for c in element.constants}


def stop_forces(s: CondensedSymbols, states: list[Expression]) -> Expression:
    """Forces of stop operators in these states on q [N], τ [N·m] and β [J], (3,)."""
    return sum(
        (s.constant(f"stop_force_{STOP_ELEMENTS[i]}") * STOP_SHARES[i] * states[i]) * along
        for i, along in enumerate(_directions(s))
    )


def _directions(s: CondensedSymbols) -> list[Expression]:
    """Slopes of the coordinate of each stop operator along (q, τ, β) [1, m, m], each (3,)."""
    arm = s.constant("friction_arm")
    l = s.constant("l")
    return [ca.vertcat(q, by_arm * arm + tau * l, beta * l) for q, by_arm, tau, beta in STOP_DIRECTIONS]


def moved_stops(s: CondensedSymbols) -> list[Expression]:
    """Stop operators at x, by the play since the start of the step: they need no differential equation."""
    return [
        elements.stop_operator(s.z[i], ca.dot(along, s.shape - s.start), _travel(s, i))
        for i, along in enumerate(_directions(s))
    ]


def _travel(s: CondensedSymbols, stop: int) -> Expression:
    """Travel [m] of a stop operator."""
    return s.constant(f"stop_travel_{STOP_ELEMENTS[stop]}")


def stop_rates(s: CondensedSymbols) -> list[Expression]:
    """Rates [1/s] of the stop operators where they are states."""
    return [
        elements.stop_rate(s.z[i], ca.dot(along, s.speeds), _travel(s, i)) for i, along in enumerate(_directions(s))
    ]


def linearised(s: CondensedSymbols) -> tuple[Expression, dict[str, Expression], Expression]:
    """The corrections' slopes along q, an input; rates of (x, z) with their exact derivatives; and that by constants.

    Rates are `f` (STATES + STOPS,), derivatives `a` by (x, z), with those slopes, `b` by the squared voltages and
    `by_c` by the corrections. Where friction turns or sticks, that of the side on which the motion goes on.
    """
    slopes = ca.SX.sym("c_q", len(CORRECTIONS))
    f = ca.vertcat(rates(s, stop_forces(s, [s.z[i] for i in range(STOPS)])), *stop_rates(s))
    by_c = ca.jacobian(f, s.c)
    a = ca.jacobian(f, ca.vertcat(s.x, s.z))
    a[:, 0] = a[:, 0] + ca.mtimes(by_c, slopes)
    return slopes, {"f": f, "a": a, "b": ca.jacobian(f, s.u), "by_c": by_c}, ca.jacobian(f, s.k)


def rest_forces(s: CondensedSymbols) -> Expression:
    """Forces [N, N·m, J] on (q, τ, β) at rest, shape (3,): no friction, strains relaxed, creep caught up.

    The membranes are as soft as the state says.
    """
    acting, _ = forces(s, ca.SX.zeros(3))
    still = {i: s.x[i] for i in (*SHAPE, SOFTENING)}
    crept = {FIRST_ELEMENT + i: at_rest * s.x[0] for i, at_rest in enumerate(AT_REST)}
    return ca.substitute(acting, s.x, ca.vertcat(*((crept | still).get(i, ca.SX(0)) for i in range(STATES))))
