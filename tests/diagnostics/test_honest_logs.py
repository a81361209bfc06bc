"""Honest logs of good rigs pass without a remark, however their sensors, drives and sequences are."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device import device as joint
from pipeline.diagnostics.check import check_logs
from pipeline.diagnostics.copies import shared_recordings, sketch
from pipeline.diagnostics.log_facts import LogSignals
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.linear_filters import first_order_lag
from pipeline.signals.findings import Finding
from pipeline.signals.remarks import channel_remarks, saturation_remarks
from pipeline.signals.signal_quality import examine_signal
from tests.double_well import DoubleWell
from tests.prototypes import motion

RATE = 1000.0
JOINT = replace(joint.JOINT, known_mass=0.041)


def _run(v: FloatArray, name: str, charging: float = 0.0) -> LogSignals:
    """A log of a double well whose electrodes charge with a time constant [s], with 2 µm of noise."""
    behind = v
    if charging:
        behind = np.column_stack([first_order_lag(np.ascontiguousarray(side), 1.0 / RATE, charging)[0] for side in v.T])
    q = DoubleWell().simulate(behind, 1.0 / RATE) + np.random.default_rng(4).normal(0.0, 2e-6, len(v))
    return LogSignals(name, np.arange(len(v)) / RATE, q, v, 1.0 / RATE, 2e-6)


def _in_turn(seconds: float, clock: float, seed: int) -> FloatArray:
    """After a second of rest one side or the other is on, by chance."""
    t = np.arange(round(seconds * RATE)) / RATE
    on = np.random.default_rng(seed).integers(0, 2, 1 + int(seconds / clock))[(t / clock).astype(np.int64)]
    return 3000.0 * np.column_stack([on, 1 - on]) * (t > 1.0)[:, None]


def _remarkable(findings: list[Finding]) -> list[str]:
    return [finding.code for finding in findings if finding.severity in ("fair", "poor")]


@pytest.mark.parametrize("charging", [0.0, 0.04])
@pytest.mark.parametrize("clock", [0.2, 0.35])
def test_two_sides_that_are_on_in_turn_are_not_told_apart(charging: float, clock: float) -> None:
    """Their difference is all that such a log shows: neither side, nor law."""
    log = _run(_in_turn(30.0, clock, 1), "train/a", charging)
    assert set(_remarkable(check_logs([log], JOINT, 0.01))) <= {"late_answer"}


@pytest.mark.parametrize("frequency", [0.25, 0.5])
def test_slow_triangles_show_no_delay(frequency: float) -> None:
    """A slow smooth input acts at any time alike."""
    t = np.arange(round(30.0 * RATE)) / RATE
    turns, place = np.divmod(np.maximum(t - 1.0, 0.0) * frequency, 1.0)
    triangle = 3000.0 * (1.0 - np.abs(2.0 * place - 1.0))
    slow = np.column_stack([triangle * (turns % 2 == side) for side in (0, 1)])
    assert _remarkable(check_logs([_run(slow, "a", 0.005)], JOINT, 0.01)) == []


def test_an_input_that_one_log_does_not_show_is_named_rightly_if_another_shows_it() -> None:
    first = _run(motion(30.0, RATE, 35)[2], "train/a")
    v = first.v * np.where(first.t < 2.5, 1.0, 0.12)[:, None]  # then small pulses in one well
    findings = check_logs([first, _run(v * [1.0, 0.0], "train/b")], JOINT, 0.01)
    assert [each.severity for each in findings if each.code == "never_on"] == ["unseen"]


def test_noise_of_a_monitor_is_no_field_above_the_limit() -> None:
    log = _run(motion(20.0, RATE, 35)[2], "train/a")
    noisy = replace(log, v=log.v + np.random.default_rng(1).normal(0.0, 15.0, log.v.shape))
    assert np.abs(noisy.v).max() > 1.02 * 3000.0
    assert [each.severity for each in check_logs([noisy], JOINT, 0.01) if each.code == "field"] == ["good"]


@pytest.mark.parametrize(("noise", "step"), [(2e-6, 0.0), (0.5e-6, 5e-6), (0.4e-6, 0.1e-6)])
def test_equal_raw_samples_make_a_copy_and_an_equal_motion_makes_none(noise: float, step: float) -> None:
    """A sequence that is run again moves alike down to the noise, also where the steps of the sensor hide it."""
    logs = []
    for day, change in enumerate((1.0, 1.0004)):
        t, q, v = motion(30.0, RATE, 1, device=DoubleWell(left_force=8.6e-9 * change))
        q += np.random.default_rng(day).normal(0.0, noise, t.size)
        q = np.round(q / step) * step if step else q
        logs.append(LogSignals(f"log {day}", t, q, v, 1.0 / RATE, noise, step, sketch=tuple(sketch(t, q))))
    assert shared_recordings(logs) == []
    part = slice(5_003, 17_000)
    later = replace(logs[0], sketch=tuple(sketch(t[part] - 5.0, logs[0].q[part])))
    ((_, _, found),) = shared_recordings([logs[0], later])
    assert (found.value("other_start"), found.value("other_stop")) == pytest.approx((5.0, 17.0), abs=1.5)
    assert (found.value("start"), found.value("stop")) == pytest.approx((0.0, 12.0), abs=1.5)
    for changed, found in ((-logs[0].q, True), (1.0001 * logs[0].q, False)):
        copy = replace(logs[0], sketch=tuple(sketch(t, changed)))
        assert bool(shared_recordings([logs[0], copy])) == found


T = np.arange(40_000) / 2000.0
REST = 2e-3 * (1.0 - np.cos(6.0 * np.maximum(T - 12.0, 0.0)))  # at rest for 12 s, then it moves to one side


@pytest.mark.parametrize(("noise", "step"), [(1e-6, 1e-5), (1.5e-6, 5e-5), (3e-6, 1e-6)])
def test_a_rest_at_an_end_of_the_motion_is_neither_a_rail_nor_frozen(noise: float, step: float) -> None:
    for seed in range(4):
        q = np.round((REST + np.random.default_rng(seed).normal(0.0, noise, T.size)) / step) * step
        quality = examine_signal(T, q, 1 / 2000.0)
        assert (quality.low_rail, quality.high_rail, quality.spikes) == (0.0, 0.0, 0)
        assert not [each for each in channel_remarks(quality) if "unchanged" in each.text or "saturated" in each.text]
    held = q + 1e-6 * np.sin(T)
    held[30_000:30_400] = held[30_000]
    assert any("unchanged" in remark.text for remark in channel_remarks(examine_signal(T, held, 1 / 2000.0)))


def test_an_amplifier_that_is_off_is_at_no_rail() -> None:
    """Its monitor has an offset, and steps that hide its noise; what it drives has ripple."""
    on = np.sin(0.7 * T) > 0.2
    v = np.round((-3.7 + on * (2000.0 + 15.0 * np.sin(628.3 * T + T**2))) / 0.07) * 0.07
    assert [*saturation_remarks(T, v, "V")] == []
    noisy = v + np.random.default_rng(1).normal(0.0, 1.0, T.size)
    clipped = np.minimum(noisy + on * 300.0 * np.sin(3.0 * T), 2200.0)
    assert len([*saturation_remarks(T, clipped, "V")]) == 1
