"""The decimation kernel's figures, exactness on lines, and no step out of place."""

import numpy as np
import pytest

from pipeline.signals.resampling import REACH, decimated, filtered_samples, interpolate, kernel, sharpened, uniform_grid

T = 0.01


def decimate(time, columns, t_out, interval):
    """The columns on the grid, shape (k, M)."""
    return np.concatenate(list(decimated(time, columns, t_out, interval)), axis=1)


def _response(frequencies):
    """Frequency response of the kernel, frequencies in output rates, by a fine Riemann sum."""
    x = np.linspace(-REACH, REACH, 40_001)
    weights = kernel(x)
    weights /= weights.sum()
    return np.array([np.sum(weights * np.cos(2 * np.pi * f * x)) for f in np.atleast_1d(frequencies)])


def test_pass_band_is_flat():
    assert np.all(np.abs(_response(np.linspace(0.0, 0.1, 21)) - 1.0) <= 0.01)


def test_documented_attenuation():
    decibel = 20 * np.log10(np.abs(_response([0.41, 0.5, 0.9, 1.0])))
    np.testing.assert_allclose(decibel, [-3.0, -5.2, -19.0, -27.1], atol=0.15)


def test_stop_band_is_40_db_down():
    assert 20 * np.log10(np.max(np.abs(_response(np.linspace(1.08, 12.0, 600))))) < -40.0


@pytest.mark.parametrize("interval", [0.001, 0.01])
def test_step_stays_in_place_and_hardly_rings(interval):
    raw = np.arange(60_001) / 30_000.0
    at = 1.00137
    step = np.where(raw < at, 0.0, 3000.0)
    # Many grids with different offsets together sample the step response densely.
    response = []
    for offset in np.linspace(0.0, interval, 21)[:-1]:
        t = uniform_grid(0.5 + offset, 1.5, interval)
        response += list(zip(t, decimate(raw, [step], t, interval)[0], strict=True))
    t, value = np.array(sorted(response)).T
    middle = np.interp(1500.0, value[np.abs(t - at) < interval / 2], t[np.abs(t - at) < interval / 2])
    assert abs(middle - at) < 1 / 30_000.0
    assert 3000.0 * 1.01 < value.max() < 3000.0 * 1.016
    assert -3000.0 * 0.016 < value.min() < 0.0
    far = np.abs(t - at) > REACH * interval + 1 / 30_000.0
    np.testing.assert_allclose(value[far], np.where(t[far] < at, 0.0, 3000.0), atol=1e-8)


def test_no_group_delay():
    """A symmetric pulse keeps its centre to a thousandth of the interval."""
    raw = np.arange(0.0, 2.0, 1e-4)
    pulse = np.exp(-0.5 * ((raw - 1.0033) / 0.04) ** 2)
    t = uniform_grid(0.0, raw[-1], T)
    value = decimate(raw, [pulse], t, T)[0]
    assert abs(np.sum(t * value) / np.sum(value) - 1.0033) < 1e-3 * T


def test_straight_lines_are_exact_up_to_the_ends_at_any_spacing():
    rng = np.random.default_rng(1)
    raw = np.cumsum(rng.uniform(0.0002, 0.002, 3000))
    t = uniform_grid(raw[0], raw[-1], T)
    value = decimate(raw, [3.0 * raw - 1.0, np.full(raw.size, 7.0)], t, T)
    np.testing.assert_allclose(value[0], 3.0 * t - 1.0, atol=1e-11)
    np.testing.assert_allclose(value[1], 7.0, atol=1e-12)


def test_white_noise_is_reduced_as_documented():
    rng = np.random.default_rng(2)
    raw = np.arange(300_000) / 30_000.0
    t = uniform_grid(0.0, raw[-1], T)
    value = decimate(raw, [rng.normal(size=raw.size)], t, T)[0]
    assert np.std(value[3:-3]) == pytest.approx(0.92 / np.sqrt(300.0), rel=0.08)


def test_single_sample_segment():
    assert decimate(np.array([0.5]), [np.array([2.0])], np.array([0.5]), T).tolist() == [[2.0]]


def test_grid_ends_with_the_last_sample_despite_rounding():
    assert uniform_grid(12.345, 12.345 + 100 * 0.1, 0.1).size == 101
    assert uniform_grid(0.0, 0.0999, 0.01).size == 10


def test_interpolation_reproduces_parabolas_and_passes_samples_through():
    rng = np.random.default_rng(4)
    raw = np.cumsum(rng.uniform(0.007, 0.014, 50))
    t = np.linspace(raw[0], raw[-1], 333)
    np.testing.assert_allclose(
        interpolate(raw, 3 * raw**2 - raw + 1, t, smooth=True), 3 * t**2 - t + 1, rtol=0.0, atol=1e-12
    )
    y = rng.normal(size=raw.size)
    np.testing.assert_allclose(interpolate(raw, y, raw, smooth=True), y, atol=1e-12)


def test_linear_interpolation_cannot_overshoot():
    raw = np.arange(10) * 0.01
    step = np.where(raw < 0.045, 0.0, 3000.0)
    value = interpolate(raw, step, np.linspace(0.0, 0.09, 91), smooth=False)
    assert value.min() >= 0.0 and value.max() <= 3000.0


@pytest.mark.parametrize("size", [1, 2])
def test_interpolation_of_short_segments(size):
    raw = np.arange(size) * 0.01
    np.testing.assert_allclose(interpolate(raw, 2.0 + raw, raw, smooth=True), 2.0 + raw)


@pytest.mark.parametrize(("ratio", "within"), [(2, (1e-4, 2e-2)), (3, (3e-5, 5e-3)), (10, (3e-6, 3e-5))])
def test_a_simulation_is_filtered_as_a_log_is(ratio, within):
    """Its few values in a sample interval like the hundreds of a log."""

    def signals(t):
        return np.column_stack([np.sin(30.0 * t), np.cos(170.0 * t)])

    t, fine = 0.01 / ratio * np.arange(60 * ratio + 1), 0.01 / 300 * np.arange(60 * 300 + 1)
    grid = uniform_grid(0.0, t[-1], 0.01)
    filtered = filtered_samples(signals(t)[None], ratio)[0]
    assert filtered.shape == (grid.size, 2)
    inner = slice(int(REACH), -int(REACH))
    logged = decimate(fine, list(signals(fine).T), grid, 0.01)
    for found, signal, log, tolerance in zip(filtered.T, signals(t).T, logged, within, strict=True):
        np.testing.assert_allclose(found[inner], log[inner], atol=tolerance)
        assert np.abs(signal[::ratio][inner] - log[inner]).max() > 3.0 * tolerance
        np.testing.assert_array_equal(found[[0, 1, -2, -1]], signal[::ratio][[0, 1, -2, -1]])


def test_sharpened_samples_are_those_of_the_smooth_signal_that_was_filtered():
    fine = 0.01 / 300 * np.arange(60 * 300 + 1)
    grid = uniform_grid(0.0, fine[-1], 0.01)
    (logged,), true = decimate(fine, [np.sin(60.0 * fine)], grid, 0.01), np.sin(60.0 * grid)
    found = sharpened(logged, np.ones(grid.size, dtype=bool))
    assert np.abs(found - true)[4:-4].max() < 2e-3 < 0.3 * np.abs(logged - true)[4:-4].max()


@pytest.mark.parametrize("size", [0, 1, 4])
def test_a_segment_too_short_to_sharpen_is_left_as_it_is(size):
    np.testing.assert_array_equal(sharpened(np.arange(size) ** 2.0, np.ones(size, dtype=bool)), np.arange(size) ** 2)


def test_samples_beside_one_that_is_not_usable_are_left_as_they_are():
    samples, usable = np.cos(0.6 * np.arange(30.0)), np.ones(30, dtype=bool)
    usable[12] = False
    changed = np.flatnonzero(sharpened(samples, usable) != samples)
    np.testing.assert_array_equal(changed, [i for i in range(2, 28) if not 10 <= i <= 14])


def test_a_simulation_shorter_than_the_kernel_is_left_as_it_is():
    signal = np.arange(7.0)[:, None]
    np.testing.assert_array_equal(filtered_samples(signal, 2), signal[::2])


@pytest.mark.parametrize("apart", [4e-5, 1e-6, 1e-9])
def test_stamps_that_nearly_coincide_do_not_throw_q_out_of_its_range(apart):
    rng, t = np.random.default_rng(0), T * np.arange(400)
    q = np.sin(3.0 * t) + rng.normal(0.0, 1e-3, t.size)
    close = np.insert(t, 200, t[200] - apart)
    samples = np.insert(q, 200, q[200] + 5e-3)
    between = interpolate(close, samples, uniform_grid(0.0, t[-1], T / 7.0), smooth=True)
    beside = np.interp(uniform_grid(0.0, t[-1], T / 7.0), t, q)
    assert np.abs(between - beside).max() < 0.6 * np.abs(np.diff(q)).max()
