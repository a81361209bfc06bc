"""What the RBF corrections of `hybrid` bring: equations alone, equations with RBF, RBF alone, on logs no fit has seen.

`python benchmarks/ablation.py RUN…` takes run folders (`debist run`, `debist batch`), fits each of the three to the
training logs anew, and prints the NRMSE of q in % of free runs over the validation logs, the worst log of each run; and
how many basis functions the run's own `hybrid` has, which held-out training data chose. 15 s a run.
"""

import argparse
from pathlib import Path

import numpy as np

from pipeline.device.parameters import parameter_set
from pipeline.models.free_runs import free_run
from pipeline.models.model_type import model_type
from pipeline.numerics.metrics import nrmse
from pipeline.store import layout
from pipeline.store.run_folder import RunFolder
from pipeline.system.machine import one_thread
from pipeline.workflow.run_contents import load_logs
from pipeline.workflow.steps.identify import training

VARIANTS = (("hybrid", "none"), ("hybrid", "always"), ("rbf", "auto"))
"""Model, and what the settings say of its corrections."""


@one_thread
def errors(root: Path) -> list[float]:
    """NRMSE of q of each variant over the worst validation log of a run; infinite where it diverges."""
    run = RunFolder.open(root)
    prototype = run.prototype
    parameters = parameter_set(prototype, Path(run.manifest.prototype_file))
    trained = load_logs(run, prototype, "train")
    logs = load_logs(run, prototype, "validation")
    found = []
    for name, corrections in VARIANTS:
        identify = prototype.identify.model_copy(update={"corrections": corrections})
        model = model_type(name).fit(training(trained, prototype.model_copy(update={"identify": identify}), parameters))
        runs = [(log.q, free_run(log, model)) for log in logs]
        found.append(max(_error(q, made.q) if made.status == "ok" else np.inf for q, made in runs))
    return found


def _error(measured: np.ndarray, calculated: np.ndarray) -> float:
    return float(nrmse(measured, calculated) or np.nan)


def main() -> None:
    """Print a row for each run, and the medians of those whose `hybrid` has corrections."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", nargs="+", type=Path)
    print(f"{'run':16s}{'equations':>12s}{'with RBF':>12s}{'RBF alone':>12s}{'basis functions':>18s}")
    acting = []
    for root in parser.parse_args().runs:
        found = errors(root)
        count = RunFolder.open(root).record(layout.MODELS).notes["hybrid"]["basis_functions"]
        print(f"{root.name:16s}" + "".join(f"{100.0 * error:12.3f}" for error in found) + f"{count:18d}", flush=True)
        acting += [found] if count else []
    if acting:
        print(f"{'median, acting':16s}" + "".join(f"{100.0 * error:12.3f}" for error in np.median(acting, axis=0)))


if __name__ == "__main__":
    main()
