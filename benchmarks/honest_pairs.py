"""`debist check` on honest pairs of logs: how far what it measures varies, and that nothing is refused.

P1 to P3, the demo, rig joints of the analytical model's physics and of others under every kind of excitation, and
dynamically similar joints of other sizes. 35 s of processor time. Run: python benchmarks/honest_pairs.py
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from measure import has_logs

from pipeline.checks.check import check_logs
from pipeline.checks.declared import Declared
from pipeline.checks.rows import findings
from pipeline.checks.weak_form import LogSignals
from pipeline.commands.console import Progress
from pipeline.rig.demo import write_demo
from pipeline.rig.fleet import Experiment, write_prototype
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schedule import bring_up_to_date
from pipeline.settings import load_prototype
from pipeline.stages import ingest
from pipeline.stages.check import signals

PROTOTYPES = Path(__file__).resolve().parent / "prototypes"
DRAWS = (
    ("same", "pulses"), ("same", "both"), ("same", "steps"), ("same", "multisine"), ("same", "mixed"),
    ("foreign", "pulses"), ("foreign", "chirps"), ("foreign", "steps"), ("foreign", "multisine"), ("foreign", "mixed"),
)  # fmt: skip
SIZES = (0.5, 2.0)
SHOWN = ("push of v1", "push of v2", "delay of q after v", "natural frequency", "coupling", "same device")


def pairs(folder: Path) -> Iterator[tuple[str, list[LogSignals], Declared]]:
    """Name, logs and declared device of every pair."""
    made = [path for name in ("P1", "P2", "P3") if (path := PROTOTYPES / f"{name}.toml").exists() and has_logs(path)]
    for number, (kind, excitation) in enumerate(DRAWS):
        experiment = Experiment(kind, "parquet", rate=2000.0, excitation=excitation)
        made.append(
            write_prototype(folder / f"{kind}-{excitation}", f"{kind}-{excitation}", experiment, seed=500 + number)
        )
    made.append(write_demo(folder / "demo"))
    for path in made:
        prototype = load_prototype(path)
        run = RunFolder.create(folder / "runs" / path.stem, prototype.model_dump(mode="json"), path)
        bring_up_to_date(run, ingest.tasks(prototype, path), Progress(quiet=True))
        logs, declared = signals(run, prototype)
        yield path.stem, logs, declared
        if path.stem in ("P1", "P2", "P3"):
            for n in SIZES:
                yield f"{path.stem}, {n:g} times as large", [_built(log, n) for log in logs], _declared(declared, n)


def _built(log: LogSignals, n: float) -> LogSignals:
    """The joint built n times as large: n times as slow, n³ times as heavy, the same slope of the capacitance."""
    return replace(log, t=n * log.t, q=n * log.q, v=n * log.v, raw_step=n * log.raw_step)


def _declared(declared: Declared, n: float) -> Declared:
    mass = None if declared.mass is None else n**3 * declared.mass
    return replace(declared, mass=mass)


def main() -> None:
    count = refused = 0
    with TemporaryDirectory() as folder:
        for name, logs, declared in pairs(Path(folder)):
            rows = check_logs(logs, declared)
            wrong = [f"refused: {found.text}" for found in findings(rows)]
            notes = [f"noted: {row.sentence}" for row in rows if row.state == "note"]
            shown = [f"{what} {' | '.join(row.found for row in rows if row.what.startswith(what))}" for what in SHOWN]
            print("\n  ".join([name, *wrong, *notes, *shown]))
            count, refused = count + 1, refused + bool(wrong)
    print(f"{refused} of {count} honest pairs refused")


if __name__ == "__main__":
    main()
