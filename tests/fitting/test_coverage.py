import numpy as np
import pytest

from pipeline.fitting.information import coverage, share_outside


def test_every_sample_counts_for_its_nearest_centre_and_for_the_inputs_that_acted():
    centres = np.array([-1.0, 0.0, 1.0])
    q = [np.array([-2.0, -0.9, 0.1, 0.2]), np.array([0.6, 5.0])]
    v = [np.array([[0.0], [1.0], [1.0], [0.05]]), np.array([[0.0], [-1.0]])]
    found = coverage(centres, q, v)
    assert found.visits.tolist() == [2, 2, 2]
    assert found.driven.tolist() == [[1, 1, 1]]


def test_the_training_data_themselves_are_inside_and_far_away_is_outside():
    rng = np.random.default_rng(2)
    q, qdot = rng.uniform(-1, 1, (2, 3000))
    assert share_outside(q, qdot, q, qdot) == 0.0
    assert share_outside(q + 10.0, qdot, q, qdot) == 1.0
    assert share_outside(q, qdot - 10.0, q, qdot) == 1.0
    assert share_outside(np.array([0.0, 9.0]), np.array([0.0, 0.0]), q, qdot) == pytest.approx(0.5)
