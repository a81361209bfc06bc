"""Disturbances of controlled joints: what the designed controllers hold on the virtual rig, misses included.

`python benchmarks/control_disturbances.py RIG=RUN …`: for each folder of `debist rig simulate` and the run that was
identified from it, the controller of the run against the joint itself, with its own converters and laser. Printed are a
line for each joint with its misses, and the table. About 20 s of processor time a joint. On a joint of another size
(`size` of an experiment) forces grow with the third power of the size and lengths with the first; the time to
settle that is wanted stays.
"""

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.control.design import Settings, design as design_law
from pipeline.control.ensemble import Converters
from pipeline.control.law import Law
from pipeline.control.plant import ControlledJoint, wells_and_saddle
from pipeline.errors import DebistError
from pipeline.models.hybrid.model import HybridModel
from pipeline.numerics.arrays import BoolArray, FloatArray
from pipeline.numerics.metrics import one_step
from pipeline.rig.joint import rest
from pipeline.rig.loop import ClosedLoop, Scenario, run_loop
from pipeline.rig.random_joint import Drift, aged
from pipeline.workflow.studies.closed_loop import VirtualJoint, designed, virtual_joint
from pipeline.workflow.studies.controlled_run import ControlSettings, control_run

HELD, TRACKED, LEFT, SETTLED, DRIFTED = 0.5e-3, 0.15e-3, 0.1e-3, 0.3, 1.0  # m, m RMS, m, s, s
RATE = 10.0  # kV/s, path of a voltage in the last second under a load; limit cycles were 18 and more
BUMPS = {f"{1e3 * impulse:g} mN s": impulse for impulse in (0.5e-3, -0.5e-3, 1e-3, 3e-3)}
STEPS = {f"{1e3 * force:g} mN": force for force in (5e-3, -5e-3)}
FRICTIONS = (1.0, 0.1)
GAINS = (0.85, 1.15)
STIFFER = (-10.0, -5.0, 5.0)  # % of the beam's stiffness, which moves the wells
OTHERS: dict[str, dict[str, float]] = {
    "mass × 0.8": {"mass": 0.8}, "mass × 1.2": {"mass": 1.2}, "voltages × 0.85": {"gain": 0.85},
    "voltages × 1.15": {"gain": 1.15}, "converters of 2.5 kV": {"highest": 2500.0},
}  # fmt: skip
IMPULSES = (1e-3, -1e-3, 3e-3, -3e-3)  # N s


Row = tuple[str, float, bool]
"""Name, number and assessment."""


@dataclass(frozen=True)
class Tested:
    """A joint, its controller, and the readings [m] of left well, saddle and right well of its model."""

    joint: VirtualJoint
    model: HybridModel
    plant: ControlledJoint
    converters: Converters
    law: Law
    places: tuple[float, float, float]
    starts: dict[tuple[int, float], FloatArray]
    size: float = 1.0

    @property
    def newton(self) -> float:
        """What a newton on the drawn joint is on this one [N]."""
        return self.size**3

    def run(self, targets: dict[float, float], duration: float, side: int = -1, **other: Any) -> ClosedLoop:
        """The loop with targets [m] from times [s] on."""
        friction = float(other.get("friction", 1.0))
        p = self.joint.parameters
        slippery = p._replace(slip_force=friction * p.slip_force, slip_stiffness=friction * p.slip_stiffness)
        if (side, friction) not in self.starts:
            self.starts[side, friction] = rest(slippery, side=side)
        times, values = np.array(list(targets)), np.array(list(targets.values()))
        scenario = Scenario(times, values, duration, side=side, seed=7, **other)
        return run_loop(p, self.joint.bench, scenario, designed(self.law), self.starts[side, friction])


def tested(rig: Path, run: Path) -> Tested:
    controlled = control_run(run)
    plant, converters = controlled.plant, controlled.converters(ControlSettings())[0]
    law = design_law(plant, Settings(min(3000.0, controlled.limit), converters.lags))
    left, saddle, right = (each.q for each in wells_and_saddle(plant))
    size = json.loads((rig / "truth/truth.json").read_text(encoding="utf-8"))["experiment"].get("size", 1.0)
    joint = virtual_joint(str(rig))
    return Tested(joint, controlled.model, plant, converters, law, (left, saddle, right), {}, size)


def off(run: ClosedLoop, last: float = 1.0) -> FloatArray:
    """Distance q − target [m] in the last seconds."""
    late = run.t >= run.t[-1] - last
    return np.asarray((run.true_q - run.target)[late])


def settling(run: ClosedLoop, part: BoolArray, target: float, distance: float) -> float:
    """Settling time [s] in a part of a run, to where the joint rests at its end; infinite if that is another well."""
    rests = float(run.true_q[part][-100:].mean())
    if abs(rests - target) > 0.25 * distance:
        return np.inf
    step = one_step(run.t[part], run.true_q[part], rests, distance)
    return np.inf if step.settling_s is None else step.settling_s


def snaps(one: Tested, count: int, each: float, **other: Any) -> list[float]:
    """Settling times [s] of snaps to right and left in turn, from the left well, every `each` seconds."""
    left, _, right = one.places
    ways, begin = (right, left), 0.3 + each * np.arange(count)
    targets = {0.0: left} | {float(t): ways[i % 2] for i, t in enumerate(begin)}
    run = one.run(targets, 0.3 + count * each, **other)
    parts = [(run.t >= t) & (run.t < t + min(each, 3.0)) for t in begin]
    return [settling(run, part, ways[i % 2], right - left) for i, part in enumerate(parts)]


def saddles(one: Tested) -> Iterator[Row]:
    """What is held at the saddle: largest distance [m] in the last second."""
    left, saddle, _ = one.places

    def held(name: str, **other: Any) -> Row:
        far = float(np.abs(off(one.run({0.0: left, 0.3: saddle}, 5.5, **other))).max())
        return name, far, far < HELD * one.size

    n = one.newton
    bump = ((2.5, 25e-3 * n, 0.02),)
    for friction in FRICTIONS:
        for name, impulse in BUMPS.items():
            yield held(
                f"saddle, bump {name}, friction {friction:g}",
                pushes=((2.5, impulse / 0.02 * n, 0.02),),
                friction=friction,
            )
        for name, force in STEPS.items():
            yield held(
                f"saddle, step {name}, friction {friction:g}", pushes=((2.5, force * n, 9.0),), friction=friction
            )
        yield held(f"saddle, hand 10 mN, friction {friction:g}", hands=((2.0, 10e-3 * n, 1.0),), friction=friction)
        yield held(
            f"saddle, table 5 mN 8 Hz, friction {friction:g}", shakes=((2.0, 5e-3 * n, 8.0, 1.5),), friction=friction
        )
    for gain in GAINS:
        yield held(f"saddle, voltages × {gain:g}, friction 0.1, bump", gain=gain, friction=0.1, pushes=bump)
    yield held("saddle, wire 1 mN", drag=1e-3 * n, pushes=bump)
    for lag in (1e-3, 3e-3, 5e-3, 8e-3):
        yield held(f"saddle, lag {1e3 * lag:g} ms untold", lag=lag, pushes=bump)
    for begin in (2.0, 2.2):
        yield held(
            f"saddle, laser frozen 1 s at {begin:g} s",
            frozen=((begin, 1.0),),
            pushes=((begin + 0.3, 25e-3 * n, 0.02),),
        )


def ramps(one: Tested) -> Iterator[Row]:
    """RMS error [m] along a ramp of 12 s from well to well."""
    left, _, right = one.places
    reference = dict(zip(np.linspace(0.5, 12.5, 400).tolist(), np.linspace(left, right, 400).tolist(), strict=True))
    for friction in FRICTIONS:
        run = one.run({0.0: left} | reference, 13.0, friction=friction)
        error = float(np.sqrt(np.mean((run.true_q - run.target)[run.t > 0.5] ** 2)))
        yield f"ramp, friction {friction:g}", error, error < TRACKED * one.size


def wells(one: Tested) -> Iterator[Row]:
    """Settling [s], voltage at rest [V], and what loads leave [m]."""
    left, _, right = one.places
    times, longest = snaps(one, 6, 2.0), SETTLED
    yield "snaps, median settling", float(np.median(times)), float(np.median(times)) <= longest
    yield "snaps, slowest", max(times), max(times) <= longest
    rates = []
    for well, side in ((left, -1), (right, 1)):
        name = "left" if side < 0 else "right"
        run = one.run({0.0: well}, 8.0, side)
        rest_volts = float(np.maximum(run.command1, run.command2)[run.t > 7.0].mean())
        yield f"{name} well, voltage at rest", rest_volts, rest_volts == 0.0
        for force in (10e-3, -10e-3, 20e-3, -20e-3):
            run = one.run({0.0: well}, 8.0, side, pushes=((0.5, force * one.newton, 9.0),))
            far, late = float(np.abs(off(run)).max()), run.t > 7.0
            volts = np.maximum(run.command1, run.command2)[late]
            none = bool(volts.max() == 0.0)
            rates.append(1e-3 * float(np.abs(np.diff(volts)).sum()))
            yield f"{name} well, load {1e3 * force:g} mN", far, far < LEFT * one.size or none
    yield "wells under these loads, fastest voltage, kV/s", max(rates), max(rates) < RATE


def drifts(one: Tested) -> Iterator[Row]:
    """Slowest settling [s] of four snaps after the beam's stiffness has changed, which moves the wells."""
    for change in STIFFER:
        moved, _ = aged(one.joint.parameters, one.joint.bench, 1.0, Drift(stiffness_percent=change))
        slowest = max(snaps(replace(one, joint=replace(one.joint, parameters=moved), starts={}), 4, 3.0))
        yield f"snaps, beam {change:+g} % stiff, slowest settling", slowest, slowest <= DRIFTED


def others(one: Tested) -> Iterator[Row]:
    """Slowest settling [s] of four snaps of a joint or converters that differ, and of a well after an impulse."""
    left, _, right = one.places
    for name, other in OTHERS.items():
        slowest = max(snaps(one, 4, 3.0, **other))
        yield f"snaps, {name}, slowest settling", slowest, slowest <= DRIFTED
    for well, side in ((left, -1), (right, 1)):
        name = "left" if side < 0 else "right"
        for impulse in IMPULSES:
            run = one.run({0.0: well}, 3.0, side, pushes=((0.5, impulse / 0.02 * one.newton, 0.02),))
            seconds = settling(run, run.t >= 0.5, well, right - left)
            yield f"{name} well, impulse {1e3 * impulse:g} mN s, settling", seconds, seconds <= DRIFTED


def print_table(joints: dict[str, dict[str, tuple[float, bool]]]) -> None:
    """Print the table: medians and worst numbers of both physics, in mm where they are lengths."""
    kinds = ("same", "foreign")
    print("| | right | " + " | ".join(f"{kind}: median, worst" for kind in kinds) + " |\n|---|---|---|---|")
    for name in dict.fromkeys(name for rows in joints.values() for name in rows):
        scale = 1e3 if name.startswith(("saddle", "ramp")) or ", load" in name else 1.0
        those = {joint: rows[name] for joint, rows in joints.items() if name in rows}
        cells = []
        for kind in kinds:
            values = scale * np.array([value for joint, (value, _) in those.items() if kind in joint])
            cells.append(f"{np.median(values):.3f}, {values.max():.3f}" if values.size else "")
        print(f"| {name} | {sum(good for _, good in those.values())} of {len(those)} | " + " | ".join(cells) + " |")


def main(measures: tuple[Callable[[Tested], Iterator[Row]], ...]) -> None:
    joints = {}
    for pair in sys.argv[1:]:
        rig, _, run = pair.partition("=")
        name = Path(rig).name
        try:
            one = tested(Path(rig), Path(run))
        except DebistError as error:
            print(f"{name}: no controller: {error}", flush=True)
            continue
        rows = {what: (value, good) for some in measures for what, value, good in some(one)}
        joints[name] = rows
        misses = "".join(f"; {what} {value:.3g}" for what, (value, good) in rows.items() if not good)
        print(f"{name}: {sum(good for _, good in rows.values())} of {len(rows)}{misses}", flush=True)
    print_table(joints)


if __name__ == "__main__":
    main((wells, saddles, ramps, drifts, others))
