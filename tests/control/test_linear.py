"""Equilibria are at rest, Jacobians are those of the equations, poles are those of the motion."""

import re
import sys
import types
from collections.abc import Callable

import numpy as np
import pytest
from control_joints import model

from pipeline.control.plant import equilibria, held, jacobian, plant_of, wells_and_saddle
from pipeline.diagnostics.events import ring_down
from pipeline.errors import InputError
from pipeline.generated.condensed_joint import STATES, STOPS
from pipeline.models.hybrid.parameters import NAMES
from tests.models.hybrid.linearisation import Linearised


def test_both_wells_and_the_unstable_equilibrium_are_found_at_rest() -> None:
    plant = plant_of(model())
    left, saddle, right = equilibria(plant, np.zeros(2))
    assert (left.stable, saddle.stable, right.stable) == (True, False, True)
    assert np.sum(saddle.poles.real > 0.0) == 1
    joint = (plant.constants.k, plant.constants.basis, plant.constants.weights)
    for each in (left, saddle, right):
        assert np.abs(Linearised(*joint, each.x, np.zeros(STOPS), np.zeros(2)).f[:STATES]).max() < 1e-5
    assert -left.q == pytest.approx(right.q, abs=1e-6)
    assert saddle.q == pytest.approx(0.0, abs=1e-6)


def test_jacobians_are_those_that_follow_from_the_equations() -> None:
    plant = plant_of(model())
    u = np.array([1000.0**2, 0.0])
    joint = (plant.constants.k, plant.constants.basis, plant.constants.weights)

    def rates(x: np.ndarray, v_squared: np.ndarray) -> np.ndarray:
        return Linearised(*joint, x, np.zeros(STOPS), v_squared).f[:STATES]

    for each in equilibria(plant, np.sqrt(u)):
        a, b = jacobian(each.x, u, plant.constants)
        by_x = np.column_stack([slope(lambda x: rates(x, u), each.x, 2e-5 * unit) for unit in np.eye(STATES)])
        by_u = np.column_stack([slope(lambda w, x=each.x: rates(x, w), u, 1e4 * unit) for unit in np.eye(2)])
        scale = np.abs(a).max(axis=1, keepdims=True)
        np.testing.assert_allclose(a / scale, by_x / scale, atol=1e-7)
        np.testing.assert_allclose(b, by_u, atol=1e-7 * np.abs(b).max())


def slope(law: Callable[[np.ndarray], np.ndarray], x: np.ndarray, step: np.ndarray) -> np.ndarray:
    """Central difference of fourth order."""
    near, far = law(x + step) - law(x - step), law(x + 2.0 * step) - law(x - 2.0 * step)
    return (8.0 * near - far) / (12.0 * np.abs(step).max())


def test_linear_models_hold_no_dry_friction() -> None:
    """A level that sets in with the speed would be a damping of small motions alone."""
    free, dry = (
        wells_and_saddle(plant_of(model(**{"log sliding force": level, "log sliding speed": -2.0})))[2]
        for level in (-20.0, 2.0)
    )
    np.testing.assert_allclose(dry.a, free.a, rtol=1e-6, atol=1e-9 * np.abs(free.a).max())


def test_an_equilibrium_held_by_voltage_is_one_under_that_voltage() -> None:
    plant = plant_of(model())
    near = wells_and_saddle(plant)[0].x.copy()
    near[0] += 2e-3
    answer = held(plant, near, np.zeros(2), np.array([1.0, 0.0]))
    assert answer is not None
    x, u = answer
    found = equilibria(plant, np.array([np.sqrt(u), 0.0]))
    assert min(abs(each.x[0] - x[0]) for each in found) < 1e-7


def test_the_poles_are_frequency_and_damping_of_small_oscillations() -> None:
    free = model(**dict.fromkeys((name for name in NAMES if re.match("log (stop|layer|sliding) force", name)), -20.0))
    well = wells_and_saddle(plant_of(free))[2]
    t = np.arange(300) * 0.01
    run = free.simulate(t, np.zeros((t.size, 2)), well.q + 0.05e-3, 0.0)
    found = ring_down(run.t, run.q)
    assert found is not None
    assert well.ringing is not None
    frequency, damping = well.ringing
    assert found.frequency == pytest.approx(frequency, rel=0.01)
    assert found.damping == pytest.approx(damping, rel=0.1)


def test_a_state_space_is_that_of_python_control_or_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    at = wells_and_saddle(plant_of(model()))[2]
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(InputError, match="pip install control"):
        at.state_space()
    monkeypatch.setitem(sys.modules, "control", types.SimpleNamespace(StateSpace=lambda *matrices: matrices))
    for found, truth in zip(at.state_space(squared=True), (at.a, at.b_squared, at.c, at.d), strict=True):
        np.testing.assert_array_equal(found, truth)
