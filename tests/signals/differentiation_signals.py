"""Signals with known first and second derivatives, for the accuracy table and the benchmark."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class Signal:
    """A noise-free signal at uniform times with its derivatives; `second` is None where it does not exist."""

    name: str
    dt: float
    value: FloatArray
    first: FloatArray
    second: FloatArray | None

    def noisy(self, noise_std: float, rng: np.random.Generator) -> FloatArray:
        return self.value + noise_std * rng.standard_normal(self.value.size)


def corner(n: int = 100) -> Signal:
    """Chartrand's |x − 0.5| on [0, 1]."""
    x = np.linspace(0.0, 1.0, n)
    return Signal("corner", float(x[1]), np.abs(x - 0.5), np.sign(x - 0.5), None)


def sine(n: int = 2000, dt: float = 1e-3, frequency: float = 2.0) -> Signal:
    t, w = dt * np.arange(n), 2.0 * np.pi * frequency
    return Signal("sine", dt, np.sin(w * t), w * np.cos(w * t), -(w**2) * np.sin(w * t))


def chirp(n: int = 4000, dt: float = 1e-3, start: float = 0.5, stop: float = 9.0) -> Signal:
    """Linear sweep of amplitude 1."""
    t = dt * np.arange(n)
    sweep = (stop - start) / (n * dt)
    phase, w, dw = 2 * np.pi * (start * t + 0.5 * sweep * t**2), 2 * np.pi * (start + sweep * t), 2 * np.pi * sweep
    sin, cos = np.sin(phase), np.cos(phase)
    return Signal("chirp", dt, sin, w * cos, dw * cos - w**2 * sin)


def steps(n: int = 3000, dt: float = 1e-3) -> Signal:
    """Moves from rest to rest with constant acceleration and deceleration: the second derivative is steps."""
    t = dt * np.arange(n)
    value, first, second = np.zeros(n), np.zeros(n), np.zeros(n)
    for begin, half, size in ((0.2537, 0.2, 50.0), (1.0213, 0.11, -165.0), (2.0171, 0.3, 22.0)):
        for offset, sign in ((0.0, 1.0), (half, -2.0), (2.0 * half, 1.0)):
            s = np.maximum(t - begin - offset, 0.0)
            value += sign * size * s**2 / 2.0
            first += sign * size * s
            second += sign * size * (s > 0.0)
    return Signal("steps", dt, value, first, second)


def ring_down(n: int = 10_000, dt: float = 1e-3, frequencies: tuple[float, ...] = (2.8, 4.0, 6.0, 9.0)) -> Signal:
    """Switching between two wells 22 mm apart, in mm: step responses of damped oscillators, whose acceleration jumps.

    Decay rate 3/s; one switch for each of `frequencies` [Hz], at times that fall between samples.
    """
    t = dt * np.arange(n)
    value, first, second = np.full(n, -11.0), np.zeros(n), np.zeros(n)
    decay, sign = 3.0, 1.0
    for k, frequency in enumerate(frequencies):
        w = 2.0 * np.pi * frequency
        s = t - n * dt * (k + 0.1837) / len(frequencies)
        s, on = np.maximum(s, 0.0), s > 0.0
        sin, cos, fall = np.sin(w * s), np.cos(w * s), 22.0 * sign * on * np.exp(-decay * s)
        value += 22.0 * sign * on - fall * (cos + decay / w * sin)
        first += fall * (w + decay**2 / w) * sin
        second += fall * (w + decay**2 / w) * (w * cos - decay * sin)
        sign = -sign
    return Signal("ring-down", dt, value, first, second)
