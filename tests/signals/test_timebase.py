"""Everything planted in a time base is counted and located; nothing else is."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from pipeline.errors import DataRefusedError
from pipeline.signals.survey import advancing_rows
from pipeline.signals.timebase import default_gap_limit, examine, nominal_step, segments


def test_clean_time_base():
    quality = examine(12.345 + np.arange(1000) / 30_000.0)
    assert quality.uniform
    assert quality.step == pytest.approx(1 / 30_000.0, rel=1e-9)
    assert (quality.n, quality.dropped, quality.gaps) == (1000, 0, 0)
    assert quality.start == 12.345


def test_planted_faults_are_counted_and_located():
    time = np.arange(10_000) * 1e-3
    time[2000:] += 0.012  # twelve missing samples
    time[3000:] += 0.002  # two missing ones, no gap
    time[5000] = time[4999]
    time[7000:] -= 0.5
    time[8000] = np.nan
    quality = examine(time)
    assert quality.gaps == 1
    assert quality.gaps_at[0] == pytest.approx((1.999, 2.012))
    assert quality.repeated == 1 and quality.repeated_at == (time[4999],)
    assert quality.backward == 1 and quality.backward_at == (time[6999],)
    assert quality.not_finite == 1
    # 2, one beside the repeated stamp, one for the stamp that is not finite; those of the gap are lost in the gap
    assert quality.dropped == 4
    assert not quality.uniform


def test_jitter_is_the_deviation_of_the_steps():
    rng = np.random.default_rng(0)
    time = np.arange(5000) * 0.01 + rng.normal(0.0, 5e-4, 5000)
    quality = examine(time)
    assert quality.jitter == pytest.approx(np.sqrt(2.0) * 5e-4, rel=0.05)
    assert not quality.uniform


def test_chunks_make_no_difference(monkeypatch):
    rng = np.random.default_rng(1)
    time = np.cumsum(rng.choice([0.0, 0.001, 0.01], 5000, p=[0.01, 0.98, 0.01]))
    whole = examine(time)
    monkeypatch.setattr("pipeline.signals.columns.CHUNK", 77)
    parts = examine(time)
    for field in ("gaps", "gaps_at", "repeated", "repeated_at", "dropped", "shortest", "longest"):
        assert getattr(parts, field) == getattr(whole, field)
    assert segments(time, 0.005).tolist() == [
        list(pair) for pair in zip([0, *_breaks(time)], [*_breaks(time), 5000], strict=True)
    ]


def _breaks(time):
    return [i + 1 for i in range(time.size - 1) if time[i + 1] - time[i] > 0.005]


@pytest.mark.parametrize("time", [[], [1.0], [1.0, 1.0], [np.nan, np.nan], [3.0, 2.0]])
def test_a_time_base_that_never_advances_is_refused(time):
    with pytest.raises(DataRefusedError, match="never advances"):
        nominal_step(np.array(time))


def test_gap_limit():
    assert default_gap_limit(0.01) == pytest.approx(0.05)
    assert default_gap_limit(1 / 30_000.0) == 1e-3


@given(st.lists(st.one_of(st.floats(-10, 10), st.just(float("nan")), st.just(float("inf"))), max_size=40))
def test_advancing_keeps_exactly_the_records(stamps):
    expected, reached = [], -20.0
    for stamp in stamps:
        later = bool(np.isfinite(stamp)) and stamp > reached
        expected.append(later)
        if np.isfinite(stamp):
            reached = max(reached, stamp)
    rows = advancing_rows(np.array([-30.0, -20.0, *stamps]), "split")
    assert rows.keep.tolist() == [True, True, *expected]


def test_one_segment_without_gaps():
    assert segments(np.arange(5.0), 1.0).tolist() == [[0, 5]]
    assert segments(np.array([2.0]), 1.0).tolist() == [[0, 1]]
