"""Folders as the rig leaves them: raw logs of a prototype, its TOML, and beside them the truth; and the demo's.

The demo is a recording that comes with the program, so no kernel of the rig is compiled: the paper's experiment on a
drawn joint of the analytical model's physics. `tests/rig/record_demo.py` records it anew.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Literal, cast, get_args

import numpy as np
from pydantic import Field, model_validator

from ..errors import InputError
from ..settings.logs import Number, Role, SettingsTable, Whole
from ..store.atomic import write_text
from ..store.outputs import beside, new_outputs
from .bench import RATE, Bench, BenchRecord, Readings, random_bench, record
from .excitation import DURATION, EXCITATIONS, Sequence, command, load_sequence, random_excitation
from .joint import wells
from .log import LAYOUTS, Fault, FaultKind, inject_faults
from .parameters import RigParameters, as_json, nominal, sized, table1
from .random_joint import Drift, Family, aged, random_joint

Kind = Literal["same", "foreign", "worn", "nominal", "table1"]

TRUTH_INTERVAL = 1e-3  # s
_RATE_STEP = 2000.0  # Hz: the joint's time step must be a whole number of samples
_CROSSINGS = 6  # through q = 0, the least that a log shall show
_MAX_TRIES = 20
_BEAM_SHARE = 0.25  # of the beam's mass that moves with the frame, about

_DRAWINGS = {"nominal": nominal, "table1": table1}
INTERVAL = 1e-3
"""Interval of the recording [s]."""
_MORE = """\
parameters = "nominal"  # the drawing, from which the simulated joint differs by workshop tolerances

[compare]
models = ["analytical", "sindy", "narx"]
"""
STEPS = {"q": 0.3e-6, "v1": 0.2, "v2": 0.2}
"""Resolution of the recorder [m, V]: a third of the instruments' noise."""


class ExperimentFile(SettingsTable):
    """Rare settings of an experiment: the TOML file of `debist rig simulate --experiment`."""

    training_logs: Whole = Field(default=1, ge=1, le=99)
    """Number of training logs."""
    validation_logs: Whole = Field(default=1, ge=0, le=99)
    """Number of validation logs."""
    excitation: str | None = None
    """pulses, alternating (the paper's), chirps, both, steps, multisine, mixed, training or validation; left out, that
    of the log's role."""
    play: str | None = None
    """Voltages for the training logs: a CSV or MAT file in V, relative to this file."""
    faults: tuple[FaultKind, ...] = ()
    """Faults that each log gets."""
    charging_time_s: Number = Field(default=0.0, ge=0.0, le=1.0)
    """Time constant of each membrane behind its electrodes."""
    size: Number = Field(default=1.0, ge=0.2, le=5.0)
    """Factor on the joint's lengths, which moves alike."""
    age_days: Number | None = Field(default=None, ge=0.0, le=1e5)
    """Age of the prototype: the same joint with other logs."""
    drift: Drift = Drift(capacitance_percent=-0.1, stiffness_percent=-0.05, charging_s=20e-6, laser_m=2e-6)
    """Changes per day, where an age is given."""


class Experiment(ExperimentFile):
    """Experiment to simulate."""

    kind: str = "same"
    """same, foreign, worn: drawn (`pipeline.rig.random_joint`); nominal, table1: the drawing itself."""
    format: str = "mat"
    """A name in `pipeline.rig.log.LAYOUTS`."""
    rate: float = RATE
    """Samples per second [Hz]."""
    duration: float = DURATION
    """Length of each log [s]."""

    @model_validator(mode="after")
    def _checked(self) -> "Experiment":
        for option, value, allowed in (
            ("--kind", self.kind, get_args(Kind)),
            ("excitation =", self.excitation or "mixed", EXCITATIONS),
            ("--format", self.format, tuple(LAYOUTS)),
        ):
            if value not in allowed:
                raise InputError(f"{option} {value}: unknown; choose one of {', '.join(allowed)}")
        if self.rate < _RATE_STEP or self.rate % _RATE_STEP:
            raise InputError(f"--rate {self.rate:g}: the rig samples at multiples of {_RATE_STEP:g} Hz")
        if not 2.0 <= self.duration <= 3600.0:
            raise InputError(f"--duration {self.duration:g}: a log lasts 2 to 3600 s")
        return self


@dataclass(frozen=True)
class SimulatedLog:
    """One simulated log: its file's stem, its excitation, its record."""

    role: Role
    stem: str
    excitation: str
    record: BenchRecord


def simulate_prototype(folder: Path, name: str, experiment: Experiment, *, seed: int) -> Path:
    """Draw a prototype from `seed`, run the experiments, write logs, ``NAME.toml`` and ``truth/``.

    A drawn prototype is drawn again until every log switches often enough and none reaches the laser's rail, as an
    operator would choose the prototypes worth recording. All of it follows from `seed`.

    Parameters
    ----------
    folder : Path
        Folder of its files.
    name : str
        Name of the prototype.
    experiment : Experiment
        The experiment.
    seed : int
        Seed of all draws.

    Returns
    -------
    Path
        The prototype's TOML.

    Raises
    ------
    InputError
        No usable draw, a sequence to play that cannot be read, or files of the same names that were not written so.
    """
    rng = np.random.default_rng(seed)
    form = LAYOUTS[experiment.format]
    files = {
        role: [f"{stem}{form.suffix}" for of, stem in _planned(experiment) if of == role] for role in get_args(Role)
    }
    names = [*(file for of_role in files.values() for file in of_role), f"{name}.toml", "truth/truth.json"]
    with new_outputs(folder, "rig simulate", force=None, names=names) as staged:
        joint, bench, logs = draw(experiment, rng)
        truth = staged / "truth"
        truth.mkdir(parents=True, exist_ok=True)
        faults: dict[str, list[Fault]] = {}
        for log in logs:
            raw, faults[log.stem] = inject_faults(log.record, experiment.faults, rng)
            form.save(raw, staged / f"{log.stem}{form.suffix}")
            _write_truth(truth / f"{log.stem}.parquet", log.record, experiment.rate)
        document = {
            "seed": seed,
            "units": "SI",
            "experiment": experiment.model_dump(),
            "excitations": {log.stem: log.excitation for log in logs},
            "wells_m": wells(joint),
            "joint": as_json(joint),
            "bench": asdict(bench),
            "faults": {stem: [asdict(fault) for fault in injected] for stem, injected in faults.items()},
        }
        (truth / "truth.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8", newline="\n")
        drawing = 'parameters = "nominal"\n' if experiment.size == 1.0 else ""  # of another size there is no drawing
        text = prototype_toml(name, moving_mass(joint), files, experiment.format, more=drawing)
        (staged / f"{name}.toml").write_text(text, encoding="utf-8", newline="\n")
    return folder / f"{name}.toml"


def simulate_fleet(folder: Path, count: int, experiment: Experiment, *, seed: int) -> Iterator[Path]:
    """Write `count` prototypes ``KIND-NN/`` below `folder`, each with its own stream of random numbers; yield TOMLs.

    With the kind ``same`` every second prototype is ``foreign``: half of a fleet must not share the model's physics.
    Otherwise as `simulate_prototype`.

    Parameters
    ----------
    folder : Path
        Folder of the prototypes' folders.
    count : int
        Number of prototypes.
    experiment : Experiment
        The experiment.
    seed : int
        Seed of all draws.
    """
    for i in range(count):
        kind = "foreign" if experiment.kind == "same" and i % 2 else experiment.kind
        name = f"{kind}-{i:02d}"
        own = np.random.SeedSequence([seed, i]).generate_state(1)[0]
        yield simulate_prototype(folder / name, name, experiment.model_copy(update={"kind": kind}), seed=int(own))


def draw(experiment: Experiment, rng: np.random.Generator) -> tuple[RigParameters, Bench, list[SimulatedLog]]:
    """A joint, its bench and its logs, drawn until they are worth recording; the drawing is taken as it is.

    A generator of an equal seed draws the same as in `simulate_prototype`.

    Raises
    ------
    InputError
        No usable draw, or a sequence to play that cannot be read.
    """
    kind = experiment.kind
    sequence = None if experiment.play is None else load_sequence(Path(experiment.play))
    for _ in range(_MAX_TRIES):
        drawn = _DRAWINGS[kind]() if kind in _DRAWINGS else random_joint(rng, cast(Family, kind))
        joint = sized(drawn, experiment.size)
        bench = random_bench(rng, rate=experiment.rate, charging=experiment.charging_time_s)
        bench = replace(bench, laser=replace(bench.laser, rail=experiment.size * bench.laser.rail))
        logs = list(_logs(joint, bench, experiment, sequence, rng))
        if kind in _DRAWINGS or all(_worth_keeping(log.record, bench) for log in logs):
            break
    else:
        raise InputError(f"no prototype worth recording among {_MAX_TRIES} draws; take another --seed")
    if experiment.age_days is None:
        return joint, bench, logs
    joint, bench = aged(joint, bench, experiment.age_days, experiment.drift)
    of_the_day = np.random.default_rng([int(rng.integers(2**32)), round(1e6 * experiment.age_days)])
    return joint, bench, list(_logs(joint, bench, experiment, sequence, of_the_day))


def _planned(experiment: Experiment) -> list[tuple[Role, str]]:
    """Role and stem of each log of an experiment."""
    counts: dict[Role, int] = {"train": experiment.training_logs, "validation": experiment.validation_logs}
    return [(role, f"{role}-{i + 1}" if i else role) for role, count in counts.items() for i in range(count)]


def _logs(
    joint: RigParameters, bench: Bench, experiment: Experiment, sequence: Sequence | None, rng: np.random.Generator
) -> Iterator[SimulatedLog]:
    """All logs of an experiment; those of training play the sequence, if there is one."""
    for role, stem in _planned(experiment):
        if sequence is not None and role == "train":
            excitation = "played"
            t = bench.clock(sequence.duration)
            u = sequence.at(t)
        else:
            excitation = experiment.excitation or ("training" if role == "train" else role)
            t = bench.clock(experiment.duration)
            u = command(random_excitation(rng, duration=experiment.duration, excitation=excitation), t)
        yield SimulatedLog(role, stem, excitation, record(joint, bench, t, u, rng))


def _worth_keeping(measured: BenchRecord, bench: Bench) -> bool:
    """True if a log visits both wells often, in proportion to its length, and stays within the laser's range."""
    wanted = _CROSSINGS * min(1.0, float(measured.t[-1]) / DURATION)
    crossings = np.count_nonzero(np.diff(np.sign(measured.true_q)))
    return bool(crossings >= wanted and np.abs(measured.q).max() < bench.laser.rail)


def _write_truth(path: Path, measured: BenchRecord, rate: float) -> None:
    """The undisturbed motion and voltages every millisecond, SI."""
    import pyarrow as pa
    from pyarrow import parquet

    every = slice(None, None, round(TRUTH_INTERVAL * rate))
    columns = {
        "t": (measured.t, "s"),
        "q": (measured.true_q, "m"),
        "qdot": (measured.true_qdot, "m/s"),
        "phi": (measured.true_phi, "rad"),
        "v1": (measured.true_v1, "V"),
        "v2": (measured.true_v2, "V"),
    }
    schema = pa.schema([pa.field(name, pa.float64(), metadata={"unit": unit}) for name, (_, unit) in columns.items()])
    parquet.write_table(
        pa.table([values[every] for values, _ in columns.values()], schema=schema), path, write_page_checksum=True
    )


def moving_mass(joint: RigParameters) -> float:
    """Mass that a user would state [kg]: that of the drawing, with the part of the beam that moves along."""
    return joint.mass + _BEAM_SHARE * joint.line_density * joint.length


def prototype_toml(name: str, mass: float, files: Mapping[str, list[str]], form: str, *, more: str = "") -> str:
    """The prototype's settings: a user's knowledge of the device, not its truth; `more` goes to ``[plant]``.

    Parameters
    ----------
    name : str
        Name of the prototype.
    mass : float
        Moving mass [kg].
    files : mapping of str to list of str
        Log files by role.
    form : str
        Layout of the logs.
    more : str
        Further lines of ``[plant]``.
    """
    logs = "\n".join(["[logs]", *(f"{role} = {json.dumps(names)}" for role, names in files.items() if names)])
    return (
        f'# Simulated by the virtual rig.\nname = "{name}"\n\n{logs}\n\n{LAYOUTS[form].toml()}\n'
        f'[plant]\nmass = {{ value = {mass:.4f}, unit = "kg" }}\ninputs = "squared"\n{more}'
    )


RECORDING = Path(__file__).with_name("assets") / "demo.npz"


def recorded() -> tuple[dict[str, Readings], str]:
    """The demo's logs, by name, and the truth behind them, as they come with the program."""
    with np.load(RECORDING) as stored:
        logs = {}
        for name in dict.fromkeys(key.partition(".")[0] for key in stored if "." in key):
            q, v1, v2 = (
                np.cumsum(stored[f"{name}.{key}"], dtype=np.int64).astype(np.float64) * step
                for key, step in STEPS.items()
            )
            logs[name] = Readings(np.linspace(0.0, (q.size - 1) * INTERVAL, q.size), q, v1, v2)
        return logs, str(stored["truth"])


def write_demo_logs(run: Path, *, force: bool = False) -> Path:
    """Write the demo's raw logs and settings beside the run folder, once; returns the settings file.

    These are ``demo.toml``, ``train.mat``, ``validation.mat`` (1 kHz, 37.5 s, ControlDesk layout), and the truth as
    ``truth.json``.

    Raises
    ------
    InputError
        Files of the same names lie there that no demo wrote.
    """
    folder = beside(run, "-rig")
    prototype = folder / "demo.toml"
    if prototype.is_file():
        return prototype
    with new_outputs(folder, "demo", force=force, names=("train.mat", "validation.mat", "truth.json")) as staged:
        logs, truth = recorded()
        for name, log in logs.items():
            LAYOUTS["mat"].save(log, staged / f"{name}.mat")
        (staged / "truth.json").write_text(f"{truth}\n", encoding="utf-8", newline="\n")
        mass = float(json.loads(truth)["moving_mass"])
        write_text(
            staged / prototype.name,
            prototype_toml("demo", mass, {name: [f"{name}.mat"] for name in logs}, "mat", more=_MORE),
        )
    return prototype
