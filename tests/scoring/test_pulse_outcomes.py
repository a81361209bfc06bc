import numpy as np
import pytest

from pipeline.scoring.wells import Wells, pulse_outcomes

WELLS = Wells(left=-1.0, right=1.0, barrier=0.1)


def test_shares_become_probabilities_and_a_split_ensemble_hinges():
    ensemble = np.ones((30, 10))
    ensemble[:15, 4:] = -1.0
    right, ambiguous = pulse_outcomes(ensemble, [slice(0, 3), slice(5, 10)], WELLS)
    assert right == pytest.approx([31 / 32, 0.5])
    assert ambiguous.tolist() == [False, True]
