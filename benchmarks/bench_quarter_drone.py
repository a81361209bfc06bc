"""A real machine: free-run errors on the quarter drone, `python benchmarks/bench_quarter_drone.py FOLDER`.

FOLDER holds `sinal2…4_*.csv` of helonayala/sysid, `data/quarter_drone` (Unlicense): a propeller on a pivoted arm,
angle in degrees, drive in percent, 100 Hz. Protocol of its authors: 20 to 80 s of each record at 50 ms; training on
the first 80 % of multisine and steps, free-run tests on their rests and on the whole swept sine.

The parts are written as CSV logs and go through the commands with everything at its default but the sample interval,
so structure and hyperparameters are chosen on the training logs alone. Our conventions: debist's decimation instead of
every fifth sample, derivatives from the 100 Hz record of the same part; runs start from the measured angle of the first
sample with the velocity at which each model follows the first ten samples best, a lag at rest under the first drive.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

RECORDS = {"multisine": "sinal4_multiseno", "steps": "sinal2_degraus", "swept": "sinal3_swept_sine"}
START, SPLIT, STOP = 20.0, 68.0, 80.0  # s
PUBLISHED = {
    "grey box, scipy": (2.160, 4.079, 3.178),
    "grey box, NODE fit": (2.191, 5.372, 3.617),
    "neural ODE, first": (1.545, 4.003, 2.561),
    "neural ODE, second": (2.512, 5.711, 2.102),
    "neural ODE, third": (2.385, 5.115, 2.519),
    "polynomial NARX": (2.162, 3.850, 4.061),
}
SETTINGS = """
name = "quarter-drone"
[logs]
train = ["train/multisine.csv", "train/steps.csv"]
validation = ["validation/multisine.csv", "validation/steps.csv", "validation/swept.csv"]
[channels]
time = { channel = "Tempo_s", unit = "s" }
q  = { channel = "Saida_y", unit = "deg" }
v1 = { channel = "Controle_u", unit = "%" }
[plant]
inputs = "squared"
[ingest]
sample_interval = 0.05
"""


def write_part(source: Path, target: Path, start: float, stop: float) -> None:
    with source.open(encoding="utf-8", newline="") as lines:
        heading, *rows = csv.reader(lines)
    target.parent.mkdir(exist_ok=True)
    with target.open("w", encoding="utf-8", newline="") as out:
        csv.writer(out).writerows([heading, *(row for row in rows if start <= float(row[0]) < stop)])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    source = parser.parse_args().folder
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for log, stem in RECORDS.items():
            record = source / f"{stem}_malha_fechada.csv"
            if log != "swept":
                write_part(record, folder / "train" / f"{log}.csv", START, SPLIT)
            write_part(record, folder / "validation" / f"{log}.csv", START if log == "swept" else SPLIT, STOP)
        (folder / "drone.toml").write_text(SETTINGS, encoding="utf-8")
        debist = [str(Path(sys.executable).parent / "debist")]
        run = folder / "run"
        subprocess.run([*debist, "ingest", "drone.toml", "-o", run], cwd=folder, check=True, capture_output=True)
        for stage in ("differentiate", "identify", "validate", "compare"):
            subprocess.run([*debist, stage, run], check=True, capture_output=True)
        shown = subprocess.run([*debist, "validate", run, "--json"], check=True, capture_output=True)
        manifest = json.loads((run / "manifest.json").read_text(encoding="utf-8"))
    errors: dict[str, dict[str, float]] = {}
    for row in json.loads(shown.stdout)["scores"]:
        if row["role"] == "validation" and row["signal"] == "q":
            error = float("nan") if row["rmse"] is None else float(np.rad2deg(row["rmse"]))
            errors.setdefault(row["model"], {})[row["log"]] = error
    print(f"free-run test RMSE [deg]  {'multisine':>10}{'steps':>10}{'swept sine':>12}")
    rows = PUBLISHED | {f"debist {model}": tuple(by[log] for log in RECORDS) for model, by in errors.items()}
    for name, row in rows.items():
        print(f"{name:<26}{row[0]:10.3f}{row[1]:10.3f}{row[2]:12.3f}")
    notes = manifest["artifacts"]["model.h5"]["notes"]["rbf"]
    print(f"chosen: {notes['chosen']}; {notes['processor_time']['fit_s']:.1f} s of processor time")


if __name__ == "__main__":
    main()
