"""The analytical joint: full order (eq. 19), and reduced to one coordinate (eq. 26).

The energies of the full order stand here; everything else follows by automatic differentiation. The curves of the
reduced joint over q are inputs. Equation numbers are the paper's; where its print is wrong, the correction and its
reason stand beside the equation.

Symbols: ``qm`` = [q2, q3, q4, u0] Ritz coordinates [1/m, 1/m², 1/m³, m]; ``z`` = [e1, e2, ζ] internal states:
Maxwell strains [1] and friction state [1]; ``v_squared`` = [v1², v2²] [V²]; ``p`` the parameters in the order of
`pipeline.device.parameters.VECTOR_NAMES`.
"""

from dataclasses import dataclass
from typing import Any

import casadi as ca

from ..device.parameters import BEAM_DAMPING_FACTOR, VECTOR_NAMES, capacitance, volume
from . import elements
from .beam import Expression, Powers, bending_density


@dataclass(frozen=True)
class FullSymbols:
    """The independent variables of all expressions."""

    qm: Expression
    qm_dot: Expression
    qm_ddot: Expression
    z: Expression
    v_squared: Expression
    force: Expression
    p: Expression

    def parameter(self, name: str) -> Expression:
        """The symbol of one parameter."""
        return self.p[VECTOR_NAMES.index(name)]


def symbols() -> FullSymbols:
    """Fresh symbols."""
    names = {"qm": 4, "qm_dot": 4, "qm_ddot": 4, "z": 3, "v_squared": 2, "force": 1, "p": len(VECTOR_NAMES)}
    return FullSymbols(**{name: ca.SX.sym(name, size) for name, size in names.items()})


def _beam() -> tuple[Powers, Powers, Powers, Powers]:
    """Integrals over the beam by (c2, c3, c4, l κ0), where w/l = c2 s² + c3 s³ + c4 s⁴ (eq. 13), s = x/l: ∫w'²;
    ∫w²/l²; ∫(l w'')² without κ0; ∫(l w'' − l κ0)²(1 + w'²).
    """
    c2, c3, c4, curvature, s = Powers.variables(5)
    w = (c2 + (c3 + c4 * s) * s) * s * s
    slope = w.derivative(4)
    bend = slope.derivative(4)
    bent = bending_density(slope, bend + curvature * -1.0)
    # Half of ∫w'² is the axial shortening. Eq. 2 prints ∂w²/∂x.
    return (slope * slope).integral(), (w * w).integral(), (bend * bend).integral(), bent.integral()


_SHORTENING, _TRANSLATION, _BENDING_SQUARED, _BENT = _beam()


def _coefficients(s: FullSymbols, qm: Expression) -> list[Expression]:
    """c2, c3, c4 of the deflection."""
    l = s.parameter("l")
    return [qm[0] * l, qm[1] * l * l, qm[2] * l * l * l]


def tip(s: FullSymbols) -> tuple[Expression, Expression, Expression]:
    """Tip of the beam: q = w(l) (eq. 3), w'(l) = tan φ (eq. 1) and u_y (eq. 2)."""
    c = _coefficients(s, s.qm)
    l = s.parameter("l")
    u_y = s.qm[3] - 0.5 * l * _SHORTENING.at(c, [0.0])
    return l * (c[0] + c[1] + c[2]), 2.0 * c[0] + 3.0 * c[1] + 4.0 * c[2], u_y


def stretches(s: FullSymbols) -> tuple[Expression, Expression]:
    """λ_{1,1} and λ_{1,2} of the left and right membrane (eqs. 4 to 6)."""
    q, slope, u_y = tip(s)
    cos = 1.0 / ca.sqrt(1.0 + slope * slope)
    place = (q, slope * cos, cos, u_y)
    result = []
    for side, sign in (("left", -1.0), ("right", 1.0)):
        a, b, a0, e_x, e_z, l0 = (s.parameter(f"{side}.{n}") for n in ("a", "b", "a0", "e_x", "e_z", "l0"))
        result.append(elements.length(sign, (a, b - a0, e_z, e_x), s.parameter("l"), place)[0] / l0)
    return result[0], result[1]


def thickness_stretches(s: FullSymbols) -> Expression:
    """λ_{3,i}, shape (2,)."""
    return ca.vertcat(*(elements.thickness_stretch(stretch) for stretch in stretches(s)))


def kinetic_energy(s: FullSymbols) -> Expression:
    """T of eq. 8 [J]."""
    q, _, u_y = tip(s)
    c_dot = _coefficients(s, s.qm_dot)
    l = s.parameter("l")
    q_dot = ca.jtimes(q, s.qm, s.qm_dot)
    u_y_dot = ca.jtimes(u_y, s.qm, s.qm_dot)
    rotation = s.parameter("I") * l * _SHORTENING.at(c_dot, [0.0])
    translation = s.parameter("A") * l**3 * _TRANSLATION.at(c_dot, [0.0])
    return 0.5 * s.parameter("m") * (q_dot**2 + u_y_dot**2) + 0.5 * s.parameter("rho") * (rotation + translation)


def beam_energy(s: FullSymbols) -> Expression:
    """U_s of eq. 9 [J], of a beam whose unloaded curvature may be κ0."""
    l = s.parameter("l")
    bent = _BENT.at(_coefficients(s, s.qm), [l * s.parameter("kappa0")])
    return 0.5 * s.parameter("E") / l * (s.parameter("I") * bent + s.parameter("A") * s.qm[3] ** 2)


def membrane_volume(s: FullSymbols, side: str) -> Expression:
    """V_DE = n A0 d0 [m³]."""
    return volume(*(s.parameter(f"{side}.{name}") for name in ("n", "A0", "d0")))


def elastic_energy(s: FullSymbols) -> Expression:
    """Energy [J] of beam, gravity and both membranes without voltage (eqs. 9 to 11)."""
    energy = beam_energy(s) + s.parameter("m") * s.parameter("g") * tip(s)[2]
    for side, stretch in zip(("left", "right"), stretches(s), strict=True):
        energy = energy + membrane_volume(s, side) * s.parameter(f"{side}.Y") / 6.0 * elements.neo_hooke(stretch)
    return energy


def capacitances(s: FullSymbols) -> Expression:
    """C_i = C0 / λ3² = C0 λ1 [F] (eq. 11, uniaxial), shape (2,)."""
    names = ("n", "eps_r", "beta", "A0", "d0")
    undeformed = [capacitance(*(s.parameter(f"{side}.{name}") for name in names)) for side in ("left", "right")]
    return ca.vertcat(*(c * stretch for c, stretch in zip(undeformed, stretches(s), strict=True)))


def viscous_dissipation(s: FullSymbols) -> Expression:
    """Half the power [W] lost in the beam and the Kelvin-Voigt dampers: their Rayleigh function (eq. 12)."""
    beam = BEAM_DAMPING_FACTOR * s.parameter("eta") * s.parameter("I")
    rayleigh = 0.5 * beam / s.parameter("l") * _BENDING_SQUARED.at(_coefficients(s, s.qm_dot), [0.0])
    lambda3_dot = ca.jtimes(thickness_stretches(s), s.qm, s.qm_dot)
    for i, side in enumerate(("left", "right")):
        rayleigh = rayleigh + 0.5 * membrane_volume(s, side) * s.parameter(f"{side}.eta_v") * lambda3_dot[i] ** 2
    return rayleigh


def internal_rates(s: FullSymbols) -> Expression:
    """ż of both Maxwell strains and of Dahl's friction, shape (3,)."""
    lambda3_dot = ca.jtimes(thickness_stretches(s), s.qm, s.qm_dot)
    rates = [
        elements.maxwell_rate(lambda3_dot[i], s.parameter(f"{side}.Y_MW") / s.parameter(f"{side}.eta_MW"), s.z[i])
        for i, side in enumerate(("left", "right"))
    ]
    return ca.vertcat(*rates, elements.dahl_rate(ca.jtimes(tip(s)[0], s.qm, s.qm_dot), s.z[2], s.parameter("s_c")))


def coupling(s: FullSymbols) -> Expression:
    """Generalised forces [N per unit of z] of the internal states: columns V Y_MW ∂λ_{3,i}/∂q_m and F_c ∂q/∂q_m,
    shape (4, 3) (the creep matrix K̄ of eq. 19, and friction).
    """
    creep = ca.jacobian(thickness_stretches(s), s.qm).T
    columns = [
        membrane_volume(s, side) * s.parameter(f"{side}.Y_MW") * creep[:, i] for i, side in enumerate(("left", "right"))
    ]
    return ca.horzcat(*columns, s.parameter("F_c") * ca.gradient(tip(s)[0], s.qm))


def residual(s: FullSymbols) -> Expression:
    """Euler-Lagrange equations in full (eq. 19), zero along a motion, shape (4,).

    d/dt ∂T/∂q̇_m − ∂T/∂q_m + ∂U/∂q_m + ∂R/∂q̇_m + K̄ z − F ∂q/∂q_m. Eq. 19 leaves out the inertia terms that are
    quadratic in the velocity; they are here, because d/dt is taken of the whole momentum.
    """
    kinetic = kinetic_energy(s)
    momentum = ca.gradient(kinetic, s.qm_dot)
    inertia = (
        ca.jtimes(momentum, s.qm, s.qm_dot) + ca.jtimes(momentum, s.qm_dot, s.qm_ddot) - ca.gradient(kinetic, s.qm)
    )
    co_energy = 0.5 * ca.dot(capacitances(s), s.v_squared)
    static = ca.gradient(elastic_energy(s) - co_energy, s.qm)
    applied = s.force * ca.gradient(tip(s)[0], s.qm)
    return inertia + static + ca.gradient(viscous_dissipation(s), s.qm_dot) + ca.mtimes(coupling(s), s.z) - applied


Kernel = tuple[str, dict[str, Expression], dict[str, Expression]]
"""Docstring, inputs and outputs by their names."""


def kernels(s: FullSymbols) -> dict[str, Kernel]:
    """Everything that is compiled of the full-order joint."""
    return _shape_kernels(s) | _motion_kernels(s)


def _shape_kernels(s: FullSymbols) -> dict[str, Kernel]:
    """Kernels that depend on the shape alone."""
    static = elastic_energy(s) - 0.5 * ca.dot(capacitances(s), s.v_squared)
    gradient = ca.gradient(static, s.qm)
    q, slope, u_y = tip(s)
    values = ca.vertcat(q, ca.atan(slope), u_y, *stretches(s))
    at = {"qm": s.qm, "v_squared": s.v_squared, "p": s.p}
    unloaded = {"qm": s.qm, "p": s.p}
    return {
        "statics": (
            "U − ½ΣC_i v_i² [J], returned; its gradient (4,) and Hessian (4, 4) in q_m.",
            at,
            {"gradient": gradient, "hessian": _symmetric(ca.jacobian(gradient, s.qm)), "energy": static},
        ),
        "static_sensitivity": (
            "Derivative of the static gradient with respect to the parameters, (4, 41).",
            at,
            {"gradient_p": ca.jacobian(gradient, s.p)},
        ),
        "tip": (
            "q [m], φ [rad], u_y [m], λ1, λ2 of left and right (5,) and their derivatives in q_m (5, 4).",
            unloaded,
            {"values": values, "jacobian": ca.jacobian(values, s.qm)},
        ),
        "capacitance": (
            "C_1, C_2 [F] (2,) and ∂C_i/∂q_m (2, 4).",
            unloaded,
            {"values": capacitances(s), "jacobian": ca.jacobian(capacitances(s), s.qm)},
        ),
        "dissipation": (
            "Damping matrix D (4, 4), coupling of z to the forces (4, 3), ∂λ_{3,i}/∂q_m (2, 4).",
            unloaded,
            {
                "damping": _symmetric(ca.hessian(viscous_dissipation(s), s.qm_dot)[0]),
                "coupling": coupling(s),
                "thickness_jacobian": ca.jacobian(thickness_stretches(s), s.qm),
            },
        ),
    }


def _motion_kernels(s: FullSymbols) -> dict[str, Kernel]:
    """The equations of motion M q̈_m = τ and their derivatives."""
    moving = {"qm": s.qm, "qm_dot": s.qm_dot, "z": s.z, "v_squared": s.v_squared, "force": s.force, "p": s.p}
    packed = {"x": ca.vertcat(s.qm, s.qm_dot, s.z), "v_squared": s.v_squared, "force": s.force, "p": s.p}
    force = residual(s)
    mass = _symmetric(ca.jacobian(force, s.qm_ddot))
    tau = -ca.substitute(force, s.qm_ddot, ca.SX.zeros(4))
    rates = internal_rates(s)
    blocks = [ca.jacobian(force, along) for along in (s.qm, s.qm_dot, s.z)]
    blocks += [ca.jacobian(rates, along) for along in (s.qm, s.qm_dot)]
    blocks += [ca.diag(ca.jacobian(rates, s.z)), ca.jacobian(force, s.v_squared)]
    return {
        "dynamics": (
            "Mass matrix M (4, 4), right-hand side τ (4,) of M q̈_m = τ, and ż (3,).",
            moving,
            {"mass": mass, "tau": tau, "z_dot": rates},
        ),
        "motion": (
            "As `dynamics`, of x = [q_m, q̇_m, z] (11,): M, and q̇_m, τ, ż in `right` (11,).",
            packed,
            {"mass": mass, "right": ca.vertcat(s.qm_dot, tau, rates)},
        ),
        "motion_slopes": (
            "Derivatives of r = M q̈_m − τ and ż, q̈_m = `a` (4,): r_q, r_v, r_z, z_q, z_v, z_z, and r_s by v_i² (79,).",
            packed | {"a": s.qm_ddot},
            {"slopes": ca.vertcat(*(ca.vec(block.T) for block in blocks))},
        ),
    }


def _symmetric(matrix: Expression) -> Expression:
    """A symmetric matrix whose lower half is taken from the upper, so that only the upper is computed."""
    return ca.triu2symm(ca.triu(matrix))


def cubics(pieces: Any, s: Any) -> Expression:
    """Values of seven curves at s [m] past a breakpoint; `pieces` (28,): ascending powers, four rows of seven."""
    rows = [pieces[7 * i : 7 * (i + 1)] for i in range(4)]
    return ((rows[3] * s + rows[2]) * s + rows[1]) * s + rows[0]


def reduced_rates(pieces: Any, s: Any, q_dot: Any, e: Any, v_squared: Any, load: Any, gain: Any, rate: Any) -> Any:
    """q̈ [m/s²] and ė (2,) [1/s] of m q̈ + ½ m' q̇² + d q̇ + f + Σ k̄_i e_i = ½ Σ C_i' v_i² + load.

    Parameters
    ----------
    pieces, s : expression
        See `cubics`; the curves over q are m_q, d, f, λ_{3,1}, λ_{3,2}, C_1, C_2.
    q_dot : expression
        q̇ [m/s].
    e : expression, shape (2,)
        Maxwell strains.
    v_squared : expression, shape (2,)
        [V²].
    load : expression
        Other forces [N].
    gain, rate : expression, shape (2,)
        V_DE Y_MW [J] and Y_MW/η_MW [1/s].
    """
    curves = cubics(pieces, s)
    slopes = ca.jacobian(curves, s)
    creep = slopes[3:5]
    force = load + 0.5 * ca.dot(slopes[5:], v_squared) - ca.dot(gain * creep, e)
    force -= curves[1] * q_dot + curves[2] + 0.5 * slopes[0] * q_dot**2
    strains = [elements.maxwell_rate(creep[i] * q_dot, rate[i], e[i]) for i in range(2)]
    return ca.vertcat(force / curves[0], *strains)


def reduced_kernels() -> dict[str, elements.Term]:
    """Terms of the reduced joint."""
    return {
        "CUBICS": elements.term(cubics, "curves", "s", pieces=28),
        "REDUCED_MOTION": elements.term(reduced_rates, "rates", pieces=28, e=2, v_squared=2, gain=2, rate=2),
    }
