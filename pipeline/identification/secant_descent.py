"""Levenberg-Marquardt steps with a Jacobian that is updated by secants, and several dampings tried at once.

A Jacobian by differences costs a simulation for each parameter, side by side eight at a time; a step needs one
batch of eight simulations, which try eight dampings. Between two Jacobians the residuals themselves correct it
(C. G. Broyden, Math. Comp. 19 (1965) 577, doi:10.1090/S0025-5718-1965-0198670-6).
"""

from typing import Protocol

import numpy as np
import scipy.linalg

from pipeline.identification.homotopy import FLOOR, Prior
from pipeline.numerics.arrays import FloatArray

DAMPINGS = 8
"""Dampings that are tried at once, and the factor between two of them."""
FACTOR = 6.0

STALE = 0.3
"""Share of the predicted fall of the cost below which a secant-updated Jacobian is replaced by a new one."""


class BatchProblem(Protocol):
    """A simulation tied to data that runs several parameter vectors at the cost of one."""

    def residuals(self, thetas: FloatArray, gain: float) -> FloatArray:
        """Simulated minus measured of each row of `thetas`, shape (B, N); NaN where a simulation diverged."""

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """The residual and its Jacobian, shapes (N,) and (N, P)."""


class SecantDescent:
    """Descent at one observer gain; see `pipeline.identification.homotopy.fit_homotopy` for the cost that falls."""

    def __init__(
        self, problem: BatchProblem, prior: Prior, gain: float, caution: float, theta: FloatArray, damping: float,
        lifetime: int,
    ) -> None:  # fmt: skip
        self.problem, self.prior, self.gain, self.caution, self.lifetime = problem, prior, gain, caution, lifetime
        self.theta, self.damping, self.iterations, self.jacobians = theta, damping, 0, 0
        self._renew()
        self.noise = caution * self._rms()

    def _rms(self) -> float:
        return max(float(np.sqrt(np.mean(self.residual**2))), FLOOR)

    def _renew(self) -> None:
        self.residual, self._jacobian = self.problem.jacobian(self.theta, self.gain)
        self.age = 0
        self.jacobians += 1
        self._square()

    def _square(self) -> None:
        self.hessian = self._jacobian.T @ self._jacobian

    def _cost(self, residual: FloatArray, theta: FloatArray) -> float:
        return 0.5 * float(residual @ residual) / self.noise**2 + 0.5 * float(np.sum(self.prior.residual(theta) ** 2))

    def step(self, tolerance: float) -> bool:
        """One step; False once the cost falls by less than `tolerance` (relative) with a new Jacobian."""
        a = self.prior.matrix
        cost = self._cost(self.residual, self.theta)
        full = self.hessian / self.noise**2 + a.T @ a
        slope = self._jacobian.T @ self.residual / self.noise**2 + a.T @ self.prior.residual(self.theta)
        dampings = self.damping * FACTOR ** (np.arange(DAMPINGS) - 3.0)
        moves = -_damped_solutions(full, slope, dampings)
        residuals = self.problem.residuals(self.theta + moves, self.gain)
        costs = np.array([self._cost(r, self.theta + m) for r, m in zip(residuals, moves, strict=True)])
        best = int(np.argmin(np.where(np.isfinite(costs), costs, np.inf)))
        if not costs[best] < cost:
            self.damping = min(1e6, dampings[-1] * FACTOR**3) if self.age == 0 else self.damping
            if self.age:
                self._renew()
                return True
            return bool(self.damping < 1e6) and self._worth(full, slope, tolerance, cost)
        move, fall = moves[best], cost - costs[best]
        predicted = -float(slope @ move) - 0.5 * float(move @ full @ move)
        self.damping = max(float(dampings[best]), 1e-9)
        change = residuals[best] - self.residual - self._jacobian @ move
        self.theta, self.residual, self.iterations = self.theta + move, residuals[best], self.iterations + 1
        small = fall <= tolerance * cost
        lower = self.caution * self._rms()
        lowered = lower < 0.7 * self.noise
        if lowered:
            self.noise = lower
        if small and not lowered and self.age == 0:
            return False
        if small or self.age >= self.lifetime or fall < STALE * predicted:
            self._renew()
        else:
            self._jacobian += np.outer(change, move) / float(move @ move)
            self.age += 1
            self._square()
        return True

    def _worth(self, full: FloatArray, slope: FloatArray, tolerance: float, cost: float) -> bool:
        """Whether a step of the present damping could still matter."""
        move = -_damped_solutions(full, slope, np.array([self.damping]))[0]
        return -float(slope @ move) > tolerance * cost


def _damped_solutions(matrix: FloatArray, right: FloatArray, dampings: FloatArray) -> FloatArray:
    """Solutions of (H + damping·diag H) x = right for several dampings, shape (B, P)."""
    scale = 1.0 / np.sqrt(np.diag(matrix))
    values, vectors = scipy.linalg.eigh(scale[:, None] * matrix * scale, check_finite=False)
    values = np.maximum(values, 0.0)
    projected = vectors.T @ (scale * right)
    solutions: FloatArray = scale * ((projected / (values + dampings[:, None])) @ vectors.T)
    return solutions
