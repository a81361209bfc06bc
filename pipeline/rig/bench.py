"""The test bench around a joint: commands through converters to the membranes, and the records of laser and probes."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..numerics.arrays import BoolArray, FloatArray, IntArray
from ..numerics.compiled import compiled, inner
from .joint import simulate
from .parameters import RigParameters

RATE = 30_000.0  # Hz, of the logs
_POWER_FLOOR = 100.0  # V: below this the current limit, not the power limit, holds
TIME_STEP = 0.5e-3  # s, of the joint's integration


@dataclass(frozen=True)
class Converter:
    """A high-voltage converter that charges one DE membrane: lag, rate limit, power limit.

    Attributes
    ----------
    lag : float
        Time constant of the voltage control [s].
    rate_limit : float
        Largest slope up or down, set by the output current [V/s].
    power_limit : float
        Largest power into the load while charging [W].
    capacitance : float
        Of membrane and cable [F].
    """

    lag: float = 2.5e-3
    rate_limit: float = 1.25e6
    power_limit: float = 8.0
    capacitance: float = 7.0e-9

    def drive(self, u: FloatArray, dt: float) -> FloatArray:
        """Output voltage [V] for a sampled command `u` [V], shape (N,), starting discharged.

        ``v̇ = clip((u − v)/lag, ±rate)`` with ``rate = min(rate_limit, power_limit/(C v))`` while charging. The
        linear part is integrated exactly for a command held over each sample.

        Cost: O(N), about 5 ns a sample.
        """
        return _drive(u, dt, self.lag, self.rate_limit, self.power_limit / self.capacitance)


@compiled
def _drive(u: FloatArray, dt: float, lag: float, rate: float, power: float) -> FloatArray:
    v = np.empty_like(u)
    decay = -np.expm1(-dt / lag)
    x = 0.0
    for i in range(u.size):
        v[i] = x
        x = charged(x, u[i], decay, rate, power, dt)
    return v


def charge_left(charging: float, dt: float) -> float:
    """Share of a membrane's missing charge that is still missing after `dt` [s]; none where it charges at once."""
    return float(np.exp(-dt / charging)) if charging > 0.0 else 0.0


@compiled
def _behind_electrodes(v: FloatArray, left: float) -> FloatArray:
    """Voltages of the membranes [V], shape (N, 2), under those of the converters, from charged membranes."""
    out = v.copy()
    if left == 0.0:
        return out
    for i in range(1, len(v)):
        for side in range(2):
            mean = 0.5 * (v[i - 1, side] + v[i, side])
            out[i, side] = mean + (out[i - 1, side] - mean) * left
    return out


@inner
def charged(v: float, asked: float, decay: float, rate: float, power: float, dt: float) -> float:
    """The converter's voltage [V] `dt` [s] after it was v; `decay` is 1 − e^(−dt/lag), `power` that over C.

    Parameters
    ----------
    v : float
        Voltage before [V].
    asked : float
        Commanded voltage [V].
    decay : float
        1 − e^(−dt/lag).
    rate : float
        Largest rate [V/s].
    power : float
        Power of the converter over the capacitance [V²/s].
    dt : float
        Time [s].
    """
    up = min(rate, power / max(v, _POWER_FLOOR)) * dt
    return v + min(max((asked - v) * decay, -rate * dt), up)


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
    zero : float
        Reading [m] at q = 0.
    """

    noise: float = 1.5e-6
    resolution: float = 0.3e-6
    linearity: float = 4.0e-6
    rail: float = 25.0e-3
    hum: float = 0.05e-6
    mains: float = 50.0
    zero: float = 0.0

    def read(self, t: FloatArray, q: FloatArray, rng: np.random.Generator) -> FloatArray:
        """Reading [m] of the displacement `q` [m] at times `t` [s], both shape (N,).

        The linearity error is a fixed wave over the range, two periods with a phase drawn once: repeatable and
        smooth in q, as a calibration sheet shows it.
        """
        phase = rng.uniform(0.0, 2 * np.pi, 2)
        hum = self.hum * np.sin(2 * np.pi * self.mains * t + phase[1])
        noise = self.noise * rng.standard_normal(t.size, dtype=np.float32)
        reading = q + self.zero + bent(q, self.linearity, self.rail, phase[0]) + hum + noise
        return _quantise(np.clip(reading, -self.rail, self.rail), self.resolution)


@compiled
def bent(q: Any, linearity: float, rail: float, phase: float) -> Any:
    """Linearity error [m] of a laser at the displacement q [m].

    Parameters
    ----------
    q : number or array
        Displacement [m].
    linearity : float
        Largest error [m].
    rail : float
        End of the range [m].
    phase : float
        Phase of the error [rad].
    """
    return linearity * np.sin(2.0 * np.pi * q / rail + phase)


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
        hum = self.hum * np.sin(2 * np.pi * self.mains * t + rng.uniform(0.0, 2 * np.pi))
        noise = self.noise * rng.standard_normal(t.size, dtype=np.float32)
        return _quantise(self.gain * v + self.offset + hum + noise, self.resolution)


def _quantise(x: FloatArray, step: float) -> FloatArray:
    """`x` rounded to multiples of `step`."""
    return np.asarray(np.round(x / step) * step)


@dataclass(frozen=True)
class Bench:
    """Converters, laser and probes; pairs are (left, right).

    Attributes
    ----------
    rate : float
        Samples per second, a multiple of 2 kHz [Hz].
    converters, laser, probes
        Left and right converter, the laser, left and right probe; the probes see the converters' voltages.
    charging : float
        Time constant [s] with which each membrane charges through its electrodes; 0: at once.
    """

    rate: float = RATE
    converters: tuple[Converter, Converter] = (Converter(), Converter())
    laser: Laser = field(default_factory=Laser)
    probes: tuple[Probe, Probe] = (Probe(), Probe())
    charging: float = 0.0

    def clock(self, duration: float) -> FloatArray:
        """Times [s] of the samples of a log that lasts `duration` [s]."""
        return np.arange(round(duration * self.rate)) / self.rate


@dataclass(frozen=True)
class Readings:
    """Readings of the instruments in one experiment, each of shape (N,): t [s], q [m], v1 (left) and v2 (right) [V]."""

    t: FloatArray
    q: FloatArray
    v1: FloatArray
    v2: FloatArray

    def at(self, rows: BoolArray | IntArray) -> "Readings":
        """The samples of some rows."""
        return Readings(self.t[rows], self.q[rows], self.v1[rows], self.v2[rows])


@dataclass(frozen=True)
class BenchRecord(Readings):
    """One log in SI units: the measurement and the truth behind it, all of shape (N,)."""

    true_q: FloatArray
    true_qdot: FloatArray
    true_phi: FloatArray
    true_v1: FloatArray
    true_v2: FloatArray


def random_bench(rng: np.random.Generator, *, rate: float = RATE, charging: float = 0.0) -> Bench:
    """A bench with its own converters and instrument errors, and the given electrodes."""
    laser = Laser(noise=float(rng.uniform(0.5e-6, 2e-6)), hum=float(rng.uniform(0.01e-6, 0.2e-6)))
    left, right = (
        Converter(
            lag=float(rng.uniform(2e-3, 7e-3)),
            rate_limit=float(rng.uniform(0.5e6, 1.4e6)),
            power_limit=float(rng.uniform(5.0, 15.0)),
        )
        for _ in range(2)
    )
    first, second = (
        Probe(noise=float(rng.uniform(3.0, 7.0)), gain=1.0 + float(rng.normal(0.0, 3e-3))) for _ in range(2)
    )
    return Bench(rate=rate, converters=(left, right), laser=laser, probes=(first, second), charging=charging)


def record(p: RigParameters, bench: Bench, t: FloatArray, u: FloatArray, rng: np.random.Generator) -> BenchRecord:
    """Play the commands `u` (N, 2) [V] at the bench's times `t` (N,) [s] on the joint `p` at rest in its left well.

    Parameters
    ----------
    p : RigParameters
        The joint.
    bench : Bench
        Instruments and converters.
    t : FloatArray, shape (N,)
        Times of the bench [s].
    u : FloatArray, shape (N, 2)
        Commands [V].
    rng : numpy.random.Generator
        Draws the noise.
    """
    dt = 1 / bench.rate
    v: FloatArray = np.stack([bench.converters[side].drive(u[:, side], dt) for side in (0, 1)], axis=1)
    motion = simulate(
        p, _behind_electrodes(v, charge_left(bench.charging, dt)), dt, stride=max(1, round(TIME_STEP * bench.rate))
    )
    return BenchRecord(
        t=t,
        q=bench.laser.read(t, motion.q, rng),
        v1=bench.probes[0].read(t, v[:, 0], rng),
        v2=bench.probes[1].read(t, v[:, 1], rng),
        true_q=motion.q,
        true_qdot=motion.qdot,
        true_phi=motion.phi,
        true_v1=v[:, 0],
        true_v2=v[:, 1],
    )
