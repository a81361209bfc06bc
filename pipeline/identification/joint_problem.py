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
"""Longest integration step, in units of the inverse frequency scale: at least 30 per period; half of it where an
element relaxes faster than `FAST` times that scale."""

COARSE_STEP = 0.4
"""The same where candidates are only compared."""

FAST = 5.0


def steps_per_sample(p: JointParameters, interval: float, step: float = STEP) -> int:
    """Integration steps per sample interval [s] that are no longer than `step`."""
    return max(1, int(np.ceil(interval * p.scales.frequency / longest_step(p, step))))


def longest_step(p: JointParameters, step: float) -> float:
    """The step for a structure."""
    return 0.5 * step if max(p.structure.rates, default=0.0) > FAST else step


def bridged(values: FloatArray, valid: FloatArray) -> FloatArray:
    """`values` with the samples that are not valid replaced by a line across them."""
    samples = np.arange(len(values))
    keep = valid > 0.0
    return np.interp(samples, samples[keep], values[keep])


@dataclass(frozen=True)
class _Log:
    """A log as it is simulated: every so-many-th sample.

    measured, observe (N,): x and the share of the observer that acts · start: velocity [1/s] · interval [s] · steps per
    interval · split: samples in the residual · v: inputs at the samples, for a delay · nodes: scaled inputs at every
    half step · held: whether they jump at the samples.
    """

    measured: FloatArray
    observe: FloatArray
    start: float
    interval: float
    steps: int
    split: int
    v: FloatArray
    nodes: FloatArray
    held: bool


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
    thinned : bool
        Whether only every so-many-th sample is simulated where samples are closer than half a step; inputs are then
        averaged over the samples between.
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
        thinned: bool = False,
        effort: Effort | None = None,
    ) -> None:
        self.parameters, self.effort = parameters, effort or Effort()
        self.logs = [_log(parameters, r, free_after, step, thinned=thinned) for r in records]

    @property
    def integration_steps(self) -> int:
        """Integration steps of one residual."""
        return sum(log.split * log.steps for log in self.logs)

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
        if p.structure.input_delay:
            u, du = p.inputs(log.v[:stop], log.interval, log.steps, theta)
        else:
            nodes = log.nodes[: 2 * log.steps * (stop - 1) + 1]
            u, du = p.acting(nodes, log.interval / log.steps / 2.0, theta)
        along = p.directions(theta) if sensitive else no_directions()
        self.effort.spend(stop * log.steps, len(along.kind))
        return observed_run(
            u, du, log.measured[:stop], seen[:stop], gain * p.scales.frequency, (float(log.measured[0]), log.start),
            log.interval, log.steps, p.coefficients(theta), along, p.at_rest(u, theta), log.held,
        )  # fmt: skip


def _log(p: JointParameters, record: Record, free_after: float | None, step: float, *, thinned: bool) -> _Log:
    s, hold = p.scales, p.structure.hold
    every = max(1, int(longest_step(p, step) / (s.frequency * record.interval))) if thinned else 1
    interval = every * record.interval
    observe = record.valid[::every].astype(np.float64)
    measured = bridged((record.q - s.middle) / s.half, record.valid.astype(np.float64))[::every]
    steps = steps_per_sample(p, interval, step)
    known = record.drive if hold == "record" else record.v
    if every == 1:
        v, nodes = known, drive_at_nodes(known, record.interval, steps, hold)
    else:
        v = _averaged(known.reshape(len(known), -1, record.v.shape[1]).mean(axis=1), every)
        nodes = _averaged(drive_at_nodes(known, record.interval, 1, hold), every)
        v, nodes = v[: len(measured)], nodes[: 2 * len(measured) - 1]
    split = len(measured) if free_after is None else int(free_after * len(measured))
    return _Log(
        measured, observe, float(record.qdot[0] / s.half), interval, steps, split,
        np.ascontiguousarray(v), np.ascontiguousarray(nodes / s.volts),
        p.held and every == 1,
    )  # fmt: skip


def _averaged(values: FloatArray, every: int) -> FloatArray:
    """Every so-many-th row of a moving average over as many, so that noise between the rows stays out."""
    window, reach = np.ones(every) / every, ((every - 1) // 2, every // 2)
    smooth = [np.convolve(np.pad(column, reach, "edge"), window, "valid") for column in values.T]
    return np.column_stack(smooth)[::every]
