"""Estimation of a free run by homotopy over an observer: from an easy problem to the wanted one.

A free run's error is a bad cost far from its minimum: one wrong decision at the separatrix, and the joint lies in
the other well until the next pulse. Coupled to the measurement by an observer with the gain λ, the simulation is
always in the right well and its error, about (force error)/λ², is nearly linear in the parameters. λ falls in steps to
zero, each level starting from the minimiser of the one before. Hidden states run through the whole record, so unlike
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
        True if the fit stopped before it because free runs part from those that start beside them.
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
        Relative fall of the cost below which the last level has converged.
    noise_inflation : float
        Factor on the noise level: above 1 where residuals are not independent, so that the prior weighs more.
    chaos_gain : float
        The one of the gains at which a chaotic device stays.
    """

    gains: Sequence[float] = GAINS
    iterations: int = 8
    last_iterations: int = 25
    tolerance: float = 1e-5
    noise_inflation: float = 1.0
    chaos_gain: float = COUPLED


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
        `Schedule.chaos_gain`, which then is the last: the error of a chaotic run is no cost to descend on.
    """

    begin: Callable[[FloatArray, float], None] = lambda theta, gain: None
    enough: Callable[[], bool] = lambda: False
    on_progress: Callable[[float, float], None] = lambda gain, rms: None
    is_chaotic: Callable[[FloatArray], bool] = lambda theta: False


def fit_homotopy(
    problem: ObservedProblem, theta: FloatArray, prior: Prior, schedule: Schedule, *,
    callbacks: Callbacks | None = None, descent: type[Descent] = Descent,
) -> HomotopyFit:  # fmt: skip
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
    callbacks : Callbacks, optional
        Functions that the fit calls.
    descent : type of Descent
        Descent method: `ParallelDescent` where simulations run side by side.

    Returns
    -------
    HomotopyFit
        Levels end early where the simulation or its sensitivities overflow, and where simulations part (chaos).
        Cost: per step one Jacobian, one to three plain simulations, and N P² + P³/3 flops.
    """
    count = len(theta)
    calls = callbacks or Callbacks()
    state = _State(theta, np.zeros(0), np.zeros((count, count)), FLOOR, (), False, pending=tuple(schedule.gains))
    levels = _Levels(problem, prior, schedule, calls, descent)
    while state.pending:
        state = levels.next(state)
    return state


@dataclass(frozen=True)
class _State(HomotopyFit):
    """A fit between two levels, and the gains of the levels to come."""

    damping: float = START
    pending: tuple[float, ...] = ()


@dataclass(frozen=True)
class _Levels:
    """Makes one level after another."""

    problem: ObservedProblem
    prior: Prior
    schedule: Schedule
    calls: Callbacks
    descent: type[Descent]

    def next(self, before: _State) -> _State:
        """The state after one more level; none is to come where simulation or sensitivities overflow, or runs part."""
        pending = before.pending
        if self.calls.enough():
            pending = pending[-1:]
        gain = pending[0]
        self.calls.begin(before.theta, gain)
        ahead = self.problem.residual(before.theta, gain)
        if ahead is None:
            return self._overflown(before)
        state = self._state(before, gain, ahead)
        following = pending[1:]
        if not state.linearise():
            return self._overflown(before)
        done = self._descend(state, gain, last=not following)
        chaotic = bool(following) and gain == self.schedule.chaos_gain and self.calls.is_chaotic(state.theta)
        if chaotic:
            following = ()
            done = self._descend(state, gain, last=True)
        if not following:
            state.linearise()
        error = rms(state.residual)
        levels = (*before.levels, Level(float(gain), state.iterations, error, done))
        reached_last = not (following or chaotic)
        return _State(
            state.theta, state.residual, state.hessian, state.noise, levels, reached_last, chaotic, state.damping,
            following,
        )  # fmt: skip

    def _state(self, before: _State, gain: float, residual: FloatArray) -> Descent:
        return self.descent(
            self.problem, self.prior, gain, self.schedule.noise_inflation, before.theta, before.damping, residual
        )

    def _overflown(self, before: _State) -> _State:
        """The state before, as the last one, with its Hessian."""
        if before.levels:
            state = self._state(before, before.levels[-1].gain, before.residual)
            state.linearise()
            before = replace(before, hessian=state.hessian)
        return replace(before, pending=())

    def _descend(self, state: Descent, gain: float, *, last: bool) -> bool:
        """Take the steps of a level; whether its cost had stopped falling."""
        done = False
        while state.iterations < (self.schedule.last_iterations if last else self.schedule.iterations) and not done:
            if self.calls.enough() and state.iterations >= LEAST_STEPS:
                break
            self.calls.on_progress(gain, rms(state.residual))
            done = not state.step(self.schedule.tolerance if last else 1e-3)
        return done
