"""Coverage of the 90 % tubes of a model, and its error, on joints of three physics that are drawn anew.

`python benchmarks/tube_coverage.py FOLDER [SEED] [COUNT] [MODEL]`: COUNT joints of each kind, without ``[plant]``, one
training and one validation log each. Printed are a line for each joint and a table. About 30 s of processor time a
joint.
"""

import argparse
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd

from pipeline.rig.fleet import Experiment, simulate_prototype

KINDS = ("same", "foreign", "worn")


def measured(folder: Path, kind: str, seed: int, model: str) -> dict[str, float]:
    """Scores of q on the validation log of one joint."""
    home = folder / f"{kind}-{seed}"
    settings = simulate_prototype(home, home.name, Experiment(kind=kind, rate=10_000.0), seed=seed)
    text = settings.read_text(encoding="utf-8")
    blind = text[: text.index("[plant]")] + f'[identify]\nmodels = ["{model}"]\n'
    settings.write_text(blind, encoding="utf-8")
    subprocess.run([str(Path(sys.executable).with_name("debist")), "run", str(settings), "-o", str(home / "run"), "-q"],
                   check=True, capture_output=True)  # fmt: skip
    scores = pd.read_parquet(home / "run" / "scores.parquet")
    rows = scores[(scores.model == model) & (scores.signal == "q")].set_index("role").to_dict("index")
    return {
        "in_tube": rows["validation"]["in_tube"],
        "nrmse": rows["validation"]["nrmse"],
        "training": rows["train"]["nrmse"],
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("seed", type=int, nargs="?", default=26112950)
    parser.add_argument("count", type=int, nargs="?", default=6)
    parser.add_argument("model", nargs="?", default="hybrid")
    given = parser.parse_args()
    print("| kind | joints | tube holds: mean, each | NRMSE of q: training, validation: median, each |")
    print("|---|---|---|---|")
    for number, kind in enumerate(KINDS):
        rows = []
        for i in range(given.count):
            seed = given.seed + 10 * number + i
            rows.append(measured(given.folder, kind, seed, given.model))
            print(kind, seed, f"{rows[-1]['in_tube']:.3f} {rows[-1]['nrmse']:.5f}", file=sys.stderr)
        held, errors, training = (100.0 * np.array([row[k] for row in rows]) for k in ("in_tube", "nrmse", "training"))
        each = ", ".join(f"{value:.0f}" for value in held)
        print(f"| `{kind}` | {given.count} | {held.mean():.0f} %: {each} | {np.median(training):.3f} %, "
              f"{np.median(errors):.2f} %: {', '.join(f'{e:.2f}' for e in errors)} |")  # fmt: skip


if __name__ == "__main__":
    main()
