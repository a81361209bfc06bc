"""What every free run shares: nothing is fed back from the measurement.

Classical Runge-Kutta steps of fixed length with the voltages linear between samples. The fixed step makes a run
reproducible to the last bit and bounds its time.
"""

from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.solvers.fixed_step import inlined, workspace

MAX_STEP = 5e-3
"""Longest integration step [s]: 70 steps per period of the 2.8 Hz ringing in a well, 20 of the fastest at 9 Hz."""

LAG_STEP = 0.5
"""Longest step as a share of the lag; Runge-Kutta 4 is stable up to 2.78 and accurate to 1e-4 at 0.5."""


def steps_per_sample(interval: float, time_constant: float) -> int:
    """Integration steps per sample interval for a model whose fastest lag is `time_constant` [s]."""
    return int(np.ceil(interval / min(MAX_STEP, LAG_STEP * time_constant)))


def escape_bounds(low: float, high: float) -> tuple[float, float]:
    """Displacements beyond which a run counts as diverged: two operating ranges past either end of the data."""
    return low - 2.0 * (high - low), high + 2.0 * (high - low)


@inlined
def between_samples(node: int, parts: int, samples: int) -> tuple[int, int, float]:
    """Samples about the half step `node`, `parts` of which are an interval, and its share of the way between them."""
    n = node // parts
    return n, min(n + 1, samples - 1), (node - n * parts) / parts


def bounded_run(
    integrate: Callable[..., int], system: NamedTuple, x: FloatArray, samples: int, steps: int, interval: float,
    bounds: tuple[float, float],
) -> tuple[FloatArray, int]:  # fmt: skip
    """q, q̇, q̈ of a system from x at the samples, (N, 3), NaN from where q leaves the bounds; and valid samples."""
    out = np.full((samples, 3, 1), np.nan)
    valid = integrate(system, x, out, workspace(x), steps, interval / steps, float(bounds[0]), float(bounds[1]))
    return out[:, :, 0], valid


def run_status(t: FloatArray, valid: int) -> tuple[Literal["ok", "diverged"], float | None]:
    """Status of a run with `valid` good samples, and the time [s] of its divergence."""
    return ("ok", None) if valid == len(t) else ("diverged", float(t[valid]))
