"""Radial basis functions: their form, those that `pipeline.model_list` names, and the Gaussian of eq. 38.

Eq. 35 prints the Gaussian without the minus sign that a bell needs. It is the exponential of a multiple of the square,
so bells of equidistant centres follow from each other. With r = (q − ξ)/σ and s = Δξ/σ, the next one is
φ((r − s)²) = φ(r²) φ(s² − 2 r s), and that ratio shrinks by φ(2 s²) from one centre to the next.
"""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import casadi as ca

from pipeline.model_list import BASIS_FUNCTIONS


@dataclass(frozen=True)
class BasisFunction:
    """A bell about a centre ξ.

    Attributes
    ----------
    law : callable
        ((q − ξ)/σ)² → φ in CasADi; 1 at the centre.
    reach : float
        |q − ξ|/σ from which φ may be left out of a sum; infinite where it has no end.
    """

    law: Callable[[Any], Any]
    reach: float


def basis_functions() -> dict[str, BasisFunction]:
    """The basis functions by name."""
    places = {name: place.split(":") for name, place in BASIS_FUNCTIONS}
    return {name: getattr(importlib.import_module(module), law) for name, (module, law) in places.items()}


GAUSSIAN = BasisFunction(lambda square: ca.exp(-0.5 * square), 8.6)  # exp(−37) is below rounding


def kernels() -> dict[str, tuple[dict[str, ca.SX], dict[str, ca.SX]]]:
    """Bells of a basis (first centre, distance Δξ, width σ): the first one at q, and from one bell the next.

    A bell is r, φ, the ratio of the next one to it, and by what that ratio shrinks. `slope` is φ' along q, and
    `shape` φ, φ' and φ'' of the first bell.
    """
    q, basis, bell, square = ca.SX.sym("q"), ca.SX.sym("basis", 3), ca.SX.sym("bell", 4), ca.SX.sym("square")
    (r, value, ratio, shrink), law = ca.vertsplit(bell), GAUSSIAN.law
    first, step, width = (q - basis[0]) / basis[2], basis[1] / basis[2], basis[2]
    at_first = law(first * first)
    first_bell = ca.vertcat(first, at_first, law(step * (step - 2.0 * first)), law(2.0 * step * step))
    exponent = ca.substitute(ca.gradient(law(square), square), square, 0.0)
    by_q = ca.gradient(at_first, q)
    return {
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
