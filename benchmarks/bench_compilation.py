"""What compilation of the kernels costs: processor time [s] of each kind, in processes that share an empty cache.

    python benchmarks/bench_compilation.py

Kinds come one after another as in `debist warmup --jobs 1`, so that a kind has what it is the first to need.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]
_INSIDE = """
import json, time
from pipeline.system.machine import settle_machine
settle_machine()
from pipeline.workflow.warmup import GROUPS
spent = {}
for kind in (kind for group in GROUPS for kind in group):
    began = time.process_time()
    kind()
    spent[kind.__name__.strip("_").replace("_", " ")] = time.process_time() - began
print(json.dumps(spent))
"""


def costs() -> dict[str, float]:
    """Processor time [s] by kind of kernels, imports included."""
    with tempfile.TemporaryDirectory() as cache:
        surroundings = os.environ | {"NUMBA_CACHE_DIR": cache, "PYTHONPATH": str(HOME)}
        done = subprocess.run([sys.executable, "-c", _INSIDE], env=surroundings, stdout=subprocess.PIPE, check=True)
    return dict(json.loads(done.stdout))


def main() -> None:
    spent = costs()
    for kind, seconds in [*spent.items(), ("all", sum(spent.values()))]:
        print(f"{kind:24} {seconds:6.1f}")


if __name__ == "__main__":
    main()
