"""Planted errors of instruments that are found, and false ones: `python benchmarks/instruments.py FOLDER [OPTIONS]`.

Joints of three physics (`debist rig simulate --kind foreign|same|worn`) and random devices that are no joint
(`simulated_devices.py`) are simulated and identified; runs in the folder are kept. Errors are planted in the first
validation log behind ingest, and each model also gets the log of the device before. Counted are planted errors that are
beyond their limits and right to 4 standard errors or 15 %, and honest quantities that are silent and lie within 2.5
standard errors of the truth. 90 s of processor time a joint, and 20 s a model of finished runs, which `--runs RUN...`
takes instead.
"""

import argparse
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from pipeline.diagnostics.instruments import SIGNIFICANCE
from pipeline.rig.fleet import Experiment, simulate_prototype
from pipeline.settings.logs import Role
from pipeline.settings.prototype import load_prototype
from pipeline.signals.log import Corrections, Log, corrected, exchanged, mirrored
from pipeline.signals.noise import noise_std
from pipeline.store import layout
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.engine import Unheard, bring_up_to_date
from pipeline.workflow.run import Planned, of_stages, plan
from pipeline.workflow.run_contents import identified_models, load_motion, load_run_model
from pipeline.workflow.stage_instruments import instrument_rows

KINDS = ("foreign", "same", "worn")
STAGES = ("ingest", "differentiate", "identify")
HERE = Path(__file__).resolve().parent
ALIKE, RIGHT = 2.5, 0.15


@dataclass(frozen=True)
class Case:
    """A validation log with planted errors of its readings, and what of it is taken.

    Attributes
    ----------
    v1, v2, q : float
        Reading over truth.
    zero : float
        Reading less truth [m].
    delay : float
        Time [s] by which the inputs are recorded later than they acted.
    clock : float
        Recorded over true time.
    noise : float
        Factor on the noise of q.
    seconds : float or None
        How much of the log is taken; None: all of it.
    """

    v1: float = 1.0
    v2: float = 1.0
    q: float = 1.0
    zero: float = 0.0
    delay: float = 0.0
    clock: float = 1.0
    noise: float = 1.0
    seconds: float | None = None

    @property
    def truth(self) -> dict[str, float]:
        """Errors of the readings by quantity."""
        gains = {"gain_v1": self.v1, "gain_v2": self.v2, "gain_q": self.q, "clock": self.clock}
        errors = {name: gain - 1.0 for name, gain in gains.items()}
        return errors | {"zero_q": self.zero, "delay": self.delay}

    def planted_in(self, log: Log, rng: np.random.Generator) -> Log:
        """A log with these errors."""
        if self.seconds is not None:
            log = log.part(0, round(self.seconds / log.interval))
        more = noise_std(log.known_q) * np.sqrt(self.noise**2 - 1.0)
        noisy = replace(log, q=log.q + more * rng.standard_normal(len(log.q)))
        gains = (self.v1, self.v2)[: log.v.shape[1]]
        return corrected(noisy, Corrections(gains, self.zero, self.q, self.delay, self.clock))


BARS = {
    "as recorded": Case(),
    "v1 +3 %, v2 −2 %": Case(v1=1.03, v2=0.98),
    "zero 0.1 mm": Case(zero=1e-4),
    "gain of q 2 %": Case(q=1.02),
    "delay 2.5 ms": Case(delay=2.5e-3),
    "clock 1 %": Case(clock=1.01),
}
REACH = {
    "v1 −10 %, v2 −10 %": Case(v1=0.9, v2=0.9),
    "30 ms late": Case(delay=0.03),
    "clock 2 % with v1 −5 %": Case(v1=0.95, clock=1.02),
    "v1 +3 %, v2 −3 %": Case(v1=1.03, v2=0.97),
    "gain of q 3 %, clock 3 %": Case(q=1.03, clock=1.03),
    "v1 −5 %, 5 ms late": Case(v1=0.95, delay=5e-3),
    **{f"{n} s: as recorded": Case(seconds=n) for n in (5, 8, 20)},
    **{f"{n} s: v1 +3 %, 2.5 ms late": Case(v1=1.03, delay=2.5e-3, seconds=n) for n in (5, 8, 20)},
    "ten times the noise: as recorded": Case(noise=10.0),
    "ten times the noise: v1 +3 %, zero 0.1 mm": Case(v1=1.03, zero=1e-4, noise=10.0),
}
DEVICE = {
    "as recorded": Case(),
    "input +5 %": Case(v1=1.05),
    "gain of q 3 %": Case(q=1.03),
    "one interval late": Case(delay=0.01),
    "clock 2 %": Case(clock=1.02),
}


@dataclass
class Tally:
    """Counts over logs."""

    planted: int = 0
    found: int = 0
    honest: int = 0
    silent: int = 0
    within: int = 0
    ratios: list[float] = field(default_factory=list)
    missed: list[str] = field(default_factory=list)

    def add(self, rows: list[dict[str, Any]], truth: Mapping[str, float], where: str) -> None:
        """Rows of one log by one model."""
        for row in rows:
            wanted = truth[row["quantity"]]
            measured = row["status"] == "measured"
            off = abs(row["estimate"] - wanted) if measured else np.inf
            if wanted:
                self.planted += 1
                right = measured and off <= max(SIGNIFICANCE * row["standard_error"], RIGHT * abs(wanted))
                self.found += bool(row["beyond"] and right)
                if not (row["beyond"] and right):
                    self.missed.append(f"{where} {row['quantity']} {row['status']}")
            else:
                self.honest += 1
                self.silent += not row["beyond"] and measured
                self.within += measured and off <= ALIKE * row["standard_error"]
        self.ratios += [rows[0]["residual_ratio"]] if rows and rows[0]["residual_ratio"] is not None else []

    @property
    def cells(self) -> str:
        """Cells of a row of the table."""
        found = f"{self.found} of {self.planted}" if self.planted else ""
        share = f"{self.silent} of {self.honest}" if self.honest else ""
        within = f"{100 * self.within / self.honest:.0f} %" if self.honest else ""
        ratio = f"{max(self.ratios):.1f}" if self.ratios else ""
        return f"{found} | {share} | {within} | {ratio}"


def joint(folder: Path, kind: str, seed: int) -> Path:
    """A run of a joint; it is kept."""
    home = folder / f"{kind}-{seed}"
    if not (home / "run" / layout.MODELS).exists():
        experiment = Experiment(kind=kind, format="parquet", rate=2000.0, validation_logs=2)
        settings = simulate_prototype(home, home.name, experiment, seed=seed)
        _run(home, settings, '[identify]\nmodels = ["auto", "rbf"]\n')
    return home / "run"


def device(folder: Path, seed: int) -> Path:
    """A run of a device that is no joint; it is kept."""
    home = folder / f"simulated-{seed}"
    if not (home / "run" / layout.MODELS).exists():
        subprocess.run([sys.executable, str(HERE / "simulated_devices.py"), str(folder), str(seed)], check=True)
        _run(home, home / "device.toml", "")
    return home / "run"


def _run(home: Path, settings: Path, more: str) -> None:
    """Run the settings with more of them, up to the identified models."""
    path = home / "cases.toml"
    path.write_text(settings.read_text(encoding="utf-8") + "\n" + more, encoding="utf-8")
    prototype = load_prototype(path)
    run = RunFolder.create(home / "run", prototype.model_dump(mode="json"), path)
    bring_up_to_date(run, of_stages(plan(Planned(run, prototype, path)), STAGES), Unheard())


def of_run(run: Path, other: Path | None, cases: Mapping[str, Case]) -> list[dict[str, Any]]:
    """Rows of the cases, planted in the first validation log of a finished run, and of the log of another run."""
    logs = {log: each for log, each in _logs(run).items() if log[0] == "train"}
    clean = _first_validation(run)
    for number, case in enumerate(cases.values()):
        logs["validation", f"case{number}"] = case.planted_in(clean, np.random.default_rng(number))
    logs["validation", "mirrored"] = mirrored(clean)
    if clean.v.shape[1] > 1:
        logs["validation", "exchanged"] = exchanged(clean)
    if other is not None:
        logs["validation", "other"] = _first_validation(other)
    nothing = dict.fromkeys(logs, Corrections((1.0,) * clean.v.shape[1]))
    folder = RunFolder.open(run)
    main, *more = identified_models(folder, folder.prototype)
    models = [main, *(name for name in more if name == "rbf")]
    return [
        row for name in models for row in instrument_rows(load_run_model(folder, folder.prototype, name), logs, nothing)
    ]


def _logs(run: Path) -> dict[tuple[Role, str], Log]:
    folder = RunFolder.open(run)
    prototype = folder.prototype
    return {(role, log): load_motion(folder, prototype, role, log) for role, log, _ in layout.logs(prototype)}


def _first_validation(run: Path) -> Log:
    return next(each for (role, _), each in _logs(run).items() if role == "validation")


def tallies(runs: Mapping[str, list[dict[str, Any]]], cases: Mapping[str, Case]) -> Iterator[tuple[str, str, Tally]]:
    """Main model or rbf, case, and counts over the rows of these runs."""
    counted: dict[tuple[str, str], Tally] = defaultdict(Tally)
    special: dict[tuple[str, str], list[str]] = defaultdict(list)
    for run, rows in runs.items():
        main = rows[0]["model"]
        for model in dict.fromkeys(row["model"] for row in rows):
            roles = [name for name, of in (("main", main), ("rbf", "rbf")) if model == of]
            own = [row for row in rows if row["model"] == model and row["role"] == "validation"]
            for role in roles:
                for number, (name, case) in enumerate(cases.items()):
                    of_log = [row for row in own if row["log"] == f"case{number}"]
                    counted[role, name].add(of_log, case.truth, f"{run} {model}")
                for name in ("mirrored", "exchanged", "other"):
                    of_log = [row for row in own if row["log"] == name]
                    if of_log:
                        special[role, name].append(f"{of_log[0]['exchanged']}/{of_log[0]['status']}")
    for (role, name), tally in counted.items():
        yield role, name, tally
    for (role, name), answers in special.items():
        print(f"{role}: {name}: " + ", ".join(f"{answers.count(a)} {a}" for a in dict.fromkeys(answers)))


def show(title: str, runs: Mapping[str, list[dict[str, Any]]], cases: Mapping[str, Case]) -> None:
    print(f"\n{title}: {len(runs)}")
    print(
        "| model | log | planted errors found | honest quantities silent | within 2.5 s.e. | largest residual ratio |"
    )
    print("|---|---|---|---|---|---|")
    missed = []
    for role, name, tally in tallies(runs, cases):
        print(f"| {role} | {name} | {tally.cells} |", flush=True)
        missed += [f"{role}: {name}: {text}" for text in tally.missed]
    print("missed:", *(missed or ["none"]), sep="\n  ")


def rows_of(runs: Sequence[Path], cases: Mapping[str, Case]) -> dict[str, list[dict[str, Any]]]:
    """Rows of the cases in each run, which also gets the log of the run before."""
    rows = {}
    for run, before in zip(runs, (None, *runs), strict=False):
        rows[str(run)] = of_run(run, before, cases)
        print(f"{run} done", file=sys.stderr, flush=True)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("--runs", type=Path, nargs="*", default=[])
    parser.add_argument("--joints", type=int, default=5, help="of each physics")
    parser.add_argument("--devices", type=int, default=6)
    parser.add_argument("--seed", type=int, default=741_000)
    given = parser.parse_args()
    joints = list(given.runs)
    devices = list[Path]()
    if not joints:
        seeds = [(kind, given.seed + 100 * k + i) for k, kind in enumerate(KINDS) for i in range(given.joints)]
        joints = [joint(given.folder, kind, seed) for kind, seed in seeds]
        devices = [device(given.folder, seed) for seed in range(201, 201 + given.devices)]
    show("joints", rows_of(joints, BARS | REACH), BARS | REACH)
    if devices:
        show("devices that are no joint", rows_of(devices, DEVICE), DEVICE)


if __name__ == "__main__":
    main()
