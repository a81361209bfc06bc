import numpy as np
import pytest

from pipeline.signals.columns import CHUNK
from pipeline.signals.signal_quality import examine_signal
from pipeline.signals.untrusted import trusted

STEP = 1e-3


def log(n=4000, noise=1e-3, seed=1):
    rng = np.random.default_rng(seed)
    t = STEP * np.arange(n)
    return t, np.sin(2 * np.pi * 0.7 * t) + noise * rng.standard_normal(n)


def masked(t, q, **policies):
    kept = trusted(q, examine_signal(t, q, STEP), STEP, **({"rails": True, "lost": True, "spikes": True} | policies))
    return kept, kept[0 : kept.size]


def test_a_clean_log_is_left_as_it_is():
    t, q = log()
    kept, seen = masked(t, q)
    assert (seen == q).all()
    assert kept.left_out() == (0, 0, 0)


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
    assert kept.left_out() == (int(runs.sum()), 0, 3)
    assert (seen[~expected] == clipped[~expected]).all()


def test_rails_are_found_behind_spikes_and_a_lost_target():
    """Neither single samples far beyond them nor the level of a lost target are the sensor's end."""
    t, q = log()
    clipped = np.clip(q, -0.8, 0.8)
    alone = masked(t, clipped)[0]
    assert alone.rails == (-0.8, 0.8)
    clipped[[510, 1910]] += 2.0
    clipped[3110] -= 2.0
    spiked = masked(t, clipped)[0]
    assert spiked.rails == (-0.8, 0.8) and spiked.left_out()[2] == 3
    clipped[2000:2200] = 5.0
    lost = masked(t, clipped)[0]
    assert lost.rails == (-0.8, 0.8) and lost.left_out()[1] == 200
    assert lost.quality.low_rail == pytest.approx(alone.quality.low_rail, rel=0.1)


def test_what_shall_be_kept_is_kept():
    t, q = log()
    clipped = np.clip(q, -0.8, None)
    clipped[500] += 0.5
    assert np.isfinite(masked(t, clipped, rails=False, spikes=False)[1]).all()
    assert np.flatnonzero(np.isnan(masked(t, clipped, rails=False)[1])).tolist() == [500]


@pytest.mark.parametrize("seam", [CHUNK - 2, CHUNK - 1, CHUNK, CHUNK + 1])
def test_neither_slices_nor_chunks_change_what_is_masked(seam):
    t, q = log(CHUNK + 50)
    q[seam - 1 : seam + 2] = 3.0  # three at the upper rail, across the seam of two chunks
    q[seam - 20] += 0.5
    kept, seen = masked(t, q)
    assert np.flatnonzero(np.isnan(seen)).tolist() == [seam - 20, seam - 1, seam, seam + 1]
    assert kept.left_out() == (3, 0, 1)
    pieces = np.concatenate([kept[i : min(i + 7, kept.size)] for i in range(seam - 40, seam + 40, 7)])
    assert np.array_equal(pieces, seen[seam - 40 : seam - 40 + len(pieces)], equal_nan=True)


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
    assert kept.left_out()[1] >= 240
    assert np.nanmax(seen) < 4.1
    assert np.isfinite(masked(t, q, lost=False)[1][801:919]).all()


@pytest.mark.parametrize("frequency", [0.0, 0.3])
def test_a_joint_that_rests_in_its_other_well_has_not_lost_the_laser(frequency):
    """Two wells with fast switches, sampled slowly; and slow motion through everything between."""
    rng, t = np.random.default_rng(4), 0.01 * np.arange(3000)
    side = np.where(np.sin(2 * np.pi * 0.2 * t) > 0.4, 1.0, -1.0)
    q = np.convolve(side, np.ones(8) / 8, "same") * (1.0 + 0.2 * np.sin(2 * np.pi * frequency * t))
    q += 1e-3 * rng.standard_normal(t.size)
    kept = trusted(q, examine_signal(t, q, 0.01), 0.01, rails=True, lost=True, spikes=True)
    assert kept.bounds == (-np.inf, np.inf)


def test_a_turning_point_in_steps_is_no_rail_but_the_same_signal_clipped_is():
    t, step = STEP * np.arange(4000), 0.01
    q = np.round(np.sin(2 * np.pi * 0.7 * t) / step) * step
    assert np.count_nonzero(q == q.max()) > 10
    quality = examine_signal(t, q, STEP)
    assert (quality.low_rail, quality.high_rail) == (0.0, 0.0)
    assert masked(t, q)[0].left_out() == (0, 0, 0)
    clipped = examine_signal(t, np.minimum(q, 0.7), STEP)
    assert clipped.high_rail > 0.1
    assert clipped.low_rail == 0.0


def test_the_noise_of_a_fast_device_is_not_its_motion():
    rng, t = np.random.default_rng(5), STEP * np.arange(8000)
    fast = np.sin(2 * np.pi * 90.0 * t) * np.sin(2 * np.pi * 0.5 * t) + 1e-3 * rng.standard_normal(t.size)
    quality = examine_signal(t, fast, STEP)
    assert quality.noise == pytest.approx(1e-3, rel=0.9)
    assert quality.roughness > 0.05
    assert quality.spikes == 0
