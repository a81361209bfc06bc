"""Levenberg-Marquardt steps that try several dampings at once, for simulations that run side by side.

Eight joints run through a log in the time of one. The least damping that brings a fair share of the best fall is taken,
not the best: a bold step along the curved valley of this cost leaves more for the next one.
"""

from typing import Protocol

import numpy as np
import scipy.linalg

from pipeline.identification.homotopy import FLOOR, Prior
from pipeline.numerics.arrays import FloatArray

DAMPINGS = 6.0 ** np.arange(-4.0, 4.0)
"""Dampings that are tried, as multiples of the last one."""

FAIR = 0.2
"""Share of the best fall of the cost that a smaller damping must bring to be taken: the smallest damping that does not
waste the step leads to lower minima than the one that falls most (compared on one simulated joint)."""

WEAKEST, STRONGEST = 1e-8, 1e4


class ParallelProblem(Protocol):
    """A simulation tied to data that runs several parameter vectors side by side."""

    def residuals(self, thetas: FloatArray, gain: float) -> FloatArray:
        """Simulated minus measured of each row of `thetas`, shape (B, N); NaN where a simulation diverged."""

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """The residual and its Jacobian, shapes (N,) and (N, P)."""


class ParallelDescent:
    """Descent at one observer gain (a `pipeline.identification.homotopy.Descent`).

    Cost of a step: one Jacobian and one batch of simulations, N P² + 4 P³ flops.
    """

    def __init__(
        self,
        problem: ParallelProblem,
        prior: Prior,
        gain: float,
        noise_inflation: float,
        theta: FloatArray,
        damping: float,
    ) -> None:
        self.problem, self.prior, self.gain, self.noise_inflation = problem, prior, gain, noise_inflation
        self.theta, self.damping, self.iterations = theta, damping, 0
        self._linearise()
        self.noise = noise_inflation * self._rms()

    def _rms(self) -> float:
        return max(float(np.sqrt(np.mean(self.residual**2))), FLOOR)

    def _linearise(self) -> None:
        self.residual, jacobian = self.problem.jacobian(self.theta, self.gain)
        self.hessian, self._slope = jacobian.T @ jacobian, jacobian.T @ self.residual

    def _cost(self, residual: FloatArray, theta: FloatArray) -> float:
        cost = 0.5 * float(residual @ residual) / self.noise**2 + 0.5 * float(np.sum(self.prior.residual(theta) ** 2))
        return cost if np.isfinite(cost) else np.inf

    def step(self, tolerance: float) -> bool:
        """One accepted step; False once the cost falls by less than `tolerance` (relative) or not at all."""
        a, cost = self.prior.matrix, self._cost(self.residual, self.theta)
        full = self.hessian / self.noise**2 + a.T @ a
        slope = self._slope / self.noise**2 + a.T @ self.prior.residual(self.theta)
        falls = np.zeros(0)
        while self.damping < STRONGEST:
            dampings = self.damping * DAMPINGS
            trials = self.theta - _damped_solutions(full, slope, dampings)
            residuals = self.problem.residuals(trials, self.gain)
            falls = cost - np.array([self._cost(r, x) for r, x in zip(residuals, trials, strict=True)])
            if falls.max() > 0.0:
                break
            self.damping = dampings[-1] / DAMPINGS[0]
        else:
            self.damping = 1e-3
            return False
        taken = int(np.flatnonzero(falls >= FAIR * falls.max())[0])
        self.theta, self.iterations = trials[taken], self.iterations + 1
        self.damping = max(float(dampings[taken]), WEAKEST)
        self._linearise()
        lower = self.noise_inflation * self._rms()
        if lower < 0.7 * self.noise:
            self.noise = lower
            return True
        return bool(falls[taken] > tolerance * cost)


def _damped_solutions(matrix: FloatArray, right: FloatArray, dampings: FloatArray) -> FloatArray:
    """Solutions of (H + damping·diag H) x = right for several dampings, shape (B, P)."""
    scale = 1.0 / np.sqrt(np.diag(matrix))
    values, vectors = scipy.linalg.eigh(scale[:, None] * matrix * scale, check_finite=False)
    projected = vectors.T @ (scale * right)
    solutions: FloatArray = scale * ((projected / (np.maximum(values, 0.0) + dampings[:, None])) @ vectors.T)
    return solutions
