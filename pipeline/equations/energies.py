"""Energies of the joint, written once; everything else is derived from them by automatic differentiation.

This module needs CasADi and is used only by `pipeline.codegen.generate_kernels`; the program itself runs the
generated kernels. Equation numbers are the paper's; where its print is wrong, the correction and its reason
stand beside the expression.

Symbols: ``qm`` = [q2, q3, q4, u0] Ritz coordinates [1/m, 1/m², 1/m³, m]; ``z`` = [e1, e2, ζ] internal states:
Maxwell strains [1] and friction state [1]; ``v_squared`` = [v1², v2²] [V²]; ``p`` the parameters in the order of
`pipeline.joint.parameters.VECTOR_NAMES`.
"""

from dataclasses import dataclass
from typing import Any

import casadi as ca

from pipeline.joint.parameters import VACUUM_PERMITTIVITY, VECTOR_NAMES

Expression = Any
"""A scalar or matrix of CasADi symbols (CasADi ships no types)."""

BEAM_DAMPING_FACTOR = 2.0
"""The 2 of 2ηI in eq. 12; η is a fitted number, so another factor only rescales it."""


@dataclass(frozen=True)
class Symbols:
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


def symbols() -> Symbols:
    """Fresh symbols."""
    names = {"qm": 4, "qm_dot": 4, "qm_ddot": 4, "z": 3, "v_squared": 2, "force": 1, "p": len(VECTOR_NAMES)}
    return Symbols(**{name: ca.SX.sym(name, size) for name, size in names.items()})


class Polynomial:
    """A polynomial in s = x/l on [0, 1] with symbolic coefficients (ascending): integrals over the beam are exact."""

    def __init__(self, coefficients: list[Expression]) -> None:
        self.coefficients = coefficients

    def derivative(self) -> "Polynomial":
        """The derivative with respect to s."""
        return Polynomial([k * c for k, c in enumerate(self.coefficients)][1:])

    def __add__(self, constant: Expression) -> "Polynomial":
        return Polynomial([self.coefficients[0] + constant, *self.coefficients[1:]])

    def __mul__(self, other: "Polynomial") -> "Polynomial":
        product = [ca.SX(0)] * (len(self.coefficients) + len(other.coefficients) - 1)
        for i, left in enumerate(self.coefficients):
            for j, right in enumerate(other.coefficients):
                product[i + j] = product[i + j] + left * right
        return Polynomial(product)

    def integral(self) -> Expression:
        """The integral over [0, 1]."""
        return sum(coefficient / (k + 1) for k, coefficient in enumerate(self.coefficients))

    def at_tip(self) -> Expression:
        """The value at s = 1."""
        return sum(self.coefficients)


def deflection(s: Symbols, qm: Expression) -> Polynomial:
    """w/l as a polynomial of x/l; w(x) = q2 x² + q3 x³ + q4 x⁴ (eq. 13).

    Then its derivative is w' and its second derivative l w''.
    """
    l = s.parameter("l")
    return Polynomial([ca.SX(0), ca.SX(0), qm[0] * l, qm[1] * l * l, qm[2] * l * l * l])


def tip(s: Symbols) -> tuple[Expression, Expression, Expression]:
    """Tip of the beam: q = w(l) (eq. 3), w'(l) = tan φ (eq. 1) and u_y (eq. 2)."""
    w, l = deflection(s, s.qm), s.parameter("l")
    slope = w.derivative()
    # Eq. 2 prints ∂w²/∂x; axial shortening is ½∫(∂w/∂x)² dx.
    u_y = s.qm[3] - 0.5 * l * (slope * slope).integral()
    return l * w.at_tip(), slope.at_tip(), u_y


def stretches(s: Symbols) -> tuple[Expression, Expression]:
    """λ_{1,1} and λ_{1,2} of the left and right membrane (eqs. 4 to 6).

    The signs of x_i, y_i and a0 cos φ as printed in eq. 5 are no rigid frame with eq. 4. With the signs used
    here λ = 1.43 at b = 23 mm (the text: strains below 50 %) and the pre-strain grows as b shrinks (§3.3.3);
    as printed λ = 2.09 and it shrinks.
    """
    q, slope, u_y = tip(s)
    cos = 1.0 / ca.sqrt(1.0 + slope * slope)
    sin = slope * cos
    result = []
    for side, sign in (("left", -1.0), ("right", 1.0)):
        a, b, a0, e_x, e_z, l0 = (s.parameter(f"{side}.{n}") for n in ("a", "b", "a0", "e_x", "e_z", "l0"))
        x = a * cos - sign * b * sin
        y = b * cos + sign * a * sin
        horizontal = sign * e_z - q - a0 * sin - sign * x
        vertical = e_x - s.parameter("l") - u_y - a0 * cos + y
        result.append(ca.sqrt(horizontal * horizontal + vertical * vertical) / l0)
    return result[0], result[1]


def thickness_stretches(s: Symbols) -> Expression:
    """λ_{3,i} = λ_{1,i}^(−1/2), uniaxial and incompressible (eq. 6), shape (2,)."""
    return ca.vertcat(*(1.0 / ca.sqrt(stretch) for stretch in stretches(s)))


def kinetic_energy(s: Symbols) -> Expression:
    """T of eq. 8 [J]."""
    q, _, u_y = tip(s)
    w_dot = deflection(s, s.qm_dot)
    slope_dot = w_dot.derivative()
    l, rho = s.parameter("l"), s.parameter("rho")
    q_dot, u_y_dot = ca.jtimes(q, s.qm, s.qm_dot), ca.jtimes(u_y, s.qm, s.qm_dot)
    rotation = s.parameter("I") * l * (slope_dot * slope_dot).integral()
    translation = s.parameter("A") * l**3 * (w_dot * w_dot).integral()
    return 0.5 * s.parameter("m") * (q_dot**2 + u_y_dot**2) + 0.5 * rho * (rotation + translation)


def beam_energy(s: Symbols) -> Expression:
    """U_s of eq. 9 [J], of a beam whose unloaded curvature may be κ0.

    Eq. 9 prints ∫EI w''²(1 + w'²); without the ½ the beam never buckles for any b in 20 to 30 mm.
    """
    slope, l = deflection(s, s.qm).derivative(), s.parameter("l")
    bending = slope.derivative() + (-l * s.parameter("kappa0"))
    bent = (bending * bending * (slope * slope + 1.0)).integral()
    stiffness = 0.5 * s.parameter("E") / l
    return stiffness * (s.parameter("I") * bent + s.parameter("A") * s.qm[3] ** 2)


def membrane_volume(s: Symbols, side: str) -> Expression:
    """V_DE = n A0 d0 [m³]."""
    return s.parameter(f"{side}.n") * s.parameter(f"{side}.A0") * s.parameter(f"{side}.d0")


def elastic_energy(s: Symbols) -> Expression:
    """Energy [J] of beam, gravity and both membranes without voltage (eqs. 9 to 11).

    Eq. 11 prints λ² + 1/λ² − 2, the pure-shear state; the uniaxial state of eq. 6 gives λ² + 2/λ − 3. As
    printed there is no z_b,min inside 0 to 10 mm.
    """
    energy = beam_energy(s) + s.parameter("m") * s.parameter("g") * tip(s)[2]
    for side, stretch in zip(("left", "right"), stretches(s), strict=True):
        neo_hooke = s.parameter(f"{side}.Y") / 6.0 * (stretch * stretch + 2.0 / stretch - 3.0)
        energy = energy + membrane_volume(s, side) * neo_hooke
    return energy


def capacitances(s: Symbols) -> Expression:
    """C_i = C0 / λ3² = C0 λ1 [F] (eq. 11, uniaxial), with C0 = n ε0 εr β A0 / d0, shape (2,)."""
    values = []
    for side, stretch in zip(("left", "right"), stretches(s), strict=True):
        n, eps_r, beta, area, d0 = (s.parameter(f"{side}.{k}") for k in ("n", "eps_r", "beta", "A0", "d0"))
        values.append(n * VACUUM_PERMITTIVITY * eps_r * beta * area / d0 * stretch)
    return ca.vertcat(*values)


def maxwell_energy(s: Symbols) -> Expression:
    """½ V_DE Y_MW e_i² of both Maxwell springs [J]."""
    return 0.5 * sum(
        membrane_volume(s, side) * s.parameter(f"{side}.Y_MW") * s.z[i] ** 2 for i, side in enumerate(("left", "right"))
    )


def viscous_dissipation(s: Symbols) -> Expression:
    """Half the power [W] lost in the beam and the Kelvin-Voigt dampers: their Rayleigh function (eq. 12)."""
    bending_dot = deflection(s, s.qm_dot).derivative().derivative()
    beam = BEAM_DAMPING_FACTOR * s.parameter("eta") * s.parameter("I")
    rayleigh = 0.5 * beam / s.parameter("l") * (bending_dot * bending_dot).integral()
    lambda3_dot = ca.jtimes(thickness_stretches(s), s.qm, s.qm_dot)
    for i, side in enumerate(("left", "right")):
        rayleigh = rayleigh + 0.5 * membrane_volume(s, side) * s.parameter(f"{side}.eta_v") * lambda3_dot[i] ** 2
    return rayleigh


def internal_rates(s: Symbols) -> Expression:
    """ż: ė_i = λ̇_{3,i} − (Y_MW/η_MW) e_i (eq. 19) and Dahl's friction ζ̇ = (q̇ − |q̇| ζ)/s_c, shape (3,).

    P. R. Dahl, "A solid friction model", 1968: the one-state member of the Maxwell-slip family.
    """
    lambda3_dot = ca.jtimes(thickness_stretches(s), s.qm, s.qm_dot)
    q_dot = ca.jtimes(tip(s)[0], s.qm, s.qm_dot)
    rates = [
        lambda3_dot[i] - s.parameter(f"{side}.Y_MW") / s.parameter(f"{side}.eta_MW") * s.z[i]
        for i, side in enumerate(("left", "right"))
    ]
    return ca.vertcat(*rates, (q_dot - ca.fabs(q_dot) * s.z[2]) / s.parameter("s_c"))


def coupling(s: Symbols) -> Expression:
    """Generalised forces [N per unit of z] of the internal states: columns V Y_MW ∂λ_{3,i}/∂q_m and F_c ∂q/∂q_m,
    shape (4, 3) (the creep matrix K̄ of eq. 19, and friction).
    """
    creep = ca.jacobian(thickness_stretches(s), s.qm).T
    columns = [
        membrane_volume(s, side) * s.parameter(f"{side}.Y_MW") * creep[:, i] for i, side in enumerate(("left", "right"))
    ]
    return ca.horzcat(*columns, s.parameter("F_c") * ca.gradient(tip(s)[0], s.qm))


def residual(s: Symbols) -> Expression:
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


def energy_flow(s: Symbols) -> list[Expression]:
    """T, U, Maxwell, friction energy [J]; rate of work of voltages and force [W]; dissipated power [W].

    Along a motion d/dt (sum of the first four) = work rate − dissipated power. The voltages are imposed, so the
    work that the field does on the structure is ½ Ċ_i v_i².
    """
    q_dot = ca.jtimes(tip(s)[0], s.qm, s.qm_dot)
    work = 0.5 * ca.dot(ca.jtimes(capacitances(s), s.qm, s.qm_dot), s.v_squared) + s.force * q_dot
    dissipated = 2.0 * viscous_dissipation(s) + s.parameter("F_c") * ca.fabs(q_dot) * s.z[2] ** 2
    for i, side in enumerate(("left", "right")):
        rate = s.parameter(f"{side}.Y_MW") ** 2 / s.parameter(f"{side}.eta_MW")
        dissipated = dissipated + membrane_volume(s, side) * rate * s.z[i] ** 2
    friction = 0.5 * s.parameter("F_c") * s.parameter("s_c") * s.z[2] ** 2
    return [kinetic_energy(s), elastic_energy(s), maxwell_energy(s), friction, work, dissipated]
