"""Tubes of free runs: calibrated on held-out data, wider where the draws differ, two where the well is open."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.models.base import TubeScale
from pipeline.models.free_runs import APART, COVERAGE, tube_scale, tubes

N, DRAWS, SPAN = 20_000, 32, 20e-3
MARGIN = 3.0
RNG = np.random.default_rng(3)
FREE = 0.4 * SPAN * np.sin(np.linspace(0.0, 40.0, N))
WIDTH = 1e-5 * (1.5 + np.sin(np.linspace(0.0, 90.0, N)))
ENSEMBLE = FREE + WIDTH * RNG.standard_normal((DRAWS, N))


def test_the_scale_is_the_quantile_of_held_out_errors_times_what_other_logs_need():
    measured = FREE + 2.0 * WIDTH * RNG.standard_normal(N)
    scale = tube_scale(FREE, ENSEMBLE, measured, 1e-9, MARGIN, SPAN)
    assert scale.factor == pytest.approx(MARGIN * 2.0 * 1.645, rel=0.05)
    assert (scale.floor, scale.apart) == (1e-9, APART * SPAN)


def test_tubes_with_the_bare_quantile_hold_nine_tenths_of_fresh_errors_of_the_same_law():
    scale = tube_scale(FREE, ENSEMBLE, FREE + 2.0 * WIDTH * RNG.standard_normal(N), 1e-9, MARGIN, SPAN)
    bare = replace(scale, factor=scale.factor / MARGIN)
    fresh = FREE + 2.0 * WIDTH * RNG.standard_normal(N)
    assert tubes(FREE, ENSEMBLE, bare).coverage(fresh) == pytest.approx(COVERAGE, abs=0.02)
    assert tubes(FREE, ENSEMBLE, scale).coverage(fresh) > 0.99


def test_a_tube_is_wide_where_the_draws_differ():
    made = tubes(FREE, ENSEMBLE, TubeScale(2.0, 1e-9, APART * SPAN))
    half = 0.5 * (made.high - made.low)
    assert np.corrcoef(half, WIDTH)[0, 1] > 0.9
    assert np.isnan(made.other_low).all()


def test_where_a_fifth_of_the_draws_fall_into_the_other_well_there_is_a_second_tube():
    split, behind = ENSEMBLE.copy(), slice(N // 2, None)
    split[: DRAWS // 5, behind] = -FREE[behind] - np.sign(FREE[behind]) * 0.5 * SPAN
    made = tubes(FREE, split, TubeScale(2.0, 1e-6, APART * SPAN))
    assert np.isnan(made.other_low[: N // 2]).all()
    assert np.isfinite(made.other_low[behind]).all()
    assert made.coverage(np.where(np.arange(N) < N // 2, FREE, split[0])) == 1.0
    # They do not widen the tube about the free run.
    alone = tubes(FREE, ENSEMBLE[DRAWS // 5 :], TubeScale(2.0, 1e-6, APART * SPAN))
    np.testing.assert_allclose(made.high[behind], alone.high[behind])
