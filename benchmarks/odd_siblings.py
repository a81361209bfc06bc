"""Which odd joints `debist fleet learn` names: `python benchmarks/odd_siblings.py FOLDER [SIBLINGS] [ODD] [SEED]`.

Half of the joints have the model's physics, half another one. For each physics SIBLINGS usual joints are drawn, and ODD
joints whose left membrane has 15 % less capacitance, and ODD joints whose laser shows 3 % too much. All are identified
from one log (37.5 s, 2 kHz). Each odd joint then stands beside the usual ones of its physics. About 20 s a joint;
joints in the folder are kept.
"""

import sys
from pathlib import Path
from typing import cast
from unittest import mock

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from measure import UnheardBatch

import pipeline.rig.fleet
from cli import debist
from debist import open_run
from pipeline.models.hybrid.model import HybridModel
from pipeline.models.hybrid.siblings import learn
from pipeline.rig.fleet import Experiment, simulate_prototype
from pipeline.rig.parameters import RigParameters
from pipeline.rig.random_joint import Family, random_joint
from pipeline.workflow.batch import Execution, run_batch
from pipeline.workflow.members import members, prototype_files

KINDS, CASES = ("same", "foreign"), {"usual": (1.0, 1.0), "left": (0.85, 1.0), "laser": (1.0, 1.03)}
QUICK = '\n[identify]\nmodels = ["hybrid"]\n[compare]\nmodels = []\n'


def simulate(folder: Path, kind: str, case: str, seed: int) -> None:
    """Logs and settings of one joint."""
    capacitance, laser = CASES[case]

    def joint(rng: np.random.Generator, family: Family) -> RigParameters:
        p = random_joint(rng, family)
        return p._replace(capacitance=p.capacitance * [capacitance, 1.0])

    home = folder / f"{kind}-{case}-{seed}"
    if (home / f"{home.name}.toml").exists():
        return
    with mock.patch.object(pipeline.rig.fleet, "random_joint", joint):
        experiment = Experiment(kind=kind, format="parquet", rate=2000.0, validation_logs=0)
        settings = simulate_prototype(home, home.name, experiment, seed=seed)
    log = pq.read_table(home / "train.parquet")
    at = log.schema.get_field_index("Laser_q")
    shown = pa.array(laser * log.column(at).to_numpy()).cast(log.schema.field(at).type)
    pq.write_table(log.set_column(at, log.schema.field(at), shown), home / "train.parquet")
    settings.write_text(settings.read_text(encoding="utf-8") + QUICK, encoding="utf-8")


def main(folder: Path, siblings: int = 30, odd: int = 5, seed: int = 57114000) -> None:
    for number, kind in enumerate(KINDS):
        for place, (case, count) in enumerate(zip(CASES, (siblings, odd, odd), strict=True)):
            for i in range(count):
                simulate(folder / "logs", kind, case, seed + 1000 * number + 100 * place + i)
    run_batch(members(prototype_files([folder / "logs"], folder)), folder / "runs", UnheardBatch(), debist,
              Execution(1, report=False))  # fmt: skip
    for kind in KINDS:
        runs = sorted((folder / "runs").glob(f"{kind}-*"))
        models = {run.name: cast(HybridModel, open_run(run).model().core) for run in runs}
        usual = {name: model for name, model in models.items() if "-usual-" in name}
        alarms = learn(usual).odd
        print(f"{kind}: {len(alarms)} of {len(usual)} usual joints are called odd: {alarms}")
        for name, model in models.items():
            if name not in usual:
                named = [entry for entry in learn(usual | {name: model}).odd if entry.name == name]
                texts = [f"{e.quantity} {e.size:+.1f} ± {e.error:.1f} {e.unit}" for e in named]
                print(f"{name}:", *(texts or ["not named"]))


if __name__ == "__main__":
    main(Path(sys.argv[1]), *map(int, sys.argv[2:]))
