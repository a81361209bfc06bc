"""The test bench around a joint: commands through converters to the membranes, and what the instruments record."""

from dataclasses import dataclass, field

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.rig.converter import Converter
from pipeline.rig.instruments import Laser, Probe
from pipeline.rig.joint import simulate
from pipeline.rig.parameters import JointParameters

TIME_STEP = 0.5e-3  # s, of the joint's integration


@dataclass(frozen=True)
class Bench:
    """Converters, laser and probes; pairs are (left, right).

    Attributes
    ----------
    rate : float
        Samples per second, a multiple of 2 kHz [Hz].
    """

    rate: float = 30_000.0
    converters: tuple[Converter, Converter] = (Converter(), Converter())
    laser: Laser = field(default_factory=Laser)
    probes: tuple[Probe, Probe] = (Probe(), Probe())

    def clock(self, duration: float) -> FloatArray:
        """Times [s] of the samples of a log that lasts `duration` [s]."""
        return np.arange(round(duration * self.rate)) / self.rate


@dataclass(frozen=True)
class Record:
    """One log in SI units: what was measured, and the truth behind it; all of shape (N,)."""

    t: FloatArray
    q: FloatArray
    v1: FloatArray
    v2: FloatArray
    true_q: FloatArray
    true_qdot: FloatArray
    true_phi: FloatArray
    true_v1: FloatArray
    true_v2: FloatArray


def random_bench(rng: np.random.Generator, *, rate: float = 30_000.0) -> Bench:
    """A bench with its own converters and instrument errors."""

    def converter() -> Converter:
        """Its lag [s], rate limit [V/s] and power limit [W]."""
        return Converter(
            lag=float(rng.uniform(2e-3, 7e-3)),
            rate_limit=float(rng.uniform(0.5e6, 1.4e6)),
            power_limit=float(rng.uniform(5.0, 15.0)),
        )

    def probe() -> Probe:
        """Its noise [V] and gain."""
        return Probe(noise=float(rng.uniform(3.0, 7.0)), gain=1.0 + float(rng.normal(0.0, 3e-3)))

    laser = Laser(noise=float(rng.uniform(0.5e-6, 2e-6)), hum=float(rng.uniform(0.01e-6, 0.2e-6)))
    return Bench(rate, (converter(), converter()), laser, (probe(), probe()))


def record(p: JointParameters, bench: Bench, t: FloatArray, u: FloatArray, rng: np.random.Generator) -> Record:
    """Play the commands `u` (N, 2) [V] at the bench's times `t` (N,) [s] on the joint `p` at rest in its left well."""
    dt = 1 / bench.rate
    v: FloatArray = np.stack([bench.converters[side].drive(u[:, side], dt) for side in (0, 1)], axis=1)
    motion = simulate(p, v, dt, stride=max(1, round(TIME_STEP * bench.rate)))
    return Record(
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
