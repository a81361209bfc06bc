"""The level at which an input rests."""

import numpy as np

from pipeline.numerics.arrays import FloatArray

NEAR, SHARE = 0.02, 0.1
"""Part of an input's largest magnitude to either side of a level, and share of the samples there, of one of rest."""
BELOW = 0.05
"""Share of the samples that may lie below it."""
_ROUNDS = 10


def rest_level(v: FloatArray) -> float | None:
    """The lowest level at which an input of one sign stays; None where it stays nowhere for a tenth of the log, or is
    often lower.

    Parameters
    ----------
    v : FloatArray, shape (N,)
        The input, finite. Of a negative one its magnitude counts.

    Notes
    -----
    Cost: one sort of N values.
    """
    sign = -1.0 if -np.min(v) > np.max(v) else 1.0
    ordered = np.sort(sign * v)
    reach = NEAR * float(ordered[-1])
    if reach == 0.0:
        return 0.0
    places = np.arange(ordered[0], ordered[-1] + reach, reach)
    first, end = (np.searchsorted(ordered, places + side * reach) for side in (-1.0, 1.0))
    stays = np.flatnonzero(end - first >= SHARE * v.size)
    if not stays.size or first[stays[0]] > BELOW * v.size:
        return None
    level = float(places[stays[0]])
    for _ in range(_ROUNDS):  # to the middle of the samples there, which that place need not be
        middle = float(
            np.median(ordered[np.searchsorted(ordered, level - reach) : np.searchsorted(ordered, level + reach)])
        )
        if middle == level:
            break
        level = middle
    return sign * level
