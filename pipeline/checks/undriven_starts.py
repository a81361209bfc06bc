"""How often a device at rest begins to move while no input changes: something moves it that was not named."""

import numpy as np

from pipeline.numerics.arrays import FloatArray

_REST, _ANSWER = 20, 10
"""Rows of a rest with steady inputs, and of what follows it."""
_STILL, _MOVED = 0.01, 0.06
"""Share of its range within which q stays at rest, and by which it then moves."""
_STEADY = 0.04
"""Share of its range within which an input counts as steady."""


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
    rows = _REST + _ANSWER
    if q.size <= rows:
        return ()
    view = np.lib.stride_tricks.sliding_window_view
    reach = float(np.nanmax(q) - np.nanmin(q))
    whole = view(q, rows)
    before, after = whole[:, :_REST], whole[:, _REST:]
    still = np.ptp(before, axis=1) < _STILL * reach
    moved = np.abs(after[:, -1] - before[:, -1]) > _MOVED * reach
    steady = np.ones(whole.shape[0], dtype=np.bool_)
    for column in v.T:
        steady &= np.ptp(view(column, rows), axis=1) < _STEADY * np.ptp(column)
    begins = np.flatnonzero(still & moved & steady)
    first = begins[np.diff(begins, prepend=-rows) > _ANSWER]
    return tuple(t[first + _REST].tolist())
