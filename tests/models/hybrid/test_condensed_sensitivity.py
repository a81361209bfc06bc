"""Derivatives of whole runs of the condensed joint against central differences of these runs."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.models.analytical.statics import rotation_nodes
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.log_reading import Similarity
from pipeline.models.hybrid.problem import CondensedJoint, CondensedProblem
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.log import Log

STEP = 3e-6  # widths
ROUNDING = 1e-6  # mm in a width, of the differences
DT = 0.01  # s


def problem(
    centres: int, similarity: Similarity, *, fine: bool, seed: int, angle: bool = False
) -> tuple[CondensedProblem, FloatArray]:
    """A log of 0.8 s from rest on, 12 s after the recording began, with a pulse on either side and a gap.

    And a joint somewhat off the drawing; with `angle` it is the slope of its tip that was measured.
    """
    rng, t = np.random.default_rng(seed), DT * np.arange(81)
    finer = DT / 5 * np.arange(5 * len(t))
    drives = [np.where((finer > begin) & (finer < begin + 0.3), 2300.0, 40.0) for begin in (0.1, 0.35)]
    v = similarity.voltage * np.column_stack(drives).reshape(len(t), 5, 2)
    q = similarity.origin + similarity.length * (0.0115 + 0.002 * np.sin(9.0 * np.maximum(t - 0.1, 0.0)))
    valid = (t < 0.3) | (t > 0.38)
    log = Log(12.0 + t, q, np.zeros(len(t)), np.zeros(len(t)), v[:, 0], valid, v if fine else None)
    basis = similarity.length * np.array([-0.02, 0.04 / max(centres - 1, 1), 0.008])
    ratio = condensed_parameters.static_slope_ratio(NOMINAL)
    rotation = rotation_nodes(NOMINAL) if angle else np.empty((0, 2))
    joint = CondensedJoint(NOMINAL, basis, centres, 3000.0 * similarity.voltage, ratio, similarity, rotation)
    return CondensedProblem(joint, [log]), 0.2 * rng.standard_normal(len(joint.start()))


@pytest.mark.parametrize(
    ("centres", "pole", "similarity", "fine", "angle"),
    [
        (0, 0.0, Similarity(), True, False),
        (0, 30.0, Similarity(1.3, 0.8, 1.1, 0.9, 2e-3), False, False),
        (9, 2.0, Similarity(), True, False),
        (9, 30.0, Similarity(), True, True),
        (0, 0.0, Similarity(), False, True),
    ],
)
def test_derivatives_of_a_run_are_those_of_differences(
    centres: int, pole: float, similarity: Similarity, fine: bool, angle: bool
) -> None:
    made, theta = problem(centres, similarity, fine=fine, seed=centres + 7, angle=angle)
    errors, jacobian = made.jacobian(theta, pole)
    moved = np.array([theta + sign * STEP * unit for unit in np.eye(len(theta)) for sign in (1.0, -1.0)])
    runs = made.residuals(moved, pole)
    differences = (runs[::2] - runs[1::2]).T / (2.0 * STEP)
    assert np.allclose(errors, made.residual(theta, pole), rtol=0.0, atol=1e-9)
    least = 1.0 if angle else 0.0  # an angle does not change with the length
    size = np.maximum(np.abs(differences).max(axis=0), least)
    wrong = np.maximum(np.abs(jacobian - differences).max(axis=0) - ROUNDING, 0.0) / size
    assert wrong.max() < 1e-3  # single precision, where a number hardly acts or a stop operator turns in a difference
    assert np.median(wrong) < 1e-6
