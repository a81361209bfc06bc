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


def test_each_width_is_one_and_the_sides_differ_by_a_share_of_it() -> None:
    root = prior_root(0)
    covariance = np.linalg.inv(root.T @ root)
    np.testing.assert_allclose(np.diag(covariance), 1.0)
    for name, own in (("b", 0.45), ("log C0", 0.045)):
        difference = np.zeros(len(NAMES))
        difference[NAMES.index(f"left.{name}")], difference[NAMES.index(f"right.{name}")] = 1.0, -1.0
        assert difference @ covariance @ difference == pytest.approx(2.0 * own)
