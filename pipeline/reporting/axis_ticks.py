"""Round numbers along an axis."""

import math

import numpy as np

from pipeline.numerics.arrays import FloatArray
from pipeline.si_prefix import significant

MOST_POWERS = 6  # labels along a logarithmic axis


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
    """Powers of ten from `low` to `high`; where there are fewer than three also 2 and 5 times them."""
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    inside = (low * (1 - 1e-9), high * (1 + 1e-9))
    powers = [10.0**k for k in range(first, last + 1) if inside[0] <= 10.0**k <= inside[1]]
    if len(powers) > 2:
        return np.array(powers[:: math.ceil(len(powers) / MOST_POWERS)])
    between = [m * 10.0**k for k in range(first, last + 1) for m in (1.0, 2.0, 5.0)]
    between = [v for v in between if inside[0] <= v <= inside[1]]
    return np.array(between) if len(between) > 1 else linear_ticks(low, high, 5)[0]


def tick_label(value: float) -> str:
    """A round number with the digits that it needs, at most three."""
    digits = next((d for d in (1, 2) if math.isclose(float(f"{value:.{d - 1}e}"), value, rel_tol=1e-9)), 3)
    return significant(value, digits)
