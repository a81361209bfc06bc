"""Errors and times of the exports on runs: `python benchmarks/bench_exports.py [RUN…]`, P1 by default.

Each export runs over the run's first validation log and is compared with the model's own free run.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.io import loadmat

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "export")]

from fmu_runs import co_simulated, exchanged  # noqa: E402
from joints import OCTAVE, CompiledModel, half_steps  # noqa: E402

from pipeline.export.sources import write_matlab  # noqa: E402
from pipeline.export.subject import Subject, curve_tables  # noqa: E402
from pipeline.models.hybrid.model import HybridModel  # noqa: E402
from pipeline.models.paper.model import RbfPaperModel  # noqa: E402
from pipeline.models.rbf.model import RbfModel  # noqa: E402
from pipeline.numerics.arrays import FloatArray  # noqa: E402
from pipeline.settings.prototype import parse_prototype  # noqa: E402
from pipeline.store.run_folder import RunFolder  # noqa: E402
from pipeline.workflow.run_contents import identified_models, subject  # noqa: E402

REPEATS = 5
OCTAVE_SECONDS = 3.0  # interpreted, it runs slower than the joint

WITH_CURVES = (HybridModel, RbfModel, RbfPaperModel)


def target_rate(what: Subject, folder: Path, rate: float) -> tuple[FloatArray, float]:
    """Displacement at the samples from `step` at a rate [Hz] under the voltages of a target; time of a step [s]."""
    compiled = CompiledModel(what, folder, flags=(f"-D{what.identifier.upper()}_STEP_S={1.0 / rate!r}",))
    t = what.t - what.t[0]
    fine = np.arange(round(rate * t[-1]) + 1) / rate
    delay = compiled.realisation.delay
    v, y = compiled.array(CubicSpline(t, what.v)(np.clip(fine - delay, 0.0, t[-1]))), compiled.array(np.zeros(3))
    q, stride = np.empty(len(v)), round(rate * what.validity.sample_interval)
    compiled.call("start", *what.start, v[0])
    for n in range(len(v)):
        if n:
            compiled.call("step", v[n])
        compiled.call("read", y)
        q[n] = y[0]
    return q[::stride], step_time(what, folder)


def step_time(what: Subject, folder: Path) -> float:
    """Median processor time [s] of a step, in C."""
    name = what.identifier
    (folder / "time.c").write_text(
        f'#include <stdio.h>\n#include <time.h>\n#include "{name}.h"\n'
        f"int main(void) {{ {name}_state s; {name}_real v[2] = {{0.0, 0.0}}, y[3]; int i; clock_t began;\n"
        f"{name}_start(&s, {what.start[0]!r}, 0.0, v); began = clock();\n"
        f"for (i = 0; i < 200000; i++) {{ v[0] = 1e-2 * i; {name}_step(&s, v); }}\n"
        f'{name}_read(&s, y); printf("%.4g", (double)(clock() - began) / CLOCKS_PER_SEC / 2e5); return y[0] > 1e9; }}\n'
    )
    subprocess.run(["gcc", "-std=c99", "-O2", "time.c", f"{name}.c", "-o", "time", "-lm"], cwd=folder, check=True)
    runs = [subprocess.run([folder / "time"], capture_output=True, text=True, check=True) for _ in range(REPEATS)]
    return statistics.median(float(run.stdout) for run in runs)


def octave_run(what: Subject, folder: Path) -> tuple[FloatArray, float]:
    """Displacement from the MATLAB function under GNU Octave, and its time [s]."""
    count = round(OCTAVE_SECONDS / what.validity.sample_interval) + 1
    write_matlab(replace(what, t=what.t[:count], v=what.v[:count]), folder)
    name = what.identifier
    script = f"load {name}_data.mat; c = check; q = {name}(c.t, c.v, c.q0, c.qdot0); save -v6 found.mat q"
    began = time.perf_counter()
    subprocess.run([OCTAVE, "--norc", "--quiet", "--eval", script], cwd=folder, check=True, capture_output=True)
    return loadmat(folder / "found.mat", squeeze_me=True)["q"], time.perf_counter() - began


def lookup_run(what: Subject) -> FloatArray:
    """Displacement by m q̈ = −F(q) − d(q) q̇ + ½ C'(q) v² with the lookup tables, as Simulink would give it."""
    tables = {table["name"]: table for table in curve_tables(what)}
    assert isinstance(what.model, WITH_CURVES)
    t, mass, h = what.t - what.t[0], what.model.mass_kg, 1e-3
    fine = np.arange(2 * round(t[-1] / h) + 1) * 0.5 * h
    u = CubicSpline(t, what.v)(np.minimum(fine, t[-1])) ** 2

    def at(name: str, q: float) -> float:
        return float(np.interp(q, tables[name]["q"], tables[name]["values"]))

    def slope(x: FloatArray, u: FloatArray) -> FloatArray:
        force = 0.5 * (at("dC1_dq", x[0]) * u[0] + at("dC2_dq", x[0]) * u[1]) - at("F", x[0]) - at("d", x[0]) * x[1]
        return np.array([x[1], force / mass])

    x, q = np.array(what.start), [what.start[0]]
    for n in range(len(u) // 2):
        d1 = slope(x, u[2 * n])
        d2 = slope(x + 0.5 * h * d1, u[2 * n + 1])
        d3 = slope(x + 0.5 * h * d2, u[2 * n + 1])
        x = x + h / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + slope(x + h * d3, u[2 * n + 2]))
        q.append(float(x[0]))
    return np.array(q)[:: round(what.validity.sample_interval / h)]


def told(q: FloatArray, truth: FloatArray) -> str:
    """Largest and RMS deviation as shares of the range, over what both hold."""
    rows = min(len(q), len(truth))
    error = np.abs(q[:rows] - truth[:rows])
    span = np.nanmax(truth) - np.nanmin(truth)
    return f"largest {np.nanmax(error) / span:.1e}, RMS {np.sqrt(np.nanmean(error**2)) / span:.1e}"


def measure(what: Subject, folder: Path) -> Iterator[tuple[str, str]]:
    """Name of each export, and how far it is from the model's own run."""
    truth = what.model.simulate(what.t, what.v, *what.start).q
    yield "C, debist's own inputs", told(CompiledModel(what, folder).free_run(half_steps(what))[:, 0], truth)
    single = CompiledModel(what, folder, single=True).free_run(half_steps(what))[:, 0]
    yield "C, single precision", told(single, truth)
    for rate in (1e3, 1e4):
        q, seconds = target_rate(what, folder, rate)
        yield f"C, step at {rate:g} Hz", f"{told(q, truth)}; {1e6 * seconds:.2f} µs a step"
    yield "FMU, co-simulation", told(co_simulated(what, folder)[:, 0], truth)
    yield "FMU, model exchange", told(exchanged(what, folder), truth)
    if isinstance(what.model, WITH_CURVES):
        yield "lookup tables alone", told(lookup_run(what), truth)
    if OCTAVE:
        q, seconds = octave_run(what, folder)
        yield "MATLAB function in Octave", f"{told(q, truth)}; {seconds:.0f} s for {OCTAVE_SECONDS:g} s"


def main() -> None:
    """Print one line per run, model and export."""
    for root in map(Path, sys.argv[1:] or ["runs/P1"]):
        run = RunFolder.open(root)
        prototype = parse_prototype(run.manifest.prototype, f"{root}/manifest.json")
        for name in identified_models(run, prototype):
            with tempfile.TemporaryDirectory() as place:
                for export, error in measure(subject(run, prototype, name), Path(place)):
                    print(f"{root.name} {name:9s} {export:26s} {error}", flush=True)


if __name__ == "__main__":
    main()
