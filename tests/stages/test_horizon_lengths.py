"""How far ahead models are judged on logs of fast and of slow devices."""

import numpy as np
import pytest

from pipeline.stages.validate import _horizons
from pipeline.units import HORIZONS


class Still:
    """A model that predicts no motion."""

    fine_voltages = False
    input_count = 1

    def simulate(self, t, v, q0, qdot0):
        raise AssertionError("predicts from what it was shown")

    def predict(self, t, v, seen, speed, starts, ahead):
        return (np.full(count + 1, seen[start]) for start, count in zip(starts, ahead, strict=True))


@pytest.mark.parametrize(
    ("interval", "judged"),
    [
        (4.0, {"one_step"}),
        (0.3, {"one_step", "1s"}),
        (0.05, set(HORIZONS)),
        (0.01, set(HORIZONS)),
        (1e-5, {"one_step"}),
    ],
)
def test_no_horizon_is_called_what_it_is_not(interval, judged):
    """One sample of 4 s is neither 0.1 s nor 1 s, and a log of 10 ms has neither."""
    t = interval * np.arange(1001)
    log = {"t": t, "q": np.sin(t / interval / 20.0), "qdot": np.cos(t / interval / 20.0), "v1": np.zeros(t.size)}
    found = _horizons(
        log | {"segment": np.zeros(t.size, dtype=np.int32)},
        Still(),
        {name: ahead for name, (ahead, _) in HORIZONS.items()},
        joint=False,
    )
    assert list(found) == list(HORIZONS)
    assert {name for name, error in found.items() if error["nrmse"] is not None} == judged
    assert all(found[name]["horizon_s"] == pytest.approx(max(HORIZONS[name][0], interval), rel=0.25) for name in judged)
