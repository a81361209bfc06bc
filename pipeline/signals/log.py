"""A log, raw with a time base for each signal, then on a uniform one: what all of the program takes; its corrections.

A log has parts between which its inputs were not recorded, so that nobody knows what the device did there. A short hole
is bridged by a straight line; behind a longer one fits and free runs start anew, as at the beginning of a log.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..errors import InputError
from ..numerics.arrays import BoolArray, FloatArray, IntArray, runs_of, sample_interval
from .columns import Signal
from .findings import Remark

SHORTEST = 5
"""Samples of a segment: a shorter one carries no dynamics worth a row in a fit."""

EDGE = 10
"""Samples at the ends of a log at which a derivative of q knows one side only."""

_MOVING = 0.02
"""Share of the range of q by which it must change over that many samples to be in motion."""

_FARTHER = 0.1
"""Share of the range of q that nothing but a log's first samples shows, from which they are kept."""

MOST_SAMPLES = 12_000
"""Samples of all logs together that a fit of the joint's equations takes: beyond, every log is cut after as large a
share. It bounds the work, whatever is given: at 10 ms these are 120 s of motion, three logs as the paper's."""

LONGEST_BRIDGE = 10.0
"""Sample intervals without inputs up to which a straight line stands for them."""
UNKNOWN = "inputs_unknown"
"""Key of a record's notes for spans [s] in which the inputs were not recorded for longer."""


def _everywhere() -> BoolArray:
    return np.ones(0, dtype=np.bool_)


@dataclass(frozen=True)
class Log:
    """One log, or a part of one, on a uniform time base, with its gaps marked.

    A free run passes through a gap in q; only the comparison with q leaves it out. Hidden states therefore do not
    restart there.

    Attributes
    ----------
    t : FloatArray, shape (N,)
        Time [s], uniform.
    q, qdot, qddot : FloatArray, shape (N,)
        Displacement and its derivatives [m, m/s, m/s²] or [rad …]; of no meaning where `valid` is false.
    v : FloatArray, shape (N, K)
        Inputs [V], K = 1 or 2 (column 0 is the left one), finite everywhere.
    valid : BoolArray, shape (N,)
        False in gaps of q and where it is masked; true everywhere if left out.
    fine : FloatArray, shape (N, r, K), optional
        Inputs at r evenly spaced times of each sample interval, from the sample itself on, where they are known so
        finely.
    past : FloatArray, shape (P, K) or (P, r, K), optional
        Inputs of the log before this part of it, as fine as `drive`.
    velocity : FloatArray, shape (N,), optional
        Measured velocity [m/s or rad/s], where there is such a channel; of no meaning where `valid` is false.
    recorded : BoolArray, shape (N,)
        False where the inputs were not recorded; true everywhere if left out.

    Raises
    ------
    InputError
        Fewer than two samples, lengths that differ, inputs that are not finite.
    """

    t: FloatArray
    q: FloatArray
    qdot: FloatArray
    qddot: FloatArray
    v: FloatArray
    valid: BoolArray = field(default_factory=_everywhere)
    fine: FloatArray | None = None
    past: FloatArray | None = None
    velocity: FloatArray | None = None
    recorded: BoolArray = field(default_factory=_everywhere)

    def __post_init__(self) -> None:
        n = len(self.t)
        if n < 2:
            raise InputError(f"a log of {n} samples is too short to identify from; at least 2 are needed")
        for name in ("valid", "recorded"):
            if not len(getattr(self, name)):
                object.__setattr__(self, name, np.ones(n, dtype=np.bool_))
        for name in ("q", "qdot", "qddot", "v", "valid"):
            if len(getattr(self, name)) != n:
                raise InputError(f"{name} has {len(getattr(self, name))} samples, the time base {n}")
        if not np.all(np.isfinite(self.drive)):
            raise InputError("a voltage is not finite; interpolate or mask it first")

    @property
    def interval(self) -> float:
        """Sample interval [s]."""
        return sample_interval(self.t)

    @property
    def duration(self) -> float:
        """Time [s] from the first sample to the last."""
        return float(self.t[-1] - self.t[0])

    @property
    def known_q(self) -> FloatArray:
        """The valid samples of the displacement, shape (M,)."""
        return self.q[self.valid]

    @property
    def drive(self) -> FloatArray:
        """The inputs as finely as they are known, shape (N, r, K) or (N, K)."""
        return self.v if self.fine is None else self.fine

    def drive_of(self, *, fine: bool) -> FloatArray:
        """The inputs for a model that takes them between the samples (`drive`), or at the samples alone."""
        return self.drive if fine else self.v

    @property
    def segment(self) -> IntArray:
        """The number of the gap-free segment of each row, −1 where the row is not valid, shape (N,)."""
        begins = np.diff(self.valid.astype(np.int64), prepend=0) > 0
        return np.asarray(np.where(self.valid, np.cumsum(begins) - 1, -1))

    def part(self, start: int, stop: int) -> "Log":
        """The samples from `start` to `stop`; the inputs before them are its past."""
        rows = slice(start, stop)
        before = [block for block in (self.past, self.drive[:start]) if block is not None and len(block)]
        return Log(
            t=self.t[rows],
            q=self.q[rows],
            qdot=self.qdot[rows],
            qddot=self.qddot[rows],
            v=self.v[rows],
            valid=self.valid[rows],
            fine=None if self.fine is None else self.fine[rows],
            past=np.concatenate(before) if before else None,
            velocity=None if self.velocity is None else self.velocity[rows],
            recorded=self.recorded[rows],
        )

    def segments(self) -> list["Log"]:
        """The gap-free segments of at least `SHORTEST` samples."""
        return [self._alone(rows) for rows in runs_of(self.valid) if rows.stop - rows.start >= SHORTEST]

    def part_rows(self) -> list[slice]:
        """The rows of each part, from its first valid sample on; parts of less than `SHORTEST` are left out.

        Where all are so short, the rows are those of the log from its first valid sample on.
        """
        from_valid = [
            slice(rows.start + int(np.argmax(self.valid[rows])), rows.stop)
            for rows in runs_of(self.recorded)
            if self.valid[rows].any()
        ]
        long_enough = [rows for rows in from_valid if rows.stop - rows.start >= SHORTEST]
        return long_enough or [slice(int(np.argmax(self.valid)), len(self.valid))]

    def parts(self) -> list["Log"]:
        """The parts, each beginning with a valid sample; what happened before one is not known."""
        return [self._alone(rows) for rows in self.part_rows()]

    def longest_part(self) -> "Log":
        """The part with the most samples."""
        return self._alone(max(self.part_rows(), key=lambda rows: rows.stop - rows.start))

    def _alone(self, rows: slice) -> "Log":
        """Rows as a log of their own, without a past."""
        return replace(self.part(rows.start, rows.stop), past=None)

    @property
    def moves_at_first(self) -> bool:
        """True if q moves at the beginning."""
        first = int(np.argmax(self.valid))
        edge = self.q[first : first + EDGE + 1]
        return bool(np.nanmax(edge) - np.nanmin(edge) > _MOVING * (np.nanmax(self.q) - np.nanmin(self.q)))

    @property
    def begins_in_motion(self) -> bool:
        """True if q moves at the beginning and its velocity is a derivative, which is poor there."""
        return self.velocity is None and self.moves_at_first

    def to_fit(self) -> "Log":
        """The log from the first valid sample whose velocity is known on, with zeros where it is not valid.

        That is the first valid one, or `EDGE` samples later for a log that begins in motion: its inputs from before are
        kept as its past. A log whose first samples go where no others do is taken from the first one on all the same. A
        model that has never been there would lose a run that starts there.
        """
        begins_in_motion = self.begins_in_motion
        whole = self._alone(slice(int(np.argmax(self.valid)), len(self.valid)))
        numbers = ("q", "qdot", "qddot", *(() if self.velocity is None else ("velocity",)))
        whole = replace(whole, **{name: np.where(whole.valid, getattr(whole, name), 0.0) for name in numbers})
        if not begins_in_motion or len(whole.valid) < 10 * EDGE or not whole.valid[EDGE:].any():
            return whole
        later = whole.part(EDGE + int(np.argmax(whole.valid[EDGE:])), len(whole.valid))
        missed = max(later.known_q.min() - whole.known_q.min(), whole.known_q.max() - later.known_q.max())
        return whole if missed > _FARTHER * float(np.ptp(whole.known_q)) else later


def operating_range(logs: Sequence[Log]) -> tuple[float, float]:
    """Smallest and largest valid displacement of all logs: q_min, q_max of eq. 39.

    Raises
    ------
    InputError
        No log at all, or a displacement that never changes.
    """
    if not logs:
        raise InputError("there is no training data; name at least one training log with valid samples")
    low = min(float(log.known_q.min()) for log in logs)
    high = max(float(log.known_q.max()) for log in logs)
    if not high > low:
        raise InputError(f"q is constant ({low:g}) in all training logs; nothing can be identified from it")
    return low, high


def within(logs: Sequence[Log], samples: int) -> list[Log]:
    """The first share of every log, `samples` together; at least `SHORTEST` of each."""
    share = min(1.0, samples / sum(log.t.size for log in logs))
    return [log.part(0, max(int(share * log.t.size), SHORTEST)) for log in logs]


def log_of(
    kinematics: Mapping[str, FloatArray], fine: FloatArray | None = None, unknown: Sequence[Sequence[float]] = ()
) -> Log:
    """A log from the columns t, q, qdot, qddot, v1, v2, segment and perhaps velocity.

    Parameters
    ----------
    kinematics : mapping of str to FloatArray, shape (N,)
        Its columns in SI units; `segment` is the number of a gap-free segment, or −1 where q is masked.
    fine : FloatArray, shape (N, r, K), optional
        The inputs between the samples.
    unknown : sequence of (float, float)
        Spans [s] in which the inputs were not recorded.
    """
    t = kinematics["t"]
    return Log(
        t=t,
        q=kinematics["q"],
        qdot=kinematics["qdot"],
        qddot=kinematics["qddot"],
        v=voltages(kinematics),
        valid=_valid(kinematics["segment"]),
        fine=fine,
        velocity=kinematics.get("velocity"),
        recorded=~unknown_rows(t, unknown),
    )


def _valid(segment: Any) -> BoolArray:
    """Rows of a segment, shape (N,); where two meet, the first row of the second one parts them."""
    meet = (np.diff(segment, prepend=segment[:1]) != 0) & (segment > 0) & (np.roll(segment, 1) >= 0)
    return np.asarray((segment >= 0) & ~meet)


def voltages(table: Mapping[str, FloatArray]) -> FloatArray:
    """The inputs v1, v2 of a table, shape (N, 1) or (N, 2)."""
    return np.column_stack([table[name] for name in ("v1", "v2") if name in table])


def unknown_rows(t: FloatArray, spans: Sequence[Sequence[float]]) -> BoolArray:
    """Rows strictly inside `spans` [s] without inputs, shape (N,)."""
    inside = np.zeros(len(t), dtype=np.bool_)
    for start, stop in spans:
        inside[np.searchsorted(t, start, side="right") : np.searchsorted(t, stop)] = True
    return inside


@dataclass(frozen=True)
class RawLog:
    """A log in SI units before it has a uniform time base; signals with one time base hold the same object.

    Attributes
    ----------
    q : Signal
        Displacement [m or rad].
    inputs : tuple of Signal
        Voltages [V], or what the inputs measure.
    velocity : Signal or None
        Measured velocity [m/s or rad/s].
    notes : tuple of Remark
        Remarks on how it was read, by the names in a record.
    """

    q: Signal
    inputs: tuple[Signal, ...]
    velocity: Signal | None = None
    notes: tuple[Remark, ...] = ()

    @property
    def beside(self) -> dict[str, Signal]:
        """All but q, by their names in a record."""
        named = {f"v{i}": signal for i, signal in enumerate(self.inputs, start=1)}
        return named if self.velocity is None else {**named, "velocity": self.velocity}


@dataclass(frozen=True)
class Corrections:
    """Corrections of readings: v → gains·v(t − delay), q → gain_q·q + zero, t → clock·t.

    Attributes
    ----------
    gains : tuple of float
        Factor on each input.
    zero : float
        Added to q [m or rad], after its gain.
    gain_q : float
        Factor on q.
    delay : float
        Time [s] by which the inputs are delayed, after the correction of the clock.
    clock : float
        Factor on the time.
    """

    gains: tuple[float, ...]
    zero: float = 0.0
    gain_q: float = 1.0
    delay: float = 0.0
    clock: float = 1.0

    @property
    def act(self) -> bool:
        """True if the corrections change anything."""
        return self != Corrections((1.0,) * len(self.gains))

    def then(self, later: "Corrections") -> "Corrections":
        """Both in one: `later` corrects what these have corrected."""
        return Corrections(
            gains=tuple(first * second for first, second in zip(self.gains, later.gains, strict=True)),
            zero=later.gain_q * self.zero + later.zero,
            gain_q=self.gain_q * later.gain_q,
            delay=later.clock * self.delay + later.delay,
            clock=self.clock * later.clock,
        )


def corrected(log: Log, by: Corrections) -> Log:
    """A log as instruments without these errors would have recorded it.

    A measured velocity is a reading of another sensor and stays. Delayed inputs are a cubic spline between their
    samples. Cost: 2 ms for 37.5 s at 1 ms where there is a delay, else a copy.
    """
    speed = by.gain_q / by.clock
    log = replace(
        log,
        t=log.t * by.clock,
        q=by.gain_q * log.q + by.zero,
        qdot=speed * log.qdot,
        qddot=speed / by.clock * log.qddot,
    )
    before = np.zeros((0, *log.drive.shape[1:])) if log.past is None else log.past
    samples = np.concatenate([before, log.drive]) * np.array(by.gains)
    if by.delay:
        samples = _delayed(samples, by.delay / log.interval)
    past, drive = np.split(samples, [len(before)])
    fine = None if log.fine is None else drive
    return replace(log, v=drive if fine is None else fine[:, 0], fine=fine, past=None if log.past is None else past)


def _delayed(samples: FloatArray, delay: float) -> FloatArray:
    """Inputs later by so many sample intervals, shape (N, K) or (N, r, K); the first and the last value hold beyond."""
    from scipy.interpolate import CubicSpline

    rows = samples.reshape(-1, samples.shape[-1])
    places = np.arange(len(rows), dtype=np.float64)
    at = np.clip(places - delay * len(rows) / len(samples), 0.0, places[-1])
    return np.asarray(CubicSpline(places, rows)(at).reshape(samples.shape))


def mirrored(log: Log) -> Log:
    """A log whose q counts the other way."""
    velocity = None if log.velocity is None else -log.velocity
    return replace(log, q=-log.q, qdot=-log.qdot, qddot=-log.qddot, velocity=velocity)


def exchanged(log: Log) -> Log:
    """A log whose inputs have changed places."""
    fine, past = (None if each is None else np.ascontiguousarray(each[..., ::-1]) for each in (log.fine, log.past))
    return replace(log, v=np.ascontiguousarray(log.v[:, ::-1]), fine=fine, past=past)
