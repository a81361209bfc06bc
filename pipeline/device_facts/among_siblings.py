"""Where a joint lies among its siblings: its deviations over what `debist fleet learn` found of the others."""

from dataclasses import dataclass

import numpy as np

from pipeline.fitting.population import NormalPopulation
from pipeline.models.base import DynamicModel
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.siblings import title, usual_prior

SHOWN = 12
"""Quantities that are shown: those of which the siblings tell most over the prior."""


@dataclass(frozen=True)
class AmongSiblings:
    """A quantity of a joint among its siblings, in standard deviations of the siblings from their mean.

    `error` is the standard deviation that the joint's own posterior leaves.
    """

    name: str
    distance: float
    error: float


def places_among(model: DynamicModel | None, siblings: NormalPopulation | None) -> list[AmongSiblings]:
    """The quantities that the siblings know best, the best known first; none without siblings or of another model."""
    if siblings is None or not isinstance(model, HybridModel):
        return []
    spread, before = (np.sqrt(np.diag(each.covariance)) for each in (siblings, usual_prior()))
    own = np.sqrt(np.sum(model.spread[: len(spread)] ** 2, axis=1))
    distances = (model.theta[: len(spread)] - siblings.mean) / spread
    best = np.argsort(spread / before, kind="stable")[:SHOWN]
    return [AmongSiblings(title(int(i)), float(distances[i]), float(own[i] / spread[i])) for i in best]
