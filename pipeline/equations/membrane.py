"""Laws of one dielectric-elastomer membrane and of the frame that stretches it."""

from typing import Any

import casadi as ca

Expression = Any


def length(
    sign: float, a: Any, c: Any, e_z: Any, e_x: Any, l: Any, q: Any, sin: Any, cos: Any, u_y: Any
) -> tuple[Expression, Expression, Expression]:
    """Length [m] between the two mounts (eqs. 4, 5), `sign` −1 left and +1 right, and its components x, y.

    c = b − a0. The signs of x_i, y_i and a0 cos φ as printed in eq. 5 are no rigid frame with eq. 4. With the signs
    used here λ = 1.43 at b = 23 mm (the text: strains below 50 %) and the pre-strain grows as b shrinks (§3.3.3);
    as printed λ = 2.09 and it shrinks.
    """
    x = -sign * (a * cos - e_z) + c * sin - q
    y = e_x - l - u_y + c * cos + sign * a * sin
    return ca.sqrt(x * x + y * y), x, y


def thickness_stretch(stretch: Any) -> Expression:
    """λ3 = λ^(−1/2): uniaxial and incompressible (eq. 6)."""
    return 1.0 / ca.sqrt(stretch)


def thickness_slope(thickness: Any) -> Expression:
    """∂λ3/∂λ = −½ λ3³."""
    return -0.5 * thickness * thickness * thickness


def neo_hooke(stretch: Any) -> Expression:
    """λ² + 2/λ − 3; times V Y / 6 it is the energy (eq. 11).

    Eq. 11 prints λ² + 1/λ² − 2, the pure-shear state; the uniaxial state of eq. 6 gives this. As printed there is no
    z_b,min inside 0 to 10 mm.
    """
    return stretch * stretch + 2.0 / stretch - 3.0


def neo_hooke_slope(stretch: Any, inverse: Any) -> Expression:
    """Its derivative 2λ − 2/λ², with `inverse` = 1/λ."""
    return 2.0 * stretch - 2.0 * inverse * inverse


def power(slope: Any, excess: Any, reference: float) -> Expression:
    """(λ/reference)^n to second order in the `excess` λ − reference, by its `slope` n/reference there.

    Capacitances go as λ in the paper and as λ² if the film's sides are clamped; strains as λ3 or as Hencky's ln λ.
    """
    return 1.0 + (slope + 0.5 * slope * (slope - 1.0 / reference) * excess) * excess
