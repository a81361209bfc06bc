"""What is believed of the joint before the data: how wide deviations and corrections are, and how alike its sides.

A joint is built to be its own mirror image. So what its equations lack is nearly the same on both sides, and what a
parameter set does not know of it is common to both membranes; only a workshop's tolerances are each side's own.
"""

import numpy as np

from pipeline.joint.condensed_parameters import NAMES
from pipeline.joint.correction_table import CURVES
from pipeline.numerics.arrays import FloatArray

UNKNOWN = 2.0
"""Factor on the prior widths of what a parameter set states, where none of the device is given."""

UNKNOWN_WEIGHT = 6.0
"""The same of the weight over the inertia: a device of another size stands under the same gravity."""

DESIGNED = ("log E", "log eta", "log eta_v", "log Y", "log C0", "log Y_MW", "b", "e_z", "a", "e_x", "laser offset")
"""What a parameter set states, and where the laser has its zero."""

OWN_MATERIAL = 0.1
"""Share of a membrane's variance in moduli and capacitance that is its own: both are cut from one film."""

ALIKE = 0.9
"""Correlation of a correction with its mirror image."""

_MIRRORED = ((0, -1.0), (1, 1.0), (3, -1.0), (2, -1.0), (4, -1.0), (5, 1.0), (7, -1.0), (6, -1.0), (8, 1.0))
"""Of each row of the corrections' weights the row at −q that is its mirror image, and the sign."""


def unknown_device() -> FloatArray:
    """Factors on the prior widths where no parameter set of the device is given, shape (DEVIATIONS,)."""
    factors = {**dict.fromkeys(DESIGNED, UNKNOWN), "log weight": UNKNOWN_WEIGHT}
    return np.array([factors.get(name.split(".")[-1], 1.0) for name in NAMES])


def prior_root(widening: FloatArray, centres: int) -> FloatArray:
    """Matrix A of the prior ‖A θ‖²/2 of deviations and corrections, both in widths, shape (P, P).

    Parameters
    ----------
    widening : FloatArray, shape (DEVIATIONS,)
        Factors on the widths of the deviations; what they add is common to both sides.
    centres : int
        Gaussians of each correction, symmetric about q = 0.
    """
    covariance = np.diag(np.concatenate([widening**2, np.ones(CURVES * centres)]))
    for i, name in enumerate(NAMES):
        if name.startswith("left."):
            j = NAMES.index("right." + name.removeprefix("left."))
            own = OWN_MATERIAL if "log" in name else 1.0
            covariance[i, j] = covariance[j, i] = widening[i] * widening[j] - own
    for row, (image, sign) in enumerate(_MIRRORED):
        for n in range(centres):
            i, j = (len(NAMES) + r * centres + m for r, m in ((row, n), (image, centres - 1 - n)))
            if i != j:
                covariance[i, j] = sign * ALIKE
    root = np.linalg.inv(np.linalg.cholesky(covariance))
    return np.asarray(root, dtype=np.float64)
