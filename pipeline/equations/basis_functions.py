"""The Gaussian of eq. 38, a bell about a centre ξ.

Eq. 35 prints it without the minus sign that a bell needs. It is the exponential of a multiple of the square, so bells
of equidistant centres follow from each other. With r = (q − ξ)/σ and s = Δξ/σ, the next one is
φ((r − s)²) = φ(r²) φ(s² − 2 r s), and that ratio shrinks by φ(2 s²) from one centre to the next.
"""

from typing import Any

import casadi as ca


def gaussian(square: Any) -> Any:
    """φ of ((q − ξ)/σ)² in CasADi; 1 at the centre."""
    return ca.exp(-0.5 * square)


def kernels() -> dict[str, tuple[dict[str, ca.SX], dict[str, ca.SX]]]:
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
    width = basis[2]
    at_first = gaussian(first * first)
    first_bell = ca.vertcat(first, at_first, gaussian(step * (step - 2.0 * first)), gaussian(2.0 * step * step))
    exponent = ca.substitute(ca.gradient(gaussian(square), square), square, 0.0)
    by_q = ca.gradient(at_first, q)
    return {
        "GAUSSIAN": ({"square": square}, {"found": gaussian(square)}),
        "BELL_SHAPE": ({"q": q, "basis": basis}, {"shape": ca.vertcat(at_first, by_q, ca.gradient(by_q, q))}),
        "FIRST_BELL": ({"q": q, "basis": basis}, {"bell": first_bell}),
        "NEXT_BELL": (
            {"bell": bell, "basis": basis},
            {
                "slope": 2.0 * exponent * r / width * value,
                "next": ca.vertcat(r - step, value * ratio, ratio * shrink, shrink),
            },
        ),
    }
