"""What a fleet costs: processor time and memory per prototype, and the parallel efficiency.

    OMP_NUM_THREADS=1 python benchmarks/bench_batch.py [--counts 1 10 50] [--jobs 1 2] [--folder FOLDER]

Prototypes are double wells under random pulses, simulated here at 1 kHz for 8 s, with one training log and the model
`rbf-paper`, without baselines and report: what is measured is what comes with every prototype. Efficiency is the wall
time with one process over that with N, divided by N, so it needs an idle machine; processor times do not. A rerun,
in which everything is up to date, is measured too.
"""

import argparse
import json
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from measure import adopt_orphans, cost

from tests.double_well import DoubleWell

TOML = """name = "{name}"
[logs]
train = ["{name}.parquet"]
[channels]
time = {{ channel = "t", unit = "s" }}
q = {{ channel = "q", unit = "m" }}
v1 = {{ channel = "v1", unit = "V" }}
v2 = {{ channel = "v2", unit = "V" }}
[identify]
models = ["rbf-paper"]
[compare]
models = []
[quality]
accept = ["visits", "rank"]
"""


def write_fleet(folder: Path, count: int) -> None:
    """Settings and logs of so many prototypes."""
    dt, folder = 1e-3, folder / "prototypes"
    folder.mkdir()
    for seed in range(count):
        rng, name = np.random.default_rng(seed), f"p{seed:04d}"
        v = np.repeat(rng.choice([0.0, 1500.0, 3000.0], size=(20, 2)), 400, axis=0)
        q = DoubleWell().simulate(v, dt, stride=2) + rng.normal(0.0, 2e-6, len(v))
        table = pa.table({"t": np.arange(len(v)) * dt, "q": q, "v1": v[:, 0].copy(), "v2": v[:, 1].copy()})
        pq.write_table(table, folder / f"{name}.parquet")
        (folder / f"{name}.toml").write_text(TOML.format(name=name))


def batch(folder: Path, output: str, jobs: int) -> dict[str, Any]:
    """Wall time, processor times of workers and of the whole command, and the largest memory of a process."""
    command = [sys.executable, "-c", "from cli import app; app()", "batch", str(folder / "prototypes")]
    made = cost([*command, "-o", str(folder / output), "--jobs", str(jobs), "--no-report", "--json"])
    prototypes = json.loads(made.stdout)["prototypes"]
    return {
        "wall": made.wall,
        "whole": made.processor,
        "workers": sum(prototype["processor_seconds"] for prototype in prototypes),
        "memory": max(prototype["memory_bytes"] for prototype in prototypes),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counts", type=int, nargs="+", default=[1, 10, 50])
    parser.add_argument("--jobs", type=int, nargs="+", default=[1, 2], help="the first is what efficiency refers to")
    parser.add_argument("--folder", type=Path, help="where fleets and runs go for the time of the benchmark")
    options = parser.parse_args()
    adopt_orphans()
    print(
        "prototypes jobs  wall [s]  efficiency  processor time [s] per prototype: run  batch itself  rerun  memory [MB]"
    )
    for count in options.counts:
        folder = Path(tempfile.mkdtemp(dir=options.folder))
        try:
            write_fleet(folder, count)
            walls = {}
            for jobs in options.jobs:
                made = batch(folder, f"runs{jobs}", jobs)
                again = batch(folder, f"runs{jobs}", jobs)
                walls[jobs] = made["wall"]
                base = options.jobs[0]
                efficiency = walls[base] * base / (walls[jobs] * jobs)
                print(
                    f"{count:10} {jobs:4} {made['wall']:9.1f} {efficiency:11.2f} {made['workers'] / count:37.2f}"
                    f" {(made['whole'] - made['workers']) / count:13.3f} {again['whole'] / count:6.2f}"
                    f" {made['memory'] / 1e6:12.0f}",
                    flush=True,
                )
            size = sum(path.stat().st_size for path in (folder / f"runs{options.jobs[0]}").rglob("*") if path.is_file())
            print(f"           {size / count / 1e3:.0f} kB of runs and tables a prototype", flush=True)
        finally:
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
