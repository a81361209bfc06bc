"""Models are told apart only where the same segments say so."""

import numpy as np

from pipeline.device.device import JOINT
from pipeline.scoring.intervals import excess_over_lowest

RNG = np.random.default_rng(1)
SHARED = np.repeat(RNG.exponential(size=40), 100) * RNG.normal(size=4000)


def test_a_model_that_errs_more_everywhere_is_told_apart_and_its_excess_is_right() -> None:
    found = excess_over_lowest({"better": SHARED, "worse": 1.1 * SHARED}, 0.01, plant=JOINT)
    assert set(found) == {"worse"}
    band = found["worse"]
    rms = float(np.sqrt(np.mean(SHARED**2)))
    assert band is not None and 0.0 < band.low < 0.1 * rms < band.high


def test_a_lead_by_one_event_is_none() -> None:
    lucky, unlucky = SHARED.copy(), SHARED.copy()
    unlucky[1000:1100] += 3.0
    lucky[3000:3100] += 2.9
    band = excess_over_lowest({"lucky": lucky, "unlucky": unlucky}, 0.01, plant=JOINT)["unlucky"]
    assert band is not None and band.low < 0.0 < band.high
