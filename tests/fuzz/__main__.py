"""The long fuzz run: ``python -m tests.fuzz [--count 10000] [--kinds mat5 csv …] [--logs FOLDER]``."""

import argparse
import tempfile
import time
from pathlib import Path

from hypothesis import HealthCheck, Phase, given, seed as hypothesis_seed, settings

from pipeline.rig_logs.child import FORMATS
from pipeline.system.isolation import preload
from tests.fuzz.edits import damage, noticeable
from tests.fuzz.property import Tally, Target
from tests.fuzz.seeds import KINDS, Seed, seeds

_SUFFIXES = {"mdf4": ".mf4", "csv": ".csv", "parquet": ".parquet", "hdf5": ".h5"}
_SUFFIXES |= {"mat5": ".mat", "mat73": ".mat73"}
_LARGEST = 16 << 20


def fuzz(kind: str, count: int, number: int, logs: Path | None = None) -> Tally:
    """Damage the seeds of a format `count` times; a third of the time under their checksums."""
    tally = Tally()
    preload([f"pipeline.rig_logs.{module}" for module in ("csv", *(each.module for each in FORMATS))])
    with tempfile.TemporaryDirectory(prefix="debist-fuzz-") as name:
        folder = Path(name)
        real = [p for p in sorted(logs.rglob(f"*{_SUFFIXES[kind]}")) if p.stat().st_size < _LARGEST] if logs else []
        intact = seeds(kind, folder)
        small = [Target(seed, folder, tally) for seed in intact]
        large = [Target(Seed(path.name, path.read_bytes()), folder, tally) for path in real]
        for_large = count // 10 if large else 0  # they are slower, and most of their bytes are samples
        for targets, share in ((small, count - for_large), (large, for_large)):
            for i, target in enumerate(targets):
                _run(target, share // len(targets) + (i < share % len(targets)), number)
    return tally


def _run(target: Target, count: int, number: int) -> None:
    """A violation is shrunk to the smallest damage that shows it, and raised."""
    seed = target.seed
    strategy = damage(len(seed.data))
    if seed.protected:
        strategy |= noticeable(seed.protected, seed.values)

    @hypothesis_seed(number)
    @settings(
        max_examples=count,
        deadline=None,
        database=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @given(edits=strategy)
    def hold(edits):
        target.check(edits)

    hold()


def main() -> None:
    """Print one line per format."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--count", type=int, default=10_000, help="damaged files of each format")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--logs", type=Path, help="folder with logs to damage as well")
    options = parser.parse_args()
    for kind in options.kinds:
        began = time.monotonic()
        tally = fuzz(kind, options.count, options.seed, options.logs)
        print(
            f"{kind:8} {sum(tally.outcomes.values()):6} damaged: "
            + ", ".join(f"{n} {what}" for what, n in sorted(tally.outcomes.items()))
            + f"; slowest {tally.slowest:.2f} s; {time.monotonic() - began:.0f} s in all",
            flush=True,
        )


if __name__ == "__main__":
    main()
