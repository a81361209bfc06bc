"""Free runs: where a log begins in motion, the velocity at its edge is found with the model."""

import numpy as np
import pytest

from pipeline.models.free_runs import free_run
from pipeline.models.rbf.model import RbfModel
from pipeline.models.rbf.parameter_layout import ParameterLayout
from pipeline.models.rbf.structure import JointScales, JointStructure
from pipeline.signals.log import log_of

INTERVAL = 0.02


def spring():
    """A mass on a spring with one linear input."""
    structure = JointStructure(
        4, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True,
        constant_gain=True,
    )  # fmt: skip
    p = ParameterLayout(structure, JointScales(0.0, 1.0, 1.0, 30.0), "linear", (0,))
    theta = np.zeros(p.count)
    theta[p.slices["force"]] = 0.0, -50.0, 0.0, np.log(0.1)
    theta[p.slices["damping"]], theta[p.slices["input0"]] = np.log(0.3), 20.0
    return RbfModel(p, theta, *np.zeros((2, p.count, 1)))


def table(model, moving, **changes):
    t = INTERVAL * np.arange(400)
    v = np.sin(2.0 * t)
    run = model.simulate(t, v[:, None], 0.3 if moving else 0.0, 2.0 if moving else 0.0)
    q = run.q if moving else np.where(t < 0.5, 0.0, run.q)
    return {
        "t": t,
        "q": q,
        "qdot": run.qdot,
        "qddot": run.qddot,
        "v1": v,
        "segment": np.zeros(t.size, dtype=np.int32),
        **changes,
    }


@pytest.mark.parametrize("off", [-1.5, 0.0, 4.0])
def test_a_wrong_velocity_at_the_edge_of_a_moving_log_is_made_good(off):
    model = spring()
    seen = table(model, moving=True)
    seen["qdot"][0] += off
    seen["q"] = seen["q"].copy()
    seen["q"][4:6], seen["segment"][4:6] = np.nan, -1
    truth = table(model, moving=True)["q"]
    assert np.abs(free_run(log_of(seen), model).q - truth).max() < 1e-3 * np.ptp(truth)


def test_the_velocity_of_a_log_that_begins_at_rest_or_was_measured_stays_as_it_is():
    model = spring()
    for seen in (table(model, moving=False), table(model, moving=True, velocity=np.zeros(400))):
        seen["qdot"][0] = 0.7
        assert free_run(log_of(seen), model).qdot[0] == pytest.approx(0.7)


def test_behind_a_gap_in_which_nobody_knows_the_inputs_a_run_starts_anew():
    model = spring()
    t = INTERVAL * np.arange(400)
    v = np.where((t > 3.2) & (t < 3.6), 5.0, np.sin(2.0 * t))  # pushed while nothing was recorded
    run = model.simulate(t, v[:, None], 0.0, 0.0)
    lost = (t > 3.0) & (t < 4.0)
    seen = {
        "t": t, "q": np.where(lost, np.nan, run.q), "qdot": run.qdot, "qddot": run.qddot, "v1": np.where(lost, 0.0, v),
        "segment": np.where(lost, -1, np.where(t < 3.5, 0, 1)),
    }  # fmt: skip
    blind = free_run(log_of(seen), model)
    started_anew = free_run(log_of(seen, unknown=[(3.0, 4.0)]), model)
    off = [np.abs(each.q - run.q)[~lost].max() / np.ptp(run.q) for each in (blind, started_anew)]
    assert off[0] > 0.1 and off[1] < 1e-3
    assert np.isnan(started_anew.q[lost]).all() and started_anew.status == "ok"
