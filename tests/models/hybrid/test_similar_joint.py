"""A joint of another size, speed and voltage is recognised from its log alone."""

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.errors import DataRefusedError
from pipeline.models.hybrid.log_reading import Similarity
from pipeline.models.hybrid.start import similar_joint
from pipeline.numerics.arrays import FloatArray
from pipeline.signals.log import Log
from tests.models.hybrid.test_hybrid import PLANTED, joint, log

UNITS = [Similarity(0.4, 1.6, 2.5, 1.0, 3e-3), Similarity(2.2, 0.6, 0.35), Similarity()]


def device(units: Similarity) -> Log:
    """A log of the planted joint as that of a device in other units."""
    inverse = Similarity(1.0 / units.length, 1.0 / units.time, 1.0 / units.voltage)
    scaled = inverse.in_reference_units(log(joint(PLANTED), 1, 20.0))
    return Log(scaled.t, scaled.q + units.origin, scaled.qdot, scaled.qddot, scaled.v, scaled.valid)


@pytest.mark.parametrize("units", UNITS)
def test_units_are_told_within_a_quarter(units: Similarity) -> None:
    found = similar_joint([device(units)], NOMINAL, mass=0.08)
    for name in ("length", "time", "voltage"):
        assert getattr(found, name) == pytest.approx(getattr(units, name), rel=0.25)
    assert found.mass == pytest.approx(0.08 / NOMINAL.m, rel=0.01)  # a hundredth of the set's is the beam's
    assert found.origin == pytest.approx(units.origin, abs=2e-3) if units.origin else found.origin == 0.0


def test_a_well_that_was_hardly_visited_does_not_decide() -> None:
    record = device(Similarity())
    kept = record.q < 0.0
    kept[np.flatnonzero(~kept)[:: len(kept) // 60]] = True
    few = Log(record.t, record.q, record.qdot, record.qddot, record.v, kept)
    few.qddot[record.q > 0.0] *= 1.0 + 40.0 * np.random.default_rng(2).standard_normal(np.count_nonzero(record.q > 0.0))
    one, other = similar_joint([record], NOMINAL), similar_joint([few], NOMINAL)
    assert other.time == pytest.approx(one.time, rel=0.15)
    assert other.voltage == pytest.approx(one.voltage, rel=0.25)


def test_scaling_a_log_scales_what_is_found_and_nothing_else() -> None:
    one, other = (similar_joint([device(units)], NOMINAL) for units in (UNITS[1], UNITS[2]))
    # Rests are looked for over fixed times, so that the wells of a faster log are a little better known.
    assert one.length / other.length == pytest.approx(2.2, rel=0.02)
    assert one.time / other.time == pytest.approx(0.6, rel=0.02)
    assert one.voltage / other.voltage == pytest.approx(0.35, rel=0.02)


def _exchanged(record: Log) -> FloatArray:
    return np.ascontiguousarray(record.v[:, ::-1])


def test_exchanged_sides_and_a_single_well_are_no_joint() -> None:
    record = device(Similarity())
    swapped = Log(record.t, record.q, record.qdot, record.qddot, _exchanged(record), record.valid)
    with pytest.raises(DataRefusedError, match="exchanged"):
        similar_joint([swapped], NOMINAL)
    still = Log(record.t, np.abs(record.q), record.qdot, record.qddot, record.v, record.valid)
    with pytest.raises(DataRefusedError, match="no two wells"):
        similar_joint([still], NOMINAL)


def test_voltages_that_act_at_no_well_are_no_joint() -> None:
    """Where rows determine no gain, rounding leaves a variance of zero or less than that, not an error of nothing."""
    record = device(Similarity())
    near = np.abs(np.abs(record.q) - np.median(np.abs(record.q))) < 0.6 * np.median(np.abs(record.q))
    undriven = Log(record.t, record.q, record.qdot, record.qddot, record.v * ~near[:, None], record.valid)
    with pytest.raises(DataRefusedError, match="no voltage drives"):
        similar_joint([undriven], NOMINAL)
