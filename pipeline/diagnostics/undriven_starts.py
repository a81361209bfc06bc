"""How often a device at rest begins to move while no input changes: something moves it that was not named."""

import numpy as np

from ..numerics.arrays import FloatArray

_ANSWER = 10
"""Rows within which a device that begins to move has done so; it is at rest for twice as many before."""
_STILL = 0.02
"""Share of its range within which q or an input stands still; q moves by three times as much."""


def undriven_starts(t: FloatArray, q: FloatArray, v: FloatArray) -> tuple[float, ...]:
    """Times [s] at which q leaves a rest though every input has been steady since before that rest.

    Parameters
    ----------
    t, q : FloatArray, shape (N,)
        Times [s], a sample interval of the identification apart, and displacement; NaN where masked.
    v : FloatArray, shape (N, K)
        Inputs.

    Notes
    -----
    Cost: some passes over N rows.
    """
    rest = 2 * _ANSWER
    rows = rest + _ANSWER
    if q.size <= rows:
        return ()
    view = np.lib.stride_tricks.sliding_window_view
    reach = float(np.nanmax(q) - np.nanmin(q))
    whole = view(q, rows)
    still = np.ptp(whole[:, :rest], axis=1) < _STILL * reach
    moved = np.abs(whole[:, -1] - whole[:, rest - 1]) > 3.0 * _STILL * reach
    steady = np.ones(whole.shape[0], dtype=np.bool_)
    for column in v.T:
        steady &= np.ptp(view(column, rows), axis=1) < _STILL * np.ptp(column)
    begins = np.flatnonzero(still & moved & steady)
    first = begins[np.diff(begins, prepend=-rows) > _ANSWER]
    return tuple(t[first + rest].tolist())
