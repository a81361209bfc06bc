"""Codes for no value are found, declared ones taken, and numbers that may be measurements kept."""

import numpy as np
import pytest

from pipeline.signals.columns import codes_in, masked, sparse

TIME = 0.002 * np.arange(5000)
PULSES = np.where(TIME % 1.0 < 0.2, 2800.0, 0.0)


def _with(code, at=slice(2000, 2012), samples=PULSES):
    spoilt = samples.copy()
    spoilt[at] = code
    return spoilt


@pytest.mark.parametrize("code", [-9999.0, 65535.0, 9.9e37, -9.9e37, np.float32(9.91e37), 1.7976931348623157e308])
def test_usual_codes_are_found_and_masked(code):
    samples = _with(float(code))
    codes = codes_in(samples)
    assert codes == {float(code): 12}
    clean = masked(samples, codes)[:]
    assert np.isnan(clean[2000:2012]).all() and np.array_equal(clean[2012:], samples[2012:])


@pytest.mark.parametrize(
    "samples",
    [
        PULSES,
        np.linspace(-9999.0, 65535.0, 5000),  # a code within the rest
        np.where(PULSES > 0.0, 9999.0, 0.0),  # a command at two levels
        _with(np.nan),
        np.full(50, 65535.0),
    ],
)
def test_numbers_that_may_be_measurements_are_kept(samples):
    assert codes_in(samples) == {}
    assert masked(samples, {}) is samples


def test_declared_codes_are_exactly_those_that_are_taken():
    samples = _with(-1.0, samples=_with(-9999.0, at=slice(10, 20)))
    assert codes_in(samples, [-1.0]) == {-1.0: 12}
    assert codes_in(samples, []) == {}
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(masked(samples, [-1.0])[:])), np.arange(2000, 2012))


def test_a_clock_passes_by_every_number_but_huge_ones():
    assert codes_in(_with(-9999.0, samples=TIME), of_time=True) == {}
    assert codes_in(_with(9.9e37, samples=TIME), of_time=True) == {9.9e37: 12}


@pytest.mark.parametrize(("every", "found"), [(1, 1), (2, 2), (10, 10), (97, 97)])
def test_a_slow_channel_is_taken_by_its_own_samples(every, found):
    slow = np.where(np.arange(5000) % every == 0, PULSES, np.nan)
    (time, samples), spacing = sparse((TIME, slow))
    assert spacing == found
    np.testing.assert_array_equal(time[:], TIME[::every])
    np.testing.assert_array_equal(samples[:], PULSES[::every])


def test_samples_that_are_lost_or_recorded_on_change_make_no_slow_channel():
    lost = _with(np.nan, at=slice(0, 2500))
    on_change = np.where(np.diff(PULSES, prepend=-1.0) != 0.0, PULSES, np.nan)
    on_change[[7, 900, 3001]] = 1.0
    for samples in (lost, on_change):
        assert sparse((TIME, samples))[1] == 1
