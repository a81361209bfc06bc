"""The condensed joint's rates with their exact derivatives at a state, from the generated graphs by numpy."""

from functools import cached_property

import numpy as np

from pipeline.generated.condensed_joint import CORRECTIONS, STATES, STOPS
from pipeline.generated.condensed_joint_jacobian import BY_CONSTANTS, JACOBIAN, PREPARE
from pipeline.models.hybrid.kernels import corrections_at
from pipeline.numerics.arrays import FloatArray

ALL = STATES + STOPS
"""States x, and the stop operators z behind them."""


class Linearised:
    """Rates f (ALL,) and their derivatives at a state.

    `a` (ALL, ALL) by x and z, `b` (ALL, 2) by the squared voltages [V²], `by_constants` (ALL, constants) and
    `by_weights` (ALL, 9, M) by the weights of the corrections. Stops at ±1 that are pushed on stick: their rows are 0.
    """

    def __init__(
        self, k: FloatArray, basis: FloatArray, weights: FloatArray, x: FloatArray, z: FloatArray, u: FloatArray
    ) -> None:
        r = (x[0] - basis[0] - basis[1] * np.arange(weights.shape[1])) / basis[2]
        bells = np.exp(-0.5 * r * r)
        slopes, bends = -r / basis[2] * bells, (r * r - 1.0) / basis[2] ** 2 * bells
        c = np.empty(len(CORRECTIONS))
        corrections_at(float(x[0]), basis, weights, c)
        c_q = np.concatenate([weights @ slopes, weights[4:8] @ bends])
        self._acting = {"x": x, "u": u, "c": c, "z": z, "p": PREPARE.evaluate(k=k)["p"]}
        found = JACOBIAN.evaluate(**self._acting, c_q=c_q)
        self.f, self.a, self.b = found["f"], found["a"].reshape(ALL, ALL), found["b"].reshape(ALL, 2)
        curves = found["by_c"].reshape(ALL, -1)
        self.by_weights = curves[:, :9, None] * bells
        self.by_weights[:, 4:8] += curves[:, 9:, None] * slopes

    @cached_property
    def by_constants(self) -> FloatArray:
        """Derivatives of the rates by the constants, (ALL, constants)."""
        return BY_CONSTANTS.evaluate(**self._acting)["by_k"].reshape(ALL, -1)
