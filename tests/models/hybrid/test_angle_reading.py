"""A joint whose angle is measured: conversion, reading, and an independent joint."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.device.device import device
from pipeline.device.parameters import NOMINAL, TABLE1
from pipeline.errors import InputError
from pipeline.models.analytical.statics import displacement_of_rotation, rotation_nodes, static_rotation
from pipeline.models.hybrid.log_reading import AngleReading
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.parameters import nominal_deviations, static_slope_ratio
from pipeline.models.hybrid.problem import CondensedJoint
from pipeline.rig.joint import simulate
from pipeline.rig.parameters import nominal
from pipeline.settings.prototype import Prototype
from pipeline.signals.columns import Signal
from pipeline.signals.log import RawLog
from pipeline.workflow.si_log import with_displacement
from tests.models.hybrid.test_hybrid import pulses


def prototype(unit: str, *, parameters: str | None = "nominal", second: bool = True) -> Prototype:
    volts = {"v1": "kV", "v2": "kV"} if second else {"v1": "kV"}
    channels = {name: {"channel": name, "unit": unit} for name, unit in ({"q": unit} | volts).items()}
    plant = {"mass": {"value": 40.0, "unit": "g"}} | ({"parameters": parameters} if parameters else {})
    return Prototype.model_validate({"name": "P", "logs": {"train": ["a"]}, "channels": channels, "plant": plant})


@pytest.mark.parametrize("parameters", [NOMINAL, TABLE1])
def test_the_displacement_is_the_inverse_of_the_rotation(parameters: object) -> None:
    q = np.linspace(-0.034, 0.034, 3401)
    phi = static_rotation(q, parameters)
    found, slope = displacement_of_rotation(phi, parameters)
    assert found == pytest.approx(q, abs=1e-7)
    middle = slice(210, -210)
    assert slope[middle] == pytest.approx(np.gradient(q, phi)[middle], rel=2e-3)


def test_only_the_angle_of_a_joint_is_converted() -> None:
    plant = device(prototype("deg"))
    assert (plant.logged.symbol, plant.displacement.symbol, plant.joint, plant.known_mass) == ("rad", "m", True, 0.04)
    other = prototype("deg", parameters=None)
    other = other.model_copy(update={"plant": other.plant.model_copy(update={"mass": None})})
    assert device(other).angle is None
    assert device(other).displacement.symbol == "rad"
    assert device(prototype("mm")).angle is None
    with pytest.raises(InputError, match="a length or its angle"):
        device(prototype("V"))


def test_a_log_of_the_angle_has_displacement_and_velocity() -> None:
    t = np.arange(2001) / 1000.0
    q = 0.01 * np.sin(4.0 * t)
    phi = static_rotation(q, NOMINAL)
    plant = device(prototype("deg"))
    raw = RawLog(Signal(t, phi), (Signal(t, t), Signal(t, t)), Signal(t, np.gradient(phi, t)))
    log = with_displacement(raw, plant, NOMINAL)
    assert log.q[1] == pytest.approx(q, abs=1e-8)
    assert log.velocity is not None
    assert log.velocity[1][1:-1] == pytest.approx(0.04 * np.cos(4.0 * t)[1:-1], abs=4e-4)
    assert with_displacement(raw, device(prototype("mm")), NOMINAL) is raw
    with pytest.raises(InputError, match="unit, offset or scale"):
        with_displacement(replace(raw, q=(t, np.degrees(phi) + 5.0)), plant, NOMINAL)


def test_reading_and_displacement_are_inverse_with_their_derivatives() -> None:
    angle = AngleReading(rotation_nodes(NOMINAL), 13.0)
    t = np.linspace(0.0, 1.0, 20001)
    q, qdot, qddot = 0.02 * np.sin(5.0 * t), 0.1 * np.cos(5.0 * t), -0.5 * np.sin(5.0 * t)
    y, ydot, yddot = angle.read(q, qdot, qddot)
    assert np.gradient(y, t)[1:-1] == pytest.approx(ydot[1:-1], abs=1e-4)
    assert np.gradient(ydot, t)[1:-1] == pytest.approx(yddot[1:-1], abs=5e-2)
    for given, found in zip((q, qdot, qddot), angle.shown(y, ydot, yddot), strict=True):
        assert found == pytest.approx(given, abs=1e-9)


def test_the_equations_follow_the_angle_of_the_virtual_joint() -> None:
    """The rig, which does not know the equations, moves a nominal joint; its angle is no function of q."""
    t, v = pulses(3, 4.0)
    fine = np.arange(round(4000.0 * t[-1]) + 1) / 4000.0
    volts = np.column_stack([np.interp(fine, t, column) for column in v.T])
    motion = simulate(nominal(), volts, 1.0 / 4000.0, stride=2)
    at = slice(None, None, 40)
    measured = displacement_of_rotation(motion.phi[at], NOMINAL)[0]
    ratio = static_slope_ratio(NOMINAL)
    errors = []
    for rotation in (rotation_nodes(NOMINAL), np.empty((0, 2))):
        joint = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, 3000.0, ratio, rotation=rotation)
        theta = np.append(nominal_deviations(), np.empty(0))
        model = HybridModel.of(joint, theta, *2 * (np.zeros((len(theta), len(theta))),))
        run = model.simulate(t, v, float(measured[0]), 0.0)
        errors.append(float(np.sqrt(np.mean((run.q - measured) ** 2)) / np.ptp(measured)))
    assert errors[0] < 0.02
    assert errors[0] < 0.4 * errors[1]
