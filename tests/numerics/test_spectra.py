"""Spectra and correlations are those of SciPy, which takes half a second to import."""

import numpy as np
import pytest
from scipy.signal import correlate, welch

from pipeline.numerics.spectra import correlation, power_density


@pytest.mark.parametrize(("count", "length"), [(1000, 200), (1000, 201), (333, 333), (50, 7)])
def test_they_are_what_scipy_says(count: int, length: int) -> None:
    x, y = np.random.default_rng(count).standard_normal((2, count)) + 3.0
    frequency, power = power_density(x, 0.01, length)
    known = welch(x, 100.0, nperseg=length)
    np.testing.assert_allclose(frequency, known[0], rtol=1e-12)
    np.testing.assert_allclose(power, known[1], rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(correlation(x, y), correlate(y, x, method="direct"), atol=1e-9 * count)


def test_the_density_adds_up_to_the_variance() -> None:
    x = np.sin(2.0 * np.pi * 8.0 * 0.01 * np.arange(4000)) + 5.0
    frequency, power = power_density(x, 0.01, 1000)
    assert power.sum() * frequency[1] == pytest.approx(0.5, rel=1e-3)
    assert frequency[np.argmax(power)] == pytest.approx(8.0)


def test_a_delayed_record_correlates_at_its_delay() -> None:
    x = np.random.default_rng(0).standard_normal(300)
    late = np.concatenate([np.zeros(7), x[:-7]])
    assert np.argmax(correlation(x, late)) - (x.size - 1) == 7
