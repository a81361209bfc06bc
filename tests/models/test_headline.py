"""Which of the identified models is the main model, by what each makes of the training logs."""

from dataclasses import dataclass

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.models.base import FreeRun
from pipeline.models.choose import main_model
from pipeline.models.model_type import Training
from pipeline.settings.prototype import Identify
from pipeline.signals.log import Log

T = 0.01 * np.arange(6000)
Q = np.sin(3.0 * T) + 0.5 * np.sin(7.7 * T)
STILL = np.zeros_like(T)
LOG = Log(T, Q, np.gradient(Q, T), STILL, STILL[:, None], np.ones(T.size, dtype=bool))
TRAINING = Training((), (LOG,), JOINT.under_other_action, None, None, Identify())


@dataclass
class Errs:
    """A model that errs in free run by `free`, and after a restart by `rate` times the time [s]."""

    free: float
    rate: float = 0.0
    chaotic: bool = False
    fine_voltages: bool = False

    def describe(self):
        return {"chaotic": self.chaotic}

    def simulate(self, t, v, q0, qdot0):
        q = np.interp(t, T, Q) + self.free * np.ptp(Q)
        q[0] = q0
        return FreeRun(t, q, 0.0 * q, 0.0 * q, "ok")

    def predict(self, t, v, seen, speed, starts, ahead):
        for start, count in zip(starts, ahead, strict=True):
            times = t[start : start + count + 1]
            yield np.interp(times, T, Q) + self.rate * (times - times[0]) * np.cos(40.0 * times[0])


@pytest.mark.parametrize(
    ("models", "best"),
    [
        ({"hybrid": Errs(0.02), "rbf": Errs(0.01), "rbf-paper": Errs(0.5)}, "hybrid"),
        ({"hybrid": Errs(0.6), "rbf": Errs(0.01), "rbf-paper": Errs(0.5)}, "rbf"),
        ({"hybrid": Errs(0.6), "rbf": Errs(0.3), "rbf-paper": Errs(np.nan)}, "hybrid"),
        ({"rbf": Errs(np.nan), "rbf-paper": Errs(0.1)}, "rbf-paper"),
        ({"rbf": Errs(0.02, 1.0), "rbf-paper": Errs(0.05, 0.1)}, "rbf"),
        ({"rbf": Errs(0.05, 1.0), "rbf-paper": Errs(0.02, 0.1)}, "rbf-paper"),
        ({"rbf": Errs(0.5, 1.0, chaotic=True), "rbf-paper": Errs(0.6, 0.1)}, "rbf-paper"),
        ({"rbf": Errs(0.5, 0.1, chaotic=True), "rbf-paper": Errs(0.4, 0.1)}, "rbf"),
    ],
    ids=["first holds", "first lost", "all lost", "diverged", "free run", "both", "chaos", "equal in chaos"],
)
def test_the_headline(models, best):
    name, reason = main_model(models, TRAINING)
    assert name == best
    assert bool(reason) == (best != next(iter(models)))
