"""Uniform records: nothing shifted, nothing invented across gaps, everything left out is counted."""

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from pipeline.errors import DataRefusedError
from pipeline.signals.columns import Stream
from pipeline.signals.survey import inputs_unknown, survey
from pipeline.signals.uniform_record import Resampling


def uniform_record(t, q, v, interval, *, v_time=None, **policies):
    """The record of a log in memory; the voltages may have a time base of their own."""
    stamps = t if v_time is None else v_time
    voltages = {f"v{k}": (stamps, np.ascontiguousarray(column)) for k, column in enumerate(v.T, start=1)}
    return Resampling(survey((t, q), voltages, **policies), interval).record()


def _log(rate=2000.0, duration=4.0, start=12.345):
    t = start + np.arange(round(rate * duration)) / rate
    q = 0.01 * np.sin(2 * np.pi * 1.5 * t)
    v = np.column_stack([np.where(t % 1.0 < 0.5, 0.0, 3000.0), 100.0 * t])
    return t, q, v


def test_clean_log_keeps_its_clock():
    t, q, v = _log()
    record = uniform_record(t, q, v, 0.01)
    assert record.t[0] == 12.345
    np.testing.assert_allclose(np.diff(record.t), 0.01, rtol=1e-9)
    assert np.all(record.segment == 0) and record.segment.dtype == np.int32
    np.testing.assert_allclose(record.q, 0.01 * np.sin(2 * np.pi * 1.5 * record.t), atol=4e-6)
    np.testing.assert_allclose(record.v[:, 1], 100.0 * record.t, rtol=1e-12)
    report = record.report
    assert (report.method, report.gaps, report.masked_rows, report.segments) == ("decimated", 0, 0, 1)
    assert (report.repeated, report.backward, report.q_not_finite, report.time_not_finite) == (0, 0, 0, 0)


def test_inputs_are_unknown_where_time_or_an_input_lacks_for_long_and_not_where_q_does():
    t, q, v = _log()
    v[1000:1300, 1] = np.nan  # 0.15 s of the second input
    v[3000:3100, 0] = np.nan  # 0.05 s, which a straight line bridges
    q[5000:5600] = np.nan
    kept = (t < 12.345 + 3.0) | (t > 12.345 + 3.5)
    t, q, v = t[kept], q[kept], v[kept]
    columns = {f"v{k}": (t, np.ascontiguousarray(column)) for k, column in enumerate(v.T, start=1)}
    seen = survey((t, q), columns)
    (first, second) = inputs_unknown(seen, 0.1)
    assert first == pytest.approx((12.345 + 999 / 2000, 12.345 + 1300 / 2000))
    assert second == pytest.approx((12.345 + 3.0, 12.345 + 3.5), abs=1e-3)
    assert len(inputs_unknown(seen, 0.01)) == 3 and inputs_unknown(survey((t, t), {}), 0.01) == []


def test_the_cost_of_a_record_does_not_grow_with_the_square_of_its_segments():
    count = 20_000  # pieces of one row each, as a log of short segments gives
    begin = time.process_time()
    stream = Stream(iter(np.arange(float(count)).reshape(count, 1, 1)))
    np.testing.assert_array_equal(stream.read(count - 1)[0], np.arange(count - 1.0))
    assert stream.read(1)[0] == count - 1
    assert time.process_time() - begin < 5.0  # 0.02 s; 25 s if each piece counts all rows before it


def test_gaps_can_be_refused():
    t, q, v = _log()
    keep = np.abs(t - 14.0) > 0.01
    with pytest.raises(DataRefusedError, match=r"1 gap\(s\) longer than 2\.5 ms, the first from 13\.9895 s to 14\.01"):
        uniform_record(t[keep], q[keep], v[keep], 0.01, gaps="refuse")


def test_short_runs_of_nan_are_passed_over_and_counted():
    t, q, v = _log()
    clean = uniform_record(t, q, v, 0.01)
    q[[100, 2000, 2001, 5000]] = [np.nan, np.nan, np.inf, np.nan]
    record = uniform_record(t, q, v, 0.01)
    assert record.report.q_not_finite == 4
    assert np.all(record.segment == 0)
    np.testing.assert_allclose(record.q, clean.q, atol=2e-6)


def test_long_runs_of_nan_are_a_gap_in_either_signal():
    t, q, v = _log()
    q[2000:2100] = np.nan
    v[6000:6100, 0] = np.nan
    record = uniform_record(t, q, v, 0.01)
    assert record.report.gaps == 2 and record.report.segments == 3
    assert (record.report.q_not_finite, record.report.v_not_finite) == (100, 100)
    assert np.all(np.isfinite(record.v))


def test_nan_at_the_ends_shortens_the_record():
    t, q, v = _log()
    q[:10] = np.nan
    v[-40:, 0] = np.nan
    record = uniform_record(t, q, v, 0.01)
    assert record.t[0] == t[10]
    assert record.t[-1] <= t[-41] + 1e-8


def test_repeated_rows_count_once():
    t, q, v = _log()
    clean = uniform_record(t, q, v, 0.01)
    again = np.insert(np.arange(t.size), 4000, 3999)
    record = uniform_record(t[again], q[again], v[again], 0.01)
    assert record.report.repeated == 1
    np.testing.assert_array_equal(record.q, clean.q)


def test_time_that_steps_back_is_refused_by_default():
    t, q, v = _log()
    t = t.copy()
    t[4000:] -= 0.10025
    with pytest.raises(DataRefusedError, match=r"steps back at 1 place\(s\), first after 14\.3445 s"):
        uniform_record(t, q, v, 0.01)
    record = uniform_record(t, q, v, 0.01, time_reversal="split")
    assert record.report.backward == 200
    assert record.report.segments == 2
    assert record.segment[-1] == 1


def test_a_log_as_coarse_as_the_record_is_interpolated():
    rng = np.random.default_rng(0)
    t = np.cumsum(rng.choice([0.007, 0.01, 0.013], 3000))
    q = np.sin(2 * np.pi * 1.0 * t)
    record = uniform_record(t, q, q[:, None], 0.01)
    assert record.report.method == "interpolated"
    np.testing.assert_allclose(record.q, np.sin(2 * np.pi * 1.0 * record.t), atol=3e-4)
    on_grid = np.arange(300) * 0.01
    same = uniform_record(on_grid, np.cos(on_grid), on_grid[:, None], 0.01)
    np.testing.assert_allclose(same.q, np.cos(on_grid), atol=1e-12)


def test_without_time_in_common_nothing_is_made_up():
    t, q, v = _log()
    with pytest.raises(DataRefusedError, match="no segment of time in common"):
        uniform_record(t, q, v, 0.01, v_time=t + 100.0)


def test_signal_without_a_finite_sample():
    t, q, v = _log()
    with pytest.raises(DataRefusedError, match="no finite sample"):
        uniform_record(t, np.full_like(q, np.nan), v, 0.01)


@settings(deadline=None, max_examples=60)
@given(st.data())
def test_rows_are_masked_exactly_where_a_hole_is_within_reach(data):
    seed = data.draw(st.integers(0, 10_000))
    rng = np.random.default_rng(seed)
    t = np.cumsum(rng.uniform(0.8e-3, 1.2e-3, 2000))
    keep = np.ones(t.size, dtype=bool)
    for _ in range(data.draw(st.integers(0, 4))):
        start = data.draw(st.integers(5, 1900))
        keep[start : start + data.draw(st.integers(1, 60))] = False
    q = 2.0 * t[keep] + 1.0
    record = uniform_record(t[keep], q, q[:, None], 0.01)
    steps = np.diff(t[keep])
    holes = np.flatnonzero(steps > record.report.gap_limit)
    near = np.zeros(record.t.size, dtype=bool)
    for i in holes:
        near |= (record.t > t[keep][i] - 0.02) & (record.t < t[keep][i + 1] + 0.02)
    np.testing.assert_array_equal(record.segment == -1, near)
    np.testing.assert_allclose(record.q[~near], 2.0 * record.t[~near] + 1.0, atol=1e-10)
    # Straight lines stay straight through every gap.
    np.testing.assert_allclose(record.v[:, 0], 2.0 * record.t + 1.0, atol=1e-10)
    numbers = record.segment[record.segment >= 0]
    assert np.all(np.diff(numbers) >= 0) and np.array_equal(np.unique(numbers), np.arange(record.report.segments))


def _awkward_log(seed):
    """Jittered stamps, gaps, repeated and backward rows, samples that are not finite, voltages on their own raster."""
    rng = np.random.default_rng(seed)
    t = np.cumsum(rng.uniform(0.5e-3, 1.5e-3, 6000))
    t[2000:] += 0.05
    t[4000:4020] -= 0.03
    t[[10, 2500]] = [np.nan, t[2499]]
    q = rng.normal(size=t.size)
    q[[100, 101, 3000]] = [np.nan, np.inf, np.nan]
    q[5000:5060] = np.nan
    raster = np.arange(t[0] - 0.7, t[-1] + 0.1, 2.5e-3)
    return t, q, rng.normal(size=(raster.size, 2)), raster


@pytest.mark.parametrize("interval", [0.001, 0.02])
@pytest.mark.parametrize("chunk", [61, 1000])
def test_the_result_does_not_depend_on_how_the_log_is_read(monkeypatch, interval, chunk):
    t, q, v, raster = _awkward_log(chunk)
    whole = uniform_record(t, q, v, interval, v_time=raster, time_reversal="split")
    monkeypatch.setattr("pipeline.signals.columns.CHUNK", chunk)
    monkeypatch.setattr("pipeline.signals.uniform_record.CHUNK", chunk // 2)
    monkeypatch.setattr("pipeline.signals.resampling.CHUNK", chunk // 4)
    again = uniform_record(t, q, v, interval, v_time=raster, time_reversal="split")
    for one, other in zip(
        (whole.t, whole.q, whole.v, whole.segment), (again.t, again.q, again.v, again.segment), strict=True
    ):
        assert one.tobytes() == other.tobytes()
    assert again.report == whole.report
    assert whole.report.segments > 3 and whole.report.repeated > 0 and whole.report.backward > 0


@pytest.mark.parametrize("interval", [0.01, 0.0001])
def test_the_record_comes_in_pieces(interval):
    t = np.arange(600_000) * 1e-4
    q, v = np.sin(t), np.cos(t)
    pieces = list(Resampling(survey((t, q), {"v1": (t, v)}), interval).pieces())
    whole = uniform_record(t, q, v[:, None], interval)
    np.testing.assert_array_equal(np.concatenate([piece.q for piece in pieces]), whole.q)
    assert max(piece.t.size for piece in pieces) <= 1 << 17


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="memory without pages of files is known on Linux")
@pytest.mark.long
def test_a_long_log_is_never_in_memory_as_a_whole(tmp_path):
    """Eight million rows, of which some are left out in each column, take 64 MB a column."""
    program = """
import re, numpy as np
from pathlib import Path
from pipeline.signals.columns import chunks, column, scaled
from pipeline.signals.signal_quality import examine_signal
from pipeline.signals.survey import survey
from pipeline.signals.uniform_record import Resampling
from pipeline.signals.outliers import trusted

def anonymous():
    return int(re.search(r"RssAnon:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])

def parts(of):
    return (of(np.arange(rows.start, rows.stop)) for rows in chunks(8_000_000))

t = column(8_000_000, parts(lambda n: n * 1e-4), np.float64)
q = column(8_000_000, parts(lambda n: np.where(n % 9_999, np.clip(np.sin(n * 1e-3), -0.9, None), np.nan)), np.float64)
v = column(8_000_000, parts(lambda n: np.where(n % 8_888, np.floor(n * 1e-4) % 2, np.nan)), np.float64)
examine_signal(t[:99], q[:99], 1e-4)
before, most = anonymous(), 0
q = scaled(q, 1e-3, 0.5)
kept = trusted((t, q), [(t, v)], examine_signal(t, q, 1e-4), 1e-4, rails=True, lost=True, spikes=True)
most = max(most, anonymous())
for piece in Resampling(survey((t, kept.samples), {"v1": (t, v)}), 1e-3).pieces():
    most = max(most, anonymous())
print(most - before, sum(kept.left_out) > 0)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    grown, masked = done.stdout.split()
    assert masked == "True"
    assert int(grown) < 60_000  # kilobytes


def test_each_input_is_taken_from_its_own_raster():
    t, q, _ = _log()
    rasters = [t[0] - 0.2 + np.arange(900) * 0.005, t[0] + np.arange(410) * 0.01]
    log = survey((t, q), {f"v{k}": (raster, 100.0 * raster) for k, raster in enumerate(rasters, start=1)})
    (piece,) = Resampling(log, 0.01).pieces()
    for column in piece.v.T:
        np.testing.assert_allclose(column, 100.0 * piece.t, rtol=1e-9)


def test_a_point_at_the_edge_of_two_segments_is_given_once():
    """Time steps back twice, and goes on where it was to within rounding: a point there belongs to two segments."""
    t = np.concatenate([k * 0.9 + k * 1e-12 + 1e-3 * np.arange(1001) for k in range(3)])
    q = np.sin(5.0 * t)
    record = uniform_record(t, q, np.column_stack([q]), 0.01, time_reversal="split")
    kept = record.segment >= 0
    assert record.report.segments == 3 and np.sum(kept) > 260
    np.testing.assert_allclose(record.q[kept], np.sin(5.0 * record.t[kept]), atol=1e-3)
