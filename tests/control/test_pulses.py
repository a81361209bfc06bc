"""Feedforward snaps and the switching map agree with the model's own runs."""

import numpy as np
import pytest
from control_joints import converters, model

from pipeline.control.ensemble import INTERVAL, ensemble_of
from pipeline.control.estimator import PERIOD
from pipeline.control.plant import plant_of, wells_and_saddle
from pipeline.control.pulses import design_pulse, settling_times
from pipeline.control.switching_map import pulses, switching_map
from pipeline.errors import InputError


def test_an_ensemble_runs_as_the_model_does() -> None:
    joint = model(delay=0.5)
    left = wells_and_saddle(plant_of(joint))[0].q
    volts = pulses(np.array([2800.0]), np.array([0.3]), 0)
    q = ensemble_of(joint, 0, converters(1e-6)).run(volts, left)[0, 0]
    volts = np.concatenate([np.zeros((4, 2)), volts[0]])
    t = np.arange(len(volts) // 4) * 4e-3
    fine = volts[: 4 * t.size].reshape(t.size, 4, 2)
    # The model's voltages are lines between their values, those of an ensemble are held: half a millisecond.
    assert np.abs(joint.simulate(t, fine, left, 0.0).q[1:] - q[: t.size - 1]).max() < 0.25e-3
    assert INTERVAL == 4 * PERIOD


@pytest.mark.long
@pytest.mark.parametrize("to", ["right", "left"])
def test_a_snap_settles_fast_without_overshoot_on_the_model_and_ends_well_in_all_draws(to: str) -> None:
    joint = model()
    left, _, right = (each.q for each in wells_and_saddle(plant_of(joint)))
    start, target = (left, right) if to == "right" else (right, left)
    made, robust = (
        design_pulse(ensemble_of(joint, draws, converters(3e-3)), start, target, right - left, 2900.0)
        for draws in (0, 8)
    )
    assert made.settling_s < 0.3
    assert made.overshoot_m < 1.0e-3
    assert robust.probability == 1.0
    assert robust.settling_low_s <= robust.settling_high_s < 1.2
    assert made.settling_low_s <= made.settling_high_s
    assert made.v.min() >= 0.0
    assert made.v.max() <= 2900.0
    assert np.all(made.v[-1] == 0.0)


def test_a_voltage_that_cannot_switch_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """After each round has been reported: the search takes up to a minute."""
    monkeypatch.setattr("pipeline.control.pulses._ROUNDS", 4)
    joint, shares = model(), list[float]()
    left, _, right = (each.q for each in wells_and_saddle(plant_of(joint)))
    with pytest.raises(InputError, match="allow a larger voltage"):
        design_pulse(
            ensemble_of(joint, 0, converters(3e-3)), left, right, right - left, 300.0,
            on_progress=lambda _, share: shares.append(share),
        )  # fmt: skip
    assert len(set(shares)) > 3 and shares == sorted(shares) and 0.0 == shares[0] < shares[-1] <= 1.0


def test_settling_times_are_those_of_the_last_entry_into_the_band() -> None:
    t = np.arange(200) * INTERVAL
    q = np.exp(-t / 0.1)
    assert settling_times(q, 0.0, 1.0) == pytest.approx(0.1 * np.log(20.0), abs=1e-3)
    assert settling_times(0.0 * q, 0.0, 1.0) == 0.0
    assert settling_times(0.0 * q + 1.0, 0.0, 1.0) == np.inf


def test_the_map_is_sure_far_from_its_boundary_and_knows_its_own_runs() -> None:
    joint = model()
    left, saddle, right = (each.q for each in wells_and_saddle(plant_of(joint)))
    some = ensemble_of(joint, 3, converters(3e-3))
    found = switching_map(some, (left, saddle, right), "right")
    assert np.all(found.probability[0] == 0.0)  # 0.6 kV never
    assert found.probability[-1, -1] == 1.0  # 3 kV for 1 s always
    assert np.all((found.low <= found.probability) & (found.probability <= found.high))
    for i, j in ((18, 15), (12, 14), (24, 5)):
        volts = pulses(found.voltages[[i]], found.durations[[j]], 0)
        assert found.probability[i, j] == pytest.approx(np.mean(some.run(volts, left)[0, 1:, -1] > saddle))
