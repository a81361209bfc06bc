import numpy as np
import pytest

from pipeline.signals.columns import CHUNK
from pipeline.signals.outliers import lost_bounds, trusted, without_spikes
from pipeline.signals.signal_quality import examine_signal

STEP = 1e-3


def log(n=4000, noise=1e-3, seed=1):
    rng = np.random.default_rng(seed)
    t = STEP * np.arange(n)
    return t, np.sin(2 * np.pi * 0.7 * t) + noise * rng.standard_normal(n)


def bounds(t, q, step):
    """Values beyond which q would be without a target."""
    return lost_bounds((t, q), (), examine_signal(t, q, step), step)


def masked(t, q, inputs=(), step=STEP, **policies):
    policies = {"rails": True, "lost": True, "spikes": True} | policies
    kept = trusted((t, q), [(t, v) for v in inputs], examine_signal(t, q, step), step, **policies)
    return kept, kept.samples


def test_a_clean_log_is_left_as_it_is():
    t, q = log()
    kept, seen = masked(t, q)
    assert (seen == q).all()
    assert kept.left_out == (0, 0, 0)


def test_exactly_the_clipped_and_the_planted_samples_are_masked():
    t, q = log()
    clipped = np.clip(q, -0.8, None)
    spiked = [500, 1900, 3100]
    clipped[spiked] += 0.5
    kept, seen = masked(t, clipped)
    low = clipped == -0.8
    runs = low & (
        np.roll(low, 1) & np.roll(low, 2) | np.roll(low, 1) & np.roll(low, -1) | np.roll(low, -1) & np.roll(low, -2)
    )
    expected = runs.copy()
    expected[spiked] = True
    assert (np.isnan(seen) == expected).all()
    assert kept.left_out == (int(runs.sum()), 0, 3)
    assert (seen[~expected] == clipped[~expected]).all()


def test_rails_are_found_behind_spikes_and_a_lost_target():
    """Neither single samples far beyond them nor the level of a lost target are the sensor's end."""
    t, q = log()
    clipped = np.clip(q, -0.8, 0.8)
    alone = masked(t, clipped)[0]
    assert alone.quality.rails == ((-0.8, -0.8), (0.8, 0.8))
    clipped[[510, 1910]] += 2.0
    clipped[3110] -= 2.0
    spiked = masked(t, clipped)[0]
    assert spiked.quality.rails == alone.quality.rails and spiked.left_out[2] == 3
    clipped[2000:2200] = 5.0
    lost = masked(t, clipped)[0]
    assert lost.quality.rails == alone.quality.rails and lost.left_out[1] == 200
    assert lost.quality.low_rail == pytest.approx(alone.quality.low_rail, rel=0.1)


def test_what_shall_be_kept_is_kept():
    t, q = log()
    clipped = np.clip(q, -0.8, None)
    clipped[500] += 0.5
    assert np.isfinite(masked(t, clipped, rails=False, spikes=False)[1]).all()
    assert np.flatnonzero(np.isnan(masked(t, clipped, rails=False)[1])).tolist() == [500]


@pytest.mark.parametrize("seam", [CHUNK - 2, CHUNK - 1, CHUNK, CHUNK + 1])
def test_chunks_do_not_change_what_is_masked(seam):
    t, q = log(CHUNK + 50)
    q[seam - 1 : seam + 2] = 3.0  # three at the upper rail, across the seam of two chunks
    q[seam - 20] += 0.5
    for lost, counts in ((False, (3, 0, 1)), (True, (0, 3, 1))):  # which are a burst too
        kept, seen = masked(t, q, lost=lost)
        assert np.flatnonzero(np.isnan(seen)).tolist() == [seam - 20, seam - 1, seam, seam + 1]
        assert kept.left_out == counts


def test_a_laser_without_its_target_is_masked_with_the_samples_of_the_jumps():
    t, q = log()
    rng = np.random.default_rng(2)
    for start in (800, 2500):
        q[start : start + 120] = 7.0 + 2e-3 * rng.standard_normal(120)
        q[start - 1] = 4.0  # the converter's filter shows one sample of the jump
    kept, seen = masked(t, q)
    expected = np.zeros(q.size, dtype=bool)
    for start in (800, 2500):
        expected[start - 1 : start + 120] = True
    assert np.isnan(seen[800:920]).all()
    assert np.isnan(seen[2500:2620]).all()
    assert np.count_nonzero(np.isnan(seen)) <= expected.sum()
    assert kept.left_out[1] >= 240
    assert np.nanmax(seen) < 4.1
    assert np.isfinite(masked(t, q, lost=False)[1][801:919]).all()


@pytest.mark.parametrize("frequency", [0.0, 0.3])
def test_a_joint_that_rests_in_its_other_well_has_not_lost_the_laser(frequency):
    """Two wells with fast switches, sampled slowly; and slow motion through everything between."""
    rng, t = np.random.default_rng(4), 0.01 * np.arange(3000)
    side = np.where(np.sin(2 * np.pi * 0.2 * t) > 0.4, 1.0, -1.0)
    q = np.convolve(side, np.ones(8) / 8, "same") * (1.0 + 0.2 * np.sin(2 * np.pi * frequency * t))
    q += 1e-3 * rng.standard_normal(t.size)
    assert bounds(t, q, 0.01) == (-np.inf, np.inf)


def _joint(noise=1e-5):
    """60 s of a bistable joint under pulses every second or so, at 1 kHz: (t, q [m], v [V])."""
    rng, t = np.random.default_rng(11), STEP * np.arange(60_000)
    starts = np.arange(1.0, 59.0, 1.0) + 0.3 * rng.random(58)
    v = 3e3 * np.any([(t >= start) & (t < start + 0.2) for start in starts], axis=0)
    side = np.where(np.searchsorted(starts + 0.08, t) % 2, 1.0, -1.0)
    q = 8e-3 * np.convolve(side, np.ones(40) / 40, "same") + 1e-6 * v + 3e-4 * np.sin(2 * np.pi * 9.0 * t)
    return t, q + noise * rng.standard_normal(t.size), v


@pytest.mark.parametrize("begin", [None, 7_350, 7_777])
def test_a_target_lost_at_a_pulse_by_chance_is_masked_all_the_same(begin):
    """At the edge of a pulse, or in the middle of nothing; the sensor does not know the voltage."""
    t, q, v = _joint()
    begin = begin or int(np.flatnonzero(np.diff(v) > 0.0)[12]) + 3
    for first, length in ((begin, 140), (30_500, 80)):
        q[first : first + length] = 25e-3
    kept, seen = masked(t, q, [v])
    assert kept.left_out[1] == 220
    assert np.isnan(seen[begin : begin + 140]).all()
    q[30_500:30_580] = q[30_400:30_480]
    assert masked(t, q, [v])[0].left_out[1] == 140
    dense = np.random.default_rng(1).standard_normal(t.size)  # steps at every sample: whatever jumps, jumps at one
    assert masked(t, q, [dense])[0].left_out[1] == 140


def _lamp(levels, noise):
    """A lamp that answers every step of its input within two samples, and its sensor, at 200 Hz: (t, q, v)."""
    rng, t = np.random.default_rng(5), 5e-3 * np.arange(4000)
    v = np.repeat(np.tile(np.array(levels)[[0, 1, 0, 2]], 4), 250)
    shown = np.concatenate((v[:2], v[:-2]))
    return t, shown * (1.0 + noise * rng.standard_normal(t.size)), v


def test_a_lamp_at_full_power_is_not_a_lost_target():
    """It jumps to a far constant level and stays there, but whenever its input does, once or often."""
    t, q, v = _lamp([0.0, 10.0, 87.0], noise=1e-4)
    slow = np.sin(2 * np.pi * 0.1 * t)
    assert masked(t, q, [v, slow], step=5e-3)[0].left_out[1] == 0
    assert masked(t, q, [slow], step=5e-3)[0].left_out[1] > 500
    once = (t > 5.0) & (t < 9.0)
    assert masked(t, 80.0 * once + 0.01 * slow, [1.0 * once], step=5e-3)[0].left_out[1] == 0
    last = t > 12.0
    assert masked(t, 80.0 * last + 0.01 * slow, [1.0 * last], step=5e-3)[0].left_out[1] == 0


def test_a_level_that_flickers_is_measured():
    """Of 3 % of the range at most is what hardly changes; noise of the rest does not make it wider."""
    t, q, _ = _lamp([0.0, 40.0, 87.0], noise=0.02)
    assert bounds(t, q, 5e-3) == (-np.inf, np.inf)
    coarse = np.round(q / 5.0) * 5.0
    assert bounds(t, coarse, 5e-3) == (-np.inf, np.inf)


def test_a_motor_that_starts_is_not_a_sensor_without_a_target():
    """Three samples far off the rest, each elsewhere."""
    rng, t = np.random.default_rng(6), 0.02 * np.arange(2000)
    q = 700.0 + 150.0 * np.sin(2 * np.pi * 0.05 * t) + 5.0 * rng.standard_normal(t.size)
    q[:4] = [0.0, 45.0, 150.0, 260.0]
    assert bounds(t, q, 0.02) == (-np.inf, np.inf)


def test_half_of_a_log_is_not_without_a_target():
    """Four samples of ten at the level, and two of the jumps between, beyond the middle of the gap as well."""
    t = 0.02 * np.arange(3000)
    there = np.tile([0, 0, 0, 0, 4.0, 5.0, 5.0, 5.0, 5.0, 4.0], 300)
    q = np.where(there > 0, there, np.sin(2 * np.pi * 0.33 * t))
    assert bounds(t, q, 0.02) == (-np.inf, np.inf)


def test_a_turning_point_in_steps_is_no_rail_but_the_same_signal_clipped_is():
    t, step = STEP * np.arange(4000), 0.01
    q = np.round(np.sin(2 * np.pi * 0.7 * t) / step) * step
    assert np.count_nonzero(q == q.max()) > 10
    quality = examine_signal(t, q, STEP)
    assert (quality.low_rail, quality.high_rail) == (0.0, 0.0)
    assert masked(t, q)[0].left_out == (0, 0, 0)
    clipped = examine_signal(t, np.minimum(q, 0.7), STEP)
    assert clipped.high_rail > 0.1
    assert clipped.low_rail == 0.0


def test_the_noise_of_a_fast_device_is_not_its_motion():
    rng, t = np.random.default_rng(5), STEP * np.arange(8000)
    fast = np.sin(2 * np.pi * 90.0 * t) * np.sin(2 * np.pi * 0.5 * t) + 1e-3 * rng.standard_normal(t.size)
    quality = examine_signal(t, fast, STEP)
    assert quality.noise == pytest.approx(1e-3, rel=0.9)
    assert quality.spikes == 0


@pytest.mark.parametrize(("step", "bridged"), [(1e-4, True), (1e-3, True), (2e-3, False), (1e-2, False)])
def test_single_samples_of_an_input_are_bridged_where_no_drive_is_as_fast(step, bridged):
    """A controller at 100 Hz kicks for one period; a probe at 1 kHz that shows one sample of 3 kV has erred."""
    rng, t = np.random.default_rng(8), step * np.arange(4000)
    v = 1000.0 + 3.0 * rng.standard_normal(t.size)
    v[[700, 2000, 3300]] += [2000.0, -800.0, 300.0]
    (_, after), count, first = without_spikes((t, v), step)
    if not bridged:
        assert count == 0 and after is v
    else:
        assert count == 3 and first == t[700]
        assert np.flatnonzero(np.abs(after[:] - v) > 0.0).tolist() == [700, 2000, 3300]
        assert np.abs(after[:] - 1000.0).max() < 20.0
