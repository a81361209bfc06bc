"""Rivals side by side: `python benchmarks/bench_rivals.py [RUN …] [--models NAME …] [--form markdown|text|latex]`.

Fits every rival to the training kinematics of a run (the demo's if none is given), simulates every log freely and
prints, per run: the NRMSE table with bootstrap intervals and processor times, the times of the switches, the error
by horizon, and the equations that SINDy found.  Imports and the compilation of kernels are not in the times; a GRU
is trained if PyTorch is there and `gru` is asked for.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(threads, "1")

import numpy as np  # noqa: E402 - after the number of threads
import pysindy  # noqa: E402, F401 - its 2.7 s of import are no part of a fit
import sklearn.linear_model  # noqa: E402, F401 - likewise

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from pipeline.artifacts.run_folder import RunFolder  # noqa: E402 - after the path to it
from pipeline.models.analytical import AnalyticalModel, calibrate_analytical  # noqa: E402
from pipeline.models.gru import identify_gru  # noqa: E402
from pipeline.models.narx import identify_narx  # noqa: E402
from pipeline.models.rbf_paper import identify_rbf_paper  # noqa: E402
from pipeline.models.sindy import SindyModel, identify_default_sindy, identify_sindy  # noqa: E402
from pipeline.numerics.identification.trajectory import Trajectory  # noqa: E402
from pipeline.numerics.metrics import signal_range  # noqa: E402
from pipeline.numerics.scoring.horizons import horizon_error  # noqa: E402
from pipeline.numerics.scoring.moving_blocks import BLOCK, rms_difference_interval  # noqa: E402
from pipeline.numerics.scoring.scores import score_run  # noqa: E402
from pipeline.numerics.scoring.step_response import response_errors  # noqa: E402
from pipeline.numerics.scoring.wells import Wells, find_wells  # noqa: E402
from pipeline.reporting.tables import nrmse_table, render  # noqa: E402
from pipeline.settings import Prototype  # noqa: E402
from pipeline.stages import layout  # noqa: E402
from pipeline.stages.device import Device, device  # noqa: E402
from pipeline.stages.joint_parameters import joint_parameters  # noqa: E402
from pipeline.stages.predict import free_run  # noqa: E402
from pipeline.stages.trajectories import trajectories, voltages  # noqa: E402

HORIZONS = (0.01, 0.1, 1.0)
QUICK = ["rbf-paper", "sindy", "sindy-default", "narx"]

Fit = Callable[[Sequence[Trajectory], Device, Any], Any]
FITS: dict[str, Fit] = {
    "rbf-paper": lambda data, plant, joint: identify_rbf_paper(data, inputs=plant.action, mass=plant.mass),
    "sindy": lambda data, plant, joint: identify_sindy(
        data, inputs=plant.action, angle=plant.displacement.symbol == "rad"
    ),
    "sindy-default": lambda data, plant, joint: identify_default_sindy(data, inputs=plant.action),
    "narx": lambda data, plant, joint: identify_narx(data, inputs=plant.action),
    "gru": lambda data, plant, joint: identify_gru(data, inputs=plant.action),
    "analytical": lambda data, plant, joint: AnalyticalModel(joint),
    "analytical-calibrated": lambda data, plant, joint: calibrate_analytical(data, joint),
}


def demo_run(folder: Path) -> Path:
    """The kinematics of the demo's logs, made by the command itself."""
    from pipeline.rig.demo import write_demo

    command = str(Path(sys.executable).with_name("debist"))
    prototype, run = write_demo(folder / "rig"), folder / "run"
    subprocess.run([command, "ingest", str(prototype), "-o", str(run)], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([command, "differentiate", str(run)], check=True, stderr=subprocess.DEVNULL)
    return run


def processor_time(work: Callable[[], Any]) -> tuple[Any, float]:
    begun = time.process_time()
    result = work()
    return result, time.process_time() - begun


def one_run(root: Path, models: Sequence[str], form: Any) -> Iterator[str]:
    run = RunFolder.open(root)
    prototype = Prototype.model_validate(run.manifest.prototype)
    plant = device(prototype)
    name = prototype.plant.parameters
    joint = joint_parameters(name, folder=Path(run.manifest.prototype_file).parent) if name else None
    tables = [(role, log, run.read_table(layout.kinematics(role, log))) for role, log, _ in layout.logs(prototype)]
    data = [x for role, _, table in tables if role == "train" for x in trajectories(table)]
    wells = find_wells([(table["q"], voltages(table), data[0].interval) for _, _, table in tables])
    scores, times, details, equations = [], {}, [], []
    errors: dict[str, dict[str, np.ndarray]] = {}
    for model in (m for m in models if joint is not None or not m.startswith("analytical")):
        fitted, fit_s = processor_time(lambda model=model: FITS[model](data, plant, joint))
        free_run(tables[0][2], fitted)  # compiles the kernel
        times[model] = {"fit_s": fit_s}
        for role, log, table in tables:
            result, times[model]["simulate_s"] = processor_time(
                lambda table=table, fitted=fitted: free_run(table, fitted)
            )
            signals = {s: (table[s], getattr(result, s)) for s in ("q", "qdot", "qddot")}
            v, interval = voltages(table), data[0].interval
            rng = np.random.default_rng(0)
            rows = score_run(
                signals, v, interval, status=result.status, diverged_at_s=result.diverged_at_s, wells=wells, rng=rng
            )
            for row in rows:
                band = row.nrmse_interval
                limits = {"nrmse_low": band.low if band else None, "nrmse_high": band.high if band else None}
                scores.append({"role": role, "log": log, "model": model, **vars(row), **limits})
            if result.status == "ok":
                errors.setdefault(f"{role}/{log}", {})[model] = (result.q - table["q"]) / signal_range(table["q"])
            details.append((role, log, model, *detail(fitted, table, result.q, v, interval, wells)))
        if isinstance(fitted, SindyModel):
            equations.append(f"{model}:\n  " + "\n  ".join(fitted.equations()))
    yield f"\n{prototype.name}: {wells}\n"
    yield render(nrmse_table(scores, times), form)
    yield "\nSwitches followed, median errors of rise and settling time; NRMSE of q by horizon:\n"
    yield from ("  ".join(f"{cell:>12}" for cell in line) + "\n" for line in details)
    yield "\nRMS of q above that of the best, paired bootstrap (apart from zero: a real difference):\n"
    yield from (line for log, by_model in errors.items() for line in paired(log, by_model, round(BLOCK / interval)))
    yield "\n" + "\n".join(equations) + "\n"


def paired(log: str, errors: dict[str, np.ndarray], block: int) -> Iterator[str]:
    best = min(errors, key=lambda model: float(np.nanmean(errors[model] ** 2)))
    for model in (m for m in errors if m != best):
        band = rms_difference_interval(errors[model], errors[best], block, np.random.default_rng(0))
        if band is not None:
            yield f"{log}: {model} − {best}: [{100 * band.low:+.2f}, {100 * band.high:+.2f}] % of the range\n"


def detail(model: Any, table: Any, q: Any, v: Any, interval: float, wells: Any) -> list[str]:
    cells = []
    if isinstance(wells, Wells):
        times = response_errors(table["q"], q, v, interval, wells)
        cells += [f"{times.followed}/{times.switches}", seconds(times.rise_s), seconds(times.settling_s)]
    for horizon in HORIZONS:
        error = horizon_error(
            lambda *run: model.simulate(*run).q, table["t"], v, table["q"], table["qdot"], horizon, most_starts=100
        )
        cells.append("–" if error.nrmse is None else f"{100 * error.nrmse:.3f} %")
    return cells


def seconds(value: float | None) -> str:
    return "–" if value is None else f"{1000 * value:.0f} ms"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="*", type=Path, metavar="RUN")
    parser.add_argument("--models", nargs="+", choices=FITS, default=QUICK)
    parser.add_argument("--form", choices=("text", "markdown", "latex", "csv"), default="text")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for root in options.runs or [demo_run(Path(folder))]:
            sys.stdout.writelines(one_run(root, options.models, options.form))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
