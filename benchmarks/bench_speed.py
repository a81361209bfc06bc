"""What a person waits for, as one table beside what other tools take: processor time unless said otherwise.

    python benchmarks/bench_speed.py [--only WORD …] [--page docs/reference/speed.md]

Every row is a process of its own with warm kernels, except the first two; wall times need an idle machine. The logs
of the drawn joint are written here by the virtual rig (`same` physics, two logs of 37.5 s at 30 kHz), so nothing else
is needed; rows of P1 are left out where its logs are not there. `--only` takes words of the rows' names; `--page`
writes the table between its marks into a page. Cost: 4 minutes.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import cached_property
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HOME))
from pipeline.system.machine import settle_machine  # noqa: E402

settle_machine()

from bench_batch import batch, write_fleet  # noqa: E402
from bench_compilation import costs  # noqa: E402
from measure import Cost, adopt_orphans, cost, fits, has_logs  # noqa: E402

P1 = HOME / "benchmarks" / "prototypes" / "P1.toml"
BEGIN, END = "<!-- table: benchmarks/bench_speed.py -->\n", "<!-- end of table -->\n"

_DEBIST = [sys.executable, "-c", "from cli import app; app()"]
_INSIDE = """
import sys
from pathlib import Path
from measure import seconds
from pipeline.api.run import open_run
from pipeline.system.machine import settle_machine
settle_machine()
import numpy as np
run = Path(sys.argv[1])
"""
_CALIBRATION = (
    _INSIDE
    + """
from pipeline.models.analytical.calibration import ASYMMETRIC_NAMES, FRICTION_NAMES, calibrate
from pipeline.device.parameters import NOMINAL
from pipeline.signals.log import log_of
from pipeline.store.tables import read_table
motions = log_of(read_table(next(run.glob("train/*/kinematics.parquet")))).segments()
names = ASYMMETRIC_NAMES + FRICTION_NAMES
print(seconds(lambda: calibrate(motions, NOMINAL, names=names), 1))
"""
)
_FREE_RUN = (
    _INSIDE
    + """
from pipeline.models.model_type import load_model
from pipeline.store.tables import read_table
table = read_table(next(run.glob("validation/*/signals.parquet")))
model = load_model(run / "model.h5")
t, v = table["t"], np.stack([table["v1"], table["v2"]], axis=1)
q = float(table["q"][np.flatnonzero(np.isfinite(table["q"]))[0]])
one, many = lambda: model.simulate(t, v, q, 0.0), lambda: model.simulate_draws(t, v, q, 0.0, count=32)
print(seconds(many if len(sys.argv) > 2 else one, 15))
"""
)
_SOLVE_IVP = (
    _INSIDE
    + """
from scipy.integrate import solve_ivp
t, v, centres = 0.01 * np.arange(3750), np.zeros((3750, 2)), np.linspace(-0.02, 0.02, 10)
rng = np.random.default_rng(5)
for start in np.arange(0.5, t[-1], 1.3):
    v[(t >= start) & (t < start + 0.7), rng.integers(2)] = rng.uniform(1500, 3000)
curves = np.array([8.0 * (centres / 0.012) ** 2 - 8.0, 0.1 + 5.0 * np.abs(centres),
                   4e-9 * (1.0 + 10.0 * centres), -4e-9 * (1.0 - 12.0 * centres)])

def slope(s, y):
    c, d, g1, g2 = curves @ np.exp(-((y[0] - centres) ** 2) / 3e-5)
    left, right = np.interp(s, t, v[:, 0]), np.interp(s, t, v[:, 1])
    return [y[1], (-c * y[0] - d * y[2] + g1 * left**2 + g2 * right**2) / 0.04, (y[1] - y[2]) / 0.03]

options = dict(t_eval=t, rtol=1e-6, atol=1e-9, max_step=0.01)
print(seconds(lambda: solve_ivp(slope, (0.0, t[-1]), [0.012, 0.0, 0.0], **options), 3))
"""
)


def told(program: str, run: Path, *more: str) -> float:
    """What a program that measures itself prints [s]."""
    made = [sys.executable, "-c", program, str(run), *more]
    paths = os.pathsep.join([str(HOME), str(HOME / "benchmarks")])
    done = subprocess.run(made, check=True, env=os.environ | {"PYTHONPATH": paths}, stdout=subprocess.PIPE)
    return float(done.stdout)


_DERIVATIVE = """
import sys, time
import numpy as np
from measure import seconds
from pipeline.numerics.tvregdiff import tvregdiff
t = 0.01 * np.arange(3750)
y = 9.0 * np.sin(2.0 * t) + 4.0 * np.sin(7.0 * t) + np.random.default_rng(1).normal(0.0, 3e-3, t.size)  # mm
if len(sys.argv) == 2:
    print(seconds(lambda: tvregdiff(y, 0.01, alpha=0.01), 15))
else:
    from pynumdiff.total_variation_regularization import iterative_velocity
    begin = time.process_time()
    iterative_velocity(y, 0.01, num_iterations=10, gamma=0.01, scale="small")
    print(time.process_time() - begin)
"""
_LEAST_SQUARES = """
import sys
import numpy as np
from measure import seconds
from pipeline.fitting.regression import pseudo_inverse_fit, triangular_factor
rows = np.random.default_rng(2).standard_normal((3750, 41))
ours = lambda: pseudo_inverse_fit(*triangular_factor([rows.copy()]))
theirs = lambda: np.linalg.lstsq(rows[:, :40], rows[:, 40], rcond=None)
print(seconds(ours if len(sys.argv) == 2 else theirs, 15))
"""


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

    @cached_property
    def first_run(self) -> tuple[Cost, Cost]:
        """A run of everything with no compiled kernel, and the same again."""
        cache = str(self.folder / "kernels")
        names = ("cold", "warm")
        cold, warm = (
            cost([*_DEBIST, "run", str(self.prototype), "-o", str(self.folder / name)], NUMBA_CACHE_DIR=cache)
            for name in names
        )
        return cold, warm

    @cached_property
    def p1(self) -> tuple[Path, Cost]:
        """The run of P1 with warm kernels, and its cost."""
        run = self.folder / "P1"
        return run, cost([*_DEBIST, "run", str(P1), "-o", str(run)])

    def added(self, kind: str) -> float:
        """What compiling adds to a run of everything."""
        cold, warm = self.first_run
        return float(getattr(cold, kind) - getattr(warm, kind))

    @cached_property
    def solve_ivp(self) -> float:
        """SciPy's time [s] for a run of 37.5 s of the paper's joint."""
        return told(_SOLVE_IVP, self.default)

    def report(self) -> float:
        """The page of a run with all baselines, made anew."""
        assert self.first_run
        (self.folder / "warm" / "report.html").unlink()
        return cost([*_DEBIST, "report", str(self.folder / "warm")]).processor

    def identification(self) -> float:
        """The fits of the default model on the drawn joint."""
        manifest = json.loads((self.default / "manifest.json").read_text(encoding="utf-8"))
        return float(sum(fits(manifest)))

    def identification_of_p1(self) -> float:
        """The same on P1, with `rbf-paper`, which is fitted beside it."""
        manifest = json.loads((self.p1[0] / "manifest.json").read_text(encoding="utf-8"))
        return float(sum(fits(manifest["artifacts"]["model.h5"])))

    @cached_property
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
        return cost([*_DEBIST, "batch", str(many), "-o", str(runs), "--jobs", "1", "--no-report"]).processor / 8

    def light_prototype(self) -> float:
        """With the paper's model alone, beyond its fit: twelve of them in one batch."""
        write_fleet(self.folder, 12)
        made = batch(self.folder, "light", 1)
        manifests = [json.loads(path.read_text(encoding="utf-8")) for path in self.folder.glob("light/*/manifest.json")]
        return (float(made["whole"]) - sum(fits(manifests))) / len(manifests)


Row = tuple[str, Callable[[Bench], float], float, str, Callable[[Bench], float] | None]
ROWS: list[Row] = [
    ("first run: processor time of its compilation [s]", lambda b: b.added("processor"), 30.0, "", None),
    ("debist warmup: all kernels [s]", lambda _: sum(costs().values()), 60.0, "", None),
    ("debist run of P1, two 30 kHz logs, all baselines, page [s]", lambda b: b.p1[1].processor, 15.0, "", None),
    ("debist run of the drawn joint, the same [s]", lambda b: b.first_run[1].processor, 15.0, "", None),
    ("debist report, all baselines, without the figures for a paper [s]", Bench.report, 5.0, "", None),
    (
        "TVRegDiff of 3750 samples to convergence [ms]", lambda b: 1e3 * told(_DERIVATIVE, b.folder), 0.0,
        "PyNumDiff iterative_velocity, 10 sweeps", lambda b: 1e3 * told(_DERIVATIVE, b.folder, "peer"),
    ),
    (
        "least squares, 4 × 10 RBF, 3750 samples [ms]", lambda b: 1e3 * told(_LEAST_SQUARES, b.folder), 0.0,
        "numpy.linalg.lstsq", lambda b: 1e3 * told(_LEAST_SQUARES, b.folder, "peer"),
    ),
    ("calibration of P1, one log [s]", lambda b: told(_CALIBRATION, b.p1[0]), 4.0, "", None),
    ("calibration of the drawn joint, the same [s]", lambda b: told(_CALIBRATION, b.default), 4.0, "", None),
    ("default identification of P1, one log [s]", Bench.identification_of_p1, 4.0, "", None),
    ("default identification of the drawn joint, one log [s]", Bench.identification, 4.0, "", None),
    (
        "free run of 37.5 s [ms]", lambda b: 1e3 * told(_FREE_RUN, b.default), 5.0,
        "solve_ivp RK45 at 1e-6, paper's joint", lambda b: 1e3 * b.solve_ivp,
    ),
    (
        "posterior ensemble of 32 free runs [ms]", lambda b: 1e3 * told(_FREE_RUN, b.default, "32"), 60.0,
        "32 times that", lambda b: 32e3 * b.solve_ivp,
    ),
    ("light prototype in a batch, beyond its fit [s]", Bench.light_prototype, 0.6, "", None),
    ("prototype of a fleet, default model [s]", lambda b: b.prototype_of_a_fleet, 9.0, "", None),
    ("100,000 prototypes [core hours]", lambda b: b.prototype_of_a_fleet / 0.036, 250.0, "", None),
]  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="+", default=[""], help="words of the rows' names")
    parser.add_argument("--page", type=Path, help="Markdown page that holds the table")
    options = parser.parse_args()
    folder, made = Path(tempfile.mkdtemp()), list[tuple[str, float, float, str, float]]()
    load, there = os.getloadavg()[0], has_logs(P1)
    adopt_orphans()
    try:
        bench = Bench(folder)
        print(f"{'work':60} {'measured':>9} {'to reach':>9} {'other tool':>11} {'ratio':>7}")
        for name, work, goal, tool, other in ROWS:
            if any(word in name for word in options.only) and (there or "P1" not in name):
                value, takes = work(bench), other(bench) if other else 0.0
                made.append((name, value, goal, tool, takes))
                beside = f"{takes:11.4g} {takes / value:6.2g}×  {tool}" if takes else ""
                print(f"{name:60} {value:9.3g} {goal or '':9.4} {beside}".rstrip(), flush=True)
    finally:
        shutil.rmtree(folder)
    if options.page:
        before, _, rest = options.page.read_text(encoding="utf-8").partition(BEGIN)
        text = before + BEGIN + _markdown(made, load) + END + rest.partition(END)[2]
        options.page.write_text(text, encoding="utf-8")


def _markdown(made: list[tuple[str, float, float, str, float]], load: float) -> str:
    """The table, and when and on what it was measured."""
    lines = ["| work | measured | to reach | other tool in the same run |", "|---|---|---|---|"]
    for name, value, goal, tool, takes in made:
        beside = f"{tool}: {_digits(takes, 3)}, {_digits(takes / value, 2)} times as much" if takes else ""
        lines.append(f"| {name} | {_digits(value, 3)} | {f'{goal:g}' if goal else ''} | {beside} |")
    day = time.strftime("%-d %B %Y", time.gmtime())
    lines.append(f"\nMeasured on {day} on {os.cpu_count()} processors, load average {load:.1f} when it began.\n")
    return "\n".join(lines)


def _digits(value: float, count: int) -> str:
    """So many significant digits, without an exponent."""
    return f"{float(f'{value:.{count}g}'):,.10g}"


if __name__ == "__main__":
    main()
