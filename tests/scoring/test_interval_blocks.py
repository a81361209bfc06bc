"""Blocks of the bootstrap are as long as the errors of a device hang together; those of the joint are 2 s."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lfilter

from pipeline.device.device import JOINT
from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.intervals import block_of, decorrelation_lag, excess_over_lowest, rms_interval

OTHER = replace(JOINT, action="linear")


def first_order(memory: float, samples: int, rng: np.random.Generator) -> FloatArray:
    """An AR(1) error of RMS 1 whose autocorrelation falls to 1/e in so many samples."""
    pole = np.exp(-1.0 / memory)
    started = lfilter([1.0], [1.0, -pole], rng.normal(size=samples + round(20 * memory)))[-samples:]
    return np.asarray(started * np.sqrt(1.0 - pole**2))


def test_the_correlation_time_is_that_of_the_error_masked_or_not() -> None:
    error = first_order(40.0, 20_000, np.random.default_rng(1))
    masked = np.where(np.arange(error.size) % 5 == 0, np.nan, error)
    assert decorrelation_lag(error) == pytest.approx(40, rel=0.2)
    assert decorrelation_lag(masked) == pytest.approx(40, rel=0.2)
    assert decorrelation_lag(np.ones(100)) == decorrelation_lag(np.full(100, np.nan)) == 1


def test_intervals_of_a_slow_device_hold_the_truth() -> None:
    """A sample every 6 s, errors of 20 samples' memory: 2 s are one sample, and hold it in a third of logs."""
    rng = np.random.default_rng(2)
    held = {JOINT.action: 0, OTHER.action: 0}
    for _ in range(100):
        error = first_order(20.0, 1600, rng)
        for plant in (JOINT, OTHER):
            band = rms_interval(error, block_of((error,), 6.0, plant), rng)
            assert band is not None
            held[plant.action] += band.low <= 1.0 <= band.high
    assert held[OTHER.action] >= 80 and held[JOINT.action] < 50


def test_a_lead_that_slow_errors_make_by_chance_is_none() -> None:
    """Two errors of one distribution: 2 s blocks call the difference sure in most logs, 95 % intervals in few."""
    rng = np.random.default_rng(3)
    sure = 0
    for _ in range(60):
        errors = {name: first_order(20.0, 1600, rng) for name in "ab"}
        band = next(iter(excess_over_lowest(errors, 6.0, plant=OTHER).values()))
        assert band is not None
        sure += band.low > 0.0
    assert sure <= 15
