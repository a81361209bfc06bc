"""Corrections of what the instruments of a log read: gains of the inputs and of q, zero of q, delay, clock."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicSpline

from pipeline.numerics.arrays import FloatArray
from pipeline.signals.trajectory import Record


@dataclass(frozen=True)
class Corrections:
    """What makes readings true: v → gains·v(t − delay), q → gain_q·q + zero, t → clock·t.

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
        """Whether they change anything."""
        return self != Corrections((1.0,) * len(self.gains))

    def then(self, later: "Corrections") -> "Corrections":
        """Both in one: `later` corrects what these have corrected."""
        return Corrections(
            tuple(first * second for first, second in zip(self.gains, later.gains, strict=True)),
            later.gain_q * self.zero + later.zero,
            self.gain_q * later.gain_q,
            later.clock * self.delay + later.delay,
            self.clock * later.clock,
        )


def corrected(record: Record, by: Corrections) -> Record:
    """A log as instruments without these errors would have recorded it.

    A measured velocity is a reading of another sensor and stays. Delayed inputs are a cubic spline between their
    samples. Cost: 2 ms for 37.5 s at 1 ms where there is a delay, else a copy.
    """
    speed = by.gain_q / by.clock
    record = replace(
        record,
        t=record.t * by.clock,
        q=by.gain_q * record.q + by.zero,
        qdot=speed * record.qdot,
        qddot=speed / by.clock * record.qddot,
    )
    before, within = np.zeros((0, *record.drive.shape[1:])) if record.past is None else record.past, record.drive
    samples = np.concatenate([before, within]) * np.array(by.gains)
    if by.delay:
        samples = _delayed(samples, by.delay / record.interval)
    past, drive = np.split(samples, [len(before)])
    fine = None if record.fine is None else drive
    return replace(
        record, v=drive if fine is None else fine[:, 0], fine=fine, past=None if record.past is None else past
    )


def _delayed(samples: FloatArray, delay: float) -> FloatArray:
    """Inputs later by so many sample intervals, shape (N, K) or (N, r, K); the first and the last value hold beyond."""
    rows = samples.reshape(-1, samples.shape[-1])
    places = np.arange(len(rows), dtype=np.float64)
    at = np.clip(places - delay * len(rows) / len(samples), 0.0, places[-1])
    later: FloatArray = CubicSpline(places, rows)(at).reshape(samples.shape)
    return later


def mirrored(record: Record) -> Record:
    """A log whose q counts the other way."""
    velocity = None if record.velocity is None else -record.velocity
    return replace(record, q=-record.q, qdot=-record.qdot, qddot=-record.qddot, velocity=velocity)


def exchanged(record: Record) -> Record:
    """A log whose inputs have changed places."""
    fine, past = (
        None if each is None else np.ascontiguousarray(each[..., ::-1]) for each in (record.fine, record.past)
    )
    return replace(record, v=np.ascontiguousarray(record.v[:, ::-1]), fine=fine, past=past)
