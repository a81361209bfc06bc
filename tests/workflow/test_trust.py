"""What a free run leaves open, on a planted double well."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.models.base import FreeRun
from pipeline.models.free_runs import drawn_runs
from pipeline.scoring.wells import wells_of
from pipeline.signals.log import Log
from pipeline.workflow.steps.score import trust_notes

N, INTERVAL = 600, 0.01


class Undecided:
    """A model whose ensemble splits after the second pulse: `share` of the draws go right."""

    def __init__(self, share):
        self.share = share

    name = "undecided"
    input_count = 1
    fine_voltages = False

    def describe(self):
        return {}

    def simulate(self, t, v, q0, qdot0):
        q = self.simulate_draws(t, v, q0, qdot0, count=1)[0][0]
        return FreeRun(t, q, np.zeros(len(t)), np.zeros(len(t)), "ok")

    def simulate_draws(self, t, v, q0, qdot0, *, count):
        ensemble = np.full((count, len(t)), -0.01)
        ensemble[:, 200:400] = 0.01
        ensemble[: round(self.share * count), 400:] = 0.01
        return ensemble, np.zeros((count, 1))


def planted():
    """Left, right after the first pulse, left after the second; rests of a second between."""
    q, v = np.full(N, -0.01), np.zeros(N)
    q[200:400] = 0.01
    v[150:200] = v[350:400] = 3000.0
    q += 1e-5 * np.sin(np.arange(N))
    qdot = np.gradient(q, INTERVAL)
    return Log(INTERVAL * np.arange(N), q, qdot, np.gradient(qdot, INTERVAL), v[:, None])


@pytest.mark.parametrize(("share", "ambiguous"), [(0.0, False), (0.4, True), (1.0, False)])
def test_an_outcome_hinges_where_the_ensemble_splits(share, ambiguous):
    log = planted()
    noted = trust_notes(log, wells_of([log], plant=JOINT), [log], drawn_runs(log, Undecided(share)), plant=JOINT)[
        "outcomes"
    ]
    assert noted["at_s"] == pytest.approx([3.49, 5.99])
    assert noted["right"][0] > 0.95
    assert noted["right"][1] == pytest.approx(share, abs=0.05)
    assert noted["ambiguous"] == [False, ambiguous]


def test_a_model_without_an_ensemble_or_a_device_without_wells_has_no_outcomes():
    log = planted()
    wells = wells_of([log], plant=JOINT)
    assert trust_notes(log, wells, [log], drawn_runs(log, object()), plant=JOINT)["outcomes"] is None
    flat = replace(log, q=1e-5 * np.sin(np.arange(N)))
    wells = wells_of([flat], plant=JOINT)
    assert trust_notes(flat, wells, [flat], drawn_runs(log, Undecided(0.5)), plant=JOINT)["outcomes"] is None
