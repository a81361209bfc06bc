"""What 100,000 prototypes cost, from some hundred real runs of the default model without baselines and report.

    python benchmarks/bench_fleet_cost.py [--joints 4] [--copies 25] [--rate 2000] [--jobs 1] [--folder FOLDER]

Joints are drawn by the virtual rig, each with a training and a validation log of 37.5 s; every copy has noise of its
own on the displacement (2 µm), so that no two prototypes have the same log. Printed are the runs that went well, the
processor time of a prototype, and the core hours of 100,000; all processes of the batch count.
"""

import argparse
import json
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from measure import adopt_orphans, cost

NOISE = 2e-6  # m
_DEBIST = [sys.executable, "-c", "from cli import app; app()"]
_UNITS = {"m": 1.0, "mm": 1e3, "um": 1e6, "µm": 1e6}


def write_copies(settings: Path, folder: Path, copies: int) -> None:
    """Prototypes whose logs are those of one prototype with further noise on q."""
    import tomllib

    text = settings.read_text(encoding="utf-8").split("[compare]")[0] + "\n[compare]\nmodels = []\n"
    document = tomllib.loads(text)
    channel = document["channels"]["q"]
    logs = [name for names in document["logs"].values() for name in names]
    for i in range(copies):
        rng, name = np.random.default_rng(i), f"{document['name']}-{i:04d}"
        place = folder / name
        place.mkdir(parents=True)
        for log in logs:
            table = pq.read_table(settings.parent / log)
            at = table.column_names.index(channel["channel"])
            q = table.column(at).to_numpy()
            q = q + rng.normal(0.0, NOISE * _UNITS[channel["unit"]], len(q))
            (place / log).parent.mkdir(parents=True, exist_ok=True)
            field = table.schema.field(at)
            pq.write_table(table.set_column(at, field, pa.array(q, field.type)), place / log)
        lines = [f'name = "{name}"' if line.startswith("name") else line for line in text.splitlines()]
        (place / f"{name}.toml").write_text("\n".join(lines), encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--joints", type=int, default=4)
    parser.add_argument("--copies", type=int, default=25, help="of each joint")
    parser.add_argument("--rate", default="2000", help="of the logs [Hz]")
    parser.add_argument("--jobs", default="1")
    parser.add_argument("--folder", type=Path, help="where logs and runs go for the time of the benchmark")
    options = parser.parse_args()
    adopt_orphans()
    folder = Path(tempfile.mkdtemp(dir=options.folder))
    try:
        fleet = [*_DEBIST, "rig", "fleet", str(options.joints), "--seed", "20261122", "--rate", options.rate]
        cost([*fleet, "-o", str(folder / "fleet")])
        for settings in sorted((folder / "fleet").glob("**/*.toml")):
            write_copies(settings, folder / "many", options.copies)
        batch = [*_DEBIST, "batch", str(folder / "many"), "-o", str(folder / "runs"), "--jobs", options.jobs]
        spent = cost([*batch, "--no-report", "--json"])
        prototypes = json.loads(spent.stdout)["prototypes"]
    finally:
        shutil.rmtree(folder)
    each = np.array([prototype["processor_seconds"] for prototype in prototypes])
    well = sum(prototype["exit_code"] == 0 for prototype in prototypes)
    mean = spent.processor / len(each)
    print(f"{len(each)} prototypes of {options.joints} joints at {options.rate} Hz, {well} went well")
    print(f"processor time of one: median {np.median(each):.2f} s, 90 % below {np.quantile(each, 0.9):.2f} s, "
          f"longest {each.max():.2f} s; mean with the batch itself {mean:.2f} s")  # fmt: skip
    print(f"100,000: {mean / 0.036:.0f} core hours")


if __name__ == "__main__":
    main()
