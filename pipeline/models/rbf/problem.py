"""The data-driven joint coupled to its training logs by an observer: residuals, Jacobians and their effort.

The effort of a fit is counted in evaluations, not taken by a clock. So the same data and settings end at the same point
on every machine. A cost model of a reference machine (one core of a 2.5 GHz server with other work beside it, and
slower kernels) turns simulations into seconds. Searches for a propeller and a soft arm take 0.5 and 0.6 times this
estimate, fits of a DE joint 0.9 to 1.1 times.
"""

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline

from ...errors import InputError
from ...numerics.arrays import BoolArray, FloatArray, bridged
from ...signals.log import Log
from ...signals.noise import noise_std
from ...signals.resampling import sharpened
from .dynamics import basis_rows, no_sensitivities
from .observed_run import Coupling, Drive, observed_run
from .parameter_layout import ParameterLayout
from .structure import drive_at_nodes, known_inputs, spline_through

PER_SIMULATION = 0.7e-3
"""Cost of a simulation beside its steps: inputs, sums, the solution of the normal equations [s]."""

PER_STEP = 0.45e-6
"""Cost of a step of the data-driven joint [s]."""

PER_SENSITIVITY = 0.054e-6
"""Cost of a step per parameter that is derived by [s]."""


def simulation_effort(steps: int, sensitivities: int = 0) -> float:
    """Seconds of a simulation of so many integration steps, with so many sensitivities."""
    return PER_SIMULATION + steps * (PER_STEP + PER_SENSITIVITY * sensitivities)


@dataclass
class Effort:
    """Limit and spent effort of a fit, in seconds of processor time by the cost model.

    Attributes
    ----------
    limit : float
        Seconds after which work that can wait is left out.
    spent : float
        Seconds so far.
    """

    limit: float = float("inf")
    spent: float = 0.0

    def exhausted(self, share: float = 1.0) -> bool:
        """True once a share of the limit is spent."""
        return self.spent >= share * self.limit


STEP = 0.2
"""Longest integration step, in units of the inverse pace of the joint: at least 30 per period."""

COARSE_STEP = 0.4
"""Longest step where candidates are only compared."""

STABLE = 1.5
"""Longest step in units of the inverse of the fastest relaxation rate; Runge-Kutta would be unstable at 2.8."""

MOST_STEPS = 2000
"""Steps in a sample interval; a device that is faster than that by its frequency scale was not identified from it."""

FASTEST = 100.0
"""Relaxations per sample interval beyond which no step follows; such an element does nothing but damp."""


def steps_per_sample(p: ParameterLayout, interval: float, theta: FloatArray, step: float = STEP) -> int:
    """Integration steps per sample interval that resolve what decays: the velocity by its damping, hidden elements.

    Parameters
    ----------
    p : ParameterLayout
        Structure.
    interval : float
        Sample interval [s].
    theta : FloatArray, shape (P,)
        Its parameters.
    step : float
        Longest step [1/pace].
    """
    c = p.coefficients(theta)
    rows = [p.rows["damping"], *(p.rows[f"relaxation{i}"] for i in range(p.structure.shape_elements))]
    decaying = basis_rows(p.centres, c) @ c.curves[rows].T
    fastest = max(float(decaying.max()), float(c.rates.max(initial=0.0)))
    touching = 0.0
    if p.structure.stops:
        stiffness, resistance = c.stops[2:]
        touching = float(np.sqrt(stiffness)) / COARSE_STEP
        fastest = max(fastest, float(resistance))
    fastest = min(fastest, FASTEST / interval) / STABLE
    rate = max(p.pace / step, min(touching, FASTEST / interval), fastest)
    if interval * rate > MOST_STEPS:
        raise InputError(
            f"the model moves {interval * rate:.3g} steps in a sample interval of {interval:g} s; resample"
        )
    return max(1, int(np.ceil(interval * rate))) * p.refinement


_NUDGE = 1e-9
"""Distance of the second run's start from the first, a share of the range of q."""
_PARTED = 1e-2
"""Share of the range at which two runs have parted: no pulse near a separatrix brings that about by chance."""


@dataclass(frozen=True)
class _Log:
    """A log as it is simulated: every so-many-th sample.

    Attributes
    ----------
    measured, observe : FloatArray, shape (N,)
        x, and the share of it that an observer follows.
    start : float
        Velocity at the first sample [1/s].
    interval : float
        Interval of the simulated samples [s].
    split : int
        Samples in the residual.
    travel : FloatArray, shape (N − 1,), or None
        Mean measured velocity [1/s] of each interval, NaN where it is not known; None without such a channel.
    weight : float
        Time [s] that makes a velocity a displacement.
    inputs : FloatArray
        Inputs, for a lag with those of `past` intervals before.
    past : int
        Intervals before the first sample.
    every : int
        Samples of the inputs in an interval.
    spacing : float
        Interval of these samples [s].
    nodes : dict
        Scaled inputs at every half step, by steps per interval and delay.
    """

    measured: FloatArray
    observe: FloatArray
    start: float
    interval: float
    split: int
    travel: FloatArray | None
    weight: float
    inputs: FloatArray
    past: int
    every: int
    spacing: float
    nodes: dict[tuple[int, float], FloatArray]

    @cached_property
    def spline(self) -> CubicSpline:
        """Spline through the inputs, which a run with a delay reads at other times each time."""
        return spline_through(known_inputs(self.inputs))

    @property
    def in_residual(self) -> BoolArray:
        """Mask of the rows of `compared` that are measured."""
        seen = self.observe[: self.split] > 0.0
        return seen if self.travel is None else np.concatenate((seen, np.isfinite(self.travel[: self.split - 1])))

    def compared(self, x: FloatArray) -> FloatArray:
        """Compared rows of a simulation or its sensitivities: x, then its weighted mean velocity."""
        if self.travel is None:
            return x
        return np.concatenate((x, self.weight / self.interval * np.diff(x, axis=0)))

    def error(self, x: FloatArray) -> FloatArray:
        """Simulated minus measured, the rows that are kept."""
        seen = self.measured[: self.split]
        if self.travel is not None:
            seen = np.concatenate((seen, self.weight * self.travel[: self.split - 1]))
        return np.asarray((self.compared(x) - seen)[self.in_residual])

    def at_nodes(self, p: ParameterLayout, steps: int, delay: float) -> FloatArray:
        """The scaled inputs at every half step, `delay` [s] later."""
        if (steps, delay) in self.nodes:
            return self.nodes[steps, delay]
        hold = p.structure.hold
        spline = self.spline if hold == "cubic" else None
        own = steps if self.every == 1 else 1
        drive = drive_at_nodes(self.inputs, self.spacing, own, hold, delay, spline, squared=p.squares_first)
        if self.every > 1:
            drive = _averaged(drive, self.every)[: 2 * (self.past + len(self.measured)) - 1]
            if steps > 1:
                drive = drive_at_nodes(drive, self.interval / 2.0, steps, "linear")[::2]
        drive = np.ascontiguousarray(drive / p.scales.volts)
        if not p.structure.input_delay:
            self.nodes[steps, delay] = drive
        return drive


class JointProblem:
    """Simulated minus measured x over all valid samples of the training logs (an `ObservedProblem`).

    Coupling gains are in units of the joint's frequency scale.

    Parameters
    ----------
    parameters : ParameterLayout
        The structure.
    records : sequence of Log
        Training logs.
    free_after : float, optional
        Share of each log after which the observer is off whatever its gain: what lies behind is held out of the
        residual, and `held_out` compares it with a free run that starts from the observed state.
    step : float
        Longest integration step, as `STEP`.
    thinning : int
        Where samples are closer than a step, at most every so-many-th is simulated; inputs are then averaged over the
        samples between. A log that moves slowly does not show how fast its device could, so this needs care.
    effort : Effort, optional
        Counts the simulations.
    """

    def __init__(
        self,
        parameters: ParameterLayout,
        records: Sequence[Log],
        free_after: float | None = None,
        *,
        step: float = STEP,
        thinning: int = 1,
        effort: Effort | None = None,
    ) -> None:
        self.parameters = parameters
        self.step = step
        self.effort = effort or Effort()
        self.logs = [_log(parameters, r, free_after, step, thinning) for r in records]

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        """See `ObservedProblem`; dimensionless."""
        parts = []
        for log in self.logs:
            states, _, valid = self._run(theta, log, gain, stop=log.split, sensitive=False)
            if valid < log.split:
                return None
            parts.append(log.error(states[:, 0]))
        return np.concatenate(parts)

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """See `ObservedProblem`."""
        parts = []
        for log in self.logs:
            states, sensitivity, _ = self._run(theta, log, gain, stop=log.split, sensitive=True)
            parts.append((log.error(states[:, 0]), log.compared(sensitivity)[log.in_residual]))
        errors, rows = zip(*parts, strict=True)
        return np.concatenate(errors), np.concatenate(rows)

    def jacobian_effort(self, theta: FloatArray) -> float:
        """Seconds of a Jacobian by the cost model."""
        p = self.parameters
        return sum(
            simulation_effort(log.split * steps_per_sample(p, log.interval, theta, self.step), p.count)
            for log in self.logs
        )

    def is_chaotic(self, theta: FloatArray) -> bool:
        """True if the free run of any log diverges from one that starts beside it."""
        for log in self.logs:
            beside = replace(log, start=log.start + _NUDGE * self.parameters.scales.frequency)
            first, second = (
                self._run(theta, each, 0.0, stop=log.split, sensitive=False)[0][:, 0] for each in (log, beside)
            )
            apart = np.abs(second - first) / 2.0
            if np.isfinite(apart).all() and np.any(apart > _PARTED):
                return True
        return False

    def refined(self) -> "JointProblem":
        """The same, simulated in twice as many steps."""
        other = copy(self)
        other.parameters = replace(self.parameters, refinement=2 * self.parameters.refinement)
        return other

    @property
    def of_displacement(self) -> BoolArray:
        """Mask of the rows of the residual that are errors of x; the others are weighted errors of the velocity."""
        return np.concatenate(
            [
                np.arange(np.count_nonzero(log.in_residual)) < np.count_nonzero(log.observe[: log.split] > 0.0)
                for log in self.logs
            ]
        )

    def held_out(self, theta: FloatArray, gain: float, coupled: float = 0.0) -> list[FloatArray]:
        """Errors behind the split of each log, free or at an observer gain `coupled`; infinite where a run diverged."""
        errors = []
        for log in self.logs:
            observe = log.observe.copy()
            observe[log.split :] *= coupled / gain
            freed = replace(log, observe=observe)
            states, _, _ = self._run(theta, freed, gain, stop=len(log.measured), sensitive=False)
            error = (states[:, 0] - log.measured)[log.split :][log.observe[log.split :] > 0.0]
            errors.append(np.where(np.isfinite(error), error, np.inf))
        return errors

    def _run(
        self,
        theta: FloatArray,
        log: _Log,
        gain: float,
        *,
        stop: int,
        sensitive: bool,
    ) -> tuple[FloatArray, FloatArray, int]:
        p = self.parameters
        steps = steps_per_sample(p, log.interval, theta, self.step)
        skipped = 2 * steps * log.past
        volts = log.at_nodes(p, steps, p.delay(theta))[: skipped + 2 * steps * (stop - 1) + 1]
        u, du = p.acting(volts, log.interval / steps / 2.0, theta)
        u, du = u[skipped:], np.ascontiguousarray(du[:, skipped:])
        wrt = p.sensitivity_parameters(theta) if sensitive else no_sensitivities()
        self.effort.spent += simulation_effort(stop * steps, len(wrt.factor))
        drive = Drive(u, du, p.at_rest(u, theta, begins=log.past == 0), p.held and log.every == 1)
        coupling = Coupling(log.measured[:stop], log.observe[:stop], gain * p.scales.frequency)
        start = (float(log.measured[0]), log.start)
        return observed_run(p.coefficients(theta), drive, coupling, start, log.interval, steps, wrt)


def _log(p: ParameterLayout, record: Log, free_after: float | None, step: float, thinning: int) -> _Log:
    s = p.scales
    hold = p.structure.hold
    past = 0
    every = min(thinning, max(1, int(step / (p.pace * record.interval))))
    measured = bridged((record.q - s.middle) / s.half, record.valid)
    if record.fine is not None:  # then the samples have been low-pass filtered, and runs are not
        measured = sharpened(measured, record.valid)
    measured = measured[::every]
    inputs = record.drive if hold == "record" else record.v
    if record.past is not None and (p.structure.input_lag or p.structure.input_delay):
        before = record.past if hold == "record" or record.past.ndim == 2 else record.past[:, 0]
        past = len(before) // every
        inputs = np.concatenate((before[len(before) - past * every :], inputs))
    travel, weight = _travel(p, record, every)
    return _Log(
        measured=measured,
        observe=record.valid[::every].astype(np.float64),
        start=float(record.qdot[0] / s.half),
        interval=every * record.interval,
        split=len(measured) if free_after is None else int(free_after * len(measured)),
        travel=travel,
        weight=weight,
        inputs=inputs,
        past=past,
        every=every,
        spacing=record.interval,
        nodes={},
    )


def _travel(p: ParameterLayout, record: Log, every: int) -> tuple[FloatArray | None, float]:
    """Mean measured velocity [1/s] over each simulated interval, NaN where it is not known; and its weight [s].

    It is the integral of the cubic with the measured velocity and its slope at the samples. The weight makes errors of
    velocity as large as those of displacement where both are noise. It is at most that of a vibration at the device's
    frequency scale, so that a model that errs is not judged by its velocity alone.
    """
    if record.velocity is None:
        return None, 0.0
    speed = np.where(record.valid, record.velocity, np.nan) / p.scales.half
    slope = record.qddot / p.scales.half
    mean = 0.5 * (speed[:-1] + speed[1:]) + record.interval / 12.0 * (slope[:-1] - slope[1:])
    count = (len(mean) // every) * every
    noise = noise_std(record.q[record.valid]), noise_std(record.velocity[record.valid])
    weight = min(1.0 / p.scales.frequency, noise[0] / noise[1] if noise[1] > 0.0 else np.inf)
    return mean[:count].reshape(-1, every).mean(axis=1), float(weight)


def _averaged(values: FloatArray, every: int) -> FloatArray:
    """Every so-many-th row of a centred average over as many, so that noise between the rows stays out."""
    window = np.ones(every) if every % 2 else np.concatenate(([0.5], np.ones(every - 1), [0.5]))
    padded = np.pad(values, ((len(window) // 2,) * 2, (0, 0)), "edge")
    return np.column_stack([np.convolve(column, window / every, "valid") for column in padded.T])[::every]
