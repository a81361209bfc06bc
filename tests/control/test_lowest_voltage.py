"""The lowest voltage that switches a joint, and its band, follow the laws that they are made of."""

from dataclasses import replace

import numpy as np
import pytest
from control_joints import model

from pipeline.control.ensemble import Converters, ensemble_at, ensemble_of
from pipeline.control.plant import plant_of, wells_and_saddle
from pipeline.control.switching_map import LowestVoltage, Well, lowest_voltage, pulses, with_voltage_error
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.model import HybridModel
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import NORMAL_90

EXACT = Converters((3e-3, 4e-3), 0.0, 0.0)


def places(joint: HybridModel) -> tuple[float, float, float]:
    left, saddle, right = (each.q for each in wells_and_saddle(plant_of(joint)))
    return left, saddle, right


def found(joint: HybridModel, converters: Converters, to: Well = "right", duration: float = 0.2) -> LowestVoltage:
    voltage = lowest_voltage(joint, converters, places(joint), to, duration)
    assert voltage is not None
    return voltage


def only(*deviations: tuple[str, float]) -> HybridModel:
    """A joint of which nothing is uncertain but these deviations, together [prior widths]."""
    joint = model()
    column: FloatArray = np.zeros((len(joint.theta), 1))
    for name, size in deviations:
        column[condensed_parameters.NAMES.index(name)] = size
    return replace(joint, band_spread=column)


def width(name: str) -> float:
    return condensed_parameters.DEVIATIONS[condensed_parameters.NAMES.index(name)].prior_std


@pytest.mark.parametrize("to", ["right", "left"])
def test_a_pulse_switches_just_above_the_lowest_voltage_and_not_below_it(to: Well) -> None:
    joint, places_of = only(), places(model())
    one = found(joint, EXACT, to)
    assert one.low == one.high == one.voltage
    volts, start = one.voltage * np.array([0.9999, 1.0001]), places_of[0 if to == "right" else 2]
    shapes = pulses(volts, np.full(2, 0.2), 0 if to == "right" else 1)
    alone = ensemble_at(joint, joint.theta[None], np.array([EXACT.lags]), np.ones(1))
    right = alone.run(shapes, start)[:, 0, -1] > places_of[1]
    assert right.tolist() == ([False, True] if to == "right" else [True, False])


def test_forces_go_with_capacitance_and_the_square_of_voltage_so_half_of_its_logarithm_is_the_voltages() -> None:
    one = found(only(("left.log C0", 0.3)), EXACT)
    assert one.of_parameters == pytest.approx(0.5 * 0.3 * width("left.log C0"), rel=1e-4)
    assert found(only(("right.log C0", 0.3)), EXACT).of_parameters == pytest.approx(0.0, abs=1e-7)


def test_the_band_is_that_of_all_its_sources_and_twice_as_wide_where_they_are() -> None:
    joint = only(("left.log C0", 0.3), ("log E", 0.1))
    one = found(joint, Converters(EXACT.lags, 0.05, 0.003))
    whole = np.sqrt(one.of_parameters**2 + one.of_lags**2 + one.of_probe**2)
    np.testing.assert_allclose(
        np.log([one.low, one.high]) - np.log(one.voltage), NORMAL_90 * whole * np.array([-1.0, 1.0])
    )
    assert one.of_probe == 0.003
    assert 0.0 < one.of_lags < 0.05
    double = found(replace(joint, band_spread=2.0 * joint.band_spread), Converters(EXACT.lags, 0.1, 0.006))
    assert double.of_parameters == pytest.approx(2.0 * one.of_parameters, rel=1e-4)
    assert double.of_lags == pytest.approx(2.0 * one.of_lags, rel=1e-4)


def test_short_pulses_need_more_and_a_voltage_that_is_not_there_is_none() -> None:
    joint = only()
    assert found(joint, EXACT, duration=0.1).voltage > 1.1 * found(joint, EXACT, duration=0.2).voltage
    assert lowest_voltage(joint, EXACT, places(joint), "right", 0.01) is None


def test_draws_of_a_map_err_by_what_the_lowest_voltage_errs_and_the_estimate_does_not() -> None:
    joint = only(("left.log C0", 0.3))
    converters = Converters(EXACT.lags, 0.0, 0.003)
    one, few = found(joint, converters), ensemble_of(joint, 32, converters)
    gains = with_voltage_error(few, [None, one]).gains
    assert gains[0] == 1.0
    assert np.log(gains[1:]).std() == pytest.approx(np.hypot(one.of_parameters, 0.003), rel=0.05)
    assert np.log(gains[1:]).mean() == pytest.approx(0.0, abs=1e-12)
    assert np.all(with_voltage_error(few, [None, None]).gains == few.gains)


def test_where_a_higher_voltage_no_longer_switches_it_swings_back() -> None:
    joint, places_of = only(), places(model())
    alone = ensemble_at(joint, joint.theta[None], np.array([EXACT.lags]), np.ones(1))
    for duration in (0.2, 0.8):
        until = found(joint, EXACT, duration=duration).until
        volts = np.array([until or alone.highest])
        ends = alone.run(pulses(volts, np.array([duration]), 0), places_of[0])[:, 0, -1]
        assert (ends[0] > places_of[1]) == (until is None)
