"""A controller against a virtual joint: what it is told, what it may do, what it cannot break."""

import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from cli import app
from pipeline.numerics.linear_filters import first_order_lag
from pipeline.rig.bench import Bench
from pipeline.rig.joint import potential, rest, saddle, simulate, tip_displacement, wells
from pipeline.rig.loop import Scenario, bench_from_json, played, run_loop
from pipeline.rig.parameters import as_json, from_json, nominal
from pipeline.rig.random_joint import random_joint
from pipeline.rig_logs import read_recording
from pipeline.workflow.studies.closed_loop import ScenarioFile, virtual_joint

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
    run = run_loop(nominal(), Bench(), scenario, made)
    assert len(heard) == 401
    np.testing.assert_array_equal([q for q, _ in heard[1:]], run.q[::2])
    np.testing.assert_array_equal([target for _, target in heard[1:]], run.target[::2])
    assert heard[0][0] == heard[1][0]
    assert np.isnan(run.q).sum() == 100
    assert set(run.command1) == {0.0}
    assert set(run.command2) == {120.0, 2000.0}
    assert (run.commands_not_finite, run.commands_clipped) == (200, 400)


def test_a_hand_a_shaking_table_and_a_wire_act() -> None:
    idle = played(np.zeros(1), np.zeros((1, 2)))
    scenario = replace(STILL, hands=((0.05, 20e-3, 0.3),))
    hand, dragged = (run_loop(nominal(), Bench(), replace(scenario, drag=drag), idle).true_q for drag in (0.0, 5e-3))
    assert np.ptp(hand[:100]) < 1e-6
    assert 0.2 * np.ptp(hand) < np.ptp(dragged) < 0.9 * np.ptp(hand)
    shaken = run_loop(nominal(), Bench(), replace(STILL, shakes=((0.1, 5e-3, 20.0, 0.2),)), idle).true_q
    pushed = run_loop(nominal(), Bench(), replace(STILL, hands=((0.1, 5e-3, 0.025),)), idle).true_q
    np.testing.assert_allclose(shaken[:240], pushed[:240], atol=1e-7)
    assert np.ptp(shaken[250:]) > 5e-6


@pytest.mark.parametrize(
    ("family", "seed"),
    [("same", 3), pytest.param("foreign", 5, marks=pytest.mark.long)],  # from a second start
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


@pytest.fixture
def still(tmp_path: Path) -> Path:
    """Voltages that do nothing, to play."""
    (tmp_path / "still.csv").write_text("time [s],v1 [V],v2 [V]\n0,0,0\n1,0,0\n", encoding="utf-8")
    return tmp_path / "still.csv"


def test_the_command_writes_a_log_that_can_be_read_with_the_reference_in_it(tmp_path: Path) -> None:
    csv = tmp_path / "pulse.csv"
    csv.write_text("time [s],v1 [V],v2 [V]\n0,0,0\n0.1,2900,0\n0.25,0,0\n0.3,0,0\n", encoding="utf-8")
    arguments = ["rig", "closed-loop", "nominal", "--play", str(csv), "--duration", "0.5s", "--target", "0.1s:right"]
    done = CliRunner().invoke(app, [*arguments, "-o", str(tmp_path / "run"), "--json"])
    assert done.exit_code == 0, done.output
    told = json.loads(done.stdout)
    log = read_recording(Path(told["files"][0]), channels=["Laser_q", "target", "HV1_meas"])
    assert log.channel("target").samples[[0, -1]] == pytest.approx([-11.19, 11.19], abs=0.02)
    assert 2.8 < log.channel("HV1_meas").samples.max() < 3.0
    assert [step["t_s"] for step in told["steps"]] == [0.0, pytest.approx(0.1)]
    assert Path(told["files"][1]).read_text(encoding="utf-8").count("run.mat") == 1


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
        ("lag_s = -1e-3", "lag_s: input should be greater than 0"),
        ("[[lost]]\nstart_s = -1.0\nlength_s = 0.1", "start_s"),
        ("[[pushes]]\nstart_s = 7.0\nforce_N = 0.05\nlength_s = 0.02", "the run is over; raise --duration"),
    ],
)
def test_a_scenario_that_cannot_be_is_one_line(tmp_path: Path, still: Path, scenario: str, said: str) -> None:
    printed = _loop(tmp_path, still, scenario)
    assert said in printed and printed.count("\n") == 1


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
