"""A population from a few members: neither too sure nor moved by an odd one, and the odd one named."""

import numpy as np
import pytest

from pipeline.fitting.population import (
    FALSE_ALARMS,
    Information,
    NormalPopulation,
    estimate_population,
    log_evidence,
    oddity,
    without_each,
)
from pipeline.numerics.arrays import FloatArray

COUNT = 20
PRIOR = NormalPopulation(np.zeros(COUNT), np.eye(COUNT))
SPREAD = np.where(np.arange(COUNT) < 12, 0.2, 1.0)
MEAN = np.where(np.arange(COUNT) < 12, 0.7, 0.0)


def draws(count: int, rng: np.random.Generator) -> FloatArray:
    drawn: FloatArray = MEAN + SPREAD * rng.standard_normal((count, COUNT))
    return drawn


def shown(theta: FloatArray, rng: np.random.Generator, seen: int = 30) -> Information:
    """What a log of one member shows: readings of random combinations of the first 15 entries."""
    rows = rng.standard_normal((seen, COUNT))
    rows[:, 15:] = 0.0
    readings = rows @ theta + 0.1 * rng.standard_normal(seen)
    return Information(rows.T @ rows / 0.01, rows.T @ readings / 0.01)


@pytest.mark.parametrize("count", [5, 12, 30])
def test_what_few_members_teach_holds_for_the_next_ones(count: int) -> None:
    distances, gains, shares = [], [], []
    for seed in range(6):
        rng = np.random.default_rng(seed)
        learnt = estimate_population([shown(theta, rng) for theta in draws(count, rng)], PRIOR)
        new = draws(20, rng)
        distances.append((new - learnt.mean)[:, :12] / np.sqrt(np.diag(learnt.covariance)[:12]))
        gains += [
            log_evidence(member, learnt) - log_evidence(member, PRIOR)
            for member in (shown(theta, rng, seen=6) for theta in new)
        ]
        shares.append(np.sqrt(np.diag(learnt.covariance)))
    assert 0.3 < np.sqrt(np.mean(np.square(distances))) < 1.15
    assert np.median(gains) > 0.5
    assert np.mean(np.array(shares)[:, :12]) < {5: 0.7, 12: 0.5, 30: 0.4}[count]
    assert np.mean(np.array(shares)[:, 15:]) == pytest.approx(1.0, abs=0.15)  # of these no log shows anything


def test_an_odd_member_is_named_with_its_size_and_moves_the_others_little() -> None:
    named, alarms, others = 0, 0, 0
    for seed in range(8):
        rng = np.random.default_rng(seed)
        theta = draws(15, rng)
        usual = estimate_population([shown(each, np.random.default_rng(9)) for each in theta], PRIOR)
        theta[3, 4] += 3.0
        members = [shown(each, np.random.default_rng(9)) for each in theta]
        whole = estimate_population(members, PRIOR)
        assert abs(whole.mean[4] - usual.mean[4]) < 0.15
        assert np.sqrt(whole.covariance[4, 4]) < 2.0 * np.sqrt(usual.covariance[4, 4])
        for i, (member, rest) in enumerate(zip(members, without_each(members, PRIOR, whole), strict=True)):
            found = oddity(member, rest, len(members) - 1, range(len(member.vector)))
            if i == 3:
                named += found.odd and found.entry == 4 and abs(found.size - 3.0) < 3.0 * found.error
            else:
                others, alarms = others + 1, alarms + found.odd
    assert named >= 7
    assert alarms <= 2.0 * FALSE_ALARMS * others
