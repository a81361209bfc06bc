"""Round numbers along an axis."""

import math

import numpy as np

from pipeline.numerics.arrays import FloatArray


def linear_ticks(low: float, high: float, about: int) -> tuple[FloatArray, int]:
    """Round numbers from `low` to `high`, about so many, and the decimals that they need."""
    raw = (high - low) / max(1, about)
    power = math.floor(math.log10(raw))
    step = float(next(m for m in (1.0, 2.0, 5.0, 10.0) if m * 10.0**power >= raw * (1 - 1e-9)) * 10.0**power)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    values: FloatArray = np.arange(first, last + 1, dtype=np.float64) * step
    return values, decimals


def log_ticks(low: float, high: float) -> FloatArray:
    """Powers of ten from `low` to `high`; the ends themselves where there are fewer than two."""
    powers = np.arange(math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9) + 1)
    every = max(1, math.ceil(len(powers) / 6))
    if len(powers) < 2:
        return np.array([low, high])
    values: FloatArray = np.power(10.0, powers[::every])
    return values
