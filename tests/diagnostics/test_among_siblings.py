"""A joint among its siblings: how far it is from their mean, in their spreads."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnostics.calibrated import SHOWN, places_among
from pipeline.fitting.population import NormalPopulation
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.parameters import NAMES
from pipeline.models.hybrid.siblings import usual_prior
from tests.export.joints import hybrid

ODD, SURE = NAMES.index("left.log C0"), NAMES.index("log charging time")


@pytest.fixture
def population() -> NormalPopulation:
    """Siblings that are known to a tenth of the prior's spread, in the charging time to a twentieth."""
    spread = 0.1 * np.sqrt(np.diag(usual_prior().covariance))
    spread[SURE] *= 0.5
    return NormalPopulation(np.full(len(NAMES), 0.3), np.diag(spread**2))


def joint(population: NormalPopulation) -> HybridModel:
    """A joint with the siblings' mean but for one quantity, five of their spreads above, known to half a spread."""
    model, spread = hybrid(), np.sqrt(np.diag(population.covariance))
    theta, own = model.theta.copy(), np.zeros((len(model.theta), len(model.theta)))
    theta[: len(NAMES)] = population.mean
    theta[ODD] += 5.0 * spread[ODD]
    own[: len(NAMES), : len(NAMES)] = np.diag(0.5 * spread)
    return replace(model, theta=theta, spread=own)


def test_what_the_siblings_know_best_comes_first_and_what_is_odd_lies_apart(population: NormalPopulation) -> None:
    everything = np.array(population.covariance)
    everything[ODD, ODD] *= 0.25
    known = NormalPopulation(population.mean, everything)
    places = places_among(joint(known), known)
    assert len(places) == SHOWN and {place.name for place in places[:2]} == {"left capacitance", "charging time"}
    distances = {place.name: place.distance for place in places}
    assert distances.pop("left capacitance") == pytest.approx(5.0)
    assert max(map(abs, distances.values())) < 1e-9
    np.testing.assert_allclose([place.error for place in places], 0.5)
