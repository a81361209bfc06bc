"""Equations of the beam: density of its energy and of its axial shortening along x/l, and integrals over it.

`slope` is w' and `bend` l w'' at one place, or with x/l as a variable of `Powers`.
"""

import math
from fractions import Fraction
from typing import Any

import casadi as ca
import numpy as np

Expression = Any
"""A scalar or matrix of CasADi symbols (CasADi ships no types)."""

_SHAPES = ((0, 0, 3, -2), (0, 0, -1, 1), (0, 0, 1, -2, 1))
"""Coefficients of h1 = 3ξ² − 2ξ³, h2 = ξ³ − ξ² and h3 = ξ²(1 − ξ)², ascending."""


def bending_density(slope: Any, bend: Any, steepening: Any = 1.0) -> Any:
    """w''² (1 + s w'²) of eq. 9 (s = 1); half of it, times EI, is the energy.

    Eq. 9 prints ∫EI w''²(1 + w'²); without the ½ the beam never buckles for any b in 20 to 30 mm.
    """
    return bend * bend * (slope * slope * steepening + 1.0)


def _derived(order: int) -> list[list[int]]:
    """Coefficients of the derivatives of `_SHAPES`."""
    shapes = [list(shape) for shape in _SHAPES]
    for _ in range(order):
        shapes = [[k * c for k, c in enumerate(shape)][1:] for shape in shapes]
    return shapes


def products(order: int) -> tuple[tuple[float, ...], ...]:
    """∫ hᵢ⁽ⁿ⁾ hⱼ⁽ⁿ⁾ dξ over the beam, (3, 3), for derivatives of this order n; exact to the last bit."""

    def integral(first: list[int], second: list[int]) -> float:
        """Integral of the product of two polynomials over [0, 1]."""
        return float(sum(Fraction(a * b, i + j + 1) for i, a in enumerate(first) for j, b in enumerate(second)))

    derived = _derived(order)
    return tuple(tuple(integral(first, second) for second in derived) for first in derived)


(STIFFNESS_QQ, STIFFNESS_QT, _), (_, STIFFNESS_TT, _), (_, _, STIFFNESS_BB) = products(2)
"""∫ h_i'' h_j'' dξ; the interior shape mode is orthogonal to the other two."""


def shapes() -> tuple[Any, Any, Any]:
    """Slopes and bends, (5, 3) each, of h1, h2, h3, and the weights (5,).

    At Gauss-Legendre points on [0, 1]; five are exact but for the last of ten powers in w''² w'².
    """
    points, weights = np.polynomial.legendre.leggauss(5)
    at = [[np.polynomial.polynomial.polyval(0.5 * (points + 1.0), h) for h in _derived(order)] for order in (1, 2)]
    return np.stack(at[0], 1), np.stack(at[1], 1), 0.5 * weights


class Powers:
    """A polynomial in several variables by its powers, with numbers as coefficients.

    An integral over the beam by Gauss points becomes one number for each power, whatever the number of points.
    """

    def __init__(self, terms: dict[tuple[int, ...], float]) -> None:
        self.terms = terms

    @staticmethod
    def variables(count: int) -> list["Powers"]:
        """Each variable as a polynomial."""
        return [Powers({tuple(int(i == j) for j in range(count)): 1.0}) for i in range(count)]

    def __add__(self, other: "Powers | float") -> "Powers":
        total = dict(self.terms)
        for powers, value in _terms(other, self).items():
            total[powers] = total.get(powers, 0.0) + value
        return Powers(total)

    def __mul__(self, other: "Powers | float") -> "Powers":
        product: dict[tuple[int, ...], float] = {}
        for first, a in self.terms.items():
            for second, b in _terms(other, self).items():
                powers = tuple(i + j for i, j in zip(first, second, strict=True))
                product[powers] = product.get(powers, 0.0) + a * b
        return Powers(product)

    __radd__ = __add__

    def derivative(self, variable: int) -> "Powers":
        """The derivative with respect to one variable."""
        falling = [(powers, value) for powers, value in self.terms.items() if powers[variable] > 0]
        return Powers({(*p[:variable], p[variable] - 1, *p[variable + 1 :]): p[variable] * v for p, v in falling})

    def integral(self) -> "Powers":
        """The integral over the last variable from 0 to 1; the result is free of it."""
        total: dict[tuple[int, ...], float] = {}
        for (*others, power), value in sorted(self.terms.items(), key=lambda term: term[0][-1]):
            total[tuple(others)] = total.get(tuple(others), 0.0) + value * (1.0 / (power + 1))
        return Powers(total)

    def at(self, moving: list[Expression], constant: list[Expression]) -> Expression:
        """The value for expressions: the last variables are `constant` and gathered into one factor of each power."""
        factors: dict[tuple[int, ...], Expression] = {}
        largest = max(map(abs, self.terms.values()), default=0.0)
        for powers, value in sorted(self.terms.items()):
            if abs(value) > 1e-13 * largest:  # the rest is rounding of an integral that vanishes
                factor = value * _product(powers[len(moving) :], constant)
                lead = powers[: len(moving)]
                factors[lead] = factors[lead] + factor if lead in factors else factor
        return sum((factor * _product(powers, moving) for powers, factor in factors.items()), ca.SX(0))


def _terms(value: "Powers | float", like: Powers) -> dict[tuple[int, ...], float]:
    if isinstance(value, Powers):
        return value.terms
    return {tuple(0 for _ in next(iter(like.terms))): float(value)}


def _product(powers: tuple[int, ...], values: list[Expression]) -> Expression:
    return math.prod((value for value, power in zip(values, powers, strict=True) for _ in range(power)), start=ca.SX(1))
