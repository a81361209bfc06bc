"""Rounded stamps of a uniform clock are known by their lattice; those of any other clock stay as they are."""

import numpy as np
import pytest

from pipeline.signals.rounded_clock import uniform_clock

N = 9000
T = np.arange(N) / 400.0
RNG = np.random.default_rng(3)


def digits(stamps, count):
    return np.array([float(f"{stamp:.{count}g}") for stamp in stamps])


def single(stamps):
    return stamps.astype(np.float32).astype(np.float64)


@pytest.mark.parametrize(
    ("stamps", "resolution"),
    [
        (np.round(T, 3), 1e-3),
        (np.floor(1e3 * T + 0.4) / 1e3, 1e-3),
        (np.round(T, 2), 1e-2),  # four rows of each stamp
        (1.7e9 + np.round(T, 3), 1e-3),
        (single(7200.0 + T), 2.0**-11),
        (digits(single(7200.0 + T), 9), 2.0**-11),  # as a text of it
        (single(4090.0 + T), 2.0**-11),  # the lattice widens at 4096
        (digits(990.0 + T, 6), 1e-2),  # and here at 1000
    ],
)
def test_a_uniform_clock_is_found_behind_its_rounded_stamps(stamps, resolution):
    clock = uniform_clock(stamps)
    assert clock.resolution == pytest.approx(resolution, rel=0.02)
    assert clock.step == pytest.approx(1.0 / 400.0, rel=1e-5)
    error = clock.time - T
    assert np.ptp(error) < 0.1 * np.ptp(stamps - T)


@pytest.mark.parametrize("rate", [333.0, 600.0, 700.0, 1024.0, 2000.0, 30000.0])
def test_at_any_rate(rate):
    true = np.arange(N) / rate
    assert np.ptp(uniform_clock(np.round(true, 3)).time - true) < 1e-9


def test_lost_rows_doubled_rows_gaps_and_missing_stamps_stay():
    kept = np.delete(np.arange(N), RNG.choice(np.arange(1, N - 1), 150, replace=False))
    lost = uniform_clock(np.round(T[kept], 3)).time
    np.testing.assert_allclose(lost - lost[0], T[kept], atol=1e-9)
    twice = uniform_clock(np.round(np.insert(T, 100, T[100]), 3)).time
    assert np.count_nonzero(np.diff(twice) == 0.0) == 1
    gap = T + np.where(T > 9.0, 7.1234, 0.0)
    np.testing.assert_allclose(np.diff(uniform_clock(np.round(gap, 3)).time), np.diff(gap), atol=1.1e-3)
    stamps = np.round(T, 3)
    stamps[50] = np.nan
    assert np.flatnonzero(np.isnan(uniform_clock(stamps).time)).tolist() == [50]


@pytest.mark.parametrize(
    "stamps",
    [
        T,
        T + 1.7e9,
        np.arange(N) / 3000.0,
        T + RNG.uniform(-1e-4, 1e-4, N),
        np.round(T + RNG.normal(0.0, 2e-4, N), 3),
        np.round(np.cumsum(RNG.normal(2.5e-3, 3e-4, N)), 3),
        np.cumsum(RNG.choice([2e-3, 3e-3], N)),
        np.delete(np.arange(N), [3000]) / 1000.0,
        np.delete(np.arange(N), RNG.choice(N, 20, replace=False)) / 1000.0,
        np.insert(np.arange(N), 3000, 3000) / 1000.0,
        T + np.where(np.arange(N) > 4000, 1.25e-3, 0.0),
        np.zeros(N),
        np.full(N, np.nan),
    ],
    ids=["exact", "epoch", "thirds", "jitter", "rounded jitter", "walk", "two steps at random", "a lost row",
         "lost rows", "a doubled row", "a pause", "never advances", "no stamp"],
)  # fmt: skip
def test_other_stamps_stay_as_they_are(stamps):
    assert uniform_clock(stamps) is None
