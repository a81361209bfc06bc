"""Modelled facts against measured ones, intervals that hold their estimate, calibrated quantities in their units."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.diagnostics.calibrated import calibrated
from pipeline.diagnostics.characteristics import intervals, shares
from pipeline.diagnostics.datasheet import DatasheetFact, comparison, fact_checks
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.parameters import DEVIATIONS
from pipeline.numerics.metrics import NORMAL_90
from tests.export.joints import hybrid


def fact(value, measured, spread, events=13, low=None, high=None):
    return DatasheetFact(
        "damping_right", "damping ratio in the right well", "1", value, low, high, measured, spread, events
    )


def test_a_damping_far_from_the_measured_one_is_a_finding():
    (check,) = fact_checks([fact(0.150, 0.095, 0.015)])
    assert check.grade == "fair"
    assert "damping ratio in the right well is 0.150 by the model, but was measured as 0.095 ± 0.015" in check.statement
    assert fact_checks([fact(0.30, 0.095, 0.015)])[0].grade == "poor"


def test_the_same_events_of_the_free_run_tell_the_size_of_motion_from_an_error():
    of_small_motion = fact(0.150, 0.095, 0.015)
    (same,) = fact_checks([replace(of_small_motion, free_run=0.096)])
    assert same.grade == "good"
    (other,) = fact_checks([replace(of_small_motion, value=0.095, free_run=0.150)])
    assert other.grade == "fair" and "0.150 in the model's free runs, but was measured as 0.095" in other.statement
    # The model's posterior says nothing of a free run: only the spread of what was measured counts there.
    assert comparison(replace(of_small_motion, low=0.0, high=0.3, free_run=0.125))[0] == pytest.approx(2.0)


def test_a_fact_that_many_draws_lack_says_so_in_place_of_an_interval():
    draws = [{"saddle": 0.0, "barrier": None} if k < 40 else {"saddle": 0.0} for k in range(64)]
    draws += [{"rest": 1.0}] * 16
    own = {"saddle": 0.0, "barrier": 1.0, "switch": None}
    assert shares(own, draws) == {"saddle": 0.8, "barrier": 0.0}
    assert shares(own, []) == {}
    assert "saddle" not in intervals(own, draws)
    unsure = replace(fact(0.1, None, None, 0), in_draws=0.8)
    assert unsure.doubt == "not certain: in 80 % of the draws"
    assert not replace(unsure, low=0.0, high=0.2, in_draws=0.95).doubt and not replace(unsure, in_draws=None).doubt


def test_calibrated_quantities_are_physical_values_around_which_their_intervals_lie():
    joint = hybrid()
    theta, spread = joint.theta.copy(), np.zeros((len(joint.theta), len(joint.theta)))
    names = [entry.name for entry in DEVIATIONS]
    at = names.index("log E")
    theta[at], spread[at, at] = -0.5, 0.1
    model = HybridModel.of(joint.joint, theta, spread, spread)
    found = {one.name: one for one in calibrated(model)}
    modulus, nominal = found["E"], joint.joint.parameters.E
    width = DEVIATIONS[at].prior_std
    assert (modulus.unit, modulus.nominal) == ("Pa", nominal)
    assert modulus.value == pytest.approx(nominal * np.exp(-0.5 * width))
    assert np.log(modulus.high / modulus.value) == pytest.approx(NORMAL_90 * 0.1 * width)
    assert all(one.low <= one.value <= one.high for one in found.values())
    assert len(found) == len(DEVIATIONS)
    assert found["left.b"].nominal == joint.joint.parameters.left.b
    weight = names.index("log weight")
    share = found["weight, share of the nominal value"]
    assert share.value == pytest.approx(np.exp(theta[weight] * DEVIATIONS[weight].prior_std))
    assert calibrated(None) == []
