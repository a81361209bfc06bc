"""Closed loop: a designed controller on a virtual joint, from files to a raw log with the reference in it."""

import json
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Literal, cast, get_args

import numpy as np
from pydantic import Field

from ...control.controller import begin_control, control
from ...control.law import CONTROLLER_STATE, Law
from ...errors import InputError
from ...numerics.arrays import FloatArray
from ...numerics.metrics import rms, step_metrics
from ...rig.bench import Bench, random_bench
from ...rig.excitation import MAX_VOLTAGE, load_sequence
from ...rig.joint import saddle, tip_displacement, wells
from ...rig.log import LAYOUTS
from ...rig.loop import ClosedLoop, Controller, Scenario, bench_from_json, played, run_loop
from ...rig.parameters import RigParameters, from_json, nominal, table1
from ...rig.random_joint import Family, random_joint
from ...rig_logs import read_recording
from ...settings.logs import Number, SettingsTable, Whole
from ...store.outputs import beside, new_outputs, rebased
from ...store.run_folder import RunFolder
from ...units.units import parse_quantity, to_si
from ..run_contents import load_design

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
        return VirtualJoint(f"{kind}-{seed}", random_joint(rng, cast(Family, kind)), random_bench(rng))
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
        time = log.channel("time")
        target = log.channel("target")
        scale = to_si(target.unit, ("m",), f"{path}: target").factor if target.unit else 1.0
        if time.samples.size < 1 or np.any(np.diff(time.samples) <= 0.0) or not np.isfinite(target.samples).all():
            raise InputError(f"{path}: a reference needs times that advance and targets that are finite")
        return time.samples - time.samples[0], scale * target.samples
    steps = []
    for part in text.split(","):
        at, colon, value = part.rpartition(":")
        place = joint.places.get(value.strip())
        when = parse_quantity(at, ("s",), "--target") if colon else 0.0
        if place is None and not any(letter.isdigit() for letter in value):
            raise InputError(f"--target: no place is called {value!r}; give left, right, saddle, or a length as 2mm")
        steps.append((when, parse_quantity(value, ("m",), "--target") if place is None else place))
    t, target = np.array(steps).T
    if np.any(np.diff(t) <= 0.0) or t[0] < 0.0:
        raise InputError(f"--target {text}: the times must rise from 0 s on")
    return (t, target) if t[0] == 0.0 else (np.insert(t, 0, 0.0), np.insert(target, 0, joint.places["left"]))


def designed(law: Law) -> Controller:
    """The controller of this law in Python, which equals the exported one."""
    s = np.zeros(CONTROLLER_STATE)
    v = np.zeros(2)

    def made(q: float) -> Any:
        """The controller at a first reading."""
        begin_control(q, law, s)

        def step(q: float, target: float) -> tuple[float, float]:
            """One period."""
            control(s, q, target, law, v)
            return float(v[0]), float(v[1])

        return step

    return made


def _controller(run: Path | None, play: Path | None) -> Controller:
    if run is not None:
        return designed(Law.from_json(load_design(RunFolder.open(run))["law"]))
    assert play is not None  # noqa: S101
    loaded = load_sequence(play)
    return played(loaded.t, loaded.u)


def write_log(path: Path, form: str, run: ClosedLoop, name: str) -> list[Path]:
    """Write a run as a raw log with the reference, and the settings with which debist reads it, beside one another.

    Parameters
    ----------
    path : Path
        The log.
    form : str
        Layout of the log.
    run : ClosedLoop
        The run.
    name : str
        Name of the prototype.

    Returns
    -------
    list of Path
        The log and ``NAME.toml``.
    """
    layout = LAYOUTS[form]
    unit = layout.v1[1]
    more = {
        ("target", layout.q[1]): run.target,
        ("command_left", unit): run.command1,
        ("command_right", unit): run.command2,
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    layout.save(run, path, more)
    toml = path.with_suffix(".toml")
    head = f'# Simulated by the virtual rig in closed loop.\nname = "{name}"\n\n[logs]\ntrain = ["{path.name}"]\n\n'
    plant = '[plant]\ninputs = "squared"\nparameters = "nominal"\n'
    toml.write_text(f"{head}{layout.toml()}\n{plant}", encoding="utf-8", newline="\n")
    return [path, toml]


class TipForce(SettingsTable):
    """A force on the tip."""

    start_s: Number = Field(ge=0.0)
    """Start [s]."""
    force_N: Number
    """Size: of a hand the greatest, of a table the amplitude [N]."""
    length_s: Number = Field(gt=0.0)
    """Length [s]."""


class Shake(TipForce):
    """A force that swings."""

    frequency_Hz: Number = Field(gt=0.0)
    """Frequency [Hz]."""


class Loss(SettingsTable):
    """A time without readings."""

    start_s: Number = Field(ge=0.0)
    """Start [s]."""
    length_s: Number = Field(gt=0.0)
    """Length [s]."""


class ScenarioFile(SettingsTable):
    """Rare settings of a closed loop: the TOML file of `debist rig closed-loop --scenario`."""

    start: Literal["left", "right"] | None = None
    """Well in which the joint rests at first; left out, the one nearest to the first target."""
    format: Literal["mat", "mf4", "csv", "csv-de", "parquet"] = "mat"
    """Form of the log."""
    lag_s: Number | None = Field(default=None, gt=0.0)
    """Time constant of the converters; left out, the joint's."""
    highest_V: Number = Field(default=MAX_VOLTAGE, gt=0.0)
    """Largest voltage of the converters."""
    pushes: tuple[TipForce, ...] = ()
    """Constant forces on the tip."""
    hands: tuple[TipForce, ...] = ()
    """Forces that rise and fall, as a hand pushes and lets go."""
    shakes: tuple[Shake, ...] = ()
    """Forces that swing, as of a table that shakes."""
    drag_N: Number = Field(default=0.0, ge=0.0)
    """Force of a wire that is dragged along."""
    friction: Number = Field(default=1.0, ge=0.0)
    """Factor on the joint's own friction."""
    lost: tuple[Loss, ...] = ()
    """Times at which the laser gives no value."""
    frozen: tuple[Loss, ...] = ()
    """Times at which the laser gives its last value."""
    barrier_percent: Number = Field(default=0.0, gt=-100.0, lt=1000.0)
    """Change of the energy barrier to the end of the run."""
    noise: Number = Field(default=1.0, ge=0.0)
    """Factor on the laser's noise."""
    seed: Whole = Field(default=1, ge=0)
    """Draws the noise."""

    def check_times(self, duration: float) -> None:
        """Refuse an event that begins after the end of a run of this length [s]."""
        for name in ("pushes", "hands", "shakes", "lost", "frozen"):
            for event in getattr(self, name):
                if event.start_s >= duration:
                    raise InputError(
                        f"{name}: at {event.start_s:g} s the run is over; raise --duration, which is {duration:g} s"
                    )

    def scenario(self, joint: VirtualJoint, target: str, duration: float) -> Scenario:
        """The scenario on a joint, with its target as `parse_target` reads it and its length [s]."""
        t, places = _checked_target(target, joint, duration)
        self.check_times(duration)
        nearer = min(("left", "right"), key=lambda well: abs(places[0] - joint.places[well]))
        return Scenario(
            t=t,
            target=places,
            duration=duration,
            side=-1 if (self.start or nearer) == "left" else 1,
            highest=self.highest_V,
            lag=self.lag_s,
            pushes=tuple((push.start_s, push.force_N, push.length_s) for push in self.pushes),
            hands=tuple((push.start_s, push.force_N, push.length_s) for push in self.hands),
            shakes=tuple((s.start_s, s.force_N, s.frequency_Hz, s.length_s) for s in self.shakes),
            lost=tuple((loss.start_s, loss.length_s) for loss in self.lost),
            frozen=tuple((loss.start_s, loss.length_s) for loss in self.frozen),
            drag=self.drag_N,
            friction=self.friction,
            barrier=0.01 * self.barrier_percent,
            noise=self.noise,
            seed=self.seed,
        )


def _checked_target(text: str, joint: VirtualJoint, duration: float) -> tuple[FloatArray, FloatArray]:
    """Times [s] and targets [m] that lie within the run and near the joint's wells."""
    t, target = parse_target(text, joint)
    places = joint.places
    reach = 0.25 * (places["right"] - places["left"])
    low = places["left"] - reach
    high = places["right"] + reach
    if target.min() < low or target.max() > high:
        raise InputError(
            f"--target: from {1e3 * target.min():.1f} to {1e3 * target.max():.1f} mm; this joint's wells lie at "
            f"{1e3 * places['left']:.1f} and {1e3 * places['right']:.1f} mm, and targets from {1e3 * low:.1f} to "
            f"{1e3 * high:.1f} mm make sense"
        )
    if not 0.1 <= duration <= 3600.0:
        raise InputError(f"--duration {duration:g} s: a run lasts 0.1 to 3600 s")
    if t[-1] >= duration and not Path(text).is_file():
        raise InputError(f"--target: at {t[-1]:g} s the run is over; raise --duration, which is {duration:g} s")
    return t, target


def closed_loop_log(
    where: str,
    controller: Path | None,
    play: Path | None,
    output: Path,
    *,
    target: str,
    duration: float,
    options: ScenarioFile,
) -> tuple[list[Path], dict[str, Any]]:
    """Run the controller of a run, or play a sequence, on a joint and write the log, as `debist rig closed-loop`.

    Parameters
    ----------
    where : str
        The joint, as `virtual_joint` reads it.
    controller, play : Path or None
        Run whose controller acts, or file of a sequence that is played; one of them.
    output : Path
        The log; its ending follows the format.
    target : str
        Reference, as `parse_target` reads it.
    duration : float
        Length [s].
    options : ScenarioFile
        The rare settings.

    Returns
    -------
    files : list of Path
        The log and its settings.
    summary : dict
        Metrics of every step of the target, from the joint's true motion (SI).
    """
    if (controller is None) == (play is None):
        raise InputError("give either --controller or --play")
    joint = virtual_joint(where)
    scenario = options.scenario(joint, target, duration)
    suffix = LAYOUTS[options.format].suffix
    path = output if output.suffix == suffix else beside(output, suffix)
    names = (path.name, path.with_suffix(".toml").name)
    with new_outputs(path.parent, "rig closed-loop", force=None, names=names) as staged:
        run = run_loop(joint.parameters, joint.bench, scenario, _controller(controller, play))
        written = write_log(staged / path.name, options.format, run, path.stem)
    places = joint.places
    steps = step_metrics(run.t, run.true_q, run.target, places["right"] - places["left"])
    moves = len(steps) > _MOST_STEPS  # a reference that moves has no steps
    followed = {"steps": [], "rms_m": rms(run.true_q - run.target)} if moves else {"steps": list(map(asdict, steps))}
    return [rebased(file, staged, path.parent) for file in written], {
        "joint": joint.name,
        "places_m": places,
        **followed,
        "commands_not_finite": run.commands_not_finite,
        "commands_clipped": run.commands_clipped,
    }
