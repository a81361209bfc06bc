"""A joint of another size, speed, voltage and mass moves as the set's joint does, in its own units."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.parameters import NOMINAL
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.kernels import CURVES
from pipeline.models.hybrid.log_reading import Similarity
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.problem import DEVIATION_COUNT, CondensedJoint
from pipeline.signals.log import Log

UNITS = Similarity(length=0.4, time=1.6, voltage=2.5, mass=3.0, origin=4e-3)


def pair(centres: int = 4) -> tuple[HybridModel, HybridModel]:
    """The set's joint with random deviations and corrections, and its like in other units."""
    rng, basis = np.random.default_rng(3), np.array([-0.015, 0.01, 0.008])
    condensed = CondensedJoint(NOMINAL, basis, centres, 3000.0, condensed_parameters.static_slope_ratio(NOMINAL))
    theta = 0.3 * rng.standard_normal(DEVIATION_COUNT + CURVES * centres)
    other = replace(condensed, basis=UNITS.length * basis, largest_voltage=UNITS.voltage * 3000.0, similarity=UNITS)
    spreads = 2 * (np.zeros((len(theta), 1)),)
    return HybridModel.of(condensed, theta, *spreads), HybridModel.of(other, theta, *spreads)


def test_free_runs_and_curves_scale() -> None:
    ours, other = pair()
    t = 0.01 * np.arange(400)
    v = np.column_stack([2900.0 * (np.sin(2.0 * t) > 0.5), 2900.0 * (np.sin(2.0 * t) < -0.5)])
    run = ours.simulate(t, v, 0.0, 0.05)
    record = Log(
        UNITS.time * t, UNITS.origin + UNITS.length * run.q, UNITS.length / UNITS.time * run.qdot,
        UNITS.length / UNITS.time**2 * run.qddot, UNITS.voltage * v, np.ones(len(t), dtype=bool),
    )  # fmt: skip
    again = other.simulate(record.t, record.v, float(record.q[0]), float(record.qdot[0]))
    assert np.ptp(run.q) > 0.015
    np.testing.assert_allclose(again.q, record.q, atol=1e-6 * np.ptp(record.q))
    measured = replace(record, velocity=record.qdot, past=record.v[:5])
    found = UNITS.in_reference_units(measured)
    for name, truth in (("qddot", run.qddot), ("velocity", run.qdot), ("past", v[:5])):
        np.testing.assert_allclose(getattr(found, name), truth, rtol=1e-12)
    q = np.linspace(-0.012, 0.012, 7)
    force, theirs = ours.curves(q), other.curves(UNITS.origin + UNITS.length * q)
    newton = UNITS.mass * UNITS.length / UNITS.time**2
    np.testing.assert_allclose(theirs["F"], newton * force["F"], rtol=1e-6)
    # Damping is that at 1 mm/s of either joint, where the quadratic drag has a share of 1e-3.
    np.testing.assert_allclose(theirs["d"], UNITS.mass / UNITS.time * force["d"], rtol=2e-3)
    np.testing.assert_allclose(theirs["dC1_dq"], newton / UNITS.voltage**2 * force["dC1_dq"], rtol=1e-4)
    assert other.mass_kg == pytest.approx(3.0 * ours.mass_kg)
