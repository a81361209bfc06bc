"""Each gate against a log that breaks it by a planted amount, and against one that just does not."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.fitting.excitation import excitation_findings
from pipeline.signals.findings import log_findings, rate_findings
from pipeline.signals.remarks import rate_remarks
from pipeline.signals.signal_quality import examine_signal
from pipeline.signals.timebase import examine

STEP, N = 1e-3, 40_000


def _findings(time=None, q=None, masked=0.0):
    rng = np.random.default_rng(1)
    clean = np.arange(N) * STEP
    time = clean if time is None else time
    q = 5e-3 * np.sin(9.0 * clean) + rng.normal(0.0, 1e-6, N) if q is None else q(clean, rng)
    return [finding.gate for finding in log_findings(examine(time), examine_signal(time, q, STEP), masked)]


def test_a_clean_log_passes():
    assert _findings() == []


@pytest.mark.parametrize(("share", "found"), [(0.49, []), (0.51, ["masked"])])
def test_masked(share, found):
    assert _findings(masked=share) == found


@pytest.mark.parametrize(("share", "found"), [(0.09, []), (0.11, ["missing"])])
def test_missing(share, found):
    assert _findings(q=lambda t, rng: np.where(np.arange(N) < share * N, np.nan, np.sin(9 * t))) == found


def test_a_row_without_time_and_displacement_is_missing_once():
    lost = np.arange(N) % 17 == 3  # 5.9 %
    time = np.where(lost, np.nan, np.arange(N) * STEP)
    assert _findings(time=time, q=lambda t, rng: np.where(lost, np.nan, np.sin(9 * t))) == []
    others = np.arange(N) % 17 == 9
    assert _findings(time=time, q=lambda t, rng: np.where(others, np.nan, np.sin(9 * t))) == ["missing"]


@pytest.mark.parametrize(("share", "found"), [(0.04, []), (0.06, ["repeated"])])
def test_repeated(share, found):
    """Of every hundred stamps some are those of the row before."""
    repeated = np.arange(N) % 100 < 100 * share
    assert _findings(time=np.cumsum(np.where(repeated, 0.0, STEP))) == found


@pytest.mark.parametrize(("every", "found"), [(6, []), (4, ["dropped"])])
def test_dropped(every, found):
    """One sample in `every` is missing: 1/(every − 1) of those that are there."""
    rows = np.arange(2 * N)
    rows = rows[rows % every != 1][:N]
    assert _findings(time=rows * STEP) == found


@pytest.mark.parametrize(("scatter", "found"), [(0.3, []), (0.45, ["jitter"])])
def test_jitter(scatter, found):
    """Stamps off by a uniform share of the step: the steps scatter by √(2/3) of it."""
    off = np.random.default_rng(2).uniform(-scatter, scatter, N)
    assert _findings(time=(np.arange(N) + off) * STEP) == found


@pytest.mark.parametrize(("limit", "found"), [(1.0, []), (0.99, ["rails"])])
def test_rails(limit, found):
    """A sine cut at 99 % of its height stays there for 9 % of the time."""
    assert _findings(q=lambda t, rng: np.clip(5e-3 * np.sin(9 * t), -5e-3 * limit, 5e-3 * limit)) == found


@pytest.mark.parametrize(("share", "found"), [(0.04, []), (0.06, ["hum"])])
def test_hum(share, found):
    """Of the range: that of the sine and of the hum together."""
    amplitude = share * 1e-2 / (1.0 - 2.0 * share)
    q = lambda t, rng: 5e-3 * np.sin(9 * t) + amplitude * np.sin(2 * np.pi * 50.0 * t) + rng.normal(0, 1e-6, N)  # noqa: E731
    assert _findings(q=q) == found


@pytest.mark.parametrize(("step", "found"), [(0.059, []), (0.061, ["rate"])])
def test_rate(step, found):
    """Three sample intervals of 20 ms."""
    time = step * np.arange(2000)
    slow = examine_signal(time, np.sin(0.3 * time), step)
    assert [finding.gate for finding in rate_findings(examine(time), slow, 0.02)] == found


@pytest.mark.parametrize(("frequency", "said", "refused"), [(15.0, 0, 0), (25.0, 1, 0), (29.0, 1, 0), (40.0, 1, 1)])
@pytest.mark.parametrize("step", [1e-3, 1e-4])
def test_what_moves_faster_than_the_sample_interval_shows(frequency, said, refused, step):
    time = step * np.arange(round(20.0 / step))
    noise = np.random.default_rng(1).normal(0.0, 0.01, time.size)
    fast = examine_signal(time, np.sin(2.0 * np.pi * frequency * time) + noise, step)
    assert fast.band.most == pytest.approx(frequency, abs=2.0 / min(16384 * step, 20.0))
    found, warnings = rate_findings(examine(time), fast, 0.01), [*rate_remarks(examine(time), fast, 0.01)]
    assert (len(warnings), len(found)) == (said, refused)
    advised = [float(remark.text.split("sample_interval = ")[-1]) for remark in warnings]
    for interval in [*advised, *(finding.numbers["advised"].value for finding in found)]:
        assert 1.0 / 9.0 < interval * fast.band.most < 1.0 / 7.0


def test_a_log_that_could_show_no_more_and_noise_alone_are_not_blamed():
    time = 0.01 * np.arange(2000)
    coarse = examine_signal(time, np.sin(2.0 * np.pi * 40.0 * time), 0.01)
    assert not [*rate_remarks(examine(time), coarse, 0.01)] and not rate_findings(examine(time), coarse, 0.01)
    fine = 1e-3 * np.arange(20_000)
    still = examine_signal(fine, np.random.default_rng(2).normal(0.0, 1e-6, fine.size), 1e-3)
    assert not [*rate_remarks(examine(fine), still, 0.01)] and not rate_findings(examine(fine), still, 0.01)


def _training(q=None, v=None, *, bistable=True, centres=10):
    rng = np.random.default_rng(3)
    t = np.arange(4000) * 0.01
    pulses = (t % 2.0) < 0.5
    left = (t // 2.0) % 2 == 0
    volts = 3e3 * np.column_stack([pulses & left, pulses & ~left]) + rng.normal(0.0, 1.0, (t.size, 2))
    side = np.where(left, 1.0, -1.0) * np.minimum((t % 2.0) / 0.4, 1.0) + np.where(left, -1.0, 1.0) * np.maximum(
        1.0 - (t % 2.0) / 0.4, 0.0
    )
    motion = 5e-3 * side + 2e-4 * np.sin(50.0 * t) + rng.normal(0.0, 1e-6, t.size)
    q, v = motion if q is None else q(motion), volts if v is None else v(volts)
    segment = np.zeros(t.size, dtype=np.int32)
    options = {"plant": JOINT, "basis_functions": centres, "smoothing": 0.5, "bistable": bistable}
    return [finding.gate for finding in excitation_findings(q, v, segment, 0.01, **options)]


def test_rich_training_data_pass():
    assert _training() == []


def test_idle():
    assert _training(q=lambda q: 1e-6 * np.random.default_rng(4).normal(size=q.size)) == ["idle"]


def test_undriven():
    assert _training(v=lambda v: v * [1.0, 0.0], bistable=False) == ["undriven"]


@pytest.mark.parametrize(("acts", "found"), [(True, False), (False, True)])
def test_a_random_input_drives_if_it_moves_the_device(acts, found):
    """Drawn anew for each sample it looks like a probe's noise; a spring and a mass that it pushes tell."""
    rng = np.random.default_rng(8)
    v, q = rng.normal(0.0, 1.0, 4000), np.zeros(4000)
    force = v if acts else rng.normal(0.0, 1.0, 4000)
    for n in range(1, 3999):
        q[n + 1] = 2.0 * q[n] - q[n - 1] - 0.02 * q[n] - 0.05 * (q[n] - q[n - 1]) + 1e-5 * force[n]
    linear = replace(JOINT, action="linear")
    options = {"plant": linear, "basis_functions": 10, "smoothing": 0.5, "bistable": False}
    gates = [one.gate for one in excitation_findings(q, v[:, None], np.zeros(4000, dtype=np.int32), 0.01, **options)]
    assert ("undriven" in gates) == found


def test_one_well_of_a_device_that_has_two():
    assert "one-well" in _training(q=np.abs)
    assert "one-well" not in _training(q=np.abs, bistable=False)


def test_visits():
    """A jump that no sample lies on leaves the centres between without any."""
    assert "visits" in _training(q=lambda q: np.sign(q) * (4e-3 + 0.2 * np.abs(q)))


def test_rank():
    """Two inputs that are one."""
    assert "rank" in _training(v=lambda v: v[:, :1] * [1.0, 1.0])
