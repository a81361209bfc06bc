"""Ingest of a long Parquet log: processor time, and the largest memory of the command and its reader together.

    python benchmarks/bench_long_log.py [--rows 100000000] [--rate 30000] [--row-group 1000000] [--folder FOLDER]

Needs 8 bytes a sample of disk for the log (less after compression) and as much again in the temporary folder. The
memory is the resident one (VmRSS of /proc), sampled every 50 ms and summed over the processes; Linux only.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

TOML = """name = "long"
[logs]
train = ["long.parquet"]
[channels]
time = { channel = "t", unit = "s" }
q = { channel = "q", unit = "m" }
v1 = { channel = "v1", unit = "V" }
v2 = { channel = "v2", unit = "V" }
"""


def write_log(path: Path, rows: int, rate: float, row_group: int) -> None:
    """A swing with 3 µm of noise under stepping voltages; written piece by piece."""
    rng = np.random.default_rng(0)
    schema = pa.schema([(name, pa.float64()) for name in ("t", "q", "v1", "v2")])
    with pq.ParquetWriter(path, schema, compression="zstd", write_page_checksum=True) as writer:
        for first in range(0, rows, row_group):
            t = np.arange(first, min(first + row_group, rows)) / rate
            q = 9e-3 * np.sin(7.0 * t) + rng.normal(0.0, 3e-6, t.size)
            v = 3000.0 * (t % 2.0 < 1.0)
            writer.write_table(pa.Table.from_arrays([t, q, v, 3000.0 - v], schema=schema), row_group_size=row_group)


def _resident(root: int) -> int:
    """Resident bytes of a process and its children."""
    total = 0
    for pid in (root, *_children(root)):
        try:
            fields = Path(f"/proc/{pid}/statm").read_text().split()
        except OSError:
            continue
        total += int(fields[1]) * os.sysconf("SC_PAGE_SIZE")
    return total


def _children(pid: int) -> list[int]:
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def ingest(folder: Path) -> tuple[float, float, int]:
    """Wall and processor time [s] and largest memory [bytes] of `debist ingest`."""
    began = time.perf_counter()
    command = [sys.executable, "-c", "from cli import app; app()", "ingest", "long.toml", "-o", "run", "--quiet"]
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    child = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL)
    largest = 0
    while True:
        largest = max(largest, _resident(child.pid))
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            break
        time.sleep(0.05)
    if status:
        raise SystemExit("debist ingest failed")
    return time.perf_counter() - began, usage.ru_utime + usage.ru_stime, largest


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rows", type=int, default=100_000_000)
    parser.add_argument("--rate", type=float, default=30_000.0, help="samples per second")
    parser.add_argument("--row-group", type=int, default=1_000_000)
    parser.add_argument("--folder", type=Path, help="where log and run go for the time of the benchmark")
    options = parser.parse_args()
    folder = Path(tempfile.mkdtemp(dir=options.folder))
    try:
        (folder / "long.toml").write_text(TOML)
        write_log(folder / "long.parquet", options.rows, options.rate, options.row_group)
        size = (folder / "long.parquet").stat().st_size
        wall, processor, memory = ingest(folder)
        made = sum(path.stat().st_size for path in (folder / "run").rglob("*.parquet"))
        print(
            f"{options.rows} rows ({size / 1e6:.0f} MB in row groups of {options.row_group}) at {options.rate:g} Hz: "
            f"{wall:.1f} s, {processor:.1f} s of processor time, at most {memory / 2**20:.0f} MB of memory; "
            f"{made / 1e6:.0f} MB written"
        )
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
