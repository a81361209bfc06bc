"""Fits, free runs and ensembles of many joints: `python benchmarks/bench_free_runs.py RUNS`.

RUNS is a folder of runs, as `debist batch` makes it. Of each: the processor time of its fits with the choice between
them, of a free run of the model over the first validation log, and of the posterior ensemble of 32, each the median of
15; then the median and the longest of all joints.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from pipeline.system.machine import settle_machine

settle_machine()

import numpy as np  # noqa: E402
from measure import fits, seconds  # noqa: E402

from pipeline.models.base import HasDraws  # noqa: E402
from pipeline.models.model_type import load_model  # noqa: E402
from pipeline.store.tables import read_table  # noqa: E402


def row(folder: Path) -> tuple[float, float, float]:
    """Fit [s], free run [ms] and ensemble [ms] of a run."""
    model = load_model(folder / "model.h5")
    assert isinstance(model, HasDraws)
    table = read_table(sorted(folder.glob("validation/*/signals.parquet"))[0])
    t, v = table["t"], np.stack([table["v1"], table["v2"]], axis=1)
    q = float(table["q"][np.flatnonzero(np.isfinite(table["q"]))[0]])
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    one = seconds(lambda: model.simulate(t, v, q, 0.0), 15)
    many = seconds(lambda: model.simulate_draws(t, v, q, 0.0, count=32), 15)
    return sum(fits(manifest["artifacts"]["model.h5"])), 1e3 * one, 1e3 * many


def main() -> None:
    print(f"{'run':24} {'fit [s]':>8} {'free run [ms]':>14} {'ensemble of 32 [ms]':>20}")
    found = []
    for folder in sorted(path.parent for path in Path(sys.argv[1]).glob("*/model.h5")):
        found.append(row(folder))
        print(f"{folder.name:24} {found[-1][0]:8.1f} {found[-1][1]:14.1f} {found[-1][2]:20.1f}", flush=True)
    for name, values in (("median", np.median(found, axis=0)), ("longest", np.max(found, axis=0))):
        print(f"{name:24} {values[0]:8.1f} {values[1]:14.1f} {values[2]:20.1f}")


if __name__ == "__main__":
    main()
