"""Candidate terms for the sparse regression of the acceleration: libraries as exponent tables."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import IntArray
from pipeline.numerics.polynomial_dynamics import FIRST_INPUT, FRICTION, LAG, QDOT, Q

COUPLING_DEGREE = 3  # degree in q of the factors of z, tanh(q̇/w) and the inputs: ∂C/∂q is smooth and even-ish


@dataclass(frozen=True)
class Library:
    """What may enter the equation of the acceleration.

    Attributes
    ----------
    degree : int
        Total degree of the polynomial in q and q̇.
    full : bool
        All products q^i q̇^j; otherwise only j ≤ 1, so a restoring force F(q) and a damping d(q)·q̇.
    friction : bool
        poly(q)·tanh(q̇/w), a smoothed dry friction.
    lag_time : float
        poly(q)·z with ż = (q̇ − z)/T_z, T_z in s; 0 leaves the lag state out.
    """

    degree: int
    full: bool
    friction: bool
    lag_time: float

    def exponents(self, inputs: int) -> IntArray:
        """The exponent table, shape (P, 4 + inputs); inputs enter as poly(q)⊗u, never among themselves."""
        rows = []
        for i in range(self.degree + 1):
            for j in range(self.degree + 1 - i if self.full else 2):
                rows.append(_row(inputs, {Q: i, QDOT: j}))
        factors = [LAG] * (self.lag_time > 0.0) + [FRICTION] * self.friction
        factors += [FIRST_INPUT + k for k in range(inputs)]
        for factor in factors:
            rows += [_row(inputs, {Q: i, factor: 1}) for i in range(COUPLING_DEGREE + 1)]
        return np.array(rows, dtype=np.int64)

    def __str__(self) -> str:
        """E.g. ``poly5(q) ⊗ (1, q̇) + poly3(q) ⊗ (z[0.02 s], tanh q̇, u)``."""
        body = f"poly{self.degree}(q, q̇)" if self.full else f"poly{self.degree}(q) ⊗ (1, q̇)"
        lag = [f"z[{self.lag_time:g} s]"] if self.lag_time > 0.0 else []
        factors = [*lag, *(["tanh q̇"] if self.friction else []), "u"]
        return f"{body} + poly{COUPLING_DEGREE}(q) ⊗ ({', '.join(factors)})"


def _row(inputs: int, powers: dict[int, int]) -> list[int]:
    return [powers.get(k, 0) for k in range(FIRST_INPUT + inputs)]
