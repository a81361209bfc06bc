"""Measured motions with derivatives and inputs: gap-free stretches, and whole logs with their gaps marked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from pipeline.errors import InputError
from pipeline.numerics.arrays import BoolArray, FloatArray, runs_of, sample_interval
from pipeline.signals.timebase import is_uniform

MOST_SAMPLES = 12_000
"""Samples of all logs together that a fit of the joint's equations takes: beyond, every log is cut after as large a
share. It bounds the work, whatever is given: at 10 ms these are 120 s of motion, three logs as the paper's."""

SHORTEST = 5
"""Samples of a stretch: a shorter one carries no dynamics worth a row in a fit."""


@dataclass(frozen=True)
class Trajectory:
    """One gap-free stretch of one log, sampled uniformly; the unit that identification works on.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q, qdot, qddot : FloatArray, shape (N,)
        Displacement, velocity, acceleration [m, m/s, m/s²], or [rad …] for an angle.
    v : FloatArray, shape (N, K) or (N, r, K)
        Voltages [V], K = 1 or 2 (column 0 is the left one), at the samples or at r times of each sample interval.

    Raises
    ------
    InputError
        Shapes that differ, fewer than two samples, samples that are not finite, a time base that is not uniform.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    v: FloatArray

    def __post_init__(self) -> None:
        n = len(self.t)
        if n < 2:
            raise InputError(f"a stretch of {n} samples is too short to identify from; at least 2 are needed")
        if self.v.ndim not in (2, 3) or len(self.v) != n:
            raise InputError(f"the voltages have the shape {self.v.shape}, ({n}, inputs) was expected")
        for name in ("t", "q", "qdot", "qddot", "v"):
            values = getattr(self, name)
            if len(values) != n:
                raise InputError(f"{name} has {len(values)} samples, the time base {n}")
            if not np.all(np.isfinite(values)):
                raise InputError(f"{name} holds samples that are not finite; split the log at its gaps first")
        if not is_uniform(self.t, 1e-6):
            raise InputError("the time base is not uniform; resample the log first")

    @property
    def interval(self) -> float:
        """Sample interval [s]."""
        return sample_interval(self.t)

    def part(self, start: int, stop: int) -> "Trajectory":
        """The samples from `start` to `stop`."""
        s = slice(start, stop)
        return Trajectory(self.t[s], self.q[s], self.qdot[s], self.qddot[s], self.v[s])

    @property
    def known_q(self) -> FloatArray:
        """The displacement, every sample of which is valid, shape (N,)."""
        return self.q


def operating_range(logs: "Sequence[Trajectory | Record]") -> tuple[float, float]:
    """Smallest and largest valid displacement of all stretches or records: q_min, q_max of eq. 39.

    Raises
    ------
    InputError
        No log at all, or a displacement that never changes.
    """
    if not logs:
        raise InputError("there is no training data; name at least one training log with valid samples")
    low, high = min(float(log.known_q.min()) for log in logs), max(float(log.known_q.max()) for log in logs)
    if not high > low:
        raise InputError(f"q is constant ({low:g}) in all training logs; nothing can be identified from it")
    return low, high


@dataclass(frozen=True)
class Record:
    """One log, or a part of one whose inputs are known throughout, on a uniform time base, gaps in q included.

    A free run passes through such a gap; only the comparison with q leaves it out. Hidden states therefore do not
    restart, as they would if a log were cut into stretches.

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
    def known_q(self) -> FloatArray:
        """The valid samples of the displacement, shape (M,)."""
        return self.q[self.valid]

    @property
    def drive(self) -> FloatArray:
        """The voltages [V] as finely as they are known, shape (N, r, K) or (N, K)."""
        return self.v if self.fine is None else self.fine

    @property
    def interval(self) -> float:
        """Sample interval [s]."""
        return sample_interval(self.t)

    def stretches(self) -> list[Trajectory]:
        """The gap-free stretches of at least `SHORTEST` samples, with the voltages as finely as they are known."""
        return [
            Trajectory(self.t[s], self.q[s], self.qdot[s], self.qddot[s], self.drive[s])
            for s in runs_of(self.valid)
            if s.stop - s.start >= SHORTEST
        ]

    def part(self, start: int, stop: int) -> "Record":
        """The samples from `start` to `stop`."""
        s = slice(start, stop)
        fine = None if self.fine is None else self.fine[s]
        before = [block for block in (self.past, self.drive[:start]) if block is not None and len(block)]
        past = np.concatenate(before) if before else None
        velocity = None if self.velocity is None else self.velocity[s]
        return Record(self.t[s], self.q[s], self.qdot[s], self.qddot[s], self.v[s], self.valid[s], fine, past, velocity)


Log = TypeVar("Log", Trajectory, Record)


def within(logs: Sequence[Log], samples: int) -> list[Log]:
    """The first share of every stretch or record, `samples` together; at least `SHORTEST` of each."""
    share = min(1.0, samples / sum(log.t.size for log in logs))
    return [log.part(0, max(int(share * log.t.size), SHORTEST)) for log in logs]


LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Key of a record's notes for spans [s] in which the inputs were not recorded for longer."""


def voltages(table: Mapping[str, FloatArray]) -> FloatArray:
    """The inputs v1, v2 of a table, shape (N, 1) or (N, 2)."""
    return np.column_stack([table[name] for name in ("v1", "v2") if name in table])


def peaks(v: FloatArray, *, joint: bool) -> FloatArray:
    """Largest magnitude of each input, shape (K,), against which its steps and rests are seen.

    Of the joint, whose voltages are of one kind, the larger one of both; of another device each input's own, but not
    less than a twentieth of the largest, so that the noise of an unused one is no step.
    """
    own: FloatArray = np.max(np.abs(v), axis=0, initial=0.0)
    largest = float(np.max(own, initial=0.0))
    return np.full_like(own, largest) if joint else np.maximum(own, 0.05 * largest)


def unknown_rows(t: FloatArray, spans: Sequence[Sequence[float]]) -> BoolArray:
    """Rows strictly inside `spans` [s] without inputs, shape (N,)."""
    inside = np.zeros(len(t), dtype=np.bool_)
    for start, stop in spans:
        inside[np.searchsorted(t, start, side="right") : np.searchsorted(t, stop)] = True
    return inside
