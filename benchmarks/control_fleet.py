"""Control of joints that are drawn now: what `debist control` reaches on the virtual rig, beside plain pulses.

`python benchmarks/control_fleet.py [COUNT] [--seed SEED]`: COUNT joints, half of the analytical model's physics and
half foreign, each identified from one log of 37.5 s with default settings. Controller and snaps are designed on
the identified model, then run against the joint itself, with its own converters and laser. Printed are a line for each
joint and the table at the end; misses are in it. Parts of a fleet may run side by side, each with its `--first`, and
with one `--record`; then the same command prints the table of all. About 45 s of processor time a joint.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from control_bound import LATE, lowest_programmes
from control_disturbances import disturbances, tested
from control_disturbances import told as told_disturbances
from control_table import Found, line, recorded, told
from scipy.signal import lfilter

from pipeline.control.design import Settings
from pipeline.control.design import design as design_law
from pipeline.control.ensemble import INTERVAL, Converters, Ensemble, ensemble_of
from pipeline.control.estimator import PERIOD
from pipeline.control.law import CONTROLLER_STATE, Law
from pipeline.control.linear import wells_and_saddle
from pipeline.control.plant import ASSUMED_LAG, plant_of
from pipeline.control.pulses import design_pulse
from pipeline.control.step_metrics import one_step
from pipeline.control.switching_map import TYPICAL, Well, lowest_voltage, pulses, uncertain
from pipeline.device_parameters import NOMINAL
from pipeline.errors import DebistError, InputError
from pipeline.export.controller import ControllerSubject, write_controller
from pipeline.loading.run_models import load_run_model
from pipeline.models.hybrid import parameters as condensed_parameters
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.problem import DEVIATION_COUNT
from pipeline.models.paper.model import RbfPaperModel
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.bench import Bench
from pipeline.rig.fleet import Experiment, write_prototype
from pipeline.rig.joint import rest, wells
from pipeline.rig.loop import ClosedLoop, Controller, Scenario, played, run_loop
from pipeline.rig.parameters import RigParameters
from pipeline.runs.run_folder import RunFolder
from pipeline.settings import parse_prototype
from pipeline.tools.closed_loop import designed, virtual_joint
from pipeline.tools.controlled_run import DATA_SHEET, ControlSettings, control_run

SNAPS, BESIDE, ROBUST, PULSES = 50, 10, 6, 12  # of a joint: snaps, plain ones, of each change, pulses to each side
LENGTHS = (0.1, 0.2)  # s, of the pulses whose lowest voltage is looked for
WAYS: tuple[Well, Well] = ("right", "left")  # what a pulse on the left and on the right brings about
WATCHED = 1.2  # s after a command
TOP = 3000.0  # V
SLOW_RAMP, FAST_RAMP = 60.0, 6.0  # s, of the ramps to 3 kV that give the static switching voltage


@dataclass(frozen=True)
class Subject:
    """A joint, its bench, its rests, and the model that was identified."""

    p: RigParameters
    bench: Bench
    model: HybridModel
    paper: RbfPaperModel
    converters: Converters
    starts: dict[int, FloatArray]
    places: tuple[float, float]

    def run(self, scenario: Scenario, controller: Controller) -> ClosedLoop:
        start = self.starts[scenario.side] if scenario.mass == scenario.gain == 1.0 else None
        return run_loop(self.p, self.bench, scenario, controller, start)


def identified(folder: Path, kind: str, seed: int) -> Subject:
    written = write_prototype(folder, "joint", Experiment(kind, "parquet", 10_000.0, validation_logs=0), seed=seed)
    run, debist = folder / "run", [str(Path(sys.executable).with_name("debist"))]
    for command in (["ingest", str(written), "-o", str(run)], ["differentiate", str(run)], ["identify", str(run)]):
        subprocess.run([*debist, *command, "-q"], check=True, capture_output=True)
    opened = RunFolder.open(run)
    prototype = parse_prototype(opened.manifest.prototype, "run")
    model, paper = (load_run_model(opened, prototype, name) for name in ("hybrid", "rbf-paper"))
    assert isinstance(model, HybridModel) and isinstance(paper, RbfPaperModel)
    joint = virtual_joint(str(folder))
    starts = {side: rest(joint.parameters, side=side) for side in (-1, 1)}
    converters, _ = control_run(run).converters(ControlSettings())
    return Subject(joint.parameters, joint.bench, model, paper, converters, starts, wells(joint.parameters))


def drawing() -> HybridModel:
    """The analytical model with nominal parameters, nothing identified."""
    slope_ratio = condensed_parameters.static_slope_ratio(NOMINAL)
    from pipeline.models.hybrid.problem import CondensedJoint

    condensed = CondensedJoint(NOMINAL, np.array([-0.02, 0.01, 0.008]), 0, TOP, slope_ratio)
    theta = np.concatenate([condensed_parameters.nominal_deviations(), condensed.start()[DEVIATION_COUNT:]])
    return HybridModel(condensed, theta, *2 * (np.zeros((len(theta), 1)),))


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


def played_snaps(subject: Subject, shapes: Sequence[FloatArray], seed: int, count: int = BESIDE) -> FloatArray:
    """Feedforward: the pulse to the right, to the left in turn."""
    times = sequence(count, seed)
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
    return judged(subject.run(scenario, designed(law)), times, subject.places)


def plain(side: int, length: float) -> FloatArray:
    u = np.zeros((round(length * 1e3) + 1, 2))
    u[:-1, side] = TOP
    return u


def static_voltage(subject: Subject, side: int, seconds: float = SLOW_RAMP) -> float:
    """Voltage [V] at which a ramp from 0 to 3 kV that takes `seconds` carries the joint over."""
    t = np.arange(round(1e3 * seconds)) * 1e-3
    u = np.zeros((t.size, 2))
    u[:, side] = TOP * t / t[-1]
    run = subject.run(Scenario(np.zeros(1), np.zeros(1), seconds, side=-1 if side == 0 else 1), played(t, u))
    over = run.true_q > 0.5 * subject.places[1] if side == 0 else run.true_q < 0.5 * subject.places[0]
    return float(u[min(int(np.argmax(over)) // 2, t.size - 1), side]) if over.any() else np.nan


def lowest_share(subject: Subject, targets: tuple[float, float], side: int, static: float) -> float:
    """Least share of a voltage with which feedback switches within 6 s, to 1 %; infinite beyond 3 kV."""

    def switches(share: float) -> bool:
        law = design_law(plant_of(subject.model), Settings(min(share * static, TOP), subject.converters.lags))
        start = -1 if side == 0 else 1
        run = subject.run(Scenario(np.zeros(1), np.array([targets[1 - side]]), 6.0, side=start), designed(law))
        return bool(abs(run.true_q[-1] - subject.places[1 - side]) < 0.1 * (subject.places[1] - subject.places[0]))

    share = 0.7
    if switches(share):
        while share > 0.4 and switches(share - 0.01):
            share -= 0.01
        return share
    return next((round(each, 2) for each in np.arange(0.71, 1.101, 0.01) if switches(each)), np.inf)


def lowest_possible(
    joint: Ensemble, targets: tuple[float, float], saddle: float, side: int, static: float, first: float
) -> float:
    """Least share of a voltage with which the best programme of both voltages carries the model over, to 1 %."""
    one, start, sign = joint.some(1), targets[side], 1.0 - 2.0 * side
    goal = sign * 0.5 * (saddle + targets[1 - side])

    def furthest(u: FloatArray) -> FloatArray:
        return np.asarray((sign * one.run(u, start)[:, 0, -round(LATE / INTERVAL) :]).max(axis=1))

    return min((share for share, _ in lowest_programmes(furthest, side, static, goal, first)), default=first)


def thresholds(subject: Subject, wells_of_model: tuple[float, float, float]) -> list[float]:
    """Whether the band of 90 % holds the lowest voltage at which a plain pulse switches the joint."""
    held = []
    for side in (0, 1):
        for length in LENGTHS:
            found = lowest_voltage(subject.model, subject.converters, wells_of_model, WAYS[side], length)
            if found is None or found.voltage * np.exp(0.12) > TOP:
                continue
            below, above = lowest_of_joint(subject, side, length, found.voltage)
            held.append(float(found.low <= above and below <= found.high))
    return held


def lowest_of_joint(subject: Subject, side: int, length: float, about: float) -> tuple[float, float]:
    """Voltages [V] below and above the lowest at which a pulse of `length` [s] switches the joint, to 0.02 %."""

    def switches(volts: float) -> bool:
        u = pulses(np.array([volts]), np.array([length]), side)[0]
        t = np.arange(len(u)) * 1e-3
        scenario = Scenario(np.zeros(1), np.zeros(1), float(t[-1]), side=-1 if side == 0 else 1)
        return bool((subject.run(scenario, played(t, u)).true_q[-1] > 0.0) == (side == 0))

    # The first switch from below, on steps of 1.5 %: there are tongues above it.
    steps = about * np.exp(np.arange(-0.12, 0.135, 0.015))
    first = next((i for i, volt in enumerate(steps) if switches(float(volt))), len(steps) - 1)
    below, above = float(steps[max(first - 1, 0)]), float(steps[first])
    for _ in range(6):
        middle = 0.5 * (below + above)
        below, above = (below, middle) if switches(middle) else (middle, above)
    return below, above


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
        places = (targets[0], saddle, targets[1])
        one = uncertain(joint, [lowest_voltage(subject.model, subject.converters, places, WAYS[side], TYPICAL)])
        volts, lengths = rng.uniform(0.4, 1.0, PULSES) * TOP, np.exp(rng.uniform(np.log(0.03), np.log(0.6), PULSES))
        shapes = pulses(volts, np.round(lengths, 3), side)
        switched = (one.run(shapes, start)[:, :, -1] > saddle) == (side == 0)
        for shape, chance in zip(shapes, switched.mean(axis=1), strict=True):
            t = np.arange(len(shape)) * 1e-3
            scenario = Scenario(np.zeros(1), np.zeros(1), float(t[-1]), side=-1 if side == 0 else 1)
            end = subject.run(scenario, played(t, shape)).true_q[-1]
            scores.append(float((chance - ((end > 0.0) == (side == 0))) ** 2))
    return scores


def step_seconds(law: Law, lags: tuple[float, float], places: tuple[float, float, float]) -> float:
    """Processor time [s] of a step in C, its call from Python included: the longest of four kinds of reading."""
    import ctypes

    with tempfile.TemporaryDirectory() as name:
        subject = ControllerSubject("fleet", "hybrid", "0" * 12, law, lags, places)
        source, library = write_controller(subject, Path(name)).written[1], Path(name) / "controller.so"
        subprocess.run(["cc", "-O2", "-fPIC", "-shared", str(source), "-o", str(library), "-lm"], check=True)
        loaded = ctypes.CDLL(str(library))
    call, begin = loaded.debist_controller_step, loaded.debist_controller_init
    call.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_void_p]
    begin.argtypes = [ctypes.c_void_p, ctypes.c_double]
    memory, v, t = np.zeros(CONTROLLER_STATE), np.zeros(2), np.arange(5000)
    left, right = places[0], places[2]
    kinds = (np.full(t.size, left), left + 1e-6 * (t % 7), np.where(t % 100 < 50, np.nan, left))
    slowest = 0.0
    for readings in (*kinds, 0.5 * (left + right) + 0.5 * (left - right) * np.cos(t / 30)):
        begin(memory.ctypes.data, left)
        began = time.process_time()
        for reading in readings.tolist():
            call(memory.ctypes.data, reading, right, v.ctypes.data)
        slowest = max(slowest, (time.process_time() - began) / t.size)
    return slowest


@cache
def nominal_pulses() -> tuple[FloatArray, FloatArray]:
    """Pulses to the right and to the left on the analytical model with nominal parameters."""
    blank = ensemble_of(drawing(), 0, Converters((ASSUMED_LAG, ASSUMED_LAG), DATA_SHEET))
    left, _, right = (each.q for each in wells_and_saddle(plant_of(drawing())))
    return (
        design_pulse(blank, left, right, right - left, TOP).v,
        design_pulse(blank, right, left, right - left, TOP).v,
    )


class OneByOne:
    """A model that is no hybrid, in the place of an ensemble: every run by itself."""

    def __init__(self, model: RbfPaperModel, lag: float) -> None:
        self.model, self.lag = model, lag

    def some(self, _count: int) -> "OneByOne":
        return self

    def run(self, commands: FloatArray, start: float) -> FloatArray:
        """Displacements [m] every `INTERVAL`, shape (P, 1, N), from rest at `start` [m]; as `Ensemble.run`."""
        kept, each = np.exp(-PERIOD / self.lag), round(INTERVAL / PERIOD)
        volts = lfilter([1.0 - kept], [1.0, -kept], np.pad(commands, ((0, 0), (0, 1), (0, 0))), axis=1)[:, ::each]
        t = INTERVAL * np.arange(volts.shape[1])
        return np.nan_to_num([[self.model.simulate(t, v, start, 0.0).q] for v in volts], nan=1.0, posinf=1.0)


def paper_snaps(subject: Subject, targets: tuple[float, float], top: float, seed: int) -> FloatArray:
    """Snaps by pulses that were designed on `rbf-paper`; all fail where it has no two wells or no pulse is found."""
    alone = OneByOne(subject.paper, sum(subject.converters.lags) / 2.0)
    left, right = (float(alone.run(np.zeros((1, 3000, 2)), place)[0, 0, -1]) for place in targets)
    if not left < 0.0 < right < -2.0 * left:
        return np.tile([0.0, np.inf, 0.0], (BESIDE, 1))
    try:
        ways = ((left, right), (right, left))
        shapes = [design_pulse(alone, a, b, right - left, top).v for a, b in ways]  # type: ignore[arg-type]
    except InputError:
        return np.tile([0.0, np.inf, 0.0], (BESIDE, 1))
    return played_snaps(subject, shapes, seed)


def measure(subject: Subject, found: Found, seed: int) -> None:
    plant = plant_of(subject.model)
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    targets, top = (left, right), min(TOP, plant.highest)
    law = design_law(plant, Settings(top, subject.converters.lags))
    joint = ensemble_of(subject.model, 32, subject.converters)
    ways = ((left, right), (right, left))
    found.lines["feedforward"] = _rows(
        played_snaps(subject, [design_pulse(joint, a, b, right - left, top).v for a, b in ways], seed, SNAPS)
    )
    found.lines["pulse, nominal parameters"] = _rows(played_snaps(subject, nominal_pulses(), seed))
    found.lines["pulse, rbf-paper"] = _rows(paper_snaps(subject, targets, top, seed))
    for length in (0.3, 0.5):
        found.lines[f"plain 3 kV, {length} s"] = _rows(
            played_snaps(subject, [plain(0, length), plain(1, length)], seed)
        )
    found.lines["feedback"] = _rows(commanded_snaps(subject, law, targets, seed, SNAPS))
    changes = ({"mass": 1.05}, {"mass": 0.95}, {"gain": 1.02}, {"gain": 0.98}, {"noise": 5.0})
    robust = [commanded_snaps(subject, law, targets, seed, ROBUST, **change)[:, 0] for change in changes]
    found.lines["robust"] = list(np.concatenate(robust))
    found.lines["hold"] = []
    for lag in (1e-3, 3e-3):
        told = np.array([left, saddle])
        run = subject.run(Scenario(np.array([0.0, 0.2]), told, 60.0, lag=lag, seed=seed), designed(law))
        late = run.t > 2.0
        found.lines["hold"].append(float(np.sqrt(np.mean((run.true_q[late] - saddle) ** 2))))
        found.lines["charge"] = [float(np.sqrt(np.mean(run.command1[late] ** 2 + run.command2[late] ** 2) / 2.0))]
    for name in ("static", "ramp", "share", "possible"):
        found.lines[name] = []
    for side in (0, 1):
        slow, fast = static_voltage(subject, side), static_voltage(subject, side, FAST_RAMP)
        if np.isnan(fast):  # 3 kV do not switch it within 6 s
            continue
        share = lowest_share(subject, targets, side, fast)
        best = lowest_possible(joint, targets, saddle, side, fast, min(share, 1.0))
        for name, value in (("static", slow), ("ramp", fast), ("share", share), ("possible", min(share, best))):
            found.lines[name].append(value)
    found.lines["caught"] = impulses(subject, designed(law), targets)
    found.lines["brier"] = brier(subject, joint, targets, saddle, seed)
    found.lines["band"] = thresholds(subject, (left, saddle, right))
    found.lines["step"] = [step_seconds(law, subject.converters.lags, (left, saddle, right))]


def _rows(values: FloatArray) -> list[float]:
    return [float(x) for x in values.ravel()]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("count", type=int, nargs="?", default=2)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--first", type=int, default=0, help="number of the first joint of the seed's fleet")
    parser.add_argument(
        "--record", type=Path, help="file that keeps the joints' results; those in it are not run again"
    )
    given = parser.parse_args()
    print(f"seed {given.seed}", flush=True)
    found, disturbed = recorded(given.record), {}
    for i in range(given.first, given.first + given.count):
        kind = ("same", "foreign")[i % 2]
        each, seed = Found(f"{kind}-{i:02d}", kind), int(np.random.SeedSequence([given.seed, i]).generate_state(1)[0])
        if any(one.name == each.name for one in found):
            continue
        began, spent = time.process_time(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        try:
            with tempfile.TemporaryDirectory() as folder:
                measure(identified(Path(folder), kind, seed), each, seed % 1000)
                disturbed[each.name] = disturbances(tested(Path(folder), Path(folder) / "run"))
        except (DebistError, subprocess.CalledProcessError) as error:
            print(f"{each.name}: no controller: {error}", flush=True)
            continue
        found.append(each)
        if given.record:
            with given.record.open("a", encoding="utf-8") as file:
                file.write(json.dumps(each.__dict__) + "\n")
        own, others = time.process_time() - began, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - spent
        print(f"{line(each)} ({others:.0f} s to identify, {own:.0f} s)", flush=True)
    told(found)
    told_disturbances(disturbed)


if __name__ == "__main__":
    main()
