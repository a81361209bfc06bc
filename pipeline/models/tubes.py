"""Tubes of free runs: where the measured displacement lies with nine tenths of probability.

The half width of a tube is

    w(t) = κ √(s(t)² + s₀²)

s(t) being the standard deviation of runs drawn from the posterior of the parameters, s₀ the error on the training data.
The draws give the shape: errors grow where the motion is sensitive, and fade where it settles. They include noise, and
not what the equations lack. So κ comes from the training data: it is the quantile of |error|/√(s² + s₀²) there, times
a factor of the kind of model, because a fit bends to its own data.

Split conformal prediction (Lei et al. 2018, doi:10.1080/01621459.2017.1307116) would take the quantile from a held-out
quarter of the log. A quarter has a few snaps only: on fifty simulated joints its quantile had a correlation of 0.3 with
that of another log, the quantile of the training data one of 0.7.

Draws that end in another well are no part of s. Where they are more than `OPEN` of all, they have a tube of their own.
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field
from pydantic import dataclasses as stored

from ..numerics.arrays import BoolArray, FloatArray
from .model_file import STORED, Unit

COVERAGE = 0.9
"""Probability with which a sample of another log lies in the tubes."""

APART = 0.25
"""Share of the operating range: a draw that is farther from the free run is in another well, or on its way there."""

OPEN = 0.05
"""Share of the draws in another well from which on they have a tube of their own."""


_NotNegative = Annotated[float, Field(ge=0.0, le=1e6)]


@stored.dataclass(frozen=True, config=STORED)
class TubeScale:
    """Scale of a model's tubes, also in its file; with a factor of zero the model has no tubes."""

    factor: _NotNegative = 0.0
    """Half width of the tubes over the spread of the draws."""
    floor: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Least spread: the error on the training data."""
    apart: Annotated[_NotNegative, Unit("{q}")] = 0.0
    """Distance from which on a draw is in another well."""


NO_TUBES = TubeScale()
"""Scale of a model that has no tubes."""


@dataclass(frozen=True)
class Tubes:
    """The tube about a free run, and that of the other well; all of shape (N,), NaN where there is none."""

    low: FloatArray
    high: FloatArray
    other_low: FloatArray
    other_high: FloatArray

    def hold(self, q: FloatArray) -> BoolArray:
        """Whether samples of q [m or rad], shape (N,), lie in one of the tubes."""
        inside = (q >= self.low) & (q <= self.high)
        return np.asarray(inside | ((q >= self.other_low) & (q <= self.other_high)))

    def coverage(self, q: FloatArray) -> float | None:
        """Share of the measured samples that lie in the tubes; None where nothing can be compared."""
        compared = np.isfinite(q) & np.isfinite(self.low)
        return float(np.mean(self.hold(q)[compared])) if compared.any() else None


def tube_scale(
    free: FloatArray, ensemble: FloatArray, measured: FloatArray, floor: float, margin: float, span: float
) -> TubeScale:
    """The scale that the training data ask for.

    Parameters
    ----------
    free, measured : FloatArray, shape (N,)
        Free run and measurement [m or rad] over the training data; NaN where masked.
    ensemble : FloatArray, shape (draws, N)
        The draws there.
    floor : float
        s₀ [m or rad].
    margin : float
        Errors on another log over those on the training data.
    span : float
        Operating range [m or rad].
    """
    apart = APART * span
    ratio = np.abs(free - measured) / _spread(free, ensemble, floor, apart)
    ratio = ratio[np.isfinite(ratio)]
    quantile = float(np.quantile(ratio, COVERAGE)) if ratio.size else 1.0
    return TubeScale(margin * quantile, floor, apart)


def tubes(free: FloatArray, ensemble: FloatArray, scale: TubeScale) -> Tubes:
    """The tubes of a free run.

    Parameters
    ----------
    free : FloatArray, shape (N,)
        The free run [m or rad].
    ensemble : FloatArray, shape (draws, N)
        Free runs of the draws.
    scale : TubeScale
        From `tube_scale`. Cost: a dozen flops for each sample of each draw.
    """
    width = scale.factor * _spread(free, ensemble, scale.floor, scale.apart)
    away = np.abs(ensemble - free) > scale.apart
    several = np.mean(away, axis=0) > OPEN
    others = np.where(away & several, ensemble, np.nan)
    lowest, highest = (np.full(free.shape, np.nan) for _ in range(2))
    lowest[several], highest[several] = np.nanmin(others[:, several], axis=0), np.nanmax(others[:, several], axis=0)
    return Tubes(free - width, free + width, lowest - width, highest + width)


def _spread(free: FloatArray, ensemble: FloatArray, floor: float, apart: float) -> FloatArray:
    """√(s² + s₀²), shape (N,)."""
    distance = ensemble - free
    near = np.abs(distance) <= apart
    count = np.maximum(np.count_nonzero(near, axis=0), 1)
    return np.asarray(np.sqrt(np.sum(np.where(near, distance, 0.0) ** 2, axis=0) / count + floor**2))
