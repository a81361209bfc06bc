"""A whole log: one motion from rest, with the samples that cannot be trusted marked."""

from dataclasses import dataclass

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import BoolArray, FloatArray


@dataclass(frozen=True)
class Record:
    """One log on a uniform time base, gaps included.

    A free run passes through a gap, because the voltages are known there; only the comparison with q leaves it
    out. Hidden states therefore never restart, as they would if a log were cut into stretches.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q, qdot, qddot : FloatArray, shape (N,)
        Displacement and its derivatives [m, m/s, m/s²] or [rad …]; any value where `valid` is false.
    v : FloatArray, shape (N, K)
        Voltages [V], finite everywhere.
    valid : BoolArray, shape (N,)
        False in gaps and in spans that are masked; the first sample is valid.
    fine : FloatArray, shape (N, r, K), optional
        Voltages [V] at r evenly spaced times of each sample interval, the first of which is the sample itself, where
        they are known so finely.
    past : FloatArray, shape (P, K) or (P, r, K), optional
        Voltages [V] of the log before this part of it, as fine as `drive`.
    velocity : FloatArray, shape (N,), optional
        Measured velocity [m/s or rad/s], where there is such a channel; any value where `valid` is false.

    Raises
    ------
    InputError
        Fewer than two samples, voltages that are not finite, a first sample that is not valid.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    v: FloatArray
    valid: BoolArray
    fine: FloatArray | None = None
    past: FloatArray | None = None
    velocity: FloatArray | None = None

    def __post_init__(self) -> None:
        if len(self.t) < 2:
            raise InputError(f"a log of {len(self.t)} samples is too short to identify from; at least 2 are needed")
        if not np.all(np.isfinite(self.drive)):
            raise InputError("a voltage is not finite; interpolate or mask it first")
        if not self.valid[0]:
            raise InputError("the first sample of a log must be valid; cut the log there")

    @property
    def drive(self) -> FloatArray:
        """The voltages [V] as finely as they are known, shape (N, r, K) or (N, K)."""
        return self.v if self.fine is None else self.fine

    @property
    def interval(self) -> float:
        """Sample interval [s]."""
        return float((self.t[-1] - self.t[0]) / (len(self.t) - 1))

    def part(self, start: int, stop: int) -> "Record":
        """The samples from `start` to `stop`."""
        s = slice(start, stop)
        fine = None if self.fine is None else self.fine[s]
        before = [block for block in (self.past, self.drive[:start]) if block is not None and len(block)]
        past = np.concatenate(before) if before else None
        velocity = None if self.velocity is None else self.velocity[s]
        return Record(self.t[s], self.q[s], self.qdot[s], self.qddot[s], self.v[s], self.valid[s], fine, past, velocity)
