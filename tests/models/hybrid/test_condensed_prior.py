"""The prior of the hybrid joint knows that a joint is built as its own mirror image."""

import numpy as np
import pytest

from pipeline.models.hybrid.kernels import CURVES
from pipeline.models.hybrid.parameters import NAMES
from pipeline.models.hybrid.start import prior_root
from pipeline.numerics.arrays import FloatArray

CENTRES = 6
FORCE, DAMPING, LEFT, RIGHT, MOMENT, STIFFNESS, LEFT_MOMENT, RIGHT_MOMENT, LOSS = range(CURVES)


def mirrored(weights: FloatArray) -> FloatArray:
    """Weights (CURVES, CENTRES) of the joint seen from behind: q and τ with the other sign, the sides exchanged."""
    images = [FORCE, DAMPING, RIGHT, LEFT, MOMENT, STIFFNESS, RIGHT_MOMENT, LEFT_MOMENT, LOSS]
    odd = np.ones((CURVES, 1))
    odd[[FORCE, LEFT, RIGHT, MOMENT, LEFT_MOMENT, RIGHT_MOMENT]] = -1.0
    return odd * weights[images, ::-1]


def cost(weights: FloatArray) -> float:
    theta = np.concatenate([np.zeros(len(NAMES)), weights.ravel()])
    return float(np.sum((prior_root(CENTRES) @ theta) ** 2))


def test_a_joint_is_as_probable_as_its_mirror_image_and_a_symmetric_one_more_probable() -> None:
    weights = np.random.default_rng(5).standard_normal((CURVES, CENTRES))
    assert cost(weights) == pytest.approx(cost(mirrored(weights)))
    even, odd = weights + mirrored(weights), weights - mirrored(weights)
    assert cost(even) / np.sum(even**2) == pytest.approx(1.0 / 1.9)
    assert cost(odd) / np.sum(odd**2) == pytest.approx(1.0 / 0.1)
