"""The least squares of a calibration: scaled unknowns with priors and bounds, and SciPy's search for them."""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from ...device.parameters import VECTOR_NAMES, JointParameters, quantity_of
from ...errors import InputError
from ...fitting.descent import PARAMETER_STEP
from ...numerics.arrays import FloatArray
from .windows import WindowRuns, Windows, error_derivatives, simulate_windows

RESOLUTION = 1e-3
"""Error of q [m] that weighs as much as one prior width; model errors are of this size."""


@dataclass(frozen=True)
class ParameterPrior:
    """Width and bounds of an unknown: factors of the starting value, or absolute [SI] where `relative` is false."""

    width: float
    lower: float
    upper: float
    relative: bool = True


_ELASTIC = ParameterPrior(1.1, 0.7, 1.4)
_VISCOUS = ParameterPrior(2.0, 0.05, 20.0)
_LENGTH = ParameterPrior(3e-4, -1.5e-3, 1.5e-3, False)
PRIORS = {
    "Y": _ELASTIC, "E": _ELASTIC, "eps_r": _ELASTIC, "rho": _ELASTIC, "m": ParameterPrior(1.02, 0.9, 1.1),
    "Y_MW": ParameterPrior(1.5, 0.1, 10.0), "eta_v": _VISCOUS, "eta_MW": _VISCOUS, "eta": _VISCOUS,
    "a": _LENGTH, "b": _LENGTH, "a0": _LENGTH, "e_x": _LENGTH, "e_z": _LENGTH, "l0": _LENGTH,
    "kappa0": ParameterPrior(0.1, -1.0, 1.0, False), "F_c": ParameterPrior(5e-3, 0.0, 0.05, False),
    "s_c": ParameterPrior(2.0, 0.1, 10.0),
}  # fmt: skip
"""Parameters that may be calibrated, and the prior widths of a designer's values."""


def prior_of(name: str) -> ParameterPrior:
    """The prior of a parameter, the same for both sides.

    Raises
    ------
    InputError
        An unknown parameter, or one that calibration leaves alone.
    """
    quantity_of(name)
    attribute = name.rpartition(".")[2]
    if attribute not in PRIORS:
        raise InputError(f"parameter {name!r} cannot be calibrated; possible are {', '.join(PRIORS)}")
    return PRIORS[attribute]


class CalibrationProblem:
    """Scaled unknowns x (P,), zero at the starting set, one prior width a unit.

    Parameters
    ----------
    start : JointParameters
        The designer's set.
    names : sequence of str
        What is fitted.
    pool : ThreadPoolExecutor
        Threads for the windows.
    """

    def __init__(self, start: JointParameters, names: Sequence[str], pool: ThreadPoolExecutor) -> None:
        self.start = start
        self.names = tuple(names)
        self.priors = [prior_of(name) for name in names]
        self.origin = np.array([start.value(name if name in VECTOR_NAMES else f"left.{name}") for name in names])
        low, high = zip(*(self._bounds(prior) for prior in self.priors), strict=True)
        self.lower = np.array(low)
        self.upper = np.array(high)
        self.pool = pool
        self.evaluations = 0

    @staticmethod
    def _bounds(prior: ParameterPrior) -> tuple[float, float]:
        if prior.relative:
            return np.log(prior.lower) / np.log(prior.width), np.log(prior.upper) / np.log(prior.width)
        return prior.lower / prior.width, prior.upper / prior.width

    def values(self, x: FloatArray) -> FloatArray:
        """Values [SI] at x."""
        pairs = zip(self.priors, self.origin, x, strict=True)
        return np.array([o * prior.width**s if prior.relative else o + prior.width * s for prior, o, s in pairs])

    def slopes(self, x: FloatArray) -> FloatArray:
        """Derivatives of the values [SI] with respect to x."""
        pairs = zip(self.priors, self.values(x), strict=True)
        return np.array([v * np.log(prior.width) if prior.relative else prior.width for prior, v in pairs])

    def parameters(self, x: FloatArray) -> JointParameters:
        """The set at x."""
        return self.start.with_values(dict(zip(self.names, self.values(x), strict=True)))

    def at(self, windows: Windows, tolerance: float) -> "SimulatedProblem":
        """The problem on these windows, simulated with this tolerance."""
        return SimulatedProblem(self, windows, tolerance)


class SimulatedProblem:
    """Residuals and their derivatives; a Jacobian uses the solution that its residuals came from."""

    def __init__(self, problem: CalibrationProblem, windows: Windows, tolerance: float) -> None:
        self.problem = problem
        self.windows = windows
        self.tolerance = tolerance
        self._made: dict[bytes, WindowRuns] = {}

    def residuals(self, x: FloatArray) -> FloatArray:
        """Errors of q over `RESOLUTION`, then the prior's residuals, shape (samples + P,)."""
        problem = self.problem
        key = x.tobytes()
        if key not in self._made:
            problem.evaluations += 1
            self._made[key] = simulate_windows(problem.parameters(x), self.windows, self.tolerance, problem.pool)
        return np.concatenate([self._made[key].errors / RESOLUTION, x])

    def jacobian(self, x: FloatArray) -> FloatArray:
        """Derivatives of the residuals where they were computed, shape (samples + P, P)."""
        problem = self.problem
        runs = self._made[x.tobytes()]
        self._made = {x.tobytes(): runs}  # a search never goes back behind a point that it took
        steps = np.where(x + PARAMETER_STEP <= problem.upper, PARAMETER_STEP, -PARAMETER_STEP)
        moved = [problem.parameters(x + step * unit) for step, unit in zip(steps, np.eye(x.size), strict=True)]
        return np.vstack([error_derivatives(runs, moved, steps, problem.pool) / RESOLUTION, np.eye(x.size)])


LOSS_SCALE = 3.0
"""Residual, in units of `RESOLUTION`, from which the soft-L1 loss grows linearly."""

SMALLEST_STEP = 1e-4
"""Change of the unknowns, relative to their size, below which a search has converged."""

INSIDE = 1e-6
"""Distance from the bounds, in prior widths, at which a search starts at least."""


@dataclass(frozen=True)
class Ended:
    """End of a search: unknowns, cost, residuals, whether it converged; evaluations of all searches so far."""

    x: FloatArray
    cost: float
    residuals: FloatArray
    converged: bool
    evaluations: int


def search(
    simulated: SimulatedProblem, x0: FloatArray, limit: int, tolerance: float, tick: Callable[[], None]
) -> Ended:
    """Improve `x0` until the cost falls by less than `tolerance` (relative), or `limit` simulations are done.

    SciPy's trust region within bounds (Branch, Coleman & Li 1999, doi:10.1137/S1064827595289108). `tick` is called
    before each step.

    Parameters
    ----------
    simulated : SimulatedProblem
        Residuals and derivatives.
    x0 : FloatArray, shape (P,)
        Start in prior widths; it is moved inside the bounds.
    limit : int
        Most simulations.
    tolerance : float
        Relative fall of the cost at which the search ends.
    tick : callable
        Called before each step.
    """
    from scipy.optimize import least_squares

    problem = simulated.problem

    def jacobian(x: FloatArray) -> FloatArray:
        """The derivatives with which a step begins."""
        tick()
        return simulated.jacobian(x)

    reached = least_squares(
        simulated.residuals, np.clip(x0, problem.lower + INSIDE, problem.upper - INSIDE), jacobian,
        (problem.lower, problem.upper), loss="soft_l1", f_scale=LOSS_SCALE, ftol=tolerance, xtol=SMALLEST_STEP,
        max_nfev=limit,
    )  # fmt: skip
    return Ended(reached.x, float(reached.cost), reached.fun, reached.status > 0, problem.evaluations)
