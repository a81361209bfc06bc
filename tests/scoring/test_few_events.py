"""Intervals of shares of few events: published values, coverage, and width where nothing went wrong."""

import numpy as np
import pytest
import scipy.stats

from pipeline.scoring.intervals import share_interval


@pytest.mark.parametrize("right", [1, 5, 9])
def test_the_share_has_the_interval_of_jeffreys(right: int) -> None:
    band = share_interval(right, 10)
    assert band is not None
    low, high = scipy.stats.beta(right + 0.5, 10 - right + 0.5).ppf([0.025, 0.975])
    assert (band.low, band.high) == (pytest.approx(low), pytest.approx(high))


def test_coverage_of_a_share() -> None:
    """Averaged over true shares, 95 % nominal covers 93 to 97 % of the outcomes of 12 pulses (Brown et al. 2001)."""
    bands = [share_interval(k, 12) for k in range(13)]
    covered = [
        sum(
            scipy.stats.binom.pmf(k, 12, p)
            for k, band in enumerate(bands)
            if band is not None and band.low <= p <= band.high
        )
        for p in np.linspace(0.01, 0.99, 99)
    ]
    assert 0.93 < np.mean(covered) < 0.97
