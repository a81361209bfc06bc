"""What a designed second log gains: `python benchmarks/next_log.py [--joints N] [--first SEED] [--candidates C]`.

The joints of the seeds from SEED on, the first half of the analytical model's physics, the others foreign. Each records
a training log of 37.5 s, from which `hybrid` is identified; then two second logs of equal length: one that `debist rig
excite --run` designed for the validation programme, and one of the usual random excitation. `hybrid` is identified from
the first log with either, and judged by free runs over two validation logs. Printed are mean NRMSE of q in %, the
expected standard deviation of the free run in µm, and medians. Two to four minutes a joint.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

from pipeline.errors import DataRefusedError
from pipeline.models.hybrid.model import HybridModel
from pipeline.rig.bench import record
from pipeline.rig.excitation import Burst, command, random_excitation
from pipeline.rig.fleet import Experiment, draw, moving_mass
from pipeline.rig.log import LAYOUTS
from pipeline.store.run_folder import in_snapshot
from pipeline.workflow.engine import Unheard
from pipeline.workflow.report_data import load_scores
from pipeline.workflow.run import run_prototype, run_stage
from pipeline.workflow.run_models import subject
from pipeline.workflow.studies.excitation_design import NextLog, Requirements, design_next_log

FORM, RATE, ARMS = LAYOUTS["parquet"], 2000.0, ("first", "usual", "designed")
SETTINGS = """
name = "{name}"
[logs]
train = {train}
validation = ["validation.parquet", "validation-2.parquet"]
{channels}
[plant]
mass = {{ value = {mass:.4f}, unit = "kg" }}
parameters = "nominal"
[identify]
models = ["hybrid"]
[compare]
models = []
"""


def identified(folder: Path, arm: str, mass: float) -> float:
    """Mean validation NRMSE of q [%]; infinite where a free run diverged or the logs were refused."""
    train = '["train.parquet"]' if arm == "first" else f'["train.parquet", "{arm}.parquet"]'
    settings = folder / f"{arm}.toml"
    settings.write_text(SETTINGS.format(name=arm, train=train, channels=FORM.toml(), mass=mass), encoding="utf-8")
    try:
        run_prototype(settings, folder / "runs" / arm, Unheard(), only="ingest")
        for stage in ("differentiate", "identify", "validate"):
            run_stage(folder / "runs" / arm, stage, Unheard())
    except DataRefusedError:
        return np.inf
    rows = load_scores(folder / "runs" / arm)
    scores = [row["nrmse"] for row in rows if (row["role"], row["signal"]) == ("validation", "q")]
    return 100.0 * float(np.mean([np.inf if score is None else score for score in scores]))


def measure(kind: str, seed: int, candidates: int, folder: Path) -> tuple[list[float], NextLog]:
    rng = np.random.default_rng(seed)
    joint, bench, logs = draw(Experiment(kind=kind, format="parquet", rate=RATE, validation_logs=2), rng)
    for log in logs:
        FORM.save(log.record, folder / f"{log.stem}.parquet")

    def play(name: str, bursts: list[Burst]) -> None:
        t = bench.clock(37.5)
        log = record(joint, bench, t, command(bursts, t), rng)
        FORM.save(log, folder / f"{name}.parquet")

    mass = moving_mass(joint)
    errors = [identified(folder, "first", mass)]
    known = in_snapshot(folder / "runs" / "first", lambda run: subject(run, run.prototype, "hybrid"))
    assert isinstance(known.model, HybridModel)
    design = design_next_log(
        known.model, known.start[0], 0.01, "validation", np.random.default_rng([1, seed]),
        Requirements(candidates=candidates),
    )  # fmt: skip
    play("usual", random_excitation(rng, excitation="training"))
    play("designed", design.bursts)
    return [*errors, *(identified(folder, arm, mass) for arm in ARMS[1:])], design


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--joints", type=int, default=10)
    parser.add_argument("--first", type=int, default=26112800)
    parser.add_argument("--candidates", type=int, default=12)
    given = parser.parse_args()
    table = []
    print(f"{'':20s}" + "".join(f"{arm:>10s}" for arm in (*ARMS, "now", *ARMS[1:])))
    for number in range(given.joints):
        kind = "same" if number < given.joints / 2 else "foreign"
        with tempfile.TemporaryDirectory() as folder:
            errors, design = measure(kind, given.first + number, given.candidates, Path(folder))
        table.append([*errors, *(1e6 * sd for sd in (design.now, design.usual, design.designed))])
        print(f"{kind + f'-{given.first + number}':20s}" + "".join(f"{x:10.3f}" for x in table[-1]), flush=True)
    half = (len(table) + 1) // 2
    for name, rows in (("same", table[:half]), ("foreign", table[half:]), ("all", table)):
        if rows:
            print(f"{'median ' + name:20s}" + "".join(f"{x:10.3f}" for x in np.median(rows, axis=0)))


if __name__ == "__main__":
    main()
