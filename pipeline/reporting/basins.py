"""Basins of attraction on a grid of initial states, simulated only where outcomes differ."""

from collections.abc import Callable

import numpy as np

from pipeline.numerics.arrays import FloatArray

BLOCK = 4  # cells between the first look's grid lines


def basins(
    outcome: Callable[[float, float], int], places: FloatArray, speeds: FloatArray
) -> "np.ndarray[tuple[int, int], np.dtype[np.int8]]":
    """Class of the outcome from every ``(places[j], speeds[i])``.

    Blocks whose four corners end alike are filled, others are halved until they hold single cells. A tongue thinner
    than a block may be missed.

    Parameters
    ----------
    outcome : callable
        ``(place, speed) -> class``, a small integer not below 0.
    places, speeds : FloatArray
        Grid lines; a multiple of `BLOCK` plus one of each.

    Returns
    -------
    array of int8, shape (speeds.size, places.size)

    Notes
    -----
    Cost: about a quarter of the grid's simulations for one smooth boundary.
    """
    index = np.full((speeds.size, places.size), -1, dtype=np.int8)

    def at(i: int, j: int) -> int:
        if index[i, j] < 0:
            index[i, j] = outcome(float(places[j]), float(speeds[i]))
        return int(index[i, j])

    pending = [
        (i, i + BLOCK, j, j + BLOCK) for i in range(0, speeds.size - 1, BLOCK) for j in range(0, places.size - 1, BLOCK)
    ]
    while pending:
        top, bottom, left, right = pending.pop()
        corners = {at(i, j) for i in (top, bottom) for j in (left, right)}
        if len(corners) == 1:
            part = index[top : bottom + 1, left : right + 1]
            part[part < 0] = corners.pop()
        elif bottom - top > 1:
            i, j = (top + bottom) // 2, (left + right) // 2
            pending += [(a, b, c, d) for a, b in ((top, i), (i, bottom)) for c, d in ((left, j), (j, right))]
    return index
