"""What a designed excitation gains: `python benchmarks/excitation_gain.py [--prototypes N] [--first I]`.

For each simulated prototype (by turns of the analytical model's physics and of another) the joint on its bench records
three training logs of 37.5 s: alternating full pulses, a random excitation, and a sequence that `debist rig excite`
designed from the drawing alone. `rbf-paper` and `hybrid` are identified on each, and all are judged by free runs over
the same two validation logs of random excitations. Prints the mean validation NRMSE of q in %. Some minutes of
processor time a prototype.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

from pipeline.device.parameters import NOMINAL
from pipeline.errors import DataRefusedError
from pipeline.rig.bench import random_bench, record
from pipeline.rig.excitation import alternating_pulses, command, random_excitation
from pipeline.rig.log import LAYOUTS
from pipeline.rig.random_joint import random_joint
from pipeline.workflow.engine import Unheard
from pipeline.workflow.report_data import load_scores
from pipeline.workflow.run import run_prototype, run_stage
from pipeline.workflow.studies.excitation_design import Requirements, design_excitation, drawn_simulators

FORM = LAYOUTS["parquet"]
RATE = 10_000.0
MODELS = ("rbf-paper", "hybrid")
SETTINGS = """
name = "{name}"
[logs]
train = ["{name}.parquet"]
validation = ["validation-1.parquet", "validation-2.parquet"]
{channels}
[plant]
mass = {{ value = 0.0405, unit = "kg" }}
parameters = "nominal"
[identify]
models = ["rbf-paper", "hybrid"]
[compare]
models = []
"""


def errors(folder: Path, name: str) -> dict[str, float]:
    """Mean validation NRMSE of q by model [%]; infinite where a free run diverged or the log was refused."""
    settings = folder / f"{name}.toml"
    settings.write_text(SETTINGS.format(name=name, channels=FORM.toml()), encoding="utf-8")
    root = folder / "runs" / name
    try:
        run_prototype(settings, root, Unheard(), only="ingest")
        for stage in ("differentiate", "identify", "validate"):
            run_stage(root, stage, Unheard())
    except DataRefusedError:
        return dict.fromkeys(MODELS, np.inf)
    rows = [row for row in load_scores(root) if row["role"] == "validation" and row["signal"] == "q"]
    return {
        model: 100.0
        * float(np.mean([np.inf if row["nrmse"] is None else row["nrmse"] for row in rows if row["model"] == model]))
        for model in MODELS
    }


def measure(number: int, folder: Path) -> dict[str, dict[str, float]]:
    rng = np.random.default_rng([20261122, number])
    joint = random_joint(rng, "foreign" if number % 2 else "same")
    bench = random_bench(rng, rate=RATE)
    t = bench.clock(37.5)
    design = design_excitation(drawn_simulators(NOMINAL, rng, 4), rng, Requirements())
    experiments = {
        "alternating": alternating_pulses(),
        "random": random_excitation(rng, excitation="training"),
        "designed": design.bursts,
        "validation-1": random_excitation(rng, excitation="validation"),
        "validation-2": random_excitation(rng, excitation="mixed"),
    }
    for name, bursts in experiments.items():
        log = record(joint, bench, t, command(bursts, t), rng)
        FORM.save(log, folder / f"{name}.parquet")
    return {name: errors(folder, name) for name in ("alternating", "random", "designed")}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--prototypes", type=int, default=8)
    parser.add_argument("--first", type=int, default=0)
    options = parser.parse_args()
    table = []
    print(
        f"{'':>10}  " + "  ".join(f"{m + ' ' + s:>22}" for m in MODELS for s in ("alternating", "random", "designed"))
    )
    for number in range(options.first, options.first + options.prototypes):
        with tempfile.TemporaryDirectory() as folder:
            found = measure(number, Path(folder))
        row = [found[s][m] for m in MODELS for s in ("alternating", "random", "designed")]
        table.append(row)
        print(
            f"{('foreign' if number % 2 else 'same') + f'-{number}':>10}  " + "  ".join(f"{x:22.2f}" for x in row),
            flush=True,
        )
    print(f"{'median':>10}  " + "  ".join(f"{x:22.2f}" for x in np.median(table, axis=0)))


if __name__ == "__main__":
    main()
