"""Equations of the elements of joints: Maxwell branch, stop operator, Dahl friction, creep, lag, membrane, bell.

A new element is one function here and one line where a joint lists its elements. The membrane's equations are those of
one dielectric elastomer and of the frame that stretches it.
"""

from collections.abc import Callable
from inspect import signature
from typing import Any

import casadi as ca

Expression = Any
Term = tuple[dict[str, Expression], dict[str, Expression]]
"""Inputs and outputs by name."""


def term(function: Callable[..., Expression], output: str = "value", *along: str, **sizes: int) -> Term:
    """A function as a term: its parameters as inputs, its value, and the exact slopes along some of them.

    Parameters
    ----------
    function : callable
        Of expressions.
    output : str
        Name of its value.
    along : str
        Parameters of the slopes; without any there are none.
    sizes : int
        Lengths of parameters that are no numbers.
    """
    inputs = {name: ca.SX.sym(name, sizes.get(name, 1)) for name in signature(function).parameters}
    outputs = {output: function(**inputs)}
    if along:
        outputs["slopes"] = ca.jacobian(outputs[output], ca.vertcat(*(inputs[name] for name in along)))
    return inputs, outputs


def maxwell_rate(strain_rate: Any, relaxation: Any, strain: Any) -> Expression:
    """ė of the spring of a Maxwell branch (eq. 19): what is applied less what the damper takes, r = Y/η [1/s]."""
    return strain_rate - relaxation * strain


def stop_operator(z: Any, play: Any, travel: Any) -> Expression:
    """Share of its capacity in [−1, 1] after a move `play` [m].

    Generalised Maxwell slip: F. Al-Bender, V. Lampaert and J. Swevers, IEEE Trans. Autom. Control 50 (2005) 1883,
    doi:10.1109/TAC.2005.858676.
    """
    return ca.fmin(1.0, ca.fmax(-1.0, _unbounded(z, play, travel)))


def _unbounded(z: Any, play: Any, travel: Any) -> Expression:
    return z + play / travel


def stop_rate(z: Any, speed: Any, travel: Any) -> Expression:
    """ż [1/s] of the stop operator: it follows the speed [m/s] but does not leave [−1, 1]."""
    held = ca.logic_or(ca.logic_and(z >= 1.0, speed > 0.0), ca.logic_and(z <= -1.0, speed < 0.0))
    return ca.if_else(held, 0.0, speed / travel)


def dahl_rate(p: Any, state: Any, length: Any) -> Expression:
    """ζ̇ = (q̇ − |q̇| ζ)/s_c: P. R. Dahl, "A solid friction model", 1968 (doi:10.21236/ada041920)."""
    return (p - ca.fabs(p) * state) / length


def dahl_move(state: Any, travel: Any, length: Any) -> Expression:
    """State of Dahl's friction after a monotonous `travel`, exactly: it goes to ±1 exponentially in the distance."""
    side = ca.if_else(travel >= 0.0, 1.0, -1.0)
    return side + (state - side) * ca.exp(-side * travel / length)


def creep_rate(rate: Any, displacement: Any, crept: Any) -> Expression:
    """Rate [m/s] of a creep element that follows the displacement with its `rate` [1/s]."""
    return rate * (displacement - crept)


def softening_rate(rate: Any, softened: Any) -> Expression:
    """Rate [1/s] of the share D of a rubber's softening that has come: Ḋ = rate (1 − D).

    Rubber softens in its first cycles: L. Mullins, Rubber Chem. Technol. 42 (1969) 339, doi:10.5254/1.3539210. Under
    steady excitation that is a matter of time, as is its warming.
    """
    return rate * (1.0 - softened)


def lag_rate(value: Any, lagged: Any, lag: Any) -> Expression:
    """ż = (q̇ − z)/T (eq. 37)."""
    return (value - lagged) / lag


def kernels() -> dict[str, Term]:
    """Terms that runs call by themselves, with their slopes along the inputs; an element at its stop counts as held."""
    z, play, travel = (ca.SX.sym(name) for name in ("z", "play", "travel"))
    free = _unbounded(z, play, travel)
    slopes = ca.if_else(ca.fabs(free) < 1.0, ca.jacobian(free, ca.vertcat(z, play, travel)), 0.0)
    outputs = {"value": stop_operator(z, play, travel), "slopes": slopes}
    return {"STOP_OPERATOR": ({"z": z, "play": play, "travel": travel}, outputs)}


Four = tuple[Expression, Expression, Expression, Expression]


def length(sign: float, mounts: Four, l: Any, tip: Four) -> tuple[Expression, Expression, Expression]:
    """Length [m] between the two mounts (eqs. 4, 5) and its components x, y.

    Parameters
    ----------
    sign : float
        −1 for the left membrane, +1 for the right one.
    mounts : (a, c, e_z, e_x)
        Places of the membrane's mounts [m] (figure 2); c = b − a0.
    l : expression
        Length of the beam [m].
    tip : (q, sin φ, cos φ, u_y)
        Displacement [m] of the beam's tip, its rotation, and its axial displacement [m].

    Notes
    -----
    The signs of x_i, y_i and a0 cos φ as printed in eq. 5 are no rigid frame with eq. 4. With the signs
    used here λ = 1.43 at b = 23 mm (the text: strains below 50 %) and the pre-strain grows as b shrinks (§3.3.3);
    as printed λ = 2.09 and it shrinks.
    """
    a, c, e_z, e_x = mounts
    q, sin, cos, u_y = tip
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
    """Derivative 2λ − 2/λ², with `inverse` = 1/λ."""
    return 2.0 * stretch - 2.0 * inverse * inverse


def power(slope: Any, excess: Any, reference: float) -> Expression:
    """(λ/reference)^n to second order in the `excess` λ − reference, by its `slope` n/reference there.

    Capacitances go as λ in the paper and as λ² if the film's sides are clamped; strains as λ3 or as Hencky's ln λ.
    """
    return 1.0 + (slope + 0.5 * slope * (slope - 1.0 / reference) * excess) * excess


def gaussian(square: Any) -> Any:
    """φ of ((q − ξ)/σ)², a bell about the centre ξ (eq. 38); eq. 35 prints it without the minus sign that it needs.

    It is the exponential of a multiple of the square, so bells of equidistant centres follow from each other. With
    r = (q − ξ)/σ and s = Δξ/σ, the next one is φ((r − s)²) = φ(r²) φ(s² − 2 r s), and that ratio shrinks by φ(2 s²)
    from one centre to the next.
    """
    return ca.exp(-0.5 * square)


def bell_kernels() -> dict[str, Term]:
    """The Gaussian, and bells of a basis (first centre, distance Δξ, width σ): the first at q, and from one the next.

    A bell is r, φ, the ratio of the next one to it, and by what that ratio shrinks. `slope` is φ' along q, and
    `shape` φ, φ' and φ'' of the first bell.
    """
    q = ca.SX.sym("q")
    basis = ca.SX.sym("basis", 3)
    bell = ca.SX.sym("bell", 4)
    square = ca.SX.sym("square")
    r, value, ratio, shrink = ca.vertsplit(bell)
    first = (q - basis[0]) / basis[2]
    step = basis[1] / basis[2]
    at_first = gaussian(first * first)
    first_bell = ca.vertcat(first, at_first, gaussian(step * (step - 2.0 * first)), gaussian(2.0 * step * step))
    exponent = ca.substitute(ca.gradient(gaussian(square), square), square, 0.0)
    by_q = ca.gradient(at_first, q)
    return {
        "GAUSSIAN": term(gaussian, "found"),
        "BELL_SHAPE": ({"q": q, "basis": basis}, {"shape": ca.vertcat(at_first, by_q, ca.gradient(by_q, q))}),
        "FIRST_BELL": ({"q": q, "basis": basis}, {"bell": first_bell}),
        "NEXT_BELL": (
            {"bell": bell, "basis": basis},
            {
                "slope": 2.0 * exponent * r / basis[2] * value,
                "next": ca.vertcat(r - step, value * ratio, ratio * shrink, shrink),
            },
        ),
    }
