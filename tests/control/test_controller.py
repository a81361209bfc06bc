"""The controller: voltages within limits whatever it is told, C equal to Python, closed loops on the model."""

import ctypes
import json
import re
import shutil
import subprocess
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from control_joints import Running, designed, model
from hypothesis import given, settings, strategies as st
from scipy.signal import lfilter

from pipeline.control.controller import PERIOD, begin_control, closed_on_model, control, estimate, move, observe
from pipeline.control.design import Settings, acting_lags, condensed_joint_law, design
from pipeline.control.estimator import ESTIMATED, MEMORY, STATUS
from pipeline.control.law import CONTROLLER_STATE, FILTER, NUMBERS, PLACES, Law
from pipeline.control.plant import plant_of, wells_and_saddle
from pipeline.errors import CorruptArtifactError, InputError
from pipeline.export.controller import ESTIMATES, write_controller
from pipeline.models.hybrid.log_reading import Similarity
from pipeline.models.hybrid.parameters import NAMES
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import BAND, step_metrics

GCC = [
    "gcc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wdouble-promotion",
    "-Wfloat-equal", "-Werror", "-O2", "-shared", "-fPIC",
]  # fmt: skip
needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")

anything = st.one_of(
    st.floats(-0.012, 0.012),
    st.floats(allow_nan=True, allow_infinity=True),
    st.sampled_from([np.nan, np.inf, -np.inf, 1e300, -1e300, 0.0, 5e-324]),
)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(anything, anything, st.integers(1, 20)), min_size=1, max_size=5))
def test_voltages_lie_within_the_limits_whatever_the_inputs(told: list[tuple[float, float, int]]) -> None:
    _, law = designed()
    running = Running(law, told[0][0])
    for q, target, times in told:
        for _ in range(times):
            v = running.step(q, target)
            assert np.all((v >= 0.0) & (v <= law.number("highest")))
            assert np.all(np.isfinite(running.state))


@given(st.sampled_from([np.nan, np.inf, 1e300, -1e300]), st.floats(-0.01, 0.01))
@settings(max_examples=10, deadline=None)
def test_a_lost_signal_ramps_to_zero_within_50_ms_and_a_found_one_begins_anew(lost: float, target: float) -> None:
    _, law = designed()
    running = Running(law, -0.011)
    for _ in range(20):
        running.step(-0.011, 0.011)
    volts = np.array([running.step(lost, target) for _ in range(round(50e-3 / PERIOD))])
    assert np.all(volts[-10:] == 0.0)
    assert np.all(volts.max(axis=1) <= law.number("highest") * (1.0 - np.arange(1, 51) / 40.0).clip(0.0) + 1e-9)
    running.step(0.0, 0.011)
    assert running.state[0] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("none", [np.nan, np.inf, 0.5])
def test_a_controller_that_was_never_told_where_the_joint_is_stays_without_voltage(none: float) -> None:
    running = Running(designed()[1], none)
    assert not np.any([running.step(none, 0.011) for _ in range(100)])
    running.step(-0.011, 0.011)
    assert np.any(running.step(-0.011, 0.011))


SLEW, MEAN = 50e3, 400.0  # V/s, V


@lru_cache(maxsize=1)
def within_limits() -> Law:
    return design(designed()[0], Settings(3000.0, (3e-3, 3e-3), SLEW, MEAN))


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(anything, anything, st.integers(1, 400)), min_size=1, max_size=8))
def test_rate_and_mean_of_the_voltages_stay_within_their_limits_whatever_the_inputs(
    inputs: list[tuple[float, float, int]],
) -> None:
    running = Running(within_limits(), inputs[0][0])
    assert_within_limits(np.array([running.step(q, target) for q, target, times in inputs for _ in range(times)]))


def assert_within_limits(v: FloatArray) -> None:
    """Voltages (n, 2) from none on, their rates, and their means by a lag."""
    assert v.min() >= 0.0
    assert np.abs(np.diff(v, axis=0, prepend=0.0)).max() <= PERIOD * SLEW * (1.0 + 1e-9)
    share = PERIOD / MEMORY
    assert lfilter([share], [1.0, share - 1.0], v, axis=0).max() <= MEAN * (1.0 + 1e-9)


def test_limits_on_rate_and_mean_leave_snaps_and_end_what_takes_voltage_for_long() -> None:
    left, saddle, right = (each.q for each in wells_and_saddle(designed()[0]))
    target = np.repeat([left, right, left, saddle], [50, 1000, 1000, 12000])
    q, v = closed_on_model(within_limits(), within_limits(), left, target)
    snaps = step_metrics(PERIOD * np.arange(q.size), q, target, right - left)[1:3]
    assert all(snap.settling_s is not None and snap.settling_s < 0.35 for snap in snaps)
    assert np.abs(q[4000:6000] - saddle).max() < 0.05e-3
    mean = np.zeros(2)
    for volts in v:
        mean += (volts - mean) * PERIOD / MEMORY
    assert 0.98 * MEAN < mean.max() <= MEAN
    assert 0.9 * PERIOD * SLEW < np.abs(np.diff(v, axis=0)).max() <= PERIOD * SLEW * (1.0 + 1e-9)


@needs_gcc
@pytest.mark.usefixtures("without_binaries")
def test_c_equals_python_is_clean_and_keeps_no_state_of_its_own(tmp_path: Path) -> None:
    plant, law = designed()
    places = tuple(each.q for each in wells_and_saddle(plant))
    names = {"prototype": "P*/1", "model": "hybrid", "origin": "0" * 64}
    at = (places[0], places[1], places[2])
    header, source = write_controller(tmp_path, law, (3e-3, 3e-3), at, **names).written[:2]
    library = tmp_path / "controller.so"
    subprocess.run([*GCC, str(source), "-o", str(library), "-lm"], check=True)
    text = source.read_text(encoding="utf-8")
    assert not any(word in text for word in ("alloc", "printf", "stdio", "stdlib"))
    kinds = [line.split()[-2] for line in nm(library) if not line.split()[-1].startswith(("_", "completed", "__"))]
    assert not set(kinds) & set("bBdDC")  # nothing that could be written to
    assert header.read_text(encoding="utf-8").count("debist_controller_") >= 4
    loaded = ctypes.CDLL(str(library))
    loaded.debist_controller_size.restype = ctypes.c_size_t
    loaded.debist_controller_period.restype = ctypes.c_double
    assert loaded.debist_controller_size() == 8 * CONTROLLER_STATE
    assert loaded.debist_controller_period() == PERIOD
    state, volts = np.zeros(CONTROLLER_STATE), np.zeros(2)
    loaded.debist_controller_init(ctypes.c_void_p(state.ctypes.data), ctypes.c_double(places[0]))
    running, rng = Running(law, places[0]), np.random.default_rng(3)
    target = np.repeat([places[2], places[0], places[1], np.nan, 0.5], 200)
    q, _ = closed_on_model(law, law, places[0], target)
    q += 2e-6 * rng.standard_normal(q.size)
    q[rng.integers(0, q.size, 30)] = np.nan
    q[700:760] = 1e300
    for reading, wanted in zip(q, target, strict=True):
        loaded.debist_controller_step(
            ctypes.c_void_p(state.ctypes.data), ctypes.c_double(reading), ctypes.c_double(wanted),
            ctypes.c_void_p(volts.ctypes.data),
        )  # fmt: skip
        np.testing.assert_allclose(volts, running.step(reading, wanted), rtol=0.0, atol=1e-9 * law.number("highest"))
    np.testing.assert_allclose(state, running.state, rtol=1e-6, atol=1e-9)
    told, commands = np.zeros(ESTIMATED), rng.choice([0.0, 2500.0, np.nan, 1e300, -5.0], (300, 2))
    for reading, v in zip(q[:300], commands, strict=True):
        loaded.debist_controller_observe(
            ctypes.c_void_p(state.ctypes.data), ctypes.c_double(reading), ctypes.c_void_p(v.ctypes.data)
        )
        observe(running.state, reading, v, law)
        loaded.debist_controller_estimate(ctypes.c_void_p(state.ctypes.data), ctypes.c_void_p(told.ctypes.data))
        np.testing.assert_allclose(told, estimate(running.state, law), rtol=1e-6, atol=1e-9)
    assert len(ESTIMATES) == ESTIMATED
    assert all(f"[{i}] {one.name} [{one.unit}]" in header.read_text("utf-8") for i, one in enumerate(ESTIMATES))


@needs_gcc
@pytest.mark.usefixtures("without_binaries")
@pytest.mark.long
def test_single_precision_controls_as_double_does(tmp_path: Path) -> None:
    """Snaps both ways and the unstable equilibrium, on the joint of the model; limits kept whatever is read."""
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    names = {"prototype": "P1", "model": "hybrid", "origin": "0" * 64}
    source = write_controller(tmp_path, law, (3e-3, 3e-3), (left, saddle, right), **names).written[1]
    library = tmp_path / "single.so"
    subprocess.run([*GCC, "-DDEBIST_CONTROLLER_SINGLE", str(source), "-o", str(library), "-lm"], check=True)
    loaded, highest = ctypes.CDLL(str(library)), law.number("highest")
    loaded.debist_controller_size.restype = ctypes.c_size_t
    assert loaded.debist_controller_size() == 4 * CONTROLLER_STATE
    state, volts = np.zeros(CONTROLLER_STATE, dtype=np.float32), np.zeros(2, dtype=np.float32)
    loaded.debist_controller_init(ctypes.c_void_p(state.ctypes.data), ctypes.c_float(left))

    def step(reading: float, wanted: float) -> FloatArray:
        loaded.debist_controller_step(
            ctypes.c_void_p(state.ctypes.data), ctypes.c_float(reading), ctypes.c_float(wanted),
            ctypes.c_void_p(volts.ctypes.data),
        )  # fmt: skip
        assert np.all((volts >= 0.0) & (volts <= np.float32(highest)))
        return volts.astype(np.float64)

    target = np.repeat([right, left, saddle, right], 1200)
    expected, _ = closed_on_model(law, law, left, target)
    truth, q = np.zeros(CONTROLLER_STATE), np.empty(target.size)
    begin_control(left, law, truth)
    for i, wanted in enumerate(target):
        q[i] = truth[0] + law.number("offset")
        move(truth, step(q[i], wanted), law)
    ends = np.arange(1, 5) * 1200 - 1
    assert np.abs(q[ends] - expected[ends]).max() < 5e-6
    assert np.sqrt(np.mean((q - expected) ** 2)) < 1e-3 * np.ptp(expected)
    for reading in (np.nan, 1e30, -np.inf, left):
        step(reading, right)


def nm(library: Path) -> list[str]:
    return subprocess.run(["nm", str(library)], check=True, capture_output=True, text=True).stdout.splitlines()


@pytest.mark.parametrize(
    ("off", "noise", "bounds"),
    [(-0.9e-3, 0.0, (1e-3, 1e-3)), (0.9e-3, 0.0, (1e-3, 1e-3)), (0.9e-3, 1e-6, (5e-3, 1e-2))],
)
def test_the_estimate_converges_on_the_true_motion(off: float, noise: float, bounds: tuple[float, float]) -> None:
    _, law = designed()
    left = wells_and_saddle(designed()[0])[0].q
    truth, s, v = np.zeros(CONTROLLER_STATE), np.zeros(CONTROLLER_STATE), np.zeros(2)
    begin_control(left, law, truth)
    begin_control(left + off, law, s)  # a millimetre off, slope and strains wrong with it
    rng, errors = np.random.default_rng(1), []
    right = wells_and_saddle(designed()[0])[2].q
    for i in range(1500):
        control(s, truth[0] + noise * rng.standard_normal(), right if 100 <= i < 700 else left, law, v)
        move(truth, v, law)
        errors.append((abs(s[1] - truth[1]), abs(s[2] - truth[2]), abs(s[PLACES["moment"]][0])))
    speed, slope, moment = np.array(errors[900:]).max(axis=0)
    assert speed < bounds[0]  # of up to 0.3 m/s
    assert slope < bounds[1]  # of up to 0.2
    assert moment < 1e-4  # N·m, of up to 16 mN·m
    p = np.zeros((FILTER, FILTER))
    p[np.tril_indices(FILTER)] = s[PLACES["spread"]]
    assert np.all(np.linalg.eigvalsh(p) > -1e-15)


@pytest.mark.parametrize("trust", [1.0, 1.02])
def test_the_estimator_alone_follows_a_joint_that_others_command(trust: float) -> None:
    """Open-loop pulses, which it is told two percent too large in the second case."""
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    truth, s = np.zeros(CONTROLLER_STATE), np.zeros(CONTROLLER_STATE)
    begin_control(left, law, truth)
    begin_control(left + 0.5e-3, law, s)
    rng, motion, errors = np.random.default_rng(4), [], []
    for i in range(3000):
        v = 2700.0 * np.array([1000 <= i % 2000 < 1300, i % 2000 < 300], dtype=np.float64)
        observe(s, truth[0] + law.number("offset") + 2e-6 * rng.standard_normal(), trust * v, law)
        move(truth, v, law)
        motion.append(estimate(truth, law)[:6])
        errors.append(np.abs(estimate(s, law)[:6] - motion[-1]))
    assert min(x[0] for x in motion) < 0.8 * left and max(x[0] for x in motion) > 0.8 * right
    size = np.abs(motion).max(axis=0)  # q, slope, interior shape, each with its rate
    assert np.all(np.max(errors[200:], axis=0) < np.array([1e-3, 0.05, 0.1, 0.4, 0.02, 0.4]) * size)
    assert np.all(
        np.sqrt(np.mean(np.square(errors[200:]), axis=0)) < np.array([3e-4, 0.015, 0.03, 0.1, 5e-3, 0.1]) * size
    )


@pytest.mark.parametrize("planted", [{}, {"left.b": 0.4}, {"log E": -0.1}])
def test_snaps_settle_and_the_unstable_equilibrium_is_held(planted: dict[str, float]) -> None:
    plant = plant_of(model(**planted))
    law = design(plant, Settings(3000.0, (3e-3, 3e-3)))
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    target = np.repeat([left, right, left, saddle], [50, 1000, 1000, 2000])
    q, _ = closed_on_model(law, law, left, target)
    steps = step_metrics(PERIOD * np.arange(q.size), q, target, right - left)[1:]
    assert all(step.settling_s is not None and step.settling_s < 0.25 for step in steps)
    assert max(step.overshoot_m for step in steps) < 1.5e-3
    assert max(step.rms_m for step in steps[:2]) < 0.2e-3
    assert steps[2].rms_m < 0.04e-3


@pytest.mark.parametrize("way", [0, 2])
def test_a_snap_is_as_fast_as_one_full_push_and_one_full_brake(way: int) -> None:
    plant, law = designed()
    wells = [each.q for each in wells_and_saddle(plant)]
    start, end = wells[way], wells[2 - way]
    full = np.array([3000.0, 0.0]) if end > start else np.array([0.0, 3000.0])
    fastest = np.inf
    for pushed in range(80, 140):
        joint, q = np.zeros(CONTROLLER_STATE), [start]
        begin_control(start, law, joint)
        while len(q) <= pushed or joint[1] * (end - start) > 0.0:
            move(joint, full if len(q) <= pushed else full[::-1].copy(), law)
            q.append(float(joint[0]))
        inside = np.abs(np.array(q) - end) < 0.05 * abs(end - start)
        if inside[-1]:
            fastest = min(fastest, PERIOD * float(np.argmax(inside)))
    target = np.full(1000, end)
    q_closed, _ = closed_on_model(law, law, start, target)
    settling = step_metrics(PERIOD * np.arange(q_closed.size), q_closed, target, abs(end - start))[0].settling_s
    assert settling is not None
    assert settling < 1.05 * fastest


@pytest.mark.parametrize(
    ("length", "mass"),
    [(0.4, 0.064), (2.5, 15.6), pytest.param(2.5, 400.0, marks=pytest.mark.long)],
    ids=["small", "large", "in units of another mass"],
)
def test_joints_of_other_sizes_snap_and_are_held(length: float, mass: float) -> None:
    time = float(np.sqrt(length))
    plant = plant_of(model(Similarity(length, time, 1.0, mass)))
    law = design(plant, Settings(3000.0, (3e-3, 3e-3)))
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    assert right - left == pytest.approx(length * 19.6e-3, rel=0.01)
    target = np.repeat([left, right, left, saddle], [50, 1500, 1500, 2000])
    q, _ = closed_on_model(law, law, left, target)
    steps = step_metrics(PERIOD * np.arange(q.size), q, target, right - left)[1:]
    assert all(step.settling_s is not None and step.settling_s < 0.25 * time for step in steps)
    assert max(step.overshoot_m for step in steps) < 0.1 * length * 10e-3
    moved = Moved(law, condensed_joint_law(plant, (4e-3, 4e-3)), left)
    moved.run(saddle, 2000)
    moved.truth[1] += 12e-3 * length / time
    rows = moved.run(saddle, 2000)
    assert np.abs(rows[-300:, 0] - saddle).max() < 0.05e-3 * length
    assert moved.status == "ok"


class Moved:
    """A controller on another joint of the model's class, and what disturbs both."""

    def __init__(self, law: Law, joint: Law, start: float) -> None:
        self.law, self.joint = law, joint
        self.truth, self.state, self.v = np.zeros(CONTROLLER_STATE), np.zeros(CONTROLLER_STATE), np.zeros(2)
        begin_control(start, joint, self.truth)
        begin_control(start, law, self.state)

    def run(self, target: float, periods: int, reading: float | None = None) -> FloatArray:
        """Displacements [m] and voltages [V] of some periods, shape (periods, 3)."""
        rows = np.empty((periods, 3))
        for row in rows:
            seen = self.truth[0] if reading is None else reading
            control(self.state, seen, target, self.law, self.v)
            row[:] = self.truth[0], *self.v
            move(self.truth, self.v, self.joint)
        return rows

    def push(self, moment: float) -> None:
        """Put a moment [N·m] on the slope from now on."""
        self.truth[PLACES["moment"]] = moment

    @property
    def status(self) -> str:
        return STATUS[round(estimate(self.state, self.law)[-1])]


SLIPPERY = {name: -20.0 for name in (name for name in NAMES if re.match("log (stop|layer|sliding) force", name))}


@pytest.mark.parametrize("lag", [1e-3, 3e-3, 8e-3])
@pytest.mark.parametrize("planted", [{}, SLIPPERY, SLIPPERY | {"offset": 1.0, "right.b": 0.5}, {"log E": -0.1}])
def test_the_unstable_equilibrium_is_held_under_bumps_and_loads_on_joints_and_lags_that_differ(
    planted: dict[str, float], lag: float
) -> None:
    plant, law = designed()
    _, saddle, _ = (each.q for each in wells_and_saddle(plant))
    other = plant_of(model(**planted))
    moved = Moved(law, condensed_joint_law(other, (lag, lag)), wells_and_saddle(other)[0].q)
    moved.run(saddle, 1500)
    moved.truth[1] += 12e-3  # of a bump of 0.5 mN·s
    moved.run(saddle, 700)
    moved.push(0.5e-3)
    rows = moved.run(saddle, 2000)
    assert np.abs(rows[-300:, 0] - saddle).max() < 0.05e-3
    assert moved.status == "ok"
    assert np.abs(np.diff(rows[-300:, 1:], axis=0)).max() < 5.0  # no limit cycle


def test_a_reading_that_stays_away_from_the_estimate_begins_it_anew_and_the_joint_comes_back() -> None:
    plant, law = designed()
    left, saddle, _ = (each.q for each in wells_and_saddle(plant))
    moved = Moved(law, law, left)
    moved.run(saddle, 1500)
    moved.truth[1] += 50e-3
    moved.run(saddle, 1000, reading=saddle)  # a frozen laser: the joint falls
    assert abs(moved.truth[0] - saddle) > 3e-3
    moved.run(saddle, 10)
    assert moved.status == "recovering"
    moved.run(saddle, 2000)
    assert moved.status == "ok"
    assert abs(moved.truth[0] - saddle) < 0.05e-3


def test_a_target_that_is_not_reached_is_given_up_until_the_next_one() -> None:
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    stuck = Moved(law, law, left)
    assert np.any(stuck.run(right, 9000, reading=left)[-1, 1:] > 0.0)
    assert not np.any(stuck.run(right, 2000, reading=left)[-1000:, 1:])
    assert stuck.status == "given up"
    assert np.any(stuck.run(0.9 * right, 100, reading=left)[:, 1:] > 0.0)
    stuck.run(right, 5, reading=np.nan)
    assert stuck.status == "lost signal"


def test_a_reading_far_from_the_estimate_moves_nothing_unless_it_lasts() -> None:
    plant, law = designed()
    left = wells_and_saddle(plant)[0].q
    moved = Moved(law, law, left)
    moved.run(left, 2000)
    before = moved.state[0]
    rows = moved.run(left, 10, reading=left + 5e-3)
    assert not np.any(rows[:, 1:])
    assert moved.state[0] == pytest.approx(before, abs=1e-6)


def test_a_barrier_that_is_higher_than_the_models_is_passed_by_swinging() -> None:
    plant, _ = designed()
    _, _, right = (each.q for each in wells_and_saddle(plant))
    law, other = design(plant, Settings(1800.0, (3e-3, 3e-3))), plant_of(model(**{"log E": -0.2}))
    softer, start = condensed_joint_law(other, (3e-3, 3e-3)), wells_and_saddle(other)[0].q
    assert law.number("pumped_right") == 0.0
    pushed = Moved(law, softer, start)
    for _ in range(3000):
        move(pushed.truth, np.array([1800.0, 0.0]), softer)
        assert pushed.truth[0] < 0.0
    moved = Moved(law, softer, start)
    moved.run(right, 4000)
    assert abs(moved.truth[0] - wells_and_saddle(other)[2].q) < 0.1e-3


@pytest.mark.parametrize("load", [-2e-3, 0.0, 2e-3])
@pytest.mark.parametrize("side", [0, 2])
def test_a_well_takes_no_voltage_at_rest_wherever_a_load_moves_it(side: int, load: float) -> None:
    plant, law = designed()
    well = wells_and_saddle(plant)[side].q
    moved = Moved(law, law, well)
    moved.push(load)
    rows = moved.run(well, 3000)
    assert not np.any(rows[-1000:, 1:])
    assert (abs(rows[-1, 0] - well) > 0.3e-3) == bool(load)
    assert moved.status == "ok"


@pytest.mark.parametrize("softer", [0.1, 0.4, 0.7])
def test_snaps_of_a_joint_whose_wells_lie_elsewhere_end_at_rest_in_its_own_wells_without_voltage(softer: float) -> None:
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    other = plant_of(model(**{"log E": -softer}))
    own_left, _, own_right = (each.q for each in wells_and_saddle(other))
    assert own_right - right > 5e-3 * softer
    moved = Moved(law, condensed_joint_law(other, (4e-3, 4e-3)), own_left)
    for target, own in ((right, own_right), (left, own_left), (right, own_right)):
        rows = moved.run(target, 2000)
        assert not np.any(rows[-400:, 1:])
        assert abs(rows[-1, 0] - own) < 0.2e-3


def test_a_target_beside_a_well_means_the_well_where_it_stands_and_is_followed_while_it_moves() -> None:
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    beside = 0.9 * BAND * (right - left)
    moved = Moved(law, law, left)
    for target in left + np.linspace(0.0, beside, 2000):
        row = moved.run(float(target), 1)[0]
    assert abs(row[0] - left - beside) < 0.3e-3
    assert row[1] > 100.0
    rest = moved.run(left + beside, 2000)[-1000:]
    assert not np.any(rest[:, 1:])
    assert np.abs(rest[:, 0] - left).max() < 0.2e-3
    held = moved.run(left + 1.5 * beside, 2000)[-500:]
    assert np.abs(held[:, 0] - left - 1.5 * beside).max() < 0.1e-3
    assert held[:, 1].min() > 100.0


def test_a_slow_ramp_from_well_to_well_is_followed() -> None:
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    other = plant_of(model(**SLIPPERY, **{"right.b": 0.3}))
    moved = Moved(law, condensed_joint_law(other, (4e-3, 4e-3)), wells_and_saddle(other)[0].q)
    ramp = np.linspace(left, right, 12000)
    errors = [moved.run(float(target), 1)[0, 0] - target for target in ramp]
    assert np.sqrt(np.mean(np.square(errors))) < 0.15e-3


def test_an_unstable_target_charges_both_sides_and_is_held_on_another_joint_and_a_well_charges_one() -> None:
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    other = plant_of(model(**{"offset": 1.0, "right.b": 0.5}))
    faster = acting_lags(other, Settings(3000.0, (1e-3, 1e-3)))
    truth, targets = condensed_joint_law(other, faster), np.repeat([left, right, saddle, saddle], 1000)
    q, v = closed_on_model(law, truth, wells_and_saddle(other)[0].q, targets)
    assert v[:2000].min(axis=1).max() == 0.0
    assert np.abs(q[-500:] - saddle).max() < 0.1e-3
    _, v = closed_on_model(law, law, left, np.repeat([left, saddle], [500, 2000]))
    assert v[-200:].min() > 500.0


def test_where_the_laser_has_its_zero_does_not_matter() -> None:
    plant, law = designed()
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    target = np.repeat([left, right, saddle], 800)
    place, zero = NUMBERS.index("offset"), 0.06
    moved = law._replace(numbers=law.numbers + zero * (np.arange(len(law.numbers)) == place))
    here, there = closed_on_model(law, law, left, target), closed_on_model(moved, moved, left + zero, target + zero)
    np.testing.assert_allclose(there[0] - zero, here[0], atol=1e-9)
    np.testing.assert_allclose(there[1], here[1], atol=1e-3)


def test_a_target_beyond_a_well_is_held_as_far_as_the_header_promises() -> None:
    plant, law = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    for well, end in ((left, law.places[0]), (right, law.places[-1])):
        target = well + 0.95 * (plant.reading(end) - well)
        q, v = closed_on_model(law, law, well, np.full(5000, target))
        assert np.abs(q[-1000:] - target).max() < 1e-4
        assert v[-1].max() > 100.0


def test_a_voltage_below_the_static_switching_voltage_still_switches_by_pumping() -> None:
    plant, _ = designed()
    left, _, right = (each.q for each in wells_and_saddle(plant))
    low = static_switching_voltage()
    law = design(plant, Settings(0.85 * low, (3e-3, 3e-3)))
    assert law.number("pumped_right") == law.number("pumped_left") == 1.0
    q, v = closed_on_model(law, law, left, np.full(6000, right))
    assert abs(q[-1] - right) < 1e-3
    assert v.max() <= 0.85 * low


def static_switching_voltage() -> float:
    """Lowest constant voltage [V] under which no equilibrium is left in the left well, to 1 %."""
    from pipeline.control.plant import equilibria

    plant, _ = designed()
    low, high = 500.0, 3000.0
    while high / low > 1.01:
        middle = 0.5 * (low + high)
        stays = any(each.q < 0.0 and each.stable for each in equilibria(plant, np.array([middle, 0.0])))
        low, high = (middle, high) if stays else (low, middle)
    return high


def test_a_design_comes_back_from_its_numbers_and_damage_is_named() -> None:
    _, law = designed()
    document = json.loads(json.dumps(law.to_json()))
    for one, other in zip(Law.from_json(document), law, strict=True):
        np.testing.assert_array_equal(one, other)
    for numbers in (document["numbers"] | {"gain": 1.0}, dict(list(document["numbers"].items())[1:])):
        with pytest.raises(CorruptArtifactError, match=r"another version.*debist control design"):
            Law.from_json(document | {"numbers": numbers})


def test_what_cannot_be_designed_is_told() -> None:
    plant = plant_of(model())
    with pytest.raises(InputError, match="trained range"):
        design(plant, Settings(4000.0))
    for highest in (1e-6, 1.0):  # well below and near to where Riccati's equation has no solution in double precision
        with pytest.raises(InputError, match="does not move the joint"):
            design(plant, Settings(highest))
    with pytest.raises(InputError, match="not two wells"):
        design(plant_of(model(**{"log E": 6.0})), Settings(3000.0))
