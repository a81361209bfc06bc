"""Random devices that are no joint, as logs for `devices.py`: `python benchmarks/simulated_devices.py FOLDER SEED...`.

In the displacement x of a mass, with the natural frequency ω and an input u that acts by itself or by its square:

    ẍ = ω² (a − k(x) − 0.3 h − 0.3 e − f tanh(ẋ / 0.02 ω)) − 2 ζ ω ẋ,   ȧ = (g(u) − a)/T

k hardens or softens, h is the hysteretic state of Bouc and Wen, e a relaxing element, f dry friction. Which of them a
device has is drawn. Each has two training logs, and two validation logs: one of the first excitation, one of another.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from devices import settings, write
from scipy.integrate import solve_ivp

DURATION, STEP, INTERVAL, KEPT = 30.0, 0.001, 0.01, 5
"""Length [s] and step [s] of a log, sample interval [s], and how many steps there are for each row of a log."""
NOISE = 2e-3
"""Noise of the sensor over the range of x."""


@dataclass(frozen=True)
class Device:
    """A device as it was drawn: frequency [rad/s], damping ratio, and the terms of its equation."""

    frequency: float
    damping: float
    cubic: float
    softens: bool
    friction: float
    lag: float
    hysteretic: bool
    squared: bool
    relaxes: bool
    rate: float

    @classmethod
    def drawn(cls, seed: int) -> "Device":
        """The device of a seed."""
        rng = np.random.default_rng(seed)
        return cls(
            frequency=2.0 * np.pi * rng.uniform(0.5, 3.0),
            damping=rng.choice([0.03, 0.1, 0.4, 1.5]),
            cubic=rng.uniform(-0.2, 1.5),
            softens=bool(rng.random() < 0.3),
            friction=rng.choice([0.0, 0.02, 0.08]),
            lag=rng.choice([0.0, 0.02, 0.1]),
            hysteretic=bool(rng.random() < 0.4),
            squared=bool(rng.random() < 0.5),
            relaxes=bool(rng.random() < 0.3),
            rate=rng.uniform(0.3, 3.0),
        )

    def displacement(self, t: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Displacement under an input u, both of shape (N,), from rest."""

        def rates(time: float, state: np.ndarray) -> list[float]:
            x, p, a, h, e = state
            acting = np.interp(time, t, u) ** (2 if self.squared else 1)
            push = a if self.lag else acting
            spring = np.tanh(1.5 * x) / 1.5 if self.softens else x + self.cubic * x**3
            held = spring + 0.3 * h * self.hysteretic + 0.3 * e * self.relaxes
            held += self.friction * np.tanh(p / (0.02 * self.frequency))
            acceleration = self.frequency**2 * (push - held) - 2.0 * self.damping * self.frequency * p
            bent = (p - 2.0 * abs(p) * h * 0.5 - 2.0 * p * abs(h) * 0.5) * self.hysteretic
            relaxing = (p - self.rate * e) * self.relaxes
            return [p, acceleration, (acting - a) / max(self.lag, STEP), bent, relaxing]

        solution = solve_ivp(rates, (0.0, t[-1]), np.zeros(5), t_eval=t, max_step=0.005, rtol=1e-7, atol=1e-9)
        return np.asarray(solution.y[0])


def excitation(rng: np.random.Generator, kind: str, largest: float, band: float) -> tuple[np.ndarray, np.ndarray]:
    """Times and an input of steps, a multisine or a sweep about the frequency `band` [Hz]."""
    t = np.arange(0.0, DURATION, STEP)
    if kind == "steps":
        levels = rng.uniform(-largest, largest, int(DURATION * band) + 2)
        return t, levels[(t * band).astype(int)]
    if kind == "multisine":
        lines = np.linspace(0.05 * band, 1.5 * band, 40)
        u = np.sin(2.0 * np.pi * np.outer(t, lines) + rng.uniform(0.0, 2.0 * np.pi, 40)).sum(axis=1)
        return t, largest * u / np.abs(u).max()
    return t, largest * np.sin(2.0 * np.pi * (0.05 * band * t + 0.75 * band / DURATION * t**2))


def main(folder: Path, seeds: list[int]) -> None:
    for seed in seeds:
        device, rng, home = Device.drawn(seed), np.random.default_rng(1000 + seed), folder / f"simulated-{seed}"
        home.mkdir(parents=True, exist_ok=True)
        kinds, band = rng.permutation(["steps", "multisine", "sweep"]), device.frequency / (2.0 * np.pi)
        logs = (("train", kinds[0], 1.0), ("train-2", kinds[1], 0.7), ("same", kinds[0], 0.9), ("other", kinds[2], 0.8))
        for name, kind, largest in logs:
            t, u = excitation(rng, kind, largest, band)
            x = device.displacement(t, u)
            x = x + NOISE * np.ptp(x) * rng.standard_normal(len(x))
            write(home, name, u[::KEPT], x[::KEPT], KEPT * STEP)
        text = settings(f"simulated-{seed}", ["train", "train-2"], ["same", "other"], "mm", INTERVAL)
        text = text.replace('"linear"', '"squared"') if device.squared else text
        text = text.replace("record_interval = 0.001", f"record_interval = {KEPT * STEP}")
        (home / "device.toml").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), list(map(int, sys.argv[2:])))
