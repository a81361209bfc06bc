"""Free-run error of `hybrid` against the length of the training log.

`python benchmarks/log_length.py RUN...`: runs of joints without ``[plant]`` that have a training log of 37.5 s or more,
such as `tube_coverage.py` leaves. Each joint is fitted to the first seconds of its training log and simulated over its
validation log. About 20 s of processor time a joint.
"""

import sys
from pathlib import Path

import numpy as np

import debist
from pipeline.errors import DataRefusedError
from pipeline.models.free_runs import free_run
from pipeline.models.model_type import model_type
from pipeline.signals.log import Log
from pipeline.workflow.run_contents import load_logs
from pipeline.workflow.steps.identify import training

LENGTHS = (5.0, 10.0, 20.0, 37.5)
"""Of the training log [s]."""


def errors(folder: Path) -> list[float]:
    """NRMSE of q [%] on the validation log, for each of `LENGTHS`; infinite where no joint can be fitted."""
    opened = debist.open_run(folder)
    prototype, run = opened._prototype, opened._folder
    trained = load_logs(run, prototype, "train")
    validation = load_logs(run, prototype, "validation")[0]
    span = np.nanmax(validation.q) - np.nanmin(validation.q)
    measured = []
    for length in LENGTHS:
        try:
            model = model_type("hybrid").fit(training([_first(log, length) for log in trained], prototype, None))
        except DataRefusedError:
            measured.append(np.inf)
            continue
        error = free_run(validation, model).q - validation.q
        measured.append(float(100.0 * np.sqrt(np.nanmean(error**2)) / span))
    return measured


def _first(log: Log, length: float) -> Log:
    return log.part(0, int(np.searchsorted(log.t, log.t[0] + length)))


def main(folders: list[Path]) -> None:
    print("| joint |" + "".join(f" {length:g} s |" for length in LENGTHS))
    print("|---|" + "---|" * len(LENGTHS))
    rows = []
    for folder in folders:
        rows.append(errors(folder))
        print(f"| `{folder.parent.name}` |" + "".join(f" {error:.2f} |" for error in rows[-1]), flush=True)
    print("| median |" + "".join(f" {error:.2f} |" for error in np.median(rows, axis=0)))


if __name__ == "__main__":
    main([Path(argument) for argument in sys.argv[1:]])
