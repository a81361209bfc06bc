"""What a person waits for, as one table beside what other tools take: processor time unless said otherwise.

    python benchmarks/bench_speed.py [--only WORD …]

Every row is a process of its own with warm kernels, except the first. The logs are written here by the virtual rig (a
joint of `same` physics, two logs of 37.5 s at 30 kHz), so nothing else is needed. `--only` takes words of the rows'
names.
"""

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HOME))
from pipeline.machine import settle_machine  # noqa: E402

settle_machine()
_DEBIST = [sys.executable, "-c", "from cli import app; app()"]
_INSIDE = """
import json, statistics, sys, time
from pathlib import Path
from pipeline.api import open_run
from pipeline.machine import settle_machine
settle_machine()
import numpy as np
run = Path(sys.argv[1])

def spent(work, repeats=5):
    work()
    times = []
    for _ in range(repeats):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return statistics.median(times)
"""
_CALIBRATION = (
    _INSIDE
    + """
from pipeline.joint.calibration import ASYMMETRIC_NAMES, FRICTION_NAMES, calibrate
from pipeline.joint.parameters import NOMINAL
from pipeline.loading.trajectories import trajectories
from pipeline.runs.tables import read_table
motions = trajectories(read_table(next(run.glob("train/*/kinematics.parquet"))))
names = ASYMMETRIC_NAMES + FRICTION_NAMES
print(spent(lambda: calibrate(motions, NOMINAL, np.random.default_rng(0), names=names), 1))
"""
)
_FREE_RUN = (
    _INSIDE
    + """
from pipeline.models.store import load_model
from pipeline.runs.tables import read_table
table = read_table(next(run.glob("validation/*/signals.parquet")))
model = load_model(run / "model.h5")
t, v = table["t"], np.stack([table["v1"], table["v2"]], axis=1)
known = int(np.flatnonzero(np.isfinite(table["q"]))[0])
print(spent(lambda: model.simulate(t, v, float(table["q"][known]), 0.0), 15))
"""
)


def cost(command: list[str], **surroundings: str) -> float:
    """Processor time [s] of a command and all that it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = os.environ | {"PYTHONPATH": str(HOME)} | surroundings
    subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def told(program: str, run: Path) -> float:
    """What a program that measures itself prints [s]."""
    made = [sys.executable, "-c", program, str(run)]
    done = subprocess.run(made, check=True, env=os.environ | {"PYTHONPATH": str(HOME)}, stdout=subprocess.PIPE)
    return float(done.stdout)


class Bench:
    """The folder in which everything lies, and the runs that several rows use."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        rig = [*_DEBIST, "rig", "fleet", "1", "--seed", "20261121", "--rate", "30000", "--format", "mat"]
        cost([*rig, "-o", str(folder / "fleet")])
        self.prototype = next((folder / "fleet").glob("**/*.toml"))
        self.default = folder / "default"
        text = self.prototype.read_text(encoding="utf-8").split("[compare]")[0] + "\n[compare]\nmodels = []\n"
        self.lean = self.prototype.with_name("lean.toml")
        self.lean.write_text(text, encoding="utf-8")
        cost([*_DEBIST, "run", str(self.lean), "-o", str(self.default), "--no-report"])

    def first_run(self) -> float:
        """What compiling adds to a run of everything."""
        cache = self.folder / "kernels"
        cold = cost([*_DEBIST, "run", str(self.prototype), "-o", str(self.folder / "cold")], NUMBA_CACHE_DIR=str(cache))
        warm = cost([*_DEBIST, "run", str(self.prototype), "-o", str(self.folder / "warm")], NUMBA_CACHE_DIR=str(cache))
        return cold - warm

    def whole_run(self) -> float:
        return cost([*_DEBIST, "run", str(self.prototype), "-o", str(self.folder / "whole")])

    def identification(self) -> float:
        manifest = json.loads((self.default / "manifest.json").read_text(encoding="utf-8"))
        return float(sum(_fits(manifest)))

    def prototype_of_a_fleet(self) -> float:
        """With the default model, no baselines and no report: eight of them in one batch."""
        many = self.folder / "many"
        many.mkdir()
        for i in range(8):
            text = self.lean.read_text(encoding="utf-8")
            name = f"M{i}"
            lines = [f'name = "{name}"' if line.startswith("name") else line for line in text.splitlines()]
            shutil.copytree(self.lean.parent, many / name, ignore=shutil.ignore_patterns("*.toml"))
            (many / name / f"{name}.toml").write_text("\n".join(lines), encoding="utf-8")
        runs = self.folder / "runs"
        return cost([*_DEBIST, "batch", str(many), "-o", str(runs), "--jobs", "1", "--no-report"]) / 8


def _fits(document: object) -> list[float]:
    """Every ``fit_s`` of a manifest."""
    if isinstance(document, dict):
        own = [float(document["fit_s"])] if "fit_s" in document else []
        return own + [x for value in document.values() for x in _fits(value)]
    return [x for value in document for x in _fits(value)] if isinstance(document, list) else []


Row = tuple[str, Callable[[Bench], float], float, str, float | None]
ROWS: list[Row] = [
    ("first run: compilation of all kernels it uses [s]", Bench.first_run, 8.0, "", None),
    ("debist run, two 30 kHz logs, all baselines, page [s]", Bench.whole_run, 15.0, "", None),
    ("calibration of the analytical joint, one log [s]", lambda b: told(_CALIBRATION, b.default), 4.0, "", None),
    ("default identification, one log [s]", Bench.identification, 4.0, "", None),
    ("free run of 37.5 s [ms]", lambda b: 1e3 * told(_FREE_RUN, b.default), 5.0, "solve_ivp RK45 at 1e-6", 706.0),
    ("prototype of a fleet, default model [s]", Bench.prototype_of_a_fleet, 9.0, "", None),
    ("100,000 prototypes [core hours]", Bench.prototype_of_a_fleet, 250.0, "", None),
]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="+", default=[""], help="words of the rows' names")
    options = parser.parse_args()
    folder = Path(tempfile.mkdtemp())
    known: dict[Callable[[Bench], float], float] = {}
    try:
        bench = Bench(folder)
        print(f"{'work':58} {'measured':>9} {'to reach':>9} {'other tool':>11} {'ratio':>7}")
        for name, work, goal, tool, takes in ROWS:
            if not any(word in name for word in options.only):
                continue
            value = known.setdefault(work, -1.0)
            if value < 0.0:
                value = known[work] = work(bench)
            value *= 1e5 / 3600.0 if "core hours" in name else 1.0
            other = f"{takes:11.0f} {takes / value:6.0f}×  {tool}" if takes else ""
            print(f"{name:58} {value:9.3g} {goal:9.3g} {other}", flush=True)
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
