"""`debist check` on 40 honest pairs of logs: what it refuses and notes of them, and whether its ± hold.

Rig joints of the analytical model's physics and of others, under every kind of excitation. A minute and a half of
processor time. Run: python benchmarks/honest_logs.py
"""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from pipeline.commands.console import Progress
from pipeline.diagnostics.check import check_logs
from pipeline.diagnostics.declared import Declared
from pipeline.diagnostics.rows import CheckRow, findings
from pipeline.diagnostics.weak_form import LogSignals
from pipeline.rig.fleet import Experiment, write_prototype
from pipeline.settings.prototype import load_prototype
from pipeline.store.run_folder import RunFolder
from pipeline.workflow import stage_ingest as ingest
from pipeline.workflow.schedule import bring_up_to_date
from pipeline.workflow.stage_check import signals

PAIRS = 40
EXCITATIONS = ("pulses", "both", "steps", "multisine", "mixed", "chirps", "training", "validation")


def pairs(folder: Path) -> Iterator[tuple[str, list[LogSignals], Declared]]:
    """Name, logs and declared device of every pair."""
    for number in range(PAIRS):
        kind = "same" if number % 2 else "foreign"
        excitation = EXCITATIONS[number // 2 % len(EXCITATIONS)]
        name = f"{kind}-{excitation}-{number}"
        experiment = Experiment(kind=kind, format="parquet", rate=2000.0, duration=20.0, excitation=excitation)
        path = write_prototype(folder / name, name, experiment, seed=500 + number)
        prototype = load_prototype(path)
        run = RunFolder.create(folder / "runs" / name, prototype.model_dump(mode="json"), path)
        bring_up_to_date(run, ingest.tasks(prototype, path), Progress(quiet=True))
        yield name, *signals(run, prototype)


def inside(rows: list[CheckRow]) -> Iterator[tuple[str, bool]]:
    """Of every number with a standard error in both logs: whether they agree within two standard errors of both."""
    for what in {row.what for row in rows}:
        both = [row.values for row in rows if row.what == what]
        for key in both[0] if len(both) == 2 else ():
            stem, _, unit = key.partition("_")
            errors = [values[name] for values in both if (name := f"{stem}_error_{unit}") in values]
            if len(errors) == 2:
                yield what, abs(both[0][key] - both[1][key]) <= 2.0 * float(np.hypot(errors[0], errors[1]))


def main() -> None:
    notes: Counter[str] = Counter()
    shares: dict[str, list[bool]] = {}
    refused = 0
    with TemporaryDirectory() as folder:
        for name, logs, declared in pairs(Path(folder)):
            rows = check_logs(logs, declared)
            wrong = [f"{name}: refused: {found.text}" for found in findings(rows)]
            noted = [row for row in rows if row.state == "note"]
            print(
                "\n".join([*wrong, *(f"{name}: noted: {row.sentence}" for row in noted)]),
                end="\n" * bool(wrong or noted),
            )
            notes.update(row.what for row in noted)
            refused += bool(wrong)
            for what, agrees in inside(rows):
                shares.setdefault(what, []).append(agrees)
    print(f"{refused} of {PAIRS} honest pairs refused; logs with a note: {dict(notes) or 'none'}")
    for what, agreeing in shares.items():
        print(f"± of {what}: {sum(agreeing)} of {len(agreeing)} pairs agree within two standard errors")
    if not shares:
        print("no number is printed with a ±")


if __name__ == "__main__":
    main()
