"""Closed loop: a designed controller on a virtual joint, from files to a raw log with the reference in it."""

import json
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast, get_args

import numpy as np

from pipeline.control.controller import begin_control, control
from pipeline.control.law import CONTROLLER_STATE, Law
from pipeline.control.step_metrics import step_metrics
from pipeline.errors import InputError
from pipeline.loading.run_models import load_design
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import rms
from pipeline.rig.bench import Bench, random_bench
from pipeline.rig.excitation import load_sequence
from pipeline.rig.joint import saddle, tip_displacement, wells
from pipeline.rig.log import LAYOUTS, PER_SI
from pipeline.rig.loop import ClosedLoop, Controller, Scenario, bench_from_json, played, python_controller, run_loop
from pipeline.rig.parameters import RigParameters, from_json, nominal, table1
from pipeline.rig.random_joint import Family, random_joint
from pipeline.rig_logs import read_recording
from pipeline.runs.outputs import new_outputs, rebased
from pipeline.runs.run_folder import RunFolder
from pipeline.units import parse_quantity, to_si

_NAMED = {"nominal": nominal, "table1": table1}
_MOST_STEPS = 50


@dataclass(frozen=True)
class VirtualJoint:
    """A joint of the virtual rig with its bench and the places that targets may name."""

    name: str
    parameters: RigParameters
    bench: Bench

    @cached_property
    def places(self) -> dict[str, float]:
        """Displacement [m] of the wells and of the unstable equilibrium, without voltage."""
        left, right = wells(self.parameters)
        return {"left": left, "right": right, "saddle": tip_displacement(self.parameters, saddle(self.parameters))}


def virtual_joint(where: str) -> VirtualJoint:
    """A joint from a folder of `debist rig`, or by name: nominal, table1, same:SEED, foreign:SEED, worn:SEED.

    Raises
    ------
    InputError
        There is no such joint, or its truth is damaged.
    """
    kind, _, seed = where.partition(":")
    if kind in _NAMED and not seed:
        return VirtualJoint(kind, _NAMED[kind](), Bench())
    if kind in get_args(Family) and seed.isdigit():
        rng = np.random.default_rng(int(seed))
        joint = random_joint(rng, cast(Family, kind))
        return VirtualJoint(f"{kind}-{seed}", joint, random_bench(rng))
    given = Path(where)
    folder = given if given.is_dir() else given.parent
    path = folder / "truth" / "truth.json"
    if not given.exists() or not path.is_file():
        raise InputError(
            f"{where}: no joint of the virtual rig; name a folder of `debist rig simulate`, or one of nominal, table1, "
            "same:SEED, foreign:SEED, worn:SEED"
        )
    try:
        truth = json.loads(path.read_text(encoding="utf-8"))
        return VirtualJoint(folder.name, from_json(truth["joint"]), bench_from_json(truth["bench"]))
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"{path}: damaged ({type(error).__name__}: {error}); simulate the joint again") from None


def parse_target(text: str, joint: VirtualJoint) -> tuple[FloatArray, FloatArray]:
    """Times [s] and targets [m] of a reference: ``VALUE``, ``TIME:VALUE,…``, or a file with channels time and target.

    A value is a length with its unit, or left, right, saddle.
    """
    path = Path(text)
    if path.suffix.lower() in (".csv", ".mat", ".parquet"):
        log = read_recording(path, channels=["time", "target"])
        time, target = log.channel("time"), log.channel("target")
        scale = to_si(target.unit, ("m",), f"{path}: target").factor if target.unit else 1.0
        if time.samples.size < 1 or np.any(np.diff(time.samples) <= 0.0) or not np.isfinite(target.samples).all():
            raise InputError(f"{path}: a reference needs times that advance and targets that are finite")
        return time.samples - time.samples[0], scale * target.samples
    places = joint.places
    steps = []
    for part in text.split(","):
        at, colon, value = part.rpartition(":")
        place = places.get(value.strip())
        when = parse_quantity(at, ("s",), "--target") if colon else 0.0
        if place is None and not any(letter.isdigit() for letter in value):
            raise InputError(f"--target: no place is called {value!r}; give left, right, saddle, or a length as 2mm")
        steps.append((when, parse_quantity(value, ("m",), "--target") if place is None else place))
    t, target = np.array(steps).T
    if np.any(np.diff(t) <= 0.0) or t[0] < 0.0:
        raise InputError(f"--target {text}: the times must rise from 0 s on")
    start = places["left"]
    return (t, target) if t[0] == 0.0 else (np.insert(t, 0, 0.0), np.insert(target, 0, start))


def parse_events(text: str, units: tuple[str, ...], option: str) -> tuple[tuple[float, ...], ...]:
    """Events ``A:B:C,…`` with a unit each."""
    events = []
    for part in filter(None, text.split(",")):
        values = part.split(":")
        if len(values) != len(units):
            raise InputError(f"{option} {part}: give {' : '.join(units)} with their units, joined by colons")
        events.append(tuple(parse_quantity(v, (u,), option) for v, u in zip(values, units, strict=True)))
    return tuple(events)


def _positive(text: str, unit: str, option: str) -> float:
    value = parse_quantity(text, (unit,), option)
    if not 0.0 < value < float("inf"):
        raise InputError(f"{option} {text}: give a value above zero")
    return value


def _in_time(events: tuple[tuple[float, ...], ...], duration: float, option: str) -> Any:
    """Events that begin within the run and take time."""
    for begin, *_, length in events:
        if not (begin >= 0.0 and length > 0.0):
            raise InputError(f"{option}: an event begins at 0 s or later and lasts longer than 0 s")
        if begin >= duration:
            raise InputError(f"{option}: at {begin:g} s the run is over; raise --duration, which is {duration:g} s")
    return events


def designed(law: Law) -> Controller:
    """The controller of this law in Python, which equals the exported one."""
    s, v = np.zeros(CONTROLLER_STATE), np.zeros(2)

    def made(q: float) -> Any:
        """The controller at a first reading."""
        begin_control(q, law, s)

        def step(q: float, target: float) -> tuple[float, float]:
            """One period."""
            control(s, q, target, law, v)
            return float(v[0]), float(v[1])

        return step

    return python_controller(made)


def _controller(run: Path | None, play: Path | None) -> Controller:
    if run is not None:
        return designed(Law.from_json(load_design(RunFolder.open(run))["law"]))
    assert play is not None  # noqa: S101
    loaded = load_sequence(play)
    return played(loaded.t, loaded.u)


def write_log(path: Path, form: str, run: ClosedLoop, name: str) -> list[Path]:
    """Write a run as a raw log with the reference, and the settings with which debist reads it, beside one another.

    Returns
    -------
    list of Path
        The log and ``NAME.toml``.
    """
    layout = LAYOUTS[form]
    unit = layout.v1[1]
    readings = {layout.q: run.q, layout.v1: run.v1, layout.v2: run.v2}
    channels = {key: (PER_SI[u] * values, u) for (key, u), values in readings.items()}
    channels["target"] = (PER_SI[layout.q[1]] * run.target, layout.q[1])
    channels["command_left"] = (PER_SI[unit] * run.command1, unit)
    channels["command_right"] = (PER_SI[unit] * run.command2, unit)
    path.parent.mkdir(parents=True, exist_ok=True)
    layout.write(path, run.t, channels)
    toml = path.with_suffix(".toml")
    head = f'# Simulated by the virtual rig in closed loop.\nname = "{name}"\n\n[logs]\ntrain = ["{path.name}"]\n\n'
    plant = '[plant]\ninputs = "squared"\nparameters = "nominal"\n'
    toml.write_text(f"{head}{layout.toml()}\n{plant}", encoding="utf-8")
    return [path, toml]


def with_side(scenario: Scenario, joint: VirtualJoint) -> Scenario:
    """The scenario from the well that lies nearer to its first target."""
    places = joint.places
    near = abs(scenario.target[0] - places["right"]) < abs(scenario.target[0] - places["left"])
    return replace(scenario, side=1 if near else -1)


@dataclass(frozen=True)
class ClosedLoopOptions:
    """Options of the user, as text with units (see `debist rig closed-loop --help`)."""

    target: str
    duration: str = "5 s"
    form: str = "mat"
    lag: str | None = None
    highest: str = "3 kV"
    push: str = ""
    hand: str = ""
    shake: str = ""
    drag: str = "0 N"
    friction: float = 1.0
    lost: str = ""
    frozen: str = ""
    barrier: float = 0.0
    noise: float = 1.0
    seed: int = 1
    start: str | None = None

    def _events(self, duration: float) -> dict[str, Any]:
        """What happens at times within a run of this length [s]."""
        given = (
            ("pushes", self.push, ("s", "N", "s"), "--push"),
            ("hands", self.hand, ("s", "N", "s"), "--hand"),
            ("shakes", self.shake, ("s", "N", "Hz", "s"), "--shake"),
            ("lost", self.lost, ("s", "s"), "--lost"),
            ("frozen", self.frozen, ("s", "s"), "--frozen"),
        )
        return {
            name: _in_time(parse_events(text, units, option), duration, option) for name, text, units, option in given
        }

    def scenario(self, joint: VirtualJoint) -> Scenario:
        """The scenario on a joint."""
        t, target = parse_target(self.target, joint)
        places = joint.places
        reach = 0.25 * (places["right"] - places["left"])
        low, high = places["left"] - reach, places["right"] + reach
        if target.min() < low or target.max() > high:
            raise InputError(
                f"--target: from {1e3 * target.min():.1f} to {1e3 * target.max():.1f} mm; this joint's wells lie at "
                f"{1e3 * places['left']:.1f} and {1e3 * places['right']:.1f} mm, and targets from {1e3 * low:.1f} to "
                f"{1e3 * high:.1f} mm make sense"
            )
        duration = parse_quantity(self.duration, ("s",), "--duration")
        if not 0.1 <= duration <= 3600.0:
            raise InputError(f"--duration {self.duration}: a run lasts 0.1 to 3600 s")
        if t[-1] >= duration and not Path(self.target).is_file():
            raise InputError(f"--target: at {t[-1]:g} s the run is over; raise --duration, which is {duration:g} s")
        if not -100.0 < self.barrier < 1000.0:
            raise InputError(
                f"--barrier {self.barrier:g}: give by how many percent the barrier is higher, -100 to 1000"
            )
        result = with_side(
            Scenario(
                t=t,
                target=target,
                duration=duration,
                highest=_positive(self.highest, "V", "--highest"),
                lag=None if self.lag is None else _positive(self.lag, "s", "--lag"),
                **self._events(duration),
                drag=abs(parse_quantity(self.drag, ("N",), "--drag")),
                friction=self.friction,
                barrier=0.01 * self.barrier,
                noise=self.noise,
                seed=self.seed,
            ),
            joint,
        )
        if self.start not in (None, "left", "right"):
            raise InputError(f"--from {self.start}: the joint rests in its left or right well")
        return result if self.start is None else replace(result, side=-1 if self.start == "left" else 1)


def closed_loop_log(
    where: str,
    controller: Path | None,
    play: Path | None,
    output: Path,
    options: ClosedLoopOptions,
    *,
    force: bool = False,
) -> tuple[list[Path], dict[str, Any]]:
    """Run the controller of a run, or play a sequence, on a joint and write the log, as `debist rig closed-loop`.

    Returns
    -------
    files : list of Path
        The log and its settings.
    summary : dict
        Metrics of every step of the target, from the joint's true motion (SI).
    """
    if (controller is None) == (play is None):
        raise InputError("give either --controller or --play")
    if options.form not in LAYOUTS:
        raise InputError(f"--format {options.form}: unknown; choose one of {', '.join(LAYOUTS)}")
    joint = virtual_joint(where)
    scenario = options.scenario(joint)
    suffix = LAYOUTS[options.form].suffix
    path = output if output.suffix == suffix else output.with_name(output.name + suffix)
    names = (path.name, path.with_suffix(".toml").name)
    with new_outputs(path.parent, "rig closed-loop", force=force, names=names) as staged:
        run = run_loop(joint.parameters, joint.bench, scenario, _controller(controller, play))
        written = write_log(staged / path.name, options.form, run, path.stem)
        files = [rebased(file, staged, path.parent) for file in written]
    places = joint.places
    refused = {"commands_not_finite": run.commands_not_finite, "commands_clipped": run.commands_clipped}
    steps = step_metrics(run.t, run.true_q, run.target, places["right"] - places["left"])
    if len(steps) > _MOST_STEPS:  # a reference that moves has no steps
        error = run.true_q - run.target
        return files, {"joint": joint.name, "places_m": places, "steps": [], "rms_m": rms(error), **refused}
    return files, {"joint": joint.name, "places_m": places, "steps": [asdict(step) for step in steps], **refused}
