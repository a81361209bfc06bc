import numpy as np
import pytest

from pipeline.fitting.descent import Prior
from pipeline.fitting.homotopy import Callbacks, Schedule, fit_homotopy
from pipeline.models.rbf.problem import Effort, simulation_effort


def test_effort_counts_simulations_and_not_the_clock():
    effort = Effort(limit=1.0)
    effort.spent += simulation_effort(10_000)
    alone = effort.spent
    effort.spent += simulation_effort(10_000, 20)
    assert effort.spent - alone > 2.0 * alone
    assert not effort.exhausted()
    effort.spent += simulation_effort(3_000_000)
    assert effort.exhausted()


class Parabola:
    def __init__(self):
        self.told = []

    def residual(self, theta, gain):
        return np.array([theta[0] ** 2 - 2.0, 0.1 * (theta[0] - 1.0)])

    def jacobian(self, theta, gain):
        return self.residual(theta, gain), np.array([[2.0 * theta[0]], [0.1]])


def test_a_spent_effort_leaves_the_least_steps_of_the_last_level_and_progress_is_told():
    told = []
    fit = fit_homotopy(
        Parabola(), np.array([30.0]), Prior(np.zeros((1, 1)), np.zeros(1)), Schedule((1.0, 0.1, 0.0)),
        callbacks=Callbacks(enough=lambda: True, on_progress=lambda gain, rms: told.append((gain, rms))),
    )  # fmt: skip
    assert [(level.gain, level.iterations) for level in fit.levels] == [(0.0, 3)]
    assert not fit.converged
    assert [gain for gain, _ in told] == [0.0] * 3
    assert told[0][1] > told[-1][1]
    whole = fit_homotopy(Parabola(), np.array([30.0]), Prior(np.zeros((1, 1)), np.zeros(1)), Schedule((1.0, 0.1, 0.0)))
    assert whole.converged
    assert whole.theta[0] == pytest.approx(np.sqrt(2.0), rel=1e-2)
