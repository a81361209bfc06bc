import numpy as np
import pytest

from pipeline.scoring.wells import Wells, pulse_outcomes

WELLS = Wells(left=-1.0, right=1.0, barrier=0.1)


def test_shares_become_probabilities_and_a_split_ensemble_hinges():
    ensemble = np.ones((30, 10))
    ensemble[:15, 4:] = -1.0
    found = pulse_outcomes(ensemble, [slice(0, 3), slice(5, 10)], WELLS)
    assert found.probability_right == pytest.approx([31 / 32, 0.5])
    assert found.ambiguous.tolist() == [False, True]


def test_calibrated_probabilities_score_better_than_overconfident_ones():
    rng = np.random.default_rng(1)
    truth = rng.uniform(size=400)
    went = rng.uniform(size=400) < truth
    members = np.where(rng.uniform(size=(200, 400)) < truth, 1.0, -1.0)
    rests = [slice(i, i + 1) for i in range(400)]
    honest, cocky = pulse_outcomes(members, rests, WELLS), pulse_outcomes(np.sign(members.sum(0))[None], rests, WELLS)
    brier = [float(np.mean((found.probability_right - went) ** 2)) for found in (honest, cocky)]
    assert brier[0] < min(0.2, brier[1])
