"""What the rig measures with: a laser distance sensor and high-voltage probes, with their errors."""

from dataclasses import dataclass

import numpy as np

from pipeline.numerics.arrays import FloatArray


@dataclass(frozen=True)
class Laser:
    """A triangulation sensor of 50 mm range.

    Attributes
    ----------
    noise, resolution, linearity, rail, hum : float
        RMS of the white noise, quantisation step, peak of the linearity error, end of the range, amplitude of
        the mains hum [m].
    mains : float
        [Hz].
    """

    noise: float = 1.5e-6
    resolution: float = 0.3e-6
    linearity: float = 4.0e-6
    rail: float = 25.0e-3
    hum: float = 0.05e-6
    mains: float = 50.0

    def read(self, t: FloatArray, q: FloatArray, rng: np.random.Generator) -> FloatArray:
        """Reading [m] of the displacement `q` [m] at times `t` [s], both shape (N,).

        The linearity error is a fixed wave over the range, two periods with a phase drawn once: repeatable and
        smooth in q, as a calibration sheet shows it.
        """
        phase = rng.uniform(0.0, 2 * np.pi, 2)
        reading = q + self.linearity * np.sin(2 * np.pi * q / self.rail + phase[0])
        reading += self.hum * np.sin(2 * np.pi * self.mains * t + phase[1])
        reading += self.noise * rng.standard_normal(t.size, dtype=np.float32)
        return _quantise(np.clip(reading, -self.rail, self.rail), self.resolution)


@dataclass(frozen=True)
class Probe:
    """A divider probe and its converter: gain error, offset, noise, mains hum, ADC step; all in [V] but the gain."""

    noise: float = 5.0
    resolution: float = 0.153
    hum: float = 4.0
    gain: float = 1.0
    offset: float = 0.0
    mains: float = 50.0

    def read(self, t: FloatArray, v: FloatArray, rng: np.random.Generator) -> FloatArray:
        """Reading [V] of the voltage `v` [V] at times `t` [s], both shape (N,)."""
        reading = self.gain * v + self.offset
        reading += self.hum * np.sin(2 * np.pi * self.mains * t + rng.uniform(0.0, 2 * np.pi))
        reading += self.noise * rng.standard_normal(t.size, dtype=np.float32)
        return _quantise(reading, self.resolution)


def _quantise(x: FloatArray, step: float) -> FloatArray:
    """`x` rounded to multiples of `step`."""
    rounded: FloatArray = np.round(x / step)
    return rounded * step
