"""From `rbf-paper` to `rbf`, one change after the other.

`python benchmarks/paper_to_rbf.py RUNS PROTOTYPE.toml… FLEET` writes docs/measured/paper-to-rbf.md: the NRMSE of q on
validation logs for each prototype, and its quantiles over the joints of FLEET, a folder of `debist rig fleet`. RUNS
keeps the records, and the errors of each joint in errors.json, so that a second call goes on. 40 s of processor time a
joint.
"""

import argparse
import json
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

import numpy as np
from scipy.optimize import lsq_linear

from pipeline.models.base import DynamicModel
from pipeline.models.free_runs import free_run
from pipeline.models.model_type import Training
from pipeline.models.paper.model import RBF_PAPER, RbfPaperModel
from pipeline.models.rbf import identify as rbf
from pipeline.models.rbf.candidates import FRICTION, Candidate, candidate
from pipeline.models.rbf.start import RIDGE
from pipeline.models.rbf.structure import JointStructure
from pipeline.numerics.arrays import FloatArray
from pipeline.numerics.metrics import nrmse
from pipeline.numerics.tvregdiff import tvregdiff
from pipeline.settings.prototype import Prototype, load_prototype
from pipeline.signals.log import Log
from pipeline.store.run_folder import RunFolder
from pipeline.system.machine import one_thread
from pipeline.units.units import ALPHA_UNIT
from pipeline.workflow.engine import Unheard
from pipeline.workflow.logs import load_logs, training
from pipeline.workflow.schedule import bring_up_to_date
from pipeline.workflow.stages import Planned, of_stages, plan
from pipeline.workflow.studies.paper import RECIPE, paper_settings

PAGE = Path(__file__).resolve().parents[1] / "docs" / "measured" / "paper-to-rbf.md"
FUNCTIONS, SMOOTHING = JointStructure().basis_functions, JointStructure().smoothing
NO_MEMORY = JointStructure(**FRICTION["viscous"], arc=False, hold="record")
ONE_SHAPE = replace(NO_MEMORY, rates=(0.15,), shape_elements=1)
WHOLE = JointStructure(**FRICTION["lags+slip"], hold="record")


@dataclass(frozen=True)
class Logs:
    """Training data and validation tables of a joint by the recipe of `debist paper`, and by that of `debist run`."""

    printed: Training
    printed_validation: list[Log]
    usual: Training
    usual_validation: list[Log]


def shifted(data: Training) -> Training:
    """The training data with derivatives as published codes return them, shifted to the samples behind."""
    return replace(data, segments=tuple(_shifted(x) for x in data.segments))


def _shifted(x: Log) -> Log:
    unit = ALPHA_UNIT["m"][1]
    alpha, epsilon = float(RECIPE.alpha) * unit, float(RECIPE.epsilon or 0.0) * unit**2

    def slope(samples: FloatArray) -> FloatArray:
        # their antiderivative begins one step before the first sample, as if that were there twice
        fit = tvregdiff(np.concatenate((samples[:1], samples)), x.interval, alpha=alpha, epsilon=epsilon)
        return np.diff(fit.integral) / x.interval

    qdot = slope(x.q)
    return replace(x, qdot=qdot, qddot=slope(qdot))


def linear(data: Training, *, functions: int, smoothing: float, bounded: bool = False) -> RbfPaperModel:
    """`rbf-paper` whose weights have a ridge, and with `bounded` a damping ≥ 0 and gains of one sign each."""
    identify = data.identify.model_copy(update={"basis_functions": functions, "smoothing": smoothing})
    model = RBF_PAPER.fit(replace(data, identify=identify))
    assert isinstance(model, RbfPaperModel)
    matrix = np.concatenate([model.regressors(x) for x in data.segments])
    target = data.mass * np.concatenate([x.qddot for x in data.segments])
    norms, size = np.linalg.norm(matrix, axis=0), float(np.linalg.norm(target))
    norms[norms == 0.0] = 1.0
    q, r = np.linalg.qr(np.vstack((matrix / norms, RIDGE * np.eye(len(norms)))))
    right = q[: len(target)].T @ (target / size)

    def solved(low: FloatArray, high: FloatArray) -> FloatArray:
        weights = lsq_linear(r, right, (low.ravel(), high.ravel())).x / norms * size
        return np.asarray(weights.reshape(model.weights.shape))

    free = np.full(model.weights.shape, np.inf)
    weights = solved(-free, free)
    if bounded:
        positive = np.array([False, True, *(weights[2:].mean(axis=1) >= 0.0)])
        negative = np.array([False, False, *~positive[2:]])
        weights = solved(np.where(positive[:, None], 0.0, -free), np.where(negative[:, None], 0.0, free))
    return model.model_copy(update={"weights": weights})


def simulated(data: Training, option: Candidate) -> DynamicModel:
    """A structure of `rbf` fitted through the observer."""
    return rbf.identify_rbf(data.records, mass=data.mass, candidates=[option])


STEPS: dict[str, Callable[[Logs], DynamicModel]] = {
    "§ 4.2 with derivatives as published codes shift them": lambda x: RBF_PAPER.fit(shifted(x.printed)),
    "derivatives at the samples (`rbf-paper` of `debist paper`)": lambda x: RBF_PAPER.fit(x.printed),
    "derivatives of order 3, α from the record (`rbf-paper` of `debist run`)": lambda x: RBF_PAPER.fit(x.usual),
    "12 wider basis functions, σ_n = 1, a ridge": lambda x: linear(x.usual, functions=FUNCTIONS, smoothing=SMOOTHING),
    "damping ≥ 0, gains of one sign": lambda x: linear(x.usual, functions=FUNCTIONS, smoothing=SMOOTHING, bounded=True),
    "the equation of `rbf` without hidden states, simulated with an observer": lambda x: simulated(
        x.usual, candidate(NO_MEMORY)
    ),
    "one hidden shape, the slope of the tip": lambda x: simulated(x.usual, candidate(ONE_SHAPE)),
    "a second shape, slow relaxation, dry friction, inertia on an arc": lambda x: simulated(x.usual, candidate(WHOLE)),
    "the prior of simulated joints: `rbf`": lambda x: rbf.RBF.fit(x.usual),
}
PRINTED = tuple(STEPS)[:2]
"""The steps whose derivatives are those of the paper's recipe."""


def logs_of(file: Path, runs: Path) -> Logs:
    """Records of a prototype, differentiated both ways."""
    given = load_prototype(file)
    usual = given.model_copy(update={"plant": given.plant.model_copy(update={"parameters": None})})
    return Logs(*_tables(file, paper_settings(given), runs / "paper"), *_tables(file, usual, runs / "usual"))


def _tables(file: Path, prototype: Prototype, root: Path) -> tuple[Training, list[Log]]:
    run = RunFolder.create(root / prototype.name, prototype.model_dump(mode="json"), file)
    bring_up_to_date(
        run, of_stages(plan(Planned(run, prototype, file)), ("ingest", "check", "differentiate")), Unheard()
    )
    return training(load_logs(run, prototype, "train"), prototype, None), load_logs(run, prototype, "validation")


def error(model: DynamicModel, tables: Sequence[Log]) -> float:
    """NRMSE of q in % over the worst log; infinite where a run diverges."""
    runs = [(log.q, free_run(log, model)) for log in tables]
    return max(100.0 * float(nrmse(q, made.q) or np.nan) if made.status == "ok" else np.inf for q, made in runs)


@one_thread
def errors(file: Path, runs: Path) -> dict[str, float]:
    """The error of each step."""
    logs = logs_of(file, runs)
    return {
        step: error(fit(logs), logs.printed_validation if step in PRINTED else logs.usual_validation)
        for step, fit in STEPS.items()
    }


def page(examples: dict[str, dict[str, float]], fleet: dict[str, dict[str, float]], drawn: int, seed: str) -> str:
    """The page: a row for each step, each with all changes of the rows above it."""
    commit = subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, check=True)
    kinds = {kind: [e for name, e in fleet.items() if name.startswith(kind)] for kind in ("foreign",)}
    heading = ["", *examples, *(f"{kind}, {len(joints)} joints" for kind, joints in kinds.items())]
    lines = [heading, ["---", *["---:"] * (len(heading) - 1)]]
    for step in STEPS:
        cells = [_cell(example[step]) for example in examples.values()]
        lines.append([step, *cells, *(_quantiles([joint[step] for joint in joints]) for joints in kinds.values())])
    table = "\n".join(f"| {' | '.join(line)} |" for line in lines)
    return f"""# Measured: from `rbf-paper` to `rbf`

Written by `python benchmarks/paper_to_rbf.py RUNS P1.toml P2.toml P3.toml FLEET` ({date.today():%-d %B %Y}, commit
{commit.stdout.strip()}).

<!-- not run: an hour -->
```sh
debist rig fleet {drawn} -o FLEET --rate 10000 --seed {seed}
```

NRMSE of q in free run on validation logs, in % of the range; of the fleet median, 90th percentile, and how many
diverged. Each row has the changes of the rows above it.

{table}
"""


def _quantiles(values: list[float]) -> str:
    ninety = float(np.percentile(values, 90, method="linear" if np.isfinite(values).all() else "inverted_cdf"))
    return f"{_cell(float(np.median(values)))}, {_cell(ninety)}, {np.count_nonzero(np.isinf(values))}"


def _cell(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else "diverged"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=Path)
    parser.add_argument("prototypes", nargs="+", type=Path)
    parser.add_argument("fleet", type=Path)
    parser.add_argument("--seed", default="26112700", help="of the fleet, for the page")
    parser.add_argument("--no-run", action="store_true", help="write the page from the errors that RUNS holds")
    given = parser.parse_args()
    store, drawn = given.runs / "errors.json", sorted(given.fleet.glob("*/*-*.toml"))
    results = json.loads(store.read_text(encoding="utf-8")) if store.exists() else {}
    for file in () if given.no_run else (*given.prototypes, *drawn):
        if file.stem not in results:
            results[file.stem] = errors(file, given.runs)
            store.write_text(json.dumps(results, indent=1), encoding="utf-8")
            print(file.stem, " ".join(f"{value:.2f}" for value in results[file.stem].values()), flush=True)
    examples = {file.stem: results[file.stem] for file in given.prototypes}
    fleet = {file.stem: results[file.stem] for file in drawn if file.stem in results}
    PAGE.write_text(page(examples, fleet, len(drawn), given.seed), encoding="utf-8")


if __name__ == "__main__":
    main()
