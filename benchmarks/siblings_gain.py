"""What siblings teach a new joint: `python benchmarks/siblings_gain.py FLEET siblings.h5 -o OUT`.

FLEET is a folder of `debist rig fleet N --rate 2000 --seed S` with 37.5 s logs, siblings.h5 what `debist fleet learn`
made of other joints. Each joint is identified (`hybrid` alone) on its whole training log and on its first 8 s, with
siblings and without. Printed are NRMSE of q on the validation log in percent, median and largest for each physics,
and the median width of the bands of F and of the capacitances' slopes with siblings over that without.
"""

import argparse
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
from measure import UnheardBatch

from cli import debist
from debist import open_run
from pipeline.models.hybrid.model import HybridModel
from pipeline.numerics.arrays import FloatArray
from pipeline.workflow.batch import Execution, run_batch
from pipeline.workflow.members import SETTINGS, members, prototype_files, with_siblings

QUICK = '\n[identify]\nmodels = ["hybrid"]\n[compare]\nmodels = []\n'
SHORT = 8.0
CURVES = ("F", "dC1_dq", "dC2_dq")


def write_settings(fleet: Path, folder: Path) -> None:
    """Settings of each joint with its whole training log and with the beginning of it."""
    folder.mkdir(parents=True, exist_ok=True)
    for toml in sorted(fleet.glob("*/*-*.toml")):
        base = toml.parent.resolve()
        table = pq.read_table(base / "train.parquet")
        pq.write_table(table.slice(0, round(SHORT * 2000.0)), base / "train-short.parquet")
        for kind, train in (("long", "train"), ("short", "train-short")):
            text = toml.read_text(encoding="utf-8") + QUICK
            text = text.replace(f'name = "{toml.stem}"', f'name = "{toml.stem}-{kind}"')
            for log, file in (("train", train), ("validation", "validation")):
                text = text.replace(f'"{log}.parquet"', f'"{base / file}.parquet"')
            (folder / f"{toml.stem}-{kind}.toml").write_text(text, encoding="utf-8")


def error(run: Path) -> float:
    rows = pq.read_table(run / "scores.parquet").to_pylist()
    return 100.0 * next(float(r["nrmse"]) for r in rows if (r["role"], r["signal"]) == ("validation", "q"))


def widths(run: Path) -> dict[str, FloatArray]:
    model = open_run(run).model().core
    assert isinstance(model, HybridModel)
    drawn = model.curve_ensemble(np.linspace(-0.012, 0.012, 97))
    return {curve: np.ptp(np.percentile(drawn[curve], (2.5, 97.5), axis=0), axis=0) for curve in CURVES}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("fleet", type=Path)
    parser.add_argument("siblings", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    given = parser.parse_args()
    write_settings(given.fleet, given.output / "settings")
    files = prototype_files([given.output / "settings"], given.output)
    without, taught = given.output / "without", given.output / "taught"
    run_batch(members(files), without, UnheardBatch(), debist, Execution(1, report=False))
    of_siblings = members(with_siblings(files, given.siblings, taught / SETTINGS))
    run_batch(of_siblings, taught, UnheardBatch(), debist, Execution(1, report=False))
    for length in ("long", "short"):
        for kind in ("same", "foreign"):
            names = [m.name for m in of_siblings if m.name.startswith(kind) and m.name.endswith(length)]
            before, after = (np.array([error(runs / name) for name in names]) for runs in (without, taught))
            ratios = [widths(taught / name)[c] / widths(without / name)[c] for name in names for c in CURVES]
            print(
                f"{length} {kind}: without {np.median(before):.2f} (largest {before.max():.2f}), "
                f"taught {np.median(after):.2f} ({after.max():.2f}); bands {np.median(ratios):.2f}"
            )


if __name__ == "__main__":
    main()
