"""Spans that signals plausibly have: a unit with a wrong prefix shows a thousand times as much, or as little."""

import numpy as np

# Spans (largest minus smallest value) that a joint's signals have, by SI unit, with room on both sides; and those of
# another device: a cart goes metres, a motor turns many times.
_PLAUSIBLE_SPANS = {"m": (1e-5, 0.5), "rad": (1e-3, 20.0), "V": (0.5, 5e4)}
_OTHER_SPANS = {"m": (1e-6, 10.0), "rad": (1e-4, 1e5), "V": (1e-3, 1e6)}


def scale_suspicion(span: float, symbol: str, *, joint: bool = True) -> float | None:
    """By what factor numbers look too large, if a unit prefix seems to be wrong.

    Parameters
    ----------
    span : float
        Largest minus smallest value, in SI.
    symbol : str
        SI unit of the values.
    joint : bool
        Whether the device is one.

    Returns
    -------
    float or None
        1000.0: looks 1000 times too large; 0.001: 1000 times too small, and so on; None where the span is
        plausible, zero, or the unit is not one with known spans.
    """
    low, high = plausible_span(symbol, joint=joint) or (0.0, np.inf)
    if not np.isfinite(span) or span <= 0.0 or low <= span <= high:
        return None
    factor = 1000.0 if span > high else 0.001
    while not low <= span / factor <= high and 1e-9 < factor < 1e9:
        factor *= 1000.0 if span > high else 0.001
    return factor


def plausible_span(symbol: str, *, joint: bool = True) -> tuple[float, float] | None:
    """Least and largest span [SI] of a signal of this unit that a joint, or another device, shows; None for others."""
    return (_PLAUSIBLE_SPANS if joint else _OTHER_SPANS).get(symbol)
