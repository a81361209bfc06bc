"""Intervals of shares and medians of few events: published values, coverage, and width where nothing went wrong."""

import numpy as np
import pytest
import scipy.stats

from pipeline.scoring.intervals import median_interval, share_interval


@pytest.mark.parametrize("right", [1, 5, 9])
def test_the_share_has_the_interval_of_jeffreys(right: int) -> None:
    band = share_interval(right, 10)
    assert band is not None
    low, high = scipy.stats.beta(right + 0.5, 10 - right + 0.5).ppf([0.025, 0.975])
    assert (band.low, band.high) == (pytest.approx(low), pytest.approx(high))


def test_fourteen_of_fourteen_is_no_certainty() -> None:
    perfect, never = share_interval(14, 14), share_interval(0, 14)
    assert perfect is not None and never is not None
    assert perfect.high == 1.0 and 0.8 < perfect.low < 0.9
    assert never.low == 0.0 and never.high == pytest.approx(1.0 - perfect.low)
    assert share_interval(0, 0) is None


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


def test_median_interval_covers_the_true_median() -> None:
    rng = np.random.default_rng(2)
    bands = [median_interval(rng.exponential(size=11).tolist(), rng) for _ in range(300)]
    covered = [band.low <= np.log(2.0) <= band.high for band in bands if band is not None]
    assert len(covered) == 300 and 0.88 < np.mean(covered) < 0.99


def test_three_switches_have_no_interval() -> None:
    assert median_interval([0.1, 0.2, 0.3], np.random.default_rng(0)) is None
