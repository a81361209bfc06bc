"""Corrections of what the instruments of a log read: gains of the inputs and of q, zero of q, delay, clock."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicSpline

from ..numerics.arrays import FloatArray
from .log import Log


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
            tuple(first * second for first, second in zip(self.gains, later.gains, strict=True)),
            later.gain_q * self.zero + later.zero,
            self.gain_q * later.gain_q,
            later.clock * self.delay + later.delay,
            self.clock * later.clock,
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
    within = log.drive
    samples = np.concatenate([before, within]) * np.array(by.gains)
    if by.delay:
        samples = _delayed(samples, by.delay / log.interval)
    past, drive = np.split(samples, [len(before)])
    fine = None if log.fine is None else drive
    return replace(log, v=drive if fine is None else fine[:, 0], fine=fine, past=None if log.past is None else past)


def _delayed(samples: FloatArray, delay: float) -> FloatArray:
    """Inputs later by so many sample intervals, shape (N, K) or (N, r, K); the first and the last value hold beyond."""
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
