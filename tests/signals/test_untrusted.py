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
    kept = trusted(q, examine_signal(t, q, STEP), **({"rails": True, "spikes": True} | policies))
    return kept, kept[0 : kept.size]


def test_a_clean_log_is_left_as_it_is():
    t, q = log()
    kept, seen = masked(t, q)
    assert (seen == q).all()
    assert kept.left_out() == (0, 0)


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
    assert kept.left_out() == (int(runs.sum()), 3)
    assert (seen[~expected] == clipped[~expected]).all()


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
    assert kept.left_out() == (3, 1)
    pieces = np.concatenate([kept[i : min(i + 7, kept.size)] for i in range(seam - 40, seam + 40, 7)])
    assert np.array_equal(pieces, seen[seam - 40 : seam - 40 + len(pieces)], equal_nan=True)
