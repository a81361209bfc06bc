"""Estimation of a free run by homotopy over an observer: from an easy problem to the wanted one.

A free run's error is a bad cost far from its minimum: one wrong decision at the separatrix, and the joint lies in
the other well until the next pulse. An observer with the gain λ couples the simulation to the measurement and keeps it
in the right well. Its error, about (force error)/λ², is nearly linear in the parameters. λ falls in steps to zero, each
level starting from the minimiser of the one before. Hidden states run through the whole record, so unlike
multiple shooting there are no window states to estimate.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..numerics.arrays import FloatArray
from ..numerics.metrics import rms
from .descent import FLOOR, START, Descent, ObservedProblem, Prior

GAINS = (3.0, 1.0, 0.3, 0.1, 0.03, 0.0)
"""Observer gains, in turn, in units of the problem's own frequency scale; zero is the free run."""

COUPLED = GAINS[2]
"""Gain at which a chaotic device stays, because less coupled simulations diverge. A bistable one stays there because
single passages near the separatrix decide its free run."""

LEVEL_TOLERANCE = 1e-3
"""Relative fall of the cost below which a level before the last one ends, and a fit that only compares candidates."""

LEAST_STEPS = 3
"""Steps of the last level that are taken even when the effort is spent."""


@dataclass(frozen=True)
class Level:
    """One level: gain λ, iterations, RMS of the residual, and whether the cost had stopped falling."""

    gain: float
    iterations: int
    rms: float
    converged: bool


@dataclass(frozen=True)
class HomotopyFit:
    """Result.

    Attributes
    ----------
    theta : FloatArray, shape (P,)
    residual : FloatArray, shape (N,)
        At the last level that did not diverge.
    hessian : FloatArray, shape (P, P)
        JᵀJ of the residual there, without noise and prior.
    noise : float
        Assumed standard deviation of the residual.
    levels : tuple of Level
    reached_last : bool
        True if the last level that was asked for (mostly the free run) was reached.
    chaotic : bool
        True if free runs part from those that start beside them; the fit then stops at `COUPLED`.
    """

    theta: FloatArray
    residual: FloatArray
    hessian: FloatArray
    noise: float
    levels: tuple[Level, ...]
    reached_last: bool
    chaotic: bool = False

    @property
    def converged(self) -> bool:
        """True if the cost stopped falling at the last level, or at the level at which a chaotic device stays."""
        return (self.reached_last or self.chaotic) and self.levels[-1].converged


@dataclass(frozen=True)
class Schedule:
    """Levels of a fit, and steps at each of them.

    Attributes
    ----------
    gains : sequence of float
        λ, falling, in the unit that the problem takes.
    iterations, last_iterations : int
        Steps per level, and at the last one.
    tolerance : float
        Relative fall of the cost below which the last level has converged. The cost is a negative log posterior, of
        some hundreds for a log of 37.5 s. A step that lowers it by a few hundredths moves no parameter by more than a
        few tenths of its standard error.
    noise_inflation : float
        Factor on the noise level: above 1 where residuals are not independent, so that the prior weighs more.
    """

    gains: Sequence[float] = GAINS
    iterations: int = 8
    last_iterations: int = 25
    tolerance: float = 1e-4
    noise_inflation: float = 1.0


@dataclass(frozen=True)
class Callbacks:
    """Functions that a fit calls.

    Attributes
    ----------
    begin : callable
        With θ and the gain, before each level.
    enough : callable
        Test if the effort is spent: then the last level follows at once, with `LEAST_STEPS` steps.
    on_progress : callable
        With the gain and the RMS of the residual, before each step.
    is_chaotic : callable
        Test if a free run with θ diverges from one that starts beside it. It is called after the level
        `COUPLED`, which then is the last: the error of a chaotic run is no cost to descend on.
    """

    begin: Callable[[FloatArray, float], None] = lambda theta, gain: None
    enough: Callable[[], bool] = lambda: False
    on_progress: Callable[[float, float], None] = lambda gain, rms: None
    is_chaotic: Callable[[FloatArray], bool] = lambda theta: False


def fit_homotopy(
    problem: ObservedProblem,
    theta: FloatArray,
    prior: Prior,
    schedule: Schedule,
    *,
    callbacks: Callbacks = Callbacks(),
    descent: type[Descent] = Descent,
) -> HomotopyFit:
    """Minimise ‖r(θ; λ)‖²/(2 s²) + ‖A θ − b‖²/2 for falling λ by Levenberg-Marquardt steps.

    The noise level s is `Schedule.noise_inflation` times the RMS of the residual itself, lowered as that falls.

    Parameters
    ----------
    problem : ObservedProblem
        The simulation and its data.
    theta : FloatArray, shape (P,)
        Start.
    prior : Prior
        Prior of θ.
    schedule : Schedule
        Levels and steps.
    callbacks : Callbacks
        Functions that the fit calls.
    descent : type of Descent
        Descent method: `ParallelDescent` where simulations run side by side.

    Returns
    -------
    HomotopyFit
        Levels end early where the simulation or its sensitivities overflow, and where simulations part (chaos).
        Cost: per step one Jacobian, one to three plain simulations, and N P² + P³/3 flops.
    """
    fit = HomotopyFit(
        theta=theta,
        residual=np.zeros(0),
        hessian=np.zeros((len(theta), len(theta))),
        noise=FLOOR,
        levels=(),
        reached_last=False,
    )
    damping = START
    pending = list(schedule.gains)

    def begun(gain: float, residual: FloatArray) -> Descent:
        """The descent of a level, which goes on from the fit before it."""
        return descent(problem, prior, gain, schedule.noise_inflation, fit.theta, damping, residual)

    while pending:
        if callbacks.enough():
            pending = pending[-1:]
        gain, *pending = pending
        callbacks.begin(fit.theta, gain)
        ahead = problem.residual(fit.theta, gain)
        level = None if ahead is None else begun(gain, ahead)
        if level is None or not level.linearise():
            if fit.levels:
                last = begun(fit.levels[-1].gain, fit.residual)
                last.linearise()
                fit = replace(fit, hessian=last.hessian)
            break
        done = _descend(level, schedule, callbacks, last=not pending)
        chaotic = gain == COUPLED and callbacks.is_chaotic(level.theta)
        stays = chaotic and bool(pending)
        if stays:
            pending = []
            done = _descend(level, schedule, callbacks, last=True)
        if not pending:
            level.linearise()
        fit = HomotopyFit(
            theta=level.theta,
            residual=level.residual,
            hessian=level.hessian,
            noise=level.noise,
            levels=(*fit.levels, Level(float(gain), level.iterations, rms(level.residual), done)),
            reached_last=not (pending or stays),
            chaotic=chaotic,
        )
        damping = level.damping
    return fit


def _descend(level: Descent, schedule: Schedule, calls: Callbacks, *, last: bool) -> bool:
    """Take the steps of a level; whether its cost had stopped falling."""
    most = schedule.last_iterations if last else schedule.iterations
    done = False
    while level.iterations < most and not done and not (calls.enough() and level.iterations >= LEAST_STEPS):
        calls.on_progress(level.gain, rms(level.residual))
        done = not level.step(schedule.tolerance if last else LEVEL_TOLERANCE)
    return done
