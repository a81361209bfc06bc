"""Weights of the single terms of a variation: small where the signal jumps, falling towards the ends."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from pipeline.numerics.arrays import FloatArray

_END_ZONE = 6.0
"""Width of the zone of relaxed ends in memory lengths of the smoother."""


def jump_weights(t: FloatArray, delta: float, order: int) -> FloatArray:
    """Weights that lift the penalty where the differences `t` of the last solution are large.

    Solving again with the weight ``delta/sqrt(T_i² + delta²)``, T_i the largest modulus of the differences up to
    `order` places from i, reweights the variation (Candès, Wakin & Boyd 2008): the fixed point minimises
    ``½ log(t² + delta²)`` instead of the modulus, whose price for a jump hardly grows with its height, so that jumps
    keep their height and the rest can be smoothed more.  Neighbours share the largest weight loss because a jump of a
    lower derivative makes as many large differences of alternating sign.

    Parameters
    ----------
    t : FloatArray, shape (N,)
        Differences [signal], zero in the first ``order + 1`` places.
    delta : float
        Size [signal] from which a difference counts as large.
    order : int
        Order m of the difference whose variation is penalised.

    Returns
    -------
    FloatArray, shape (N,)
        In (0, 1].

    References
    ----------
    E. J. Candès, M. B. Wakin, S. P. Boyd, Enhancing sparsity by reweighted l1 minimization, J. Fourier Anal. Appl. 14
    (2008) 877-905, doi:10.1007/s00041-008-9045-x.
    """
    around = sliding_window_view(np.pad(np.abs(t), order), 2 * order + 1)
    largest = np.asarray(around.max(axis=1))
    return np.asarray(delta / np.hypot(largest, delta))


def relaxed_ends(n: int, order: int, memory: float) -> FloatArray:
    """Weights that fall as the square of the distance to the nearer end (Oehlert 1992).

    Without them the minimiser meets both ends with its derivatives above m + 1 zero, whatever the signal does
    there; with them the error at the ends is of the order of the error inside.

    Parameters
    ----------
    n : int
        Number of samples.
    order : int
        Order m of the difference whose variation is penalised.
    memory : float
        Memory length of the smoother [samples], ``(lam/delta)^(1/(2m + 2))``.

    Returns
    -------
    FloatArray, shape (n,)
        In (0, 1].

    References
    ----------
    G. W. Oehlert, Relaxed boundary smoothing splines, Ann. Statist. 20 (1992) 146-160, doi:10.1214/aos/1176348516.
    """
    zone = min(_END_ZONE * memory, n / 3.0)
    index = np.arange(n, dtype=np.float64)
    distance = np.maximum(np.minimum(index - order, n - index), 1.0)
    return np.asarray(np.minimum(1.0, (distance / max(zone, 1.0)) ** 2))
