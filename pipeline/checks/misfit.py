"""Whether two logs show one device: the accelerations of one, predicted by what the other taught, say so."""

from dataclasses import dataclass

import numpy as np

from pipeline.checks.weak_form import WeakTerms, solve, unexplained
from pipeline.numerics.arrays import BoolArray
from pipeline.numerics.metrics import rms

_TELLING = 0.01  # of the accelerations: two recorders, or two sampling rates, are that far apart
_LEAST_SHARED = 60


@dataclass(frozen=True)
class Misfit:
    """How one log's weak form explains another.

    Attributes
    ----------
    ratio : float
        Median residual of the other's accelerations over that of its own weights, or over `_TELLING` of their RMS
        where that is larger.
    unexplained : float
        RMS residual of the logs under their own weights over that of the accelerations, the larger of the two.
    together : float
        The same under weights that both logs have in common.
    """

    ratio: float
    unexplained: float
    together: float


def misfit(first: WeakTerms, second: WeakTerms) -> Misfit | None:
    """How much worse one log's weak form explains the other than that explains itself.

    Each log's weights predict the accelerations of the other, at those displacements that both visit; of the two
    directions that with the smaller ratio counts. Both logs must share their `Scales`. One device gives 0.8 to 1.2,
    whatever the voltages; another of the same drawing 2 and more.

    Returns
    -------
    Misfit or None
        None where the logs share too few displacements.
    """
    ratios = [
        ratio for a, b in ((first, second), (second, first)) if (ratio := _ratio(a, b, _shared(a, b))) is not None
    ]
    if not ratios:
        return None
    return Misfit(min(ratios), max(unexplained(first), unexplained(second)), _together(first, second))


def _together(first: WeakTerms, second: WeakTerms) -> float:
    """What weights in common leave of the log that they explain less, both logs counting alike."""
    logs = [(terms.design(), terms.inertia) for terms in (first, second)]
    sizes = [max(float(np.linalg.norm(inertia)), np.finfo(float).tiny) for _, inertia in logs]
    scaled = [(design / size, inertia / size) for (design, inertia), size in zip(logs, sizes, strict=True)]
    weights = solve(np.vstack([design for design, _ in scaled]), np.concatenate([inertia for _, inertia in scaled]))
    return max(float(np.linalg.norm(inertia - design @ weights)) for design, inertia in scaled)


def _shared(taught: WeakTerms, judged: WeakTerms) -> BoolArray:
    """Bumps of `judged` at displacements that `taught` has seen, outliers left out."""
    low, high = np.quantile(taught.q, (0.01, 0.99))
    inside: BoolArray = (judged.q >= low) & (judged.q <= high)
    return inside


def _ratio(taught: WeakTerms, judged: WeakTerms, rows: BoolArray) -> float | None:
    if np.count_nonzero(rows) < _LEAST_SHARED:
        return None
    design, inertia = judged.design(), judged.inertia
    foreign = inertia - design @ solve(taught.design(), taught.inertia)
    own = inertia - design @ solve(design, inertia)
    size = max(float(np.median(np.abs(own[rows]))), _TELLING * rms(inertia))
    return float(np.median(np.abs(foreign[rows]))) / size if size > 0.0 else None
