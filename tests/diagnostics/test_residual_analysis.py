"""Whiteness, cross-correlation and spectrum of residuals whose truth is known."""

import numpy as np
import pytest
from scipy.signal import lfilter, welch

from pipeline.diagnostics.residual_analysis import analyse_residual

DT, N = 0.01, 4000


def signals(seed):
    rng = np.random.default_rng(seed)
    u = (rng.random((N // 50, 2)) > 0.5).repeat(50, axis=0).astype(float)
    return rng, u, np.cumsum(rng.standard_normal(N))


def test_white_noise_stays_within_both_bands_as_often_as_stated():
    own, crossed = [], []
    for seed in range(20):
        rng, u, q = signals(seed)
        found = analyse_residual(q, q + rng.standard_normal(N), u, DT)
        own.append(np.mean(np.abs(found.correlation[found.lags > DT / 2]) > found.band))
        crossed.append(found.outside)
    assert np.mean(own) == pytest.approx(0.01, abs=0.006)
    assert np.mean(crossed) < 0.03


def test_a_coloured_residual_that_is_independent_of_the_input_stays_within_the_band_of_the_input():
    crossed = []
    for seed in range(20):
        rng, u, q = signals(seed)
        found = analyse_residual(q, q + lfilter([1.0], [1.0, -0.95], rng.standard_normal(N)), u, DT)
        assert np.mean(np.abs(found.correlation) > found.band) > 0.1
        crossed.append(found.outside)
    assert np.mean(crossed) < 0.05


def test_what_an_input_still_explains_shows_at_its_lag():
    rng, u, q = signals(1)
    late = np.concatenate((np.zeros(30), u[:-30, 1]))
    found = analyse_residual(q, q + late + 0.3 * rng.standard_normal(N), u, DT)
    assert found.lags[np.argmax(np.abs(found.with_inputs[1]))] == pytest.approx(0.30, abs=0.02)
    assert found.outside > 0.2
    assert np.abs(found.with_inputs[1]).max() > 3 * found.input_bands[1]


def test_gaps_leave_the_longest_segment_and_short_ones_nothing():
    rng, u, q = signals(3)
    gapped = np.where(np.arange(N) % 2500 < 10, np.nan, q)
    found = analyse_residual(gapped, q + rng.standard_normal(N), u, DT)
    assert found.band == pytest.approx(2.5758 / np.sqrt(2490), rel=1e-4)
    late = np.where(np.arange(N) < N - 500, np.nan, q)
    assert analyse_residual(late, q + 1.0, u, DT) is None


@pytest.mark.parametrize("count", [3000, 3749])
def test_the_spectra_are_those_of_scipy(count):
    x = np.random.default_rng(5).standard_normal(count).cumsum()
    frequency, density = welch(x, 1.0 / DT, nperseg=2 * count // 9, detrend="constant")
    found = analyse_residual(x, np.zeros(count), np.zeros((count, 1)), DT)
    np.testing.assert_allclose(found.frequency, frequency[1:], rtol=1e-12)
    np.testing.assert_allclose(found.density, density[1:], rtol=1e-9)
    np.testing.assert_allclose(found.measured_density, density[1:], rtol=1e-9)
