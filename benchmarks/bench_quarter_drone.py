"""A real machine: free-run errors on the quarter drone, `python benchmarks/bench_quarter_drone.py FOLDER`.

FOLDER holds `sinal2…4_*.csv` of helonayala/sysid, `data/quarter_drone` (Unlicense): a propeller on a pivoted arm,
angle in degrees, drive in percent, 100 Hz. Protocol of its authors: 20 to 80 s of each record, every fifth sample;
training on the first 80 % of multisine and steps, free-run tests on their rests and on the whole swept sine.
Our conventions: the drive is linear between samples; runs start from the measured angle and the Savitzky-Golay
velocity at the first sample, the drive's lag at rest under the first drive. Angle in radians, inertia unknown.
"""

import argparse
import csv
import os
import time
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from scipy.signal import savgol_filter

from pipeline.models.identify_rbf import identify_rbf
from pipeline.numerics.identification.record import Record

RECORDS = {"multisine": "sinal4_multiseno", "steps": "sinal2_degraus", "swept sine": "sinal3_swept_sine"}
INTERVAL = 0.05
PUBLISHED = {
    "grey box, scipy": (2.160, 4.079, 3.178),
    "grey box, NODE fit": (2.191, 5.372, 3.617),
    "neural ODE, first": (1.545, 4.003, 2.561),
    "neural ODE, second": (2.512, 5.711, 2.102),
    "neural ODE, third": (2.385, 5.115, 2.519),
    "polynomial NARX": (2.162, 3.850, 4.061),
}


def record(folder: Path, stem: str) -> Record:
    with (folder / f"{stem}_malha_fechada.csv").open(encoding="utf-8") as lines:
        rows = np.array([[float(x) for x in row] for row in list(csv.reader(lines))[1:]])
    rows = rows[(rows[:, 0] >= 20.0) & (rows[:, 0] < 80.0)][::5]
    angle = np.deg2rad(rows[:, 2])
    speed, acceleration = (savgol_filter(angle, 7, 3, deriv=k, delta=INTERVAL) for k in (1, 2))
    t = INTERVAL * np.arange(len(rows))
    return Record(t, angle, speed, acceleration, rows[:, 3:4].copy(), np.ones(len(rows), dtype=bool))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    logs = {name: record(parser.parse_args().folder, stem) for name, stem in RECORDS.items()}
    split = {name: int(0.8 * len(log.t)) for name, log in logs.items()}
    training = [logs[name].part(0, split[name]) for name in ("multisine", "steps")]
    tests = {name: logs[name].part(split[name], len(logs[name].t)) for name in ("multisine", "steps")}
    tests["swept sine"] = logs["swept sine"]
    identify_rbf([training[0].part(0, 200)])  # compile
    start = time.process_time()
    model = identify_rbf(training)
    spent = time.process_time() - start
    ours = []
    for log in tests.values():
        run = model.simulate(log.t, log.v, float(log.q[0]), float(log.qdot[0]))
        ours.append(float(np.rad2deg(np.sqrt(np.mean((run.q - log.q) ** 2)))))
    print(f"free-run test RMSE [deg]  {'multisine':>10}{'steps':>10}{'swept sine':>12}")
    for name, row in {**PUBLISHED, "debist rbf": tuple(ours)}.items():
        print(f"{name:<26}{row[0]:10.3f}{row[1]:10.3f}{row[2]:12.3f}")
    print(f"chosen: {model.diagnostics['chosen']}; {spent:.1f} s of processor time")


if __name__ == "__main__":
    main()
