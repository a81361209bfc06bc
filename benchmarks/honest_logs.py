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
from pipeline.device.device import device
from pipeline.diagnostics.check import check_logs, refusing
from pipeline.diagnostics.log_facts import LogSignals
from pipeline.diagnostics.sentences import sentences
from pipeline.rig.fleet import Experiment, simulate_prototype
from pipeline.settings.prototype import Prototype, load_prototype
from pipeline.signals.findings import Finding
from pipeline.store.run_folder import RunFolder
from pipeline.workflow import stage_ingest as ingest
from pipeline.workflow.engine import bring_up_to_date
from pipeline.workflow.stage_check import signals

PAIRS = 40
EXCITATIONS = ("pulses", "both", "steps", "multisine", "mixed", "chirps", "training", "validation")


def pairs(folder: Path) -> Iterator[tuple[str, list[LogSignals], Prototype]]:
    """Name, logs and settings of every pair."""
    for number in range(PAIRS):
        kind = "same" if number % 2 else "foreign"
        excitation = EXCITATIONS[number // 2 % len(EXCITATIONS)]
        name = f"{kind}-{excitation}-{number}"
        experiment = Experiment(kind=kind, format="parquet", rate=2000.0, duration=20.0, excitation=excitation)
        path = simulate_prototype(folder / name, name, experiment, seed=500 + number)
        prototype = load_prototype(path)
        run = RunFolder.create(folder / "runs" / name, prototype.model_dump(mode="json"), path)
        bring_up_to_date(run, ingest.tasks(prototype, path), Progress(quiet=True))
        yield name, signals(run, prototype), prototype


def inside(findings: list[Finding]) -> Iterator[tuple[str, bool]]:
    """Of every number with a standard error in both logs: whether they agree within two standard errors of both."""
    for of in {(finding.code, finding.subject) for finding in findings}:
        both = [finding.numbers for finding in findings if (finding.code, finding.subject) == of]
        for name in both[0] if len(both) == 2 else ():
            first, second = (numbers[name] for numbers in both)
            if first.error is not None and second.error is not None:
                yield (
                    f"{of[0]} {name}",
                    abs(first.value - second.value) <= 2.0 * float(np.hypot(first.error, second.error)),
                )


def main() -> None:
    notes: Counter[str] = Counter()
    shares: dict[str, list[bool]] = {}
    refused = 0
    with TemporaryDirectory() as folder:
        for name, logs, prototype in pairs(Path(folder)):
            findings = check_logs(logs, device(prototype), prototype.ingest.sample_interval)
            wrong = refusing(findings)
            noted = [finding for finding in findings if finding.severity == "fair"]
            for kind, some in (("refused", wrong), ("noted", noted)):
                for finding in some:
                    print(f"{name}: {kind}: {sentences(finding)[0]}")
            notes.update(finding.code for finding in noted)
            refused += bool(wrong)
            for what, agrees in inside(findings):
                shares.setdefault(what, []).append(agrees)
    print(f"{refused} of {PAIRS} honest pairs refused; logs with a note: {dict(notes) or 'none'}")
    for what, agreeing in shares.items():
        print(f"± of {what}: {sum(agreeing)} of {len(agreeing)} pairs agree within two standard errors")
    if not shares:
        print("no number is printed with a ±")


if __name__ == "__main__":
    main()
