"""What a log does not excite is named, and what is excited is not."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.fitting.excitation import examine_excitation
from pipeline.rig.bench import Bench, record
from pipeline.rig.excitation import Burst, alternating_pulses, command
from pipeline.rig.parameters import nominal
from pipeline.workflow.inspection import shortfalls

BENCH = Bench(rate=2000.0)
NONE = np.empty(0)


def played(bursts: list[Burst], duration: float) -> tuple[np.ndarray, np.ndarray]:
    """Displacement and voltages of the drawn joint, every 10 ms."""
    t = BENCH.clock(duration)
    log = record(nominal(), BENCH, t, command(bursts, t), np.random.default_rng(1))
    return log.q[::20], np.stack([log.v1, log.v2], axis=1)[::20]


def examined(bursts: list[Burst], duration: float = 24.0):
    q, v = played(bursts, duration)
    found = examine_excitation(q, v, np.zeros(q.size, dtype=np.int64), 0.01, plant=JOINT)
    return found, " | ".join(each.finding for each in shortfalls(found, ("V1", "V2"), 1e3, "mm", JOINT))


def test_full_pulses_lack_levels_bandwidth_and_both_sides() -> None:
    found, text = examined(alternating_pulses(duration=24.0))
    assert min(found.switches) >= 5 and abs(found.switches[0] - found.switches[1]) <= 1
    assert found.wells.left == pytest.approx(-found.wells.right, rel=0.05), "the drawing is symmetric"  # type: ignore[union-attr]
    assert "V1 is either off or full" in text and "V2 is either off or full" in text
    assert "never act together" in text and "snaps" not in text
    assert max(found.bandwidth) < found.ringing and "rings at" in text  # type: ignore[operator]


def test_one_side_alone_leaves_one_well_and_a_silent_input() -> None:
    pulses = [Burst("pulse", start, 1.0, 3000.0, 0.0, NONE, NONE) for start in (1.0, 3.0, 5.0)]
    q, v = played(pulses, 8.0)
    found = examine_excitation(q[150:], v[150:] * [1.0, 0.0], np.zeros(q.size - 150, dtype=np.int64), 0.01, plant=JOINT)
    text = " | ".join(each.finding for each in shortfalls(found, ("V1", "V2"), 1e3, "mm", JOINT))
    assert "no two wells" in text and "V2 never acts" in text
    assert found.conditioning.silent == len(found.centres)


def _rings(q: np.ndarray, interval: float, v: np.ndarray) -> float | None:
    return examine_excitation(
        q, v[:, None], np.zeros(q.size, dtype=np.int64), interval, plant=replace(JOINT, action="linear")
    ).ringing


@pytest.mark.parametrize("noise", [0.0, 0.1])
@pytest.mark.parametrize("interval", [1.0, 10.0])
def test_a_heater_does_not_ring(noise: float, interval: float) -> None:
    """A first order lag, with and without the noise of its sensor, whose differences have a peak in their spectrum."""
    rng = np.random.default_rng(2)
    v = np.repeat(rng.choice([0.0, 50.0], 60), 60)
    q, rest = np.empty(v.size), 0.0
    for i, drive in enumerate(v):
        rest += (drive - rest) / 150.0
        q[i] = rest
    assert _rings(q + noise * rng.standard_normal(q.size), interval, v) is None


@pytest.mark.parametrize(("frequency", "interval"), [(0.12, 1.0), (3.0, 0.01), (30.0, 0.01), (1.0, 0.1)])
def test_slow_and_fast_devices_ring_where_they_do(frequency: float, interval: float) -> None:
    """However they are sampled; a crane logged at 1 Hz rings below 0.5 Hz."""
    rng = np.random.default_rng(3)
    v = np.repeat(rng.standard_normal(120), round(0.7 / (frequency * interval)) or 1)
    transition = np.exp(2.0 * np.pi * frequency * interval * complex(-0.05, 1.0))
    swing, q = 0.0j, np.empty(v.size)
    for i, drive in enumerate(v):
        swing = transition * swing + (1.0 - transition) * drive
        q[i] = swing.real
    found = _rings(q + 1e-3 * rng.standard_normal(q.size), interval, v)
    assert found == pytest.approx(frequency, rel=0.15)
