"""Online identification: the stream converges to the batch solution, and forgetting follows a planted drift."""

import numpy as np
import pytest

from pipeline.models.paper.online import drifted, follow


def _stream(count: int = 4000) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Rows of a joint with three force and two input columns, its weights, its target, and rows of F."""
    rng = np.random.default_rng(1)
    rows, weights = rng.standard_normal((count, 5)), np.array([2.0, -1.0, 0.5, 3.0, 1.0])
    force = np.column_stack([np.eye(3), np.zeros((3, 2))])
    return rows, weights, rows @ weights + 1e-3 * rng.standard_normal(count), force


def test_a_constant_joint_is_found_and_nothing_forgotten_is_best() -> None:
    rows, weights, target, force = _stream()
    truth = np.tile(force @ weights, (len(target), 1))
    samples, kept, prediction = follow(rows, target, force, truth, forgetting=1.0)
    _, forgetful, _ = follow(rows, target, force, truth, forgetting=0.98)
    assert kept[-1] < 1e-4
    assert kept[-1] < forgetful[-1] < 1e-3
    assert samples[-1] == len(target)
    assert prediction[0] > 0.9  # nothing is known before the first sample
    assert prediction[-1] < 1e-3


def test_a_drift_is_followed_by_forgetting_alone() -> None:
    rows, weights, target, force = _stream()
    planted, growth = drifted(rows, target, weights, 3, 0.2)
    assert growth[[0, -1]] == pytest.approx([1.0, 1.2])
    assert planted - target == pytest.approx((growth - 1.0) * (rows[:, :3] @ weights[:3]))
    truth = growth[:, None] * (force @ weights)
    _, kept, _ = follow(rows, planted, force, truth, forgetting=1.0)
    _, forgetful, _ = follow(rows, planted, force, truth, forgetting=0.98)
    # Nothing forgotten, the estimate is the mean over the drift: 10 % of F behind.
    assert kept[-1] == pytest.approx(0.1 * np.sqrt(np.mean((force @ weights) ** 2)) / 3.0, rel=0.1)
    assert forgetful[-1] < 0.05 * kept[-1]
