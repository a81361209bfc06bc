"""A joint for the tests of control: the designer's drawing with typical friction, without identification."""

from functools import lru_cache

import numpy as np

from pipeline.control.controller import begin_control, control
from pipeline.control.design import Settings, design
from pipeline.control.ensemble import Converters
from pipeline.control.law import CONTROLLER_STATE, Law
from pipeline.control.plant import ControlledJoint, plant_of
from pipeline.device.parameters import NOMINAL
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.log_reading import SAME, Similarity
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.problem import CondensedJoint
from pipeline.numerics.arrays import FloatArray


def model(similarity: Similarity = SAME, **planted: float) -> HybridModel:
    """The hybrid joint with deviations in prior widths, and a narrow posterior."""
    ratio = condensed_parameters.static_slope_ratio(NOMINAL)
    condensed = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, 3000.0, ratio, similarity)
    theta = condensed.start()
    for name, value in planted.items():
        theta[condensed_parameters.NAMES.index(name)] = value
    return HybridModel.of(condensed, theta, *2 * (0.01 * np.eye(len(theta)),))


def converters(lag: float) -> Converters:
    """Two of one kind, whose lag [s] is known."""
    return Converters((lag, lag), 0.1)


@lru_cache(maxsize=4)
def designed(highest: float = 3000.0) -> tuple[ControlledJoint, Law]:
    plant = plant_of(model())
    return plant, design(plant, Settings(highest, (3e-3, 3e-3)))


class Running:
    """A controller that has begun."""

    def __init__(self, law: Law, q: float) -> None:
        self.law, self.state = law, np.zeros(CONTROLLER_STATE)
        begin_control(q, law, self.state)

    def step(self, q: float, target: float) -> FloatArray:
        v = np.full(2, np.nan)
        control(self.state, q, target, self.law, v)
        return v
