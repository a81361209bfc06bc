"""Candidate terms for the sparse regression of the acceleration: libraries as exponent tables."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pipeline.baselines.polynomial_dynamics import COSINE, FIRST_INPUT, FRICTION, LAG, QDOT, SINE, Q
from pipeline.numerics.arrays import IntArray

Shape = Literal["polynomial", "trigonometric"]


@dataclass(frozen=True)
class Library:
    """What may enter the equation of the acceleration.

    Attributes
    ----------
    shape : {"polynomial", "trigonometric"}
        Functions of q: its powers, or 1, sin q and cos q (an angle).
    degree : int
        Total degree of the polynomial in q and q̇; of the powers of q̇ for the trigonometric shape.
    full : bool
        All products up to the degree; otherwise only powers of q̇ up to 1, so F(q) and d(q)·q̇.
    friction : bool
        f(q)·tanh(q̇/w), a smoothed dry friction.
    lag_time : float
        f(q)·z with ż = (q̇ − z)/T_z, T_z in s; 0 leaves the lag state out.
    coupling : int
        Degree of the polynomial f(q) that multiplies z, tanh and the inputs; 0 lets them act alike everywhere. Any
        other number means 1, sin q and cos q for the trigonometric shape.
    """

    shape: Shape
    degree: int
    full: bool
    friction: bool
    lag_time: float
    coupling: int = 3

    def exponents(self, inputs: int) -> IntArray:
        """The exponent table, shape (P, 6 + inputs); inputs enter as f(q)⊗u, never among themselves."""
        rows = [_row(inputs, powers) for powers in self._body()]
        factors = [LAG] * (self.lag_time > 0.0) + [FRICTION] * self.friction
        factors += [FIRST_INPUT + k for k in range(inputs)]
        rows += [_row(inputs, f | {factor: 1}) for factor in factors for f in self._couplings()]
        return np.array(rows, dtype=np.int64)

    def _body(self) -> list[dict[int, int]]:
        if self.shape == "trigonometric":
            return [f | {QDOT: j} for f in _CIRCLE for j in range(self.degree + 1 if self.full else 2)]
        return [{Q: i, QDOT: j} for i in range(self.degree + 1) for j in range(self.degree + 1 - i if self.full else 2)]

    def _couplings(self) -> list[dict[int, int]]:
        if self.shape == "trigonometric":
            return _CIRCLE if self.coupling else [{}]
        return [{Q: i} for i in range(self.coupling + 1)]

    def __str__(self) -> str:
        """E.g. ``poly5(q) ⊗ (1, q̇) + poly3(q) ⊗ (z[0.02 s], tanh q̇, u)``."""
        circle = "(1, sin q, cos q)"
        if self.shape == "trigonometric":
            body = f"{circle} ⊗ poly{self.degree if self.full else 1}(q̇)"
        else:
            body = f"poly{self.degree}(q, q̇)" if self.full else f"poly{self.degree}(q) ⊗ (1, q̇)"
        lag = [f"z[{self.lag_time:g} s]"] if self.lag_time > 0.0 else []
        factors = ", ".join([*lag, *(["tanh q̇"] if self.friction else []), "u"])
        if self.coupling == 0:
            return f"{body} + ({factors})"
        return f"{body} + {circle if self.shape == 'trigonometric' else f'poly{self.coupling}(q)'} ⊗ ({factors})"


_CIRCLE: list[dict[int, int]] = [{}, {SINE: 1}, {COSINE: 1}]


def _row(inputs: int, powers: dict[int, int]) -> list[int]:
    return [powers.get(k, 0) for k in range(FIRST_INPUT + inputs)]
