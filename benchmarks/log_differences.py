"""What `debist check` says of a second log with a planted gain, offset, delay or zero, beside honest ones.

Run: python benchmarks/log_differences.py PROTOTYPE.toml… (15 s of processor time for each prototype with two logs)
"""

import re
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from pipeline.checks.check import check_logs
from pipeline.checks.declared import Declared
from pipeline.checks.weak_form import LogSignals
from pipeline.commands.console import Progress
from pipeline.runs.run_folder import RunFolder
from pipeline.runs.schedule import bring_up_to_date
from pipeline.settings import load_prototype
from pipeline.stages import ingest
from pipeline.stages.check import signals

Change = Callable[[LogSignals], LogSignals]
SHOWN = {"gain": ("gain", 1.0, ""), "answer of q": ("later_s", 1e3, "ms"), "zero of q": ("zero_m", 1e3, "mm")}


def pairs(paths: list[str]) -> Iterator[tuple[str, list[LogSignals], Declared]]:
    """Name, logs and declared device of every prototype."""
    with TemporaryDirectory() as folder:
        for path in map(Path, paths):
            prototype = load_prototype(path)
            run = RunFolder.create(Path(folder) / path.stem, prototype.model_dump(mode="json"), path)
            bring_up_to_date(run, ingest.tasks(prototype, path), Progress(quiet=True))
            yield path.stem, *signals(run, prototype)


def probe(gain: float = 1.0, offset: float = 0.0, late: int = 0, zero: float = 0.0) -> Change:
    """A gain, an offset [V], q that answers later by so many samples, and a zero of q [m]."""

    def change(log: LogSignals) -> LogSignals:
        q, v = log.q + zero, gain * log.v + offset
        rows, n = np.arange(abs(late), len(q)), len(q)
        early = rows - abs(late)
        of_q, of_v = (early, rows) if late > 0 else (rows, early)
        return replace(log, t=log.t[:n][rows], q=q[of_q], v=np.ascontiguousarray(v[of_v]))

    return change


PLANTED = {
    "nothing": probe(),
    **{f"gain {gain}": probe(gain=gain) for gain in (0.5, 0.9, 0.95, 1.05, 1.1)},
    **{f"offset {offset} V": probe(offset=offset) for offset in (10, 25, -60, 150, -150, 300)},
    **{f"late by {late} ms": probe(late=late) for late in (-30, -12, 6, 12, 20, 40)},
    **{f"zero {1e3 * zero:g} mm": probe(zero=zero) for zero in (1e-4, 3e-4, -1e-3)},
    "gain 0.95, late by 20 ms": probe(gain=0.95, late=20),
    "gain 1.05, offset 60 V": probe(gain=1.05, offset=60),
    "gain 0.9, offset 60 V, late by -20 ms": probe(gain=0.9, offset=60, late=-20),
}


def told(logs: list[LogSignals], declared: Declared) -> dict[str, float]:
    """What is said of the second log: number by its name."""
    numbers = {}
    for row in check_logs(logs, declared):
        if row.log == logs[0].name or row.state == "ok" or row.state == "not seen":
            continue
        if row.what.startswith("rest level"):
            numbers["rest level (V)"] = row.values["level_V"] - row.values.get("level_of_first_V", 0.0)
        for what, (key, factor, unit) in SHOWN.items():
            if row.what.startswith(what):
                numbers[f"{what} ({unit})" if unit else what] = factor * row.values[key]
        if row.what == "same device" and row.state == "wrong":
            numbers["another device"] = 1.0
    return numbers


def main() -> None:
    made = list(pairs(sys.argv[1:]))
    print("| in the second log | said of how many of the pairs, least and largest |\n|---|---|")
    for name, change in PLANTED.items():
        every: dict[str, list[float]] = defaultdict(list)
        count = 0
        for _, logs, declared in made:
            if not declared.joint and name != "nothing":
                continue
            count += 1
            for what, number in told([logs[0], *map(change, logs[1:])], declared).items():
                every[what].append(number)
        cells = [f"{what}: {len(n)}, {min(n):.4g} to {max(n):.4g}" for what, n in every.items()]
        print(f"| {name} ({count}) | {re.sub('-', '−', '; '.join(cells)) or 'nothing'} |", flush=True)


if __name__ == "__main__":
    main()
