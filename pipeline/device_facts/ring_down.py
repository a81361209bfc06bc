"""Frequency and damping of a decaying oscillation, by variable projection."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray

LEAST_SAMPLES = 20
MOST_UNEXPLAINED = 0.3  # RMS of the rest over that of the oscillation, beyond which no frequency is stated


@dataclass(frozen=True)
class RingDown:
    """A damped sinusoid: frequency [Hz], damping ratio, and the unexplained share (RMS over RMS)."""

    frequency: float
    damping: float
    unexplained: float


def ring_down(t: FloatArray, q: FloatArray) -> RingDown | None:
    """Fit ``q = a + b t + e^(−ζω₀t) (c cos ωt + s sin ωt)``; None where there is no such oscillation.

    The four linear numbers are eliminated (Golub & Pereyra 1973, doi:10.1137/0710036), so that a simplex search over
    decay and frequency is left. It starts at the highest line of the spectrum.

    Parameters
    ----------
    t : FloatArray, shape (n,)
        Uniform time [s].
    q : FloatArray, shape (n,)
        Displacement, finite.
    """
    from scipy.optimize import minimize

    if q.size < LEAST_SAMPLES:
        return None
    time, span = t - t[0], float(t[-1] - t[0])
    trend = np.column_stack((np.ones_like(time), time / span))
    oscillation = q - trend @ np.linalg.lstsq(trend, q, rcond=None)[0]
    size = float(np.linalg.norm(oscillation))
    if size == 0.0:
        return None
    padded = 8 * q.size
    line = int(np.argmax(np.abs(np.fft.rfft(oscillation, padded))))
    omega = 2.0 * np.pi * line / (padded * span / (q.size - 1))
    if omega * span < 2.0 * np.pi:
        return None

    def rest(logs: FloatArray) -> float:
        decay, angular = np.exp(logs)
        envelope = np.exp(-decay * time)
        columns = np.column_stack((trend, envelope * np.cos(angular * time), envelope * np.sin(angular * time)))
        weights = np.linalg.lstsq(columns, q, rcond=None)[0]
        return float(np.linalg.norm(q - columns @ weights)) / size

    start = np.log([2.0 / span, omega])
    simplex = start + np.array([[0.0, 0.0], [0.7, 0.0], [0.0, 0.05]])
    best = minimize(
        rest, start, method="Nelder-Mead", options={"initial_simplex": simplex, "fatol": 1e-6, "xatol": 1e-5}
    )
    decay, angular = np.exp(best.x)
    if best.fun > MOST_UNEXPLAINED or angular * span < 2.0 * np.pi:
        return None
    natural = float(np.hypot(decay, angular))
    return RingDown(float(angular / (2.0 * np.pi)), float(decay / natural), float(best.fun))
