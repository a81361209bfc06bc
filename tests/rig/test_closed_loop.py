"""A controller against a virtual joint: what it is told, what it may do, what it cannot break."""

import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.errors import InputError
from pipeline.numerics.linear_filters import first_order_lag
from pipeline.rig.bench import Bench
from pipeline.rig.joint import potential, rest, saddle, simulate, tip_displacement, wells
from pipeline.rig.loop import Scenario, bench_from_json, played, python_controller, run_loop
from pipeline.rig.parameters import as_json, from_json, nominal
from pipeline.rig.random_joint import random_joint
from pipeline.rig_logs import read_recording
from pipeline.tools.closed_loop import ScenarioFile, virtual_joint

STILL = Scenario(np.zeros(1), np.zeros(1), 0.4)


@pytest.mark.parametrize("charging", [0.0, 8e-3])
def test_the_loop_moves_a_joint_as_the_simulation_of_logs_does(charging: float) -> None:
    p = nominal()
    t = np.arange(1000) * 1e-3
    u = np.zeros((t.size, 2))
    u[100:400, 0] = 2900.0
    bench = Bench(rate=20_000.0, charging=charging)
    run = run_loop(p, bench_from_json(asdict(bench)), replace(STILL, duration=1.0), played(t, u))
    fine = np.repeat(u, 20, axis=0)
    v = np.stack([bench.converters[side].drive(fine[:, side], 5e-5) for side in (0, 1)], axis=1)
    if charging:
        v = np.column_stack([first_order_lag(np.ascontiguousarray(side), 5e-5, charging)[0] for side in v.T])
    assert np.abs(simulate(p, v, 5e-5, stride=10).q[::10] - run.true_q).max() < 15e-6


def test_a_controller_is_told_readings_and_targets_once_a_period_and_its_answer_is_limited() -> None:
    heard: list[tuple[float, float]] = []

    def made(first: float):  # type: ignore[no-untyped-def]
        heard.append((first, np.nan))

        def step(q: float, target: float) -> tuple[float, float]:
            heard.append((q, target))
            return (-50.0, 1e9) if len(heard) % 2 else (np.nan, 120.0)

        return step

    scenario = Scenario(np.array([0.0, 0.2]), np.array([1e-3, 2e-3]), 0.4, highest=2000.0, lost=((0.3, 0.05),))
    run = run_loop(nominal(), Bench(), scenario, python_controller(made))
    assert len(heard) == 401
    np.testing.assert_array_equal([q for q, _ in heard[1:]], run.q[::2])
    np.testing.assert_array_equal([target for _, target in heard[1:]], run.target[::2])
    assert heard[0][0] == heard[1][0]
    assert np.isnan(run.q).sum() == 100
    assert set(run.command1) == {0.0}
    assert set(run.command2) == {120.0, 2000.0}
    assert (run.commands_not_finite, run.commands_clipped) == (200, 400)


def test_pushes_drifts_and_factors_act() -> None:
    idle = python_controller(lambda _q: lambda _q, _target: (0.0, 0.0))
    calm = run_loop(nominal(), Bench(), STILL, idle).true_q
    assert np.ptp(calm) < 1e-6
    pushed = run_loop(nominal(), Bench(), replace(STILL, pushes=((0.1, 20e-3, 0.05),)), idle).true_q
    assert pushed[200] == pytest.approx(calm[200], abs=1e-6)
    assert pushed[320] > calm[320] + 0.3e-3
    higher = run_loop(nominal(), Bench(), replace(STILL, barrier=0.5, duration=2.0), idle).true_q
    assert higher[-1] < calm[-1] - 0.3e-3  # a higher barrier has its wells farther apart
    heavier = run_loop(nominal(), Bench(), replace(STILL, mass=1.05), idle).true_q
    assert heavier[0] < calm[0] - 0.05e-3


def test_a_hand_a_shaking_table_and_a_wire_act() -> None:
    idle = python_controller(lambda _q: lambda _q, _target: (0.0, 0.0))
    scenario = replace(STILL, hands=((0.05, 20e-3, 0.3),))
    hand, dragged = (run_loop(nominal(), Bench(), replace(scenario, drag=drag), idle).true_q for drag in (0.0, 5e-3))
    assert np.ptp(hand[:100]) < 1e-6
    assert 0.2 * np.ptp(hand) < np.ptp(dragged) < 0.9 * np.ptp(hand)
    shaken = run_loop(nominal(), Bench(), replace(STILL, shakes=((0.1, 5e-3, 20.0, 0.2),)), idle).true_q
    pushed = run_loop(nominal(), Bench(), replace(STILL, hands=((0.1, 5e-3, 0.025),)), idle).true_q
    np.testing.assert_allclose(shaken[:240], pushed[:240], atol=1e-7)
    assert np.ptp(shaken[250:]) > 5e-6


def test_without_friction_a_joint_rings_longer_and_a_frozen_laser_gives_its_last_value() -> None:
    idle = python_controller(lambda _q: lambda _q, _target: (0.0, 0.0))
    p = nominal()._replace(slip_force=np.array([2e-3]), slip_stiffness=np.array([20.0]))
    knocked = replace(STILL, pushes=((0.0, 0.1, 0.02),), duration=2.0, frozen=((0.1, 0.05),))
    runs = [run_loop(p, Bench(), replace(knocked, friction=factor), idle) for factor in (1.0, 0.1)]
    assert np.ptp(runs[1].true_q[-400:]) > 1.5 * np.ptp(runs[0].true_q[-400:])
    assert np.ptp(runs[0].q[199:300]) == 0.0 < np.ptp(runs[0].q[300:400])


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        ("same", 3),
        pytest.param("foreign", 7, marks=pytest.mark.long),
        pytest.param("foreign", 5, marks=pytest.mark.long),
    ],  # from a second start
)
def test_a_saddle_is_an_equilibrium_between_the_wells_and_the_truth_comes_back_from_json(
    family: str, seed: int
) -> None:
    p = random_joint(np.random.default_rng(seed), family)  # type: ignore[arg-type]
    x, none = saddle(p), np.zeros(2)
    left, right = wells(p)
    assert left < tip_displacement(p, x) < right
    heights = potential(p, x, none) - np.array([potential(p, rest(p, side=side), none) for side in (-1, 1)])
    assert heights.min() > 0.2 * heights.mean()
    assert as_json(from_json(json.loads(json.dumps(as_json(p))))) == as_json(p)


def test_the_truth_of_an_earlier_version_is_read_and_one_that_lacks_a_number_is_not() -> None:
    written = as_json(nominal())
    later = ("plastic_share", "plastic_yield", "softening", "softening_time")
    assert as_json(from_json({key: x for key, x in written.items() if key not in later})) == written
    with pytest.raises(KeyError, match="mass"):
        from_json({key: x for key, x in written.items() if key != "mass"})


def test_the_failure_of_a_controller_in_python_is_told() -> None:
    with pytest.raises(InputError, match="the controller failed: ZeroDivisionError"):
        run_loop(nominal(), Bench(), STILL, python_controller(lambda _q: lambda _q, _target: (1 / 0, 0.0)))


@pytest.fixture
def still(tmp_path: Path) -> Path:
    """Voltages that do nothing, to play."""
    (tmp_path / "still.csv").write_text("time [s],v1 [V],v2 [V]\n0,0,0\n1,0,0\n", encoding="utf-8")
    return tmp_path / "still.csv"


def test_the_command_writes_a_log_that_can_be_read_with_the_reference_in_it(tmp_path: Path) -> None:
    csv = tmp_path / "pulse.csv"
    csv.write_text("time [s],v1 [V],v2 [V]\n0,0,0\n0.1,2900,0\n0.25,0,0\n0.3,0,0\n", encoding="utf-8")
    arguments = ["rig", "closed-loop", "nominal", "--play", str(csv), "--duration", "1s", "--target", "0.1s:right"]
    done = CliRunner().invoke(app, [*arguments, "-o", str(tmp_path / "run"), "--json"])
    assert done.exit_code == 0, done.output
    told = json.loads(done.stdout)
    log = read_recording(Path(told["files"][0]), channels=["Laser_q", "target", "HV1_meas"])
    assert log.channel("target").samples[[0, -1]] == pytest.approx([-11.19, 11.19], abs=0.02)
    assert 2.8 < log.channel("HV1_meas").samples.max() < 3.0
    assert [step["t_s"] for step in told["steps"]] == [0.0, pytest.approx(0.1)]
    assert Path(told["files"][1]).read_text(encoding="utf-8").count("run.mat") == 1


def test_errors_of_a_moving_reference_and_of_steps_that_do_not_settle_are_printed(tmp_path: Path, still: Path) -> None:
    t = np.arange(0.0, 1.0, 0.01)
    rows = [f"{at},{1e-3 * np.sin(6.0 * at)}" for at in t]
    (tmp_path / "sine.csv").write_text("\n".join(["time [s],target [m]", *rows]))
    loop = ["rig", "closed-loop", "nominal", "--play", str(still), "--duration", "1s"]
    moving = CliRunner().invoke(app, [*loop, "--target", str(tmp_path / "sine.csv"), "-o", str(tmp_path / "a")])
    steps = CliRunner().invoke(app, [*loop, "--target", "0.1s:right", "-o", str(tmp_path / "b")])
    assert "moving reference: RMS error 11." in moving.output, moving.output  # the joint stays in its well
    assert "did not settle, then RMS" in steps.output, steps.output


def _loop(folder: Path, still: Path, scenario: str, *options: str, joint: str = "nominal") -> str:
    """What a loop that cannot be run prints on stderr."""
    (folder / "scenario.toml").write_text(scenario, encoding="utf-8")
    arguments = ["rig", "closed-loop", joint, "--scenario", str(folder / "scenario.toml"), "-o", str(folder / "out")]
    done = CliRunner().invoke(app, [*arguments, "--play", str(still), *options])
    assert done.exit_code == 2 and not (folder / "out.mat").exists()
    return done.stderr


@pytest.mark.parametrize(
    ("scenario", "said"),
    [
        ("pushs = []", "unknown key 'pushs'; did you mean 'pushes'"),
        ("[[pushes]]\nstart_s = 1.0\nforce_N = 2.0\nlength = 1.0", "did you mean 'length_s'"),
        ('format = "xls"', "format"),
        ("lag_s = -1e-3", "lag_s: input should be greater than 0"),
        ("highest_V = 0.0", "highest_V: input should be greater than 0"),
        ("[[lost]]\nstart_s = -1.0\nlength_s = 0.1", "start_s"),
        ("barrier_percent = nan", "barrier_percent"),
        ("[[pushes]]\nstart_s = 7.0\nforce_N = 0.05\nlength_s = 0.02", "the run is over; raise --duration"),
        ("[[lost]]\nstart_s = 5.0\nlength_s = 0.05", "the run is over; raise --duration"),
    ],
)
def test_a_scenario_that_cannot_be_is_one_line(tmp_path: Path, still: Path, scenario: str, said: str) -> None:
    printed = _loop(tmp_path, still, scenario)
    assert said in printed and printed.count("\n") == 1


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--target", "3"], "no unit"),
        (["--controller", "missing"], "either --controller or --play"),
        (["--target", "0s:left,1s:60mm"], "make sense"),
        (["--target", "0s:left,5s:right"], "the run is over; raise --duration"),
    ],
)
def test_bad_options_are_one_line(tmp_path: Path, still: Path, options: list[str], said: str) -> None:
    assert said in _loop(tmp_path, still, "", *options)


@pytest.mark.parametrize("joint", ["nowhere", "foreign3"])
def test_a_mistyped_joint_is_refused(joint: str, tmp_path: Path, still: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also in a folder that holds a joint of its own, which is not the one that was named."""
    (tmp_path / "truth").mkdir()
    (tmp_path / "truth" / "truth.json").write_text("{}", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert "no joint of the virtual rig" in _loop(tmp_path, still, "", joint=joint)


def test_a_scenario_is_what_its_file_states() -> None:
    joint = virtual_joint("nominal")
    stated = {
        "start": "right", "lag_s": 2e-3, "drag_N": 1e-3, "barrier_percent": 20.0,
        "hands": [{"start_s": 1.0, "force_N": 0.01, "length_s": 0.5}],
        "shakes": [{"start_s": 2.0, "force_N": 5e-3, "frequency_Hz": 10.0, "length_s": 1.0}],
        "frozen": [{"start_s": 3.0, "length_s": 0.2}],
    }  # fmt: skip
    scenario = ScenarioFile.model_validate(stated).scenario(joint, "0s:left,0.5s:right", 5.0)
    assert (scenario.side, scenario.lag, scenario.drag, scenario.barrier) == (1, 2e-3, 1e-3, pytest.approx(0.2))
    assert scenario.hands == ((1.0, 0.01, 0.5),) and scenario.shakes == ((2.0, 5e-3, 10.0, 1.0),)
    assert scenario.frozen == ((3.0, 0.2),)
    assert ScenarioFile().scenario(joint, "0s:left,0.5s:right", 5.0).side == -1
