"""How well a batch predicts a simulated fleet, and how well anything could.

`python benchmarks/fleet_accuracy.py FLEET RUNS [--margins]`: FLEET is a folder of `debist rig fleet`, RUNS what
`debist batch FLEET -o RUNS` made of it. Printed are, for joints of the same and of foreign physics and every model,
median and 90th percentile of the validation NRMSE of q and the well agreement; the processor time of the fit; then the
pulses that went the wrong way, and how the probabilities that the model's ensemble gave to all of them came true.

With ``--margins`` the true joints are simulated again with their voltages a little off (0.1 to 1 %), which is what a
high-voltage probe is wrong by. Where that sends a pulse into the other well, no model can be expected to know better.
About 10 s a joint.
"""

import argparse
import json
from itertools import pairwise
from pathlib import Path

import numpy as np

from pipeline.device.device import JOINT
from pipeline.numerics.arrays import FloatArray, IntArray
from pipeline.rig.bench import TIME_STEP
from pipeline.rig.fleet import Experiment, draw
from pipeline.rig.joint import simulate
from pipeline.scoring.wells import SURE, rests
from pipeline.store.manifest import TIMES
from pipeline.store.run_folder import RunFolder
from pipeline.store.tables import Table, read_table

WRONG_VOLTAGES = (-0.01, -0.005, -0.002, -0.001, 0.001, 0.002, 0.005, 0.01)
INTERVAL = 0.01  # s
BINS = np.array([0.0, 0.1, 0.5, SURE, 1.0])


def accuracy(runs: Path, names: list[str]) -> None:
    """Errors of every model by kind of joint, and the processor time of the main model's fit with its choice."""
    table = read_table(runs / "fleet.parquet")
    chosen = (table["role"] == "validation") & (table["signal"] == "q")
    numbers = ("joints", "median %", "p90 %", "worst %", "wells %", "diverged")
    print(f"{'':8s}{'model':22s}" + "".join(f"{name:>10s}" for name in numbers))
    main_model = table["headline"].astype(bool)
    others = sorted(set(table["model"][chosen & ~main_model]))
    for kind in ("same", "foreign", ""):
        of_kind = chosen & np.array([str(n) in names and str(n).startswith(kind) for n in table["prototype"]])
        _row(table, kind or "all", "headline", np.flatnonzero(of_kind & main_model))
        for model in others:
            _row(table, "", model, np.flatnonzero(of_kind & (table["model"] == model)))
    there = set(map(str, table["prototype"][chosen]))
    print("absent:", ", ".join(name for name in names if name not in there) or "none")
    spent = np.array([_fit_time(runs / name) for name in names if name in there])
    print(f"processor time of the fit: median {np.median(spent):.1f} s, longest {spent.max():.1f} s")
    for at in np.flatnonzero(chosen & main_model):
        print(f"  {table['prototype'][at]:10s} {table['model'][at]:8s} {100.0 * table['nrmse'][at]:7.2f} %")


def _row(table: Table, kind: str, model: str, at: IntArray) -> None:
    """One line of the table of errors."""
    if len(at):
        error = 100.0 * np.where(table["status"][at] == "ok", table["nrmse"][at], np.inf)
        wells = 100.0 * np.nanmean(table["well_agreement"][at])
        lost = np.count_nonzero(table["status"][at] != "ok")
        ninety = np.percentile(error, 90, method="inverted_cdf" if lost else "linear")
        numbers = "".join(f"{x:10.2f}" for x in (np.median(error), ninety, error.max(), wells))
        print(f"{kind:8s}{model:22s}{len(at):10d}{numbers}{lost:10d}")


def _fit_time(run: Path) -> float:
    """Processor time [s] of the main model's fit, with the choice."""
    notes = RunFolder.open(run).manifest.artifacts["model.h5"].notes
    return float(notes[notes["identified"][0]][TIMES]["fit_s"])


def outcomes(runs: Path, names: list[str]) -> None:
    """Pulses that went the wrong way, and what the ensemble had said of them."""
    probability, went_right, agreed, unclear = [], [], [], []
    for name in names:
        run = RunFolder.open(runs / name)
        model = run.manifest.artifacts["model.h5"].notes["identified"][0]
        said = run.manifest.artifacts[f"validation/validation/predictions/{model}.parquet"].notes.get("outcomes")
        if not said:
            continue
        measured = read_table(runs / name / "validation/validation/kinematics.parquet")
        free = read_table(runs / name / f"validation/validation/predictions/{model}.parquet")
        for at, right, open_one in zip(said["at_s"], said["right"], said["ambiguous"], strict=True):
            sides = [np.nanmean(log["q"][np.abs(log["t"] - at) < 0.15]) > 0.0 for log in (measured, free)]
            probability.append(right)
            went_right.append(sides[0])
            unclear.append(open_one)
            agreed.append(sides[0] == sides[1])
            if sides[0] != sides[1]:
                print(f"wrong: {name} at {at:.2f} s, probability of the right well {right:.2f}, measured {sides[0]}")
    p, happened, wrong, ambiguous = (np.array(x) for x in (probability, went_right, agreed, unclear))
    wrong = ~wrong
    both = np.sum(wrong & ambiguous)
    print(f"{len(p)} outcomes, {wrong.sum()} wrong, {ambiguous.sum()} ambiguous, {both} both")
    print(f"Brier score {np.mean((p - happened) ** 2):.3f}")
    place = np.clip(np.digitize(p, BINS) - 1, 0, len(BINS) - 2)
    for i, (low, high) in enumerate(pairwise(BINS)):
        if np.any(place == i):
            count, said, came = np.count_nonzero(place == i), p[place == i].mean(), happened[place == i].mean()
            print(f"  said {low:.1f} to {high:.1f}: {count:4d}, mean {said:.2f}, came true {came:.2f}")


def margins(fleet: Path, names: list[str]) -> None:
    """NRMSE [%] of the true joint itself under voltages that are a little wrong."""
    print("the true joint, voltages wrong by " + ", ".join(f"{100 * d:+.1f} %" for d in WRONG_VOLTAGES))
    found = []
    for name in names:
        truth = json.loads((fleet / name / "truth/truth.json").read_text(encoding="utf-8"))
        joint, bench, logs = draw(Experiment(**truth["experiment"]), np.random.default_rng(truth["seed"]))
        records = {log.stem: log.record for log in logs}
        record, dt = records["validation"], 1.0 / bench.rate
        every, stride = round(INTERVAL * bench.rate), max(1, round(TIME_STEP * bench.rate))
        v = np.column_stack([record.true_v1, record.true_v2])
        q = record.true_q[::every]
        runs = [simulate(joint, (1.0 + d) * v, dt, stride=stride).q[::every] for d in WRONG_VOLTAGES]
        found.append([100.0 * np.sqrt(np.mean((run - q) ** 2)) / np.ptp(q) for run in runs])
        print(f"{name:10s}" + "".join(f"{x:8.2f}" for x in found[-1]) + "  " + flips(v[::every], q, runs), flush=True)
    print(f"{'p90':10s}" + "".join(f"{x:8.2f}" for x in np.percentile(np.array(found), 90, axis=0)))


def flips(v: FloatArray, q: FloatArray, runs: list[FloatArray]) -> str:
    """Ends [s] of the pulses whose outcome changes, with the smallest wrong voltage that does it."""
    texts = []
    for rest in rests(v, INTERVAL, plant=JOINT):
        end = rest.stop - 1
        changed = [abs(d) for d, run in zip(WRONG_VOLTAGES, runs, strict=True) if (run[end] > 0.0) != (q[end] > 0.0)]
        if changed:
            texts.append(f"{end * INTERVAL:.1f} s ({100 * min(changed):.1f} %)")
    return ", ".join(texts)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("fleet", type=Path)
    parser.add_argument("runs", type=Path)
    parser.add_argument("--margins", action="store_true")
    given = parser.parse_args()
    names = sorted(path.parent.parent.name for path in given.fleet.glob("*/truth/truth.json"))
    accuracy(given.runs, names)
    outcomes(given.runs, names)
    if given.margins:
        margins(given.fleet, names)


if __name__ == "__main__":
    main()
