"""What a log does not excite is named, and what is excited is not."""

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


def test_full_pulses_reach_both_wells() -> None:
    found, text = examined(alternating_pulses(duration=24.0))
    assert min(found.switches) >= 5 and abs(found.switches[0] - found.switches[1]) <= 1
    assert found.wells.left == pytest.approx(-found.wells.right, rel=0.05), "the drawing is symmetric"  # type: ignore[union-attr]
    assert "snaps" not in text and "two wells" not in text


def test_one_side_alone_leaves_one_well_and_a_silent_input() -> None:
    pulses = [Burst("pulse", start, 1.0, 3000.0, 0.0, NONE, NONE) for start in (1.0, 3.0, 5.0)]
    q, v = played(pulses, 8.0)
    found = examine_excitation(q[150:], v[150:] * [1.0, 0.0], np.zeros(q.size - 150, dtype=np.int64), 0.01, plant=JOINT)
    text = " | ".join(each.finding for each in shortfalls(found, ("V1", "V2"), 1e3, "mm", JOINT))
    assert "no two wells" in text and "V2 never acts" in text
    assert found.conditioning.silent == len(found.centres)
