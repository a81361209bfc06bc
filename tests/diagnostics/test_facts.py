"""Device facts against closed forms of a double well."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from pipeline.device.device import JOINT
from pipeline.diagnostics.characteristics import Curves, curves_from, device_facts, equilibria, intervals
from pipeline.diagnostics.datasheet import drawn_ring_downs, make_datasheet, simulated_ring_downs
from pipeline.diagnostics.events import rest_events, ring_down, voltage_switches
from pipeline.diagnostics.model_quality import model_checks
from pipeline.diagnostics.run_data import LogData
from pipeline.fitting.posterior import outcome_draws
from pipeline.models.base import FreeRun
from pipeline.scoring.wells import NoWells, Wells, snaps
from pipeline.units.units import SiUnit
from tests.reporting.synthetic import (
    DAMPING,
    MASS,
    PUSH,
    STIFFNESS,
    WELL,
    run_data,
)

Q = np.linspace(-0.02, 0.02, 4001)
K = STIFFNESS / (2 * WELL**2)
FORCE = K * (Q**2 - WELL**2) * Q
HIGHEST_FORCE = 2.0 * K * WELL**3 / (3.0 * np.sqrt(3.0))  # at q = a/√3


def _curves() -> Curves:
    pushes = np.array([np.full_like(Q, PUSH), np.full_like(Q, -PUSH)])
    return Curves(Q, FORCE, np.full_like(Q, DAMPING), pushes)


def test_facts_of_a_quartic_double_well() -> None:
    facts = device_facts(_curves(), plant=JOINT)
    assert facts["well_left"] == pytest.approx(-WELL, rel=1e-5)
    assert facts["well_right"] == pytest.approx(WELL, rel=1e-5)
    assert facts["barrier_left"] == pytest.approx(K * WELL**4 / 4.0, rel=1e-4)
    assert facts["stiffness_right"] == pytest.approx(2.0 * K * WELL**2, rel=2e-3)
    assert facts["switch_v1_to_right"] == pytest.approx(np.sqrt(HIGHEST_FORCE / PUSH), rel=1e-5)
    assert facts["switch_v2_to_left"] == pytest.approx(np.sqrt(HIGHEST_FORCE / PUSH), rel=1e-5)
    assert facts["switch_v1_to_left"] is None
    assert facts["switch_v2_to_right"] is None
    assert facts["asymmetry_wells"] == pytest.approx(0.0, abs=1e-6)


def test_asymmetries_are_those_of_a_tilted_double_well() -> None:
    left, saddle, right = -0.010, 0.002, 0.013
    force = 1e3 * np.polynomial.Polynomial.fromroots([left, saddle, right])
    at_left, top, at_right = force.integ()(np.array([left, saddle, right]))
    facts = device_facts(Curves(Q, force(Q), None, np.zeros((0, Q.size))), plant=JOINT)
    assert facts["barrier_left"] == pytest.approx(top - at_left, rel=1e-4)
    assert facts["barrier_right"] == pytest.approx(top - at_right, rel=1e-4)
    assert facts["asymmetry_wells"] == pytest.approx((left + right) / (right - left), rel=1e-4)
    mean = top - (at_left + at_right) / 2.0
    assert facts["asymmetry_barriers"] == pytest.approx((at_right - at_left) / mean, rel=1e-3)


def test_a_linear_input_switches_both_ways_with_its_sign() -> None:
    facts = device_facts(_curves(), plant=JOINT.under_other_action)
    assert facts["switch_v1_to_right"] == pytest.approx(HIGHEST_FORCE / PUSH, rel=1e-5)
    assert facts["switch_v1_to_left"] == pytest.approx(-HIGHEST_FORCE / PUSH, rel=1e-5)


def test_the_lowest_switching_voltage_is_where_the_loaded_well_vanishes() -> None:
    voltage = device_facts(_curves(), plant=JOINT)["switch_v1_to_right"]
    assert voltage is not None
    for factor, wells in ((0.999, 2), (1.001, 1)):
        loaded = FORCE - PUSH * (factor * voltage) ** 2
        assert sum(e.stable for e in equilibria(Q, loaded)) == wells


def test_intervals_hold_nine_draws_in_ten_and_leave_out_what_most_draws_lack() -> None:
    draws = [{"a": float(x), "b": 1.0 if x < 50 else None} for x in range(101)]
    limits = intervals({}, draws)
    assert list(limits) == ["a"]
    assert limits["a"] == pytest.approx((5.0, 95.0))


@pytest.mark.parametrize(("frequency", "damping"), [(2.8, 0.04), (1.5, 0.12), (6.0, 0.02)])
def test_a_ring_down_is_recovered(frequency: float, damping: float) -> None:
    t = np.arange(0.0, 1.5, 0.01)
    natural = 2.0 * np.pi * frequency / np.sqrt(1.0 - damping**2)
    q = 0.011 + 1e-3 * np.exp(-damping * natural * t) * np.sin(2.0 * np.pi * frequency * t + 0.4)
    found = ring_down(t, q + 3e-6 * np.random.default_rng(0).standard_normal(t.size))
    assert found is not None
    assert found.frequency == pytest.approx(frequency, rel=5e-3)
    assert found.damping == pytest.approx(damping, rel=5e-2)


def test_switches_and_snaps_are_found_where_they_are() -> None:
    t = np.arange(0.0, 10.0, 0.01)
    v = np.zeros((t.size, 2))
    v[(t >= 2.0) & (t < 3.0), 0] = 3e3
    v[(t >= 6.0) & (t < 7.0), 1] = 2e3
    q = np.where((t < 2.1) | (t > 6.1), -0.011, 0.011) + 5e-3 * np.exp(-(((t - 4.0) / 0.1) ** 2))
    np.testing.assert_allclose(voltage_switches(t, v), [2.0, 3.0, 6.0, 7.0], atol=0.011)
    np.testing.assert_allclose(t[snaps(q, Wells(-0.011, 0.011, 0.0))], [2.1, 6.1], atol=0.011)
    assert snaps(q, NoWells("none")).size == 0


def test_measured_rests_and_rings_are_those_of_the_truth() -> None:
    log = run_data().logs[0]
    rests = rest_events([(log.motion.t, log.motion.q, log.motion.v)], Wells(-WELL, WELL, 0.0), plant=JOINT)
    natural = np.sqrt(STIFFNESS / MASS) / (2.0 * np.pi)
    assert len(rests["well_left"]) > 3
    assert len(rests["well_right"]) > 3
    assert np.median(rests["well_left"]) == pytest.approx(-WELL, rel=0.1)
    assert np.median(rests["frequency_right"]) == pytest.approx(natural, rel=0.15)


def test_the_datasheet_knows_the_truth_and_its_uncertainty() -> None:
    sheet = make_datasheet(run_data())
    facts = {fact.key: fact for fact in sheet.facts}
    barrier, frequency = facts["barrier_left"], facts["frequency_right"]
    assert barrier.low is not None
    assert barrier.high is not None
    assert barrier.value is not None
    assert barrier.low < K * WELL**4 / 4.0 < barrier.high
    assert barrier.high - barrier.low == pytest.approx(2 * 1.645 * 0.02 * barrier.value, rel=0.3)
    assert frequency.value == pytest.approx(np.sqrt(STIFFNESS / MASS) / (2.0 * np.pi), rel=0.05)
    assert facts["damping_right"].value == pytest.approx(DAMPING / (2 * np.sqrt(STIFFNESS * MASS)), rel=0.2)


def test_rests_that_have_not_settled_are_judged_by_those_of_a_free_run_not_by_the_wells() -> None:
    def graded(*, followed: bool) -> str:
        def crept(log: LogData) -> LogData:
            q = log.motion.q + np.where((log.motion.v > 0.0).any(axis=1), 0.0, 0.3 * WELL)
            predictions = {m: {**run, "q": q if followed else run["q"]} for m, run in log.predictions.items()}
            return replace(log, motion=replace(log.motion, q=q), predictions=predictions)

        data = run_data()
        checks = make_datasheet(replace(data, logs=tuple(crept(log) for log in data.logs))).checks
        return next(check.grade for check in checks if check.name == "wells")

    assert graded(followed=True) == "good"
    assert graded(followed=False) == "poor"


def test_outcomes_that_hinge_and_states_outside_the_training_are_graded() -> None:
    data = run_data()
    rows = [row | {"outcomes": 10, "ambiguous_outcomes": 2, "outside_training": 0.08} for row in data.scores]
    wells = Wells(-WELL, WELL, 0.0)
    found = {check.name: check for check in model_checks(replace(data, scores=rows), "rbf", None, wells)}
    assert found["ambiguous"].grade == "fair"
    assert "2 of 10 outcomes" in found["ambiguous"].statement
    assert found["outside"].grade == "fair"  # the model errs by 0.1 % there
    far = [row | {"nrmse": 0.03} for row in rows]
    found = {check.name: check for check in model_checks(replace(data, scores=far), "rbf", None, wells)}
    assert found["outside"].grade == "poor"
    assert not {"ambiguous", "outside"} & {check.name for check in model_checks(data, "rbf", None, wells)}
    without = {check.name for check in model_checks(replace(data, scores=rows), "rbf", None, NoWells("one rest"))}
    assert without & {"ambiguous", "outside"} == {"outside"}


@pytest.mark.parametrize(
    ("displacement", "mass_known", "force", "energy"),
    [
        ("m", True, "N", "J"),
        ("m", False, "m/s²", "J/kg"),
        ("rad", True, "N·m", "J"),
        ("rad", False, "rad/s²", "rad²/s²"),
        ("V", False, "V/s²", "V²/s²"),
    ],
)
def test_an_energy_is_a_force_times_what_q_is(displacement: str, mass_known: bool, force: str, energy: str) -> None:
    plant = replace(run_data().device, displacement=SiUnit(1.0, displacement), known_mass=0.04 if mass_known else None)
    data = replace(run_data(), device=plant)
    assert (plant.curve_units["F"], plant.energy_unit) == (force, energy)
    units = {fact.key: fact.unit for fact in make_datasheet(data).facts}
    assert units["barrier_left"] == energy
    assert units["stiffness_left"] == (f"{force}/{displacement}" if mass_known else "1/s²")


def _pulsed(step: float, damping: float, frequency: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A device that rings [Hz] after each pulse of 1 s: (t, q, v)."""
    t = np.arange(0.0, 30.0, step)
    since = (t - 1.0) % 3.0
    v = np.where((since < 1.0) & (t > 1.0), 10.0, 0.0)[:, None]
    natural = 2.0 * np.pi * frequency
    swing = np.exp(-damping * natural * (since - 1.0)) * np.cos(natural * (since - 1.0))
    return t, np.where(v[:, 0] > 0.0, 1e-3, 2e-4 * swing), v


def test_hum_is_no_ring_down_where_it_is_aliased_to_either() -> None:
    """60 Hz in samples at 100 Hz: 40 Hz that never decays."""
    t, q, v = _pulsed(0.01, 0.05, 3.0)
    ringing = rest_events([(t, q, v)], NoWells("none"), plant=JOINT)
    assert np.median(ringing["frequency"]) == pytest.approx(3.0, rel=0.01)
    still = np.where(v[:, 0] > 0.0, 1e-3, 0.0)
    humming = still + 7e-5 * np.sin(2.0 * np.pi * 60.0 * t)
    assert "frequency" not in rest_events([(t, humming, v)], NoWells("none"), plant=JOINT)
    drifting = still + 7e-5 * np.exp(-0.3 * (t % 3.0)) * np.sin(2.0 * np.pi * 60.1 * t)
    assert "frequency" in rest_events([(t, drifting, v)], NoWells("none"), plant=JOINT)
    assert "frequency" not in rest_events([(t, drifting, v)], NoWells("none"), [60.0], plant=JOINT)
    assert "frequency" in rest_events([(t, q, v)], NoWells("none"), [60.0], plant=JOINT)


def test_a_drawn_ring_down_is_that_of_its_own_spring_and_damper() -> None:
    """Against the closed form of a weakly damped vibration: ω = √(k/m), ζ = d/(2 √(k m))."""
    own = _curves()
    draw = replace(own, force=1.04 * FORCE, damping=1.1 * np.full_like(Q, DAMPING))

    def closed(stiffness: float, damping: float) -> tuple[float, float]:
        return np.sqrt(stiffness / MASS) / (2.0 * np.pi), damping / (2.0 * np.sqrt(stiffness * MASS))

    frequency, ratio = closed(2.0 * K * WELL**2, DAMPING)
    rings = {"frequency_left": frequency, "damping_left": ratio, "frequency_right": None, "damping_right": None}
    model = run_data().models["rbf"]
    (facts,) = drawn_ring_downs(model, rings, own, [draw], JOINT)
    drawn = closed(1.04 * 2.0 * K * WELL**2, 1.1 * DAMPING)
    assert facts == {"frequency_left": pytest.approx(drawn[0]), "damping_left": pytest.approx(drawn[1])}
    (facts,) = drawn_ring_downs(model, rings, own, [replace(draw, damping=None)], JOINT)
    assert facts.keys() == {"frequency_left"}


@dataclass(frozen=True)
class Stuck:
    """A spring and a damper of known curves, stiffened by friction that sticks and is known to 4 %."""

    stuck: float = 300.0
    input_count = 2
    fine_voltages = False
    name = "rbf"
    mass_kg = MASS

    def curves(self, q: np.ndarray[Any, Any]) -> dict[str, np.ndarray[Any, Any]]:
        none = np.zeros_like(q)
        return {"F": STIFFNESS * q, "d": none + DAMPING, "dC1_dq": none, "dC2_dq": none}

    def simulate(self, t: np.ndarray[Any, Any], v: np.ndarray[Any, Any], q0: float, qdot0: float) -> FreeRun:
        decay = DAMPING / (2.0 * MASS)
        angular = np.sqrt((STIFFNESS + self.stuck) / MASS - decay**2)
        q = np.exp(-decay * t) * (q0 * np.cos(angular * t) + (qdot0 + decay * q0) / angular * np.sin(angular * t))
        return FreeRun(t, q, np.zeros_like(q), np.zeros_like(q), "ok")

    def describe(self) -> dict[str, Any]:
        return {}

    def outcome_ensemble(self, outcome: Callable[[Any], np.ndarray[Any, Any]], count: int = 64) -> np.ndarray[Any, Any]:
        spread = np.array([[0.04 * self.stuck]])
        return outcome_draws(lambda theta: outcome(Stuck(theta[0])), np.array([self.stuck]), spread, count, 1)


def test_the_interval_of_a_ring_down_holds_what_sticking_friction_leaves_open() -> None:
    """Against the closed form: ω₀² = (k + s)/m, so that the frequency is known to half of what s is of k + s."""
    model = Stuck()
    own = curves_from(model.curves(Q), Q)
    rings = simulated_ring_downs(model, device_facts(own, plant=JOINT), own, 2)
    draws = drawn_ring_downs(model, rings, own, 400 * [own], JOINT)
    stiffness = STIFFNESS + model.stuck
    frequencies = np.array([draw["frequency"] for draw in draws], dtype=np.float64)
    ratios = np.array([draw["damping"] for draw in draws], dtype=np.float64)
    assert frequencies.mean() == pytest.approx(np.sqrt(stiffness / MASS) / (2.0 * np.pi), rel=0.01)
    known = 0.5 * 0.04 * model.stuck / stiffness
    assert frequencies.std() / frequencies.mean() == pytest.approx(known, rel=0.1)
    assert ratios.std() / ratios.mean() == pytest.approx(known, rel=0.1)
