"""Do two logs show one device? The accelerations of one, predicted by what the other taught, say so."""

import numpy as np

from pipeline.checks.weak_form import WeakTerms, solve
from pipeline.numerics.arrays import BoolArray

_LEAST_SHARED = 60


def misfit_ratio(first: WeakTerms, second: WeakTerms) -> float | None:
    """How much worse one log's weak form explains the other than that explains itself.

    Each log's weights predict the accelerations of the other, at those displacements that both visit; the median
    residual over that of the log's own weights is taken, and of the two directions the smaller one. Both logs must
    share their `Scales`. One device gives 0.8 to 1.2, whatever the voltages; another of the same drawing 2 and more.

    Returns
    -------
    float or None
        None where the logs share too few displacements, or one of them is explained without any residual.
    """
    ratios = [
        ratio for a, b in ((first, second), (second, first)) if (ratio := _misfit(a, b, _shared(a, b))) is not None
    ]
    return min(ratios, default=None)


def _shared(taught: WeakTerms, judged: WeakTerms) -> BoolArray:
    """Bumps of `judged` at displacements that `taught` has seen, outliers left out."""
    low, high = np.quantile(taught.q, (0.01, 0.99))
    inside: BoolArray = (judged.q >= low) & (judged.q <= high)
    return inside


def _misfit(taught: WeakTerms, judged: WeakTerms, rows: BoolArray) -> float | None:
    if np.count_nonzero(rows) < _LEAST_SHARED:
        return None
    design, inertia = judged.design(), judged.inertia
    foreign = inertia - design @ solve(taught.design(), taught.inertia)
    own = inertia - design @ solve(design, inertia)
    size = float(np.median(np.abs(own[rows])))
    return float(np.median(np.abs(foreign[rows]))) / size if size > 0.0 else None
