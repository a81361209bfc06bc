"""The data-driven joint tied to its training logs: residuals and Jacobians of the displacement."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pipeline.identification.effort import Effort
from pipeline.identification.input_path import drive_at_nodes
from pipeline.identification.joint_parameters import JointParameters
from pipeline.identification.relaxing_joint import no_directions, observed_run
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.record import Record

STEP = 0.2
"""Longest integration step, in units of the inverse frequency scale: at least 30 per period."""

COARSE_STEP = 0.4
"""The same where candidates are only compared."""

STABLE = 1.5
"""Longest step in units of the inverse of the fastest relaxation rate; Runge-Kutta would be unstable at 2.8."""


FASTEST = 100.0
"""Relaxations per sample interval beyond which no step follows; such an element does nothing but damp."""


def steps_per_sample(p: JointParameters, interval: float, theta: FloatArray, step: float = STEP) -> int:
    """Integration steps per sample interval [s] that are no longer than `step` and resolve the relaxation rates."""
    fastest = float(np.exp(theta[p.slices["rate"]]).max(initial=0.0))
    return max(1, int(np.ceil(interval * max(p.scales.frequency / step, min(fastest, FASTEST / interval) / STABLE))))


def bridged(values: FloatArray, valid: FloatArray) -> FloatArray:
    """`values` with the samples that are not valid replaced by a line across them."""
    samples = np.arange(len(values))
    keep = valid > 0.0
    return np.interp(samples, samples[keep], values[keep])


@dataclass(frozen=True)
class _Log:
    """A log as it is simulated: every so-many-th sample.

    measured, observe (N,): x and the share of the observer that acts · start: velocity [1/s] · interval [s] · split:
    samples in the residual · known: inputs, those of `past` intervals before included for a lag · every: their samples
    per interval · spacing: their interval [s] · nodes: scaled inputs at every half step, by steps per interval.
    """

    measured: FloatArray
    observe: FloatArray
    start: float
    interval: float
    split: int
    known: FloatArray
    past: int
    every: int
    spacing: float
    nodes: dict[int, FloatArray]

    def at_nodes(self, p: JointParameters, steps: int) -> FloatArray:
        """The scaled inputs at every half step."""
        if steps not in self.nodes:
            hold, rows = p.structure.hold, self.past + len(self.measured)
            if self.every == 1:
                drive = drive_at_nodes(self.known, self.spacing, steps, hold)
            else:
                drive = _averaged(drive_at_nodes(self.known, self.spacing, 1, hold), self.every)[: 2 * rows - 1]
                if steps > 1:
                    drive = drive_at_nodes(drive, self.interval / 2.0, steps, "linear")[::2]
            self.nodes[steps] = np.ascontiguousarray(drive / p.scales.volts)
        return self.nodes[steps]


class JointProblem:
    """Simulated minus measured x over all valid samples of the training logs (an `ObservedProblem`).

    Observer gains are in units of the joint's frequency scale.

    Parameters
    ----------
    parameters : JointParameters
        The structure.
    records : sequence of Record
        Training logs.
    free_after : float, optional
        Share of each log after which the observer is off whatever its gain: what lies behind is held out of the
        residual, and `held_out` compares it with a free run that starts from the observed state.
    step : float
        Longest integration step, as `STEP`.
    thinning : int
        Where samples are closer than a step, at most every so-many-th is simulated; inputs are then averaged over the
        samples between. A log that moves slowly says little of how fast its device could, so this needs care.
    effort : Effort, optional
        Counts the simulations.
    """

    def __init__(
        self,
        parameters: JointParameters,
        records: Sequence[Record],
        free_after: float | None = None,
        *,
        step: float = STEP,
        thinning: int = 1,
        effort: Effort | None = None,
    ) -> None:
        self.parameters, self.step, self.effort = parameters, step, effort or Effort()
        self.logs = [_log(parameters, r, free_after, step, thinning) for r in records]

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        """See `ObservedProblem`; dimensionless."""
        parts = []
        for log in self.logs:
            states, _, valid = self._run(theta, log, gain, stop=log.split, sensitive=False)
            if valid < log.split:
                return None
            parts.append((states[:, 0] - log.measured[: log.split])[log.observe[: log.split] > 0.0])
        return np.concatenate(parts)

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """See `ObservedProblem`."""
        parts, rows = [], []
        for log in self.logs:
            states, sensitivity, _ = self._run(theta, log, gain, stop=log.split, sensitive=True)
            keep = log.observe[: log.split] > 0.0
            parts.append((states[:, 0] - log.measured[: log.split])[keep])
            rows.append(sensitivity[keep])
        return np.concatenate(parts), np.concatenate(rows)

    def held_out(self, theta: FloatArray, gain: float) -> list[FloatArray]:
        """Free-run errors behind the split of each log; infinite where the run diverged."""
        errors = []
        for log in self.logs:
            observe = log.observe.copy()
            observe[log.split :] = 0.0
            states, _, _ = self._run(theta, log, gain, stop=len(log.measured), sensitive=False, observe=observe)
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
        observe: FloatArray | None = None,
    ) -> tuple[FloatArray, FloatArray, int]:
        p, seen = self.parameters, log.observe if observe is None else observe
        steps = steps_per_sample(p, log.interval, theta, self.step)
        skipped, count = 2 * steps * log.past, 2 * steps * (stop - 1) + 1
        if p.structure.input_delay:
            u, du = p.inputs(log.known[: log.past + stop], log.interval, steps, theta)
        else:
            u, du = p.acting(log.at_nodes(p, steps)[: skipped + count], log.interval / steps / 2.0, theta)
        if skipped:
            u, du = u[skipped:], np.ascontiguousarray(du[:, skipped:])
        along = p.directions(theta) if sensitive else no_directions()
        self.effort.spend(stop * steps, len(along.kind))
        return observed_run(
            u, du, log.measured[:stop], seen[:stop], gain * p.scales.frequency, (float(log.measured[0]), log.start),
            log.interval, steps, p.coefficients(theta), along, p.at_rest(u, theta, begins=log.past == 0),
            p.held and log.every == 1,
        )  # fmt: skip


def _log(p: JointParameters, record: Record, free_after: float | None, step: float, thinning: int) -> _Log:
    s, hold, past = p.scales, p.structure.hold, 0
    every = min(thinning, max(1, int(step / (s.frequency * record.interval)))) if not p.structure.input_delay else 1
    observe = record.valid[::every].astype(np.float64)
    measured = bridged((record.q - s.middle) / s.half, record.valid.astype(np.float64))[::every]
    known = record.drive if hold == "record" else record.v
    if record.past is not None and (p.structure.input_lag or p.structure.input_delay):
        before = record.past if hold == "record" or record.past.ndim == 2 else record.past[:, 0]
        past = len(before) // every
        known = np.concatenate((before[len(before) - past * every :], known))
    split = len(measured) if free_after is None else int(free_after * len(measured))
    start, interval = float(record.qdot[0] / s.half), every * record.interval
    return _Log(measured, observe, start, interval, split, known, past, every, record.interval, {})


def _averaged(values: FloatArray, every: int) -> FloatArray:
    """Every so-many-th row of a moving average over as many, so that noise between the rows stays out."""
    window, reach = np.ones(every) / every, ((every - 1) // 2, every // 2)
    smooth = [np.convolve(np.pad(column, reach, "edge"), window, "valid") for column in values.T]
    return np.column_stack(smooth)[::every]
