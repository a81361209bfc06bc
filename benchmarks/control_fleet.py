"""Control of joints that are drawn now: what `debist control` reaches on the virtual rig, beside plain pulses.

`python benchmarks/control_fleet.py [COUNT] [--seed SEED]`: COUNT joints, half of the analytical model's physics and
half foreign, each identified from one log of 37.5 s with default settings. Controller and snaps are designed on
the identified model, then run against the joint itself, with its own converters and laser. Printed are a line for each
joint and the table; misses are in it. About 50 s of processor time a joint.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pipeline.control.controller import begin_control, control
from pipeline.control.design import Settings, three
from pipeline.control.design import design as design_law
from pipeline.control.ensemble import Ensemble, ensemble_of
from pipeline.control.law import CONTROLLER_STATE, Law
from pipeline.control.plant import plant_of
from pipeline.control.pulses import design_pulse
from pipeline.control.step_metrics import one_step
from pipeline.control.switching_map import pulses
from pipeline.errors import InputError
from pipeline.export.controller import ControllerSubject, write_controller
from pipeline.joint import condensed_parameters
from pipeline.joint.condensed_problem import DEVIATIONS
from pipeline.joint.parameters import NOMINAL
from pipeline.models.hybrid import HybridModel
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.bench import Bench
from pipeline.rig.controllers import Controller, c_controller, played, python_controller
from pipeline.rig.fleet import Experiment, write_prototype
from pipeline.rig.joint import rest, wells
from pipeline.rig.loop import ClosedLoop, Scenario, run_loop
from pipeline.rig.parameters import JointParameters
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import parse_prototype
from pipeline.tools.closed_loop import virtual_joint
from pipeline.tools.export import load_run_model

SNAPS = 50
WATCHED = 1.2  # s after a command
TOP = 3000.0  # V
LAG = 3e-3  # s, what a controller assumes of the converters
SHARES = (1.0, 0.9, 0.8, 0.75, 0.7, 0.65, 0.6, 0.5)


@dataclass
class Found:
    """What was measured of one joint."""

    name: str
    kind: str
    lines: dict[str, list[float]] = field(default_factory=dict)


@dataclass(frozen=True)
class Subject:
    """A joint, its bench, its rests, and the model that was identified."""

    p: JointParameters
    bench: Bench
    model: HybridModel
    starts: dict[int, FloatArray]
    places: tuple[float, float]

    def run(self, scenario: Scenario, controller: Controller) -> ClosedLoop:
        start = self.starts[scenario.side] if scenario.mass == scenario.gain == 1.0 else None
        return run_loop(self.p, self.bench, scenario, controller, start)


def of_law(law: Law) -> Controller:
    """The Python twin in the loop."""
    s, v = np.zeros(CONTROLLER_STATE), np.zeros(2)

    def made(q: float):
        begin_control(q, law, s)

        def step(q: float, target: float) -> tuple[float, float]:
            control(s, q, target, law, v)
            return float(v[0]), float(v[1])

        return step

    return python_controller(made)


def identified(folder: Path, kind: str, seed: int) -> Subject:
    prototype = write_prototype(folder, "joint", Experiment(kind, "parquet", 10_000.0, validation_logs=0), seed=seed)
    run, debist = folder / "run", [str(Path(sys.executable).with_name("debist"))]
    for command in (["ingest", str(prototype), "-o", str(run)], ["differentiate", str(run)], ["identify", str(run)]):
        subprocess.run([*debist, *command, "-q"], check=True, capture_output=True)
    opened = RunFolder.open(run)
    model = load_run_model(opened, parse_prototype(opened.manifest.prototype, "run"), "hybrid")
    assert isinstance(model, HybridModel)
    joint = virtual_joint(str(folder))
    starts = {side: rest(joint.parameters, side=side) for side in (-1, 1)}
    return Subject(joint.parameters, joint.bench, model, starts, wells(joint.parameters))


def drawing() -> HybridModel:
    """The analytical model with nominal parameters, nothing identified."""
    body_ratio = condensed_parameters.static_slope_ratio(NOMINAL)
    from pipeline.joint.condensed_problem import Body

    body = Body(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, TOP, body_ratio)
    theta = np.concatenate([condensed_parameters.drawing_alone(), body.start()[DEVIATIONS:]])
    return HybridModel(body, theta, np.zeros((len(theta), 1)))


def sequence(count: int, seed: int) -> FloatArray:
    """Times [s] of commands, with rests of different lengths between."""
    return 0.5 + np.concatenate([[0.0], np.cumsum(np.random.default_rng(seed).uniform(1.6, 3.5, count - 1))])


def judged(run: ClosedLoop, times: FloatArray, places: tuple[float, float]) -> FloatArray:
    """Settled in the right well (0, 1), settling time [s], overshoot [m] of every snap, shape (n, 3)."""
    rows = []
    for i, begin in enumerate(times):
        target = places[1 - i % 2]
        part = (run.t >= begin) & (run.t < begin + WATCHED)
        step = one_step(run.t[part], run.true_q[part], target, places[1] - places[0])
        rows.append((float(step.settling_s is not None), step.settling_s or np.inf, step.overshoot_m))
    return np.array(rows)


def played_snaps(subject: Subject, shapes: list[FloatArray], seed: int) -> FloatArray:
    """Feedforward: the pulse to the right, to the left in turn."""
    times = sequence(SNAPS, seed)
    u = np.zeros((round((times[-1] + WATCHED) * 1e3) + 1, 2))
    for i, begin in enumerate(times):
        at, shape = round(begin * 1e3), shapes[i % 2]
        u[at : at + len(shape)] = shape[: len(u) - at]
    t = np.arange(len(u)) * 1e-3
    scenario = Scenario(np.zeros(1), np.zeros(1), float(t[-1]), seed=seed)
    return judged(subject.run(scenario, played(t, u)), np.round(times, 3), subject.places)


def commanded_snaps(subject: Subject, law: Law, targets: tuple[float, float], seed: int, count: int, **other: float):
    times = np.round(sequence(count, seed), 3)
    told = np.array([targets[0], *(targets[1 - i % 2] for i in range(count))])
    t = np.concatenate([[0.0], times])
    scenario = Scenario(t, told, float(times[-1] + WATCHED), seed=seed, **other)  # type: ignore[arg-type]
    return judged(subject.run(scenario, of_law(law)), times, subject.places)


def plain(side: int, length: float) -> FloatArray:
    u = np.zeros((round(length * 1e3) + 1, 2))
    u[:-1, side] = TOP
    return u


def static_voltage(subject: Subject, side: int) -> float:
    """Voltage [V] at which a slow ramp carries the joint over."""
    t = np.arange(6000) * 1e-3
    u = np.zeros((6000, 2))
    u[:, side] = TOP * t / t[-1]
    run = subject.run(Scenario(np.zeros(1), np.zeros(1), 6.0, side=-1 if side == 0 else 1), played(t, u))
    over = run.true_q > 0.5 * subject.places[1] if side == 0 else run.true_q < 0.5 * subject.places[0]
    return float(u[min(int(np.argmax(over)) // 2, 5999), side]) if over.any() else np.nan


def lowest_share(subject: Subject, targets: tuple[float, float], side: int) -> float:
    """Least share of the static switching voltage with which feedback still switches within 6 s."""
    static, least = static_voltage(subject, side), np.inf
    for share in SHARES:
        law = design_law(plant_of(subject.model), Settings(min(share * static, TOP), LAG))
        told = np.array([targets[1 - side]])
        start = -1 if side == 0 else 1
        run = subject.run(Scenario(np.zeros(1), told, 6.0, side=start), of_law(law))
        if abs(run.true_q[-1] - subject.places[1 - side]) > 0.1 * (subject.places[1] - subject.places[0]):
            break
        least = share
    return least


def impulses(subject: Subject, controller: Controller, targets: tuple[float, float]) -> list[float]:
    """Whether impulses of 1.1 and 1.5 times the one that switches the joint alone are caught, in both wells."""
    caught = []
    idle = np.zeros((1500, 2))
    t = np.arange(1500) * 1e-3
    for well, side in ((0, -1), (1, 1)):
        low, high = 0.02, 3.0
        while high / low > 1.05:
            force = float(np.sqrt(low * high))
            scenario = Scenario(np.zeros(1), np.zeros(1), 1.5, side=side, pushes=((0.2, -side * force, 0.02),))
            try:
                switched = side * subject.run(scenario, played(t, idle)).true_q[-1] < 0.0
            except InputError:
                switched = True
            low, high = (low, force) if switched else (force, high)
        for factor in (1.1, 1.5):
            push = ((0.2, -side * factor * high, 0.02),)
            run = subject.run(Scenario(np.zeros(1), np.array([targets[well]]), 2.5, side=side, pushes=push), controller)
            caught.append(float(side * run.true_q[-1] > 0.5 * abs(subject.places[well])))
    return caught


def brier(subject: Subject, joint: Ensemble, targets: tuple[float, float], saddle: float, seed: int) -> list[float]:
    """(p − outcome)² of random plain pulses."""
    rng, scores = np.random.default_rng(seed), []
    for side, start in ((0, targets[0]), (1, targets[1])):
        volts, lengths = rng.uniform(0.4, 1.0, 16) * TOP, np.exp(rng.uniform(np.log(0.03), np.log(0.6), 16))
        shapes = pulses(volts, np.round(lengths, 3), side)
        switched = (joint.run(shapes, start)[:, :, -1] > saddle) == (side == 0)
        for shape, chance in zip(shapes, switched.mean(axis=1), strict=True):
            t = np.arange(len(shape)) * 1e-3
            scenario = Scenario(np.zeros(1), np.zeros(1), float(t[-1]), side=-1 if side == 0 else 1)
            end = subject.run(scenario, played(t, shape)).true_q[-1]
            scores.append(float((chance - ((end > 0.0) == (side == 0))) ** 2))
    return scores


def step_seconds(law: Law, places: tuple[float, float, float]) -> float:
    """Processor time [s] of a step in C, its call from Python included."""
    import ctypes

    with tempfile.TemporaryDirectory() as name:
        subject = ControllerSubject("fleet", "hybrid", "0" * 12, law, LAG, places)
        loaded = c_controller(write_controller(subject, Path(name)).written[1])
    call = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p)(loaded.step)
    loaded.begin(places[0])
    v, began = np.zeros(2), time.process_time()
    for i in range(20_000):
        call(loaded.memory, places[0] + 1e-6 * (i % 7), places[2], v.ctypes.data)
    return (time.process_time() - began) / 20_000


def measure(subject: Subject, found: Found, seed: int) -> None:
    plant = plant_of(subject.model)
    left, saddle, right = (each.q for each in three(plant))
    targets, top = (left, right), min(TOP, plant.highest)
    law = design_law(plant, Settings(top, LAG))
    joint, blank = ensemble_of(subject.model, 32, LAG), ensemble_of(drawing(), 0, LAG)
    b_left, _, b_right = (each.q for each in three(plant_of(drawing())))
    ways = ((left, right), (right, left))
    found.lines["feedforward"] = _rows(
        played_snaps(subject, [design_pulse(joint, a, b, right - left, top).v for a, b in ways], seed)
    )
    nominal = [design_pulse(blank, a, b, b_right - b_left, TOP).v for a, b in ((b_left, b_right), (b_right, b_left))]
    found.lines["pulse, nominal parameters"] = _rows(played_snaps(subject, nominal, seed))
    for length in (0.3, 0.5):
        found.lines[f"plain 3 kV, {length} s"] = _rows(
            played_snaps(subject, [plain(0, length), plain(1, length)], seed)
        )
    found.lines["feedback"] = _rows(commanded_snaps(subject, law, targets, seed, SNAPS))
    changes = ({"mass": 1.05}, {"mass": 0.95}, {"gain": 1.02}, {"gain": 0.98}, {"noise": 5.0})
    robust = [commanded_snaps(subject, law, targets, seed, 10, **change)[:, 0] for change in changes]
    found.lines["robust"] = list(np.concatenate(robust))
    found.lines["hold"] = []
    for lag in (1e-3, 3e-3):
        told = np.array([left, saddle])
        run = subject.run(Scenario(np.array([0.0, 0.2]), told, 60.0, lag=lag, seed=seed), of_law(law))
        late = run.t > 2.0
        found.lines["hold"].append(float(np.sqrt(np.mean((run.true_q[late] - saddle) ** 2))))
    found.lines["share"] = [lowest_share(subject, targets, side) for side in (0, 1)]
    found.lines["caught"] = impulses(subject, of_law(law), targets)
    found.lines["brier"] = brier(subject, joint, targets, saddle, seed)
    found.lines["step"] = [step_seconds(law, (left, saddle, right))]


def _rows(values: FloatArray) -> list[float]:
    return [float(x) for x in values.ravel()]


def told(found: list[Found]) -> None:
    def snaps(name: str) -> str:
        rows = np.concatenate([np.array(each.lines[name]).reshape(-1, 3) for each in found])
        good = rows[rows[:, 0] > 0.5]
        middle = (np.median(rows[:, 1]), 1e3 * np.median(rows[:, 2])) if len(good) else (np.inf, np.nan)
        return f"{100 * rows[:, 0].mean():9.1f}{middle[0]:12.3f}{middle[1]:14.2f}"

    print(f"\n{'':28s}{'snaps %':>9s}{'settling s':>12s}{'overshoot mm':>14s}   (medians)")
    for name in ("feedback", "feedforward", "pulse, nominal parameters", "plain 3 kV, 0.3 s", "plain 3 kV, 0.5 s"):
        print(f"{name:28s}{snaps(name)}")

    def whole(name: str) -> FloatArray:
        return np.concatenate([each.lines[name] for each in found])

    held = np.array([max(each.lines["hold"]) for each in found])
    print(f"unstable equilibrium, 60 s, lag 1 and 3 ms: RMS at most 0.3 mm on {np.sum(held <= 0.3e-3)} of {len(found)}")
    shares = whole("share")
    print(
        f"lowest voltage over the static one: median {100 * np.median(shares):.0f} %, worst {100 * shares.max():.0f} %"
    )
    print(f"impulses caught: {100 * whole('caught').mean():.1f} % of {len(whole('caught'))}")
    print(f"Brier score of the switching probability: {whole('brier').mean():.4f} over {len(whole('brier'))} pulses")
    print(f"robustness: {100 * whole('robust').mean():.1f} % of {len(whole('robust'))} snaps")
    print(f"one step in C: {1e6 * whole('step').max():.1f} µs at most")


def line(each: Found) -> str:
    parts = []
    for name in ("feedback", "feedforward", "plain 3 kV, 0.5 s"):
        rows = np.array(each.lines[name]).reshape(-1, 3)
        parts.append(f"{name} {100 * rows[:, 0].mean():.0f} % {np.median(rows[:, 1]):.3f} s")
    held = "/".join(f"{1e3 * x:.2f}" for x in each.lines["hold"])
    shares = "/".join(f"{x:.2f}" for x in each.lines["share"])
    caught, score = np.mean(each.lines["caught"]), np.mean(each.lines["brier"])
    robust = np.mean(each.lines["robust"])
    return (
        f"{each.name}: "
        + ", ".join(parts)
        + (f", held {held} mm, voltage {shares}, caught {caught:.2f}, Brier {score:.3f}, robust {robust:.2f}")
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("count", type=int, nargs="?", default=2)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--first", type=int, default=0, help="number of the first joint of the seed's fleet")
    given = parser.parse_args()
    print(f"seed {given.seed}", flush=True)
    found = []
    for i in range(given.first, given.first + given.count):
        kind = ("same", "foreign")[i % 2]
        each, seed = Found(f"{kind}-{i:02d}", kind), int(np.random.SeedSequence([given.seed, i]).generate_state(1)[0])
        with tempfile.TemporaryDirectory() as folder:
            began = time.process_time()
            subject = identified(Path(folder), kind, seed)
            measure(subject, each, seed % 1000)
        found.append(each)
        print(f"{line(each)} ({time.process_time() - began:.0f} s)", flush=True)
    told(found)


if __name__ == "__main__":
    main()
