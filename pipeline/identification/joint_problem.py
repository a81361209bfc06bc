"""The data-driven joint tied to its training logs: residuals and Jacobians of the displacement."""

from collections.abc import Sequence

import numpy as np

from pipeline.identification.joint_parameters import JointParameters
from pipeline.identification.relaxing_joint import no_directions, observed_run
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.record import Record

STEP = 0.1
"""Longest integration step, in units of the inverse frequency scale: at least 60 per period."""

COARSE_STEP = 0.2
"""The same where candidates are only compared."""


def steps_per_sample(p: JointParameters, interval: float, step: float = STEP) -> int:
    """Integration steps per sample interval [s] that are no longer than `step`."""
    return max(1, int(np.ceil(interval * p.scales.frequency / step)))


def bridged(values: FloatArray, valid: FloatArray) -> FloatArray:
    """`values` with the samples that are not valid replaced by a line across them."""
    samples = np.arange(len(values))
    keep = valid > 0.0
    return np.interp(samples, samples[keep], values[keep])


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
    """

    def __init__(
        self,
        parameters: JointParameters,
        records: Sequence[Record],
        free_after: float | None = None,
        *,
        step: float = STEP,
    ) -> None:
        self.parameters, self.step = parameters, step
        self.records = records
        self.splits = [len(r.t) if free_after is None else int(free_after * len(r.t)) for r in records]
        s = parameters.scales
        self.observe = [r.valid.astype(np.float64) for r in records]
        self.measured = [
            bridged((r.q - s.middle) / s.half, valid) for r, valid in zip(records, self.observe, strict=True)
        ]

    def residual(self, theta: FloatArray, gain: float) -> FloatArray | None:
        """See `ObservedProblem`; dimensionless."""
        parts = []
        for i, record in enumerate(self.records):
            states, _, valid = self._run(theta, i, gain, stop=self.splits[i], sensitive=False)
            if valid < self.splits[i]:
                return None
            keep = record.valid[: self.splits[i]]
            parts.append((states[:, 0] - self.measured[i][: self.splits[i]])[keep])
        return np.concatenate(parts)

    def jacobian(self, theta: FloatArray, gain: float) -> tuple[FloatArray, FloatArray]:
        """See `ObservedProblem`."""
        parts, rows = [], []
        for i, record in enumerate(self.records):
            states, sensitivity, _ = self._run(theta, i, gain, stop=self.splits[i], sensitive=True)
            keep = record.valid[: self.splits[i]]
            parts.append((states[:, 0] - self.measured[i][: self.splits[i]])[keep])
            rows.append(sensitivity[keep])
        return np.concatenate(parts), np.concatenate(rows)

    def held_out(self, theta: FloatArray, gain: float) -> list[FloatArray]:
        """Free-run errors behind the split of each log; infinite where the run diverged."""
        errors = []
        for i, record in enumerate(self.records):
            split = self.splits[i]
            observe = self.observe[i].copy()
            observe[split:] = 0.0
            states, _, _ = self._run(theta, i, gain, stop=len(record.t), sensitive=False, observe=observe)
            error = (states[:, 0] - self.measured[i])[split:][record.valid[split:]]
            errors.append(np.where(np.isfinite(error), error, np.inf))
        return errors

    def _run(
        self, theta: FloatArray, i: int, gain: float, *, stop: int, sensitive: bool, observe: FloatArray | None = None
    ) -> tuple[FloatArray, FloatArray, int]:
        p, record = self.parameters, self.records[i]
        steps = steps_per_sample(p, record.interval, self.step)
        u, du = p.inputs(record.v[:stop], record.interval, steps, theta)
        tie = gain * p.scales.frequency
        start = (float(self.measured[i][0]), float(record.qdot[0] / p.scales.half))
        along = p.directions(theta) if sensitive else no_directions()
        seen = self.observe[i] if observe is None else observe
        return observed_run(
            u, du, self.measured[i][:stop], seen[:stop], tie, start, record.interval, steps,
            p.coefficients(theta), along,
        )  # fmt: skip
