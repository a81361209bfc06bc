"""Planted rails, hum, spikes and frozen segments are found with their numbers; clean signals have none."""

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.signals.findings import scale_suspicion
from pipeline.signals.noise import hum, is_idle, resolution
from pipeline.signals.remarks import saturation_remarks
from pipeline.signals.signal_quality import examine_signal, in_a_row, usual_span
from tests.prototypes import motion

RATE = 10_000.0
T = np.arange(200_000) / RATE


def _signal(seed=0, noise=0.002):
    return 10.0 * np.sin(2 * np.pi * 0.7 * T) + np.random.default_rng(seed).normal(0.0, noise, T.size)


def test_clean_signal():
    quality = examine_signal(T, _signal(), 1 / RATE)
    assert quality.noise == pytest.approx(0.002, rel=0.02)
    assert (quality.not_finite, quality.spikes, quality.low_rail, quality.high_rail) == (0, 0, 0.0, 0.0)
    assert not quality.constant and not quality.idle
    assert all(abs(line.above_floor_db) < 3.0 for line in quality.hum)


@pytest.mark.parametrize("frequency", [50.0, 60.0])
@pytest.mark.parametrize("drift", [0.0, 0.13])
def test_hum_is_measured(frequency, drift):
    amplitude = 0.004
    [line] = hum(_signal() + amplitude * np.sin(2 * np.pi * (frequency + drift) * T), 1 / RATE, [frequency])
    assert line.amplitude == pytest.approx(amplitude, rel=0.02)
    assert line.above_floor_db > 25.0


def test_hum_beyond_nyquist_or_in_short_records_is_not_guessed():
    assert hum(np.sin(np.arange(10_000.0)), 0.01) == ()
    assert hum(_signal()[:70_000], 1 / RATE) == ()


def test_saturation():
    clipped = np.clip(_signal(), -9.0, 9.5)
    quality = examine_signal(T, clipped, 1 / RATE)
    assert quality.high_rail == pytest.approx(np.mean(clipped == 9.5), abs=2e-3)
    assert quality.low_rail == pytest.approx(np.mean(clipped == -9.0), abs=2e-3)
    assert quality.high_rail > 0.05


def test_spikes_are_told_from_steps():
    y = _signal()
    y[T > 10.0] += 5.0
    y[[1000, 150_000]] += [3.0, -3.0]
    quality = examine_signal(T, y, 1 / RATE)
    assert quality.spikes == 2
    assert quality.spikes_at == (T[1000], T[150_000])


@pytest.mark.parametrize("rate", [50, 100, 200])
def test_a_turning_point_of_a_slow_log_is_no_spike(rate: int):
    """Of a joint that snaps, a log has few samples of each swing."""
    every, masked = 1000 // rate, 0
    for seed in range(3):
        t, q, _ = motion(40.0, 1000.0, seed, noise=1e-6)
        for first in range(3):
            q_slow = q[first::every]
            masked += examine_signal(t[: q_slow.size] * every, q_slow, 1.0 / rate).spikes
    assert masked == 0


def test_frozen_segment():
    y = _signal()
    y[50_000:50_400] = y[50_000]
    quality = examine_signal(T, y, 1 / RATE)
    assert quality.frozen_at == T[50_000]
    assert quality.longest_frozen == pytest.approx(399 / RATE)


def test_not_finite_samples_are_located():
    y = _signal()
    y[[5, 77]] = [np.nan, np.inf]
    quality = examine_signal(T, y, 1 / RATE)
    assert quality.not_finite == 2 and quality.not_finite_at == (T[5], T[77])
    assert np.isfinite(quality.largest)


def test_constant_idle_and_empty_signals():
    assert examine_signal(T, np.full(T.size, 3.0), 1 / RATE).constant
    assert examine_signal(T, np.random.default_rng(0).normal(size=T.size), 1 / RATE).idle
    nothing = examine_signal(T, np.full(T.size, np.nan), 1 / RATE)
    assert nothing.not_finite == T.size and np.isnan(nothing.largest)


@pytest.mark.parametrize(
    ("span", "symbol", "factor"),
    [
        (0.044, "m", None),
        (44.0, "m", 1000.0),
        (44_000.0, "m", 1e6),
        (94.0, "rad", 1000.0),
        (3000.0, "V", None),
        (0.0, "m", None),
        (1e9, "Pa", None),
    ],
)
def test_scale_suspicion(span, symbol, factor):
    assert scale_suspicion(span, JOINT.plausible_span(symbol)) == (None if factor is None else pytest.approx(factor))


@pytest.mark.parametrize("samples", [[1.0, 2.0], [0.0, 0.0, 1.0, 1.0] * 50, [0.0, 1.0] * 50])
def test_what_stays_nowhere_for_three_samples_still_has_a_span_the_right_way_round(samples):
    assert usual_span(np.array(samples)) == (min(samples), max(samples))


def test_a_rest_that_a_drive_overshoots_is_no_rail():
    t = 0.02 * np.arange(3000)
    gone = t % 4.0
    step = 1.0 - np.exp(-6.0 * gone) * np.cos(12.0 * gone)
    q = np.round(1000.0 * np.where(t % 8.0 < 4.0, step, 1.0 - step))  # counts of an encoder
    found = examine_signal(t, q, 0.02)
    assert found.low_rail == found.high_rail == 0.0
    clipped = examine_signal(t, np.clip(q, 50.0, 950.0), 0.02)
    assert min(clipped.low_rail, clipped.high_rail) > 0.1


@pytest.mark.parametrize("held", [1, 2, 3, 5, 8, 40])
def test_a_random_binary_input_is_no_noise(held):
    prbs = np.repeat(np.random.default_rng(held).choice([-3.0, 3.0], 20_000), held)[:20_000]
    quality = examine_signal(np.arange(prbs.size) / 1000.0, prbs, 1e-3)
    assert not quality.idle and quality.levels == (-3.0, 3.0)
    assert not is_idle(prbs)
    rounded = prbs * (1.0 + 1e-15 * np.random.default_rng(0).integers(-2, 3, prbs.size))  # as interpolation leaves it
    assert not is_idle(rounded)


@pytest.mark.parametrize("held", [2, 3, 5])
def test_random_steps_are_no_noise(held):
    steps = np.repeat(np.random.default_rng(held).normal(size=20_000), held)[:20_000]
    quality = examine_signal(np.arange(steps.size) / 1000.0, steps, 1e-3)
    assert quality.stepped and not quality.idle and quality.levels == ()
    assert not is_idle(steps)


def test_the_flicker_of_a_converter_is_noise():
    """A channel at rest whose last digit flickers for a fifth of the time takes two values too."""
    flicker = 0.01 * (np.random.default_rng(0).random(20_000) < 0.2)
    quality = examine_signal(np.arange(flicker.size) / 1000.0, flicker, 1e-3)
    assert quality.idle and not quality.stepped
    assert is_idle(flicker)


def test_the_steps_of_an_encoder_are_seen_where_most_values_occur_once():
    """A drive that turns many times hardly meets the same count twice."""
    rng, step = np.random.default_rng(0), 360.0 / 2048.0
    angle = step * np.cumsum(rng.integers(1, 9, 2000))
    assert resolution(angle) == pytest.approx(step)
    assert resolution(np.round(angle, 3)) == pytest.approx(step, rel=1e-4)
    assert resolution(angle + 1e-3 * step * rng.random(2000)) is None or resolution(angle) > 1e-2 * step
    assert resolution(rng.normal(size=2000)) is None


def test_a_clipped_signal_is_found_whatever_the_digits_of_its_numbers():
    """Decimals lie on a grid too, but one far finer than any converter's."""
    t = np.arange(20_000) / 1000.0
    clipped = np.minimum(10.0 * np.sin(3.0 * t), 5.0) + 1e-4 * np.random.default_rng(0).normal(size=t.size)
    clipped = np.minimum(clipped, 5.0)
    for decimals in (5, 6, 15):
        quality = examine_signal(t, np.round(clipped, decimals), 1e-3)
        assert quality.high_rail == pytest.approx(np.mean(np.round(clipped, decimals) == 5.0), abs=0.1)
        assert quality.high_rail > 0.05


def _swings(rate=2000.0, seconds=20.0):
    """Swings of changing height up to 22 mm, as of a joint that is driven by a slow chirp."""
    t = np.arange(int(rate * seconds)) / rate
    return t, 22.0 * np.sin(0.3 * t) * np.sin(2 * np.pi * (2.0 + 0.3 * t) * t)


@pytest.mark.parametrize("rate", [1000.0, 2000.0, 10_000.0])
@pytest.mark.parametrize("noise", [0.003, 0.01, 0.03])
def test_a_laser_that_is_cut_off_beneath_its_noise(rate, noise):
    t, q = _swings(rate)
    added = noise * np.random.default_rng(1).normal(size=t.size)
    quality = examine_signal(t, np.clip(q, -18.0, 18.0) + added, 1.0 / rate)
    (low, high), (least, most) = quality.rails
    assert low < -18.0 < high and least < 18.0 < most and most - least < 12.0 * noise
    assert quality.high_rail == pytest.approx(np.mean(q > 18.0), abs=0.02)
    assert examine_signal(t, q + added, 1.0 / rate).rails == ()


def _pulses(lag, heights, rate=10_000.0):
    """Pulses behind a converter's lag [s]."""
    t = np.arange(int(rate * 8.0)) / rate
    command = np.where(t % 0.4 < 0.2, np.take(heights, (t / 0.4).astype(int) % len(heights)), 0.0)
    v, share = np.empty(t.size), 1.0 - np.exp(-1.0 / (rate * lag))
    level = 0.0
    for i, target in enumerate(command):
        level += share * (target - level)
        v[i] = level
    return t, v


def test_a_probe_that_saturates_beneath_its_noise():
    t, v = _pulses(3e-3, [3000.0, 2700.0, 1800.0, 2900.0])
    added = np.random.default_rng(2).normal(size=t.size)
    assert len([*saturation_remarks(t, np.minimum(v, 2500.0) + added, "V")]) == 1
    assert [*saturation_remarks(t, v + added, "V")] == []


def test_pulses_of_one_height_are_no_rail():
    added = np.random.default_rng(3).normal(size=80_000)
    t, lagging = _pulses(3e-3, [2500.0])
    assert [*saturation_remarks(t, lagging + added, "V")] == []
    square = np.where(t % 0.4 < 0.2, 2500.0, 0.0)
    assert [*saturation_remarks(t, square + added, "V")] == []
    ramped = np.interp(t % 0.4, [0.0, 0.02, 0.2, 0.22], [0.0, 2500.0, 2500.0, 0.0])
    assert [*saturation_remarks(t, ramped + added, "V")] == []
    triangle = np.interp(t % 0.4, [0.0, 0.2, 0.4], [0.0, 2500.0, 0.0])
    assert [*saturation_remarks(t, triangle + added, "V")] == []


def test_samples_in_a_row_are_three_or_more():
    inside = np.array([1, 1, 1, 0, 1, 1, 0, 1, 1, 1, 1], dtype=bool)
    assert in_a_row(inside).tolist() == [*inside[:4], False, False, *inside[6:]]
    assert in_a_row(inside[:0]).size == 0
