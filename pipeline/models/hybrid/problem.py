"""The condensed joint coupled to its training logs by an observer: residuals and Jacobians of the displacement.

θ holds deviations from the parameter set (`pipeline.models.hybrid.parameters.DEVIATIONS`), then the weights of the
RBF corrections, all in prior standard deviations.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.interpolate import CubicSpline

from ...device.parameters import JointParameters
from ...fitting.descent import PARAMETER_STEP
from ...generated.condensed_joint import CONSTANTS
from ...numerics.arrays import BoolArray, FloatArray, samples_of
from ...signals.log import Log
from ...signals.resampling import sharpened
from . import parameters as condensed_parameters
from .kernels import CURVES, INDEX
from .log_reading import SAME, AngleReading, DrivingVoltages, Instruments, Similarity
from .runs import Driving, Followed, JointCoefficients, Stepping, run_joints
from .sensitivity import sensitivities
from .statics import substeps
from .variational import INSTRUMENTS, Driven

DEVIATION_COUNT = len(condensed_parameters.NAMES)
"""Leading entries of θ that are deviations."""

FARTHEST = 6.0
"""Deviations [prior standard deviations] beyond which a trial is refused: the constants would describe another
machine."""

LOST_ERROR_SHARE = 0.1
CAUGHT_ERROR_SHARE = 0.02
"""Shares of the range of q: a run that errs by more has lost the log, and did so after it last erred by less."""

HELD_POLE = 15.0
HELD_ON = 0.3
"""Pole [1/s] of the observer that holds a run where it would lose its log, and how long [s] it does so from there."""

POLES = (60.0, 30.0, 8.0, 2.0, 0.0)
"""Observer poles [1/s] in turn: from above the joint's 18 1/s, where each sample stands alone, to the free run."""

SETTLING = 1.0
"""Time [s] for which a run is held first where the log begins in motion, and from which on it is compared: shape and
strains are not known there."""

CONFINED = 1.5
"""Largest displacements of the training logs at which a wall confines every run. Fitted energies are polynomials. One
of 17 simulated joints had places of rest from 1.8 of them on, and a free run stayed there for a third of its log."""

USED = 60.0
"""Time [s] of motion after which a joint is taken as softened as it gets: logs are about as long."""

PASSES = 12
"""Largest number of runs of a log in the search for places where runs lose it."""

LONGEST_RECORDING = 3600.0
"""Largest time stamp [s] that is taken as the time since a recording began; a larger one counts from an epoch."""

BRIDGED = 0.03
"""Gap [s] in a log over which a spline is as good as a measurement."""

SETTLED = 3.0
"""Times 1/pole after a longer one, after which a run that is held has forgotten it."""


@dataclass(frozen=True)
class CondensedJoint:
    """Structure of the hybrid joint: parameter set and RBF basis.

    Attributes
    ----------
    parameters : JointParameters
        The parameter set; its mass is the moving mass.
    basis : FloatArray, shape (3,)
        First centre, distance of the centres, width σ [m], of the device.
    centres : int
        M; 0 for the analytical joint without corrections.
    largest_voltage : float
        Largest voltage [V] of the training logs; the free run holds larger ones at twice that.
    slope_ratio : float
        τ / Q of slow motions.
    similarity : Similarity
        The device in units of the set's joint.
    rotation : FloatArray, shape (K, 2)
        q [m] and φ [rad] at rest, by which the angle was made a displacement; of no rows where q was measured.
    """

    parameters: JointParameters
    basis: FloatArray
    centres: int
    largest_voltage: float
    slope_ratio: float
    similarity: Similarity = SAME
    rotation: FloatArray = field(default_factory=lambda: np.empty((0, 2)))

    @property
    def angle(self) -> AngleReading | None:
        """Reading of the log's displacement from an angle; None where q itself was measured."""
        return AngleReading(self.rotation, self.lead) if len(self.rotation) else None

    def reading(self, log: Log) -> Log:
        """A log as the equations read it."""
        return self.angle.log(log) if self.angle else log

    def constants(self, theta: FloatArray) -> FloatArray:
        """The kernel's constants, shape (…, len(CONSTANTS)), of one θ or of several, shape (…, P)."""
        of_set = condensed_parameters.constants(self.parameters, theta[..., :DEVIATION_COUNT], self.slope_ratio)
        return of_set * self.similarity.constants

    def in_use(self, theta: FloatArray) -> FloatArray:
        """The same of a joint that has moved for `USED` and softens no more, as a controller meets it."""
        k = self.constants(theta)
        softer = 1.0 - k[..., INDEX["softening"]] * (1.0 - np.exp(-k[..., INDEX["softening_rate"]] * USED))
        k[..., [INDEX["left_elastic"], INDEX["right_elastic"]]] *= softer[..., None]
        k[..., INDEX["softening"]] = 0.0
        return k

    def weights(self, theta: FloatArray) -> FloatArray:
        """Weights of the corrections [SI], shape (…, CURVES, M)."""
        shares = theta[..., DEVIATION_COUNT:].reshape(*theta.shape[:-1], CURVES, self.centres)
        widths = condensed_parameters.correction_prior_std(self.parameters) * self.similarity.weights
        return np.ascontiguousarray(shares * widths[:, None])

    def instruments(self, theta: FloatArray) -> Instruments:
        """Instruments between the joint and the log."""
        own = condensed_parameters.OF_INSTRUMENTS
        offset, delay, charging, *probe = (theta[own] * condensed_parameters.PRIOR_STD[own]).tolist()
        units = self.similarity
        return Instruments(
            offset=units.origin + units.length * offset,
            delay=units.time * delay,
            charging=units.time * (condensed_parameters.CHARGING_TIME * math.exp(charging)),
            probe=units.voltage * np.array(probe),
        )

    def derivatives(self, theta: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Derivatives by θ of the numbers that a run takes.

        Of the constants (C, P); of laser offset [m], and of delay, charging time and probes in units of θ, (5, P); and
        the prior widths (9,) of the weights.
        """
        count = len(theta)
        moved = PARAMETER_STEP * np.eye(DEVIATION_COUNT, count)
        constants = np.zeros((len(CONSTANTS), count))
        changes = self.constants(theta + moved) - self.constants(theta - moved)
        constants[:, :DEVIATION_COUNT] = changes.T / (2.0 * PARAMETER_STEP)
        instruments = np.zeros((INSTRUMENTS, count))
        instruments[range(INSTRUMENTS), condensed_parameters.OF_INSTRUMENTS] = 1.0
        instruments[0] *= self.instruments(np.ones(count)).offset - self.similarity.origin
        return (
            constants,
            instruments,
            condensed_parameters.correction_prior_std(self.parameters) * self.similarity.weights,
        )

    def substeps(self, theta: FloatArray, dt: float) -> int:
        """Runge-Kutta steps in a sample interval of `dt` [s]."""
        return substeps(self.constants(theta), self.basis, self.weights(theta), dt, self.similarity.time)

    @property
    def length(self) -> float:
        """Length of the beam [m]."""
        return self.parameters.l * self.similarity.length

    @property
    def q_stop(self) -> float:
        """Displacement [m] of the wall that confines every run: `CONFINED` reaches of the data, or half the length."""
        return min(0.5 * self.length, CONFINED * float(-self.basis[0]))

    @property
    def lead(self) -> float:
        """dτ/dq [1/m] of slow motions."""
        return self.slope_ratio / self.length

    def stepping(self, dt: float, steps: int) -> Stepping:
        """Steps of a run of this joint, so many in a sample interval `dt` [s]."""
        return Stepping(
            dt=dt,
            substeps=steps,
            wall=self.q_stop,
            lead=self.lead,
            reading=(0.0, 1.0 / self.lead) if self.angle else (1.0, 0.0),
        )

    def start(self) -> FloatArray:
        """θ where an estimation starts: the parameter set with typical friction, creep and relaxation."""
        return np.zeros(DEVIATION_COUNT + CURVES * self.centres)


class CondensedProblem:
    """Simulated minus measured q [mm] over the valid samples of all logs (an `ObservedProblem`); gains are poles [1/s].

    Every log starts from rest. Cost: a residual is one run of each log; a Jacobian takes as long as five to eight
    batches of eight runs.

    Parameters
    ----------
    joint : CondensedJoint
    records : sequence of Log
        Training logs.
    fitted : callable
        Number of a log's samples that are compared; the rest is held out.
    from_start : bool
        Compare a log that begins in motion from its first sample on, too, where an observer holds the run anyway.
    """

    def __init__(
        self,
        joint: CondensedJoint,
        records: Sequence[Log],
        fitted: Callable[[int], int] = lambda samples: samples,
        *,
        from_start: bool = False,
    ) -> None:
        self.joint = joint
        self._steps = 1
        self.logs = [_Log(record, fitted(len(record.t)), 0 if from_start else _settling(record)) for record in records]

    def hold_lost(self, theta: FloatArray, gain: float) -> None:
        """Find where runs with θ lose their logs, and hold them to these there from now on, and nowhere else.

        A pulse that ends in the other well is no error that a linearisation could mend.
        """
        for log in self.logs:
            log.hold_lost(self.joint, theta, gain, self._substeps(theta, log.dt))

    @property
    def held_share(self) -> float:
        """Share of the samples near which runs are held."""
        return float(np.mean(np.concatenate([log.held & ~log.settling for log in self.logs])))

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        """See `ObservedProblem`."""
        if np.any(np.abs(theta[:DEVIATION_COUNT]) > FARTHEST):
            return None
        error = np.concatenate(
            [
                log.errors(self.joint, theta[None], gain, self._substeps(theta, log.dt))[0, log.compared(gain)]
                for log in self.logs
            ]
        )
        return error if np.all(np.isfinite(error)) else None

    def residuals(self, thetas: FloatArray, gain: float) -> FloatArray:
        """Residuals of several θ side by side, (B, N), with the steps of the last Jacobian; NaN where one is refused.

        Eight cost what one does.
        """
        errors = np.concatenate(
            [log.errors(self.joint, thetas, gain, self._steps)[:, log.compared(gain)] for log in self.logs], axis=1
        )
        errors[np.any(np.abs(thetas[:, :DEVIATION_COUNT]) > FARTHEST, axis=1)] = np.nan
        return errors

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """See `ObservedProblem`; a column without finite derivatives is zero there."""
        parts = []
        self._steps = 1
        for log in self.logs:
            self._steps = self._substeps(theta, log.dt)
            parts.append(log.sensitivities(self.joint, theta, gain, self._steps))
        errors, columns = zip(*parts, strict=True)
        joined = columns[0] if len(columns) == 1 else np.concatenate(columns)
        if not np.isfinite(joined.sum()):
            joined[~np.isfinite(joined)] = 0.0
        return np.concatenate(errors), joined

    def held_out(self, theta: FloatArray, gain: float) -> FloatArray:
        """Errors [mm] over the held-out ends, coupled to the measurement with the pole `gain` [1/s]."""
        return np.concatenate(
            [
                log.errors(self.joint, theta[None], gain, self._substeps(theta, log.dt))[0, log.held_out]
                for log in self.logs
            ]
        )

    def _substeps(self, theta: FloatArray, dt: float) -> int:
        """Steps in a sample interval, never fewer than at the last Jacobian, with whose point a trial is compared."""
        return max(self._steps, self.joint.substeps(theta, dt))


class _Log:
    """One record, with its voltages and a spline of the displacement that the observer follows."""

    def __init__(self, record: Log, stop: int, settling: int) -> None:
        self.dt = record.interval
        self.t = record.t - record.t[0]
        behind = np.arange(len(self.t)) >= stop
        self.settling = np.arange(len(self.t)) < settling
        self.fitted = record.valid & ~behind & ~self.settling
        self.held_out = record.valid & behind
        self.v = DrivingVoltages(record.drive, self.dt)
        self.q = np.interp(self.t, self.t[record.valid], record.q[record.valid])
        if self.v.refined:  # then the samples have been low-pass filtered, and runs are not
            self.q = sharpened(self.q, record.valid)
        self._path = CubicSpline(self.t[record.valid], self.q[record.valid])
        self._start = np.array([self.q[0], 0.0, age_at(record.t)])
        self._seen, self._seen_for = _visibility(record.valid, self.dt)
        self.held = self.settling.copy()
        self._followed: dict[int, FloatArray] = {}

    def hold_lost(self, joint: CondensedJoint, theta: FloatArray, gain: float, steps: int) -> None:
        """See `CondensedProblem.hold_lost`."""
        self.held = self.settling.copy()
        span = 1e3 * (self.q[self.fitted].max() - self.q[self.fitted].min())
        for _ in range(PASSES):
            error = np.abs(self.errors(joint, theta[None], gain, steps)[0]) / span
            diverged = np.flatnonzero(~(error < LOST_ERROR_SHARE) & self.fitted & ~self.held)
            if not len(diverged):
                return
            first = max(np.flatnonzero(error[: diverged[0] + 1] < CAUGHT_ERROR_SHARE), default=0)
            self.held[first : diverged[0] + samples_of(HELD_ON, self.dt)] = True

    def compared(self, gain: float) -> BoolArray:
        """Samples at which an observer with this pole has made up for what happened while the laser saw nothing."""
        return self.fitted & (gain * self._seen_for >= SETTLED * (1.0 - 1e-9)) if gain > 0.0 else self.fitted

    def errors(self, joint: CondensedJoint, thetas: FloatArray, gain: float, steps: int) -> FloatArray:
        """Simulated minus measured q [mm] of several θ, shape (B, N)."""
        pole, path = self._observer(gain, steps)
        runs = simulate(
            joint,
            thetas,
            lambda seen: self.v.squared(steps, seen, joint.largest_voltage),
            self._start,
            Followed(path, pole),
            joint.stepping(self.dt, steps),
        )
        return np.asarray((runs[:, :, 0] - self.q) * 1e3)

    def sensitivities(
        self, joint: CondensedJoint, theta: FloatArray, gain: float, steps: int
    ) -> tuple[FloatArray, FloatArray]:
        """Errors [mm] of one θ over the samples that are compared, shape (N,), and their derivatives by it, (N, P)."""
        pole, path = self._observer(gain, steps)
        seen = joint.instruments(theta)
        constants, instruments, widths = joint.derivatives(theta)
        u = self.v.squared(steps, seen, joint.largest_voltage)
        moved = theta + PARAMETER_STEP * np.eye(len(theta))[condensed_parameters.OF_INSTRUMENTS[1:]]
        later = np.array([self.v.squared(steps, joint.instruments(each), joint.largest_voltage) for each in moved])
        driven = Driven(
            squares=u,
            by_instruments=(later - u) / PARAMETER_STEP,
            observed=path,
            pole=np.repeat(pole, 2 * steps) if len(path) else path,
            start=self._start,
        )
        q, columns, by_weights = sensitivities(
            JointCoefficients(joint.constants(theta), joint.weights(theta), joint.basis),
            np.abs(constants).max(axis=1),
            widths,
            seen.offset,
            driven,
            joint.stepping(self.dt, steps),
        )
        at = self.compared(gain)
        chain = 1e3 * np.concatenate([constants[np.any(constants, axis=1)], instruments])
        by = (columns if at.all() else columns[at]) @ chain
        by[:, DEVIATION_COUNT:] += 1e3 * (by_weights[at] * widths[:, None]).reshape(by[:, DEVIATION_COUNT:].shape)
        by += 1e3 * instruments[0]  # the reading is q + offset
        return 1e3 * (q[at] + seen.offset - self.q[at]), by

    def _observer(self, gain: float, steps: int) -> tuple[FloatArray, FloatArray]:
        """Pole [1/s] of the observer in each sample interval, and what it follows, nothing where it never does."""
        pole = np.where(self._seen, np.where(self.held, max(gain, HELD_POLE), gain), 0.0)
        if not np.any(pole > 0.0):
            return pole, np.zeros(0)
        if steps not in self._followed:
            self._followed[steps] = self._path(np.linspace(0.0, self.t[-1], 2 * steps * (len(self.t) - 1) + 1))
        return pole, self._followed[steps]


def age_at(t: FloatArray) -> float:
    """Time [s] for which a joint has been recorded at the first of these time stamps; 0 where they do not show it."""
    first = float(t[0])
    return first if 0.0 < first <= LONGEST_RECORDING else 0.0


def _settling(record: Log) -> int:
    """Samples of a record until its state is known, none where it begins at rest."""
    return min(samples_of(SETTLING, record.interval), len(record.t) // 2) if record.moves_at_first else 0


def _visibility(valid: BoolArray, dt: float) -> tuple[BoolArray, FloatArray]:
    """Mask of the sample intervals [dt] along which an observer may follow, and the time [s] for which it could.

    A gap of up to `BRIDGED` is followed along the spline over it. Beyond, where the joint may have turned, a run is
    free: pulled along a bridge it would be pulled astray.
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[True], valid, [True]]).astype(np.int8)))
    seen = np.ones(len(valid), dtype=bool)
    seen_for = np.full(len(valid), np.inf)
    for first, stop in edges.reshape(-1, 2):
        if (stop - first) * dt > BRIDGED:
            seen[max(first - 1, 0) : stop] = False
            seen_for[first:] = dt * (np.arange(first, len(valid)) - stop)
    return seen, seen_for


def simulate(
    joint: CondensedJoint,
    thetas: FloatArray,
    inputs: Callable[[Instruments], FloatArray],
    start: FloatArray,
    followed: Followed,
    stepping: Stepping,
    *,
    every_step: bool = False,
    built: tuple[FloatArray, FloatArray] | None = None,
) -> FloatArray:
    """Runs of several θ through one log, as the laser reads them, shape (B, N, 3); see `run_joints`.

    Parameters
    ----------
    joint : CondensedJoint
        Structure.
    thetas : FloatArray, shape (B, P)
        Parameter vectors.
    inputs : callable
        Instruments → squared voltages [V²] on the half steps, shape (2 substeps (N − 1) + 1, 2).
    start : FloatArray, shape (3,) or (B, 3)
        Reading [m] and its rate [m/s] at the first sample, and the time [s] since the recording began.
    followed : Followed
        Measurement that an observer follows.
    stepping : Stepping
        Steps of the run.
    every_step : bool
        Return every Runge-Kutta step.
    built : (FloatArray, FloatArray), optional
        Constants (B, len(CONSTANTS)) and weights (B, 9, M) of the joints, where they are known already.
    """
    constants, weights = built or (joint.constants(thetas), joint.weights(thetas))
    seen = [joint.instruments(theta) for theta in thetas]
    keys = [(instrument.delay, instrument.charging, *instrument.probe) for instrument in seen]
    different = list(dict.fromkeys(keys))
    driving = Driving(
        np.array([inputs(seen[keys.index(key)]) for key in different]),
        np.array([different.index(key) for key in keys]),
        np.array([instrument.offset for instrument in seen]),
        start,
    )
    return run_joints(
        JointCoefficients(constants, weights, joint.basis), driving, followed, stepping, every_step=every_step
    )
