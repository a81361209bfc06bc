"""What is believed of the joint before the data: how wide deviations and corrections are, and how alike its sides.

A joint is built to be its own mirror image. So what its equations lack is nearly the same on both sides, and what a
parameter set does not know of it is common to both membranes; only a workshop's tolerances are each side's own.
"""

from collections.abc import Sequence

import numpy as np

from pipeline.joint.condensed_parameters import NAMES
from pipeline.joint.correction_table import CURVES
from pipeline.numerics.arrays import FloatArray, IntArray

OWN_MATERIAL, OWN_MOUNT = 0.045, 0.45
"""Shares of variance that are each side's own: in moduli and capacitance, as both membranes are cut from one film, and
in the places of the mounts."""

ALIKE = 0.9
"""Correlation of a correction with its mirror image."""

_MIRRORED = ((0, -1.0), (1, 1.0), (3, -1.0), (2, -1.0), (4, -1.0), (5, 1.0), (7, -1.0), (6, -1.0), (8, 1.0))
"""Of each row of the corrections' weights the row at −q that is its mirror image, and the sign."""


def prior_root(centres: int, rows: Sequence[int] = range(CURVES)) -> FloatArray:
    """Matrix A of the prior ‖A θ‖²/2 of deviations and corrections, both in widths, shape (P, P).

    Parameters
    ----------
    centres : int
        Number of Gaussians of each correction, symmetric about q = 0.
    rows : sequence of int
        The corrections whose weights θ holds, rows of `pipeline.joint.correction_table.CURVES`.
    """
    covariance = np.eye(len(NAMES) + CURVES * centres)
    for i, name in enumerate(NAMES):
        if name.startswith("left."):
            j = NAMES.index("right." + name.removeprefix("left."))
            covariance[i, j] = covariance[j, i] = 1.0 - (OWN_MATERIAL if "log" in name else OWN_MOUNT)
    for row, (image, sign) in enumerate(_MIRRORED):
        for n in range(centres):
            i, j = (len(NAMES) + r * centres + m for r, m in ((row, n), (image, centres - 1 - n)))
            if i != j:
                covariance[i, j] = sign * ALIKE
    kept = theta_places(centres, rows)
    root = np.linalg.inv(np.linalg.cholesky(covariance[np.ix_(kept, kept)]))
    return np.asarray(root, dtype=np.float64)


def theta_places(centres: int, rows: Sequence[int]) -> IntArray:
    """Places in θ of the deviations and of the weights of some corrections."""
    weights = len(NAMES) + centres * np.asarray(rows, dtype=np.int64)[:, None] + np.arange(centres)
    return np.concatenate([np.arange(len(NAMES)), weights.ravel()])
