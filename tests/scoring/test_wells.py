"""Wells, well agreement and switch accuracy on records whose wells are known by construction."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lfilter

from pipeline.device.device import JOINT
from pipeline.diagnostics.events import rest_events
from pipeline.numerics.arrays import FloatArray
from pipeline.scoring.wells import (
    NoWells,
    Wells,
    find_wells,
    in_same_well,
    places_of_rest,
    rests,
    switch_accuracy,
)

OTHER = replace(JOINT, action="linear")

DT = 0.01
WELLS = Wells(-0.010, 0.012, 0.001)


def record(sides: str, rest: float = 0.8, pulse: float = 0.5) -> tuple[FloatArray, FloatArray]:
    """A joint that rests on these sides ("l" or "r") with a pulse between any two rests, ringing at 2.8 Hz: q and v."""
    hold, push = round(rest / DT), round(pulse / DT)
    q, v = [], []
    for k, side in enumerate(sides):
        t = DT * np.arange(hold)
        well = WELLS.left if side == "l" else WELLS.right
        q += [well + 0.004 * np.exp(-2.0 * t) * np.sin(2 * np.pi * 2.8 * t)]
        v += [np.full((hold, 2), 2.0)]  # probe offset
        if k + 1 < len(sides):
            right = sides[k + 1] == "r"
            q += [np.linspace(well, WELLS.right if right else WELLS.left, push)]
            v += [np.tile([3000.0, 0.0] if right else [0.0, 3000.0], (push, 1))]
    return np.concatenate(q), np.concatenate(v)


def test_wells_are_found_in_the_rests() -> None:
    q, v = record("lrlrrl")
    wells = find_wells([(q, v, DT)], plant=JOINT)
    assert isinstance(wells, Wells)
    assert wells.left == pytest.approx(-0.010, abs=5e-4)
    assert wells.right == pytest.approx(0.012, abs=5e-4)
    assert wells.barrier == pytest.approx(0.001, abs=5e-4)


def test_pauses_in_which_the_joint_still_swings_hide_no_wells() -> None:
    q, v = record("lrlrrlll")
    t = DT * np.arange(80)
    for stop, middle in ((len(q), -0.003), (len(q) - 130, -0.022)):  # pauses between the pulses of a chirp
        q[stop - 80 : stop] = middle + 0.02 * np.sin(2 * np.pi * 2.5 * t)
    wells = find_wells([(q, v, DT)], plant=JOINT)
    assert isinstance(wells, Wells)
    assert (wells.left, wells.right) == (pytest.approx(-0.010, abs=5e-4), pytest.approx(0.012, abs=5e-4))


@pytest.mark.parametrize("q_of_t", [lambda t: np.sin(t), lambda t: np.full_like(t, 0.01)], ids=["linear", "still"])
def test_a_device_without_two_wells_has_none(q_of_t) -> None:  # type: ignore[no-untyped-def]
    q, v = record("lrlr")
    assert isinstance(find_wells([(q_of_t(DT * np.arange(q.size)), v, DT)], plant=JOINT), NoWells)


def test_switch_accuracy_counts_pulses_that_end_in_the_right_well() -> None:
    measured, v = record("lrlrl")
    simulated, _ = record("lrllr")
    assert switch_accuracy(measured, simulated, v, DT, WELLS, plant=JOINT) == (2, 4)


def test_after_a_divergence_nothing_is_right() -> None:
    measured, v = record("lrlrl")
    diverged = measured.copy()
    diverged[measured.size // 2 :] = np.nan
    assert switch_accuracy(measured, diverged, v, DT, WELLS, plant=JOINT) == (1, 4)
    assert np.nanmean(in_same_well(measured, diverged, WELLS)) == pytest.approx(0.5, abs=0.01)


def test_masked_rows_neither_agree_nor_disagree() -> None:
    measured = np.array([-0.01, np.nan, 0.01, np.nan])
    same = in_same_well(measured, np.array([-0.01, 0.01, -0.01, -0.01]), WELLS)
    np.testing.assert_array_equal(same, [1.0, np.nan, 0.0, np.nan])


def test_without_a_pulse_none_is_counted() -> None:
    q = np.full(300, -0.01)
    assert switch_accuracy(q, q, np.zeros((300, 2)), DT, WELLS, plant=JOINT) == (0, 0)


def heater(pause: int, memory: float = 400.0) -> tuple[FloatArray, FloatArray]:
    """A first-order device, a sample every 2 s: heating of so many samples and pauses as long, and noise."""
    v = np.repeat(1 - np.arange(3000 // pause) % 2, pause)[:, None].astype(np.float64)
    share = 1.0 - np.exp(-1.0 / memory)
    q = lfilter([share], [1.0, share - 1.0], v[:, 0]) + 1e-4 * np.random.default_rng(0).normal(size=len(v))
    return np.asarray(q), v


@pytest.mark.parametrize("pause", [4, 25, 100, 300])
def test_a_pause_in_which_a_slow_device_still_moves_is_no_place_of_rest(pause: int) -> None:
    q, v = heater(pause)
    assert len(places_of_rest(q, v, 2.0, plant=JOINT)) == len(rests(v, 2.0, plant=JOINT)) > 4
    assert places_of_rest(q, v, 2.0, plant=OTHER) == []
    assert rest_events([(2.0 * np.arange(q.size), q, v)], NoWells("one"), plant=OTHER) == {}


def test_a_device_that_comes_to_rest_rests_there() -> None:
    q, v = heater(300, memory=10.0)
    assert places_of_rest(q, v, 2.0, plant=OTHER) == rests(v, 2.0, plant=OTHER)
    found = rest_events([(2.0 * np.arange(q.size), q, v)], NoWells("one"), plant=OTHER)["rest"]
    np.testing.assert_allclose(found, 0.0, atol=4e-3)


def test_a_rest_at_the_barrier_among_many_does_not_hide_the_wells() -> None:
    places = [*np.full(20, -0.0113), *np.full(20, 0.0110), -0.0015]
    length = 100
    q = np.concatenate([np.full(length, place) for place in np.random.default_rng(0).permutation(places)])
    v = np.zeros((q.size, 2))
    v[::length, 0] = v[1::length, 0] = 3000.0
    found = find_wells([(q, v, DT)], plant=JOINT)
    assert isinstance(found, Wells)
    assert (found.left, found.right, found.barrier) == pytest.approx((-0.0113, 0.0110, -0.00015), abs=1e-6)
