"""Whether `debist series` sees what changes in simulated joints: `python benchmarks/series_drift.py LOGS RUNS`.

LOGS has the folders day0, day5, … of one joint, each of `debist rig simulate --seed S` with `age_days`, and RUNS what
`debist batch LOGS -o RUNS` made of them. Printed are the drifts that are claimed beside the true ones: of rests, as the
laser reads them, of the mean of both barriers, of the laser's zero, and of the charging time. Then the runs are put
into `--shuffles` random orders of the same days: of a joint that does not change each is another series, and the facts
that change there are false alarms.
"""

import argparse
import json
from pathlib import Path

import numpy as np

from pipeline.diagnostics.series import ALARM, trend
from pipeline.rig.joint import barrier
from pipeline.rig.parameters import from_json
from pipeline.workflow.studies.fleet import series_of


def truth_of(logs: Path) -> dict[str, float]:
    """The true facts at one day, in SI."""
    truth = json.loads((logs / "truth" / "truth.json").read_text(encoding="utf-8"))
    zero, wells = truth["bench"]["laser"]["zero"], truth["wells_m"]
    return {
        "well_left": wells[0] + zero,
        "well_right": wells[1] + zero,
        "barrier": barrier(from_json(truth["joint"])),
        "laser_offset": zero,
        "charging_time": truth["bench"]["charging"],
    }


def _sum(*values: float | None) -> float:
    return sum(np.nan if value is None else value for value in values)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("logs", type=Path)
    parser.add_argument("runs", type=Path)
    parser.add_argument("--shuffles", type=int, default=20)
    given = parser.parse_args()
    days = sorted(float(path.name.removeprefix("day")) for path in given.logs.glob("day*"))
    roots = [next(given.runs.glob(f"*-day{day:g}")) for day in days]
    facts = {fact.key: fact for fact in series_of(roots, ",".join(map(str, days))).facts}
    truths = [truth_of(given.logs / f"day{day:g}") for day in days]
    print(f"{'fact':16s}{'true a day':>14s}{'claimed a day':>14s}{'± 95 %':>12s}  claim")
    for key, fact in facts.items():
        true = np.polyfit(days, [truth.get(key, np.nan) for truth in truths], 1)[0] if key in truths[0] else np.nan
        slope, half = _sum(fact.trend.slope), _sum(fact.trend.slope_error)
        print(f"{key:16s}{true:14.3g}{slope:14.3g}{half:12.2g}  {fact.trend.kind}")
    if {"barrier_left", "barrier_right"} <= facts.keys():
        left, right = facts["barrier_left"].trend, facts["barrier_right"].trend
        mean, half = 0.5 * _sum(left.slope, right.slope), 0.5 * _sum(left.slope_error, right.slope_error)
        true = np.polyfit(days, [truth["barrier"] for truth in truths], 1)[0]
        print(f"{'mean barrier':16s}{true:14.3g}{mean:14.3g}{half:12.2g}")
    rng, alarms, level = np.random.default_rng(1), 0, ALARM / len(facts)
    for _ in range(given.shuffles):
        orders = ((fact, rng.permutation(len(fact.at))) for fact in facts.values())
        shuffled = (trend(f.at, f.values[order], f.errors[order], level).kind for f, order in orders)
        alarms += any(kind in ("line", "step") for kind in shuffled)
    print(f"random orders: a change is claimed in {alarms} of {given.shuffles}")


if __name__ == "__main__":
    main()
