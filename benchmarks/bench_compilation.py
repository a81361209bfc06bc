"""What each kernel of a first `debist run` costs before it runs: processor time of numba's work and of LLVM's.

    python benchmarks/bench_compilation.py

Two processes with empty caches: one takes the kernels that come with the package, the other compiles the sources. A
kernel's row has what itself and the parts that it is the first to need cost.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]
_INSIDE = """
import json, sys, time
from collections import defaultdict
from pathlib import Path
from pipeline.machine import settle_machine
settle_machine()
from pipeline import compiled, kernel_parts, prepared_kernels
from pipeline.first_run import compile_kernels

if sys.argv[1] == "compiled":
    prepared_kernels.PREPARED = Path()
spent, llvm, names = defaultdict(lambda: [0.0, 0.0]), [0.0], []

def timed(of, name):
    inner = getattr(of, name)
    def outer(*arguments, **named):
        began, before = time.process_time(), llvm[0]
        try:
            return inner(*arguments, **named)
        finally:
            llvm[0] = before + time.process_time() - began
    setattr(of, name, outer)

for name in ("_optimize_functions", "_optimize_final_module", "_finalize_final_module", "finish"):
    timed(kernel_parts.EntryLibrary, name)
timed(kernel_parts._PartLibrary, "_optimize_functions")
whole = compiled._Kernel.compile

def compile(kernel, signature):
    began, before = time.process_time(), llvm[0]
    try:
        return whole(kernel, signature)
    finally:
        row = spent[f"{kernel.py_func.__module__.removeprefix('pipeline.')}.{kernel.py_func.__qualname__}"]
        row[0] += time.process_time() - began
        row[1] += llvm[0] - before

compiled._Kernel.compile = compile
compile_kernels()
print(json.dumps(spent))
"""


def costs(way: str) -> dict[str, tuple[float, float]]:
    """All and LLVM's processor time [s] by kernel, `prepared` or `compiled`."""
    with tempfile.TemporaryDirectory() as cache:
        run = [sys.executable, "-c", _INSIDE, way]
        surroundings = os.environ | {"NUMBA_CACHE_DIR": cache, "PYTHONPATH": str(HOME)}
        done = subprocess.run(run, env=surroundings, stdout=subprocess.PIPE, check=True)
    return {name: (whole, llvm) for name, (whole, llvm) in json.loads(done.stdout).items()}


def main() -> None:
    prepared, compiled = costs("prepared"), costs("compiled")
    print(f"{'kernel':64} {'prepared [s]':>12} {'compiled [s]':>12} {'of it LLVM':>10}")
    for name in sorted(compiled, key=lambda name: -compiled[name][0]):
        print(f"{name:64} {prepared[name][0]:12.2f} {compiled[name][0]:12.2f} {compiled[name][1]:10.2f}")
    sums = [sum(column) for column in ((v[0] for v in prepared.values()), *zip(*compiled.values(), strict=True))]
    print(f"{'all':64} {sums[0]:12.2f} {sums[1]:12.2f} {sums[2]:10.2f}")


if __name__ == "__main__":
    main()
