"""Levenberg-Marquardt steps of a least-squares problem with a prior (Marquardt 1963, doi:10.1137/0111030).

`Descent` tries one damping after the other; `ParallelDescent` several at once, for simulations that run side by side:
eight joints run through a log in the time of one. It takes the least damping that brings a fair share of the best fall,
not the best one. A bold step along the curved valley of this cost leaves more for the next step.
"""

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import scipy.linalg

from ..numerics.arrays import FloatArray
from ..numerics.metrics import rms

FLOOR = 1e-5  # smallest noise level, in units of the residual: below it the prior would lose all weight

LOWERED = 0.7
"""Share of the noise level below which it follows the falling residual."""

APART = 6.0
DAMPINGS = APART ** np.arange(-4.0, 4.0)
"""Dampings that are tried at once, as multiples of the last one."""

FAIR = 0.2
"""Share of the best fall of the cost that a smaller damping must bring to be taken: the smallest damping that does not
waste the step leads to lower minima than the one that falls most (compared on one simulated joint)."""

PROBED = 0.1
LARGEST_BEND = 0.75
"""Share of a step over which its bend is measured, and the largest bend, relative to the step, that is trusted."""

START = 1e-3
WEAKEST = 1e-8
STRONGEST = 1e6


PARAMETER_STEP = 1e-4
"""Step of differences by parameters, in prior standard deviations."""


class ObservedProblem(Protocol):
    """A simulation that an observer couples to data."""

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        """Simulated minus measured, shape (N,); None if the simulation diverged."""

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """The residual and its Jacobian, shapes (N,) and (N, P)."""


@dataclass(frozen=True)
class Prior:
    """Gaussian prior ‖A θ − b‖²/2, knowledge or belief before the data; shapes (R, P) and (R,)."""

    matrix: FloatArray
    right: FloatArray

    def residual(self, theta: FloatArray) -> FloatArray:
        """A θ − b."""
        return np.asarray(self.matrix @ theta - self.right)


class Descent:
    """Steps at one observer gain.

    Parameters
    ----------
    problem : ObservedProblem
    prior : Prior
    gain : float
        Of the observer.
    noise_inflation : float
        The noise level is this multiple of the residual's RMS.
    theta : FloatArray, shape (P,)
        Start.
    damping : float
        First damping.
    residual : FloatArray, shape (N,)
        At the start.

    Notes
    -----
    Cost of a step: one Jacobian, one to three simulations, N P² + P³/3 flops.
    """

    def __init__(
        self,
        problem: Any,
        prior: Prior,
        gain: float,
        noise_inflation: float,
        theta: FloatArray,
        damping: float,
        residual: FloatArray,
    ) -> None:
        self.problem = problem
        self.prior = prior
        self.gain = gain
        self.noise_inflation = noise_inflation
        self.theta = theta
        self.damping = damping
        self.residual = residual
        self.iterations = 0
        self.hessian = np.zeros((len(theta), len(theta)))
        self._linear: tuple[FloatArray, FloatArray] | None = None  # θ and residual where these two hold
        self.noise = noise_inflation * max(rms(residual), FLOOR)

    def linearise(self) -> bool:
        """Sensitivities at θ, if they are not there yet; False, and back to where they were, if they overflow."""
        if self._linear is not None and self._linear[0] is self.theta:
            return True
        with np.errstate(over="ignore", invalid="ignore"):
            residual, jacobian = self.problem.jacobian(self.theta, self.gain)
            hessian = jacobian.T @ jacobian
            slope = jacobian.T @ residual
        if np.isfinite(hessian).all() and np.isfinite(slope).all():
            self.residual = residual
            self.jacobian = jacobian
            self.hessian = hessian
            self._slope = slope
            self._linear = self.theta, residual
            return True
        if self._linear is not None:
            self.theta, self.residual = self._linear
        return False

    def step(self, tolerance: float) -> bool:
        """One accepted step; False once the cost falls by less than `tolerance` (relative) or not at all."""
        if not self.linearise():
            return False
        cost = self._cost(self.residual, self.theta)
        matrix = self.prior.matrix
        full = self.hessian / self.noise**2 + matrix.T @ matrix
        slope = self._slope / self.noise**2 + matrix.T @ self.prior.residual(self.theta)
        lowered = self._lower(full, slope, cost)
        if lowered is None:
            self.damping = START
            return False
        self.theta, self.residual, fall = lowered
        self.iterations += 1
        lower = self.noise_inflation * max(rms(self.residual), FLOOR)
        if lower < LOWERED * self.noise:
            self.noise = lower
            return True
        return fall > tolerance * cost

    def _lower(self, full: FloatArray, slope: FloatArray, cost: float) -> tuple[FloatArray, FloatArray, float] | None:
        """θ and residual of a lower cost, and by how much; None if no damping leads to one."""
        scale = 1.0 / np.sqrt(np.diag(full))
        scaled = scale[:, None] * full * scale
        while self.damping < STRONGEST:
            step = np.linalg.solve(scaled + self.damping * np.eye(len(full)), scale * slope)
            trial = self.theta - scale * step
            residual = self.problem.residual(trial, self.gain)
            fall = -np.inf if residual is None else cost - self._cost(residual, trial)
            if fall > 0.0:
                self.damping = max(self.damping / 5.0, WEAKEST)
                return trial, residual, fall
            self.damping *= 5.0
        return None

    def _cost(self, residual: FloatArray, theta: FloatArray) -> float:
        cost = 0.5 * float(residual @ residual) / self.noise**2 + 0.5 * float(np.sum(self.prior.residual(theta) ** 2))
        return cost if np.isfinite(cost) else np.inf


class ParallelDescent(Descent):
    """Descent with steps that bend along the valley of the cost, on a problem that runs several θ side by side.

    Its ``residuals(thetas, gain)`` are simulated minus measured of each row of θ, shape (B, N); NaN where one diverged.

    Where parameters trade against each other the cost is a narrow curved valley, and a straight step is short or
    leaves it. The second derivative of the residual along a step, from one more simulation at a share of it, says how
    the valley bends ("geodesic acceleration": Transtrum, Machta, Sethna 2011, doi:10.1103/PhysRevE.83.036701).

    A step costs one Jacobian, two batches of simulations, N P² + 4 P³ flops.
    """

    def _lower(self, full: FloatArray, slope: FloatArray, cost: float) -> tuple[FloatArray, FloatArray, float] | None:
        while self.damping < STRONGEST:
            dampings = self.damping * DAMPINGS
            trials = self._bent(full, dampings, slope)
            residuals = self.problem.residuals(trials, self.gain)
            falls = cost - np.array([self._cost(r, x) for r, x in zip(residuals, trials, strict=True)])
            if falls.max() > 0.0:
                taken = int(np.flatnonzero(falls >= FAIR * falls.max())[0])
                self.damping = max(float(dampings[taken]), WEAKEST)
                return trials[taken], residuals[taken], float(falls[taken])
            self.damping = APART * dampings[-1] / DAMPINGS[0]
        return None

    def _bent(self, full: FloatArray, dampings: FloatArray, slope: FloatArray) -> FloatArray:
        """Ends of the steps of several dampings, shape (B, P): straight where the valley bends too much."""
        scale = 1.0 / np.sqrt(np.diag(full))
        values, vectors = scipy.linalg.eigh(scale[:, None] * full * scale, check_finite=False)
        damped = np.maximum(values, 0.0) + dampings[:, None]

        def solved(right: FloatArray) -> FloatArray:
            """Solutions x of (H + damping·diag H) x = b for one b of each damping, shape (B, P)."""
            return np.asarray(scale * ((right * scale) @ vectors / damped @ vectors.T))

        steps = -solved(np.broadcast_to(slope, (len(dampings), len(slope))))
        probed = self.problem.residuals(self.theta + PROBED * steps, self.gain)
        curvature = 2.0 / PROBED * ((probed - self.residual) / PROBED - steps @ self.jacobian.T)
        finite = ~np.any(~np.isfinite(curvature), axis=1, keepdims=True)
        bends = -0.5 * solved(np.where(finite, curvature, 0.0) @ self.jacobian / self.noise**2)
        # Lengths are in units in which diag H is one.
        trusted = np.linalg.norm(bends / scale, axis=1) <= LARGEST_BEND * np.linalg.norm(steps / scale, axis=1)
        return np.asarray(self.theta + steps + np.where(trusted[:, None], bends, 0.0))
