"""The velocity from which a model starts, of a log that begins in motion."""

import numpy as np

from pipeline.models.base import FreeRun
from pipeline.models.free_runs import followed_velocity
from pipeline.signals.log import Log


class Line:
    """A model that goes on with a share of its first velocity."""

    def __init__(self, share):
        self.share = share

    def simulate(self, t, v, q0, qdot0):
        speed = self.share * qdot0 * np.ones(len(t))
        return FreeRun(t, q0 + speed * (t - t[0]), speed, np.zeros(len(t)), "ok")


def known():
    t = np.arange(200) * 0.01
    return Log(t, 0.3 * t, 0.2 + 0.05 * np.sin(t), 0.05 * np.cos(t), np.zeros((200, 2)))


def test_the_velocity_is_that_with_which_the_model_follows():
    assert abs(followed_velocity(known(), np.zeros((200, 2)), Line(1.0)) - 0.3) < 1e-9
