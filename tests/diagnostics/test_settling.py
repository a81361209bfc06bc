"""Many runs at once end where each ends alone."""

import numpy as np
import pytest

from pipeline.diagnostics.phase_plane import settled
from tests.models.hybrid.test_hybrid import joint
from tests.reporting.synthetic import WELL, double_well

STARTS = np.column_stack((np.linspace(-0.02, 0.02, 11), np.linspace(0.2, -0.15, 11)))


def test_the_joint_in_lanes_ends_where_each_run_ends_alone() -> None:
    model = joint({"left.log C0": 1.0, "probe 1": 2.0, "laser offset": 1.0, "log stop force 0": 0.8})
    t = np.arange(0.0, 1.0, 0.01)
    alone = [model.simulate(t, np.zeros((len(t), 2)), q, rate).q[-1] for q, rate in STARTS]
    assert settled(model, STARTS, 1.0, 0.01, 2) == pytest.approx(alone, abs=1e-12)


def test_another_model_settles_in_its_wells() -> None:
    ends = settled(double_well(), STARTS, 6.0, 0.01, 2)
    assert np.abs(np.abs(ends) - WELL).max() < 0.02 * WELL
