"""The condensed joint's beam: the energy of its shape (Q, τ, β), and how far it shortens.

Both have terms which no slender beam of uniform section has: a printed beam is uneven, its clamps give way, and a chain
of links is no beam at all.
"""

from dataclasses import dataclass
from itertools import combinations_with_replacement

import casadi as ca

from pipeline.equations import beam
from pipeline.equations.beam import Expression
from pipeline.equations.condensed_symbols import SHORTENINGS, Symbols

_ORDER = "qtb"
"""Letters of Q, τ and β in the names of constants."""
_FAR = (0.35, 0.6, 1.6)
"""Tip displacement over length, tip slope and interior shape up to which added terms grow; joints reach 0.28, 0.5 and
1.2. From there on they level off, and are constant from one and a half times that on."""


def beam_gradient(s: Symbols) -> list[Expression]:
    """∂U_s/∂(Q, τ, β) [J] of eq. 9 (as corrected) and of the added terms.

    The beam's own slope is slope_by_q Q + slope_by_tau τ + slope_by_beta β, because clamps and a printed beam of uneven
    section make another stiffness than 12, −6, 4 and 0.8; its shortening is another, too (`raised`).
    """
    k = s.constant
    shape = [s.x[0] / k("l"), s.x[2], s.x[4]]
    slope = k("slope_by_q") * shape[0] + k("slope_by_tau") * shape[1] + k("slope_by_beta") * shape[2]
    moving, constant = [shape[0], slope, shape[2]], [k(name) for name in ("curvature", "steepening", "stiffening")]
    energy = _slender_energy()
    by_q, by_slope, by_b = (energy.derivative(i).at(moving, constant) for i in range(3))
    slender = (by_q + k("slope_by_q") * by_slope, k("slope_by_tau") * by_slope, by_b + k("slope_by_beta") * by_slope)
    added = _hardening_gradient(s, _near(s))
    return [k("bending") * (one + more) for one, more in zip(slender, added, strict=True)]


def shortening(s: Symbols) -> tuple[Expression, Expression]:
    """u_y [m] of eq. 2 and ∂u_y/∂(q, τ, β) [1, m, m], shape (3,).

    Beyond second order (`raised`) it is −l Σ shortening Q^i τ^j β^k, i + j + k = 4 and k < 2.
    """
    l, near, up = s.constant("l"), _near(s), raised(s)
    bows = _quartic_gradient(s, near, "shortening")
    bowed = 0.25 * sum(value * by for value, by in zip(near.values.values(), bows, strict=True))  # Euler's theorem
    slopes = [by * slope for by, slope in zip(bows, near.slopes, strict=True)]
    more = ca.vertcat(slopes[0], l * slopes[1], l * slopes[2])
    return 0.5 * ca.dot(s.shape, up) - l * bowed, up - more


def raised(s: Symbols) -> Expression:
    """Slopes of the height −½ (q, τ, β) R (q, τ, β)ᵀ [m] by which a beam that bends lifts its tip, (3,) [1, m, m]."""
    matrix = bends(s)
    return ca.mtimes(-matrix, s.shape)


def bends(s: Symbols) -> Expression:
    """The matrix R, (3, 3)."""
    names = [["".join(sorted(one + two, key=_ORDER.index)) for two in _ORDER] for one in _ORDER]
    return ca.vertcat(*(ca.horzcat(*(s.constant(f"rise_{name}") for name in row)) for row in names))


def _slender_energy() -> beam.Powers:
    """Energy over EI/l by Q, own slope, β, then curvature and coefficients."""
    q, end, b, curvature, steepening, stiffening = beam.Powers.variables(6)
    energy = q * 0.0
    for slopes, bent, weight in zip(*beam.shapes(), strict=True):
        slope = q * slopes[0] + end * slopes[1] + b * slopes[2]
        bend = q * bent[0] + end * bent[1] + b * bent[2] + curvature * -1.0
        energy += beam.bending_density(slope, bend, steepening) * (0.5 * weight)
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


def _near(s: Symbols) -> _Near:
    """They level off beyond `_FAR`, so that no sign of a term lets the energy fall for ever, with continuous slopes."""
    values, slopes = {}, []
    for one, x, far in zip(_ORDER, (s.x[0] / s.constant("l"), s.x[2], s.x[4]), _FAR, strict=True):
        kept = ca.fmin(1.5 * far, ca.fmax(-1.5 * far, x))
        above, below = ca.fmax(0.0, kept - far), ca.fmax(0.0, -far - kept)
        values[one] = kept - (above * above - below * below) / far
        slopes.append(1.0 - (above + below) * (2.0 / far))
    pairs: _Products = {two: values[two[0]] * values[two[1]] for two in combinations_with_replacement(_ORDER, 2)}
    threes = combinations_with_replacement(_ORDER, 3)
    return _Near(values, slopes, pairs, {three: pairs[three[:2]] * values[three[2]] for three in threes})


def _hardening_gradient(s: Symbols, near: _Near) -> list[Expression]:
    """∂/∂(Q, τ, β) of Σ quartic Q^i τ^j β^k + β³ Σ sextic Q^i τ^j β^k, i + j + k = 4 and 3."""
    square, cube = near.pairs["b", "b"], near.triples["b", "b", "b"]
    sextic = sum(s.constant(f"sextic_{''.join(three)}bbb") * at for three, at in near.triples.items())
    found = []
    for one, slope, quartic in zip(_ORDER, near.slopes, _quartic_gradient(s, near, "quartic"), strict=True):
        by = sum(_coefficient(s, one, two, "bbb", "sextic") * at for two, at in near.pairs.items()) * cube + quartic
        if one == "b":
            by += 3.0 * square * sextic
        found.append(by * slope)
    return found


def _quartic_gradient(s: Symbols, near: _Near, name: str) -> list[Expression]:
    """Slopes of Σ name Q^i τ^j β^k along the values of `near`."""
    return [sum(_coefficient(s, one, three, "", name) * at for three, at in near.triples.items()) for one in _ORDER]


def _coefficient(s: Symbols, one: str, others: tuple[str, ...], factor: str, name: str) -> Expression:
    """Coefficient in the slope along `one` of the term that is `one` times `others` times `factor`."""
    powers = "".join(sorted((*others, one), key=_ORDER.index))
    if name == "shortening" and powers not in SHORTENINGS:
        return 0.0
    return powers.count(one) * s.constant(f"{name}_{powers}{factor}")
