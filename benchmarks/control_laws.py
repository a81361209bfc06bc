"""Four feedback laws on the same joints of the virtual rig, with the same estimator: one table.

braking curve: the law of `debist control design`. Energy switch: push along the velocity until the model's energy
carries the joint over its barrier, coast, drain what is left, then the same linear-quadratic regulator. Energy shaping:
the model's static moment is compensated and a spring to the target and a damper injected; both are tuned on the model,
by settling time. Predictive: every 5 ms the best of 80 moment sequences over 0.2 s by simulation of the model, then
the same regulator; an upper bound, as no target computes it in time.

Usage: python benchmarks/control_laws.py [COUNT] [--seed N]. About 40 s of processor time for each joint.
"""

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from control_fleet import FAST_RAMP, TOP, Subject, identified, impulses, judged, sequence, static_voltage

from pipeline.codegen.sequence import GraphSequence, sequence_kernel
from pipeline.compiled import compiled
from pipeline.control.controller import CONTROL, GRAPHS, PERIOD, begin_control, move
from pipeline.control.design import Settings
from pipeline.control.design import design as design_law
from pipeline.control.law import CONTROLLER_STATE, PLACES, TARGET_COLUMNS, TARGETS, Law
from pipeline.control.linear import wells_and_saddle
from pipeline.control.plant import ControlledJoint, forces, inertia, plant_of
from pipeline.generated.condensed_joint import STATES
from pipeline.models.hybrid.statics import rest_state
from pipeline.numerics.arrays import FloatArray
from pipeline.rig.loop import Controller, Scenario, python_controller

_GIVEN = CONTROL.given
_listen = sequence_kernel(GraphSequence(GRAPHS, CONTROL.calls[:2], _GIVEN))
_advance = sequence_kernel(GraphSequence(GRAPHS, CONTROL.calls[2:], _GIVEN))
NEAR, TARGET, VOLTS = PLACES["near"].start, PLACES["target"].start, PLACES["volts"]
Effort = Callable[[FloatArray], float]
EVERY, HORIZON = 5, 200  # periods


@compiled
def listen(s: FloatArray, q: float, target: float, law: Law, v: FloatArray) -> None:
    """Correct the estimate; the designed law's voltages."""
    told = np.array([q, target])
    _listen((s, told, v, law.numbers, law.prepared, law.slopes, law.curves, law.rests, law.targets, law.braking))


@compiled
def advance(s: FloatArray, law: Law, v: FloatArray) -> None:
    """Predict under voltages."""
    told = np.zeros(2)
    _advance((s, told, v, law.numbers, law.prepared, law.slopes, law.curves, law.rests, law.targets, law.braking))


def running(law: Law, make: Callable[[], Effort] | None, catches: bool = True) -> Controller:
    """A law in the loop; `make` gives the share of the largest moment, positive to the right; None the designed law."""
    s, v, top = np.zeros(CONTROLLER_STATE), np.zeros(2), law.number("highest")

    def made(q: float):
        begin_control(q, law, s)
        effort = None if make is None else make()

        def step(reading: float, target: float) -> tuple[float, float]:
            listen(s, reading, target, law, v)
            if effort is not None and not (catches and s[NEAR] > 0.5):
                share = float(np.clip(effort(s), -1.0, 1.0))
                v[0], v[1] = top * np.sqrt(max(share, 0.0)), top * np.sqrt(max(-share, 0.0))
            advance(s, law, v)
            return float(v[0]), float(v[1])

        return step

    return python_controller(made)


def column(law: Law, start: int, q: float) -> float:
    """A column of the table of targets at q [m]."""
    first, last = law.places
    return float(np.interp(q, np.linspace(first, last, TARGETS), law.targets[:, start]))


def energy_switch(plant: ControlledJoint, law: Law) -> Effort:
    """Push along the velocity until the energy suffices, coast, drain."""
    k, p, basis, weights = plant.constants
    grid = np.linspace(*law.places, 121)
    ratio, force = 1.25 / float(k[0]), []
    for q in grid:
        x, _ = rest_state(q, np.zeros(2), k, p, basis, weights, 0.0)
        on_q, on_slope, _ = forces(x, 0.0, 0.0, plant.constants)
        force.append(on_q + ratio * on_slope)
    potential = -np.concatenate([[0.0], np.cumsum(0.5 * np.diff(grid) * (np.array(force)[1:] + np.array(force)[:-1]))])
    saddle = law.number("saddle")
    barrier = float(np.interp(saddle, grid, potential))
    wells = [float(np.min(potential[side])) for side in (grid < saddle, grid > saddle)]

    def effort(s: FloatArray) -> float:
        x, target = s[:STATES], s[TARGET]
        towards = 1.0 if target > x[0] else -1.0
        along = 0.5 * x[[1, 3, 5]] @ inertia(x, p) @ x[[1, 3, 5]]
        energy = along + float(np.interp(x[0], grid, potential))
        before = (saddle - x[0]) * (target - saddle) > 0.0
        well = wells[int(target > saddle)] if not before else wells[int(target < saddle)]
        if before:
            if energy > barrier + 0.15 * (barrier - well) and x[1] * towards > 0.0:
                return 0.0
            return float(np.sign(x[1])) if abs(x[1]) > 5e-3 else towards
        if abs(target - x[0]) > 0.5 * abs(target - saddle) and x[1] * towards > 0.02:
            return 0.0
        drained = (energy - well) / (barrier - well)
        return float(np.clip(-10.0 * x[1], -1.0, 1.0)) * min(1.0, 4.0 * max(drained, 0.0))

    return effort


def shaped(law: Law, spring: float, damper: float) -> Effort:
    """Static moment compensated, spring and damper injected [shares of the largest moment per m, per m/s]."""

    def effort(s: FloatArray) -> float:
        q, speed = s[0], s[1]
        static = column(law, STATES, q) - s[PLACES["moment"].start]
        wanted = static / column(law, TARGET_COLUMNS["moments"].start + (0 if static > 0.0 else 1), q)
        return float(wanted + spring * (s[TARGET] - q) - damper * speed)

    return effort


def tuned(law: Law, places: tuple[float, float]) -> Callable[[], Effort]:
    """Energy shaping with the spring and damper that settle fastest on the model."""
    best, found = np.inf, (100.0, 5.0)
    for spring in (60.0, 120.0, 240.0, 480.0):
        for damper in (2.0, 4.0, 8.0, 16.0, 32.0):
            late = sum(_on_model(law, shaped(law, spring, damper), *pair) for pair in (places, places[::-1]))
            if late < best:
                best, found = late, (spring, damper)
    return lambda: shaped(law, *found)


def _on_model(law: Law, effort: Effort, start: float, target: float) -> float:
    s, v, top, last = np.zeros(CONTROLLER_STATE), np.zeros(2), law.number("highest"), 0
    begin_control(start, law, s)
    s[TARGET] = target - law.number("offset")
    for i in range(800):
        share = float(np.clip(effort(s), -1.0, 1.0))
        v[0], v[1] = top * np.sqrt(max(share, 0.0)), top * np.sqrt(max(-share, 0.0))
        move(s, v, law)
        if abs(s[0] - s[TARGET]) > 0.05 * abs(target - start):
            last = i
    return PERIOD * last


@compiled
def best_effort(s: FloatArray, law: Law, top: float, plans: FloatArray, ahead: int) -> float:
    """First moment of the plan (share, periods, share, periods, share) with the least cost; no number loses."""
    best, found, v = np.inf, 0.0, np.zeros(2)
    for i in range(len(plans)):
        x, cost = s.copy(), 0.0
        for step in range(ahead):
            row = 0 if step < plans[i, 1] else (2 if step < plans[i, 1] + plans[i, 3] else 4)
            share = plans[i, row]
            v[0], v[1] = top * np.sqrt(max(share, 0.0)), top * np.sqrt(max(-share, 0.0))
            move(x, v, law)
            off = x[0] - s[TARGET]
            cost += off * off
        cost += ahead * ((x[0] - s[TARGET]) ** 2 + (0.03 * x[1]) ** 2)
        if cost < best:
            best, found = cost, plans[i, 0]
    return found


def predictive(law: Law) -> Effort:
    """The best plan by simulation, renewed every `EVERY` periods."""
    top, kept = law.number("highest"), [0, 0.0]

    def effort(s: FloatArray) -> float:
        if kept[0] % EVERY == 0:
            towards = 1.0 if s[TARGET] > s[0] else -1.0
            plans = np.array(
                [
                    (a * towards, t, -b * towards, u, 0.0)
                    for a in (1.0, 0.4, -0.4, -1.0)
                    for t in (5, 15, 35, 70)
                    for b in (0.0, 0.5, 1.0)
                    for u in ((0,) if b == 0.0 else (10, 40))
                ]
            )
            kept[1] = best_effort(s, law, top, plans, HORIZON)
        kept[0] += 1
        return float(kept[1])

    return effort


def laws(plant: ControlledJoint, law: Law, wells: tuple[float, float]) -> dict[str, Controller]:
    return {
        "braking curve": running(law, None),
        "energy switch": running(law, lambda: energy_switch(plant, law)),
        "energy shaping": running(law, tuned(law, wells), catches=False),
        "predictive": running(law, lambda: predictive(law)),
    }


def measure(subject: Subject, count: int) -> dict[str, list[float]]:
    """Of each law: snaps right [%], settling [s], overshoot [mm], hold [mm], lowest voltage [%], caught [%]."""
    plant = plant_of(subject.model)
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    top, lags = min(TOP, plant.highest), subject.converters.lags
    made = laws(plant, design_law(plant, Settings(top, lags)), (left, right))
    times = np.round(sequence(count, 3), 3)
    told = np.array([left, *((right, left)[i % 2] for i in range(count))])
    snaps = Scenario(np.concatenate([[0.0], times]), told, float(times[-1] + 1.2), seed=3)
    hold = Scenario(np.array([0.0, 0.2]), np.array([left, saddle]), 6.0, lag=3e-3, seed=3)
    shares = (0.9, 0.8, 0.75, 0.7)
    low = {s: design_law(plant, Settings(min(s * static_voltage(subject, 0, FAST_RAMP), top), lags)) for s in shares}
    found = {}
    for name, controller in made.items():
        rows = judged(subject.run(snaps, controller), times, subject.places)
        held = subject.run(hold, controller)
        late = held.t > 2.0
        rms = float(np.sqrt(np.mean((held.true_q[late] - saddle) ** 2)))
        least = np.nan
        for share, law in low.items():
            still = Scenario(np.zeros(1), np.array([right]), 4.0, side=-1)
            end = subject.run(still, laws(plant, law, (left, right))[name]).true_q[-1]
            if abs(end - subject.places[1]) > 0.1 * (right - left):
                break
            least = share
        caught = np.mean(impulses(subject, controller, (left, right)))
        settled = rows[rows[:, 0] > 0.5]
        middle = np.median(settled[:, 1:], axis=0) if len(settled) else (np.nan, np.nan)
        found[name] = [100 * rows[:, 0].mean(), middle[0], 1e3 * middle[1], 1e3 * rms, 100 * least, 100 * caught]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("count", type=int, nargs="?", default=4)
    parser.add_argument("--seed", type=int, default=4242)
    parser.add_argument("--snaps", type=int, default=6)
    given = parser.parse_args()
    names = ("snaps %", "settling s", "overshoot", "hold mm", "least V %", "caught %")
    print(
        f"{'':28s}" + "".join(f"{name:>{int(float(width[:-1]))}}" for name, width in zip(names, _WIDTHS, strict=True))
    )
    for i in range(given.count):
        kind = ("same", "foreign")[i % 2]
        seed = int(np.random.SeedSequence([given.seed, i]).generate_state(1)[0])
        began = time.process_time()
        with tempfile.TemporaryDirectory() as folder:
            subject = identified(Path(folder), kind, seed)
            for name, row in measure(subject, given.snaps).items():
                texts = "".join(f"{value:{width}}" for value, width in zip(row, _WIDTHS, strict=True))
                print(f"{kind + ' ' + str(i):12s}{name:16s}{texts}", flush=True)
        print(f"{time.process_time() - began:.0f} s")


_WIDTHS = ("8.0f", "12.3f", "11.2f", "9.3f", "11.0f", "10.0f")

if __name__ == "__main__":
    main()
