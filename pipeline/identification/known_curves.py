"""Characteristic curves that were measured on a test stand: the fit keeps them and learns the friction (§4.2).

A measured point is an observation like any other: rows of the prior say that the curve passes there, within a small
share of the curve's largest value. Where nothing was measured the data decide as before.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import lsq_linear

from pipeline.errors import InputError
from pipeline.identification import viscoelastic_joint as joint
from pipeline.identification.descent import Prior
from pipeline.identification.parameter_layout import ParameterLayout
from pipeline.numerics.arrays import FloatArray

KEPT = 5e-3
"""Standard deviation of a measured point, as a share of its curve's largest value."""

LEAST_POINTS = 4
SLIGHT_CUBIC = 0.02  # of the stiffness scale: the confining cubic that stays whatever was measured
PINNED = 1e-3  # standard deviation of the logarithm of that cubic
RIDGE = 1e-4


@dataclass(frozen=True)
class KnownCurves:
    """Measured curves of a joint.

    Attributes
    ----------
    q : FloatArray, shape (n,)
        Displacement [m] or [rad].
    force : FloatArray, shape (n,), optional
        Restoring force F [N] at rest without inputs, positive where it pulls to smaller q; NaN where not measured.
    gains : sequence of FloatArray, shape (n,), or None, one per input
        g_k [N/V²] (half the slope of a capacitance) or [N/V]; NaN where not measured, None for all of them.
    """

    q: FloatArray
    force: FloatArray | None
    gains: tuple[FloatArray | None, ...]

    @property
    def reach(self) -> tuple[float, float]:
        """Smallest and largest q at which something was measured."""
        curves = [curve for curve in (self.force, *self.gains) if curve is not None]
        known = self.q[np.any(np.isfinite(curves), axis=0)]
        return float(known.min()), float(known.max())

    def check(self, low: float, high: float) -> None:
        """Refuse curves that have next to nothing to do with data from `low` to `high`.

        Raises
        ------
        InputError
            A curve has fewer than four points there.
        """
        named = {"F": self.force} | {f"input {k}": gain for k, gain in enumerate(self.gains, start=1)}
        for name, curve in named.items():
            if curve is None:
                continue
            points = np.count_nonzero(np.isfinite(curve) & (self.q >= low) & (self.q <= high))
            if points < LEAST_POINTS:
                raise InputError(
                    f"the measured curve of {name} has {points} points where the training data are ({low:.4g} to "
                    f"{high:.4g}), at least {LEAST_POINTS} are needed; check q and its unit in the file of plant.curves"
                )

    def per_unit_mass(self, mass: float) -> "KnownCurves":
        """Forces over the moving mass [kg]."""
        force = None if self.force is None else self.force / mass
        return KnownCurves(self.q, force, tuple(None if gain is None else gain / mass for gain in self.gains))


def pin_curves(p: ParameterLayout, start: FloatArray, prior: Prior, known: KnownCurves) -> tuple[FloatArray, Prior]:
    """Start vector and prior that keep the known curves.

    Parameters
    ----------
    p : ParameterLayout
        Gains of inputs whose curve is known are free of a sign.
    start : FloatArray, shape (P,)
        Where the estimation would start without them.
    prior : Prior
        What is believed without them.
    known : KnownCurves
        Per unit mass.
    """
    start, s, rows, right = start.copy(), p.scales, [prior.matrix], [prior.right]
    c, at = p.coefficients(start), p.slices
    if known.force is not None:
        basis, y = _points(p, c, known.q, -known.force / s.half)
        high = np.full(basis.shape[1], np.inf)
        high[joint.POLYNOMIALS - 1] = -SLIGHT_CUBIC * s.stiffness
        weights = _fitted(basis, y, high)
        cubic = at["force"].start + joint.POLYNOMIALS - 1
        start[at["force"]] = weights
        start[cubic] = np.log(-weights[joint.POLYNOMIALS - 1])
        others = [i for i in range(basis.shape[1]) if i != joint.POLYNOMIALS - 1]
        linear = y - basis[:, joint.POLYNOMIALS - 1] * weights[joint.POLYNOMIALS - 1]
        _add(
            rows, right, p.count, at["force"].start + np.array(others), basis[:, others], linear, KEPT * np.abs(y).max()
        )
        _add(rows, right, p.count, np.array([cubic]), np.ones((1, 1)), start[[cubic]], PINNED)
    for k, gain in enumerate(known.gains):
        if gain is not None:
            per_unit = gain / s.half * (s.volts**2 if p.law == "squared" else s.volts)
            basis, y = _points(p, c, known.q, per_unit)
            bells, where = basis[:, joint.POLYNOMIALS :], at[f"input{k}"]
            start[where] = _fitted(bells, y, np.full(bells.shape[1], np.inf))
            _add(rows, right, p.count, np.arange(where.start, where.stop), bells, y, KEPT * np.abs(y).max())
    return start, Prior(np.vstack(rows), np.concatenate(right))


def _points(
    p: ParameterLayout, c: joint.Coefficients, q: FloatArray, values: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Basis and values at the measured points."""
    kept = np.isfinite(values)
    x = (q[kept] - p.scales.middle) / p.scales.half
    return joint.basis(np.ascontiguousarray(x), c), values[kept]


def _fitted(basis: FloatArray, y: FloatArray, high: FloatArray) -> FloatArray:
    norms = np.linalg.norm(basis, axis=0) + np.finfo(float).tiny
    matrix = np.vstack((basis / norms, RIDGE * np.eye(basis.shape[1])))
    right = np.concatenate((y, np.zeros(basis.shape[1])))
    weights: FloatArray = lsq_linear(matrix, right, (-np.inf, high * norms)).x / norms
    return weights


def _add(
    rows: list[FloatArray], right: list[FloatArray], count: int, index: Sequence[int] | FloatArray,
    factors: FloatArray, values: FloatArray, spread: float,
) -> None:  # fmt: skip
    block = np.zeros((len(values), count))
    block[:, np.asarray(index, dtype=np.int64)] = factors / spread
    rows.append(block)
    right.append(values / spread)
