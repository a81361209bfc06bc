"""Moving-block bootstrap: known sampling distributions, dependence, masking and pairing."""

import numpy as np
import pytest

from pipeline.scoring.intervals import rms_difference_interval, rms_interval


def test_width_on_white_noise_is_that_of_theory() -> None:
    """The RMS of N normal draws has the standard deviation σ/sqrt(2N)."""
    error = np.random.default_rng(1).normal(size=20_000)
    band = rms_interval(error, 10, np.random.default_rng(2))
    assert band is not None
    assert band.high - band.low == pytest.approx(2 * 1.96 / np.sqrt(2 * error.size), rel=0.1)
    assert band.low < np.sqrt(np.mean(error**2)) < band.high


def test_coverage_of_a_correlated_error() -> None:
    """An AR(1) error of known variance: 95 % nominal covers at least 85 % (blocks understate a little)."""
    rng = np.random.default_rng(3)
    covered = 0
    for _ in range(100):
        noise = rng.normal(size=4000)
        error = np.empty(4000)
        error[0] = noise[0] / np.sqrt(1 - 0.9**2)
        for k in range(1, 4000):
            error[k] = 0.9 * error[k - 1] + noise[k]
        band = rms_interval(error, 100, rng)
        assert band is not None
        covered += band.low <= 1 / np.sqrt(1 - 0.9**2) <= band.high
    assert covered >= 85


def test_pairing_sees_a_difference_that_hides_between_separate_intervals() -> None:
    rng = np.random.default_rng(7)
    shared = np.repeat(rng.exponential(size=40), 100) * rng.normal(size=4000)
    worse, better = 1.1 * shared, shared
    apart = [rms_interval(e, 200, np.random.default_rng(8)) for e in (worse, better)]
    assert apart[0] is not None and apart[1] is not None and apart[0].low <= apart[1].high
    paired = rms_difference_interval(worse, better, 200, np.random.default_rng(8))
    assert paired is not None and paired.low > 0.0
